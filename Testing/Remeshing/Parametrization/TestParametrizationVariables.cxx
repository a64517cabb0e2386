// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Parametrization/ParametrizationVariables.h"

#include "Features/KeptFeatures.h"
#include "Meshes/Surfaces.h"
#include "Remeshing/CutExample.h"

#include <gtest/gtest.h>

using namespace DirectionFields;
using Meshes::CutExample;

namespace
{
/// Integers are multiples of this, so that a dependent one with a real part would be noticed.
constexpr std::int64_t IntegerStep = 1000;

/// Random values of the free variables, and those of the others that follow.
std::vector<std::int64_t> RandomValues(IntegerElimination& solved, unsigned seed)
{
  std::mt19937 engine(seed);
  std::vector<std::int64_t> value(solved.GetNumberOfVariables(), 0);
  for (std::size_t v = 0; v < value.size(); ++v)
  {
    const std::int64_t random = static_cast<std::int64_t>(engine() % 101) - 50;
    value[v] = solved.IsInteger(static_cast<Index>(v)) ? IntegerStep * random : random;
  }
  for (std::size_t v = 0; v < value.size(); ++v)
  {
    if (!solved.IsFree(static_cast<Index>(v)))
    {
      value[v] = 0;
      for (const auto& [w, factor] : solved.Resolve(static_cast<Index>(v)))
      {
        value[v] += factor * value[w];
      }
    }
  }
  return value;
}

/// The constraints from their definitions.
class Constraints
{
public:
  Constraints(const ParametrizationVariables& variables, const std::vector<std::int64_t>& value)
    : Variables(variables)
    , Plane(variables.Degree)
    , Value(value)
  {
  }
  GridPoint Place(Index v) const { return { this->Value[2 * v], this->Value[2 * v + 1] }; }
  GridPoint Apply(const SymbolicTransition& t, GridPoint p) const
  {
    GridPoint image = this->Plane.Turned(p, t.Turn);
    for (const Jump& jump : t.Jumps)
    {
      image = image +
        this->Plane.Turned(this->Place(this->Variables.Vertices + jump.Variable), jump.Turn);
    }
    return image;
  }
  GridPoint Corner(Index t, int c) const
  {
    const CutMesh::MapTriangle& triangle = this->Variables.Mesh.Triangles[t];
    return this->Apply(triangle.Corner[c], this->Place(triangle.Vertex[c]));
  }
  const IntegerGrid& GetPlane() const { return this->Plane; }

private:
  const ParametrizationVariables& Variables;
  IntegerGrid Plane;
  const std::vector<std::int64_t>& Value;
};

void ExpectConstraints(ParametrizationVariables& variables)
{
  const std::vector<std::int64_t> value = RandomValues(variables.Solved, 3);
  const Constraints constraints(variables, value);
  const CutMesh& mesh = variables.Mesh;
  for (const CutMesh::Cone& cone : mesh.Cones)
  {
    // Its own coordinates are the fixed point of its holonomy.
    const GridPoint place = constraints.Place(cone.Vertex);
    EXPECT_EQ(constraints.Apply(cone.Holonomy, place), place);
  }
  for (const CutMesh::IsolineEdge& edge : mesh.Isolines)
  {
    const GridPoint along = constraints.Corner(edge.Triangle, (edge.Corner + 1) % 3) -
      constraints.Corner(edge.Triangle, edge.Corner);
    EXPECT_EQ(constraints.GetPlane().Turned(along, -edge.Axis).B, 0);
  }
  for (const auto& [key, variable] : variables.AcrossFeature)
  {
    const GridPoint turned =
      constraints.GetPlane().Turned(constraints.Place(key.first), key.second);
    EXPECT_EQ(turned.B, value[variable]);
    EXPECT_EQ(value[variable] % IntegerStep, 0);
  }
  for (Index v = 0; v < variables.Vertices; ++v)
  {
    if (variables.IsPoint[v] != 0)
    {
      EXPECT_EQ(value[2 * v] % IntegerStep, 0);
      EXPECT_EQ(value[2 * v + 1] % IntegerStep, 0);
    }
  }
  for (Index v = 2 * variables.Vertices; v < 2 * (variables.Vertices + mesh.NumberOfJumps); ++v)
  {
    EXPECT_EQ(value[v] % IntegerStep, 0);
  }
}
}

