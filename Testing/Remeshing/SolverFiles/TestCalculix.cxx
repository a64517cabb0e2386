// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// CalculiX computes shells of quads that are made of triangles here: the deflections that are known
// of two shells (R. H. MacNeal and R. L. Harder: A proposed standard set of problems to test finite
// element accuracy, 1985; T. Belytschko et al.: Stress projection for membrane and shear locking in
// shell finite elements, 1985), and what is known of materials with two axes.

#include "Remesh.h"
#include "SolverFiles/AbaqusFile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numeric>
#include <sstream>

using namespace DirectionFields;

namespace
{
namespace fs = std::filesystem;
using Place = std::function<Vector3(double, double)>;

/// Triangles over [0, 1]^2, closed across u = 0 if that is wanted, which wind but along the lines
/// u = k / 4 and v = 1/2.
Surface Triangles(int across, int along, bool isClosed, const Place& place)
{
  Surface surface;
  const int columns = isClosed ? across : across + 1;
  for (int j = 0; j <= along; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      const double u = static_cast<double>(i) / across;
      const double v = static_cast<double>(j) / along;
      const double bend = 0.3 * std::pow(std::sin(4.0 * Pi * u) * std::sin(2.0 * Pi * v), 2);
      surface.Points.push_back(place(
        u + bend * std::cos(9.0 * v + 5.0 * u) / across, v + bend * std::sin(7.0 * u) / along));
    }
  }
  for (int j = 0; j < along; ++j)
  {
    for (int i = 0; i < across; ++i)
    {
      const Index a = j * columns + i;
      const Index b = j * columns + (i + 1) % columns;
      surface.Triangles.push_back({ a, b, b + columns });
      surface.Triangles.push_back({ a, b + columns, a + columns });
    }
  }
  return surface;
}

/// Quads with the regions that a function of the triangles' centers divides the surface into.
ShellMesh Quads(Surface surface, Index faces, const std::function<Index(const Vector3&)>& region)
{
  RemeshOptions options;
  options.NumberOfFaces = faces;
  options.PureQuads = true;
  for (const Triangle& t : surface.Triangles)
  {
    options.Regions.push_back(
      region((surface.Points[t[0]] + surface.Points[t[1]] + surface.Points[t[2]]) / 3.0));
  }
  const RemeshResult result =
    Remesh(std::make_shared<Surface>(std::move(surface))).Compute(options);
  EXPECT_EQ(result.Triangles, 0);
  EXPECT_NEAR(result.RegionsShown.BordersKept, 1.0, 1e-6);
  ShellMesh mesh;
  mesh.Points = result.Points;
  mesh.Faces = result.Faces;
  for (std::size_t f = 0; f < mesh.Faces.size(); ++f)
  {
    const auto r = static_cast<std::size_t>(result.Regions[f]);
    while (mesh.FaceSets.size() <= r)
    {
      mesh.FaceSets.push_back({ "Part " + std::to_string(mesh.FaceSets.size()), {} });
    }
    mesh.FaceSets[r].Members.push_back(static_cast<Index>(f));
  }
  return mesh;
}

std::vector<Index> PointsWhere(
  const ShellMesh& mesh, const std::function<bool(const Vector3&)>& holds)
{
  std::vector<Index> points;
  for (std::size_t p = 0; p < mesh.Points.size(); ++p)
  {
    if (holds(mesh.Points[p]))
    {
      points.push_back(static_cast<Index>(p));
    }
  }
  return points;
}

/// The one vertex at a place, which a corner of regions has to be.
NamedSet Vertex(const char* name, const ShellMesh& mesh, const Vector3& place, double tolerance)
{
  const std::vector<Index> found =
    PointsWhere(mesh, [&](const Vector3& p) { return (p - place).norm() < tolerance; });
  EXPECT_EQ(found.size(), 1U) << name;
  return { name, found };
}

/// Runs CalculiX, and returns the displacements that it prints.
std::vector<Vector3> Displacements(const std::string& name, const ShellMesh& mesh,
  const AbaqusOptions& options, const std::string& elastic, const std::string& step)
{
  const fs::path folder = fs::path(DIRECTIONFIELDS_CALCULIX_FOLDER) / name;
  fs::create_directories(folder);
  WriteAbaqus((folder / "mesh.inp").string(), mesh, options);
  std::ofstream deck(folder / "run.inp");
  deck << "*INCLUDE, INPUT=mesh.inp\n";
  for (std::size_t s = 0; s < mesh.FaceSets.size(); ++s)
  {
    deck << "*MATERIAL, NAME=PART_" << s << "\n*ELASTIC" << elastic << "\n*DENSITY\n1.\n";
  }
  deck << step << "*END STEP\n";
  deck.close();
  fs::remove(folder / "run.dat");
  const std::string command = "cd \"" + folder.string() + "\" && OMP_NUM_THREADS=1 \"" +
    DIRECTIONFIELDS_CCX + "\" -i run > run.log 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << "see " << folder / "run.log";
  std::ifstream results(folder / "run.dat");
  std::vector<Vector3> displacements;
  std::string line;
  while (std::getline(results, line))
  {
    std::istringstream words(line);
    int node = 0;
    Vector3 u;
    if (words >> node >> u.x() >> u.y() >> u.z())
    {
      displacements.push_back(u);
    }
  }
  EXPECT_FALSE(displacements.empty()) << "see " << folder / "run.log";
  return displacements;
}
}

