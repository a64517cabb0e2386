// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SizeAdvice_h
#define DirectionFields_SizeAdvice_h

#include "FaceMesh/Faces.h"
#include "Geometry/SurfaceGeometry.h"
#include "Types.h"

#include <string>
#include <vector>

namespace DirectionFields::Internal
{
/// Tells the user where the wanted faces are too large for the surface, and which length of edges
/// would be short enough.
class SizeAdvice
{
public:
  /// @param edgeLength the one that is asked for
  /// @param degree     4 for quads, 6 for triangles
  SizeAdvice(double edgeLength, int degree)
    : EdgeLength(edgeLength)
    , Degree(degree)
  {
  }

  /// The length is longer than the one that the area gives.
  void Lengthen(double ofArea) { this->LengthOfArea = ofArea; }
  /// @param perLength 1 / h of each vertex, h the wanted length of edges there
  void AddComponent(const SurfaceGeometry& geometry, const TriangleMesh::Component& component,
    const std::vector<double>& perLength);
  /// @param kept vertices that are no grid points but could not be removed
  void AddMesh(const std::vector<Vector3>& points, const Faces& faces, Index kept);
  /// @param unit of the lengths, in that of the user's surface
  std::vector<std::string> GetSentences(double unit = 1.0) const;

private:
  double EdgeLength;
  int Degree;
  /// 0 if it is the one that is asked for.
  double LengthOfArea = 0.0;
  Index SmallComponents = 0;
  /// The least faces of a component.
  double LeastFaces = 0.0;
  Index Kept = 0;
  double ShortestEdge = 0.0;
};
}

#endif