TEST(ParametrizationVariables, AnyValuesOfTheFreeOnesSatisfyAllConstraints)
{
  // The finer sphere and plate have many cones.
  for (const Surface& surface : { Meshes::Icosphere(2), Meshes::Icosphere(3),
         Meshes::PlateWithHole(32, 9, 0.4, false), Meshes::Torus(12, 9), Meshes::Disk(4),
         Meshes::DoubleTorus(), Meshes::PlateWithHole(12, 4, 0.4, true) })
  {
    for (const int degree : { 4, 6 })
    {
      const CutExample example = CutExample::Random(surface, degree, 4);
      ParametrizationVariables variables(example.Mesh);
      ExpectConstraints(variables);
    }
  }
}

TEST(ParametrizationVariables, BoundedLengthsAreTheLengthsOfTheirFeatures)
{
  const CutExample example = CutExample::AlongX(Meshes::Square(6), 4);
  ParametrizationVariables variables(example.Mesh);
  // Edges of length 1: every side of the square is short.
  const std::vector<char> isShort = variables.ShortIsolines(example.Settings(1.0).PerLength);
  EXPECT_EQ(std::count(isShort.begin(), isShort.end(), 1), 4);
  const std::vector<char> isNoneShort = variables.ShortIsolines(example.Settings(10.0).PerLength);
  EXPECT_EQ(std::count(isNoneShort.begin(), isNoneShort.end(), 1), 0);
  variables.BoundIsolines(isShort);
  ExpectConstraints(variables);
  const std::vector<std::int64_t> value = RandomValues(variables.Solved, 5);
  const Constraints constraints(variables, value);
  std::set<std::int64_t> lengths;
  for (const FeatureIsoline& side : variables.Isolines)
  {
    std::int64_t length = 0;
    for (const FeatureIsoline::Step& step : side.Steps)
    {
      const CutMesh::IsolineEdge& edge = example.Mesh.Isolines[step.Isoline];
      const GridPoint along = constraints.Corner(edge.Triangle, (edge.Corner + 1) % 3) -
        constraints.Corner(edge.Triangle, edge.Corner);
      length += constraints.GetPlane().Turned(along, -edge.Axis).A;
    }
    lengths.insert(length);
  }
  // Opposite sides are as long as each other.
  EXPECT_EQ(lengths.size(), 2U);
  std::set<std::int64_t> bounded;
  for (const Index variable : variables.Bounded)
  {
    bounded.insert(value[variable]);
  }
  EXPECT_EQ(lengths, bounded);
}

TEST(ParametrizationVariables, BoundedDistancesAreTheRowsBetweenConesOrLinesAndLines)
{
  const Surface cube = Meshes::FlatlySubdivided(Meshes::Cube(), 3);
  for (const Surface& surface : { cube, Meshes::PlateWithHole(32, 9, 0.4, false), Meshes::Disk(6) })
  {
    for (const int degree : { 4, 6 })
    {
      if (degree == 6 && surface.Points.size() == cube.Points.size())
      {
        // Corners of three squares are no cones of a grid of triangles.
        continue;
      }
      const SurfaceGeometry geometry(surface);
      const CutExample example(
        surface, degree, [&](const SurfaceGeometry& of) { return Meshes::RandomSection(of, 4); },
        FindFeatures(geometry, FeatureSettings{ true, 40.0, 0.0, 0.0 }));
      ParametrizationVariables variables(example.Mesh);
      const std::vector<RowDistance> distances =
        FindRowDistances(example.Mesh, example.Settings(10.0).PerLength);
      ASSERT_GT(distances.size(), 10U);
      variables.BoundDistances(distances);
      ExpectConstraints(variables);
      const std::vector<std::int64_t> value = RandomValues(variables.Solved, 6);
      const Constraints constraints(variables, value);
      std::set<std::int64_t> bounded;
      for (const Index variable : variables.Bounded)
      {
        bounded.insert(value[variable]);
      }
      std::size_t found = 0;
      for (const RowDistance& distance : distances)
      {
        const auto rowOf = [&](int corner)
        {
          const GridPoint place =
            constraints.Apply(distance.ToFirst, constraints.Corner(distance.Triangle, corner)) -
            constraints.Corner(distance.From / 3, distance.From % 3);
          return constraints.GetPlane().Turned(place, -distance.Axis).B;
        };
        // The line is one of the grid, in whatever chart it is looked at.
        EXPECT_EQ(rowOf(distance.Corner), rowOf((distance.Corner + 1) % 3));
        found += bounded.count(rowOf(distance.Corner));
      }
      EXPECT_GT(10 * found, 9 * distances.size());
    }
  }
}
