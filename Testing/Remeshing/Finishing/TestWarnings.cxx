// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Surfaces whose meshes fall short somewhere. Each shortcoming is measured here, from the points
// and faces alone; the user has to be told of it, and what the sentence advises has to help.

#include "Finishing/FaceSources.h"
#include "Meshes/Remeshed.h"
#include "Meshes/Surfaces.h"
#include "Remesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

namespace
{
using Rim = std::vector<Vector3>;

Rim RimOf(int count, const std::function<double(int)>& radius)
{
  Rim rim;
  for (int k = 0; k < count; ++k)
  {
    const double angle = 2.0 * Pi * k / count;
    rim.emplace_back(radius(k) * std::cos(angle), radius(k) * std::sin(angle), 0.0);
  }
  return rim;
}

Vector3 MiddleOf(const Rim& rim)
{
  Vector3 sum = Vector3::Zero();
  for (const Vector3& point : rim)
  {
    sum += point;
  }
  return sum / static_cast<double>(rim.size());
}

/// Triangles from each edge of a rim to a point above its middle.
Surface Fan(const Rim& rim, double height = 0.0)
{
  Surface fan;
  fan.Points = rim;
  const auto count = static_cast<Index>(rim.size());
  fan.Points.push_back(MiddleOf(rim) + height * Vector3::UnitZ());
  for (Index k = 0; k < count; ++k)
  {
    fan.Triangles.push_back({ k, (k + 1) % count, count });
  }
  return fan;
}

/// A solid between two such fans.
Surface Solid(const Rim& rim, double height)
{
  Surface solid;
  const auto count = static_cast<Index>(rim.size());
  for (const double z : { 0.0, height })
  {
    for (const Vector3& point : rim)
    {
      solid.Points.push_back(point + z * Vector3::UnitZ());
    }
  }
  for (const double z : { 0.0, height })
  {
    solid.Points.push_back(MiddleOf(rim) + z * Vector3::UnitZ());
  }
  for (Index k = 0; k < count; ++k)
  {
    const Index next = (k + 1) % count;
    solid.Triangles.push_back({ next, k, 2 * count });
    solid.Triangles.push_back({ count + k, count + next, 2 * count + 1 });
    solid.Triangles.push_back({ k, next, count + next });
    solid.Triangles.push_back({ k, count + next, count + k });
  }
  return solid;
}

Surface Star(int points, double inner)
{
  return Fan(RimOf(2 * points, [&](int k) { return k % 2 == 0 ? 1.0 : inner; }));
}

/// Its teeth are as wide as the gaps between.
Surface Gear(int teeth)
{
  return Solid(RimOf(4 * teeth, [](int k) { return k % 4 == 0 || k % 4 == 3 ? 0.9 : 1.0; }), 0.2);
}

/// 200 times as long as it is wide, of eight triangles.
Surface Strip()
{
  Surface strip;
  for (Index k = 0; k <= 4; ++k)
  {
    strip.Points.emplace_back(25.0 * k, 0.0, 0.0);
    strip.Points.emplace_back(25.0 * k, 0.5, 0.0);
    if (k > 0)
    {
      strip.Triangles.push_back({ 2 * k - 2, 2 * k, 2 * k + 1 });
      strip.Triangles.push_back({ 2 * k - 2, 2 * k + 1, 2 * k - 1 });
    }
  }
  return strip;
}

/// A square with a slit from the middle of a side.
Surface Slit()
{
  Surface slit;
  slit.Points = { { 0.0, 0.0, 0.0 }, { 0.5, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 1.0, 1.0, 0.0 },
    { 0.501, 1.0, 0.0 }, { 0.5, 0.3, 0.0 }, { 0.499, 1.0, 0.0 }, { 0.0, 1.0, 0.0 },
    { 0.0, 0.3, 0.0 }, { 1.0, 0.3, 0.0 } };
  slit.Triangles = { { 0, 1, 8 }, { 1, 5, 8 }, { 1, 9, 5 }, { 1, 2, 9 }, { 8, 5, 6 }, { 8, 6, 7 },
    { 5, 9, 4 }, { 9, 3, 4 } };
  return slit;
}

/// A plate with a spike in its middle.
Surface Spike()
{
  Surface plate = Meshes::Square(20, 2.0);
  for (Vector3& p : plate.Points)
  {
    p[2] = 2.0 * std::exp(-(std::pow(p[0] - 1.0, 2.0) + std::pow(p[1] - 1.0, 2.0)) / 0.0225);
  }
  return plate;
}

Surface BallBesideALargeOne(double radius)
{
  return Meshes::Joined(Meshes::Icosphere(3),
    Meshes::Transformed(
      Meshes::Icosphere(2), radius * Eigen::Matrix3d::Identity(), Vector3(2.0, 0.0, 0.0)));
}

/// Faces of a mesh, or triangles of a surface.
using Cells = std::vector<std::array<Index, 4>>;

Cells CellsOf(const Surface& surface)
{
  Cells cells;
  for (const Triangle& t : surface.Triangles)
  {
    cells.push_back({ t[0], t[1], t[2], None });
  }
  return cells;
}

/// The ends of the edges of one face only, each as a triangle without area.
Cells BoundaryOf(const Cells& cells)
{
  std::map<std::array<Index, 2>, int> times;
  for (const auto& cell : cells)
  {
    const int size = cell[3] == None ? 3 : 4;
    for (int c = 0; c < size; ++c)
    {
      ++times[{ std::min(cell[c], cell[(c + 1) % size]), std::max(cell[c], cell[(c + 1) % size]) }];
    }
  }
  Cells boundary;
  for (const auto& [ends, count] : times)
  {
    if (count == 1)
    {
      boundary.push_back({ ends[0], ends[1], ends[1], None });
    }
  }
  return boundary;
}

/// The largest distance of places in some cells, as close as a third of a length, from others.
double Farthest(const std::vector<Vector3>& points, const Cells& cells,
  const std::vector<Vector3>& otherPoints, const Cells& others, double length)
{
  std::vector<Vector3> places;
  for (const auto& cell : cells)
  {
    const int last = cell[3] == None ? 2 : 3;
    const Vector3& a = points[cell[0]];
    const Vector3 u = points[cell[1]] - a;
    const Vector3 v = points[cell[last]] - a;
    const Vector3 beyond = points[cell[2]] - a - u - v;
    const int parts =
      std::min(60, 2 + static_cast<int>(3.0 * std::max(u.norm(), v.norm()) / length));
    for (int i = 0; i <= parts; ++i)
    {
      for (int j = 0; j <= (last == 2 ? parts - i : parts); ++j)
      {
        const double x = static_cast<double>(i) / parts;
        const double y = static_cast<double>(j) / parts;
        places.emplace_back(a + x * u + y * v + (last == 3 ? x * y : 0.0) * beyond);
      }
    }
  }
  return others.empty() ? 0.0 : LargestDistance(places, otherPoints, others);
}

/// How often it happens that the user should be told, as numbers that have to fall.
struct Shortcomings
{
  Shortcomings(const Surface& surface, const RemeshResult& mesh)
    : Triangles(static_cast<double>(mesh.Triangles) / static_cast<double>(mesh.Faces.size()))
    , LeastQuality(Meshes::LeastQuality(mesh))
  {
    const Cells cells = CellsOf(surface);
    Vector3 low = surface.Points.front();
    Vector3 high = low;
    for (const Vector3& point : surface.Points)
    {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
    const double step = mesh.EdgeLength;
    this->Distance = std::max(Farthest(surface.Points, cells, mesh.Points, mesh.Faces, step),
      Farthest(mesh.Points, mesh.Faces, surface.Points, cells, step));
    const Cells ofSurface = BoundaryOf(cells);
    const Cells ofMesh = BoundaryOf(mesh.Faces);
    this->OfBoundary = std::max(Farthest(surface.Points, ofSurface, mesh.Points, ofMesh, step),
      Farthest(mesh.Points, ofMesh, surface.Points, ofSurface, step));
    this->MostDistance = std::max(0.02 * (high - low).norm(), step / 3.0);
  }

  double Triangles;
  double LeastQuality;
  double Distance = 0.0;
  double OfBoundary = 0.0;
  double MostDistance = 0.0;
};

std::string NoteWith(const RemeshResult& mesh, const std::string& words)
{
  const auto note = std::find_if(mesh.Notes.begin(), mesh.Notes.end(),
    [&](const std::string& text) { return text.find(words) != std::string::npos; });
  return note == mesh.Notes.end() ? std::string() : *note;
}

double NumberAfter(const std::string& note, const std::string& words)
{
  const std::size_t at = note.find(words);
  return at == std::string::npos ? 0.0 : std::stod(note.substr(at + words.size()));
}

RemeshResult Remeshed(const Surface& surface, const RemeshOptions& options)
{
  return Remesh(std::make_shared<Surface>(surface)).Compute(options);
}

RemeshOptions Of(Index faces)
{
  RemeshOptions options;
  options.NumberOfFaces = faces;
  return options;
}

/// With the length of edges that a sentence names.
RemeshOptions WithLengthOf(const std::string& note)
{
  RemeshOptions options;
  options.UseEdgeLength = true;
  options.EdgeLength = NumberAfter(note, "An edge length of ");
  return options;
}

/// What the user has to be told.
void ExpectSaid(const Surface& surface, const RemeshResult& mesh, Index faces)
{
  const Shortcomings off(surface, mesh);
  EXPECT_TRUE(
    mesh.Triangles <= 4 || off.Triangles <= 0.01 || !NoteWith(mesh, "triangles.").empty());
  EXPECT_TRUE(off.LeastQuality >= 0.1 || !NoteWith(mesh, "scaled Jacobian").empty());
  // Places between those that the filter looks at may be a little farther.
  const double most = 1.15 * off.MostDistance;
  EXPECT_TRUE(
    std::max(off.Distance, off.OfBoundary) <= most || !NoteWith(mesh, "away from").empty())
    << off.Distance << " " << off.OfBoundary << " of " << most;
  const double ratio = static_cast<double>(mesh.Faces.size()) / static_cast<double>(faces);
  EXPECT_TRUE((ratio < 1.3 && ratio > 1.0 / 1.3) || !NoteWith(mesh, "in place of").empty());
  EXPECT_TRUE(mesh.EulerCharacteristicAfter == mesh.EulerCharacteristicBefore ||
    !NoteWith(mesh, "Euler characteristic").empty());
}
}

TEST(Warnings, NoShortcomingIsSilent)
{
  struct Case
  {
    const char* Name;
    Surface Given;
  };
  for (const Case& one : { Case{ "strip", Strip() },
         { "wedge", Fan({ { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 1.0, 0.035, 0.0 } }) },
         { "star", Star(12, 0.3) }, { "rod", Solid(RimOf(12, [](int) { return 0.01; }), 2.0) },
         { "disk", Solid(RimOf(100, [](int) { return 1.0; }), 0.02) }, { "gear", Gear(20) },
         { "cone", Fan(RimOf(60, [](int) { return 1.0; }), 2.0) }, { "spike", Spike() },
         { "slit", Slit() }, { "limbs", Meshes::BallWithLimbs() },
         { "one-sided", Meshes::MoebiusStrip(40, 4) }, { "cross-cap", Meshes::ProjectivePlane(3) },
         { "bottle", Meshes::KleinBottle(40, 16) }, { "balls", BallBesideALargeOne(0.03) } })
  {
    for (const Index faces : { 10, 300 })
    {
      SCOPED_TRACE(std::string(one.Name) + " " + std::to_string(faces));
      ExpectSaid(one.Given, Remeshed(one.Given, Of(faces)), faces);
    }
  }
}

TEST(Warnings, PureQuadsOrShorterEdgesHaveFewerTriangles)
{
  for (const Surface& surface : { Strip(), Star(12, 0.3) })
  {
    ASSERT_NE(NoteWith(Remeshed(surface, Of(10)), "Pure Quads"), "");
    RemeshOptions pure = Of(10);
    pure.PureQuads = true;
    EXPECT_EQ(Remeshed(surface, pure).Triangles, 0);
  }
  // Teeth of less than half an edge.
  const Surface gear = Gear(20);
  const RemeshResult mesh = Remeshed(gear, Of(300));
  ASSERT_NE(NoteWith(mesh, "shorter edges leave fewer"), "");
  RemeshOptions shorter;
  shorter.UseEdgeLength = true;
  shorter.EdgeLength = 0.5 * mesh.EdgeLength;
  const RemeshResult fine = Remeshed(gear, shorter);
  EXPECT_EQ(NoteWith(fine, "are triangles"), "");
  // With Pure Quads that is no advice.
  RemeshOptions pure = Of(300);
  pure.PureQuads = true;
  EXPECT_EQ(NoteWith(Remeshed(gear, pure), "Pure Quads would"), "");
}

TEST(Warnings, OtherNumbersOfFacesHaveNoneOfNoUse)
{
  const Surface strip = Strip();
  ASSERT_NE(NoteWith(Remeshed(strip, Of(10)), "A tenth fewer or more faces"), "");
  EXPECT_GE(std::max(Meshes::LeastQuality(Remeshed(strip, Of(9))),
              Meshes::LeastQuality(Remeshed(strip, Of(11)))),
    0.1);
}

TEST(Warnings, LengthsOfEdgesThatAreNamedComeCloser)
{
  struct Case
  {
    Surface Given;
    Index Faces;
    // With features tips are kept.
    bool KeepsFeatures;
  };
  for (const Case& one : { Case{ Fan(RimOf(60, [](int) { return 1.0; }), 2.0), 300, false },
         Case{ Spike(), 150, true }, Case{ Slit(), 300, true }, Case{ Star(12, 0.3), 10, true },
         Case{ Solid(RimOf(12, [](int) { return 0.01; }), 2.0), 10, true } })
  {
    const Surface& surface = one.Given;
    const auto made = [&](RemeshOptions options)
    {
      options.KeepFeatures = one.KeepsFeatures;
      return Remeshed(surface, options);
    };
    const RemeshResult mesh = made(Of(one.Faces));
    const std::string note = NoteWith(mesh, "away from");
    ASSERT_NE(note, "") << surface.Points.size();
    const RemeshResult fine = made(WithLengthOf(note));
    const Shortcomings before(surface, mesh);
    const Shortcomings after(surface, fine);
    EXPECT_LT(std::max(after.Distance, after.OfBoundary),
      0.8 * std::max(before.Distance, before.OfBoundary))
      << note;
  }
}

TEST(Warnings, BoundariesAreMeasuredFromEachOther)
{
  // All of the square is close to the mesh, but not the slit.
  const Surface slit = Slit();
  const RemeshResult mesh = Remeshed(slit, Of(300));
  EXPECT_LT(std::max(mesh.MaximumDistance, mesh.MaximumDistanceToMesh), 1e-3);
  const Shortcomings off(slit, mesh);
  EXPECT_GT(off.OfBoundary, off.MostDistance);
  EXPECT_NEAR(mesh.MaximumBoundaryDistance, off.OfBoundary, 0.1 * off.OfBoundary);
  EXPECT_NE(NoteWith(mesh, "slits and notches"), "");
  EXPECT_EQ(NoteWith(Remeshed(slit, WithLengthOf(NoteWith(mesh, "slits"))), "slits"), "");
  EXPECT_EQ(Remeshed(Meshes::Icosphere(2), Of(100)).MaximumBoundaryDistance, 0.0);
}

/// Together: of one surface not each number can be met.
TEST(Warnings, NumbersOfFacesThatAreNamedComeCloser)
{
  double before = 0.0;
  double after = 0.0;
  for (const auto& [surface, faces] :
    { std::pair(Star(12, 0.3), Index(10)), std::pair(Star(12, 0.5), Index(20)),
      std::pair(Star(16, 0.5), Index(20)), std::pair(Star(24, 0.5), Index(30)) })
  {
    const RemeshResult mesh = Remeshed(surface, Of(faces));
    const std::string note = NoteWith(mesh, "in place of");
    ASSERT_NE(note, "") << mesh.Faces.size() << " of " << faces;
    const RemeshResult other =
      Remeshed(surface, Of(static_cast<Index>(NumberAfter(note, "A Number Of Faces of "))));
    const auto off = [wanted = faces](const RemeshResult& made)
    { return std::abs(std::log(static_cast<double>(made.Faces.size()) / wanted)); };
    before += off(mesh);
    after += off(other);
  }
  EXPECT_LT(after, 0.9 * before);
}

TEST(Warnings, FeaturesThatNeedMoreFacesThanWantedAreNamed)
{
  const Surface gear = Gear(20);
  RemeshOptions options = Of(100);
  const RemeshResult mesh = Remeshed(gear, options);
  ASSERT_NE(NoteWith(mesh, "Keep Features off would come closer"), "") << mesh.Faces.size();
  options.KeepFeatures = false;
  const RemeshResult without = Remeshed(gear, options);
  EXPECT_LT(without.Faces.size(), mesh.Faces.size());
  EXPECT_EQ(NoteWith(without, "Keep Features"), "");
}

TEST(Warnings, SizesAreReachedByTheIrregularVerticesThatAreAdvised)
{
  const Surface square = Meshes::Square(30);
  RemeshOptions options = Of(1000);
  options.AddIrregularPairs = false;
  for (const Vector3& p : square.Points)
  {
    options.Sizing.push_back(p[0] < 0.1 ? 1.0 : 8.0);
  }
  const RemeshResult mesh = Remeshed(square, options);
  ASSERT_NE(NoteWith(mesh, "Add Irregular Pairs would help"), "");
  options.AddIrregularPairs = true;
  const RemeshResult sized = Remeshed(square, options);
  EXPECT_GT(sized.EdgesAsWanted, 1.2 * mesh.EdgesAsWanted);
  EXPECT_EQ(NoteWith(sized, "Add Irregular Pairs"), "");
}

TEST(Warnings, SmallComponentsGetFacesOfTheLengthThatIsNamed)
{
  const Surface balls = BallBesideALargeOne(0.1);
  const std::string note = NoteWith(Remeshed(balls, Of(300)), "too small");
  ASSERT_EQ(note.rfind("1 component is too small", 0), 0U);
  EXPECT_EQ(NoteWith(Remeshed(balls, WithLengthOf(note)), "too small"), "");
  // Their triangles are no vertices of a grid, which is not told once more.
  EXPECT_EQ(NoteWith(Remeshed(BallBesideALargeOne(0.004), Of(300)), "points of a grid"), "");
}
