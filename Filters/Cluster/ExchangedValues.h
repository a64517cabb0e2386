// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef ExchangedValues_h
#define ExchangedValues_h

#include "Processes.h"
#include "SurfacePiece.h"

#include "vtkType.h"

#include <vector>

class vtkPolyData;

namespace DirectionFields::Parallel
{
/// Tells which points and cells of other processes are the same.
struct PointExchange
{
  /// The points that several pieces have: for each process the points that this process owns and
  /// sends, and the points that the other one owns and sends here; in the same order on both sides.
  std::vector<std::vector<vtkIdType>> Sent;
  std::vector<std::vector<vtkIdType>> Received;
  /// The number of each of the piece's own points, the same on all processes.
  std::vector<vtkIdType> Numbers;
  /// How others are found: by global ids, or within a distance.
  bool UseIds = false;
  double Tolerance = 0.0;
};

/// Gives all outputs the same new arrays, and points of several pieces the same bits on all of
/// them, their owner's: rounding depends on the other points of a process. Then gives copies of
/// other pieces' points and cells the values of the originals; zero where no process has them. All
/// processes call it; throws ProcessesError.
/// @param input  whose arrays stay as they are
/// @param output gets the values, in all arrays of numbers that the input does not have
/// @return how many polygons of all pieces are copies of polygons that no piece has
vtkIdType ExchangeValues(Processes& processes, const PointExchange& exchange,
  const SurfacePiece& piece, vtkPolyData* input, vtkPolyData* output);
}

#endif
