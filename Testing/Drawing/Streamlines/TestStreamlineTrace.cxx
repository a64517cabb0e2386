// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Meshes/Fields.h"
#include "Meshes/Surfaces.h"
#include "Streamlines.h"
#include "Streamlines/TracedStreamline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

using namespace DirectionFields;

namespace
{
constexpr double Radius = 1.0;
constexpr double TubeRadius = 0.4;

/// The vector field around the axis of a torus.
PointDirections AroundAxis(const Surface& surface)
{
  PointDirections field;
  field.Degree = 1;
  field.Direction = [&surface](Index point, int)
  {
    const Vector3& p = surface.Points[point];
    return Vector3(-p.y(), p.x(), 0.0).normalized();
  };
  field.Magnitude = [](Index) { return 1.0; };
  return field;
}

double TubeAngle(const Vector3& p)
{
  return std::atan2(p.z(), std::hypot(p.x(), p.y()) - Radius);
}

/// How far around the tube, in degrees, a line has come after once around the axis.
double Drift(int around, int across)
{
  // Turned a little around the tube, so that nothing is symmetric.
  Surface torus = Meshes::Torus(around, across, Radius, TubeRadius);
  for (Vector3& p : torus.Points)
  {
    const double u = std::atan2(p.y(), p.x()) + 0.1 * std::sin(3.0 * TubeAngle(p));
    const double v = TubeAngle(p) + 0.15 * std::sin(2.0 * u + 0.4);
    const double r = Radius + TubeRadius * std::cos(v);
    p = { r * std::cos(u), r * std::sin(u), TubeRadius * std::sin(v) };
  }
  const PointDirections directions = AroundAxis(torus);
  const GivenField field(torus, directions);
  double worst = 0.0;
  for (Index t = 0; t < static_cast<Index>(torus.Triangles.size());
       t += static_cast<Index>(torus.Triangles.size()) / 23)
  {
    StreamlineOptions options;
    options.Seeds = SeedType::Points;
    options.Direction = IntegrationDirection::Forward;
    options.Offset = 0.0;
    options.MaximumLength = 2.5 * Pi * (Radius + TubeRadius);
    const Streamlines lines =
      TraceStreamlines(field, directions, { { t, { 0.3, 0.4, 0.3 } } }, options);
    double turned = 0.0;
    for (std::int64_t p = 1; p < lines.Offsets[1]; ++p)
    {
      const Complex before(lines.Points[p - 1].x(), lines.Points[p - 1].y());
      const Complex now(lines.Points[p].x(), lines.Points[p].y());
      turned += std::arg(now / before);
      if (turned >= 2.0 * Pi)
      {
        const double drift = TubeAngle(lines.Points[p]) - TubeAngle(lines.Points[0]);
        worst = std::max(worst, std::abs(drift - 2.0 * Pi * std::round(drift / (2.0 * Pi))));
        break;
      }
    }
    EXPECT_GE(turned, 2.0 * Pi);
  }
  return worst * 180.0 / Pi;
}

bool IsSound(const Streamlines& lines)
{
  for (const Vector3& p : lines.Points)
  {
    if (!p.allFinite())
    {
      return false;
    }
  }
  for (const Vector3& d : lines.Directions)
  {
    if (!(std::abs(d.norm() - 1.0) < 1e-6))
    {
      return false;
    }
  }
  return true;
}
}

TEST(StreamlineTrace, DriftsByTheSquareOfTheEdges)
{
  const double coarse = Drift(24, 12);
  const double middle = Drift(48, 24);
  const double fine = Drift(96, 48);
  EXPECT_LT(fine, 3.0);
  EXPECT_GT(coarse / middle, 2.8) << coarse << " " << middle << " " << fine;
  EXPECT_GT(middle / fine, 2.8) << coarse << " " << middle << " " << fine;
}

TEST(StreamlineTrace, IsStraightOnThePlane)
{
  const Surface square = Meshes::BadSquare(12, 4);
  const auto angle = [](const Vector3&) { return 0.3; };
  for (const int degree : { 1, 2, 3, 4, 6 })
  {
    const PointDirections directions = Fields::PlanarField(square, degree, angle);
    const GivenField field(square, directions);
    StreamlineOptions options;
    options.Seeds = SeedType::Points;
    options.Offset = 0.0;
    const Streamlines lines =
      TraceStreamlines(field, directions, { { 40, { 0.2, 0.3, 0.5 } } }, options);
    ASSERT_EQ(static_cast<int>(lines.Length.size()), degree % 2 == 0 ? degree / 2 : degree);
    for (std::size_t i = 0; i < lines.Length.size(); ++i)
    {
      const Vector3 begin = lines.Points[lines.Offsets[i]];
      const Vector3 end = lines.Points[lines.Offsets[i + 1] - 1];
      EXPECT_NEAR((end - begin).norm(), lines.Length[i], 1e-8);
      const double turn = std::atan2((end - begin).y(), (end - begin).x()) - 0.3;
      const double step = 2.0 * Pi / degree;
      EXPECT_NEAR(turn, step * std::round(turn / step), 1e-7);
      // From boundary to boundary.
      EXPECT_EQ(lines.Ends[i][0], StreamlineEnd::Boundary);
      EXPECT_EQ(lines.Ends[i][1], StreamlineEnd::Boundary);
      const int branch = lines.Branch[lines.Offsets[i]];
      EXPECT_LT((directions.Direction(0, branch) - (end - begin).normalized()).norm(), 1e-6);
    }
  }
}