TEST(Calculix, PinchedCylinderWithDiaphragmsIsBentAsPublished)
{
  constexpr double radius = 300.0;
  constexpr double length = 600.0;
  ShellMesh mesh = Quads(Triangles(96, 48, true,
                           [](double u, double v) {
                             return Vector3(radius * std::sin(2.0 * Pi * u), length * v,
                               radius * std::cos(2.0 * Pi * u));
                           }),
    2000, [](const Vector3& p) { return (p.x() > 0.0 ? 1 : 0) + (p.y() > 0.5 * length ? 2 : 0); });
  mesh.PointSets = {
    { "Diaphragms",
      PointsWhere(mesh, [](const Vector3& p) { return p.y() < 1e-6 || p.y() > length - 1e-6; }) },
    Vertex("Top", mesh, { 0.0, 0.5 * length, radius }, 1e-3 * radius),
    Vertex("Bottom", mesh, { 0.0, 0.5 * length, -radius }, 1e-3 * radius),
    Vertex("End", mesh, { 0.0, 0.0, radius }, 1e-3 * radius)
  };
  AbaqusOptions options;
  options.SecondOrder = true;
  options.Thickness = 3.0;
  const std::vector<Vector3> moved = Displacements("Cylinder", mesh, options, "\n3e6, .3",
    "*BOUNDARY\nDIAPHRAGMS, 1\nDIAPHRAGMS, 3\nEND, 2\n*STEP\n*STATIC\n*CLOAD\nTOP, 3, -1.\n"
    "BOTTOM, 3, 1.\n*NODE PRINT, NSET=TOP\nU\n*NODE PRINT, NSET=BOTTOM\nU\n");
  ASSERT_EQ(moved.size(), 2U);
  constexpr double published = 1.8248e-5;
  EXPECT_NEAR(-moved[0].z() / published, 1.0, 0.02);
  EXPECT_NEAR(moved[1].z() / published, 1.0, 0.02);
}

TEST(Calculix, ScordelisLoRoofIsBentAsPublished)
{
  constexpr double radius = 25.0;
  constexpr double length = 50.0;
  constexpr double half = 40.0 * Pi / 180.0;
  ShellMesh mesh =
    Quads(Triangles(40, 40, false,
            [](double u, double v)
            {
              const double angle = (2.0 * u - 1.0) * half;
              return Vector3(radius * std::sin(angle), length * v, radius * std::cos(angle));
            }),
      1000, [](const Vector3& p) { return p.y() > 0.5 * length ? 1 : 0; });
  const Vector3 edge(radius * std::sin(half), 0.5 * length, radius * std::cos(half));
  mesh.PointSets = {
    { "Diaphragms",
      PointsWhere(mesh, [](const Vector3& p) { return p.y() < 1e-6 || p.y() > length - 1e-6; }) },
    Vertex("Edge", mesh, edge, 1e-3 * radius),
    Vertex("Corner", mesh, edge - Vector3(0.0, 0.5 * length, 0.0), 1e-6 * radius)
  };
  AbaqusOptions options;
  options.Thickness = 0.25;
  // 90 per area.
  const std::vector<Vector3> moved = Displacements("Roof", mesh, options, "\n4.32e8, 0.",
    "*BOUNDARY\nDIAPHRAGMS, 1\nDIAPHRAGMS, 3\nCORNER, 2\n*STEP\n*STATIC\n*DLOAD\n"
    "EALL, GRAV, 360., 0., 0., -1.\n*NODE PRINT, NSET=EDGE\nU\n");
  ASSERT_EQ(moved.size(), 1U);
  EXPECT_NEAR(-moved[0].z() / 0.3024, 1.0, 0.02);
}

