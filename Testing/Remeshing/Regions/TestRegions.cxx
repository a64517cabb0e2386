// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remesh.h"

#include "Meshes/Remeshed.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <set>

using namespace DirectionFields;

namespace
{
std::vector<Index> Labelled(
  const Surface& surface, const std::function<Index(const Vector3&)>& label)
{
  std::vector<Index> regions;
  for (const Triangle& t : surface.Triangles)
  {
    regions.push_back(
      label((surface.Points[t[0]] + surface.Points[t[1]] + surface.Points[t[2]]) / 3.0));
  }
  return regions;
}

/// The same number of triangles in each region, one after the other.
std::vector<Index> InTurn(const Surface& surface, std::size_t triangles)
{
  std::vector<Index> regions;
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    regions.push_back(static_cast<Index>(t / triangles));
  }
  return regions;
}

RemeshResult Remeshed(const Surface& surface, const std::vector<Index>& regions, Index faces,
  RemeshOptions options = {})
{
  options.NumberOfFaces = faces;
  options.Regions = regions;
  return Remesh(std::make_shared<Surface>(surface)).Compute(options);
}

RemeshOptions PureQuads()
{
  RemeshOptions options;
  options.PureQuads = true;
  return options;
}

/// The vertices with faces of at least this number of regions.
Index CountMeetings(const RemeshResult& mesh, std::size_t least)
{
  std::vector<std::set<Index>> at(mesh.Points.size());
  for (std::size_t f = 0; f < mesh.Faces.size(); ++f)
  {
    for (const Index v : mesh.Faces[f])
    {
      if (v != None)
      {
        at[v].insert(mesh.Regions[f]);
      }
    }
  }
  return static_cast<Index>(std::count_if(
    at.begin(), at.end(), [&](const std::set<Index>& own) { return own.size() >= least; }));
}

/// Everything that holds for a mesh of regions with room for their faces.
void ExpectAllKept(const RemeshResult& mesh, const Surface& surface,
  const std::vector<Index>& regions, double areaError)
{
  EXPECT_EQ(Meshes::FlawOf(mesh), "");
  EXPECT_GT(Meshes::LeastQuality(mesh), 0.5);
  EXPECT_TRUE(mesh.RegionsShown.Lost.empty());
  EXPECT_GT(mesh.RegionsShown.BordersKept, 1.0 - 1e-9);
  EXPECT_EQ(mesh.RegionsShown.MissedCorners, 0);
  EXPECT_EQ(mesh.RegionsShown.Stairs, 0.0);
  ASSERT_EQ(mesh.Regions.size(), mesh.Faces.size());
  std::map<Index, double> wanted;
  std::map<Index, double> found;
  for (std::size_t t = 0; t < regions.size(); ++t)
  {
    const Triangle& p = surface.Triangles[t];
    wanted[regions[t]] += 0.5 *
      (surface.Points[p[1]] - surface.Points[p[0]])
        .cross(surface.Points[p[2]] - surface.Points[p[0]])
        .norm();
  }
  for (std::size_t f = 0; f < mesh.Faces.size(); ++f)
  {
    EXPECT_EQ(mesh.Regions[f], regions[mesh.FaceSource[f]]);
    const std::array<Index, 4>& p = mesh.Faces[f];
    const Vector3& last = mesh.Points[p[3] == None ? p[0] : p[3]];
    found[mesh.Regions[f]] +=
      0.5 * (mesh.Points[p[2]] - mesh.Points[p[0]]).cross(last - mesh.Points[p[1]]).norm();
  }
  ASSERT_EQ(found.size(), wanted.size());
  for (const auto& [region, area] : wanted)
  {
    EXPECT_NEAR(found[region], area, areaError * area) << region;
  }
}
}

TEST(Regions, ProgressGoesOnWhileLinesAreBroughtCloser)
{
  const Surface square = Meshes::Square(30);
  RemeshOptions options;
  options.NumberOfFaces = 500;
  options.Regions = Labelled(square,
    [](const Vector3& middle) { return (middle - Vector3(0.5, 0.5, 0.0)).norm() < 0.2 ? 1 : 0; });
  for (const bool isPure : { false, true })
  {
    options.PureQuads = isPure;
    std::map<double, int> reports;
    Remesh(std::make_shared<Surface>(square))
      .Compute(options, {},
        [&reports](double done)
        {
          ++reports[done];
          return true;
        });
    const auto most = std::max_element(reports.begin(), reports.end(),
      [](const auto& a, const auto& b) { return a.second < b.second; });
    EXPECT_LT(most->second, 10) << most->first;
  }
}

