// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Parametrization/IsolineFolds.h"

#include "Meshes/Surfaces.h"
#include "Parametrization/ParametrizationVariables.h"
#include "Remeshing/CutExample.h"

#include <gtest/gtest.h>

using namespace DirectionFields;
using Meshes::CutExample;

namespace
{
constexpr int Cells = 6;

/// A square of 12 x 12 units of the grid, whose four sides are isolines.
struct MappedSquare
{
  MappedSquare()
    : Example(CutExample::AlongX(Meshes::Square(Cells), 4))
    , Isolines(ParametrizationVariables(this->Example.Mesh).Isolines)
    , Own(3 * this->Example.Mesh.Triangles.size())
    , Places(this->Example.Mesh.Positions.size())
  {
    const IntegerGridMap map(this->Example.Mesh, this->Example.Settings(2.0 * Cells));
    const IntegerGrid plane(4);
    for (std::size_t h = 0; h < this->Own.size(); ++h)
    {
      const CutMesh::MapTriangle& t = this->Example.Mesh.Triangles[h / 3];
      EXPECT_TRUE(t.Corner[h % 3].Jumps.empty());
      this->Own[h].Turn = t.Corner[h % 3].Turn;
      this->Places[t.Vertex[h % 3]] = plane.Apply(plane.Inverse(this->Own[h]), map.GetCorners()[h]);
    }
  }

  /// The inner vertices of a side in its direction, and how far each is along it.
  std::vector<GridPoint> Along(const FeatureIsoline& side) const
  {
    std::vector<GridPoint> places;
    for (const FeatureIsoline::Step& step : side.Steps)
    {
      const CutMesh::IsolineEdge& edge = this->Example.Mesh.Isolines[step.Isoline];
      if (places.empty())
      {
        places.push_back(this->Places[EndOf(this->Example.Mesh, edge, step.IsReversed)]);
      }
      places.push_back(this->Places[EndOf(this->Example.Mesh, edge, !step.IsReversed)]);
    }
    return places;
  }

  CutExample Example;
  std::vector<FeatureIsoline> Isolines;
  std::vector<Transition> Own;
  std::vector<GridPoint> Places;
};

/// The vertex between two steps of a side.
Index VertexAfter(const MappedSquare& square, const FeatureIsoline& side, std::size_t step)
{
  const CutMesh& mesh = square.Example.Mesh;
  const FeatureIsoline::Step& at = side.Steps[step];
  return EndOf(mesh, mesh.Isolines[at.Isoline], !at.IsReversed);
}
}

TEST(IsolineFolds, AreSpacedAnewInProportionToTheLengthsOfTheEdges)
{
  MappedSquare square;
  ASSERT_EQ(square.Isolines.size(), 4U);
  const std::vector<GridPoint> before = square.Places;
  for (const FeatureIsoline& side : square.Isolines)
  {
    ASSERT_EQ(side.Steps.size(), static_cast<std::size_t>(Cells));
    // The third inner vertex is set back behind the first: the map runs back and forth.
    const std::vector<GridPoint> places = square.Along(side);
    square.Places[VertexAfter(square, side, 2)] = places[1] + places[1] - places[2];
  }
  EXPECT_NE(square.Places, before);
  EXPECT_TRUE(
    UnfoldIsolines(square.Example.Mesh, square.Own, square.Isolines, square.Places).empty());
  // All edges are as long as each other, so that the vertices are where they were.
  for (std::size_t v = 0; v < before.size(); ++v)
  {
    EXPECT_LE(std::abs(square.Places[v].A - before[v].A), 2);
    EXPECT_LE(std::abs(square.Places[v].B - before[v].B), 2);
  }
}

TEST(IsolineFolds, StayWhereNothingIsFolded)
{
  MappedSquare square;
  const std::vector<GridPoint> before = square.Places;
  EXPECT_TRUE(
    UnfoldIsolines(square.Example.Mesh, square.Own, square.Isolines, square.Places).empty());
  EXPECT_EQ(square.Places, before);
}

TEST(IsolineFolds, FeaturesWhoseEndsAreInTheWrongOrderAreReturned)
{
  MappedSquare square;
  const FeatureIsoline side = square.Isolines.front();
  const Index last = VertexAfter(square, side, Cells - 1);
  const std::vector<GridPoint> places = square.Along(side);
  const GridPoint back = places[0] - places[1];
  square.Places[last] = places[0] + back;
  const std::vector<GridPoint> before = square.Places;
  const std::vector<FeatureIsoline> collapsed =
    UnfoldIsolines(square.Example.Mesh, square.Own, { side }, square.Places);
  ASSERT_EQ(collapsed.size(), 1U);
  EXPECT_EQ(collapsed.front().Steps.size(), side.Steps.size());
  EXPECT_EQ(square.Places, before);
}
