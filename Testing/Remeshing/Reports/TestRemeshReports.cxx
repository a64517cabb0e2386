// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Reports/RemeshReports.h"

#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
#include <string>

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
  try
  {
    Remesh(square).Compute(options);
    FAIL();
  }
  catch (const std::invalid_argument& refused)
  {
    EXPECT_STREQ(refused.what(),
      "An Edge Length of 1e-06 needs about 2.5e+13 faces, more than 100 million. Lengths of "
      "0.0005 and more are not refused, and take about 2 kB a face.");
  }
}