TEST(Regions, CurvedBordersAreEdgesAndTheirMeetingsVertices)
{
  // Great circles divide the sphere into the faces of an icosahedron, five of which meet at a point.
  const Surface sphere = Meshes::Icosphere(4);
  const std::vector<Index> regions = InTurn(sphere, 256);
  for (const RemeshOptions& options : { RemeshOptions(), PureQuads() })
  {
    const RemeshResult mesh = Remeshed(sphere, regions, 3000, options);
    ExpectAllKept(mesh, sphere, regions, 0.005);
    EXPECT_EQ(mesh.Triangles, 0);
    EXPECT_EQ(CountMeetings(mesh, 5), 12);
    // Twelve places of five edges, and one in each of the triangles, where three sectors meet.
    EXPECT_EQ(mesh.IrregularVertices, 32);
  }
}

TEST(Regions, FlatRegionsAreKeptWhateverTheFeaturesAre)
{
  RemeshOptions options;
  options.KeepFeatures = false;
  const Surface disk = Meshes::Disk(24);
  // Three sectors, and around them a ring.
  const auto label = [](const Vector3& p)
  {
    const double turn = 3.0 * (std::atan2(p[1], p[0]) / (2.0 * Pi) + 1.0);
    return p.norm() > 0.5 ? 3 : static_cast<Index>(turn) % 3;
  };
  const std::vector<Index> regions = Labelled(disk, label);
  const RemeshResult mesh = Remeshed(disk, regions, 1000, options);
  ExpectAllKept(mesh, disk, regions, 0.01);
  // The middle, and the ends of the sectors' sides.
  EXPECT_EQ(CountMeetings(mesh, 3), 4);
}

TEST(Regions, BandsAreClosedRowsOfFaces)
{
  const Surface torus = Meshes::Torus(64, 32);
  const std::vector<Index> regions = InTurn(torus, 64 * 8);
  const RemeshResult mesh = Remeshed(torus, regions, 2000);
  ExpectAllKept(mesh, torus, regions, 0.01);
  EXPECT_EQ(mesh.IrregularVertices, 0);
}

TEST(Regions, EdgesAroundSmallHolesAreAsCloseToThem)
{
  struct Case
  {
    double Radius;
    Index Sides;
    Index Faces;
  };
  // Radii of one to eight edges.
  const std::array<Case, 6> holes = { Case{ 0.05, 24, 2400 }, Case{ 0.1, 24, 800 },
    Case{ 0.1, 24, 1200 }, Case{ 0.1, 48, 2400 }, Case{ 0.2, 48, 800 }, Case{ 0.3, 24, 2400 } };
  for (const Case& hole : holes)
  {
    const double radius = hole.Radius;
    const Surface plate = Meshes::PlateWithHole(96, hole.Sides, radius, false);
    const std::vector<Index> regions =
      Labelled(plate, [](const Vector3& p) { return p[1] > 0.0 ? 1 : 0; });
    const RemeshResult mesh = Remeshed(plate, regions, hole.Faces);
    EXPECT_EQ(Meshes::FlawOf(mesh), "");
    Index around = 0;
    double most = 0.0;
    for (const std::array<Index, 4>& face : mesh.Faces)
    {
      const int size = face[3] == None ? 3 : 4;
      for (int c = 0; c < size; ++c)
      {
        const Vector3& a = mesh.Points[face[c]];
        const Vector3& b = mesh.Points[face[(c + 1) % size]];
        if (std::max(a.norm(), b.norm()) < 1.0001 * radius)
        {
          ++around;
          most = std::max(most, radius - (0.5 * (a + b)).norm());
        }
      }
    }
    EXPECT_LE(most, 0.08 * mesh.EdgeLength) << radius;
    // Vertices around a hole that edges of the wanted length do not need would be paid for by these.
    EXPECT_GT(Meshes::LeastQuality(mesh), 0.5) << radius;
    EXPECT_EQ(mesh.Triangles, 0) << radius;
    // No more than half as many again as even spacing needs, or edges of the wanted length.
    const double needed = Pi / std::acos(1.0 - 0.035 * mesh.EdgeLength / radius);
    EXPECT_LE(around, 1.5 * std::max(needed, 2.0 * Pi * radius / mesh.EdgeLength)) << radius;
  }
}

