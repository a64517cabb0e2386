// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ReferenceSection_h
#define DirectionFields_ReferenceSection_h

#include "Geometry/SurfaceGeometry.h"

namespace DirectionFields::Internal
{
/// Sections that follow from the geometry of a component alone, not from any numbering: the start
/// of the eigensolver, and the reference that fixes the global phase of the eigenvector. All arrays
/// are over the vertices of the component.
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

  /// The sums of FixPhase over the vertices, by which a component in pieces gets the phase of the
  /// whole: the overlaps of the pieces add up, the first axis whose overlap decides gives the
  /// phase, and where none does the piece with the largest candidate.
  struct Overlap
  {
    Complex Sum = 0.0;
    double Size = 0.0;

    void operator+=(const Overlap& other)
    {
      this->Sum += other.Sum;
      this->Size += other.Size;
    }
    /// Whether it is larger than the rounding that a symmetry leaves.
    bool Decides() const;
  };
  /// @param counts for each vertex whether it is summed up; empty for all
  Overlap OverlapWith(int axis, const ComplexVector& u, const std::vector<char>& counts) const;
  /// A vertex that no symmetry maps to another, and the overlap there.
  struct Candidate
  {
    double Value = -1.0;
    Index Vertex = 0;
    Complex Overlap = 0.0;

    void operator+=(const Candidate& other) { *this = other.Value > this->Value ? other : *this; }
  };
  Candidate FindCandidate(const ComplexVector& u, const std::vector<char>& counts) const;
  /// The box around the whole component, where its vertices are not all there.
  void SetBox(const Vector3& lower, const Vector3& upper);

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

/// Turns a section by one global phase towards another one; a symmetric section over a cover by
/// half a turn or not at all. Nothing is done where the two have nothing in common.
void TurnTowards(const ComplexVector& reference, bool isCover, ComplexVector& u);
}

#endif
