// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "TrivialConnection/TrivialConnection.h"

#include "Fields/TrivialConnection/Components.h"
#include "Meshes/Surfaces.h"
#include "Sections/Singularities.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace DirectionFields;

namespace
{
/// A trivial connection over a rough base of degree n, with singularities moved by dipoles.
struct Example
{
  Example(const Surface& surface, int degree, int dipoles, RotationObjective objective)
    : Parts(surface)
    , Degree(degree)
    , Base(MakeBase(Parts.Mesh.GetNumberOfVertices()))
    , Connection(Parts.Geometry, Parts.Component, degree, Base, {})
  {
    this->Target.Objective = objective;
    this->Target.Indices.assign(this->Parts.Component.Triangles(), 0);
    // The sum is the base's, which is n times the Euler characteristic; units stand apart.
    const std::vector<int>& base = this->Connection.GetBaseIndices();
    int sum = 0;
    for (const int index : base)
    {
      sum += index;
    }
    const int count = std::abs(sum) + 2 * dipoles;
    for (int k = 0; k < count; ++k)
    {
      const Index t = static_cast<Index>((k + 0.5) * this->Parts.Component.Triangles() / count);
      const int unit = k < std::abs(sum) ? (sum > 0 ? 1 : -1)
        : (k - std::abs(sum)) % 2 == 0   ? 1
                                         : -1;
      this->Target.Indices[t] += unit;
      this->Target.Places.push_back({ t, { 0.3, 0.3, 0.4 } });
    }
  }

  static std::vector<Complex> MakeBase(Index vertices)
  {
    std::vector<Complex> base(vertices);
    for (Index v = 0; v < vertices; ++v)
    {
      base[v] = std::polar(1.0, 0.7 * std::sin(0.1 * v));
    }
    return base;
  }

  Components::Tested Parts;
  int Degree;
  std::vector<Complex> Base;
  TrivialConnection Connection;
  RotationTarget Target;
};
}

/// d omega = 2 pi k - Omega.
TEST(TrivialConnection, HasThePrescribedCurvature)
{
  for (const Surface& surface : { Meshes::Potato(3), Meshes::Torus(30, 15), Meshes::Disk(10) })
  {
    for (const int degree : { 1, 4 })
    {
      for (const auto objective : { RotationObjective::Smoothest, RotationObjective::LeastChange })
      {
        Example example(surface, degree, 2, objective);
        const TurnedField field = example.Connection.Turn(example.Target, {});
        for (Index t = 0; t < example.Parts.Component.Triangles(); ++t)
        {
          EXPECT_NEAR(example.Parts.Forms.Around(field.Rotation, t),
            2.0 * Pi * example.Target.Indices[t] -
              degree * example.Parts.Geometry.Transport.Curvature[t],
            1e-9);
        }
        EXPECT_TRUE(example.Connection.WrongTriangles(example.Target, field).empty());
        const ComplexVector section = example.Connection.SectionOf(field);
        EXPECT_EQ(SingularityIndices(
                    example.Parts.Geometry, example.Parts.Component, degree, section.data()),
          example.Target.Indices);
        EXPECT_NEAR(section.cwiseAbs().minCoeff(), 1.0, 1e-12);
        EXPECT_NEAR(section.cwiseAbs().maxCoeff(), 1.0, 1e-12);
      }
    }
  }
}

