// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "TrivialConnection/LoopHolonomies.h"

#include "Fields/TrivialConnection/Components.h"
#include "Meshes/Surfaces.h"
#include "Sections/Singularities.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace DirectionFields;
using Components::Tested;

namespace
{
double Longitude(const Vector3& p)
{
  return std::atan2(p.y(), p.x());
}

/// The rotation of a field on a torus whose directions turn against the circles of latitude by turns / n while it goes
/// once around the axis.
EdgeForm FieldOnTorus(const Tested& torus, int degree, int turns)
{
  std::vector<Complex> section(torus.Mesh.GetNumberOfVertices());
  for (Index v = 0; v < torus.Mesh.GetNumberOfVertices(); ++v)
  {
    const double angle = Longitude(torus.Geometry.Positions[v]);
    const Complex tangent =
      torus.Geometry.Frames.Tangential(v, Vector3(-std::sin(angle), std::cos(angle), 0.0));
    section[v] = std::pow(tangent / std::abs(tangent), degree) * std::polar(1.0, turns * angle);
  }
  return PhaseDifferences(torus.Geometry, torus.Component, degree, section.data());
}

/// How often a loop goes around the axis.
int TimesAround(const Tested& torus, const std::vector<Index>& loop)
{
  Index at = torus.Mesh.Tail(torus.Mesh.HalfEdge(loop.front()));
  double sum = 0.0;
  for (const Index e : loop)
  {
    const Index h = torus.Mesh.HalfEdge(e);
    const Index next = torus.Mesh.Tail(h) == at ? torus.Mesh.Head(h) : torus.Mesh.Tail(h);
    sum += std::remainder(
      Longitude(torus.Geometry.Positions[next]) - Longitude(torus.Geometry.Positions[at]),
      2.0 * Pi);
    at = next;
  }
  return static_cast<int>(std::lround(sum / (2.0 * Pi)));
}
}

/// A simple loop that cannot be contracted turns as often as the field along the latitudes, whatever its way: not at
/// all against it.
TEST(LoopHolonomies, CountTheTurnsOfFieldsOnATorus)
{
  const Tested torus(Meshes::Torus(48, 24));
  for (const int degree : { 1, 2, 4 })
  {
    for (const int turns : { 0, 1, -3 })
    {
      const std::vector<int> found = LoopHolonomies(
        torus.Geometry, torus.Component, degree, torus.Trees, FieldOnTorus(torus, degree, turns));
      ASSERT_EQ(found.size(), 2u);
      bool isAround = false;
      for (std::size_t k = 0; k < found.size(); ++k)
      {
        const int times = TimesAround(torus, torus.Trees.LoopOf(k));
        EXPECT_EQ(found[k], turns * times) << degree << " " << turns;
        isAround = isAround || times != 0;
      }
      EXPECT_TRUE(isAround);
    }
  }
}

/// A simple loop around a hole in the plane turns once, and a constant field once against it.
TEST(LoopHolonomies, ConstantFieldsTurnAgainstALoopAroundAHole)
{
  const Tested plate(Meshes::PlateWithHole(16, 4, 0.5, false));
  for (const int degree : { 1, 2, 4 })
  {
    std::vector<Complex> section(plate.Mesh.GetNumberOfVertices());
    for (Index v = 0; v < plate.Mesh.GetNumberOfVertices(); ++v)
    {
      section[v] = std::pow(plate.Geometry.Frames.Tangential(v, Vector3::UnitX()), degree);
    }
    const std::vector<int> found = LoopHolonomies(plate.Geometry, plate.Component, degree,
      plate.Trees, PhaseDifferences(plate.Geometry, plate.Component, degree, section.data()));
    ASSERT_EQ(found.size(), 1u);
    const int times = TimesAround(plate, plate.Trees.LoopOf(0));
    EXPECT_EQ(std::abs(times), 1);
    EXPECT_EQ(found[0], -degree * times);
  }
}

TEST(LoopHolonomies, GrowByOneWithEachGenerator)
{
  const Tested tested(Meshes::FlatlySubdivided(Meshes::DoubleTorus(), 1));
  const std::vector<Complex> section(tested.Mesh.GetNumberOfVertices(), 1.0);
  const EdgeForm rotation = PhaseDifferences(tested.Geometry, tested.Component, 4, section.data());
  const std::vector<int> before =
    LoopHolonomies(tested.Geometry, tested.Component, 4, tested.Trees, rotation);
  ASSERT_EQ(before.size(), 4u);
  for (std::size_t k = 0; k < before.size(); ++k)
  {
    EdgeForm more = rotation;
    for (const TreeCotree::Term& term : tested.Trees.FormOf(k))
    {
      more[term.Edge] += 2.0 * Pi * term.Value;
    }
    std::vector<int> wanted = before;
    ++wanted[k];
    EXPECT_EQ(LoopHolonomies(tested.Geometry, tested.Component, 4, tested.Trees, more), wanted);
  }
}

TEST(NearestIntegers, NoSingleStepMakesTheSumSmaller)
{
  std::mt19937 random(9);
  for (int size = 1; size < 9; ++size)
  {
    const Eigen::MatrixXd half =
      Eigen::MatrixXd::NullaryExpr(size, size, [&] { return random() / 4294967296.0 - 0.5; });
    const Eigen::MatrixXd products =
      half.transpose() * half + 0.01 * Eigen::MatrixXd::Identity(size, size);
    const Eigen::VectorXd slope =
      Eigen::VectorXd::NullaryExpr(size, [&] { return random() / 4294967296.0 - 0.5; });
    const auto value = [&](const Eigen::VectorXd& x)
    { return 0.5 * x.dot(products * x) + slope.dot(x); };
    const Eigen::VectorXd nearest = NearestIntegers(products, slope).cast<double>();
    for (int j = 0; j < size; ++j)
    {
      for (const double step : { 1.0, -1.0 })
      {
        EXPECT_GE(value(nearest + step * Eigen::VectorXd::Unit(size, j)), value(nearest) - 1e-8);
      }
    }
  }
}

TEST(NearestIntegers, AreRoundedWhereUnknownsAreIndependent)
{
  const Eigen::Vector3d diagonal(1.0, 2.0, 0.5);
  const Eigen::Vector3d wanted(2.4, -3.6, 0.2);
  EXPECT_EQ(NearestIntegers(diagonal.asDiagonal(), -diagonal.cwiseProduct(wanted)),
    Eigen::Vector3i(2, -4, 0));
}
