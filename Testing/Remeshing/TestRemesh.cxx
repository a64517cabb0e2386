// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remesh.h"

#include "Meshes/Remeshed.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace DirectionFields;

namespace
{
RemeshResult Remeshed(
  const Surface& surface, Index faces, Element element = Element::Quads, int smoothing = 12)
{
  RemeshOptions options;
  options.NumberOfFaces = faces;
  options.Element = element;
  options.SmoothingIterations = smoothing;
  return Remesh(std::make_shared<Surface>(surface)).Compute(options);
}
}

TEST(Remesh, SquareIsCutIntoSquares)
{
  const RemeshResult mesh = Remeshed(Meshes::Square(7), 100);
  EXPECT_EQ(Meshes::FlawOf(mesh), "");
  EXPECT_EQ(mesh.Quads, 100);
  EXPECT_EQ(mesh.Triangles, 0);
  EXPECT_EQ(mesh.IrregularVertices, 0);
  EXPECT_GT(Meshes::LeastQuality(mesh), 1.0 - 1e-4);
  EXPECT_LT(mesh.MaximumDistance, 1e-12);
}

TEST(Remesh, CubeIsCutIntoSquaresOfEachSide)
{
  for (const int side : { 3, 8 })
  {
    const RemeshResult mesh = Remeshed(Meshes::Cube(), 6 * side * side);
    EXPECT_EQ(Meshes::FlawOf(mesh), "");
    EXPECT_EQ(mesh.Quads, 6 * side * side);
    EXPECT_EQ(mesh.Triangles, 0);
    // The corners have three edges each, which sums up to 4 chi = 8 quarters.
    EXPECT_EQ(mesh.IrregularVertices, 8);
    EXPECT_GT(Meshes::LeastQuality(mesh), 1.0 - 1e-4);
  }
}

TEST(Remesh, PrismIsCutIntoSquaresOfEachSide)
{
  // A box of 2 x 1 x 1, with edges of 1 / 6.
  const Surface box =
    Meshes::Transformed(Meshes::Cube(), Vector3(2.0, 1.0, 1.0).asDiagonal(), Vector3::Zero());
  const RemeshResult mesh = Remeshed(box, 10 * 6 * 6);
  EXPECT_EQ(Meshes::FlawOf(mesh), "");
  EXPECT_EQ(mesh.Quads, 10 * 6 * 6);
  EXPECT_EQ(mesh.Triangles, 0);
  EXPECT_EQ(mesh.IrregularVertices, 8);
  EXPECT_GT(Meshes::LeastQuality(mesh), 1.0 - 1e-4);
}

TEST(Remesh, HexagonIsCutIntoEquilateralTriangles)
{
  // The lattice fits the boundary, so that all edges have the same length.
  constexpr int cells = 8;
  Surface hexagon;
  hexagon.Points = { Vector3::Zero() };
  for (int k = 0; k < 6; ++k)
  {
    hexagon.Points.emplace_back(std::cos(k * Pi / 3.0), std::sin(k * Pi / 3.0), 0.0);
    hexagon.Triangles.push_back({ 0, 1 + k, 1 + (k + 1) % 6 });
  }
  const RemeshResult mesh =
    Remeshed(Meshes::FlatlySubdivided(hexagon, 3), 6 * cells * cells, Element::Triangles, 0);
  EXPECT_EQ(Meshes::FlawOf(mesh), "");
  EXPECT_EQ(mesh.Triangles, 6 * cells * cells);
  EXPECT_EQ(mesh.IrregularVertices, 0);
  for (const std::array<Index, 4>& face : mesh.Faces)
  {
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(
        (mesh.Points[face[c]] - mesh.Points[face[(c + 1) % 3]]).norm(), 1.0 / cells, 1e-9);
    }
  }
}

TEST(Remesh, MovesWithTheSurface)
{
  const Surface surface = Meshes::Potato(4);
  const Vector3 shift(8.0, -4.0, 2.0);
  const RemeshResult mesh = Remeshed(surface, 500);
  const RemeshResult moved =
    Remeshed(Meshes::Transformed(surface, Eigen::Matrix3d::Identity(), shift), 500);
  ASSERT_EQ(mesh.Faces, moved.Faces);
  for (std::size_t v = 0; v < mesh.Points.size(); ++v)
  {
    EXPECT_LT((mesh.Points[v] + shift - moved.Points[v]).norm(), 1e-4);
  }
}

