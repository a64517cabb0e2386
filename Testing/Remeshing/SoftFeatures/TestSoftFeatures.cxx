// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SoftFeatures/SoftFeatures.h"

#include "Geometry/DihedralAngles.h"
#include "Meshes/Remeshed.h"
#include "Meshes/Surfaces.h"
#include "Remesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

namespace
{
double Radians(double degrees)
{
  return degrees / 180.0 * Pi;
}

using Outline = std::vector<std::array<double, 2>>;

void AddQuad(Surface& surface, Index a, Index b, Index c, Index d)
{
  surface.Triangles.push_back({ a, b, c });
  surface.Triangles.push_back({ a, c, d });
}

/// Rings of points, one above the other, with fans of triangles at both ends.
Surface Stacked(const std::vector<std::vector<Vector3>>& rings)
{
  Surface surface;
  const auto around = static_cast<Index>(rings.front().size());
  const auto last = static_cast<Index>(rings.size()) - 1;
  for (const std::vector<Vector3>& ring : rings)
  {
    surface.Points.insert(surface.Points.end(), ring.begin(), ring.end());
  }
  const auto middle = static_cast<Index>(surface.Points.size());
  surface.Points.emplace_back(0.0, 0.0, rings.front().front().z());
  surface.Points.emplace_back(0.0, 0.0, rings.back().front().z());
  for (Index i = 0; i < around; ++i)
  {
    const Index next = (i + 1) % around;
    for (Index k = 0; k < last; ++k)
    {
      AddQuad(
        surface, k * around + i, k * around + next, (k + 1) * around + next, (k + 1) * around + i);
    }
    surface.Triangles.push_back({ middle, next, i });
    surface.Triangles.push_back({ middle + 1, last * around + i, last * around + next });
  }
  return surface;
}

Surface Revolved(const Outline& profile, int sides)
{
  std::vector<std::vector<Vector3>> rings;
  for (const auto& [radius, height] : profile)
  {
    rings.emplace_back();
    for (int i = 0; i < sides; ++i)
    {
      const double angle = 2.0 * Pi * i / sides;
      rings.back().emplace_back(radius * std::cos(angle), radius * std::sin(angle), height);
    }
  }
  return Stacked(rings);
}

Surface Prism(int sides)
{
  return Revolved({ { 1.0, -1.0 }, { 1.0, 1.0 } }, sides);
}

/// A cylinder whose rims are fillets of a few facets.
Surface Can(int facets)
{
  constexpr double fillet = 0.2;
  Outline profile;
  for (const double side : { -1.0, 1.0 })
  {
    for (int k = 0; k <= facets; ++k)
    {
      const double angle = 0.5 * Pi * (side < 0.0 ? k : facets - k) / facets;
      profile.push_back({ 1.0 - fillet + fillet * std::sin(angle),
        side * (1.0 - fillet + fillet * std::cos(angle)) });
    }
  }
  return Revolved(profile, 48);
}

/// A rod with a rectangle for its section, whose corners are fillets of a few facets.
Surface Bar(int facets)
{
  constexpr double fillet = 0.2;
  std::vector<std::vector<Vector3>> rings(2);
  for (int quarter = 0; quarter < 4; ++quarter)
  {
    const double x = (quarter == 0 || quarter == 3 ? 1.0 : -1.0) * (0.5 - fillet);
    const double y = (quarter < 2 ? 1.0 : -1.0) * (0.75 - fillet);
    for (int k = 0; k <= facets; ++k)
    {
      const double angle = 0.5 * Pi * (quarter + static_cast<double>(k) / facets);
      for (int end = 0; end < 2; ++end)
      {
        rings[end].emplace_back(
          x + fillet * std::cos(angle), y + fillet * std::sin(angle), end == 0 ? -2.0 : 2.0);
      }
    }
  }
  return Stacked(rings);
}

/// A roof over a square, bent along the middle by an angle that goes from one value to another.
Surface Roof(double bendAtStart, double bendAtEnd)
{
  constexpr int cells = 16;
  Surface surface = Meshes::Square(cells);
  double left = surface.Points.front().x();
  double right = left;
  for (const Vector3& p : surface.Points)
  {
    left = std::min(left, p.x());
    right = std::max(right, p.x());
  }
  double middle = 0.0;
  for (const Vector3& p : surface.Points)
  {
    middle += p.y() / static_cast<double>(surface.Points.size());
  }
  for (Vector3& p : surface.Points)
  {
    const double part = (p.x() - left) / (right - left);
    const double bend = Radians((1.0 - part) * bendAtStart + part * bendAtEnd);
    p.z() = -std::tan(0.5 * bend) * std::abs(p.y() - middle);
  }
  return surface;
}

constexpr FeatureSettings Usual{ true, DefaultFeatureAngle, DefaultMinimumFeatureLength, 0.0 };

SoftFeatures RimsOf(const SurfaceGeometry& geometry, double face, double room,
  const FeatureSettings& settings = Usual)
{
  return FindSoftFeatures(
    geometry, FindFeatures(geometry, settings), SoftFeatureSettings(settings, face, room));
}

double LengthOf(const SurfaceGeometry& geometry, Index e)
{
  const Index h = geometry.Mesh.HalfEdge(e);
  return (geometry.Positions[geometry.Mesh.Head(h)] - geometry.Positions[geometry.Mesh.Tail(h)])
    .norm();
}

double LengthOf(const SurfaceGeometry& geometry, const std::vector<char>& isRim)
{
  double length = 0.0;
  for (std::size_t e = 0; e < isRim.size(); ++e)
  {
    length += isRim[e] != 0 ? LengthOf(geometry, static_cast<Index>(e)) : 0.0;
  }
  return length;
}

RemeshResult MeshOf(const Surface& surface, RemeshOptions options, bool keepsSoft)
{
  options.KeepSoftFeatures = keepsSoft;
  RemeshResult mesh = Remesh(std::make_shared<Surface>(surface)).Compute(options);
  EXPECT_EQ(Meshes::FlawOf(mesh), "");
  return mesh;
}

RemeshResult MeshOf(const Surface& surface, Index faces, bool keepsSoft = true)
{
  RemeshOptions options;
  options.NumberOfFaces = faces;
  return MeshOf(surface, options, keepsSoft);
}

void ExpectSame(const RemeshResult& a, const RemeshResult& b)
{
  EXPECT_EQ(a.Points, b.Points);
  EXPECT_EQ(a.Faces, b.Faces);
}

/// The edges of a mesh by the first coordinate of their middles.
class EdgesNearby
{
public:
  explicit EdgesNearby(const RemeshResult& mesh)
  {
    for (const auto& face : mesh.Faces)
    {
      const std::size_t count = face[3] == None ? 3 : 4;
      for (std::size_t c = 0; c < count; ++c)
      {
        const Vector3& start = mesh.Points[face[c]];
        const Vector3 along = mesh.Points[face[(c + 1) % count]] - start;
        this->Edges.emplace(start.x() + 0.5 * along.x(), std::make_pair(start, along));
        this->Farthest = std::max(this->Farthest, along.norm());
      }
    }
  }

