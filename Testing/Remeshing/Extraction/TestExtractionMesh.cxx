// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Charts/CutMesh.h"
#include "Extraction/DoubleEdges.h"
#include "Extraction/ExtractionMesh.h"
#include "Extraction/GridPoints.h"
#include "Extraction/Pairing.h"
#include "Extraction/VertexRemoval.h"
#include "Meshes/Surfaces.h"
#include "Parametrization/IntegerGridMap.h"

#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <set>

using namespace DirectionFields;

namespace
{
/// The cells of a field with many singularities, whose map folds in many places.
std::unique_ptr<ExtractionMesh> MakeMesh(const Surface& surface, int degree, double perLength)
{
  const SurfaceGeometry geometry(surface);
  std::mt19937 engine(3);
  std::vector<Complex> section(geometry.Mesh.GetNumberOfVertices());
  for (Complex& z : section)
  {
    z = std::polar(1.0, engine() / 4294967296.0 * 2.0 * Pi);
  }
  const FieldMatching charts(geometry, degree, section);
  const std::vector<char> isFrameless(geometry.Mesh.GetNumberOfVertices(), 0);
  const FeatureLines features(geometry, charts, {}, isFrameless, { 0.1 });
  const TriangleMesh::Component& part = geometry.Mesh.GetComponents().front();
  const CutGraph jumps(geometry, part, charts, features, isFrameless);
  const CutMesh charted(geometry, part, charts, features, isFrameless, jumps, section);
  IntegerGridMap::Settings settings;
  settings.PerLength.assign(charted.Positions.size(), perLength);
  const IntegerGridMap map(charted, settings);
  return map.GetFailure() == nullptr ? std::make_unique<ExtractionMesh>(charted, map) : nullptr;
}

/// Says what is wrong with the links of a mesh; empty if nothing is.
std::string FlawOf(const ExtractionMesh& mesh)
{
  std::set<std::array<Index, 2>> edges;
  for (Index h = 0; h < 3 * mesh.GetNumberOfTriangles(); ++h)
  {
    if (!mesh.IsTriangle(h / 3))
    {
      continue;
    }
    if (!mesh.IsVertex(mesh.Tail(h)))
    {
      return "a corner that is no vertex";
    }
    if (!edges.insert({ mesh.Tail(h), mesh.Head(h) }).second)
    {
      return "an edge twice";
    }
    const Index g = mesh.Twin(h);
    if (g == None)
    {
      continue;
    }
    if (mesh.Twin(g) != h || mesh.Tail(g) != mesh.Head(h) || mesh.Head(g) != mesh.Tail(h) ||
      mesh.Feature(g) != mesh.Feature(h))
    {
      return "neighbours that are not mutual";
    }
    if (mesh.GetPlane().Apply(mesh.Across(h), mesh.Place(g)) !=
        mesh.Place(ExtractionMesh::Next(h)) ||
      mesh.GetPlane().Apply(mesh.Across(h), mesh.Place(ExtractionMesh::Next(g))) != mesh.Place(h))
    {
      return "charts that do not agree";
    }
  }
  return "";
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
      ASSERT_EQ(FlawOf(*mesh), "");
      InsertGridPoints(*mesh);
      ASSERT_EQ(FlawOf(*mesh), "");
      EXPECT_EQ(mesh->EulerCharacteristic(), chi);
      VertexRemoval removal(*mesh);
      for (const VertexRemoval::Mode mode :
        { VertexRemoval::Mode::Strict, VertexRemoval::Mode::Joining, VertexRemoval::Mode::Relaxed })
      {
        for (Index v = 0; v < mesh->GetNumberOfVertices(); ++v)
        {
          if (mesh->IsVertex(v) && !mesh->GetRole(v).IsKept && removal.Remove(v, mode))
          {
            ASSERT_EQ(FlawOf(*mesh), "");
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
  // Cones that were rounded to the same place are neighbours once what is between them has been removed.
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
      ASSERT_EQ(FlawOf(*mesh), "");
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
    EXPECT_EQ(FlawOf(*mesh), "an edge twice");
    SplitDoubleEdges(*mesh);
    EXPECT_EQ(FlawOf(*mesh), "");
    EXPECT_EQ(mesh->EulerCharacteristic(), euler);
  }
}
