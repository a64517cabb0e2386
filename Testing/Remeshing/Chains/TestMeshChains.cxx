// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Chains/MeshChains.h"
#include "Remesh.h"

#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <functional>
#include <map>
#include <set>

using namespace DirectionFields;

namespace
{
using Label = std::function<Index(const Vector3&)>;

RemeshResult Remeshed(const Surface& surface, Index faces, const Label& label = {},
  const std::vector<std::string>& names = {}, bool keepsFeatures = true, bool keepsSoft = true)
{
  RemeshOptions options;
  options.NumberOfFaces = faces;
  options.KeepFeatures = keepsFeatures;
  options.KeepSoftFeatures = keepsSoft;
  options.RegionNames = names;
  for (std::size_t t = 0; label && t < surface.Triangles.size(); ++t)
  {
    const Triangle& corners = surface.Triangles[t];
    options.Regions.push_back(
      label((surface.Points[corners[0]] + surface.Points[corners[1]] + surface.Points[corners[2]]) /
        3.0));
  }
  return Remesh(std::make_shared<Surface>(surface)).Compute(options);
}

std::vector<std::string> NamesOf(const RemeshResult& mesh)
{
  std::vector<std::string> names;
  for (const MeshChain& chain : mesh.Chains)
  {
    names.push_back(chain.Name);
  }
  return names;
}

Vector3 Middle(const RemeshResult& mesh, const std::string& name)
{
  Vector3 sum = Vector3::Zero();
  double length = 0.0;
  for (const MeshChain& chain : mesh.Chains)
  {
    for (std::size_t i = 1; chain.Name == name && i < chain.Points.size(); ++i)
    {
      const Vector3& a = mesh.Points[chain.Points[i - 1]];
      const Vector3& b = mesh.Points[chain.Points[i]];
      sum += 0.5 * (b - a).norm() * (a + b);
      length += (b - a).norm();
    }
  }
  return sum / length;
}

/// How many faces, and of how many regions, are at each edge.
struct EdgeFaces
{
  Index Count = 0;
  std::set<Index> Regions;
};
std::map<std::array<Index, 2>, EdgeFaces> EdgesOf(const RemeshResult& mesh)
{
  std::map<std::array<Index, 2>, EdgeFaces> edges;
  for (std::size_t f = 0; f < mesh.Faces.size(); ++f)
  {
    const int size = mesh.Faces[f][3] == None ? 3 : 4;
    for (int c = 0; c < size; ++c)
    {
      const auto ends = std::minmax(mesh.Faces[f][c], mesh.Faces[f][(c + 1) % size]);
      EdgeFaces& edge = edges[{ ends.first, ends.second }];
      ++edge.Count;
      edge.Regions.insert(mesh.Regions.empty() ? None : mesh.Regions[f]);
    }
  }
  return edges;
}

/// Each boundary edge and each border edge is in the one chain of its kind and regions, and all
/// edges of chains are edges of the mesh. Returns the number of those that are features.
Index CheckEdges(const RemeshResult& mesh)
{
  const auto edges = EdgesOf(mesh);
  std::map<std::array<Index, 2>, const MeshChain*> chainOf;
  Index features = 0;
  for (const MeshChain& chain : mesh.Chains)
  {
    for (std::size_t i = 1; i < chain.Points.size(); ++i)
    {
      const auto ends = std::minmax(chain.Points[i - 1], chain.Points[i]);
      EXPECT_TRUE(chainOf.emplace(std::array<Index, 2>{ ends.first, ends.second }, &chain).second);
      EXPECT_EQ(edges.count({ ends.first, ends.second }), 1U) << chain.Name;
      features += chain.Kind == ChainKind::Feature ? 1 : 0;
    }
  }
  for (const auto& [ends, edge] : edges)
  {
    const bool isBoundary = edge.Count == 1;
    const bool isBorder = edge.Regions.size() > 1;
    const auto found = chainOf.find(ends);
    if (isBoundary || isBorder)
    {
      EXPECT_TRUE(found != chainOf.end());
      EXPECT_EQ(found->second->Kind, isBoundary ? ChainKind::Boundary : ChainKind::Border);
      const std::array<Index, 2> beside = isBoundary
        ? std::array<Index, 2>{ None, *edge.Regions.begin() }
        : std::array<Index, 2>{ *edge.Regions.begin(), *edge.Regions.rbegin() };
      EXPECT_EQ(found->second->Regions, beside);
    }
    else if (found != chainOf.end())
    {
      EXPECT_EQ(found->second->Kind, ChainKind::Feature);
    }
  }
  return features;
}
}

