// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "PrescribedSingularities/SingularityTargets.h"

#include "Fields/PrescribedSingularities/Placements.h"
#include "Meshes/Surfaces.h"
#include "TrivialConnection/RotationAtPlace.h"

#include <gtest/gtest.h>

#include <stdexcept>

using namespace DirectionFields;

namespace
{
struct Example
{
  Example(const Surface& surface, int degree)
    : Geometry(surface)
    , Component(Geometry.Mesh.GetComponents().front())
    , Degree(degree)
    , Base(Geometry.Mesh.GetNumberOfVertices(), 1.0)
    , Connection(Geometry, Component, degree, Base, {})
  {
  }

  RotationTarget Make(const std::vector<int>& indices, const EditOptions& options)
  {
    std::vector<PrescribedSingularity> wanted;
    for (std::size_t k = 0; k < indices.size(); ++k)
    {
      const auto t = static_cast<Index>((2 * k + 1) * Component.Triangles() / (2 * indices.size()));
      wanted.push_back({ { t, { 0.2, 0.3, 0.5 } }, indices[k] });
    }
    this->Notes.clear();
    return MakeTarget(
      Geometry, Component, Degree, Connection, Geometry.Positions, wanted, options, this->Notes);
  }

  SurfaceGeometry Geometry;
  const TriangleMesh::Component& Component;
  int Degree;
  std::vector<Complex> Base;
  TrivialConnection Connection;
  std::vector<std::string> Notes;
};
}

TEST(SingularityTargets, AddUpToTheDegreeTimesTheEulerCharacteristic)
{
  for (const int degree : { 1, 2, 4 })
  {
    Example sphere(Meshes::Potato(3), degree);
    const RotationTarget exact =
      sphere.Make(std::vector<int>(static_cast<std::size_t>(2 * degree), 1), {});
    EXPECT_EQ(Placements::Sum(exact.Indices), 2 * degree);
    EXPECT_EQ(exact.Places.size(), static_cast<std::size_t>(2 * degree));
    EXPECT_TRUE(sphere.Notes.empty());
    // One more is refused, or balanced by one of the other sign.
    const std::vector<int> tooMany(static_cast<std::size_t>(2 * degree + 1), 1);
    EXPECT_THROW(sphere.Make(tooMany, {}), std::invalid_argument);
    EditOptions balanced;
    balanced.Balances = true;
    const RotationTarget mended = sphere.Make(tooMany, balanced);
    EXPECT_EQ(Placements::Sum(mended.Indices), 2 * degree);
    EXPECT_EQ(std::count(mended.Indices.begin(), mended.Indices.end(), -1), 1);
    EXPECT_EQ(sphere.Notes.size(), 1u);
  }
  Example torus(Meshes::Torus(30, 15), 4);
  EXPECT_EQ(Placements::Sum(torus.Make({ 1, -1, 2, -2 }, {}).Indices), 0);
  EXPECT_THROW(torus.Make({ 1 }, {}), std::invalid_argument);
}

TEST(SingularityTargets, AnyNumberGoesThroughABoundary)
{
  Example disk(Meshes::Disk(12), 4);
  for (const std::vector<int>& indices : { std::vector<int>{ 1 }, { -1, -1 }, { 1, 1, 1, 1, 1 } })
  {
    const RotationTarget target = disk.Make(indices, {});
    EXPECT_EQ(Placements::Sum(target.Indices), Placements::Sum(indices));
  }
}

TEST(SingularityTargets, AddToTheBaseOrReplaceIt)
{
  Example sphere(Meshes::Potato(3), 4);
  EditOptions adding;
  adding.AddsToBase = true;
  const RotationTarget target = sphere.Make({ 1, -1 }, adding);
  std::vector<int> change = target.Indices;
  for (std::size_t t = 0; t < change.size(); ++t)
  {
    change[t] -= sphere.Connection.GetBaseIndices()[t];
  }
  EXPECT_EQ(std::count_if(change.begin(), change.end(), [](int k) { return k != 0; }), 2);
  EXPECT_EQ(Placements::Sum(change), 0);
  // Without singularities in it nothing is replaced.
  EXPECT_EQ(sphere.Make({}, {}).Indices, sphere.Connection.GetBaseIndices());
}

/// A triangle's edges turn by less than a half turn each: the excess goes to others.
TEST(SingularityTargets, SpreadIndicesThatATriangleCannotHave)
{
  Example disk(Meshes::Disk(16), 4);
  for (const int index : { 2, 5, -4 })
  {
    const RotationTarget target = disk.Make({ index }, {});
    EXPECT_EQ(Placements::Sum(target.Indices), index);
    for (std::size_t t = 0; t < target.Indices.size(); ++t)
    {
      EXPECT_TRUE(target.Indices[t] == 0 ||
        CanHaveIndex(target.Indices[t], 4 * disk.Geometry.Transport.Curvature[t]));
    }
    EXPECT_EQ(disk.Notes.size(), 1u);
  }
}

/// A surface that cannot be oriented has each singularity on both sides of its cover.
TEST(SingularityTargets, AreTheSameOnBothSidesOfACover)
{
  Example strip(Meshes::MoebiusStrip(40, 6), 4);
  ASSERT_TRUE(strip.Component.IsCover);
  const TriangleMesh& mesh = strip.Geometry.Mesh;
  std::vector<PrescribedSingularity> wanted;
  for (Index t = 0; t < mesh.GetNumberOfTriangles() && wanted.size() < 2; t += 50)
  {
    if (mesh.IsFront(t))
    {
      wanted.push_back({ { t, { 0.2, 0.3, 0.5 } }, wanted.empty() ? 1 : -1 });
    }
  }
  const RotationTarget target = MakeTarget(strip.Geometry, strip.Component, 4, strip.Connection,
    strip.Geometry.Positions, wanted, {}, strip.Notes);
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    EXPECT_EQ(target.Indices[t], target.Indices[mesh.Mirror(3 * t) / 3]);
  }
  EXPECT_EQ(target.Places.size(), 2 * wanted.size());
}
