// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remesh.h"

#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

using namespace DirectionFields;

namespace
{
void ExpectSame(const RemeshResult& a, const RemeshResult& b)
{
  EXPECT_EQ(a.Points, b.Points);
  EXPECT_EQ(a.Faces, b.Faces);
  EXPECT_EQ(a.Kind, b.Kind);
  EXPECT_EQ(a.FieldIndex, b.FieldIndex);
  EXPECT_EQ(a.Regular, b.Regular);
  EXPECT_EQ(a.SourceTriangle, b.SourceTriangle);
  EXPECT_EQ(a.SourceWeights, b.SourceWeights);
  EXPECT_EQ(a.FaceSource, b.FaceSource);
  EXPECT_EQ(a.Notes, b.Notes);
  EXPECT_EQ(a.EdgeLength, b.EdgeLength);
  EXPECT_EQ(a.MaximumDistance, b.MaximumDistance);
}

/// Asks one object for several sizes, back and forth, and a new one for each.
void ExpectSameAgain(const Surface& given, RemeshOptions options)
{
  const auto surface = std::make_shared<Surface>(given);
  Remesh kept(surface);
  for (const Index faces : { 600, 500, 1500, 60, 600 })
  {
    SCOPED_TRACE(faces);
    options.NumberOfFaces = faces;
    options.NumberOfThreads = 3;
    const RemeshResult again = kept.Compute(options);
    options.NumberOfThreads = 1;
    ExpectSame(again, Remesh(surface).Compute(options));
  }
}

/// A part with sharp edges, a closed surface and a sheet with a boundary.
Surface ThreeComponents()
{
  const auto moved = [](const Surface& surface, double x)
  { return Meshes::Transformed(surface, Eigen::Matrix3d::Identity(), Vector3(x, 0.0, 0.0)); };
  return Meshes::Joined(Meshes::Joined(Meshes::ChamferedCube(6), moved(Meshes::Potato(3), 5.0)),
    moved(Meshes::PlateWithHole(32, 6, 0.3, true), 10.0));
}
}

TEST(RemeshAgain, IsTheSameAsANewMesh)
{
  ExpectSameAgain(Meshes::Potato(3), {});
  ExpectSameAgain(Meshes::DoubleTorus(), {});
  RemeshOptions pure;
  pure.PureQuads = true;
  ExpectSameAgain(Meshes::Potato(3), pure);
}

TEST(RemeshAgain, IsTheSameAsANewMeshOfComponentsWithFeatures)
{
  const Surface surface = ThreeComponents();
  RemeshOptions options;
  ExpectSameAgain(surface, options);
  options.MinimumFeatureLength = 0.0;
  options.FeatureAngle = 20.0;
  ExpectSameAgain(surface, options);
  options.KeepFeatures = false;
  ExpectSameAgain(surface, options);
  options.Element = Element::Triangles;
  options.KeepFeatures = true;
  ExpectSameAgain(surface, options);
}

TEST(RemeshAgain, IsTheSameAsANewMeshOfOtherSizesFromPlaceToPlace)
{
  const Surface surface = ThreeComponents();
  RemeshOptions options;
  for (std::size_t p = 0; p < surface.Points.size(); ++p)
  {
    options.Sizing.push_back(1.0 + 0.5 * std::sin(static_cast<double>(p)));
  }
  ExpectSameAgain(surface, options);
}

TEST(RemeshAgain, IsTheSameAsANewMeshWhateverWasAskedForBefore)
{
  const auto surface = std::make_shared<Surface>(ThreeComponents());
  RemeshOptions options;
  options.NumberOfFaces = 800;
  const RemeshResult anew = Remesh(surface).Compute(options);
  Remesh kept(surface);
  RemeshOptions other = options;
  other.Sizing.assign(surface->Points.size(), 1.0);
  other.Sizing.front() = 3.0;
  kept.Compute(other);
  ExpectSame(kept.Compute(options), anew);
  other.Element = Element::Triangles;
  kept.Compute(other);
  ExpectSame(kept.Compute(options), anew);
  // Stopped at any step, with other equations than those that are kept.
  other = options;
  other.NumberOfFaces = 90;
  int steps = 0;
  kept.Compute(other, {}, [&](double) { return ++steps > 0; });
  for (int last = 0; last < steps; last += 1 + steps / 20)
  {
    int calls = 0;
    kept.Compute(other, {}, [&](double) { return ++calls < last; });
    ExpectSame(kept.Compute(options), anew);
  }
}

TEST(RemeshAgain, IsTheSameAsANewMeshOfOtherFeatures)
{
  // The middle of the disk has so many triangles that the surface is decimated along its features.
  Surface wheel;
  constexpr Index spokes = 60;
  wheel.Points.emplace_back(9.0, 0.0, 0.0);
  for (Index k = 0; k < spokes; ++k)
  {
    const double angle = 2.0 * Pi * static_cast<double>(k) / spokes;
    wheel.Points.emplace_back(9.0 + std::cos(angle), std::sin(angle), 0.0);
    wheel.Triangles.push_back({ 0, k + 1, (k + 1) % spokes + 1 });
  }
  const auto surface = std::make_shared<Surface>(Meshes::Joined(Meshes::ChamferedCube(6), wheel));
  RemeshOptions options;
  options.NumberOfFaces = 800;
  options.KeepSoftFeatures = false;
  Remesh kept(surface);
  kept.Compute(options);
  options.FeatureAngle = 80.0;
  ExpectSame(kept.Compute(options), Remesh(surface).Compute(options));
}
