// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef JoinedComponents_h
#define JoinedComponents_h

#include "Mesh/PieceWithSurroundings.h"
#include "Mesh/TriangleMesh.h"

#include "vtkType.h"

#include <vector>

namespace DirectionFields::Parallel
{
/// The first own triangle of each part of a process's mesh, counted over all processes; -1 for
/// parts of other pieces' triangles only.
std::vector<vtkIdType> FirstTriangles(const TriangleMesh& mesh, const PieceWithSurroundings& piece);

/// Joins parts of several processes that share a point, and numbers the components by their first
/// triangles.
/// @param first   the first triangle of each part, counted over all processes; -1 for none
/// @param border  the part at each point on the border of a piece; -1 for none
/// @param numbers of these points, equal for the same point
/// @return the component of each part; -1 where no part of it has a triangle
std::vector<int> JoinedComponents(const std::vector<vtkIdType>& first,
  const std::vector<int>& border, const std::vector<vtkIdType>& numbers);

/// The process that has the only part of each component; -1 where there are several parts.
/// @param components of each part, and how many there are
/// @param first      the first part of each process, and the number of all
std::vector<int> OnlyProcesses(
  const std::vector<int>& components, const std::vector<int>& first, int count);
}

#endif
