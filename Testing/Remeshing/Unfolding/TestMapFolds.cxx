// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Unfolding/MapFolds.h"

#include "Meshes/Surfaces.h"
#include "Parametrization/ParametrizationVariables.h"
#include "Remeshing/CutExample.h"
#include "Support/Threads.h"
#include "Unfolding/ConeOpening.h"
#include "Unfolding/PatchUnfolding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

using namespace DirectionFields;
using Meshes::CutExample;

namespace
{
/// A regular polygon with a field that is parallel to its sides and has one singularity inside: of
/// index (n - sides) / n.
CutExample Polygon(int degree, int sides, int levels, const Vector3& singularity)
{
  Surface fan;
  fan.Points.push_back(Vector3::Zero());
  for (int k = 0; k < sides; ++k)
  {
    const double angle = 2.0 * Pi * (k + 0.5) / sides;
    fan.Points.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    fan.Triangles.push_back({ 0, k + 1, (k + 1) % sides + 1 });
  }
  return { Meshes::FlatlySubdivided(fan, levels), degree,
    [&](const SurfaceGeometry& geometry)
    {
      return Meshes::SectionAlong(geometry, degree,
        [&](const Vector3& p)
        {
          // Across each side the field is parallel to its normal.
          const double angle = (1.0 - static_cast<double>(sides) / degree) *
            std::atan2(p.y() - singularity.y(), p.x() - singularity.x());
          return Vector3(std::cos(angle), std::sin(angle), 0.0);
        });
    } };
}

/// The places of a map, each vertex in the chart of the first triangle that has it as a corner.
struct Mapped
{
  Mapped(const CutExample& example, double perLength, bool isUnfolded = true)
    : Settings(SettingsOf(example, perLength, isUnfolded))
    , IsPoint(ParametrizationVariables(example.Mesh).IsPoint)
    , Own(3 * example.Mesh.Triangles.size())
    , Places(example.Mesh.Positions.size())
    , Map(example.Mesh, this->Settings)
    , Movable(example.Mesh, this->OwnOf(example.Mesh), this->IsPoint, this->Settings.PerLength,
        this->Places)
  {
  }

  static IntegerGridMap::Settings SettingsOf(
    const CutExample& example, double perLength, bool isUnfolded)
  {
    IntegerGridMap::Settings settings = example.Settings(perLength);
    settings.IsUnfolded = isUnfolded;
    return settings;
  }

  const std::vector<Transition>& OwnOf(const CutMesh& mesh)
  {
    const IntegerGrid plane(mesh.Degree);
    std::vector<char> isKnown(this->Places.size(), 0);
    for (std::size_t h = 0; h < this->Own.size(); ++h)
    {
      const CutMesh::MapTriangle& t = mesh.Triangles[h / 3];
      GridPoint& place = this->Places[t.Vertex[h % 3]];
      const GridPoint& corner = this->Map.GetCorners()[h];
      const int turn = t.Corner[h % 3].Turn;
      place = isKnown[t.Vertex[h % 3]] != 0 ? place : plane.Turned(corner, -turn);
      isKnown[t.Vertex[h % 3]] = 1;
      this->Own[h] = { turn, corner - plane.Turned(place, turn) };
    }
    return this->Own;
  }

  Index CountFlipped() const
  {
    Index count = 0;
    for (Index t = 0; t < static_cast<Index>(this->Movable.Mesh.Triangles.size()); ++t)
    {
      count += this->Movable.IsFlipped(t) ? 1 : 0;
    }
    return count;
  }

  Index CountWronglySurrounded() const
  {
    Index count = 0;
    for (Index v = 0; v < static_cast<Index>(this->Places.size()); ++v)
    {
      count += this->Movable.IsSurrounded(v) ? 0 : 1;
    }
    return count;
  }

