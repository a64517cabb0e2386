// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Refinement/Thinning.h"

#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <set>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

namespace
{
std::set<Index> PointsOf(const std::vector<Triangle>& triangles)
{
  std::set<Index> points;
  for (const Triangle& t : triangles)
  {
    points.insert(t.begin(), t.end());
  }
  return points;
}
}

TEST(Thinning, VerticesThatStayAreThereAfterwardsAndOnlyThese)
{
  const Surface disk = Meshes::Disk(30);
  const SurfaceGeometry geometry(disk);
  const TriangleMesh& mesh = geometry.Mesh;
  const std::vector<char> isFeature(mesh.GetNumberOfEdges(), 0);
  const std::vector<double> longest(disk.Points.size(), 0.2);
  const std::set<Index> thin = PointsOf(ThinInside(geometry, isFeature, longest, {}));
  // The boundary stays in any case.
  EXPECT_GE(thin.size(), 6U * 30U);
  EXPECT_LT(thin.size(), disk.Points.size() / 2);
  std::vector<char> isKept(mesh.GetNumberOfVertices(), 0);
  std::set<Index> kept;
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    if (thin.count(mesh.Point(v)) == 0 && v % 7 == 0)
    {
      isKept[v] = 1;
      kept.insert(mesh.Point(v));
    }
  }
  ASSERT_GT(kept.size(), 200U);
  const std::set<Index> left = PointsOf(ThinInside(geometry, isFeature, longest, isKept));
  for (const Index p : kept)
  {
    EXPECT_EQ(left.count(p), 1U) << p;
  }
  EXPECT_LT(left.size(), disk.Points.size() / 2);
}