TEST(MeshChains, SidesOfASquareAreApart)
{
  const RemeshResult mesh = Remeshed(Meshes::Square(12), 100);
  EXPECT_EQ(NamesOf(mesh),
    (std::vector<std::string>{ "Boundary 1", "Boundary 2", "Boundary 3", "Boundary 4" }));
  EXPECT_EQ(CheckEdges(mesh), 0);
  for (const MeshChain& chain : mesh.Chains)
  {
    EXPECT_NE(chain.Points.front(), chain.Points.back());
    EXPECT_LT((Middle(mesh, chain.Name) -
                0.5 * (mesh.Points[chain.Points.front()] + mesh.Points[chain.Points.back()]))
                .norm(),
      1e-9);
  }
}

TEST(MeshChains, NamesStayTheSameForOtherSizesOfFaces)
{
  // Soft features are others where faces are too large for them.
  const RemeshResult coarse = Remeshed(Meshes::ChamferedCube(8), 500, {}, {}, true, false);
  const RemeshResult fine = Remeshed(Meshes::ChamferedCube(8), 2300, {}, {}, true, false);
  ASSERT_EQ(NamesOf(coarse), NamesOf(fine));
  // The edges of six faces, and at each corner those of a triangle.
  EXPECT_EQ(coarse.Chains.size(), 6U * 4U);
  for (const MeshChain& chain : coarse.Chains)
  {
    EXPECT_LT((Middle(coarse, chain.Name) - Middle(fine, chain.Name)).norm(), 0.02) << chain.Name;
  }
}

TEST(MeshChains, EdgesOfACubeAreFeaturesUnlessTheyAreNotKept)
{
  const Surface cube = Meshes::FlatlySubdivided(Meshes::Cube(), 3);
  const RemeshResult mesh = Remeshed(cube, 600);
  EXPECT_EQ(mesh.Chains.size(), 12U);
  EXPECT_GT(CheckEdges(mesh), 60);
  EXPECT_EQ(mesh.Chains[11].Name, "Feature 12");
  EXPECT_TRUE(Remeshed(cube, 600, {}, {}, false).Chains.empty());
}

TEST(MeshChains, BordersAreBetweenRegionsAndEndWhereTheseMeet)
{
  // Four quarters.
  const RemeshResult mesh = Remeshed(Meshes::Square(16), 256,
    [](const Vector3& p) { return (p.x() > 0.5 ? 1 : 0) + (p.y() > 0.5 ? 2 : 0); },
    { "10", "\"steel\"", "30", "\"glass fibre\"" });
  const std::vector<std::string> names = NamesOf(mesh);
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()),
    (std::set<std::string>{ "Boundary 10 1", "Boundary 10 2", "Boundary steel 1",
      "Boundary steel 2", "Boundary 30 1", "Boundary 30 2", "Boundary glass fibre 1",
      "Boundary glass fibre 2", "Border 10/steel 1", "Border 10/30 1", "Border steel/glass fibre 1",
      "Border 30/glass fibre 1" }));
  EXPECT_EQ(names.size(), 12U);
  EXPECT_EQ(CheckEdges(mesh), 0);
  EXPECT_LT((Middle(mesh, "Border 10/steel 1") - Vector3(0.5, 0.25, 0.0)).norm(), 1e-9);
}

TEST(MeshChains, ClosedOnesEndWhereTheyBegin)
{
  const RemeshResult mesh = Remeshed(
    Meshes::Cylinder(40, 20, 2.0), 300, [](const Vector3& p) { return p.z() > 1.0 ? 1 : 0; });
  std::size_t closed = 0;
  for (const MeshChain& chain : mesh.Chains)
  {
    closed += chain.Points.front() == chain.Points.back() ? 1 : 0;
  }
  EXPECT_EQ(closed, 3U);
  EXPECT_EQ(mesh.Chains.size(), 3U);
  EXPECT_EQ(CheckEdges(mesh), 0);
}

// A one-sided surface is cut open for its map; that cut is none of its lines.
TEST(MeshChains, CutsOfOneSidedSurfacesAreNoFeatures)
{
  const RemeshResult mesh = Remeshed(Meshes::MoebiusStrip(60, 6), 300);
  EXPECT_EQ(NamesOf(mesh), std::vector<std::string>{ "Boundary 1" });
  CheckEdges(mesh);
  // Its bends are sharp for faces of this size.
  EXPECT_TRUE(Remeshed(Meshes::KleinBottle(40, 24), 300, {}, {}, false).Chains.empty());
}

