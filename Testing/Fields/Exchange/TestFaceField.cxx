// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Exchange/FaceField.h"
#include "Interpolation/FieldInterpolant.h"
#include "Interpolation/InterpolantZero.h"
#include "Meshes/Fields.h"
#include "Meshes/Surfaces.h"
#include "Sections/Singularities.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
constexpr std::array<double, 3> Middle = { 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0 };

/// How the section turns on the straight way between two places of a triangle.
double TurnAlong(const FieldInterpolant& power, const Complex& from, const Complex& to)
{
  constexpr int steps = 60;
  double turn = 0.0;
  Complex last = power.At(from);
  for (int i = 1; i <= steps; ++i)
  {
    const Complex next = power.At(from + (to - from) * (static_cast<double>(i) / steps));
    turn += std::arg(next * std::conj(last));
    last = next;
  }
  return turn;
}

/// Indices of the vertices if directions on faces match along centroid, middle of the edge, centroid.
std::vector<int> IndicesByTheSection(const GivenField& field)
{
  const SurfaceGeometry& geometry = field.GetGeometry();
  const TriangleMesh& mesh = geometry.Mesh;
  const int n = field.GetDegree();
  std::vector<int> indices(mesh.GetNumberOfVertices(), 0);
  std::vector<Index> fan;
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    mesh.GetFan(v, fan);
    if (mesh.IsBoundary(v))
    {
      continue;
    }
    double sum = 2.0 * Pi * n;
    for (const Index h : fan)
    {
      sum -= n * geometry.Lengths.CornerAngle(mesh, h);
      const Index out = TriangleMesh::Previous(h);
      const Index in = mesh.Twin(out);
      for (const bool isOut : { true, false })
      {
        const Index at = isOut ? out : in;
        const FieldInterpolant power(geometry, n, field.GetSection().data(), at / 3);
        const Complex centroid = power.Flat().Place(Middle);
        const Complex edge =
          0.5 * (power.Flat().Corner(at % 3) + power.Flat().Corner((at % 3 + 1) % 3));
        sum += isOut ? TurnAlong(power, centroid, edge) : TurnAlong(power, edge, centroid);
      }
    }
    indices[v] = static_cast<int>(std::lround(sum / (2.0 * Pi)));
    EXPECT_NEAR(sum / (2.0 * Pi), indices[v], 1e-6);
  }
  return indices;
}

/// The sum of the signs of the zeros in the part of each vertex, where it has the largest weight.
std::vector<int> IndicesByZeros(const GivenField& field)
{
  const TriangleMesh& mesh = field.GetMesh();
  std::vector<int> indices(mesh.GetNumberOfVertices(), 0);
  const std::vector<int> given = field.Indices();
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    if (given[t] == 0)
    {
      continue;
    }
    const FieldInterpolant power(
      field.GetGeometry(), field.GetDegree(), field.GetSection().data(), t);
    const std::array<double, 3> weights = power.Flat().Weights(FindZero(power, given[t]).Place);
    const auto corner = std::max_element(weights.begin(), weights.end()) - weights.begin();
    indices[mesh.Tail(3 * t + static_cast<Index>(corner))] += given[t];
  }
  return indices;
}

int Sum(const std::vector<int>& indices)
{
  return std::accumulate(indices.begin(), indices.end(), 0);
}
}

TEST(FaceField, IndicesOfVerticesAreThoseOfTheZerosInTheirDualCells)
{
  const std::vector<std::pair<Surface, int>> surfaces = { { Potato(3), 2 }, { Potato(2), 2 },
    { Jittered(Torus(24, 12), 0.01, 3), 0 }, { Jittered(DoubleTorus(), 0.02, 5), -2 } };
  for (const auto& [surface, chi] : surfaces)
  {
    for (const int degree : { 1, 2, 4, 6 })
    {
      const Result result = Fields::Compute(surface, degree);
      const GivenField field(surface, Fields::Of(result));
      const std::vector<int> bySection = IndicesByTheSection(field);
      EXPECT_EQ(Sum(bySection), degree * chi);
      const std::vector<int> byZeros = IndicesByZeros(field);
      // On symmetric surfaces zeros may lie on the border of two cells, where rounding decides.
      int different = 0;
      for (std::size_t v = 0; v < byZeros.size(); ++v)
      {
        different += bySection[v] != byZeros[v] ? 1 : 0;
      }
      // Hex fields may have several zeros in one triangle of a coarse saddle; one is known here.
      EXPECT_LE(different, degree == 6 && chi < 0 ? 4 : 0)
        << "degree " << degree << " chi " << chi << " of " << Sum(byZeros);
    }
  }
}

