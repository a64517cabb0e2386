// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Finishing/FaceSources.h"
#include "Finishing/MeshAdvice.h"
#include "Meshes/Surfaces.h"
#include "Remesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

namespace
{
/// A star of this many points, as far inside of each other as this radius; of five with 0.38 they
/// have 40 degrees.
Surface Star(int points = 5, double inside = 0.38)
{
  Surface star;
  star.Points.emplace_back(0.0, 0.0, 0.0);
  for (int k = 0; k < 2 * points; ++k)
  {
    const double radius = k % 2 == 0 ? 1.0 : inside;
    const double angle = k * Pi / points;
    star.Points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    star.Triangles.push_back({ 0, 1 + k, 1 + (k + 1) % (2 * points) });
  }
  return star;
}

RemeshResult Remeshed(const Surface& surface, const RemeshOptions& options)
{
  return Remesh(std::make_shared<Surface>(surface)).Compute(options);
}

/// The sentence that has these words; empty if none has.
std::string NoteWith(const RemeshResult& mesh, const std::string& words)
{
  const auto note = std::find_if(mesh.Notes.begin(), mesh.Notes.end(),
    [&](const std::string& text) { return text.find(words) != std::string::npos; });
  return note == mesh.Notes.end() ? std::string() : *note;
}

/// The number that follows some words.
double NumberAfter(const std::string& note, const std::string& words)
{
  return std::stod(note.substr(note.find(words) + words.size()));
}
}

TEST(MeshAdvice, MeshesThatAreAsTheyShouldBeHaveNone)
{
  RemeshOptions options;
  options.NumberOfFaces = 1500;
  for (const Surface& surface : { Meshes::Potato(4), Meshes::Cube(), Meshes::Square(20) })
  {
    const RemeshResult mesh = Remeshed(surface, options);
    EXPECT_TRUE(mesh.Notes.empty()) << mesh.Notes.front();
  }
}

TEST(MeshAdvice, ManyTrianglesAndAnotherNumberOfFacesAreToldWithWhatHelps)
{
  RemeshOptions options;
  // The points of the star are closer to each other than edges.
  const Surface star = Star(16, 0.3);
  options.NumberOfFaces = 40;
  options.KeepThinParts = false;
  const RemeshResult mesh = Remeshed(star, options);
  ASSERT_GT(100 * mesh.Triangles, static_cast<Index>(mesh.Faces.size()));
  EXPECT_NE(NoteWith(mesh, "are triangles. Pure Quads"), "");
  EXPECT_NE(NoteWith(mesh, "in place of 40. A Number Of Faces of "), "");
  options.PureQuads = true;
  const RemeshResult pure = Remeshed(star, options);
  EXPECT_EQ(pure.Triangles, 0);
  EXPECT_EQ(NoteWith(pure, "are triangles"), "");
}

TEST(MeshAdvice, LimbsThatAreLostAreToldWithTheEdgeLengthThatComesCloser)
{
  RemeshOptions options;
  options.NumberOfFaces = 300;
  options.KeepThinParts = false;
  const RemeshResult mesh = Remeshed(Meshes::BallWithLimbs(), options);
  const std::string note = NoteWith(mesh, "away from the");
  ASSERT_NE(note, "");
  options.UseEdgeLength = true;
  options.EdgeLength = NumberAfter(note, "An edge length of ");
  const RemeshResult fine = Remeshed(Meshes::BallWithLimbs(), options);
  EXPECT_LT(std::max(fine.MaximumDistance, fine.MaximumDistanceToMesh),
    std::max(mesh.MaximumDistance, mesh.MaximumDistanceToMesh));
}

TEST(MeshAdvice, LengthsAreInTheUnitOfTheSurface)
{
  RemeshOptions options;
  options.NumberOfFaces = 300;
  options.KeepThinParts = false;
  const RemeshResult mesh = Remeshed(Meshes::BallWithLimbs(), options);
  const double scale = std::ldexp(1.0, 400);
  const RemeshResult large = Remeshed(Meshes::Transformed(Meshes::BallWithLimbs(),
                                        scale * Eigen::Matrix3d::Identity(), Vector3::Zero()),
    options);
  EXPECT_NEAR(large.MaximumDistanceToMesh / scale, mesh.MaximumDistanceToMesh, 1e-9);
  for (const char* words : { "An edge length of ", "Parts of the surface are up to " })
  {
    const double here = NumberAfter(NoteWith(mesh, words), words);
    EXPECT_NEAR(NumberAfter(NoteWith(large, words), words) / scale, here, 0.01 * here);
  }
}

