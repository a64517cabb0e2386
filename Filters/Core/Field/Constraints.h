// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Constraints_h
#define DirectionFields_Constraints_h

#include "Field/Curvature.h"
#include "Geometry/TangentFrames.h"
#include "Options.h"
#include "Result.h"

#include <string>
#include <vector>

namespace DirectionFields
{
/// Which vertices are constrained, and to what; after POC14, section 3, as the thesis of C. Clemenz
/// (TU Wien 2019) settled it. Vertices of a non-manifold edge are always constrained to it.
struct Constraints
{
  struct Input
  {
    const TriangleMesh& Mesh;
    const Connection& Transport;
    const TangentFrames& Frames;
    /// Of the vertices.
    const std::vector<Vector3>& Positions;
    /// Of each edge; may be empty if sharp edges are not asked for.
    const std::vector<double>& DihedralAngles;
    /// May be null if curvature is not asked for.
    const Curvature* Curved;
    /// Area of each component in its unit.
    const std::vector<double>& ComponentArea;
    /// Guidance as a section of the field's degree; empty if not asked for.
    const std::vector<Complex>& Given;
  };

  /// Adds a sentence for each kind that is asked for and constrains nothing.
  Constraints(const Input& input, const Options& options, std::vector<std::string>& notes);

  bool Any() const { return this->Count > 0; }

  /// Over the vertices; empty, as Value, if none is constrained.
  std::vector<ConstraintKind> Kind;
  /// Representation vector, of modulus 1 where constrained, else 0.
  std::vector<Complex> Value;
  Index Count = 0;

private:
  void Set(Index vertex, ConstraintKind kind, const Complex& value);
  void AddGiven(const Input& input);
  void AddBoundary(const Input& input, const Options& options);
  void MirrorBoundary(const Input& input, const Options& options);
  void MirrorInterior(const Input& input, const Options& options);
  void AddSharpEdges(const Input& input, const Options& options);
  void AddCurvature(const Input& input, const Options& options);
  void DropInconsistent(const Input& input, const Options& options);
  void DropAtSingularities(const Input& input, const Options& options);
  void DropCurvature(const std::vector<char>& drop);
};
}

#endif