TEST(Remesh, TorusNeedsNoIrregularVertices)
{
  // Along a field without singularities.
  const Surface torus = Meshes::Torus(48, 24);
  std::vector<Vector3> around;
  for (const Vector3& p : torus.Points)
  {
    around.emplace_back(-p[1], p[0], 0.0);
  }
  RemeshOptions options;
  options.NumberOfFaces = 800;
  const RemeshResult mesh = Remesh(std::make_shared<Surface>(torus)).Compute(options, around);
  EXPECT_EQ(Meshes::FlawOf(mesh), "");
  EXPECT_EQ(mesh.EulerCharacteristicAfter, 0);
  EXPECT_EQ(mesh.Triangles, 0);
  EXPECT_EQ(mesh.IrregularVertices, 0);
  EXPECT_EQ(mesh.KeptVertices, 0);
}

TEST(Remesh, CylinderKeepsItsTwoRims)
{
  const RemeshResult mesh = Remeshed(Meshes::Cylinder(40, 10, 2.0), 600);
  EXPECT_EQ(Meshes::FlawOf(mesh), "");
  EXPECT_EQ(mesh.Triangles, 0);
  EXPECT_EQ(mesh.IrregularVertices, 0);
  EXPECT_EQ(Meshes::CountBoundaryLoops(mesh), 2);
  for (std::size_t v = 0; v < mesh.Points.size(); ++v)
  {
    if (mesh.Kind[v] == VertexKind::Boundary || mesh.Kind[v] == VertexKind::Corner)
    {
      EXPECT_NEAR(std::abs(mesh.Points[v][2] - 1.0), 1.0, 1e-12);
    }
  }
}

TEST(Remesh, DiskHasFourIrregularVertices)
{
  const RemeshResult mesh = Remeshed(Meshes::Disk(20), 500);
  EXPECT_EQ(Meshes::FlawOf(mesh), "");
  EXPECT_EQ(Meshes::CountBoundaryLoops(mesh), 1);
  EXPECT_EQ(mesh.IrregularVertices, 4);
  EXPECT_LE(mesh.Triangles, 2);
}

TEST(Remesh, PlaneIsCutIntoEquilateralTriangles)
{
  const RemeshResult mesh = Remeshed(Meshes::Square(10), 300, Element::Triangles);
  EXPECT_EQ(Meshes::FlawOf(mesh), "");
  EXPECT_EQ(mesh.Quads, 0);
  EXPECT_GT(static_cast<double>(std::count(mesh.Regular.begin(), mesh.Regular.end(), 1)),
    0.8 * mesh.Triangles);
}

namespace
{
/// A roof over a triangle with an angle at each of the two ends of its ridge: sharp edges that meet there at that
/// angle.
Surface Wedge(double angle)
{
  Surface wedge;
  const double half = std::tan(0.5 * angle);
  wedge.Points = { { 0.0, 0.0, 0.0 }, { 1.0, half, 0.0 }, { 1.0, -half, 0.0 }, { 0.0, 0.0, 1.0 },
    { 1.0, half, 1.0 }, { 1.0, -half, 1.0 } };
  wedge.Triangles = { { 0, 1, 2 }, { 3, 5, 4 }, { 0, 3, 4 }, { 0, 4, 1 }, { 0, 2, 5 }, { 0, 5, 3 },
    { 1, 4, 5 }, { 1, 5, 2 } };
  return Meshes::FlatlySubdivided(wedge, 3);
}
}

TEST(Remesh, WedgesHaveRoomAtTheirNarrowCorners)
{
  // Two edges that meet at 25 degrees follow the same direction of the field, and cannot both be lines of the lattice up
  // to the corner.
  for (const double angle : { 25.0, 40.0, 80.0 })
  {
    const RemeshResult mesh = Remeshed(Wedge(angle * Pi / 180.0), 1000);
    EXPECT_EQ(Meshes::FlawOf(mesh), "");
    EXPECT_GT(mesh.Quads, 0.97 * static_cast<double>(mesh.Faces.size())) << angle;
    EXPECT_NEAR(static_cast<double>(mesh.Faces.size()), 1000.0, 150.0) << angle;
    EXPECT_GT(Meshes::LeastQuality(mesh), 0.0) << angle;
  }
}

