// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Dislocations/SizedRows.h"

#include "Meshes/Remeshed.h"
#include "Meshes/Surfaces.h"
#include "Remesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

namespace
{
using Size = std::function<double(const Vector3&)>;

RemeshOptions WithSizes(const Surface& surface, const Size& size, Index faces)
{
  RemeshOptions options;
  options.NumberOfFaces = faces;
  for (const Vector3& point : surface.Points)
  {
    options.Sizing.push_back(size(point));
  }
  return options;
}

RemeshResult Remeshed(const Surface& surface, const RemeshOptions& options)
{
  return Remesh(std::make_shared<Surface>(surface)).Compute(options);
}

double AreaOf(const RemeshResult& mesh)
{
  double sum = 0.0;
  for (const Faces::Face& face : mesh.Faces)
  {
    sum += Internal::AreaOf(mesh.Points, face);
  }
  return sum;
}

double Linear(const Vector3& p)
{
  return 1.0 + 4.0 * p.x();
}

double AtTwoSides(const Vector3& p)
{
  return 1.0 + 4.0 * std::min(1.0, 2.0 * std::min(p.x(), p.y()));
}

/// A boundary layer of 1 : 5 over a unit square, and how many of its edges are as wanted.
struct Layer
{
  const char* Name;
  Size Of;
};

const std::vector<Layer> Layers = { { "Linear", Linear },
  { "Exponential", [](const Vector3& p) { return std::pow(5.0, p.x()); } },
  { "Tanh", [](const Vector3& p) { return 3.0 + 2.0 * std::tanh((p.x() - 0.3) / 0.15); } },
  { "Quarter", [](const Vector3& p) { return 1.0 + 4.0 * std::min(1.0, 4.0 * p.x()); } },
  { "TwoSides", AtTwoSides },
  { "Radial", [](const Vector3& p) { return 1.0 + 4.0 * std::min(1.0, p.norm()); } },
  { "Spot",
    [](const Vector3& p)
    {
      const double distance = (p - Vector3(0.4, 0.45, 0.0)).norm() / 0.3;
      return 1.0 + 4.0 * (1.0 - std::exp(-distance * distance));
    } } };
}

/// Nine of ten edges have a length within a quarter of what is wanted, and all faces are good quads,
/// where without the rows every second or third edge is off.
TEST(SizedRows, MeetTheSizesOfLayers)
{
  constexpr Index faces = 1500;
  const Surface square = Meshes::Square(40);
  for (const Layer& layer : Layers)
  {
    SCOPED_TRACE(layer.Name);
    RemeshOptions options = WithSizes(square, layer.Of, faces);
    const RemeshResult with = Remeshed(square, options);
    options.AddIrregularPairs = false;
    const RemeshResult without = Remeshed(square, options);
    EXPECT_GE(with.EdgesAsWanted, 0.9);
    EXPECT_LT(without.EdgesAsWanted, 0.8);
    EXPECT_EQ(with.Triangles, 0);
    EXPECT_GE(Meshes::LeastQuality(with), 0.4);
    EXPECT_NEAR(static_cast<double>(with.Quads), static_cast<double>(faces), 0.2 * faces);
    // One boundary, of the corners and straight sides of the square, and as many vertices of three
    // faces as of five, which is the sum of the valences of a disk.
    EXPECT_EQ(Meshes::FlawOf(with), "");
    EXPECT_EQ(Meshes::CountBoundaryLoops(with), 1);
    EXPECT_LT(with.MaximumBoundaryDistance, 1e-9);
    EXPECT_NEAR(AreaOf(with), 1.0, 1e-9);
    EXPECT_GT(with.IrregularVertices, 0);
  }
}

/// Around a hole the surface keeps its two boundaries.
TEST(SizedRows, GoAroundHoles)
{
  constexpr double radius = 0.25;
  const Surface plate = Meshes::PlateWithHole(80, 20, radius, false);
  const RemeshResult mesh = Remeshed(plate,
    WithSizes(
      plate,
      [](const Vector3& p)
      { return 1.0 + 4.0 * std::min(1.0, (p.norm() - radius) / (1.0 - radius)); },
      1500));
  EXPECT_GE(mesh.EdgesAsWanted, 0.9);
  EXPECT_EQ(mesh.Triangles, 0);
  EXPECT_EQ(Meshes::FlawOf(mesh), "");
  EXPECT_EQ(Meshes::CountBoundaryLoops(mesh), 2);
  EXPECT_GE(Meshes::LeastQuality(mesh), 0.4);
}

