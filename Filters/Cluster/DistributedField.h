// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DistributedField_h
#define DistributedField_h

#include "ExchangedValues.h"
#include "Processes.h"
#include "SurfacePiece.h"

#include <DirectionFields/Computation/SurfaceFigures.h>
#include <DirectionFields/Options.h>
#include <DirectionFields/Result.h>
#include <DirectionFields/Types.h>

#include "vtkType.h"

#include <functional>
#include <string>
#include <vector>

namespace DirectionFields::Parallel
{
/// The field of a piece; no process ever had the whole surface.
struct DistributedField
{
  /// Empty, or why the field can only be computed of the gathered surface, as a part of a sentence:
  /// then there is nothing else. The same on all processes.
  std::string Reason;
  /// Over the points and triangles of the piece; components and repairs are of the whole surface.
  Result Field;
  SurfaceFigures Figures;
  vtkIdType SharedPoints = 0;
  PointExchange Exchange;
};

/// Whether this build has PETSc, which the computation needs.
bool CanDistribute();

/// Computes the field. All processes call it; throws ProcessesError.
/// @param surface the triangles of the piece, over all points of its polydata
/// @param guidance of the surface's points
/// @param previous the first directions of the time step before, of the surface's points, where
///                 this one is to follow it
/// @param goOn    is called now and then with the part that is done; false on any process stops all
DistributedField ComputeDistributed(Processes& processes, const Surface& surface,
  const SurfacePiece& piece, const Options& options, const Guidance& guidance,
  const std::vector<Vector3>& previous, const std::function<bool(double)>& goOn);
}

#endif