/// The field of least energy is coexact: nothing flows into any vertex away from singular triangles, whose rotations
/// are set, and nothing into any of these as a whole.
TEST(TrivialConnection, HasNoDivergence)
{
  for (const Surface& surface : { Meshes::Potato(3), Meshes::Disk(10) })
  {
    Example example(surface, 4, 2, RotationObjective::Smoothest);
    const TurnedField field = example.Connection.Turn(example.Target, {});
    const Eigen::VectorXd inflow = example.Parts.Forms.Inflow(field.Rotation);
    std::vector<char> isRigid(inflow.size(), 0);
    for (Index t = 0; t < example.Parts.Component.Triangles(); ++t)
    {
      double sum = 0.0;
      for (int c = 0; c < 3; ++c)
      {
        const Index v = example.Parts.Mesh.Tail(3 * t + c);
        sum += inflow[v];
        isRigid[v] = isRigid[v] || example.Target.Indices[t] != 0;
      }
      if (example.Target.Indices[t] != 0)
      {
        EXPECT_NEAR(sum, 0.0, 1e-4);
      }
    }
    double largest = 0.0;
    for (Index v = 0; v < inflow.size(); ++v)
    {
      largest = std::max(largest, isRigid[v] ? 0.0 : std::abs(inflow[v]));
    }
    EXPECT_LT(largest, 1e-4);
    EXPECT_LT(largest, 1e-3 * inflow.cwiseAbs().maxCoeff());
    EXPECT_NEAR(field.Energy, example.Parts.Forms.Product(field.Rotation, field.Rotation),
      1e-9 * field.Energy);
  }
}

/// Neither does another number of turns along a loop lower the energy: adding 2 pi of a harmonic form changes it by
/// more than it could gain.
TEST(TrivialConnection, TurnsAlongLoopsAsLittleAsItCan)
{
  Example example(Meshes::Torus(40, 20), 4, 0, RotationObjective::Smoothest);
  const TurnedField field = example.Connection.Turn(example.Target, {});
  ASSERT_EQ(example.Parts.Trees.GetGenerators().size(), 2u);
  const PoissonSolver& solver = example.Connection.GetSolver();
  for (std::size_t k = 0; k < 2; ++k)
  {
    EdgeForm harmonic = example.Parts.Dense(example.Parts.Trees.FormOf(k));
    const Eigen::VectorXd inflow = example.Parts.Forms.Inflow(harmonic);
    Eigen::VectorXd potential = Eigen::VectorXd::Zero(inflow.size());
    solver.Solve(PoissonSolver::Problem{ inflow }, potential);
    example.Parts.Forms.SubtractRise(potential, harmonic);
    for (const double turns : { 2.0 * Pi, -2.0 * Pi })
    {
      EdgeForm other = field.Rotation;
      for (std::size_t e = 0; e < other.size(); ++e)
      {
        other[e] += turns * harmonic[e];
      }
      EXPECT_GT(example.Parts.Forms.Product(other, other), field.Energy);
    }
  }
}

TEST(TrivialConnection, ChangesNothingWhereTheBaseHasTheIndices)
{
  Example example(Meshes::Potato(3), 4, 0, RotationObjective::LeastChange);
  example.Target.Indices = example.Connection.GetBaseIndices();
  example.Target.Places.clear();
  const TurnedField field = example.Connection.Turn(example.Target, {});
  EXPECT_EQ(field.Turn.cwiseAbs().maxCoeff(), 0.0);
  const ComplexVector section = example.Connection.SectionOf(field);
  for (Index v = 0; v < section.size(); ++v)
  {
    EXPECT_LT(std::abs(section[v] - example.Base[v]), 1e-12);
  }
}

/// Given directions stay, and edges between them turn as these say.
TEST(TrivialConnection, KeepsGivenDirections)
{
  Example example(Meshes::Disk(10), 4, 0, RotationObjective::Smoothest);
  const TriangleMesh& mesh = example.Parts.Mesh;
  std::vector<char> isGiven(mesh.GetNumberOfVertices(), 0);
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    isGiven[v] = mesh.IsBoundary(v) ? 1 : 0;
    example.Base[v] = isGiven[v] ? example.Base[v] : Complex(1.0);
  }
  TrivialConnection connection(
    example.Parts.Geometry, example.Parts.Component, 4, example.Base, isGiven);
  example.Target.Indices = connection.GetBaseIndices();
  example.Target.Places.clear();
  const TurnedField field = connection.Turn(example.Target, {});
  const ComplexVector section = connection.SectionOf(field);
  for (Index v = 0; v < section.size(); ++v)
  {
    if (isGiven[v])
    {
      EXPECT_LT(std::abs(section[v] - example.Base[v]), 1e-9);
    }
  }
}