TEST(Regions, TeesAndIslandsOfASquareAreExact)
{
  const Surface square = Meshes::Square(40);
  const auto label = [](const Vector3& p)
  {
    // An island of one face, which would be too short for a sharp edge.
    const bool isIsland = std::abs(p[0] - 0.725) < 0.02 && std::abs(p[1] - 0.225) < 0.02;
    return isIsland ? 3 : p[1] > 0.5 ? 0 : p[0] > 0.3 ? 1 : 2;
  };
  const std::vector<Index> regions = Labelled(square, label);
  const RemeshResult mesh = Remeshed(square, regions, 400);
  ExpectAllKept(mesh, square, regions, 1e-9);
  EXPECT_EQ(CountMeetings(mesh, 3), 1);
}

TEST(Regions, SheetsThatMeetInALineKeepTheirs)
{
  // Three rectangles of different regions around one edge, which needs no border. The first has
  // nearly all of the area.
  Surface sheets;
  std::vector<Index> regions;
  constexpr int cells = 12;
  for (int k = 0; k < 3; ++k)
  {
    const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(k * 2.0 * Pi / 3.0, Vector3::UnitY()).toRotationMatrix();
    const Eigen::Matrix3d widen = Vector3(k == 0 ? 8.0 : 0.15, 1.0, 1.0).asDiagonal();
    const Surface sheet = Meshes::Transformed(Meshes::Square(cells), turn * widen, Vector3::Zero());
    regions.resize(regions.size() + sheet.Triangles.size(), k);
    sheets = k == 0 ? sheet : Meshes::Joined(sheets, sheet);
  }
  // The points on the edge are the first sheet's for all three.
  const auto perSheet = static_cast<Index>(sheets.Points.size()) / 3;
  for (Triangle& t : sheets.Triangles)
  {
    for (Index& p : t)
    {
      p = std::hypot(sheets.Points[p].x(), sheets.Points[p].z()) < 1e-9 ? p % perSheet : p;
    }
  }
  const RemeshResult mesh = Remeshed(sheets, regions, 830);
  std::map<Index, double> areas;
  for (std::size_t f = 0; f < mesh.Faces.size(); ++f)
  {
    EXPECT_EQ(mesh.Regions[f], regions[mesh.FaceSource[f]]);
    const std::array<Index, 4>& p = mesh.Faces[f];
    areas[mesh.Regions[f]] += 0.5 *
      (mesh.Points[p[2]] - mesh.Points[p[0]]).cross(mesh.Points[p[3]] - mesh.Points[p[1]]).norm();
  }
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_NEAR(areas[k], k == 0 ? 8.0 : 0.15, 1e-6) << k;
  }
}

TEST(Regions, DecimatedSurfacesKeepThem)
{
  const Surface sphere = Meshes::Icosphere(6);
  const std::vector<Index> regions = InTurn(sphere, 4096);
  const RemeshResult mesh = Remeshed(sphere, regions, 1500);
  ExpectAllKept(mesh, sphere, regions, 0.01);
}

TEST(Regions, SizesAndNumbersDoNotMatter)
{
  const Surface sphere = Meshes::Icosphere(3);
  const std::vector<Index> regions = InTurn(sphere, 160);
  const RemeshResult mesh = Remeshed(sphere, regions, 500);
  std::vector<Index> others;
  for (const Index r : regions)
  {
    others.push_back(1000 - 7 * r);
  }
  const RemeshResult other = Remeshed(sphere, others, 500);
  EXPECT_EQ(other.Points, mesh.Points);
  for (std::size_t f = 0; f < mesh.Faces.size(); ++f)
  {
    EXPECT_EQ(other.Regions[f], 1000 - 7 * mesh.Regions[f]);
  }
  const Surface small = Meshes::Transformed(
    sphere, Vector3::Constant(std::ldexp(1.0, -20)).asDiagonal(), Vector3::Zero());
  const RemeshResult tiny = Remeshed(small, regions, 500);
  EXPECT_EQ(tiny.Regions, mesh.Regions);
  EXPECT_EQ(tiny.RegionsShown.BordersKept, mesh.RegionsShown.BordersKept);
}

TEST(Regions, OneRegionIsNone)
{
  const Surface sphere = Meshes::Icosphere(3);
  const RemeshResult mesh = Remeshed(sphere, {}, 500);
  const RemeshResult one = Remeshed(sphere, std::vector<Index>(sphere.Triangles.size(), 5), 500);
  EXPECT_EQ(one.Points, mesh.Points);
  EXPECT_TRUE(mesh.Regions.empty());
  EXPECT_EQ(one.Regions, std::vector<Index>(one.Faces.size(), 5));
}

