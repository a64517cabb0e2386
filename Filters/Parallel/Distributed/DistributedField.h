// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DistributedField_h
#define DistributedField_h

#include "Computation/SurfaceFigures.h"
#include "Options.h"
#include "Processes.h"
#include "Result.h"
#include "SurfacePiece.h"

#include "vtkType.h"

#include <functional>
#include <string>
#include <vector>

class vtkPolyData;

namespace DirectionFields::Parallel
{
/// What tells which of other processes' points and cells are the same.
struct PointExchange
{
  /// The points that several pieces have: for each process those whose values it gets from here, which owns them,
  /// and those whose values come from it; in the same order on both sides.
  std::vector<std::vector<vtkIdType>> Sent;
  std::vector<std::vector<vtkIdType>> Received;
  /// The number of each of the piece's own points, the same on all processes.
  std::vector<vtkIdType> Numbers;
  /// How others are found: by global ids, or within a distance.
  bool UseIds = false;
  double Tolerance = 0.0;
};

/// The field of a piece, of which nothing was ever whole on one process.
struct DistributedField
{
  /// Empty, or why the field can only be computed of the gathered surface, as a part of a sentence: then there is
  /// nothing else. The same on all processes.
  std::string Reason;
  /// Over the points and triangles of the piece; the components, and what was mended, are those of the whole.
  Result Field;
  SurfaceFigures Figures;
  vtkIdType SharedPoints = 0;
  PointExchange Exchange;
};

/// Why options can only be had of a gathered surface, as a part of a sentence; empty where they can be had of its
/// pieces.
std::string WhyNotDistributed(const Options& options);

/// Whether this build has PETSc, which the computation needs.
bool CanDistribute();

/// Computes the field. All processes call it; throws ProcessesError.
/// @param surface the triangles of the piece, over all points of its polydata
/// @param guidance of the surface's points
/// @param goOn    is called now and then with the part that is done; false on any process stops all
DistributedField ComputeDistributed(Processes& processes, const Surface& surface,
  const SurfacePiece& piece, const Options& options, const Guidance& guidance,
  const std::function<bool(double)>& goOn);

/// Gives all outputs the same new arrays, and points of several pieces the same bits on all of them, those of their owner:
/// rounding depends on what else a process computes. Then gives copies of other pieces' points and cells what these have; zero where no
/// process has them. All processes call it; throws ProcessesError.
/// @param input  whose arrays stay as they are
/// @param output gets the values, in all arrays of numbers that the input does not have
/// @return how many polygons of all pieces are copies of polygons that no piece has
vtkIdType ExchangeValues(Processes& processes, const PointExchange& exchange,
  const SurfacePiece& piece, vtkPolyData* input, vtkPolyData* output);
}

#endif