  /// Moves vertices near a point as far as they may in any direction, by up to a distance.
  void Scramble(const Vector3& middle, double radius, double distance, unsigned seed)
  {
    std::mt19937 engine(seed);
    const auto random = [&]() { return distance * (engine() / 2147483648.0 - 1.0); };
    for (Index v = 0; v < static_cast<Index>(this->Places.size()); ++v)
    {
      if (this->Movable.GetFreedom(v) == 2 &&
        (this->Movable.Mesh.Positions[v] - middle).norm() < radius)
      {
        this->Movable.Move(v, random(), random());
      }
    }
  }

  IntegerGridMap::Settings Settings;
  std::vector<char> IsPoint;
  std::vector<Transition> Own;
  std::vector<GridPoint> Places;
  IntegerGridMap Map;
  MovablePlaces Movable;
};
}

/// A cone is a grid point. Here the nearest is several triangles away from the place that the cone
/// would have, and the map over the integers that is closest to the field is folded there.
TEST(MapFolds, MapsAreUnfoldedAroundCones)
{
  int maps = 0;
  int left = 0;
  for (const auto& [degree, sides] :
    { std::pair(4, 3), std::pair(4, 5), std::pair(6, 5), std::pair(6, 7) })
  {
    Index folded = 0;
    // On a spiral around the middle.
    for (int k = 2; k <= 24; k += 2)
    {
      const Complex place = std::polar(0.004 * k, 2.4 * k);
      const CutExample example =
        Polygon(degree, sides, 5, Vector3(place.real(), place.imag(), 0.0));
      const Index before = Mapped(example, 6.0, false).CountFlipped();
      const Mapped mapped(example, 6.0);
      ASSERT_FALSE(mapped.Map.GetFailure());
      EXPECT_EQ(mapped.Map.CountFlipped(), mapped.CountFlipped());
      EXPECT_LE(mapped.CountFlipped(), before);
      folded += before;
      left += mapped.CountFlipped() > 0 || mapped.CountWronglySurrounded() > 0 ? 1 : 0;
      ++maps;
    }
    // Towards angles of more than 360 degrees three triangles are few.
    EXPECT_TRUE(sides < degree || folded > 5) << degree << ", " << sides << ": " << folded;
  }
  EXPECT_LE(6 * left, maps);
}

/// A cone that the map goes around by the right angle keeps it, whatever is wrong around, unless its
/// triangles become thinner than the numbers of the grid can tell.
TEST(MapFolds, ConesKeepTheirAngle)
{
  const CutExample example = Polygon(4, 5, 4, Vector3(0.011, 0.005, 0.0));
  std::vector<Index> vertices(example.Mesh.Positions.size());
  std::iota(vertices.begin(), vertices.end(), 0);
  std::vector<Index> triangles(example.Mesh.Triangles.size());
  std::iota(triangles.begin(), triangles.end(), 0);
  int lost = 0;
  for (unsigned seed = 0; seed < 30; ++seed)
  {
    Mapped mapped(example, 6.0);
    mapped.Scramble(Vector3::Zero(), 0.25, 1.0, seed);
    OpenCone(mapped.Movable, vertices.back(), vertices, vertices, 0.0);
    ASSERT_TRUE(mapped.Movable.IsSurrounded(vertices.back()));
    UnfoldPatch(mapped.Movable, vertices, triangles);
    lost += mapped.Movable.IsSurrounded(vertices.back()) ? 0 : 1;
  }
  EXPECT_LE(lost, 4);
}

