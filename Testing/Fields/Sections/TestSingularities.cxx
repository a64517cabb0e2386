// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Meshes/Surfaces.h"
#include "Meshes/System.h"
#include "Sections/DoubleCover.h"
#include "Sections/Singularities.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

using namespace DirectionFields;
using namespace Meshes;

TEST(Singularities, SumIsDegreeTimesChiForAnyField)
{
  const std::vector<std::pair<Surface, int>> surfaces = { { Tetrahedron(), 2 }, { Octahedron(), 2 },
    { Cube(), 2 }, { Icosphere(1), 2 }, { Potato(2), 2 }, { Torus(5, 4), 0 },
    { DoubleTorus(), -2 } };
  for (const auto& [surface, chi] : surfaces)
  {
    for (int degree = 1; degree <= 16; ++degree)
    {
      const System system(surface, degree, 0.0);
      const auto n = static_cast<std::size_t>(system.Mesh.GetNumberOfVertices());
      std::vector<std::vector<Complex>> fields;
      const ComplexVector random = RandomVector(static_cast<Eigen::Index>(n), degree);
      fields.emplace_back(random.begin(), random.end());
      // Vanishing vectors, and signs only: ties of omega at +-pi.
      fields.emplace_back(n, 0.0);
      fields.emplace_back(n, 1.0);
      fields.emplace_back(n, 1e-300);
      for (std::size_t i = 0; i < n; i += 2)
      {
        fields[2][i] = -1.0;
        fields[3][i] = Complex(0.0, -1e300);
      }
      for (const auto& field : fields)
      {
        int sum = 0;
        for (const int index : SingularityIndices(system, degree, field))
        {
          sum += index;
        }
        EXPECT_EQ(sum, degree * chi) << "degree " << degree;
      }
    }
  }
}

TEST(Singularities, KnownFieldsOnTheDisk)
{
  // u = (z / |z|)^k has one singularity of index k / n, at the center, for any n.
  Surface disk = Disk(6);
  for (Vector3& p : disk.Points)
  {
    p += Vector3(0.02, 0.03, 0.0);
  }
  const System system(disk, 1, 0.0);
  for (const int k : { -2, -1, 0, 1, 2 })
  {
    for (const int degree : { 1, 2, 4, 6 })
    {
      std::vector<Complex> field;
      for (Index v = 0; v < system.Mesh.GetNumberOfVertices(); ++v)
      {
        const Vector3& p = disk.Points[system.Mesh.Point(v)];
        const double frame = std::atan2(system.Frames.X[v].y(), system.Frames.X[v].x());
        field.push_back(std::polar(1.0, k * std::atan2(p.y(), p.x()) - degree * frame));
      }
      int sum = 0;
      int nonZero = 0;
      for (const int index : SingularityIndices(system, degree, field))
      {
        sum += index;
        nonZero += index != 0;
      }
      EXPECT_EQ(sum, k);
      EXPECT_LE(nonZero, std::abs(k));
    }
  }
}

/// The phase of a section over the flat square grows by the same everywhere.
TEST(EnergyDensity, IsTheSquareOfTheGradientOfThePhase)
{
  const SurfaceGeometry flat(Square(20));
  for (const int degree : { 1, 4 })
  {
    std::vector<Complex> field;
    for (Index v = 0; v < flat.Mesh.GetNumberOfVertices(); ++v)
    {
      const Vector3& p = flat.Positions[v];
      const double axis = std::arg(flat.Frames.Tangential(v, Vector3::UnitX()));
      // The length of the section does not matter.
      field.push_back(
        std::polar(1.0 + 0.5 * std::sin(5.0 * p.x()), 0.6 * p.x() - 0.3 * p.y() + degree * axis));
    }
    const double unit = flat.Lengths.Unit[0];
    for (const double density : EnergyDensity(flat, degree, field))
    {
      EXPECT_NEAR(density, 0.45 * unit * unit, 1e-3 * 0.45 * unit * unit);
    }
  }
}

TEST(EnergyDensity, IsOnAScaledSurfaceWhatItIsPerArea)
{
  const Surface surface = Potato(3);
  const Surface larger = Transformed(surface, 4.0 * Eigen::Matrix3d::Identity(), Vector3::Zero());
  Options options;
  const Result here = DirectionField(surface).Compute(options);
  const Result there = DirectionField(larger).Compute(options);
  double largest = 0.0;
  std::size_t place = 0;
  for (std::size_t i = 0; i < surface.Points.size(); ++i)
  {
    EXPECT_NEAR(
      there.EnergyDensity[i] * 16.0, here.EnergyDensity[i], 1e-4 * (1.0 + here.EnergyDensity[i]));
    place = here.EnergyDensity[i] > largest ? i : place;
    largest = std::max(largest, here.EnergyDensity[i]);
  }
  // The largest is at a singularity.
  bool singular = false;
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    const Triangle& triangle = surface.Triangles[t];
    singular = singular ||
      (here.SingularityIndex[t] != 0 &&
        std::count(triangle.begin(), triangle.end(), static_cast<Index>(place)) > 0);
  }
  EXPECT_TRUE(singular);
}

TEST(Singularities, OppositeValuesTurnAlikeOnBothSidesOfACover)
{
  const SurfaceGeometry geometry(MoebiusStrip(12, 3));
  const TriangleMesh& mesh = geometry.Mesh;
  const TriangleMesh::Component& component = mesh.GetComponents()[0];
  ASSERT_TRUE(component.IsCover);
  for (const int degree : { 1, 2 })
  {
    const DoubleCover cover(geometry, component, degree);
    for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
    {
      const Index h = mesh.HalfEdge(e);
      const Index i = mesh.Tail(h);
      const Index j = mesh.Head(h);
      ASSERT_NE(mesh.MirrorVertex(i), j);
      std::vector<Complex> field(mesh.GetNumberOfVertices(), 1.0);
      field[j] = -std::polar(1.0, degree * geometry.Transport.Rotation[e]);
      for (const Index v : { i, j })
      {
        field[mesh.MirrorVertex(v)] = cover.Mirrored(v, field[v]);
      }
      const LargeArray<double> omega = PhaseDifferences(geometry, component, degree, field.data());
      const auto along = [&](Index side)
      { return mesh.GivesDirection(side) ? omega[mesh.Edge(side)] : -omega[mesh.Edge(side)]; };
      EXPECT_NEAR(std::abs(along(h)), Pi, 1e-9);
      EXPECT_NEAR(along(h), along(mesh.Mirror(h)), 1e-9);
    }
  }
}