TEST(Remesh, KeepsTheTopologyOfAnySurface)
{
  const std::vector<Surface> surfaces = { Meshes::Tetrahedron(), Meshes::Octahedron(),
    Meshes::Icosphere(3), Meshes::Hemisphere(3), Meshes::DoubleTorus(), Meshes::Potato(3),
    Meshes::LShape(6), Meshes::PlateWithHole(24, 8, 0.4, true), Meshes::ChamferedCube(4),
    Meshes::BadSphere(3, 0.1, 1), Meshes::Scrambled(Meshes::Icosphere(3), 1),
    Meshes::Roughened(Meshes::Icosphere(3), 0.1, 1),
    Meshes::Joined(Meshes::Icosphere(2), Meshes::Square(3)) };
  for (std::size_t i = 0; i < surfaces.size(); ++i)
  {
    for (const Index faces : { 20, 200, 2000 })
    {
      for (const Element element : { Element::Quads, Element::Triangles })
      {
        const RemeshResult mesh = Remeshed(surfaces[i], faces, element);
        EXPECT_EQ(Meshes::FlawOf(mesh), "") << "surface " << i << ", " << faces;
        EXPECT_EQ(Meshes::CountBoundaryLoops(mesh), Meshes::CountBoundaryLoops(surfaces[i]))
          << "surface " << i << ", " << faces;
      }
    }
  }
}

TEST(Remesh, ThinTrianglesDoNotMakeManyTimesTheFaces)
{
  // One vertex is a thousand times as far away as the others, which are noise: angles at it, scaled to those of a
  // plane, would ask for millions of faces.
  for (const Element element : { Element::Quads, Element::Triangles })
  {
    Surface needles = Meshes::Jittered(Meshes::Potato(1), 0.5, 1);
    needles.Points[0] *= 1000.0;
    const RemeshResult mesh = Remeshed(needles, 500, element, 0);
    EXPECT_EQ(Meshes::FlawOf(mesh), "");
    EXPECT_GT(mesh.Faces.size(), 100U);
    EXPECT_LT(mesh.Faces.size(), 4 * 500U);
  }
}

TEST(Remesh, StripsThinnerThanAFaceHaveAboutTheFacesThatWereAskedFor)
{
  // Of edges that fit the area there would be ten thousand.
  const Surface strip =
    Meshes::Transformed(Meshes::Square(6), Vector3(1.0, 1e-6, 1.0).asDiagonal(), Vector3::Zero());
  const RemeshResult mesh = Remeshed(strip, 100);
  EXPECT_EQ(Meshes::FlawOf(mesh), "");
  EXPECT_GT(mesh.Faces.size(), 100U);
  EXPECT_LT(mesh.Faces.size(), 1000U);
  ASSERT_FALSE(mesh.Notes.empty());
  EXPECT_NE(mesh.Notes.front().find("boundary"), std::string::npos) << mesh.Notes.front();
}

TEST(Remesh, RefusesCoordinatesWhoseSumsOverflow)
{
  Surface far = Meshes::Square(3);
  for (Vector3& point : far.Points)
  {
    point = 1e290 * point + Vector3(1.7e308, 0.0, 0.0);
  }
  EXPECT_THROW(Remeshed(far, 20), MeshError);
}

TEST(Remesh, DoesNotTryMoreFacesThanCanBeNumbered)
{
  const RemeshResult mesh = Remeshed(Meshes::Square(3), 2147483647);
  EXPECT_EQ(mesh.Faces.size(), 18U);
  ASSERT_FALSE(mesh.Notes.empty());
  EXPECT_NE(mesh.Notes.front().find("cells"), std::string::npos) << mesh.Notes.front();
}

TEST(Remesh, SizingMakesFacesSmallerWhereItIsAsked)
{
  const Surface square = Meshes::Square(30);
  RemeshOptions options;
  options.NumberOfFaces = 1000;
  for (const Vector3& p : square.Points)
  {
    options.Sizing.push_back(p[0] < 0.5 ? 1.0 : 2.0);
  }
  const RemeshResult mesh = Remesh(std::make_shared<Surface>(square)).Compute(options);
  EXPECT_EQ(Meshes::FlawOf(mesh), "");
  Index left = 0;
  for (const Vector3& p : mesh.Points)
  {
    left += p[0] < 0.5 ? 1 : 0;
  }
  // 4 of 5 where the size could jump.
  EXPECT_GT(left, 0.6 * static_cast<double>(mesh.Points.size()));
}

TEST(Remesh, DoesNotDependOnThreadsOrOnWhatWasComputedBefore)
{
  const auto surface = std::make_shared<Surface>(Meshes::Potato(4));
  RemeshOptions options;
  options.NumberOfFaces = 700;
  options.NumberOfThreads = 1;
  const RemeshResult one = Remesh(surface).Compute(options);
  options.NumberOfThreads = 3;
  Remesh kept(surface);
  RemeshOptions other = options;
  other.NumberOfFaces = 300;
  kept.Compute(other);
  const RemeshResult three = kept.Compute(options);
  EXPECT_EQ(one.Faces, three.Faces);
  EXPECT_EQ(one.Points, three.Points);
}

