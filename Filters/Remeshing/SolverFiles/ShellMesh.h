// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ShellMesh_h
#define DirectionFields_ShellMesh_h

#include "Types.h"

#include <array>
#include <string>
#include <vector>

namespace DirectionFields
{
/// Points or faces of a mesh under one name.
struct NamedSet
{
  /// Any text; files may allow fewer characters.
  std::string Name;
  /// Numbers from 0 on, in any order.
  std::vector<Index> Members;
};

/// A mesh of shell elements for a solver of finite elements.
struct ShellMesh
{
  std::vector<Vector3> Points;
  /// Corners in their order around the face; the fourth one of a triangle is None.
  std::vector<std::array<Index, 4>> Faces;
  /// Parts of the surface, whose faces may have materials of their own.
  std::vector<NamedSet> FaceSets;
  /// Places of loads and supports.
  std::vector<NamedSet> PointSets;
  /// A vector for each face, of any length, that the first axis of its material is along; empty for
  /// none. The projection to the face counts.
  std::vector<Vector3> Directions;
};
}

#endif
