// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Extraction/FoldRepair.h"

#include "Extraction/GridPoints.h"
#include "Extraction/VertexRemoval.h"
#include "Meshes/Surfaces.h"
#include "Remeshing/CutExample.h"

#include <gtest/gtest.h>

using namespace DirectionFields;
using Meshes::CutExample;

namespace
{
/// Vertices, and grid points among them that are to stay.
Index CountVerticesAndGridPoints(const ExtractionMesh& mesh)
{
  Index count = 0;
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    count += mesh.IsVertex(v) ? (mesh.GetRole(v).IsKept ? 2 : 1) : 0;
  }
  return count;
}
}

TEST(FoldRepair, TakesVerticesOrGridPointsAwayAndKeepsTheTopology)
{
  for (const int degree : { 4, 6 })
  {
    // A field with more singularities than the grid has room for.
    const CutExample example = CutExample::Random(Meshes::Icosphere(2), degree, 3);
    const IntegerGridMap map(example.Mesh, example.Settings(3.0));
    ASSERT_GT(map.CountFlipped(), 0);
    ExtractionMesh mesh(example.Mesh, map);
    InsertGridPoints(mesh);
    VertexRemoval removal(mesh);
    removal.RemoveAll(VertexRemoval::Mode::Strict);
    Index count = CountVerticesAndGridPoints(mesh);
    int repairs = 0;
    while (RepairFolds(mesh))
    {
      const Index now = CountVerticesAndGridPoints(mesh);
      ASSERT_LT(now, count);
      EXPECT_EQ(mesh.EulerCharacteristic(), 2);
      EXPECT_EQ(Meshes::FlawOf(mesh), "");
      removal.RemoveAll(VertexRemoval::Mode::Strict);
      removal.RemoveAll(VertexRemoval::Mode::Joining);
      count = CountVerticesAndGridPoints(mesh);
      ++repairs;
    }
    EXPECT_GT(repairs, 0);
    // Nothing was found to be done, and nothing is.
    EXPECT_EQ(CountVerticesAndGridPoints(mesh), count);
  }
}

TEST(FoldRepair, LeavesAMapWithoutFoldsAlone)
{
  const CutExample example = CutExample::AlongX(Meshes::Square(7), 4);
  ExtractionMesh mesh(example.Mesh, IntegerGridMap(example.Mesh, example.Settings(5.0)));
  InsertGridPoints(mesh);
  const Index count = CountVerticesAndGridPoints(mesh);
  EXPECT_FALSE(RepairFolds(mesh));
  EXPECT_EQ(CountVerticesAndGridPoints(mesh), count);
}
