// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SurfacePiece_h
#define SurfacePiece_h

#include "vtkType.h"

#include <cstddef>
#include <vector>

class vtkPolyData;

namespace DirectionFields::Parallel
{
/// Polygons or strips, by the numbers of their points.
struct PieceCells
{
  /// Which cells of the vtkPolyData they are.
  std::vector<vtkIdType> Cells;
  /// The number of corners of each; empty where all have three.
  std::vector<vtkIdType> Sizes;
  std::vector<vtkIdType> Corners;

  vtkIdType Size(std::size_t i) const { return this->Sizes.empty() ? 3 : this->Sizes[i]; }
};

/// Points of the vtkPolyData that some cells use, in ascending order.
struct PiecePoints
{
  std::vector<vtkIdType> Points;
  /// Three coordinates of each.
  std::vector<double> Coordinates;
  /// The global id of each; empty where the vtkPolyData has none.
  std::vector<vtkIdType> GlobalIds;
};

/// The polygons and strips of a vtkPolyData, which is one process's piece of a surface.
struct SurfacePiece
{
  /// The points of the piece's own cells, which the corners are counted by.
  PiecePoints Own;
  PieceCells Polys;
  PieceCells Strips;
  /// The ends of the edges that only one of the piece's own triangles has, two numbers of own
  /// points each.
  std::vector<vtkIdType> BorderEdges;

  /// Cells that are copies of another piece's, and their points that no own cell has. Corners below
  /// the number of own points are own points, the others are these.
  PieceCells Ghosts;
  PiecePoints GhostPoints;

  bool HasPoints = false;
  bool HasDoublePoints = false;
  bool HasGlobalIds = false;
};

/// Reads a piece. Cells that vtkGhostType marks as hidden take no part.
///
/// Throws std::invalid_argument where a point in use has coordinates that are not finite or too
/// large.
/// @param polyData has passed vtkDirectionField's check
SurfacePiece ReadPiece(vtkPolyData* polyData);
}

#endif