TEST(MeshAdvice, DistancesAreMeasuredFromTheSurfaceToo)
{
  // The unit square of the plane, and places beside and above it.
  const std::vector<Vector3> square = { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 1.0, 1.0, 0.0 },
    { 0.0, 1.0, 0.0 } };
  const std::vector<Faces::Face> faces = { { 0, 1, 2, 3 } };
  EXPECT_NEAR(LargestDistance({ { 0.2, 0.7, 0.0 } }, square, faces), 0.0, 1e-15);
  EXPECT_NEAR(
    LargestDistance({ { 0.3, 0.4, -0.5 }, { 3.0, 0.5, 0.0 } }, square, faces), 2.0, 1e-12);
  EXPECT_EQ(LargestDistance({ { 0.3, 0.4, -0.5 } }, {}, {}), 0.0);
}

TEST(MeshAdvice, FlatFacesAreTold)
{
  const std::vector<Vector3> points = { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 1.0, 0.05, 0.0 },
    { 1.0, 1.0, 0.0 }, { 0.0, 1.0, 0.0 } };
  MeshWishes wishes;
  wishes.Extent = 1.0;
  EXPECT_TRUE(MeshAdvice(points, { { { 0, 1, 3, 4 } }, { 1 } }, wishes).empty());
  const Faces flat{ { { 0, 1, 2, None } }, { 0 } };
  ASSERT_EQ(MeshAdvice(points, flat, wishes).size(), 1u);
  EXPECT_EQ(
    MeshAdvice(points, flat, wishes)[0].rfind("1 face has a scaled Jacobian below 0.1", 0), 0u);
  wishes.IsSmoothed = false;
  EXPECT_NE(MeshAdvice(points, flat, wishes)[0].find("Smoothing Iterations"), std::string::npos);
  wishes.PartCrossed = 0.25;
  EXPECT_NE(MeshAdvice(points, flat, wishes)[0].find("cross 25 % of the edges that are kept"),
    std::string::npos);
}

TEST(MeshAdvice, SizesThatAreNotReachedAreTold)
{
  const Surface square = Meshes::Square(30);
  RemeshOptions options;
  options.NumberOfFaces = 1000;
  const auto sizing = [&](double power)
  {
    options.Sizing.clear();
    for (const Vector3& p : square.Points)
    {
      options.Sizing.push_back(std::pow(p[0] < 0.1 ? 1.0 : 8.0, power));
    }
  };
  const auto worst = [](const std::string& note)
  { return std::max(NumberAfter(note, "Edges are "), NumberAfter(note, "shortest, and ")); };
  // With pairs of irregular vertices these sizes are reached.
  options.AddIrregularPairs = false;
  sizing(1.0);
  const std::string note = NoteWith(Remeshed(square, options), "to be shortest");
  ASSERT_NE(note, "");
  sizing(0.5);
  const std::string less = NoteWith(Remeshed(square, options), "to be shortest");
  EXPECT_TRUE(less.empty() || worst(less) < worst(note)) << note << less;
  sizing(0.0);
  EXPECT_EQ(NoteWith(Remeshed(square, options), "to be shortest"), "");
}

TEST(MeshAdvice, ComponentsWithoutAreaAreToldToBeMissing)
{
  Surface surface = Meshes::Icosphere(2);
  RemeshOptions options;
  options.NumberOfFaces = 500;
  const auto p = static_cast<Index>(surface.Points.size());
  surface.Points.emplace_back(1.0, 1.0, 1.0);
  surface.Points.emplace_back(1.0, 1.0, 1.1);
  surface.Triangles.push_back({ p, p + 1, p });
  // The sphere has triangles of that kind, too, but is there.
  surface.Triangles.push_back({ 0, 0, 1 });
  EXPECT_EQ(NoteWith(Remeshed(surface, options), "not in the mesh").rfind("1 component is", 0), 0u);
  surface.Triangles.erase(surface.Triangles.end() - 2);
  EXPECT_EQ(NoteWith(Remeshed(surface, options), "not in the mesh"), "");
  EXPECT_EQ(CountUnused({ { 0, 1, 2 }, { 2, 3, 4 }, { 5, 5, 6 } }, { 0, 1, 0 }), 1);
}