/// Whatever the places of the vertices are that may move, they become those of a map without folds.
/// Grid points stay, and vertices of sides stay on these.
TEST(MapFolds, ScrambledPlacesAreUnfolded)
{
  for (const auto& [degree, sides] :
    { std::pair(4, 3), std::pair(4, 4), std::pair(4, 5), std::pair(6, 6) })
  {
    const CutExample example = Polygon(degree, sides, 4, Vector3(0.011, 0.005, 0.0));
    for (unsigned seed = 0; seed < 8; ++seed)
    {
      Mapped mapped(example, 6.0);
      ASSERT_EQ(mapped.CountFlipped(), 0);
      // Within a patch in the middle, or beside a side.
      const bool isInMiddle = seed % 2 == 0;
      mapped.Scramble(isInMiddle ? Vector3::Zero() : Vector3(0.8 * std::cos(Pi / sides), 0.0, 0.0),
        0.25, 0.4, seed);
      ASSERT_GT(mapped.CountFlipped(), 0);
      const std::vector<GridPoint> before = mapped.Places;
      UnfoldTriangles(mapped.Movable);
      EXPECT_EQ(mapped.CountFlipped(), 0) << degree << ", " << sides << ", " << seed;
      EXPECT_EQ(mapped.CountWronglySurrounded(), 0) << degree << ", " << sides << ", " << seed;
      int slid = 0;
      for (std::size_t v = 0; v < before.size(); ++v)
      {
        const auto vertex = static_cast<Index>(v);
        const int freedom = mapped.Movable.GetFreedom(vertex);
        const Complex move = std::conj(mapped.Movable.GetDirection(vertex)) *
          mapped.Movable.Plane.Place(mapped.Places[v] - before[v]);
        EXPECT_TRUE(freedom == 2 || std::abs(move.imag()) < 1e-9);
        EXPECT_TRUE(freedom > 0 || move == 0.0);
        slid += freedom == 1 && move != 0.0 ? 1 : 0;
      }
      EXPECT_TRUE(isInMiddle || slid > 0);
    }
  }
}

/// Patches that do not touch are shared among threads, and those that do are not.
TEST(MapFolds, AreTheSameForAnyNumberOfThreads)
{
  const CutExample example = Polygon(4, 5, 5, Vector3(0.011, 0.005, 0.0));
  int folded = 0;
  for (unsigned seed = 0; seed < 6; ++seed)
  {
    std::vector<std::vector<GridPoint>> places;
    for (const int number : { 1, 2, 3 })
    {
      Mapped mapped(example, 12.0);
      for (unsigned k = 0; k < 24; ++k)
      {
        const Complex middle = std::polar(0.15 + 0.025 * k, (2.4 + 0.02 * seed) * k);
        mapped.Scramble(Vector3(middle.real(), middle.imag(), 0.0), 0.03, 0.7, 24 * seed + k);
      }
      folded += mapped.CountFlipped();
      Threads threads(number);
      const Threads::Scope scope(threads);
      UnfoldTriangles(mapped.Movable);
      places.push_back(mapped.Places);
    }
    EXPECT_TRUE(places[0] == places[1] && places[0] == places[2]) << seed;
  }
  EXPECT_GT(folded, 100);
}

/// A map that turns one of the three triangles at a cone over goes around it by 360 degrees less.
TEST(MapFolds, ConesAreOpenedToTheirAngle)
{
  for (const auto& [degree, sides] : { std::pair(4, 3), std::pair(4, 5), std::pair(6, 7) })
  {
    const CutExample example = Polygon(degree, sides, 4, Vector3(0.011, 0.005, 0.0));
    Mapped mapped(example, 6.0);
    MovablePlaces& movable = mapped.Movable;
    const auto count = static_cast<Index>(mapped.Places.size());
    std::vector<Index> all(count);
    std::iota(all.begin(), all.end(), 0);
    const Index cone = count - 1;
    ASSERT_TRUE(movable.IsInTriangle(cone));
    EXPECT_NEAR(movable.WantedAngle(cone), 2.0 * Pi * sides / degree, 1e-12);
    EXPECT_TRUE(movable.IsSurrounded(cone));
    // The neighbour goes to the other side of the cone.
    const Index t = movable.TrianglesAt(cone)[0];
    const Index neighbour = example.Mesh.Triangles[t].Vertex[1];
    movable.MoveTo(
      neighbour, 2.0 * movable.Corner(t, 0) - movable.Corner(t, 1), movable.FromVertex(t, 1));
    EXPECT_FALSE(movable.IsSurrounded(cone));
    OpenCone(movable, cone, all, all, 0.5);
    EXPECT_TRUE(movable.IsSurrounded(cone));
    EXPECT_EQ(movable.TrianglesAt(cone).size(), 3);
    for (const Index around : movable.TrianglesAt(cone))
    {
      EXPECT_FALSE(movable.IsFlipped(around)) << sides;
    }
  }
}

