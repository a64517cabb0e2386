// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_DirectionField_h
#define DirectionFields_DirectionField_h

#include "MeshError.h"
#include "Options.h"
#include "Result.h"
#include "Surface.h"

#include <functional>
#include <memory>

namespace DirectionFields
{
class Stages;

/// Called with the fraction done, 0 to 1; false stops the computation.
using ProgressFunction = std::function<bool(double)>;

/// The globally optimal direction field of a triangle mesh: for every connected component the
/// eigenvector to the smallest eigenvalue of the smoothness energy of
///
/// F. Knöppel, K. Crane, U. Pinkall, P. Schröder: Globally Optimal Direction Fields.
/// ACM Transactions on Graphics 32(4), 2013 (KCPS13),
///
/// or the field of least energy that is drawn to a guidance, or that satisfies constraints after
///
/// B. Pellenard, G. Orbay, J. Chen, S. Sohan, W. Kwok, J. R. Tristano: QMCF: QMorph Cross
/// Field-driven Quad-dominant Meshing Algorithm. Procedia Engineering 82, 2014 (POC14).
///
/// Whatever depends on the surface only is computed once, when the object is made; the matrices,
/// the smallest eigenpairs and the curvature are kept for the next call of Compute and redone only
/// when the options that they depend on change. Not to be used by two threads at once.
class DirectionField
{
public:
  /// Throws MeshError for a surface that cannot be processed.
  /// @param numberOfThreads as in Options
  explicit DirectionField(const Surface& surface, int numberOfThreads = 0);
  ~DirectionField();
  DirectionField(DirectionField&&) noexcept;
  DirectionField& operator=(DirectionField&&) noexcept;

  /// Throws std::invalid_argument for options out of range, for curvature alignment or constraints
  /// with a degree other than 2 and 4, and for guidance of the wrong size.
  Result Compute(
    const Options& options, const Guidance& guidance = {}, const ProgressFunction& progress = {});

private:
  Surface Input;
  std::unique_ptr<Stages> Kept;
};
}

#endif