  /// Whether test(start, along) is true for an edge that is within an edge's length.
  template <typename Test>
  bool Any(const Vector3& place, const Test& test) const
  {
    return std::any_of(this->Edges.lower_bound(place.x() - this->Farthest),
      this->Edges.upper_bound(place.x() + this->Farthest),
      [&](const auto& edge) { return test(edge.second.first, edge.second.second); });
  }

private:
  std::multimap<double, std::pair<Vector3, Vector3>> Edges;
  double Farthest = 0.0;
};

/// Of the length of edges bent by 20 to 40 degrees the part that is within a tenth of an edge of
/// one of the mesh that encloses less than 10 degrees with it.
double PartAlongEdges(const Surface& surface, const RemeshResult& mesh)
{
  constexpr double rounding = 1e-6;
  const EdgesNearby edges(mesh);
  const SurfaceGeometry geometry(surface);
  const std::vector<double> dihedral = DihedralAngles(geometry);
  double length = 0.0;
  double along = 0.0;
  for (Index e = 0; e < geometry.Mesh.GetNumberOfEdges(); ++e)
  {
    const double bend = std::abs(dihedral[e]);
    if (bend < Radians(20.0) - rounding || bend >= Radians(40.0))
    {
      continue;
    }
    const Index h = geometry.Mesh.HalfEdge(e);
    const Vector3& start = geometry.Positions[geometry.Mesh.Tail(h)];
    const Vector3 whole = geometry.Positions[geometry.Mesh.Head(h)] - start;
    const auto pieces = static_cast<int>(std::ceil(5.0 * whole.norm() / mesh.EdgeLength));
    for (int k = 0; k < pieces; ++k)
    {
      const Vector3 place = start + (k + 0.5) / pieces * whole;
      length += whole.norm() / pieces;
      const bool isAlong = edges.Any(place,
        [&](const Vector3& end, const Vector3& own)
        {
          const double part = std::clamp((place - end).dot(own) / own.squaredNorm(), 0.0, 1.0);
          return (end + part * own - place).norm() < 0.1 * mesh.EdgeLength &&
            std::abs(own.dot(whole)) > std::cos(Radians(10.0)) * own.norm() * whole.norm();
        });
      along += isAlong ? whole.norm() / pieces : 0.0;
    }
  }
  return length > 0.0 ? along / length : 1.0;
}

/// A surface of a body whose rims are to be edges: of quads only, and with as many irregular
/// vertices as a cube.
void ExpectAlongRims(const Surface& surface, Index faces)
{
  const RemeshResult mesh = MeshOf(surface, faces);
  EXPECT_GT(PartAlongEdges(surface, mesh), 0.999);
  EXPECT_EQ(mesh.Triangles, 0);
  EXPECT_EQ(mesh.IrregularVertices, 8);
  EXPECT_GT(Meshes::LeastQuality(mesh), 0.3);
  EXPECT_LT(PartAlongEdges(surface, MeshOf(surface, faces, false)), 0.65);
}
}