/// Where corners are in one place there is no angle, and nothing that could be unfolded, but
/// triangles beside may be.
TEST(MapFolds, GridPointsInOnePlaceAreLeft)
{
  const CutExample example = Polygon(4, 5, 0, Vector3(0.011, 0.005, 0.0));
  Mapped mapped(example, 6.0);
  for (Index v = 0; v < static_cast<Index>(mapped.Places.size()); ++v)
  {
    mapped.Places[v] = mapped.Movable.GetFreedom(v) == 2 ? mapped.Places[v] : GridPoint();
  }
  const Index before = mapped.CountWronglySurrounded();
  ASSERT_GT(before, 0);
  Index flat = 0;
  for (Index t = 0; t < static_cast<Index>(example.Mesh.Triangles.size()); ++t)
  {
    flat += mapped.Movable.StaysFlat(t) ? 1 : 0;
  }
  EXPECT_GT(flat, 0);
  UnfoldTriangles(mapped.Movable);
  EXPECT_LE(mapped.CountWronglySurrounded(), before);
  EXPECT_GE(mapped.CountFlipped(), flat);
}

TEST(MapFolds, StopWhenTheyAreTold)
{
  const CutExample example = Polygon(4, 5, 4, Vector3(0.011, 0.005, 0.0));
  Mapped mapped(example, 6.0);
  mapped.Scramble(Vector3::Zero(), 0.25, 0.4, 1);
  int asked = 0;
  const ProgressFunction stop = [&](double) { return ++asked < 3; };
  EXPECT_THROW(UnfoldTriangles(mapped.Movable, Progress(stop)), Stopped);
  EXPECT_EQ(asked, 3);
}

/// Grid points in the wrong order leave folds, or a way around them that is much longer than the
/// surface, which would have as many more faces.
TEST(MapFolds, MapsAreNotStretchedToBeUnfolded)
{
  for (const int levels : { 1, 2 })
  {
    const CutExample example = Polygon(4, 5, levels, Vector3(0.011, 0.005, 0.0));
    for (unsigned seed = 0; seed < 90; ++seed)
    {
      Mapped mapped(example, std::array<double, 3>{ 1.0, 3.0, 10.0 }[seed / 30]);
      std::mt19937 engine(seed % 30);
      const int most = 1 + static_cast<int>(seed % 5) * 3;
      const auto random = [&]() { return static_cast<int>(engine() % (2 * most + 1)) - most; };
      for (Index v = 0; v < static_cast<Index>(mapped.Places.size()); ++v)
      {
        if (mapped.Movable.GetFreedom(v) == 0)
        {
          mapped.Places[v] = mapped.Places[v] +
            GridPoint{ random() * IntegerGrid::Unit, random() * IntegerGrid::Unit };
        }
      }
      double inSpace = 0.0;
      double before = 0.0;
      double after = 0.0;
      const auto triangles = static_cast<Index>(example.Mesh.Triangles.size());
      for (Index t = 0; t < triangles; ++t)
      {
        inSpace += mapped.Movable.AreaInSpace(t);
        before += std::max(0.0, mapped.Movable.AreaInMap(t));
      }
      UnfoldTriangles(mapped.Movable);
      for (Index t = 0; t < triangles; ++t)
      {
        after += std::max(0.0, mapped.Movable.AreaInMap(t));
      }
      // In two rounds by 1.5.
      EXPECT_LT(after, 2.25 * (before + inSpace)) << levels << ", " << seed;
    }
  }
}