TEST(StreamlineTrace, RunsOnlyTheWayThatIsAskedFor)
{
  const Surface square = Meshes::Square(8);
  const auto angle = [](const Vector3&) { return 0.0; };
  const PointDirections directions = Fields::PlanarField(square, 1, angle);
  const GivenField field(square, directions);
  const std::vector<StreamlineSeed> seeds = { { 64, { 0.3, 0.3, 0.4 } } };
  const Triangle& corners = square.Triangles[64];
  const double x = 0.3 * square.Points[corners[0]].x() + 0.3 * square.Points[corners[1]].x() +
    0.4 * square.Points[corners[2]].x();
  const auto run = [&](IntegrationDirection way)
  {
    StreamlineOptions options;
    options.Seeds = SeedType::Points;
    options.Direction = way;
    const Streamlines lines = TraceStreamlines(field, directions, seeds, options);
    return std::pair(lines.Points.front().x(), lines.Points.back().x());
  };
  const auto both = run(IntegrationDirection::Both);
  EXPECT_NEAR(both.first, 0.0, 1e-6);
  EXPECT_NEAR(both.second, 1.0, 1e-6);
  const auto forward = run(IntegrationDirection::Forward);
  EXPECT_NEAR(forward.first, x, 1e-5);
  EXPECT_NEAR(forward.second, 1.0, 1e-6);
  const auto backward = run(IntegrationDirection::Backward);
  EXPECT_NEAR(backward.first, 0.0, 1e-6);
  EXPECT_NEAR(backward.second, x, 1e-5);
}

TEST(StreamlineTrace, StopsAtTheLengthThatIsAskedFor)
{
  const Surface surface = Meshes::Potato(2);
  const Result result = Fields::Compute(surface, 4);
  const PointDirections directions = Fields::Of(result);
  const GivenField field(surface, directions);
  for (const SeedType seeds : { SeedType::EvenlySpaced, SeedType::Singularities, SeedType::Points })
  {
    StreamlineOptions options;
    options.Seeds = seeds;
    options.MaximumLength = 0.7;
    options.MinimumLength = 0.1;
    const Streamlines lines =
      TraceStreamlines(field, directions, { { 3, { 0.2, 0.3, 0.5 } } }, options);
    EXPECT_GT(lines.Length.size(), 0u);
    for (const double length : lines.Length)
    {
      EXPECT_LE(length, 0.75);
      EXPECT_GE(length, 0.1);
    }
    options.MaximumNumber = 1;
    EXPECT_LE(
      TraceStreamlines(field, directions, { { 3, { 0.2, 0.3, 0.5 } } }, options).Length.size(), 1u);
  }
}

TEST(StreamlineTrace, KeepsToTheGreatestNumberWhereLinesStopAtCrossings)
{
  const Surface surface = Meshes::Joined(Meshes::Potato(2),
    Meshes::Transformed(Meshes::Potato(2), Eigen::Matrix3d::Identity(), Vector3(9.0, 0.0, 0.0)));
  const Result result = Fields::Compute(surface, 4);
  const PointDirections directions = Fields::Of(result);
  const GivenField field(surface, directions);
  for (const bool stops : { false, true })
  {
    StreamlineOptions options;
    options.Seeds = SeedType::Singularities;
    options.StopAtCrossings = stops;
    const Streamlines all = TraceStreamlines(field, directions, {}, options);
    EXPECT_GT(all.Length.size(), 20U);
    EXPECT_FALSE(all.IsLimited);
    options.MaximumNumber = 3;
    const Streamlines few = TraceStreamlines(field, directions, {}, options);
    EXPECT_TRUE(few.IsLimited);
    ASSERT_EQ(few.Length.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i)
    {
      EXPECT_EQ(few.Length[i], all.Length[i]);
    }
  }
}