TEST(Remesh, ScalesWithTheSurface)
{
  const Surface potato = Meshes::Potato(3);
  const RemeshResult unit = Remeshed(potato, 300);
  for (const double scale : { 1e-9, 1e9 })
  {
    const Surface scaled =
      Meshes::Transformed(potato, scale * Eigen::Matrix3d::Identity(), Vector3::Zero());
    const RemeshResult mesh = Remeshed(scaled, 300);
    EXPECT_EQ(Meshes::FlawOf(mesh), "");
    EXPECT_EQ(mesh.Quads, unit.Quads) << scale;
    EXPECT_NEAR(mesh.EdgeLength / (scale * unit.EdgeLength), 1.0, 1e-9);
  }
}

TEST(Remesh, IsTheSameVeryFarFromZero)
{
  // Whole coordinates from 0 on, which stay whole where they are moved.
  Surface near = Meshes::Potato(3);
  Vector3 least = near.Points.front();
  for (Vector3& point : near.Points)
  {
    point = (std::ldexp(1.0, 15) * point).array().round();
    least = least.cwiseMin(point);
  }
  Surface far = near;
  const Vector3 shift(std::ldexp(1.0, 52), 0.0, -std::ldexp(1.0, 52));
  for (std::size_t p = 0; p < near.Points.size(); ++p)
  {
    near.Points[p] -= Vector3(least[0], 0.0, least[2]);
    far.Points[p] = near.Points[p] + shift;
  }
  const RemeshResult mesh = Remeshed(near, 300);
  const RemeshResult moved = Remeshed(far, 300);
  EXPECT_EQ(moved.Faces, mesh.Faces);
  EXPECT_EQ(moved.MaximumDistance, mesh.MaximumDistance);
  for (std::size_t v = 0; v < mesh.Points.size(); ++v)
  {
    EXPECT_EQ(moved.Points[v], Vector3(mesh.Points[v] + shift));
  }

  // A square in a plane whose place, squared, is no number.
  const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
  const RemeshResult plane =
    Remeshed(Meshes::Transformed(Meshes::Square(7), identity, Vector3(0.0, 0.0, -1e200)), 100);
  EXPECT_EQ(plane.Quads, 100);
  EXPECT_LT(plane.MaximumDistance, 1e-12);
  EXPECT_LT(plane.MaximumDistanceToMesh, 1e-12);
}

TEST(Remesh, PointsAreWhereTheirSourcesSay)
{
  const Surface surface = Meshes::ChamferedCube(4);
  const RemeshResult mesh = Remeshed(surface, 400);
  for (std::size_t v = 0; v < mesh.Points.size(); ++v)
  {
    Vector3 place = Vector3::Zero();
    for (int c = 0; c < 3; ++c)
    {
      place +=
        mesh.SourceWeights[v][c] * surface.Points[surface.Triangles[mesh.SourceTriangle[v]][c]];
    }
    EXPECT_LT((place - mesh.Points[v]).norm(), 1e-9);
  }
}

TEST(Remesh, FollowsTheFieldThatIsGiven)
{
  const Surface square = Meshes::Square(12);
  RemeshOptions options;
  options.NumberOfFaces = 200;
  const std::vector<Vector3> directions(square.Points.size(), Vector3(0.0, 1.0, 0.0));
  const RemeshResult mesh = Remesh(std::make_shared<Surface>(square)).Compute(options, directions);
  EXPECT_EQ(Meshes::FlawOf(mesh), "");
  EXPECT_EQ(mesh.IrregularVertices, 0);
  for (const std::array<Index, 4>& face : mesh.Faces)
  {
    const Vector3 edge = (mesh.Points[face[1]] - mesh.Points[face[0]]).normalized();
    EXPECT_NEAR(std::max(std::abs(edge[0]), std::abs(edge[1])), 1.0, 1e-3);
  }
}

TEST(Remesh, StopsWhenItIsAskedTo)
{
  int calls = 0;
  const RemeshResult mesh = Remesh(std::make_shared<Surface>(Meshes::Potato(3)))
                              .Compute({}, {}, [&](double) { return ++calls < 4; });
  EXPECT_TRUE(mesh.Aborted);
  EXPECT_TRUE(mesh.Points.empty());
}

