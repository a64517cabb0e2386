// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Parametrization/ParametrizationEnergy.h"

#include "Meshes/Surfaces.h"
#include "Remeshing/CutExample.h"

#include <gtest/gtest.h>

using namespace DirectionFields;
using Meshes::CutExample;

namespace
{
std::vector<Surface> Examples()
{
  return { Meshes::Icosphere(1), Meshes::Torus(9, 6), Meshes::PlateWithHole(12, 4, 0.4, true) };
}

/// The energy from its definition, for any values of the free variables: the real ones first, then
/// the integers.
class Definition
{
public:
  Definition(const CutMesh& mesh, ParametrizationVariables& variables, double perLength)
    : Mesh(mesh)
    , Plane(mesh.Degree)
    , Variables(variables)
    , PerLength(perLength)
    , Slot(variables.Solved.GetNumberOfVariables(), None)
  {
    Index count = 0;
    for (const bool areIntegers : { false, true })
    {
      for (std::size_t v = 0; v < this->Slot.size(); ++v)
      {
        const auto variable = static_cast<Index>(v);
        if (variables.Solved.IsFree(variable) &&
          variables.Solved.IsInteger(variable) == areIntegers)
        {
          this->Slot[v] = count++;
        }
      }
    }
  }

  std::array<double, 2> Corner(const Eigen::VectorXd& x, Index t, int c)
  {
    const SymbolicGridPoint point = this->Variables.Corner(t, c);
    return { this->Value(x, point.A), this->Value(x, point.B) };
  }

  double EnergyAt(const Eigen::VectorXd& x)
  {
    double energy = 0.0;
    for (Index t = 0; t < static_cast<Index>(this->Mesh.Triangles.size()); ++t)
    {
      const CutMesh::MapTriangle& triangle = this->Mesh.Triangles[t];
      for (int c = 0; c < 3; ++c)
      {
        const Index twin = triangle.Twin[c];
        if (twin != None && twin < 3 * t + c)
        {
          continue;
        }
        const double beyond = twin != None ? this->Mesh.Triangles[twin / 3].Weight[twin % 3] : 0.0;
        const std::array<double, 2> tail = this->Corner(x, t, c);
        const std::array<double, 2> head = this->Corner(x, t, (c + 1) % 3);
        const Complex edge = this->Plane.Combined(head[0] - tail[0], head[1] - tail[1]);
        energy += std::max(0.05, triangle.Weight[c] + beyond) *
          std::norm(edge - this->PerLength * triangle.Target[c]);
      }
    }
    return energy;
  }

  double AreaAt(const Eigen::VectorXd& x)
  {
    double area = 0.0;
    for (Index t = 0; t < static_cast<Index>(this->Mesh.Triangles.size()); ++t)
    {
      const std::array<double, 2> p = this->Corner(x, t, 0);
      const std::array<double, 2> q = this->Corner(x, t, 1);
      const std::array<double, 2> r = this->Corner(x, t, 2);
      area += 0.5 * ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
    }
    return area;
  }

private:
  double Value(const Eigen::VectorXd& x, const IntegerSum& sum)
  {
    double value = 0.0;
    for (const auto& [variable, factor] : this->Variables.Solved.Resolve(sum))
    {
      value += static_cast<double>(factor) * x[this->Slot[variable]];
    }
    return value;
  }

  const CutMesh& Mesh;
  IntegerGrid Plane;
  ParametrizationVariables& Variables;
  double PerLength;
  std::vector<Index> Slot;
};

Eigen::VectorXd RandomVector(Eigen::Index size, unsigned seed)
{
  std::mt19937 engine(seed);
  Eigen::VectorXd x(size);
  for (double& value : x)
  {
    value = engine() / 4294967296.0 - 0.5;
  }
  return x;
}

constexpr double PerLength = 5.0;
}

TEST(ParametrizationEnergy, RightHandSideIsTheSlopeOfTheEnergy)
{
  for (const Surface& surface : Examples())
  {
    for (const int degree : { 4, 6 })
    {
      const CutExample example = CutExample::Random(surface, degree, 5);
      const std::vector<double> perLength = example.Settings(PerLength).PerLength;
      ParametrizationEnergy energy(example.Mesh, perLength);
      Definition definition(example.Mesh, energy.GetVariables(), PerLength);
      const Eigen::VectorXd side = energy.RightHandSide(perLength);
      for (unsigned seed = 0; seed < 3; ++seed)
      {
        // A quadratic function's central differences are exact.
        const Eigen::VectorXd d = RandomVector(side.size(), seed);
        const double slope = 0.25 * (definition.EnergyAt(-d) - definition.EnergyAt(d));
        EXPECT_NEAR(slope, side.dot(d), 1e-8 * (1.0 + definition.EnergyAt(d)));
      }
    }
  }
}

TEST(ParametrizationEnergy, SolutionOfTheSystemIsItsMinimum)
{
  for (const Surface& surface : Examples())
  {
    for (const int degree : { 4, 6 })
    {
      const CutExample example = CutExample::Random(surface, degree, 6);
      const std::vector<double> perLength = example.Settings(PerLength).PerLength;
      ParametrizationEnergy energy(example.Mesh, perLength);
      Definition definition(example.Mesh, energy.GetVariables(), PerLength);
      ASSERT_TRUE(energy.IsFactored());
      const SchurSystem& system = energy.GetSystem();
      ASSERT_TRUE(system.IsDefinite());
      const Eigen::VectorXd x = system.Solve(energy.RightHandSide(perLength));
      const double least = definition.EnergyAt(x);
      for (unsigned seed = 0; seed < 3; ++seed)
      {
        const Eigen::VectorXd d = RandomVector(x.size(), seed);
        const double ahead = definition.EnergyAt(x + d);
        EXPECT_NEAR(ahead, definition.EnergyAt(x - d), 1e-8 * ahead);
        EXPECT_GT(ahead, least);
      }
    }
  }
}

TEST(ParametrizationEnergy, AreaIsTheSumOverTheTriangles)
{
  for (const Surface& surface : Examples())
  {
    for (const int degree : { 4, 6 })
    {
      const CutExample example = CutExample::Random(surface, degree, 7);
      const std::vector<double> perLength = example.Settings(PerLength).PerLength;
      ParametrizationEnergy energy(example.Mesh, perLength);
      Definition definition(example.Mesh, energy.GetVariables(), PerLength);
      const Eigen::VectorXd x = RandomVector(energy.RightHandSide(perLength).size(), 1);
      const double area = definition.AreaAt(x);
      EXPECT_NEAR(energy.AreaAt(x), area, 1e-9 * (1.0 + std::abs(area)));
    }
  }
}