TEST(SoftFeatures, PrismsHaveLinesOfEdgesAlongTheirSides)
{
  for (const int sides : { 12, 15, 18 })
  {
    ExpectAlongRims(Prism(sides), 1000);
  }
}

TEST(SoftFeatures, CansHaveLinesOfEdgesAlongTheirFillets)
{
  for (const int facets : { 2, 3, 4 })
  {
    ExpectAlongRims(Can(facets), 1500);
  }
}

TEST(SoftFeatures, BarsHaveLinesOfEdgesAlongTheirFillets)
{
  for (const int facets : { 2, 3, 4 })
  {
    ExpectAlongRims(Bar(facets), 1500);
  }
}

TEST(SoftFeatures, RimsThatHaveRoomAreFound)
{
  // The fillet of four facets, each 0.0780 wide, has three rims bent by 22.5 degrees on either side.
  const Surface can = Can(4);
  const SurfaceGeometry geometry(can);
  const double facet = 2.0 * 0.2 * std::sin(Pi / 16.0);
  const double face = 0.1;
  const double all = LengthOf(geometry, RimsOf(geometry, face, 0.9 * facet).IsRim);
  std::vector<double> radii;
  for (int k = 1; k < 4; ++k)
  {
    radii.push_back(0.8 + 0.2 * std::sin(Pi * k / 8.0));
  }
  const double perRadius = 2.0 * 48 * 2.0 * std::sin(Pi / 48.0);
  EXPECT_NEAR(all, perRadius * (radii[0] + radii[1] + radii[2]), 1e-9);
  // Where only some have room these are the outer ones, and then a single one.
  const double outer = LengthOf(geometry, RimsOf(geometry, face, 1.2 * facet).IsRim);
  EXPECT_NEAR(outer, perRadius * (radii[0] + radii[2]), 1e-9);
  const double single = LengthOf(geometry, RimsOf(geometry, face, 2.2 * facet).IsRim);
  EXPECT_LT(single, 0.5 * all);
  EXPECT_GT(single, 0.2 * all);
  EXPECT_TRUE(RimsOf(geometry, face, 2.2 * facet).DependsOnRoom);
}

