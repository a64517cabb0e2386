// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Finishing/GivenPlaces.h"

#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

TEST(GivenPlaces, AreThoseOfThinPartsBeforeTheyWereSmoothed)
{
  const Surface torus = Meshes::Torus(60, 10, 1.0, 0.2);
  PreparedSurface surface(torus, 4, FeatureSettings{ false, 40.0, 0.5, 0.0 });
  surface.Smooth(std::vector<char>(surface.GetGeometry().Mesh.GetNumberOfEdges(), 0), 16);
  std::vector<ExtractedMesh> extracted(1);
  double before = 0.0;
  const std::vector<Vector3> given = surface.GetGivenPositions();
  for (std::size_t v = 0; v < given.size(); ++v)
  {
    extracted[0].Vertices.emplace_back();
    extracted[0].Vertices.back().Position = surface.GetGeometry().Positions[v];
    before = std::max(before, (surface.GetGeometry().Positions[v] - given[v]).norm());
  }
  EXPECT_GT(before, 0.08);
  MoveToGiven(surface, extracted);
  for (std::size_t v = 0; v < given.size(); ++v)
  {
    EXPECT_LT((extracted[0].Vertices[v].Position - given[v]).norm(), 0.04);
  }
}
