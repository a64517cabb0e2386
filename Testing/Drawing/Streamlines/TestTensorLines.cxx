// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DirectionField.h"
#include "Meshes/TensorFields.h"
#include "Streamlines.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
/// Lines along both principal directions.
Streamlines LinesAlong(const Surface& surface, const TensorAt& at)
{
  DirectionField solver(surface);
  solver.FollowTensors(AtPoints(surface, at), {});
  Options options;
  options.AlignmentStrength = 1.0;
  const Result field = solver.Compute(options);
  const PointDirections directions = DirectionsOf(field);
  StreamlineOptions spaced;
  spaced.Offset = 0.0;
  return TraceStreamlines(GivenField(surface, directions), directions, {}, spaced);
}

/// The angle in degrees between two lines that cross, from 0 to 90.
double AngleBetween(const Vector3& a, const Vector3& b)
{
  return std::atan2(a.cross(b).norm(), std::abs(a.dot(b))) * 180.0 / Pi;
}

/// The angle to the nearer of a tensor's principal directions in the plane of a line and a normal.
double AngleTo(const Matrix& tensor, const Vector3& along, const Vector3& normal)
{
  const Vector3 across = normal.cross(along).normalized();
  const double a = along.dot(tensor * along);
  const double c = across.dot(tensor * across);
  const double b = along.dot(tensor * across);
  const double turn = 0.5 * std::atan2(2.0 * b, a - c) * 180.0 / Pi;
  return std::abs(std::remainder(turn, 90.0));
}

/// The part of the length that is more than a degree off.
double PartOff(const Streamlines& lines, const TensorAt& at)
{
  double off = 0.0;
  double all = 0.0;
  for (std::size_t line = 0; line + 1 < lines.Offsets.size(); ++line)
  {
    for (std::int64_t i = lines.Offsets[line]; i + 1 < lines.Offsets[line + 1]; ++i)
    {
      const double length = lines.Arc[i + 1] - lines.Arc[i];
      all += length;
      const double angle = AngleTo(at(lines.Points[i]), lines.Directions[i], lines.Normals[i]);
      off += angle > 1.0 ? length : 0.0;
    }
  }
  return off / all;
}

/// The largest difference from a right angle between points of different lines that are nearer to
/// each other than this and not parallel, degrees, and their number.
std::pair<double, int> WorstCrossing(const Streamlines& lines, double near)
{
  using Cell = std::array<int, 3>;
  std::map<Cell, std::vector<std::size_t>> cells;
  const auto cellOf = [&](const Vector3& p)
  {
    return Cell{ static_cast<int>(std::floor(p.x() / near)),
      static_cast<int>(std::floor(p.y() / near)), static_cast<int>(std::floor(p.z() / near)) };
  };
  double worst = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < lines.Points.size(); ++i)
  {
    std::vector<std::size_t>& there = cells[cellOf(lines.Points[i])];
    for (const std::size_t j : there)
    {
      const double angle = AngleBetween(lines.Directions[i], lines.Directions[j]);
      // Lines of one family are farther from each other.
      if ((lines.Points[i] - lines.Points[j]).norm() < near && angle > 45.0)
      {
        worst = std::max(worst, 90.0 - angle);
        ++count;
      }
    }
    there.push_back(i);
  }
  return { worst, count };
}
}

TEST(TensorLines, FollowTheNetOfAPlateWithAHole)
{
  const Surface plate = Plate(240, 60);
  const Streamlines lines = LinesAlong(plate, Kirsch);
  EXPECT_LT(PartOff(lines, Kirsch), 0.05);
  const auto [worst, count] = WorstCrossing(lines, 0.0015);
  EXPECT_GT(count, 100) << worst;
  EXPECT_LT(worst, 2.0);
}

TEST(TensorLines, FollowTheNetOfATorusUnderPressure)
{
  const Surface torus = Torus(160, 80);
  const Streamlines lines = LinesAlong(torus, TorusStress);
  EXPECT_LT(PartOff(lines, TorusStress), 0.05);
  const auto [worst, count] = WorstCrossing(lines, 0.008);
  EXPECT_GT(count, 100);
  EXPECT_LT(worst, 2.0);
}

TEST(TensorLines, CarryValuesOfTheSurfaceByTrianglesAndWeights)
{
  const Surface plate = Plate(80, 20);
  const Streamlines lines = LinesAlong(plate, Kirsch);
  ASSERT_EQ(lines.Weights.size(), lines.Points.size());
  for (std::size_t i = 0; i < lines.Points.size(); ++i)
  {
    const Triangle& corners = plate.Triangles[lines.Triangle[i]];
    Vector3 place = Vector3::Zero();
    for (int c = 0; c < 3; ++c)
    {
      place += lines.Weights[i][c] * plate.Points[corners[c]];
    }
    EXPECT_LT((place - lines.Points[i]).norm(), 1e-9);
  }
}
