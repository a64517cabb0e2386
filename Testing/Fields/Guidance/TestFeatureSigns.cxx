// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DirectionField.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
Surface Rewound(Surface surface)
{
  for (Triangle& t : surface.Triangles)
  {
    std::swap(t[1], t[2]);
  }
  return surface;
}

std::vector<bool> SingularTriangles(const Result& result)
{
  std::vector<bool> singular;
  for (const int index : result.SingularityIndex)
  {
    singular.push_back(index != 0);
  }
  return singular;
}

/// A part without symmetries, with holes and with edges of many angles.
Surface Part()
{
  Eigen::Matrix3d squeezed;
  squeezed << 1.0, 0.2, 0.1, 0.0, 0.7, 0.15, 0.05, 0.0, 1.6;
  return Jittered(
    Transformed(FlatlySubdivided(DoubleTorus(), 2), squeezed, Vector3::Zero()), 0.02, 4);
}

/// The field is singular at the same triangles in other frames and where the surface is wound the other way.
void ExpectTheSame(const Surface& part, const Options& options)
{
  const Result here = DirectionField(part).Compute(options);
  const std::vector<bool> singular = SingularTriangles(here);
  for (const double angle : { 0.7, 1.9, 3.0, 4.4 })
  {
    const Surface turned = Transformed(part, ObliqueRotation(angle), { 0.3, 1.0, -2.0 });
    const Result there = DirectionField(turned).Compute(options);
    EXPECT_EQ(SingularTriangles(there), singular) << options.Degree << " " << angle;
    EXPECT_EQ(there.Constraint, here.Constraint);
  }
  const Result other = DirectionField(Rewound(part)).Compute(options);
  EXPECT_EQ(SingularTriangles(other), singular) << options.Degree;
  EXPECT_EQ(other.Constraint, here.Constraint);
}
}

TEST(FeatureSigns, DoNotDependOnTheFrameNorTheWinding)
{
  for (const int degree : { 1, 3, 5 })
  {
    Options options;
    options.Degree = degree;
    options.ConstrainSharpEdges = true;
    ExpectTheSame(Part(), options);
  }
}

TEST(FeatureSigns, FollowTheBoundary)
{
  // The plate's edges and its bevels, around the hole and the rim.
  const Surface plate = Jittered(PlateWithHole(48, 12, 0.5, true), 0.01, 2);
  for (const int degree : { 1, 3 })
  {
    Options options;
    options.Degree = degree;
    options.ConstrainSharpEdges = true;
    options.FeatureAngle = 15.0;
    options.ConstrainBoundary = true;
    ExpectTheSame(plate, options);
  }
}

TEST(FeatureSigns, AreCarriedAlongChains)
{
  // A prism of 24 sides with lids: the field runs along both rims without turning round anywhere.
  Surface prism = Cylinder(24, 6, 1.0);
  for (const double z : { 0.0, 1.0 })
  {
    const auto center = static_cast<Index>(prism.Points.size());
    prism.Points.emplace_back(0.0, 0.0, z);
    const Index first = z == 0.0 ? 0 : 24 * 6;
    for (Index k = 0; k < 24; ++k)
    {
      const Index here = first + k;
      const Index next = first + (k + 1) % 24;
      prism.Triangles.push_back(
        z == 0.0 ? Triangle{ center, next, here } : Triangle{ center, here, next });
    }
  }
  Options options;
  options.Degree = 1;
  options.ConstrainSharpEdges = true;
  const Result result = DirectionField(prism).Compute(options);
  // One singularity at each lid, and a smooth field between the rims.
  int total = 0;
  for (const int index : result.SingularityIndex)
  {
    total += std::abs(index);
  }
  EXPECT_EQ(total, 2);
  double sense = 0.0;
  for (Index i = 0; i < 24 * 7; ++i)
  {
    if (result.Constraint[i] == ConstraintKind::SharpEdge)
    {
      const Vector3& p = prism.Points[i];
      const double along = Vector3(-p.y(), p.x(), 0.0).normalized().dot(result.Direction(i, 0));
      EXPECT_GT(std::abs(along), 0.99);
      sense = sense == 0.0 ? along : sense;
      EXPECT_GT(sense * along, 0.0) << i;
    }
  }
  EXPECT_NE(sense, 0.0);
}

TEST(FeatureSigns, GoOnAroundWhatCannotBeOriented)
{
  // Signs agree with their mirror images.
  const Surface strip = MoebiusStrip(60, 6);
  Options options;
  options.ConstrainSharpEdges = true;
  options.FeatureAngle = 2.0;
  for (const int degree : { 1, 3 })
  {
    options.Degree = degree;
    const Result result = DirectionField(strip).Compute(options);
    EXPECT_LE(result.Components[0].SystemResidual, 1e-6);
    for (std::size_t i = 0; i < strip.Points.size(); ++i)
    {
      EXPECT_NEAR(result.Direction(static_cast<Index>(i), 0).norm(), 1.0, 1e-9);
    }
  }
}

TEST(BoundaryCorners, DoNotDependOnTheWinding)
{
  // The corners of a square cancel for line fields, those of 45 degrees for cross fields.
  const Surface sheared = Transformed(Jittered(Square(9), 0.02, 6),
    (Eigen::Matrix3d() << 1.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0).finished(), Vector3::Zero());
  for (const auto& [surface, degree] : { std::pair(Square(10), 2), std::pair(LShape(6), 2),
         std::pair(sheared, 4), std::pair(sheared, 2), std::pair(Jittered(LShape(6), 0.01, 3), 2) })
  {
    Options options;
    options.Degree = degree;
    options.ConstrainBoundary = true;
    const Result here = DirectionField(surface).Compute(options);
    const Result rewound = DirectionField(Rewound(surface)).Compute(options);
    ASSERT_EQ(rewound.Constraint, here.Constraint);
    for (Index i = 0; i < static_cast<Index>(surface.Points.size()); ++i)
    {
      if (here.Constraint[i] != ConstraintKind::None)
      {
        EXPECT_LT(Deviation(rewound, i, here.Direction(i, 0)), 1e-6) << i;
      }
    }
    // A symmetric field vanishes along lines, where rounding decides.
    if (std::abs(surface.Points[0].z()) > 0.0)
    {
      EXPECT_EQ(SingularTriangles(rewound), SingularTriangles(here));
    }
  }
}