TEST(Remesh, RefusesWhatMakesNoSense)
{
  Remesh remesh(std::make_shared<Surface>(Meshes::Cube()));
  RemeshOptions options;
  options.NumberOfFaces = 0;
  EXPECT_THROW(remesh.Compute(options), std::invalid_argument);
  options = {};
  options.UseEdgeLength = true;
  options.EdgeLength = 0.0;
  EXPECT_THROW(remesh.Compute(options), std::invalid_argument);
  options = {};
  options.AlignmentStrength = 1.5;
  EXPECT_THROW(remesh.Compute(options), std::invalid_argument);
  options = {};
  options.SingularityCost = 5.0;
  EXPECT_THROW(remesh.Compute(options), std::invalid_argument);
  options = {};
  options.Sizing = { 1.0 };
  EXPECT_THROW(remesh.Compute(options), std::invalid_argument);
}

TEST(Remesh, EmptySurfaceGivesAnEmptyMesh)
{
  EXPECT_TRUE(Remesh(std::make_shared<Surface>()).Compute({}).Faces.empty());
}

TEST(Remesh, NamesTheEdgeLengthThatWouldDo)
{
  // A sphere of a hundredth of the size has an area of 1e-4 of the other one's, and so of less than one face.
  const Surface sphere = Meshes::Icosphere(3);
  Surface small = sphere;
  for (Vector3& p : small.Points)
  {
    p = 0.01 * p + Vector3(3.0, 0.0, 0.0);
  }
  const auto both = std::make_shared<Surface>(Meshes::Joined(sphere, small));
  RemeshOptions options;
  options.NumberOfFaces = 500;
  Remesh remesh(both);
  const RemeshResult mesh = remesh.Compute(options);
  const std::string words = "1 component is too small";
  const auto isAbout = [&](const std::string& note) { return note.rfind(words, 0) == 0; };
  const auto note = std::find_if(mesh.Notes.begin(), mesh.Notes.end(), isAbout);
  ASSERT_NE(note, mesh.Notes.end());
  const std::string before = "An edge length of ";
  options.UseEdgeLength = true;
  options.EdgeLength = std::stod(note->substr(note->find(before) + before.size()));
  EXPECT_NEAR(options.EdgeLength, std::sqrt(4.0 * Pi * 1e-4 / 8.0), 1e-3);
  // Of the small one alone, since the large one would have 80 000 faces; three digits are rounded.
  options.EdgeLength *= 0.99;
  const RemeshResult fine = Remesh(std::make_shared<Surface>(small)).Compute(options);
  EXPECT_TRUE(std::none_of(fine.Notes.begin(), fine.Notes.end(), isAbout));
}

TEST(Remesh, LargeSurfaceIsRemeshedOnFewerTrianglesAndLiesOnIt)
{
  const Surface potato = Meshes::Potato(6);
  const auto surface = std::make_shared<Surface>(potato);
  RemeshOptions options;
  options.NumberOfFaces = 2000;
  Remesh remesh(surface);
  const RemeshResult mesh = remesh.Compute(options);
  EXPECT_EQ(Meshes::FlawOf(mesh), "");
  EXPECT_GT(Meshes::LeastQuality(mesh), 0.3);
  EXPECT_GT(mesh.Quads, static_cast<Index>(0.99 * static_cast<double>(mesh.Faces.size())));
  for (std::size_t v = 0; v < mesh.Points.size(); ++v)
  {
    Vector3 place = Vector3::Zero();
    for (int c = 0; c < 3; ++c)
    {
      place +=
        mesh.SourceWeights[v][c] * potato.Points[potato.Triangles[mesh.SourceTriangle[v]][c]];
    }
    ASSERT_LT((place - mesh.Points[v]).norm(), 1e-9);
  }
  // The cache of the first mesh does not show in the next one.
  options.NumberOfFaces = 3000;
  options.NumberOfThreads = 2;
  const RemeshResult next = remesh.Compute(options);
  options.NumberOfThreads = 1;
  const RemeshResult anew = Remesh(surface).Compute(options);
  EXPECT_EQ(next.Points, anew.Points);
  EXPECT_EQ(next.Faces, anew.Faces);
}

TEST(Remesh, TrianglesHaveFewIrregularVerticesAndBadFaces)
{
  Surface bump = Meshes::Square(40, 2.0);
  for (Vector3& point : bump.Points)
  {
    const double squared = (point - Vector3(1.0, 1.0, 0.0)).squaredNorm();
    point[2] = 1.5 * std::exp(-80.0 * squared);
  }
  RemeshOptions options;
  options.Element = Element::Triangles;
  options.NumberOfFaces = 1000;
  const RemeshResult mesh = Remesh(std::make_shared<Surface>(bump)).Compute(options);
  EXPECT_EQ(Meshes::FlawOf(mesh), "");
  EXPECT_EQ(mesh.Quads, 0);
  EXPECT_LE(mesh.IrregularVertices, 8);
  EXPECT_GT(Meshes::LeastQuality(mesh), 0.3);
}
