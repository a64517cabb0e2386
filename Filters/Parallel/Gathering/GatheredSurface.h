// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef GatheredSurface_h
#define GatheredSurface_h

#include "Processes.h"
#include "SurfacePiece.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace DirectionFields::Parallel
{
/// The pieces of all processes as one surface on one of them, and the way back.
struct GatheredSurface
{
  /// The process that has the surface: the one with the largest piece, the first of equal ones,
  /// unless another one was asked for.
  int Process = 0;
  /// Points, polygons and strips of all pieces, without the copies that other pieces have of them,
  /// and the arrays that were asked for; null on the other processes.
  vtkSmartPointer<vtkPolyData> Surface;
  /// How many processes have a piece.
  int Pieces = 0;
  /// How many polygons and strips the surface has, which are triangles mostly.
  vtkIdType Cells = 0;
  /// How many points of the surface belong to several pieces; 0 on the other processes.
  vtkIdType SharedPoints = 0;
  /// How many polygons of the pieces are copies of polygons that no piece has; 0 on the other
  /// processes.
  vtkIdType LostCopies = 0;

  /// This process's own piece.
  SurfacePiece Piece;
  /// For each process the surface's points of its piece: the points of its own cells, then the
  /// points that only copied cells have. -1 where there is none. Only where the surface is, as all
  /// below.
  std::vector<vtkIdType> PointsOf;
  /// The first of each process's, and their number.
  std::vector<vtkIdType> FirstPointOf;
  /// How many of each process's are points of its own cells.
  std::vector<vtkIdType> OwnPointsOf;
  /// The same for cells: own polygons, own strips, copied polygons.
  std::vector<vtkIdType> CellsOf;
  std::vector<vtkIdType> FirstCellOf;
  std::vector<vtkIdType> OwnCellsOf;
};

/// Gathers a surface. All processes call it; throws ProcessesError.
/// @param polyData the piece, which ReadPiece takes
/// @param arrays   names of point arrays of numbers that the surface is to have; one that a piece
///                 with points lacks, or has with another number of components, is left out
/// @param cells    the same for cell arrays
/// @param to       the process that gets the surface; -1 for that with the largest piece
GatheredSurface GatherSurface(Processes& processes, vtkPolyData* polyData,
  const std::vector<std::string>& arrays, const std::vector<std::string>& cells = {}, int to = -1);
}

#endif
