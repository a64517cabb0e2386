// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Extraction/ExtractionMesh.h"

#include "Extraction/DoubleEdges.h"
#include "Extraction/GridPoints.h"
#include "Extraction/VertexRemoval.h"
#include "Meshes/Surfaces.h"
#include "Remeshing/CutExample.h"

#include <gtest/gtest.h>

#include <memory>

using namespace DirectionFields;

namespace
{
/// The mesh of a map of a field with many singularities, which folds in many places.
std::unique_ptr<ExtractionMesh> MakeMesh(const Surface& surface, int degree, double perLength)
{
  const Meshes::CutExample example = Meshes::CutExample::Random(surface, degree, 3);
  const IntegerGridMap map(example.Mesh, example.Settings(perLength));
  return map.GetFailure() ? nullptr : std::make_unique<ExtractionMesh>(example.Mesh, map);
}
}

TEST(ExtractionMesh, NoOperationChangesTheTopologyOrBreaksTheCharts)
{
  for (const Surface& surface : { Meshes::Icosphere(2), Meshes::Torus(12, 9), Meshes::Disk(4),
         Meshes::PlateWithHole(12, 4, 0.4, true) })
  {
    for (const int degree : { 4, 6 })
    {
      const std::unique_ptr<ExtractionMesh> mesh = MakeMesh(surface, degree, 5.0);
      ASSERT_NE(mesh, nullptr);
      const Index chi = mesh->EulerCharacteristic();
      ASSERT_EQ(Meshes::FlawOf(*mesh), "");
      InsertGridPoints(*mesh);
      ASSERT_EQ(Meshes::FlawOf(*mesh), "");
      EXPECT_EQ(mesh->EulerCharacteristic(), chi);
      VertexRemoval removal(*mesh);
      for (const VertexRemoval::Mode mode :
        { VertexRemoval::Mode::Strict, VertexRemoval::Mode::Joining, VertexRemoval::Mode::Relaxed })
      {
        for (Index v = 0; v < mesh->GetNumberOfVertices(); ++v)
        {
          if (mesh->IsVertex(v) && !mesh->GetRole(v).IsKept && removal.Remove(v, mode))
          {
            ASSERT_EQ(Meshes::FlawOf(*mesh), "");
            ASSERT_EQ(mesh->EulerCharacteristic(), chi);
          }
        }
      }
    }
  }
}

TEST(ExtractionMesh, CollapsesKeepTheTopology)
{
  const std::unique_ptr<ExtractionMesh> mesh = MakeMesh(Meshes::Icosphere(2), 4, 1.0);
  ASSERT_NE(mesh, nullptr);
  // Cones that were rounded to the same place are neighbours once the vertices between them have been removed.
  InsertGridPoints(*mesh);
  VertexRemoval removal(*mesh);
  removal.RemoveAll(VertexRemoval::Mode::Strict);
  removal.RemoveAll(VertexRemoval::Mode::Joining);
  const Index chi = mesh->EulerCharacteristic();
  Index collapsed = 0;
  for (Index h = 0; h < 3 * mesh->GetNumberOfTriangles(); ++h)
  {
    if (mesh->IsTriangle(h / 3) && mesh->Place(h) == mesh->Place(ExtractionMesh::Next(h)) &&
      mesh->MayCollapse(h))
    {
      mesh->Collapse(h);
      ++collapsed;
      ASSERT_EQ(Meshes::FlawOf(*mesh), "");
      ASSERT_EQ(mesh->EulerCharacteristic(), chi);
    }
  }
  EXPECT_GT(collapsed, 0);
}

TEST(ExtractionMesh, DoubleEdgesAreSplit)
{
  for (const int degree : { 4, 6 })
  {
    const std::unique_ptr<ExtractionMesh> mesh = MakeMesh(Meshes::Potato(1), degree, 2.0);
    ASSERT_NE(mesh, nullptr);
    const Index euler = mesh->EulerCharacteristic();
    const Vector3 middle = (mesh->Position(mesh->Tail(0)) + mesh->Position(mesh->Tail(1)) +
                             mesh->Position(mesh->Tail(2))) /
      3.0;
    // A spoke of the vertex inside of a triangle is turned into a second edge between the other two corners.
    const Index inside = mesh->SplitTriangle(0, mesh->Place(0), middle);
    std::vector<Index> star;
    mesh->GetStar(inside, star);
    ASSERT_EQ(star.size(), 3U);
    mesh->Flip(star.front());
    EXPECT_EQ(Meshes::FlawOf(*mesh), "an edge twice");
    SplitDoubleEdges(*mesh);
    EXPECT_EQ(Meshes::FlawOf(*mesh), "");
    EXPECT_EQ(mesh->EulerCharacteristic(), euler);
  }
}

TEST(ExtractionMesh, SplitsAndFlipsKeepTheAreaCoveredExactly)
{
  for (const int degree : { 4, 6 })
  {
    const std::unique_ptr<ExtractionMesh> mesh = MakeMesh(Meshes::Torus(12, 9), degree, 5.0);
    ASSERT_NE(mesh, nullptr);
    const auto area = Meshes::TwiceAreaOf(*mesh);
    const Index triangles = mesh->GetNumberOfTriangles();
    for (Index t = 0; t < triangles; ++t)
    {
      // A point inside, though not the centroid: coordinates are integers.
      const GridPoint sum = mesh->Place(3 * t) + mesh->Place(3 * t + 1) + mesh->Place(3 * t + 2);
      const GridPoint inside{ sum.A / 3, sum.B / 3 };
      mesh->SplitTriangle(t, inside, mesh->Position(mesh->Tail(3 * t)));
    }
    EXPECT_TRUE(Meshes::TwiceAreaOf(*mesh) == area);
    EXPECT_EQ(Meshes::FlawOf(*mesh), "");
    Index flipped = 0;
    for (Index h = 0; h < 3 * triangles; ++h)
    {
      const Index g = mesh->Twin(h);
      if (g > h &&
        !mesh->AreJoined(
          mesh->Tail(ExtractionMesh::Previous(h)), mesh->Tail(ExtractionMesh::Previous(g))))
      {
        mesh->Flip(h);
        ++flipped;
      }
    }
    EXPECT_GT(flipped, 0);
    EXPECT_TRUE(Meshes::TwiceAreaOf(*mesh) == area);
    EXPECT_EQ(Meshes::FlawOf(*mesh), "");
  }
}