TEST(Regions, ChangedRegionsOfTheSameSurfaceMakeAnotherMesh)
{
  const Surface square = Meshes::Square(20);
  RemeshOptions options;
  options.NumberOfFaces = 100;
  Remesh remesh(std::make_shared<Surface>(square));
  for (const double border : { 0.25, 0.65 })
  {
    options.Regions = Labelled(square, [&](const Vector3& p) { return p[0] > border ? 1 : 0; });
    ExpectAllKept(remesh.Compute(options), square, options.Regions, 1e-9);
  }
}

TEST(Regions, BordersInStairsAreSaidAndSpoilNothing)
{
  const Surface sphere = Meshes::Icosphere(4);
  const std::vector<Index> wavy = Labelled(sphere,
    [](const Vector3& p) { return p[2] > 0.2 * std::sin(5.0 * std::atan2(p[1], p[0])) ? 1 : 0; });
  std::vector<Index> noise;
  for (std::size_t t = 0; t < sphere.Triangles.size(); ++t)
  {
    noise.push_back(static_cast<Index>((t * 2654435761U >> 7U) % 3));
  }
  const RemeshResult plain = Remeshed(sphere, {}, 800);
  for (const std::vector<Index>& regions : { wavy, noise })
  {
    const RemeshResult mesh = Remeshed(sphere, regions, 800);
    EXPECT_EQ(mesh.Points, plain.Points);
    EXPECT_EQ(mesh.RegionsShown.Stairs, 1.0);
    EXPECT_EQ(mesh.RegionsShown.BordersKept, 0.0);
    EXPECT_GT(mesh.Notes.size(), plain.Notes.size());
    for (std::size_t f = 0; f < mesh.Faces.size(); ++f)
    {
      EXPECT_EQ(mesh.Regions[f], regions[mesh.FaceSource[f]]);
    }
  }
}

TEST(Regions, LostOnesAreNamed)
{
  const Surface sphere = Meshes::Icosphere(4);
  std::vector<Index> regions(sphere.Triangles.size(), 0);
  regions[77] = 1;
  RemeshOptions options;
  options.RegionNames = { "steel", "weld" };
  const RemeshResult mesh = Remeshed(sphere, regions, 500, options);
  EXPECT_EQ(mesh.RegionsShown.Lost, std::vector<Index>{ 1 });
  // Neither its borders nor its corners are complained about a second time.
  ASSERT_EQ(mesh.Notes.size(), 1U);
  EXPECT_EQ(mesh.Notes[0].find("Region weld has no faces"), 0U);
}

TEST(Regions, LostOnesBetweenOthersAreNamedOnce)
{
  const Surface square = Meshes::Square(40);
  const std::vector<Index> regions = Labelled(square,
    [](const Vector3& p)
    {
      const bool isSmall = p.x() > 0.5 && p.x() < 0.6 && p.y() > 0.5 && p.y() < 0.6;
      return isSmall ? 2 : p.x() > 0.5 ? 1 : 0;
    });
  const RemeshResult mesh = Remeshed(square, regions, 5);
  EXPECT_EQ(mesh.RegionsShown.Lost, std::vector<Index>{ 2 });
  EXPECT_GT(mesh.RegionsShown.MissedCorners, 0);
  EXPECT_LT(mesh.RegionsShown.BordersKept, 0.9);
  const auto has = [](const char* words)
  { return [words](const std::string& note) { return note.find(words) != std::string::npos; }; };
  EXPECT_EQ(std::count_if(mesh.Notes.begin(), mesh.Notes.end(), has("egion")), 1);
  EXPECT_EQ(std::count_if(mesh.Notes.begin(), mesh.Notes.end(), has("Region 2 has no faces")), 1);
  EXPECT_EQ(std::count_if(mesh.Notes.begin(), mesh.Notes.end(), has("border")), 0);
}

TEST(Regions, NumbersThatDoNotFitAreRefused)
{
  const auto square = std::make_shared<Surface>(Meshes::Square(2));
  RemeshOptions options;
  options.Regions = { 0, 1 };
  EXPECT_THROW(Remesh(square).Compute(options), std::invalid_argument);
  options.Regions.assign(square->Triangles.size(), 2);
  options.RegionNames = { "a", "b" };
  EXPECT_THROW(Remesh(square).Compute(options), std::invalid_argument);
}