TEST(SoftFeatures, FeaturesThatFadeAreNotContinued)
{
  const auto lengthOn = [](const Surface& surface)
  {
    const SurfaceGeometry geometry(surface);
    return LengthOf(geometry, RimsOf(geometry, 0.05, 0.025).IsRim);
  };
  const double whole = lengthOn(Roof(30.0, 30.0));
  EXPECT_GT(whole, 0.0);
  EXPECT_EQ(lengthOn(Roof(60.0, 0.0)), 0.0);
  // Bent too little, and as much as features are.
  EXPECT_EQ(lengthOn(Roof(19.0, 19.0)), 0.0);
  EXPECT_EQ(lengthOn(Roof(41.0, 41.0)), 0.0);
}

TEST(SoftFeatures, AngularAndRoughSurfacesHaveNone)
{
  for (const Surface& surface : { Meshes::Cube(), Meshes::Icosphere(1), Meshes::Icosphere(3),
         Meshes::Roughened(Meshes::Icosphere(3), 0.3, 5), Meshes::Octahedron() })
  {
    const SurfaceGeometry geometry(surface);
    EXPECT_TRUE(RimsOf(geometry, 0.1, 0.05).IsRim.empty());
    ExpectSame(MeshOf(surface, 300, true), MeshOf(surface, 300, false));
  }
}

TEST(SoftFeatures, TheFeatureAngleSaysWhatIsSoft)
{
  const Surface bar = Bar(3);
  const SurfaceGeometry geometry(bar);
  // The rims are bent by 30 degrees, and beside planes by 15.
  for (const double angle : { 0.0, 14.0, 91.0, 180.0 })
  {
    const FeatureSettings settings{ true, angle, 0.0, 0.0 };
    EXPECT_FALSE(SoftFeatureSettings(settings, 0.1, 0.05).AreKept());
    RemeshOptions options;
    options.NumberOfFaces = 500;
    options.FeatureAngle = angle;
    ExpectSame(MeshOf(bar, options, true), MeshOf(bar, options, false));
  }
  const auto lengthAt = [&](double angle) {
    return LengthOf(geometry, RimsOf(geometry, 0.1, 0.05, { true, angle, 0.0, 0.0 }).IsRim);
  };
  EXPECT_NEAR(lengthAt(40.0), 8 * 4.0, 1e-9);
  EXPECT_EQ(lengthAt(61.0), 0.0);
  EXPECT_NEAR(lengthAt(29.0), 8 * 4.0, 1e-9);
  EXPECT_FALSE(SoftFeatureSettings({ false, 40.0, 0.0, 0.0 }, 0.1, 0.05).AreKept());
}

TEST(SoftFeatures, AMeshIsNotWorseForThem)
{
  for (const Index faces : { 300, 500 })
  {
    for (const Surface& surface : { Bar(4), Can(4), Prism(17) })
    {
      const RemeshResult with = MeshOf(surface, faces, true);
      const RemeshResult without = MeshOf(surface, faces, false);
      EXPECT_LE(with.Triangles, without.Triangles) << faces;
      EXPECT_GE(Meshes::LeastQuality(with), std::min(0.28, Meshes::LeastQuality(without) - 0.021));
    }
  }
}

TEST(SoftFeatures, AMesherThatWasUsedBeforeGivesTheSame)
{
  const auto bar = std::make_shared<Surface>(Bar(4));
  Remesh mesher(bar);
  RemeshOptions options;
  for (const Index faces : { 800, 200, 250, 800 })
  {
    options.NumberOfFaces = faces;
    ExpectSame(mesher.Compute(options), Remesh(bar).Compute(options));
  }
  options.FeatureAngle = 50.0;
  ExpectSame(mesher.Compute(options), Remesh(bar).Compute(options));
  options.KeepSoftFeatures = false;
  ExpectSame(mesher.Compute(options), Remesh(bar).Compute(options));
  options.KeepSoftFeatures = true;
  options.NumberOfThreads = 1;
  const RemeshResult one = mesher.Compute(options);
  options.NumberOfThreads = 3;
  ExpectSame(Remesh(bar).Compute(options), one);
}