/// On a curved surface with singularities of its own, too.
TEST(SizedRows, MeetTheSizesOfCurvedSurfaces)
{
  const Surface potato = Meshes::Potato(4);
  const RemeshOptions options = WithSizes(
    potato, [](const Vector3& p) { return 3.0 + 2.0 * std::tanh(2.0 * p.x()); }, 1500);
  const RemeshResult mesh = Remeshed(potato, options);
  EXPECT_GE(mesh.EdgesAsWanted, 0.9);
  EXPECT_EQ(Meshes::FlawOf(mesh), "");
  EXPECT_GE(Meshes::LeastQuality(mesh), 0.3);
}

/// Sizes that are the same everywhere need no rows, and those of triangles have none.
TEST(SizedRows, AreOnlyThereWhereSizesVary)
{
  const Surface potato = Meshes::Potato(3);
  RemeshOptions options = WithSizes(
    potato, [](const Vector3&) { return 3.0; }, 400);
  const RemeshResult even = Remeshed(potato, options);
  options.AddIrregularPairs = false;
  const RemeshResult without = Remeshed(potato, options);
  EXPECT_EQ(even.Points, without.Points);
  EXPECT_EQ(even.Faces, without.Faces);
}

TEST(SizedRows, DoNotDependOnTheNumberOfThreads)
{
  const Surface square = Meshes::Square(20);
  RemeshOptions options = WithSizes(square, AtTwoSides, 600);
  options.NumberOfThreads = 1;
  const RemeshResult one = Remeshed(square, options);
  options.NumberOfThreads = 3;
  const RemeshResult three = Remeshed(square, options);
  EXPECT_EQ(one.Points, three.Points);
  EXPECT_EQ(one.Faces, three.Faces);
  EXPECT_GT(one.IrregularVertices, 0);
}

/// Rows cross a border between regions, which stays where it is, and given points stay vertices.
TEST(SizedRows, KeepRegionsAndGivenPoints)
{
  const Surface square = Meshes::Square(40);
  RemeshOptions options = WithSizes(square, Linear, 1500);
  for (const Triangle& t : square.Triangles)
  {
    const Vector3 middle = (square.Points[t[0]] + square.Points[t[1]] + square.Points[t[2]]) / 3.0;
    options.Regions.push_back(middle.y() < 0.5 ? 0 : 1);
  }
  const Vector3 given(0.3, 0.7, 0.0);
  const RemeshResult mesh =
    Remesh(std::make_shared<Surface>(square), {}, { given }).Compute(options);
  EXPECT_GE(mesh.EdgesAsWanted, 0.85);
  EXPECT_EQ(Meshes::FlawOf(mesh), "");
  EXPECT_TRUE(mesh.RegionsShown.Lost.empty());
  EXPECT_GT(mesh.RegionsShown.BordersKept, 1.0 - 1e-9);
  std::array<double, 2> areas = { 0.0, 0.0 };
  for (std::size_t f = 0; f < mesh.Faces.size(); ++f)
  {
    areas[mesh.Regions[f]] += Internal::AreaOf(mesh.Points, mesh.Faces[f]);
  }
  EXPECT_NEAR(areas[0], 0.5, 1e-9);
  EXPECT_NEAR(areas[1], 0.5, 1e-9);
  EXPECT_TRUE(std::any_of(mesh.Points.begin(), mesh.Points.end(),
    [&](const Vector3& p) { return (p - given).norm() < 1e-9; }));
}

/// Only quads stay only quads.
TEST(SizedRows, MakeNoTriangles)
{
  const Surface potato = Meshes::Potato(3);
  RemeshOptions options = WithSizes(
    potato, [](const Vector3& p) { return 3.0 + 2.0 * std::tanh(2.0 * p.x()); }, 600);
  options.PureQuads = true;
  const RemeshResult mesh = Remeshed(potato, options);
  EXPECT_EQ(mesh.Triangles, 0);
  EXPECT_EQ(Meshes::FlawOf(mesh), "");
}
