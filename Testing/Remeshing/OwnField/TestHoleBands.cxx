// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Meshes/Remeshed.h"
#include "Meshes/Surfaces.h"
#include "OwnField/HoleBands.h"
#include "Quality/FaceQuality.h"
#include "Remesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

namespace
{
constexpr double Radius = 0.2;

Surface Plate()
{
  return Meshes::PlateWithHole(48, 40, Radius, false);
}

/// At each point.
std::vector<Vector3> BandsOf(const Surface& surface, double edgeLength)
{
  const SurfaceGeometry geometry(surface);
  const std::vector<Vector3> atVertices =
    HoleBands(geometry, 4, std::vector<char>(geometry.Mesh.GetNumberOfEdges(), 0), edgeLength);
  std::vector<Vector3> bands(surface.Points.size(), Vector3::Zero());
  for (std::size_t v = 0; v < atVertices.size(); ++v)
  {
    bands[geometry.Mesh.Point(static_cast<Index>(v))] = atVertices[v];
  }
  return bands;
}
}

/// The band around a hole of 48 sides in a plate whose sides are .8 away, for edges of which the
/// radius is 20, 5 and 1: 5 lengths, .7 R and 2 lengths wide, or a third of the way to the sides.
TEST(HoleBands, GoAroundHoles)
{
  const Surface plate = Plate();
  const double inner = Radius * std::cos(Pi / 48);
  for (const auto& [edgeLength, width] :
    { std::pair(0.01, 0.05), std::pair(0.04, 0.14), std::pair(0.2, 0.4) })
  {
    const std::vector<Vector3> bands = BandsOf(plate, edgeLength);
    int inside = 0;
    for (std::size_t v = 0; v < plate.Points.size(); ++v)
    {
      const Vector3& p = plate.Points[v];
      const double r = p.norm();
      const double toSide = 1.0 - p.cwiseAbs().maxCoeff();
      const double most = std::min(width, (r - Radius + toSide) / 3.0);
      if (r < Radius + 1e-9 || r > inner + most + 1e-3)
      {
        EXPECT_TRUE(bands[v].isZero(0.0)) << p.transpose();
      }
      else if (r < Radius + most - 1e-3)
      {
        ++inside;
        EXPECT_NEAR(bands[v].norm(), 1.0, 1e-12)
          << edgeLength << ": " << p.transpose() << ", " << r << ' ' << most;
        // The shortest way to a polygon is off that to the middle by half of the turn at a corner.
        EXPECT_NEAR(std::abs(bands[v].dot(p)) / r, 0.0, std::sin(Pi / 48)) << p.transpose();
        EXPECT_NEAR(bands[v].z(), 0.0, 1e-12);
      }
    }
    EXPECT_GT(inside, 48) << edgeLength;
  }
}

/// A plate that is bent to a bowl has none, nor has one whose hole is at the bottom of a chamfer, nor
/// a disk, which is inside of its rim, nor a square hole.
TEST(HoleBands, AreOnlyAroundRoundHolesInPlanes)
{
  const auto isZero = [](const Vector3& v) { return v.isZero(0.0); };
  Surface bowl = Plate();
  for (Vector3& p : bowl.Points)
  {
    p.z() = 2.0 * p.squaredNorm();
  }
  Surface chamfered = Plate();
  for (Vector3& p : chamfered.Points)
  {
    p.z() = 0.5 * std::min(0.0, p.norm() - 0.3);
  }
  for (const Surface& surface : { bowl, chamfered, Meshes::Disk(12), Meshes::Square(8) })
  {
    const std::vector<Vector3> bands = BandsOf(surface, 0.1);
    EXPECT_TRUE(std::all_of(bands.begin(), bands.end(), isZero));
  }
  Surface pierced = Meshes::Square(12);
  const auto isInside = [&](const Triangle& t)
  {
    const Vector3 middle =
      (pierced.Points[t[0]] + pierced.Points[t[1]] + pierced.Points[t[2]]) / 3.0;
    return std::max(std::abs(middle.x() - 0.5), std::abs(middle.y() - 0.5)) < 0.25;
  };
  const std::size_t before = pierced.Triangles.size();
  pierced.Triangles.erase(
    std::remove_if(pierced.Triangles.begin(), pierced.Triangles.end(), isInside),
    pierced.Triangles.end());
  ASSERT_LT(pierced.Triangles.size(), before);
  const std::vector<Vector3> bands = BandsOf(pierced, 0.05);
  EXPECT_TRUE(std::all_of(bands.begin(), bands.end(), isZero));
}

TEST(HoleBands, TurnWithTheSurface)
{
  const Surface plate = Plate();
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(1.1, Vector3(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  const std::vector<Vector3> bands = BandsOf(plate, 0.04);
  const std::vector<Vector3> turned =
    BandsOf(Meshes::Transformed(plate, 3.0 * turn, Vector3(1.0, 0.0, 2.0)), 0.12);
  for (std::size_t v = 0; v < bands.size(); ++v)
  {
    EXPECT_LT((turn * bands[v] - turned[v]).norm(), 1e-9)
      << plate.Points[v].transpose() << ": " << bands[v].transpose() << ", "
      << turned[v].transpose();
  }
}

/// Around its hub rows of quads have to begin, all of them between the singularities at six holes.
/// Four quarters of a singularity are at each end of each hole.
TEST(HoleBands, MeshesOfAFlangeHaveRoundHoles)
{
  for (const int fine : { 5, 6 })
  {
    Remesh remesh(std::make_shared<Surface>(Meshes::Flange(fine)));
    for (const Index faces : { 2500, 5000 })
    {
      RemeshOptions options;
      options.NumberOfFaces = faces;
      const RemeshResult mesh = remesh.Compute(options);
      EXPECT_EQ(mesh.EulerCharacteristicAfter, -12);
      EXPECT_LE(mesh.Triangles, 4) << fine << ", " << faces;
      EXPECT_LE(mesh.IrregularVertices, 52) << fine << ", " << faces;
      EXPECT_EQ(mesh.TurnedFaces, 0) << fine << ", " << faces;
      const std::vector<double> quality = QualityOf(mesh.Points, mesh.Faces).ScaledJacobian;
      EXPECT_GT(*std::min_element(quality.begin(), quality.end()), 0.4) << fine << ", " << faces;
      EXPECT_LT(std::max(mesh.MaximumDistance, mesh.MaximumDistanceToMesh), 0.2 * mesh.EdgeLength)
        << fine << ", " << faces;
    }
  }
}