TEST(StreamlineTrace, RefusesMoreLinesThanThereIsMemoryFor)
{
  const auto trace = [](const Surface& surface, double spacing)
  {
    const Result result = Fields::Compute(surface, 4);
    const PointDirections directions = Fields::Of(result);
    const GivenField field(surface, directions);
    StreamlineOptions options;
    options.Spacing = spacing;
    options.MaximumNumber = 1;
    return TraceStreamlines(field, directions, {}, options).Length.size();
  };
  EXPECT_THROW(trace(Meshes::Square(10), 1e-30), std::invalid_argument);
  EXPECT_EQ(trace(Meshes::Square(10), 0.01), 1U);
  // A strip much thinner than its lines are apart.
  const Surface strip = Meshes::Transformed(Meshes::Square(10),
    Eigen::Vector3d(392.0, 1e-7, 1.0).asDiagonal().toDenseMatrix(), Vector3(0.0, 0.0, 0.0));
  EXPECT_THROW(trace(strip, 1e-30), std::invalid_argument);
  EXPECT_EQ(trace(strip, 0.0), 1U);
  EXPECT_EQ(trace(strip, 1.0), 1U);
}

TEST(StreamlineTrace, StraightWalksDoNotWindAroundATubeForEver)
{
  // Around a tube of seven triangles and along one of many.
  const Surface tube = Meshes::Cylinder(7, 1, 1.0);
  const PointDirections directions = AroundAxis(tube);
  const GivenField field(tube, directions);
  const Internal::FlatTriangle flat(field.GetGeometry(), 0);
  const int lower =
    std::abs(tube.Points[tube.Triangles[0][0]].z() - tube.Points[tube.Triangles[0][1]].z()) < 0.5
    ? 0
    : std::abs(tube.Points[tube.Triangles[0][1]].z() - tube.Points[tube.Triangles[0][2]].z()) < 0.5
    ? 1
    : 2;
  const Complex along = flat.Along(lower);
  const Internal::LineStart start{ 0, flat.Place({ 0.3, 0.4, 0.3 }), along, 1 };
  const double round = 7.0 * flat.Length(lower);
  // 14 triangles each time.
  EXPECT_NE(Internal::WalkStraight(field, start, 100.0 * round).Triangle, None);
  EXPECT_EQ(Internal::WalkStraight(field, start, 1000.0 * round).Triangle, None);
}

TEST(StreamlineTrace, TakesWhateverSurfaceComes)
{
  Surface broken = Meshes::Potato(1);
  broken.Points[5].x() = std::numeric_limits<double>::quiet_NaN();
  broken.Triangles[3] = { 1, 1, 2 };
  broken.Triangles[8][0] = 77777;
  Surface fan;
  fan.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0.3, 1, 0 }, { 0.3, -1, 0 }, { 0.3, 0, 1 } };
  fan.Triangles = { { 0, 1, 2 }, { 0, 1, 3 }, { 1, 0, 4 } };
  Surface ghosts = Meshes::Square(6);
  ghosts.Ghost.assign(ghosts.Triangles.size(), 0);
  std::fill(ghosts.Ghost.begin(), ghosts.Ghost.begin() + 20, 1);
  const std::vector<Surface> surfaces = { Surface(), broken, fan, ghosts, Meshes::Tetrahedron(),
    Meshes::Cube(), Meshes::MoebiusStrip(12, 3), Meshes::KleinBottle(10, 6),
    Meshes::ProjectivePlane(1), Meshes::BadSphere(1, 0.7, 3), Meshes::BadSquare(6, 1),
    Meshes::Soup(Meshes::Potato(1)), Meshes::Joined(Meshes::Square(2), Meshes::Icosphere(1)) };
  for (const Surface& surface : surfaces)
  {
    for (const int degree : { 1, 3, 4 })
    {
      PointDirections directions;
      directions.Degree = degree;
      directions.Direction = [&](Index point, int k)
      {
        const double angle = 0.3 * point * point + 2.0 * Pi * k / degree;
        const Vector3 any(std::cos(angle), std::sin(angle), 0.1 * (point % 7));
        return point % 11 == 3 ? Vector3(Vector3::Zero()) : Vector3(any.normalized());
      };
      directions.Magnitude = [](Index point) { return 1.0 + point % 3; };
      const GivenField field(surface, directions);
      for (const SeedType seeds :
        { SeedType::EvenlySpaced, SeedType::Singularities, SeedType::Points })
      {
        StreamlineOptions options;
        options.Seeds = seeds;
        options.StopAtCrossings = degree == 4;
        options.MaximumLength = 3.0;
        std::vector<StreamlineSeed> places;
        for (Index t = 0; t < static_cast<Index>(surface.Triangles.size()); t += 37)
        {
          places.push_back({ t, { 1.0, 0.0, 0.0 } });
        }
        const Streamlines lines = TraceStreamlines(field, directions, places, options);
        EXPECT_TRUE(IsSound(lines));
        for (std::size_t i = 0; i < lines.Length.size(); ++i)
        {
          EXPECT_GE(lines.Offsets[i + 1] - lines.Offsets[i], 2);
          const bool isOfGhost = seeds == SeedType::EvenlySpaced && !surface.Ghost.empty() &&
            lines.Offsets[i + 1] - lines.Offsets[i] < 2;
          EXPECT_FALSE(isOfGhost);
        }
      }
    }
  }
}
