// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Finishing/CloserMesh.h"
#include "Finishing/ThinParts.h"
#include "Meshes/Remeshed.h"
#include "Meshes/Surfaces.h"
#include "Remesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

namespace
{
RemeshOptions Wanted(Index faces, bool keepsThinParts)
{
  RemeshOptions options;
  options.NumberOfFaces = faces;
  options.KeepThinParts = keepsThinParts;
  return options;
}

double Least(const RemeshResult& mesh)
{
  return LeastQuality(mesh.Points, mesh.Faces);
}

double FarthestOf(const RemeshResult& mesh)
{
  return std::max(mesh.MaximumDistance, mesh.MaximumDistanceToMesh);
}

void ExpectSame(const RemeshResult& a, const RemeshResult& b)
{
  EXPECT_EQ(a.Points, b.Points);
  EXPECT_EQ(a.Faces, b.Faces);
  EXPECT_EQ(a.Notes, b.Notes);
}
}

TEST(ThinParts, LimbsThatWouldBeLostHaveSmallerFaces)
{
  const auto surface = std::make_shared<Surface>(Meshes::BallWithLimbs());
  const double diagonal = 6.0 * std::sqrt(3.0);
  Remesh remesh(surface);
  const RemeshResult lost = remesh.Compute(Wanted(400, false));
  const RemeshResult kept = remesh.Compute(Wanted(400, true));
  ASSERT_GT(FarthestOf(lost), 0.025 * diagonal);
  EXPECT_LT(FarthestOf(kept), 0.01 * diagonal);
  EXPECT_EQ(Meshes::FlawOf(kept), "");
  EXPECT_GE(Least(kept), std::min(0.2, Least(lost)));
  EXPECT_NEAR(static_cast<double>(kept.Faces.size()), 400.0, 0.35 * 400.0);
  // It says where.
  const auto note = std::find_if(kept.Notes.begin(), kept.Notes.end(),
    [](const std::string& text) { return text.rfind("Edges are shorter", 0) == 0; });
  ASSERT_NE(note, kept.Notes.end());
  EXPECT_NE(note->find("at 6 places where limbs"), std::string::npos) << *note;
}

/// Whether a limb is lost is a matter of the size that is wanted there.
TEST(ThinParts, DistancesCountInUnitsOfTheSize)
{
  const Surface surface = Meshes::BallWithLimbs();
  const ClosestPoints triangles(surface);
  std::vector<double> distance;
  for (const Vector3& point : surface.Points)
  {
    distance.push_back(0.4 * std::max(0.0, point.norm() - 1.0));
  }
  ThinParts even(surface);
  ThinParts twice(surface, std::vector<double>(surface.Points.size(), 2.0));
  ASSERT_TRUE(even.Shrink(triangles, distance, 0.6));
  ASSERT_TRUE(twice.Shrink(triangles, distance, 0.3));
  EXPECT_EQ(even.GetLengths(), twice.GetLengths());
  EXPECT_FALSE(ThinParts(surface, std::vector<double>(surface.Points.size(), 8.0))
                 .Shrink(triangles, distance, 0.6));
}

TEST(ThinParts, MeshesThatLoseNothingAreTheSame)
{
  for (const Surface& surface : { Meshes::Potato(4), Meshes::Torus(60, 24), Meshes::Cube() })
  {
    const auto shared = std::make_shared<Surface>(surface);
    for (const Index faces : { 60, 600 })
    {
      ExpectSame(
        Remesh(shared).Compute(Wanted(faces, true)), Remesh(shared).Compute(Wanted(faces, false)));
    }
  }
}

TEST(ThinParts, DoNotDependOnThreadsOrOnWhatWasComputedBefore)
{
  const auto surface = std::make_shared<Surface>(Meshes::BallWithLimbs());
  RemeshOptions options = Wanted(400, true);
  options.NumberOfThreads = 1;
  Remesh remesh(surface);
  const RemeshResult first = remesh.Compute(options);
  ExpectSame(remesh.Compute(options), first);
  options.NumberOfThreads = 3;
  ExpectSame(Remesh(surface).Compute(options), first);
}

TEST(ThinParts, ThicknessesAreDistancesFromTheOtherSide)
{
  const Surface ball = Meshes::Icosphere(3);
  const ClosestPoints onBall(ball);
  Thicknesses ofBall(ball);
  for (std::size_t p = 0; p < ball.Points.size(); ++p)
  {
    const auto point = static_cast<Index>(p);
    EXPECT_TRUE(std::isinf(ofBall.At(point, onBall, 1.0)));
    EXPECT_NEAR(ofBall.At(point, onBall, 2.0, p == 0 ? None : point - 1), std::sqrt(2.0), 0.15);
  }
  const Surface plate = Meshes::Transformed(Meshes::FlatlySubdivided(Meshes::Cube(), 3),
    Vector3(1.0, 1.0, 0.05).asDiagonal().toDenseMatrix(), Vector3::Zero());
  const ClosestPoints onPlate(plate);
  Thicknesses ofPlate(plate);
  Index inside = 0;
  for (std::size_t p = 0; p < plate.Points.size(); ++p)
  {
    if ((plate.Points[p].head<2>() - Eigen::Vector2d(0.5, 0.5)).cwiseAbs().maxCoeff() < 0.4)
    {
      EXPECT_NEAR(ofPlate.At(static_cast<Index>(p), onPlate, 1.0), 0.05, 1e-12);
      ++inside;
    }
  }
  EXPECT_EQ(inside, 2 * 7 * 7);
}