// A plate with simply supported sides, by Navier's series of sines; the load and what is looked at
// are at given points, whose sets the mesh names.
TEST(Calculix, PlateIsBentByALoadAtAGivenPointAsTheSeriesSays)
{
  const std::vector<Vector3> given = { { 0.37, 0.58, 0.0 }, { 0.71, 0.33, 0.0 } };
  const auto plate =
    Triangles(24, 24, false, [](double u, double v) { return Vector3(u, v, 0.0); });
  RemeshOptions wanted;
  wanted.NumberOfFaces = 900;
  wanted.PureQuads = true;
  const RemeshResult result = Remesh(std::make_shared<Surface>(plate), {}, given).Compute(wanted);
  ShellMesh mesh;
  mesh.Points = result.Points;
  mesh.Faces = result.Faces;
  mesh.FaceSets.push_back({ "Part 0", std::vector<Index>(mesh.Faces.size()) });
  std::iota(mesh.FaceSets[0].Members.begin(), mesh.FaceSets[0].Members.end(), 0);
  for (const MeshChain& chain : result.Chains)
  {
    mesh.PointSets.push_back({ chain.Name, chain.Points });
  }
  ASSERT_EQ(mesh.PointSets.size(), 6U);
  AbaqusOptions options;
  options.SecondOrder = true;
  options.Thickness = 0.005;
  const std::vector<Vector3> moved = Displacements("Plate", mesh, options, "\n1e6, .3",
    "*BOUNDARY\nBOUNDARY_1, 3\nBOUNDARY_2, 3\nBOUNDARY_3, 3\nBOUNDARY_4, 3\nPOINT_0, 1, 2\n"
    "POINT_1, 2\n*STEP\n*STATIC\n*CLOAD\nPOINT_0, 3, 1e-3\n*NODE PRINT, NSET=POINT_0\nU\n"
    "*NODE PRINT, NSET=POINT_1\nU\n");
  ASSERT_EQ(moved.size(), 2U);
  const double stiffness = 1e6 * std::pow(options.Thickness, 3) / (12.0 * (1.0 - 0.3 * 0.3));
  for (std::size_t k = 0; k < 2; ++k)
  {
    double series = 0.0;
    for (int m = 1; m < 200; ++m)
    {
      for (int n = 1; n < 200; ++n)
      {
        series += std::sin(m * Pi * given[0].x()) * std::sin(n * Pi * given[0].y()) *
          std::sin(m * Pi * given[k].x()) * std::sin(n * Pi * given[k].y()) /
          std::pow(m * m + n * n, 2);
      }
    }
    const double bent = 4.0 * 1e-3 / (std::pow(Pi, 4) * stiffness) * series;
    EXPECT_NEAR(moved[k].z() / bent, 1.0, 0.02) << k;
  }
}

// A strip in tension gets longer by length * stress / E of the axis along it.
TEST(Calculix, MaterialsAreStiffAlongTheDirections)
{
  for (const double angle : { 0.0, 0.5 * Pi })
  {
    ShellMesh mesh = Quads(
      Triangles(8, 8, false, [](double u, double v) { return Vector3(4.0 * u, 2.0 * v, 0.0); }), 30,
      [](const Vector3&) { return 0; });
    mesh.Directions.assign(mesh.Faces.size(), Vector3(std::cos(angle), std::sin(angle), 0.0));
    const auto at = [&](const char* name, double x, double least, double most)
    {
      return NamedSet{ name,
        PointsWhere(mesh,
          [&](const Vector3& p)
          { return std::abs(p.x() - x) < 1e-6 && p.y() > least - 1e-6 && p.y() < most + 1e-6; }) };
    };
    mesh.PointSets = { at("Left", 0.0, 0.0, 2.0), at("Right", 4.0, 0.0, 2.0),
      at("Low", 0.0, 0.0, 0.0), at("High", 0.0, 2.0, 2.0), at("Far", 4.0, 0.0, 0.0) };
    AbaqusOptions options;
    options.Thickness = 0.1;
    const std::vector<Vector3> moved = Displacements(
      "Strip", mesh, options,
      ", TYPE=ENGINEERING CONSTANTS\n1000., 10., 10., 0., 0., 0., 5., 5.,\n5.",
      "*BOUNDARY\nLEFT, 1\nLOW, 2, 3\nHIGH, 3\nFAR, 3\n*EQUATION\n" +
        [&mesh]
        {
          // The right end stays straight, so that one force stretches all of it.
          std::ostringstream text;
          const std::vector<Index>& right = mesh.PointSets[1].Members;
          for (const Index p : right)
          {
            if (p != mesh.PointSets[4].Members[0])
            {
              text << "2\n"
                   << p + 1 << ", 1, 1., " << mesh.PointSets[4].Members[0] + 1 << ", 1, -1.\n";
            }
          }
          return text.str();
        }() +
        "*STEP\n*STATIC\n*CLOAD\nFAR, 1, 2.\n*NODE PRINT, NSET=RIGHT\nU\n");
    const double wanted = 4.0 * 2.0 / (2.0 * 0.1) / (angle == 0.0 ? 1000.0 : 10.0);
    for (const Vector3& u : moved)
    {
      EXPECT_NEAR(u.x() / wanted, 1.0, 1e-4) << angle;
    }
  }
}
