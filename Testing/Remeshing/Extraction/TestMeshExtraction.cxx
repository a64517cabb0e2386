// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Extraction/MeshExtraction.h"

#include "Extraction/BoundaryVertices.h"
#include "Meshes/Surfaces.h"
#include "Remeshing/CutExample.h"

#include <gtest/gtest.h>

using namespace DirectionFields;
using Meshes::CutExample;

namespace
{
ExtractedMesh Extracted(const CutExample& example, double perLength)
{
  return ExtractMesh(example.Geometry,
    { example.Component, example.Mesh, IntegerGridMap(example.Mesh, example.Settings(perLength)) });
}

double AreaOf(const ExtractedMesh& mesh)
{
  double area = 0.0;
  for (const Faces::Face& face : mesh.Cells.Corners)
  {
    const Vector3& p = mesh.Vertices[face[0]].Position;
    for (int c = 1; c + 1 < Faces::Size(face); ++c)
    {
      // The surface lies in the plane z = 0.
      area += 0.5 *
        (mesh.Vertices[face[c]].Position - p).cross(mesh.Vertices[face[c + 1]].Position - p).z();
    }
  }
  return area;
}

int EulerCharacteristicOf(const ExtractedMesh& mesh)
{
  return EulerCharacteristic(static_cast<Index>(mesh.Vertices.size()), mesh.Cells);
}

/// A row of unit squares along the x-axis.
ExtractedMesh Row(int squares)
{
  ExtractedMesh mesh;
  for (int i = 0; i <= squares; ++i)
  {
    for (const double y : { 0.0, 1.0 })
    {
      ExtractedMesh::Vertex vertex;
      vertex.Position = Vector3(i, y, 0.0);
      vertex.IsBoundary = true;
      mesh.Vertices.push_back(vertex);
    }
  }
  for (Index i = 0; i < squares; ++i)
  {
    mesh.Cells.Corners.push_back({ 2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1 });
    mesh.Cells.IsRegular.push_back(1);
    mesh.LineEdges.push_back({ { 2 * i, 2 * i + 2 }, 1 });
  }
  return mesh;
}

/// Vertices at equal distances on the lower edge of a square of the row.
BoundaryVertices OnLowerEdge(const ExtractedMesh& row, Index square, int count)
{
  BoundaryVertices vertices{ square, 2 * square, 2 * square + 2, {} };
  for (int k = 1; k <= count; ++k)
  {
    vertices.Positions.push_back(row.Vertices[2 * square].Position +
      static_cast<double>(k) / (count + 1) * Vector3(1.0, 0.0, 0.0));
  }
  return vertices;
}
}

TEST(MeshExtraction, FacesHaveTheTopologyOfTheSurface)
{
  for (const Surface& surface : { Meshes::Icosphere(2), Meshes::Torus(12, 9), Meshes::DoubleTorus(),
         Meshes::Disk(4), Meshes::Cylinder(9, 4, 1.0), Meshes::PlateWithHole(12, 4, 0.4, true) })
  {
    for (const int degree : { 4, 6 })
    {
      const CutExample example = CutExample::Random(surface, degree, 21);
      const ExtractedMesh mesh = Extracted(example, 6.0);
      EXPECT_FALSE(mesh.Failure);
      const TriangleMesh& before = example.Geometry.Mesh;
      EXPECT_EQ(EulerCharacteristicOf(mesh),
        before.GetNumberOfVertices() - before.GetNumberOfEdges() + before.GetNumberOfTriangles());
    }
  }
}

TEST(MeshExtraction, SquareBecomesTheCellsOfItsMap)
{
  const CutExample example = CutExample::AlongX(Meshes::Square(7), 4);
  const ExtractedMesh mesh = Extracted(example, 5.0);
  ASSERT_EQ(mesh.Cells.Corners.size(), 25U);
  EXPECT_EQ(mesh.Vertices.size(), 36U);
  EXPECT_EQ(mesh.KeptVertices, 0);
  EXPECT_NEAR(AreaOf(mesh), 1.0, 1e-5);
  Index boundary = 0;
  for (const ExtractedMesh::Vertex& vertex : mesh.Vertices)
  {
    boundary += vertex.IsBoundary ? 1 : 0;
  }
  EXPECT_EQ(boundary, 20);
  EXPECT_EQ(mesh.LineEdges.size(), 20U);
}

TEST(MeshExtraction, ComponentWithoutAMapKeepsItsTriangles)
{
  const CutExample example = CutExample::AlongX(Meshes::Square(3), 4);
  const ExtractedMesh mesh = Extracted(example, 1e6);
  EXPECT_EQ(mesh.Failure, MapFailure::TooManyCells);
  ASSERT_EQ(mesh.Cells.Corners.size(), 18U);
  EXPECT_EQ(mesh.Vertices.size(), 16U);
  EXPECT_NEAR(AreaOf(mesh), 1.0, 1e-12);
  for (const ExtractedMesh::Vertex& vertex : mesh.Vertices)
  {
    EXPECT_TRUE(vertex.IsCorner);
  }
}

TEST(BoundaryVertices, KeepAreaAndTopology)
{
  for (const int count : { 1, 2, 3, 6 })
  {
    ExtractedMesh row = Row(3);
    std::vector<BoundaryVertices> all = { OnLowerEdge(row, 2, count), OnLowerEdge(row, 0, 1) };
    InsertBoundaryVertices(row, all);
    EXPECT_EQ(row.Vertices.size(), static_cast<std::size_t>(8 + count + 1));
    EXPECT_EQ(EulerCharacteristicOf(row), 1);
    EXPECT_NEAR(AreaOf(row), 3.0, 1e-12);
    // One face more for each new vertex, and the middle one untouched.
    EXPECT_EQ(row.Cells.Corners.size(), static_cast<std::size_t>(3 + count + 1));
    EXPECT_EQ(std::count(row.Cells.IsRegular.begin(), row.Cells.IsRegular.end(), 1), 1);
    // The edges of the feature, divided.
    EXPECT_EQ(row.LineEdges.size(), static_cast<std::size_t>(3 + count + 1));
    double length = 0.0;
    for (const ExtractedMesh::LineEdge& edge : row.LineEdges)
    {
      length += (row.Vertices[edge.Ends[1]].Position - row.Vertices[edge.Ends[0]].Position).norm();
    }
    EXPECT_NEAR(length, 3.0, 1e-12);
  }
}