TEST(ThinParts, EdgesAreAsShortAsLostPartsAreThinAndGrowFromThere)
{
  const Surface body = Meshes::BallWithLimbs();
  const ClosestPoints triangles(body);
  const double length = 0.25;
  std::vector<double> distance(body.Points.size(), 0.0);
  ThinParts thin(body);
  EXPECT_FALSE(thin.Shrink(triangles, distance, length));
  EXPECT_TRUE(thin.GetLengths().empty());
  EXPECT_EQ(thin.Sentence(Vector3::Zero(), 1.0), "");
  // The tip of one limb is lost.
  for (std::size_t p = 0; p < distance.size(); ++p)
  {
    distance[p] = body.Points[p][0] > 2.9 ? 1.1 * length : 0.0;
  }
  ASSERT_TRUE(thin.Shrink(triangles, distance, length));
  for (std::size_t p = 0; p < distance.size(); ++p)
  {
    const Vector3& point = body.Points[p];
    if (point[0] > 1.2)
    {
      EXPECT_GE(thin.GetLengths()[p], 0.5 * length);
      EXPECT_LE(thin.GetLengths()[p], 0.8 * length);
    }
    if (point[0] < 0.2)
    {
      EXPECT_TRUE(std::isinf(thin.GetLengths()[p]));
    }
  }
  EXPECT_NE(thin.Sentence(Vector3::Zero(), 1.0).find("at 1 place where"), std::string::npos);
  // The place that it names is one of the shortest edges, where and as large as the user's surface is.
  const std::string told = thin.Sentence(Vector3(100.0, -200.0, 300.0), 10.0);
  Vector3 place;
  ASSERT_EQ(std::sscanf(told.c_str() + told.find("as at ("), "as at (%lf, %lf, %lf)", &place[0],
              &place[1], &place[2]),
    3)
    << told;
  const auto least = std::min_element(thin.GetLengths().begin(), thin.GetLengths().end());
  const Vector3 expected = body.Points[least - thin.GetLengths().begin()];
  EXPECT_LT((0.1 * (place - Vector3(100.0, -200.0, 300.0)) - expected).norm(), 0.1) << told;
}

TEST(ThinParts, AnotherMeshIsTakenIfItIsBetterAndInNothingWorse)
{
  const auto meshOf = [](double distance, double quality, int holes) {
    return MeshStanding{ distance, quality, holes };
  };
  const MeshStanding former = meshOf(1.0, 0.09, 1);
  EXPECT_FALSE(IsCloser(former, former));
  EXPECT_TRUE(IsCloser(meshOf(0.7, 0.09, 1), former));
  EXPECT_FALSE(IsCloser(meshOf(0.9, 0.09, 1), former));
  EXPECT_FALSE(IsCloser(meshOf(0.7, 0.05, 1), former));
  EXPECT_FALSE(IsCloser(meshOf(0.7, 0.09, 2), former));
  EXPECT_TRUE(IsCloser(meshOf(1.1, 1.0, 0), former));
  EXPECT_FALSE(IsCloser(meshOf(1.2, 1.0, 0), former));
  // Usable for the first time; as much folded as before.
  EXPECT_TRUE(IsCloser(meshOf(1.1, 0.15, 1), former));
  EXPECT_FALSE(IsCloser(meshOf(1.1, -0.5, 1), meshOf(1.0, -0.51, 1)));
  EXPECT_FALSE(IsCloser(meshOf(1.1, 1e-17, 1), meshOf(1.0, 0.0, 1)));
  // A region or a given point that it loses is worse than any distance.
  const MeshStanding withParts{ 1.0, 0.05, 0, 0.0, 3 };
  EXPECT_TRUE(IsCloser(MeshStanding{ 0.5, 0.3, 0, 0.0, 3 }, withParts));
  EXPECT_FALSE(IsCloser(MeshStanding{ 0.5, 0.3, 0, 0.0, 2 }, withParts));
  // On planes distances are rounding errors.
  const auto flat = [](double distance, double quality) {
    return MeshStanding{ distance, quality, 0, 1e-3 };
  };
  EXPECT_TRUE(IsCloser(flat(4e-16, 1.0), flat(0.0, 0.0)));
  EXPECT_FALSE(IsCloser(flat(0.0, 0.05), flat(4e-16, 0.05)));
}
