// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Reports/RemeshReports.h"

#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace DirectionFields;

namespace
{
std::string SummaryOf(const Surface& surface)
{
  RemeshOptions options;
  options.NumberOfFaces = 200;
  return Summary(Remesh(std::make_shared<Surface>(surface)).Compute(options), {});
}

bool Has(const std::string& text, const char* part)
{
  return text.find(part) != std::string::npos;
}

std::string RefusalOf(std::shared_ptr<const Surface> surface, const RemeshOptions& options)
{
  try
  {
    Remesh(std::move(surface)).Compute(options);
  }
  catch (const std::invalid_argument& refused)
  {
    return refused.what();
  }
  return {};
}
}

/// Distances that come of rounding are none: on flat surfaces, oblique, far away, and of points in
/// single precision.
TEST(RemeshReports, RoundingIsNoDistance)
{
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.7, Vector3(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
  for (const double shift : { 0.0, 1e4 })
  {
    for (const double unit : { 1e-6, 1.0, 1e6 })
    {
      Surface square =
        Meshes::Transformed(Meshes::Square(8), unit * turn, unit * shift * Vector3::Ones());
      EXPECT_TRUE(Has(SummaryOf(square), "or more, exactly on the surface"));
      for (Vector3& point : square.Points)
      {
        point = point.cast<float>().cast<double>();
      }
      EXPECT_TRUE(Has(SummaryOf(square), "or more, exactly on the surface"));
    }
  }
}

/// A disk's mesh is on the disk, but not all of the disk is below its chords.
TEST(RemeshReports, EachWayHasItsDistance)
{
  const std::string disk = SummaryOf(Meshes::Disk(40));
  EXPECT_TRUE(Has(disk, "or more, on the surface, which is 0.")) << disk;
  EXPECT_TRUE(Has(disk, "or less from the mesh")) << disk;
  const std::string sphere = SummaryOf(Meshes::Icosphere(4));
  EXPECT_TRUE(Has(sphere, "or less from the surface, which is 0.")) << sphere;
}

/// Lengths that need too many faces are refused, with those that do not: 25 / .0005^2 is 10^8.
TEST(RemeshReports, ImpossibleLengthsNameThePossibleOne)
{
  RemeshOptions options;
  options.UseEdgeLength = true;
  options.EdgeLength = 1e-6;
  const auto square = std::make_shared<Surface>(Meshes::Transformed(
    Meshes::Square(2), 5.0 * Eigen::Matrix3d::Identity(), Vector3(1.0, 2.0, 3.0)));
  EXPECT_EQ(RefusalOf(square, options),
    "An Edge Length of 1e-06 needs about 2.5e+13 faces, more than 100 million. Lengths of "
    "0.0005 and more are not refused, and take about 2 kB a face.");
}

/// Lengths that no edge can have are refused at once, whatever else is asked for, with one that
/// leaves room: a mesh of it takes no warning about lengths.
TEST(RemeshReports, LengthsBeyondTheSurfaceNameOneThatIsPossible)
{
  const Surface two = Meshes::Joined(Meshes::Icosphere(3),
    Meshes::Transformed(
      Meshes::Icosphere(3), 0.999 * Eigen::Matrix3d::Identity(), Vector3(3.0, 0.0, 0.0)));
  const std::vector<Surface> bodies = { Meshes::Icosphere(3), Meshes::Square(8),
    Meshes::FlatlySubdivided(Meshes::Cube(), 3), two, Meshes::Soup(Meshes::Icosphere(2)) };
  for (const Surface& body : bodies)
  {
    const auto surface = std::make_shared<Surface>(body);
    double area = 0.0;
    Eigen::AlignedBox3d box;
    for (const Triangle& t : body.Triangles)
    {
      const Vector3& origin = body.Points[t[0]];
      area += 0.5 * (body.Points[t[1]] - origin).cross(body.Points[t[2]] - origin).norm();
    }
    for (const Vector3& point : body.Points)
    {
      box.extend(point);
    }
    RemeshOptions options;
    options.UseEdgeLength = true;
    for (const bool withRegions : { false, true })
    {
      options.Regions.assign(withRegions ? body.Triangles.size() : 0, 0);
      for (const double length : { 1.1 * box.diagonal().norm(), 10.0, 1e300 })
      {
        options.PureQuads = !options.PureQuads;
        options.EdgeLength = length;
        const std::string words = RefusalOf(surface, options);
        EXPECT_TRUE(Has(words, "is longer than the whole surface")) << words;
        const std::string before = "One of ";
        ASSERT_TRUE(Has(words, before.c_str())) << words;
        const double named = std::stod(words.substr(words.find(before) + before.size()));
        const double parts = &body == &bodies[3] ? 2.0 : 1.0;
        EXPECT_NEAR(area / parts / (named * named), 24.0, 0.5);
        options.EdgeLength = named;
      }
    }
    const RemeshResult mesh = Remesh(surface).Compute(options);
    for (const std::string& note : mesh.Notes)
    {
      EXPECT_FALSE(Has(note, "too small")) << note;
    }
  }
}
