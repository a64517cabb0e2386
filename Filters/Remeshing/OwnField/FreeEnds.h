// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FreeEnds_h
#define DirectionFields_FreeEnds_h

#include "Geometry/SurfaceGeometry.h"

#include <vector>

namespace DirectionFields::Internal
{
/// What a field of degree n needs around lines of features that end inside of the surface. Such a
/// line may turn a field to the same side on its left and its right, up to half of 2 pi / n, as a
/// line at 45 degrees to the sides of a square does. The flux of the field's rotation out of the
/// line is then not zero, and the sizes of a map, whose logarithm is the conjugate function of the
/// rotation, jump by e to the flux from one side of the line to the other: faces fold at its ends.
/// Directions next to the two ends that turn by 2 pi / n around the one and by -2 pi / n around the
/// other give each a singularity. The field then turns the other way on one side of the line, where
/// that takes little more energy, and the fluxes of the sides cancel each other; else it has an
/// opposite singularity beside each, and rows of faces end there, which is room for the sizes.
class FreeEnds
{
public:
  /// Finds the lines that have such a flux.
  /// @param isFeature not 0 for each edge that is a feature
  /// @param section   a field of the degree that is kept along the features
  /// @param face      the usual length of an edge of the mesh to be made; shorter lines are left
  FreeEnds(const SurfaceGeometry& geometry, int degree, const std::vector<char>& isFeature,
    const std::vector<Complex>& section, double face);

  bool IsEmpty() const { return this->Lines.empty(); }
  /// The direction at each vertex next to an end of such a line that gives the end its singularity,
  /// of length 1; zero elsewhere.
  std::vector<Vector3> Directions() const;

private:
  /// From a free end to where it ends.
  struct Line
  {
    Index First;
    Index Last;
    /// How many times 2 pi / n the field turns around the first vertex, counter-clockwise.
    int Turn;
  };
  struct Fluxes
  {
    double Left = 0.0;
    double Right = 0.0;
    double Ends = 0.0;
    double Sum() const { return this->Left + this->Right + this->Ends; }
  };
  bool IsFreeEnd(Index v) const { return this->Sides[v] == 1 && !this->Mesh.IsBoundary(v); }
  std::vector<Index> LineFrom(Index v) const;
  double LengthOfFlat(const std::vector<Index>& line, const std::vector<double>& dihedral) const;
  Fluxes FluxesOf(const std::vector<Index>& line, const std::vector<Complex>& section) const;
  double FluxAlong(Index h, const std::vector<Complex>& section) const;
  void AddDirections(Index end, int turn, std::vector<Vector3>& directions) const;

  const SurfaceGeometry& Geometry;
  const TriangleMesh& Mesh;
  const int Degree;
  const std::vector<char>& IsFeature;
  /// The features, and edges of the boundary, at each vertex.
  std::vector<int> Sides;
  std::vector<Line> Lines;
};
}

#endif
