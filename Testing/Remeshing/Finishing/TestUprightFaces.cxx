// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Finishing/SurfacePatches.h"
#include "Meshes/Surfaces.h"
#include "Preparation/PreparedField.h"
#include "Remesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <utility>
#include <vector>

using namespace DirectionFields;
using namespace Meshes;

/// A disk with a hub and holes for bolts has corners where faces of two sides meet; vertices that get over an edge
/// there turn a face over, and it is half an edge away from the part.
TEST(UprightFaces, AreAllOfThemBesideTheFeaturesOfAPart)
{
  const auto part = std::make_shared<const Surface>(Flange(1));
  Remesh remesh(part);
  Index turned = 0;
  for (const int faces : { 1000, 1500, 2000, 2500 })
  {
    RemeshOptions options;
    options.NumberOfFaces = faces;
    turned += remesh.Compute(options).TurnedFaces;
  }
  EXPECT_LE(turned, 1);
}

namespace
{
constexpr Index Cells = 25;

/// A square plate of quads whose lower side is a little smaller than the upper one, so that its
/// narrow sides look downwards, with lines at all edges of its shape.
FaceMesh UndercutPlate()
{
  constexpr Index row = Cells + 1;
  FaceMesh mesh;
  for (const auto& [size, z] : { std::pair<double, double>(10.0, 0.0), { 9.6, -0.4 } })
  {
    for (Index j = 0; j < row; ++j)
    {
      for (Index i = 0; i < row; ++i)
      {
        mesh.Points.emplace_back(size * i / Cells, size * j / Cells, z);
        mesh.Points.back() -= Vector3(0.5 * size, 0.5 * size, 0.0);
      }
    }
  }
  const auto at = [](Index i, Index j) { return row * j + i; };
  constexpr Index below = row * row;
  for (Index j = 0; j < Cells; ++j)
  {
    for (Index i = 0; i < Cells; ++i)
    {
      const std::array<Index, 4> top = { at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) };
      mesh.Cells.Corners.push_back({ top[0], top[1], top[2], top[3] });
      mesh.Cells.Corners.push_back(
        { top[3] + below, top[2] + below, top[1] + below, top[0] + below });
    }
  }
  for (Index k = 0; k < Cells; ++k)
  {
    for (const auto& [a, b] :
      { std::pair<Index, Index>(at(k, 0), at(k + 1, 0)), { at(Cells, k), at(Cells, k + 1) },
        { at(k + 1, Cells), at(k, Cells) }, { at(0, k + 1), at(0, k) } })
    {
      mesh.Cells.Corners.push_back({ b, a, a + below, b + below });
      mesh.LineEdges.push_back({ { a, b }, 1 });
      mesh.LineEdges.push_back({ { a + below, b + below }, 1 });
    }
  }
  for (const Index corner : { at(0, 0), at(Cells, 0), at(Cells, Cells), at(0, Cells) })
  {
    mesh.LineEdges.push_back({ { corner, corner + below }, 1 });
  }
  mesh.Vertices.resize(mesh.Points.size());
  mesh.Cells.IsRegular.assign(mesh.Cells.Corners.size(), 1);
  return mesh;
}

Surface TrianglesOf(const FaceMesh& mesh)
{
  Surface surface;
  surface.Points = mesh.Points;
  for (const Faces::Face& face : mesh.Cells.Corners)
  {
    surface.Triangles.push_back({ face[0], face[1], face[2] });
    surface.Triangles.push_back({ face[0], face[2], face[3] });
  }
  return surface;
}
}

TEST(UprightFaces, AreThoseOfAPatchThatALineDoesNotEncloseAllAround)
{
  FaceMesh mesh = UndercutPlate();
  const Surface plate = TrianglesOf(mesh);
  const Internal::PreparedField field(plate, 4, Internal::KeptEdges({ true, 40.0, 0.0, 0.0 }), {},
    {}, ShapeAlignment{ 0.25, 1.5 }, Progress());
  const Internal::FeatureLines lines(
    field.GetGeometry(), field.GetMatching(), field.GetFeatures(), field.GetFrameless(), { 1.0 });
  const Internal::SurfacePatches patches(field.GetSurface(), lines, 0.4);
  const ClosestPoints triangles(field.GetSurface().GetTriangles());
  ASSERT_EQ(patches.GetAll().size(), 6u);
  EXPECT_TRUE(patches.FindTurned(mesh, triangles).empty());
  // Without one edge of the line the upper side and a narrow one are one part of the mesh.
  mesh.LineEdges.erase(mesh.LineEdges.begin() + 8 * (Cells / 2));
  EXPECT_TRUE(patches.FindTurned(mesh, triangles).empty());
  const std::vector<Index> ofFaces = patches.OfFaces(mesh, triangles);
  std::map<Index, Index> faces;
  for (const Index patch : ofFaces)
  {
    ++faces[patch];
  }
  EXPECT_EQ(faces.size(), 6u);
  EXPECT_EQ(std::count_if(
              faces.begin(), faces.end(), [](const auto& patch) { return patch.second == Cells; }),
    4);
  std::swap(mesh.Cells.Corners.back()[1], mesh.Cells.Corners.back()[3]);
  EXPECT_EQ(patches.FindTurned(mesh, triangles),
    std::vector<Index>({ static_cast<Index>(mesh.Cells.Corners.size()) - 1 }));
}