// Three sheets at an edge.
TEST(MeshChains, EdgesOfThreeFacesAreFeatures)
{
  Surface sheets = Meshes::Square(8);
  const Surface square = Meshes::Square(8);
  std::vector<Index> number;
  for (const Vector3& p : square.Points)
  {
    // The third sheet stands on the line x = 1/2.
    const Vector3 place(0.5, p.y(), p.x());
    Index found = None;
    for (std::size_t q = 0; q < square.Points.size(); ++q)
    {
      found = (square.Points[q] - place).norm() < 1e-12 ? static_cast<Index>(q) : found;
    }
    number.push_back(found == None ? static_cast<Index>(sheets.Points.size()) : found);
    if (found == None)
    {
      sheets.Points.push_back(place);
    }
  }
  for (const Triangle& t : square.Triangles)
  {
    sheets.Triangles.push_back({ number[t[0]], number[t[1]], number[t[2]] });
  }
  const RemeshResult mesh = Remeshed(sheets, 150);
  const auto edges = EdgesOf(mesh);
  Index meeting = 0;
  for (const auto& entry : edges)
  {
    meeting += entry.second.Count > 2 ? 1 : 0;
  }
  EXPECT_GT(meeting, 3);
  EXPECT_EQ(CheckEdges(mesh), meeting);
  std::size_t features = 0;
  for (const MeshChain& chain : mesh.Chains)
  {
    features += chain.Kind == ChainKind::Feature ? 1 : 0;
  }
  EXPECT_EQ(features, 1U);
}

// The second region, or the faces at a boundary, are left of the way.
TEST(MeshChains, RunWithTheSecondRegionOnTheLeft)
{
  for (const bool isSwapped : { false, true })
  {
    const RemeshResult mesh = Remeshed(Meshes::Square(16), 256,
      [&](const Vector3& p) { return (p.x() > 0.5) != isSwapped ? 1 : 0; });
    std::map<std::array<Index, 2>, Index> regionLeftOf;
    for (std::size_t f = 0; f < mesh.Faces.size(); ++f)
    {
      const int size = mesh.Faces[f][3] == None ? 3 : 4;
      for (int c = 0; c < size; ++c)
      {
        regionLeftOf[{ mesh.Faces[f][c], mesh.Faces[f][(c + 1) % size] }] = mesh.Regions[f];
      }
    }
    std::size_t borders = 0;
    for (const MeshChain& chain : mesh.Chains)
    {
      borders += chain.Kind == ChainKind::Border ? 1 : 0;
      for (std::size_t i = 1; i < chain.Points.size(); ++i)
      {
        const auto left = regionLeftOf.find({ chain.Points[i - 1], chain.Points[i] });
        ASSERT_TRUE(left != regionLeftOf.end()) << chain.Name;
        EXPECT_EQ(left->second, chain.Regions[1]) << chain.Name;
      }
    }
    EXPECT_EQ(borders, 1U);
  }
}

namespace
{
/// Triangles around a point, every other one of another region.
Internal::FaceMesh Hub(Index valence)
{
  Internal::FaceMesh mesh;
  mesh.Points.push_back(Vector3::Zero());
  for (Index k = 0; k < valence; ++k)
  {
    const double angle = 2.0 * Pi * k / valence;
    mesh.Points.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    mesh.Cells.Corners.push_back({ 0, 1 + k, 1 + (k + 1) % valence, None });
  }
  mesh.Vertices.resize(mesh.Points.size());
  return mesh;
}

std::vector<MeshChain> ChainsOfHub(const Internal::FaceMesh& mesh)
{
  std::vector<Index> regions;
  for (std::size_t f = 0; f < mesh.Cells.Corners.size(); ++f)
  {
    regions.push_back(static_cast<Index>(f % 2));
  }
  return Internal::FindChains(mesh, { 0 }, {}, regions, {});
}
}

// By the square of the valence it would be 256 times.
TEST(MeshChains, TimeAtAHubGrowsByItsValence)
{
  const std::array<Internal::FaceMesh, 2> hubs = { Hub(2000), Hub(32000) };
  const std::vector<MeshChain> chains = ChainsOfHub(hubs[0]);
  EXPECT_EQ(std::count_if(chains.begin(), chains.end(),
              [](const MeshChain& chain) { return chain.Kind == ChainKind::Border; }),
    2000);
  EXPECT_EQ(chains.size(), 4000U);
  std::array<double, 2> time = { HUGE_VAL, HUGE_VAL };
  for (int k = 0; k < 6; ++k)
  {
    const std::clock_t begin = std::clock();
    ChainsOfHub(hubs[k % 2]);
    time[k % 2] = std::min(time[k % 2], static_cast<double>(std::clock() - begin));
  }
  EXPECT_LT(time[1], 80.0 * time[0]);
}
