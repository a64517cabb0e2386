// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_RotationRepair_h
#define DirectionFields_RotationRepair_h

#include "Distance/SurfaceDistance.h"
#include "TrivialConnection/DiscreteForms.h"
#include "TrivialConnection/RotationObjective.h"

#include <vector>

namespace DirectionFields::Internal
{
/// How the rotations along the edges of a triangle are set before the others are computed.
enum class RotationSetting : char
{
  /// As they are around a singularity at its place; those of other triangles are free.
  Prescribed = 0,
  /// They are free.
  Free = 1,
  /// They are those of the base.
  Base = 2
};

/// The singularities that a component is to have.
struct RotationTarget
{
  /// Of each triangle of the component, in units of 1/n.
  std::vector<int> Indices;
  /// Where in their triangles singularities are, with weights of the mesh's corners. Others are
  /// where the base vanishes.
  std::vector<MeshPlace> Places;
  RotationObjective Objective = RotationObjective::Smoothest;
};

/// An edge along which the rotation is set, counted from the component's first one.
struct SetEdge
{
  Index Edge;
  double Rotation;
};
/// The attempt to mend a field that has not the indices that it is to have: its rotation along some
/// edge is more than half a turn.
class RotationRepair
{
public:
  /// All must outlive this.
  /// @param baseIndices of the triangles of the component
  RotationRepair(const TriangleMesh& mesh, const TriangleMesh::Component& component,
    const std::vector<int>& baseIndices, const RotationTarget& target)
    : Mesh(mesh)
    , Component(component)
    , BaseIndices(baseIndices)
    , Target(target)
  {
  }

  /// Takes the rotations of the base around triangles whose index is wrong, where no singularity is
  /// asked for that the base has not: the base shows that the triangles there can carry theirs.
  /// @param wrong    triangles of the component, counted from its first one
  /// @param rings    of triangles around a wrong one that become those of the base
  /// @param settings of the triangles of the component; empty where all are as prescribed
  /// @return whether there are any
  bool KeepBase(
    const std::vector<Index>& wrong, int rings, std::vector<RotationSetting>& settings) const;
  /// Frees singular triangles that touch one whose index is wrong.
  /// @return whether there are any
  bool Loosen(const std::vector<Index>& wrong, std::vector<RotationSetting>& settings) const;
  /// Limits the rotations of edges to the largest that is allowed.
  /// @return whether there are any
  static bool LimitEdges(const EdgeForm& rotation, std::vector<SetEdge>& edges);

  /// Whether a place is the middle of its triangle, where a singularity of the given field is: one
  /// that is there has not been moved.
  static bool IsMiddle(const MeshPlace& place);

private:
  /// Not 0 for triangles that are to have the base's singularity, where it is, or none as the base.
  std::vector<char> OwnTriangles() const;
  /// Appends the triangles that touch one.
  void AddRing(Index localTriangle, std::vector<Index>& ring) const;

  const TriangleMesh& Mesh;
  const TriangleMesh::Component& Component;
  const std::vector<int>& BaseIndices;
  const RotationTarget& Target;
};
}

#endif
