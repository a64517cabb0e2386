// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Meshes/Fields.h"
#include "Meshes/Surfaces.h"
#include "Streamlines.h"
#include "Streamlines/SingularPoints.h"
#include "Streamlines/TracedStreamline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace DirectionFields;

namespace
{
/// The field of u = z - a, or its conjugate, on the plane.
PointDirections PlanarZero(const Surface& surface, int degree, const Complex& a, bool isConjugate)
{
  const auto vector = [&surface, a, isConjugate](Index point)
  {
    const Complex z = Complex(surface.Points[point].x(), surface.Points[point].y()) - a;
    return isConjugate ? std::conj(z) : z;
  };
  PointDirections field;
  field.Degree = degree;
  field.Direction = [vector, degree](Index point, int k)
  {
    const double angle = (std::arg(vector(point)) + 2.0 * Pi * k) / degree;
    return Vector3(std::cos(angle), std::sin(angle), 0.0);
  };
  field.Magnitude = [vector](Index point) { return std::abs(vector(point)); };
  return field;
}

/// Closed surfaces of different kinds: round, bumpy and bent at edges.
std::vector<Surface> ClosedSurfaces()
{
  const Eigen::Matrix3d stretch = Eigen::Vector3d(1.5, 1.0, 0.7).asDiagonal();
  return { Meshes::Transformed(Meshes::Icosphere(3), stretch, Vector3::Zero()), Meshes::Potato(3),
    Meshes::Roughened(Meshes::Potato(3), 0.15, 4), Meshes::ChamferedCube(6), Meshes::DoubleTorus(),
    Meshes::Jittered(Meshes::Torus(24, 12), 0.05, 3) };
}
}

TEST(Separatrices, OfLinearFieldsOnThePlaneAreStraight)
{
  const Complex center(0.0317, 0.0213);
  for (const unsigned seed : { 1u, 2u })
  {
    Surface disk = Meshes::Jittered(Meshes::Disk(12), 0.025, seed);
    for (Vector3& point : disk.Points)
    {
      point.z() = 0.0;
    }
    for (int degree = 1; degree <= 6; ++degree)
    {
      for (const bool isConjugate : { false, true })
      {
        const PointDirections directions = PlanarZero(disk, degree, center, isConjugate);
        const GivenField field(disk, directions);
        StreamlineOptions options;
        options.Seeds = SeedType::Singularities;
        options.Offset = 0.0;
        const Streamlines lines = TraceStreamlines(field, directions, {}, options);
        const int index = isConjugate ? -1 : 1;
        const int count = (degree - index) * (degree % 2 == 1 ? 2 : 1);
        ASSERT_EQ(static_cast<int>(lines.Length.size()), count) << degree;
        for (std::size_t i = 0; i < lines.Length.size(); ++i)
        {
          // Rays stand at equal angles; the odd ones of odd degrees point inwards.
          const Vector3 begin = lines.Points[lines.Offsets[i]];
          const Vector3 end = lines.Points[lines.Offsets[i + 1] - 1];
          EXPECT_LT((begin - Vector3(center.real(), center.imag(), 0.0)).norm(), 1e-9);
          const double angle = std::atan2(end.y() - begin.y(), end.x() - begin.x());
          const double step = 2.0 * Pi / count;
          const double off = angle - step * std::round(angle / step);
          EXPECT_LT(std::abs(off) * 180.0 / Pi, 1e-3) << degree << " " << isConjugate;
          for (std::int64_t p = lines.Offsets[i] + 1; p + 1 < lines.Offsets[i + 1]; ++p)
          {
            const Vector3 offset = lines.Points[p] - begin;
            EXPECT_LT(offset.cross((end - begin).normalized()).norm(), 2e-5 * offset.norm() + 1e-9);
          }
          EXPECT_EQ(lines.Ends[i][1], StreamlineEnd::Boundary);
          EXPECT_EQ(lines.Nodes[lines.EndNodes[i][1]].Type, StreamlineNodeType::Boundary);
        }
      }
    }
  }
}

TEST(Separatrices, AreAsManyAsTheIndicesSay)
{
  for (const Surface& surface : ClosedSurfaces())
  {
    for (const int degree : { 1, 2, 3, 4, 6 })
    {
      const Result result = Fields::Compute(surface, degree);
      const PointDirections directions = Fields::Of(result);
      const GivenField field(surface, directions);
      StreamlineOptions options;
      options.Seeds = SeedType::Singularities;
      options.MaximumLength = 0.5 * std::sqrt(surface.Triangles.size());
      const Streamlines lines = TraceStreamlines(field, directions, {}, options);
      std::vector<int> count(lines.Nodes.size(), 0);
      for (std::size_t i = 0; i < lines.Length.size(); ++i)
      {
        EXPECT_EQ(lines.Ends[i][0], StreamlineEnd::Singularity);
        EXPECT_NE(lines.Ends[i][1], StreamlineEnd::Boundary) << "a line has left a closed surface";
        EXPECT_NE(lines.Ends[i][1], StreamlineEnd::Stuck);
        EXPECT_EQ(lines.EndNodes[i][0], lines.Seed[i]);
        ++count[lines.EndNodes[i][0]];
      }
      int sum = 0;
      for (std::size_t k = 0; k < lines.Nodes.size(); ++k)
      {
        if (lines.Nodes[k].Type == StreamlineNodeType::Singularity)
        {
          sum += lines.Nodes[k].SingularityIndex;
          EXPECT_EQ(count[k],
            std::abs(degree - lines.Nodes[k].SingularityIndex) * (degree % 2 == 1 ? 2 : 1));
        }
      }
      const auto sumOfIndices = [&]
      {
        int total = 0;
        for (const int index : result.SingularityIndex)
        {
          total += index;
        }
        return total;
      };
      EXPECT_EQ(sum, sumOfIndices());
    }
  }
}

TEST(Separatrices, LeaveAlongTheField)
{
  const Surface surface = Meshes::Roughened(Meshes::Potato(3), 0.2, 1);
  for (const int degree : { 1, 2, 3, 4, 6 })
  {
    const Result result = Fields::Compute(surface, degree);
    const PointDirections directions = Fields::Of(result);
    const GivenField field(surface, directions);
    const SingularPoints zeros(field);
    for (Index i = 0; i < static_cast<Index>(zeros.GetZeros().size()); ++i)
    {
      const SingularPoint& zero = zeros.GetZeros()[i];
      const FieldInterpolant power(
        field.GetGeometry(), degree, field.GetSection().data(), zero.Triangle);
      for (const ZeroRay& ray : zeros.Rays(i))
      {
        const Complex outward = std::polar(1.0, ray.Angle);
        const Complex value = power.At(zero.Place + ray.Radius * outward);
        const Complex wanted =
          IntegerPower(outward, degree) * ((degree % 2 == 1 && ray.Sense < 0) ? -1.0 : 1.0);
        EXPECT_LT(std::abs(value / std::abs(value) - wanted), 1e-6);
      }
    }
  }
}
