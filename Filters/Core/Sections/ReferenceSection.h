// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ReferenceSection_h
#define DirectionFields_ReferenceSection_h

#include "Geometry/SurfaceGeometry.h"

namespace DirectionFields::Internal
{
/// Sections that follow from the geometry of a component alone, not from any numbering: the start of
/// the eigensolver, and what fixes the global phase that the eigenvector leaves open. All arrays are
/// over the vertices of the component.
class ReferenceSection
{
public:
  ReferenceSection(
    const SurfaceGeometry& geometry, const TriangleMesh::Component& component, int degree);

  /// A smooth section without any symmetry, made of a smooth vector field in space.
  ComplexVector Start() const;

  /// Turns a section by one global phase so that its directions are close to the x axis on average;
  /// to the y or z axis, or at one vertex, where that leaves the phase open.
  void FixPhase(ComplexVector& u) const;

private:
  /// The n-th power of the tangential part of a vector, of that part's length.
  Complex Power(Index vertex, const Vector3& v) const;
  /// Position within the component's bounding box, about -1 to 1.
  Vector3 Position(Index vertex) const;

  const TangentFrames& Frames;
  const std::vector<Vector3>& Positions;
  const TriangleMesh::Component& Component;
  int Degree;
  Vector3 Center;
  double HalfSize;
};

/// Turns a section by one global phase towards another one; a symmetric section over a cover by half a
/// turn or not at all. Nothing is done where the two have nothing in common.
void TurnTowards(const ComplexVector& reference, bool isCover, ComplexVector& u);
}

#endif
