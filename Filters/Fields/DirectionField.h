// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_DirectionField_h
#define DirectionFields_DirectionField_h

#include "MeshError.h"
#include "Options.h"
#include "Progress.h"
#include "Result.h"
#include "Surface.h"

#include <memory>

namespace DirectionFields
{
struct SurfaceTensors;
struct TensorGuidance;
struct TensorGuidanceOptions;

namespace Internal
{
class Stages;
struct FollowedTensors;
}

/// The globally optimal direction field of a triangle mesh: for every connected component the
/// eigenvector to the smallest eigenvalue of the smoothness energy of
///
/// F. Knöppel, K. Crane, U. Pinkall, P. Schröder: Globally Optimal Direction Fields. ACM
/// Transactions on Graphics 32(4), 2013 (KCPS13),
///
/// or the field of least energy that is drawn to a guidance, or that satisfies constraints after
///
/// B. Pellenard, G. Orbay, J. Chen, S. Sohan, W. Kwok, J. R. Tristano: QMCF: QMorph Cross
/// Field-driven Quad-dominant Meshing Algorithm. Procedia Engineering 82, 2014 (POC14).
///
/// Mesh, matrices, smallest eigenpairs and curvature are kept for the next call of Compute; each is
/// made anew only when the options change that it depends on. Two threads may not use one object at
/// once.
class DirectionField
{
public:
  explicit DirectionField(const Surface& surface);
  /// Shares the surface, which must not change any more, in place of keeping a copy.
  explicit DirectionField(std::shared_ptr<const Surface> surface);
  ~DirectionField();
  DirectionField(DirectionField&&) noexcept;
  DirectionField& operator=(DirectionField&&) noexcept;

  /// Throws MeshError for a surface that cannot be processed, and std::invalid_argument for options
  /// out of range, for curvature alignment or constraints with a degree other than 2 and 4, and for
  /// guidance of the wrong size.
  Result Compute(
    const Options& options, const Guidance& guidance = {}, const ProgressFunction& progress = {}) &;
  /// The same field, from an object that is not to compute another one: it prepares nothing for
  /// other strengths of the alignment.
  Result Compute(const Options& options, const Guidance& guidance = {},
    const ProgressFunction& progress = {}) &&;

  /// From the next call of Compute on, the one rotation of each component that the smoothest field
  /// leaves open is such that it is closest to these directions on average, as those of the surface
  /// a moment ago; without any, closest to the x axis.
  /// @param directions one a point of the surface, its length the weight: any of the directions of
  ///                   a field, in space. Ignored where they are not one a point.
  /// @param degree     of that field; fields of other degrees ignore it
  void SetPhaseReference(std::vector<Vector3> directions, int degree);
  /// These directions, where they are those of a field of that degree; else none.
  std::vector<Vector3> GetPhaseReference(int degree) const;

  /// From the next call of Compute on, fields follow the principal directions of these tensors, for
  /// degrees 2 and 4, and Options::Alignment counts no more. Where AlignmentStrength is 1, and
  /// UseShift off, they have these directions themselves, but for constrained vertices and their
  /// neighbours, and where the tensors are isotropic within noise: there is the smoothest field,
  /// always of least energy, in between. Below that they are drawn to the directions. Weights are
  /// those of GuideByTensors, with points merged as Options::MergePoints has it.
  ///
  /// Throws std::invalid_argument as GuideByTensors; Compute does for values that are not finite,
  /// and for other degrees.
  void FollowTensors(SurfaceTensors tensors, const TensorGuidanceOptions& options);
  /// From the next call of Compute on, fields follow no tensors.
  void FollowNoTensors();
  /// The guidance by the tensors of the last field that was computed, at its output points
  /// (Result::OriginalPoint); null where it followed none.
  std::shared_ptr<const TensorGuidance> GetTensorGuidance() const;

private:
  Result ComputeField(const Options& options, const Guidance& guidance,
    const ProgressFunction& progress, bool othersFollow);
  /// The options as they count where tensors are followed.
  Options WithTensors(const Options& options) const;
  /// The stages of the surface with points merged or not, made anew where that has changed.
  Internal::Stages& StagesFor(const Options& options);
  /// The phase reference as a section over the vertices; empty where there is none of that degree.
  std::vector<Complex> PhaseReferenceSection(int degree) const;

  std::shared_ptr<const Surface> Input;
  std::unique_ptr<Internal::Stages> Cache;
  Guidance PhaseReference;
  int PhaseReferenceDegree = 0;
  std::unique_ptr<Internal::FollowedTensors> Followed;
  std::shared_ptr<const TensorGuidance> AtTensors;
};
}

#endif