TEST(FaceField, LeastRotationsAddUpToTheEulerCharacteristic)
{
  const std::vector<std::pair<Surface, int>> surfaces = { { Potato(3), 2 }, { Cube(), 2 },
    { Torus(24, 12), 0 }, { DoubleTorus(), -2 }, { Icosahedron(), 2 } };
  for (const auto& [surface, chi] : surfaces)
  {
    for (const int degree : { 1, 2, 3, 4, 6 })
    {
      const Result result = Fields::Compute(surface, degree);
      const GivenField field(surface, Fields::Of(result));
      FaceField faces = AtCentroids(field);
      EXPECT_EQ(Sum(FaceSingularityIndices(field.GetGeometry(), faces)), degree * chi);
      // Whatever the field.
      for (std::size_t t = 0; t < faces.Power.size(); ++t)
      {
        faces.Power[t] =
          t % 3 == 0 ? Complex(0.0) : std::polar(1.0, 2.3 * static_cast<double>(t * t));
      }
      EXPECT_EQ(Sum(FaceSingularityIndices(field.GetGeometry(), faces)), degree * chi);
    }
  }
}

TEST(FaceField, KnownDirectionsInThePlane)
{
  Surface disk = Disk(12);
  for (Vector3& p : disk.Points)
  {
    p += Vector3(0.01, 0.02, 0.0);
  }
  for (const int degree : { 1, 2, 4, 6 })
  {
    for (const int k : { -1, 1 })
    {
      const auto angle = [=](const Vector3& p) { return k * std::atan2(p.y(), p.x()) / degree; };
      const GivenField field(disk, Fields::PlanarField(disk, degree, angle));
      const FaceField faces = AtCentroids(field);
      for (int direction = 0; direction < degree; ++direction)
      {
        const std::vector<Vector3> given = DirectionsInSpace(field, faces, direction);
        const std::vector<Vector3> next = DirectionsInSpace(field, faces, (direction + 1) % degree);
        for (std::size_t t = 0; t < given.size(); ++t)
        {
          EXPECT_NEAR(given[t].norm(), 1.0, 1e-14);
          EXPECT_NEAR(given[t].z(), 0.0, 1e-14);
          EXPECT_NEAR(given[t].cross(next[t]).z(), std::sin(2.0 * Pi / degree), 1e-12);
          const Vector3 middle =
            (disk.Points[disk.Triangles[t][0]] + disk.Points[disk.Triangles[t][1]] +
              disk.Points[disk.Triangles[t][2]]) /
            3.0;
          if (middle.norm() > 0.3)
          {
            const double wrong = degree * (std::atan2(given[t].y(), given[t].x()) - angle(middle));
            EXPECT_LT(std::abs(std::remainder(wrong, 2.0 * Pi)), 0.03);
          }
        }
      }
      EXPECT_EQ(Sum(FaceSingularityIndices(field.GetGeometry(), faces)), k);
    }
  }
}

TEST(FaceField, VectorsGiveTheFaceFieldThatTheyCameFrom)
{
  // Triangles wound against the others, and a surface that cannot be oriented, among them.
  Surface turned = Potato(2);
  for (std::size_t t = 0; t < turned.Triangles.size(); t += 7)
  {
    std::swap(turned.Triangles[t][1], turned.Triangles[t][2]);
  }
  for (const Surface& surface : { Potato(2), turned, MoebiusStrip(30, 3) })
  {
    for (const int degree : { 2, 3, 4 })
    {
      const Result result = Fields::Compute(surface, degree);
      const GivenField field(surface, Fields::Of(result));
      const FaceField faces = AtCentroids(field);
      const FaceField read =
        FromVectors(field.GetGeometry(), degree, DirectionsInSpace(field, faces, 1), 1);
      for (std::size_t t = 0; t < faces.Power.size(); ++t)
      {
        EXPECT_LT(std::abs(read.Power[t] - faces.Power[t]), 1e-12);
      }
    }
  }
}

TEST(FaceField, BackAtTheVerticesItIsNearlyTheField)
{
  const int degree = 4;
  std::vector<double> errors;
  for (const int levels : { 2, 3, 4 })
  {
    // The n-th power of the projection of a constant vector, which is smooth but at two points.
    const Surface surface = Icosphere(levels);
    PointDirections given;
    given.Degree = degree;
    given.Direction = [&](Index point, int)
    {
      const Vector3& p = surface.Points[point];
      return Vector3(
        (Vector3(0.3, 0.4, 1.0) - p.dot(Vector3(0.3, 0.4, 1.0)) * p).stableNormalized());
    };
    given.Magnitude = [](Index) { return 1.0; };
    const GivenField field(surface, given);
    const std::vector<Complex> back = ToVertices(field.GetGeometry(), AtCentroids(field));
    double worst = 0.0;
    for (std::size_t v = 0; v < back.size(); ++v)
    {
      const Vector3& p = field.GetGeometry().Positions[v];
      if (std::abs(p.dot(Vector3(0.3, 0.4, 1.0).normalized())) < 0.7)
      {
        worst =
          std::max(worst, std::abs(std::arg(back[v] * std::conj(field.GetSection()[v]))) / degree);
        EXPECT_GT(std::abs(back[v]), 0.9);
        EXPECT_LE(std::abs(back[v]), 1.0 + 1e-12);
      }
    }
    errors.push_back(worst);
  }
  EXPECT_LT(errors[1], 0.7 * errors[0]);
  EXPECT_LT(errors[2], 0.7 * errors[1]);
  EXPECT_LT(errors[2] * 180.0 / Pi, 0.2);
}
