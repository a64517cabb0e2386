// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Meshes/DenseAlgebra.h"
#include "Meshes/LocalMatrices.h"
#include "Meshes/Surfaces.h"
#include "Meshes/System.h"
#include "Sections/SectionIntegrals.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
Eigen::VectorXd SystemEigenvalues(const Operators& o)
{
  return DenseEigenpairs(Eigen::MatrixXcd(o.Energy), Eigen::MatrixXcd(o.Mass)).Values;
}
}

TEST(Operators, AreHermitianWithOnePattern)
{
  const System system(Potato(2), 3, 0.4);
  const SparseMatrix& a = system.Matrices.Energy;
  const SparseMatrix& m = system.Matrices.Mass;
  EXPECT_EQ((a - SparseMatrix(a.adjoint())).norm(), 0.0);
  EXPECT_EQ((m - SparseMatrix(m.adjoint())).norm(), 0.0);
  EXPECT_EQ(a.nonZeros(), system.Mesh.GetNumberOfVertices() + 2 * system.Mesh.GetNumberOfEdges());
  EXPECT_EQ(m.nonZeros(), a.nonZeros());
  for (Eigen::Index column = 0; column < a.cols(); ++column)
  {
    for (Index k = a.outerIndexPtr()[column] + 1; k < a.outerIndexPtr()[column + 1]; ++k)
    {
      EXPECT_LT(a.innerIndexPtr()[k - 1], a.innerIndexPtr()[k]);
    }
  }
}

TEST(Operators, FlatSurfaceHasCotangentWeightsAndTheLinearMassMatrix)
{
  Surface flat = Jittered(Square(5), 0.05, 8);
  for (Vector3& p : flat.Points)
  {
    p.z() = 0.0;
  }
  const System s(flat, 4, 0.0);
  for (Index e = 0; e < s.Mesh.GetNumberOfEdges(); ++e)
  {
    const Index h = s.Mesh.HalfEdge(e);
    double cotangents = 0.0;
    double area = 0.0;
    for (const Index side : { h, s.Mesh.Twin(h) })
    {
      if (side != None)
      {
        cotangents += 1.0 / std::tan(s.Lengths.CornerAngle(s.Mesh, TriangleMesh::Previous(side)));
        area += s.Lengths.Area[side / 3];
      }
    }
    const Complex back = std::polar(1.0, 4.0 * s.Transport.Rotation[e]);
    const Complex a = s.Matrices.Energy.coeff(s.Mesh.Tail(h), s.Mesh.Head(h)) * back;
    const Complex m = s.Matrices.Mass.coeff(s.Mesh.Tail(h), s.Mesh.Head(h)) * back;
    EXPECT_NEAR(a.real(), -0.5 * cotangents, 1e-11);
    EXPECT_NEAR(a.imag(), 0.0, 1e-11);
    EXPECT_NEAR(m.real(), area / 12.0, 1e-11);
    EXPECT_NEAR(m.imag(), 0.0, 1e-11);
  }
}

TEST(Operators, MatricesAreHermitianToTheBit)
{
  Surface sheet = Jittered(Potato(3), 0.03, 2);
  sheet.Triangles.push_back({ 0, sheet.Triangles[0][1], 600 });
  const System system(sheet, 3, 0.4);
  for (const SparseMatrix& matrix : { system.Matrices.Energy, system.Matrices.Mass })
  {
    EXPECT_EQ((matrix - SparseMatrix(matrix.adjoint())).norm(), 0.0);
  }
}

TEST(Operators, EdgesThatJoinTheSameVerticesAddUp)
{
  // A fin inside a sheet leaves a slit: its two sides are edges between the same two vertices.
  Surface sheet = Jittered(Square(4), 0.03, 2);
  sheet.Points.emplace_back(0.4, 0.5, 1.0);
  sheet.Triangles.push_back({ 11, 12, 25 });
  const System system(sheet, 4, 0.3);
  const auto& component = system.Mesh.GetComponents()[0];
  ASSERT_EQ(component.Vertices(), 25);
  EXPECT_EQ(system.Matrices.Energy.nonZeros(), 25 + 2 * (component.Edges() - 1));
  const ComplexVector u = RandomVector(25, 3);
  double energy = 0.0;
  for (Index t = component.FirstTriangle; t < component.EndTriangle; ++t)
  {
    std::array<double, 3> squaredLength;
    std::array<Complex, 3> transport;
    for (int c = 0; c < 3; ++c)
    {
      squaredLength[c] = system.Lengths.SquaredLength[system.Mesh.Edge(3 * t + c)];
      transport[c] = std::polar(1.0, 4.0 * system.Transport.RotationAlong(system.Mesh, 3 * t + c));
    }
    const LocalMatrices local(
      squaredLength, system.Lengths.Area[t], 4.0 * system.Transport.Curvature[t], transport, 0.3);
    for (int c = 0; c < 3; ++c)
    {
      const Complex tail = u[system.Mesh.Tail(3 * t + c)];
      const Complex head = u[system.Mesh.Head(3 * t + c)];
      energy += std::norm(tail) * local.EnergyDiagonal[c] +
        2.0 * (std::conj(tail) * local.Energy[c] * head).real();
    }
  }
  EXPECT_NEAR(u.dot(system.Matrices.Energy * u).real(), energy, 1e-11 * energy);
}

TEST(Operators, EnergyIsPositiveSemidefiniteAlsoWithBoundary)
{
  for (const Surface& surface : { Tetrahedron(), Cube(), Hemisphere(1), Disk(3), Potato(1),
         Jittered(Cylinder(7, 3, 1.0), 0.2, 5), Jittered(Torus(8, 6), 0.1, 6) })
  {
    for (const int degree : { 1, 2, 4, 7 })
    {
      for (const double bias : { -1.0, -0.6, 0.0, 0.5, 1.0 })
      {
        const System system(surface, degree, bias);
        const Eigen::VectorXd values = SystemEigenvalues(system.Matrices);
        EXPECT_GT(values[0], -1e-12 * values[values.size() - 1])
          << "degree " << degree << " bias " << bias;
        EXPECT_GT(DenseEigenvalues(Eigen::MatrixXcd(system.Matrices.Mass))[0], 0.0);
      }
    }
  }
}