TEST(MeshAdvice, SheetsThatOnlyTouchAreToldToBeApart)
{
  // Two cubes; where they have a corner at the same place it is the same point.
  const auto cubesAt = [](const Vector3& shift)
  {
    Surface cubes = Meshes::Joined(
      Meshes::Cube(), Meshes::Transformed(Meshes::Cube(), Eigen::Matrix3d::Identity(), shift));
    for (Triangle& t : cubes.Triangles)
    {
      for (Index& p : t)
      {
        const auto isHere = [&](const Vector3& q) { return (q - cubes.Points[p]).norm() < 1e-9; };
        p = static_cast<Index>(
          std::find_if(cubes.Points.begin(), cubes.Points.end(), isHere) - cubes.Points.begin());
      }
    }
    return cubes;
  };
  RemeshOptions options;
  options.NumberOfFaces = 300;
  Vector3 size = Vector3::Zero();
  for (const Vector3& point : Meshes::Cube().Points)
  {
    size = size.cwiseMax(point - Meshes::Cube().Points.front());
  }
  const std::string words = "sheets of the surface only touch";
  EXPECT_EQ(NoteWith(Remeshed(cubesAt(size), options), words).rfind("At 1 point", 0), 0u);
  const Vector3 aside(size[0], size[1], 0.0);
  const RemeshResult joined = Remeshed(cubesAt(aside), options);
  EXPECT_EQ(NoteWith(joined, words), "");
  EXPECT_EQ(joined.EulerCharacteristicAfter, 3);
  EXPECT_EQ(NoteWith(Remeshed(cubesAt(2.0 * size), options), words), "");
  EXPECT_EQ(TopologyAdvice(0, 2, 1, 0.5).size(), 1u);
  EXPECT_TRUE(TopologyAdvice(0, 2, 2, 0.5).empty());
}

/// Four squares in a row that are to be a millionth of what they are, or fewer.
TEST(MeshAdvice, WhatCannotHelpIsNotAdvised)
{
  std::vector<Vector3> points;
  Faces faces;
  for (Index k = 0; k <= 4; ++k)
  {
    points.emplace_back(k, 0.0, 0.0);
    points.emplace_back(k, 1.0, 0.0);
    if (k < 4)
    {
      faces.Corners.push_back({ 2 * k, 2 * k + 2, 2 * k + 3, 2 * k + 1 });
    }
  }
  MeshWishes wishes;
  wishes.Extent = 5.0;
  wishes.EdgeLength = 1e-6;
  wishes.Sizes.assign(points.size(), 1e-6);
  EXPECT_TRUE(MeshAdvice(points, faces, wishes).empty());
  // Those that differ, by a factor that the mesh has not.
  wishes.Sizes[0] = wishes.Sizes[1] = 1e-7;
  ASSERT_EQ(MeshAdvice(points, faces, wishes).size(), 1u);
  EXPECT_NE(
    MeshAdvice(points, faces, wishes)[0].find("where they are to be shortest"), std::string::npos);
  wishes.Sizes.clear();
  wishes.NumberOfFaces = 1;
  EXPECT_EQ(MeshAdvice(points, faces, wishes),
    std::vector<std::string>{ "There are 4 faces in place of 1. So few cannot show the surface." });
  wishes.NumberOfFaces = 2;
  EXPECT_EQ(MeshAdvice(points, faces, wishes),
    std::vector<std::string>{
      "There are 4 faces in place of 2. A Number Of Faces of 1 should come closer." });
  wishes.NumberOfFaces = 0;
  wishes.Turned = 2;
  for (const bool hasHard : { false, true })
  {
    wishes.HasHard = hasHard;
    ASSERT_EQ(MeshAdvice(points, faces, wishes).size(), 1u);
    EXPECT_EQ(
      MeshAdvice(points, faces, wishes)[0].find("Curves at up to 34 degrees") != std::string::npos,
      hasHard);
  }
}

TEST(MeshAdvice, ProgressNeverGoesBackwards)
{
  // The star has no good quads at once, so that a second mesh is made.
  for (const Surface& surface : { Meshes::Potato(2), Star() })
  {
    for (const bool isPure : { false, true })
    {
      RemeshOptions options;
      options.NumberOfFaces = 100;
      options.PureQuads = isPure;
      double last = 0.0;
      bool goesOn = true;
      Remesh(std::make_shared<Surface>(surface))
        .Compute(options, {},
          [&](double done)
          {
            goesOn = goesOn && done >= last && done <= 1.0;
            last = done;
            return true;
          });
      EXPECT_TRUE(goesOn);
    }
  }
}
