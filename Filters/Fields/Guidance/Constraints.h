// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Constraints_h
#define DirectionFields_Constraints_h

#include "Curvature/Curvature.h"
#include "Geometry/SurfaceGeometry.h"
#include "Options.h"
#include "Result.h"

#include <string>
#include <vector>

namespace DirectionFields::Internal
{
/// The constrained vertices and their directions, by the rules of POC14, section 3, with the
/// details settled in the thesis of C. Clemenz (TU Wien 2019). Vertices of a non-manifold edge are
/// always constrained to it.
struct Constraints
{
  struct Input
  {
    const SurfaceGeometry& Geometry;
    /// The angle of each edge; empty is enough where sharp edges are not asked for.
    const std::vector<double>& DihedralAngles;
    /// Null is enough where curvature is not asked for.
    const Curvature* Curved;
    /// Guidance as a section of the field's degree; empty where it does not constrain.
    const std::vector<Complex>& Given;
    /// GuidanceStrengths; those below 1 do not constrain.
    const std::vector<double>& Strengths;
  };

  /// Adds a sentence for each kind that is asked for and constrains nothing. Throws
  /// std::invalid_argument where least squares would have to solve for more than
  /// MostLeastSquaresVertices.
  Constraints(const Input& input, const Options& options, std::vector<std::string>& notes);

  bool Any() const { return this->Count > 0; }

  /// The kind of each vertex; empty, as Value is, where no vertex is constrained.
  std::vector<ConstraintKind> Kind;
  /// The representation vector of each vertex: its modulus is 1 where the vertex is constrained,
  /// else 0. That of a sharp edge has the edge's angle in the tangent cone, as transport has.
  std::vector<Complex> Value;
  Index Count = 0;

  /// Whether sharp edges have other directions in space.
  bool HasTurns() const { return !this->Turns.empty(); }
  /// Turns the values at vertices on sharp edges, of a section that has these values there, to the
  /// directions of the edges' projections, so that they follow the edges in space.
  void TurnToEdgesInSpace(std::vector<Complex>& section) const;

private:
  /// A vertex of the front, its mirror vertex on a cover, else None, and the factor of modulus 1
  /// from its Value to the direction in space.
  struct Turn
  {
    Index Vertex;
    Index Mirror;
    Complex Factor;
  };
  void Set(Index vertex, ConstraintKind kind, const Complex& value);
  void AddGiven(const Input& input);
  void AddBoundary(const Input& input, const Options& options);
  void MirrorBoundary(const Input& input, const Options& options);
  void MirrorInterior(const Input& input, const Options& options);
  void AddSharpEdges(const Input& input, const Options& options);
  void AddCurvature(const Input& input, const Options& options);
  void DropInconsistent(const Input& input, const Options& options);
  void DropLonely(const Input& input);
  void DropAtSingularities(const Input& input, const Options& options);
  void DropCurvature(const std::vector<char>& drop);

  std::vector<Turn> Turns;
};
}

#endif
