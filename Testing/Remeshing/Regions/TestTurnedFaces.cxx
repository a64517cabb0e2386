// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remesh.h"

#include "Meshes/Remeshed.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

using namespace DirectionFields;

namespace
{
/// The regions of a plate with a hole.
enum Side : Index
{
  Top,
  Bottom,
  Outside,
  Hole
};

struct Plate
{
  std::shared_ptr<Surface> Skin = std::make_shared<Surface>();
  std::vector<Index> Regions;
};

/// A square plate of side 2 with a hole in its middle, its upper side at z = 0. The regions are its
/// faces.
Plate PlateWithHole(Index sides, double radius, double thickness)
{
  constexpr Index layers = 6;
  const Surface flat = Meshes::PlateWithHole(sides, 24, radius, false);
  const auto count = static_cast<Index>(flat.Points.size());
  Surface all;
  Plate plate;
  std::map<std::array<Index, 2>, bool> halfEdges;
  for (Index k = 0; k <= layers; ++k)
  {
    for (const Vector3& p : flat.Points)
    {
      all.Points.emplace_back(p[0], p[1], -thickness * k / layers);
    }
  }
  const auto add = [&](const Triangle& t, Index region)
  {
    all.Triangles.push_back(t);
    plate.Regions.push_back(region);
  };
  constexpr Index last = layers;
  for (const Triangle& t : flat.Triangles)
  {
    add(t, Top);
    add({ t[0] + last * count, t[2] + last * count, t[1] + last * count }, Bottom);
    for (int c = 0; c < 3; ++c)
    {
      halfEdges[{ t[c], t[(c + 1) % 3] }] = true;
    }
  }
  for (const auto& [ends, isThere] : halfEdges)
  {
    if (halfEdges.count({ ends[1], ends[0] }) > 0)
    {
      continue;
    }
    const Index region =
      flat.Points[ends[0]].cwiseAbs().maxCoeff() < 1.0 - 1e-9 ? Side::Hole : Side::Outside;
    for (Index k = 0; k < layers; ++k)
    {
      const Index a = ends[0] + k * count;
      const Index b = ends[1] + k * count;
      add({ a, a + count, b + count }, region);
      add({ a, b + count, b }, region);
    }
  }
  std::vector<Index> number(all.Points.size(), None);
  for (Triangle& t : all.Triangles)
  {
    for (Index& p : t)
    {
      if (number[p] == None)
      {
        number[p] = static_cast<Index>(plate.Skin->Points.size());
        plate.Skin->Points.push_back(all.Points[p]);
      }
      p = number[p];
    }
  }
  plate.Skin->Triangles = all.Triangles;
  return plate;
}

/// The faces that look inwards, known from the plate's shape alone.
Index CountTurned(const RemeshResult& mesh)
{
  Index turned = 0;
  for (std::size_t f = 0; f < mesh.Faces.size(); ++f)
  {
    const std::array<Index, 4>& face = mesh.Faces[f];
    const int size = face[3] == None ? 3 : 4;
    Vector3 middle = Vector3::Zero();
    for (int c = 0; c < size; ++c)
    {
      middle += mesh.Points[face[c]] / size;
    }
    const Vector3& last = mesh.Points[face[size == 3 ? 0 : 3]];
    const Vector3 normal =
      (mesh.Points[face[2]] - mesh.Points[face[0]]).cross(last - mesh.Points[face[1]]);
    const bool isAlongX = std::abs(middle[0]) > std::abs(middle[1]);
    const Vector3 out = mesh.Regions[f] == Top ? Vector3(0.0, 0.0, 1.0)
      : mesh.Regions[f] == Bottom              ? Vector3(0.0, 0.0, -1.0)
      : mesh.Regions[f] == Side::Hole          ? Vector3(-middle[0], -middle[1], 0.0)
      : isAlongX                               ? Vector3(middle[0], 0.0, 0.0)
                                               : Vector3(0.0, middle[1], 0.0);
    turned += normal.dot(out) < 0.0 ? 1 : 0;
  }
  return turned;
}

RemeshResult Remeshed(const Plate& plate, Index faces, bool isPure)
{
  RemeshOptions options;
  options.NumberOfFaces = faces;
  options.PureQuads = isPure;
  options.Regions = plate.Regions;
  return Remesh(plate.Skin).Compute(options);
}
}

TEST(TurnedFaces, AreNoneAtHolesOfParts)
{
  struct Case
  {
    double Radius;
    Index Sides;
    Index Faces;
    bool IsPure;
  };
  for (const Case& one :
    { Case{ 0.1, 48, 400, false }, Case{ 0.1, 48, 400, true }, Case{ 0.15, 48, 800, false },
      Case{ 0.15, 48, 800, true }, Case{ 0.2, 48, 400, true }, Case{ 0.3, 48, 1600, false } })
  {
    const RemeshResult mesh =
      Remeshed(PlateWithHole(one.Sides, one.Radius, 0.3), one.Faces, one.IsPure);
    EXPECT_EQ(Meshes::FlawOf(mesh), "");
    EXPECT_EQ(CountTurned(mesh), 0) << one.Radius;
    EXPECT_EQ(mesh.TurnedFaces, 0) << one.Radius;
    EXPECT_GT(mesh.RegionsShown.BordersKept, 0.95) << one.Radius;
  }
}

TEST(TurnedFaces, AreTold)
{
  // The hole is narrower than an edge. Which of these meshes have some depends on rounding.
  Index all = 0;
  for (const Index sides : { 24, 36 })
  {
    for (const Index faces : { 200, 500 })
    {
      const RemeshResult mesh = Remeshed(PlateWithHole(sides, 0.03, 0.1), faces, false);
      all += mesh.TurnedFaces;
      // Faces whose middles lie in the hole have no part below them that is certain.
      EXPECT_NEAR(mesh.TurnedFaces, CountTurned(mesh), 2) << sides << ' ' << faces;
      const auto note = std::find_if(mesh.Notes.begin(), mesh.Notes.end(),
        [](const std::string& text) { return text.find("turned over") != std::string::npos; });
      EXPECT_EQ(note == mesh.Notes.end() ? 0 : std::stoi(*note), mesh.TurnedFaces)
        << sides << ' ' << faces;
    }
  }
  EXPECT_GT(all, 0);
}
