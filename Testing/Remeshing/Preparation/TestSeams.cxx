// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remesh.h"

#include "Meshes/FacesAtEdges.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace DirectionFields;

namespace
{
/// Squares that have one side in common, the z axis, like the pages of a book.
Surface Book(int pages, int cells)
{
  Surface book;
  const auto point = [&](int page, int i, int j)
  { return static_cast<Index>(i == 0 ? j : (cells + 1) * (1 + page * cells + i - 1) + j); };
  for (int j = 0; j <= cells; ++j)
  {
    book.Points.emplace_back(0.0, 0.0, static_cast<double>(j) / cells);
  }
  for (int page = 0; page < pages; ++page)
  {
    const double angle = 2.0 * Pi * page / pages;
    for (int i = 1; i <= cells; ++i)
    {
      for (int j = 0; j <= cells; ++j)
      {
        const double x = static_cast<double>(i) / cells;
        book.Points.emplace_back(
          x * std::cos(angle), x * std::sin(angle), static_cast<double>(j) / cells);
      }
    }
    for (int i = 0; i < cells; ++i)
    {
      for (int j = 0; j < cells; ++j)
      {
        const std::array<Index, 4> q = { point(page, i, j), point(page, i + 1, j),
          point(page, i + 1, j + 1), point(page, i, j + 1) };
        book.Triangles.push_back({ q[0], q[1], q[2] });
        book.Triangles.push_back({ q[0], q[2], q[3] });
      }
    }
  }
  return book;
}

RemeshResult Remeshed(const Surface& surface, Index faces, bool pureQuads = false)
{
  RemeshOptions options;
  options.NumberOfFaces = faces;
  options.PureQuads = pureQuads;
  return Remesh(std::make_shared<Surface>(surface)).Compute(options);
}

/// Whether each sentence has one of these words.
bool NoneBut(const std::vector<std::string>& notes, const std::vector<std::string>& words)
{
  return std::all_of(notes.begin(), notes.end(),
    [&](const std::string& note)
    {
      return std::any_of(words.begin(), words.end(),
        [&](const std::string& text) { return note.find(text) != std::string::npos; });
    });
}
}

TEST(Seams, OfSurfacesWithOneSideAreClosedAgain)
{
  const std::vector<std::pair<Surface, int>> surfaces = { { Meshes::MoebiusStrip(60, 6), 0 },
    { Meshes::KleinBottle(40, 20), 0 }, { Meshes::ProjectivePlane(3), 1 } };
  for (const auto& [surface, euler] : surfaces)
  {
    for (const bool pureQuads : { false, true })
    {
      const RemeshResult mesh = Remeshed(surface, 600, pureQuads);
      // The plane crosses itself, which faces of this size cannot follow to the end: some are flat,
      // and some look to the other side.
      EXPECT_TRUE(NoneBut(mesh.Notes,
        { "are triangles", "away from the mesh", "Jacobian below 0.1", "turned over" }));
      EXPECT_EQ(mesh.EulerCharacteristicBefore, euler);
      EXPECT_EQ(mesh.EulerCharacteristicAfter, euler);
      EXPECT_NEAR(static_cast<double>(mesh.Faces.size()), 600.0, 90.0);
      EXPECT_GT(mesh.Quads, 0.85 * static_cast<double>(mesh.Faces.size()));
      EXPECT_TRUE(!pureQuads || mesh.Triangles == 0);
      Index boundary = 0;
      for (const auto& [edge, faces] : Meshes::FacesAtEdges(mesh.Faces))
      {
        EXPECT_LE(faces, 2);
        boundary += faces == 1 ? 1 : 0;
      }
      // Only the strip has a boundary.
      EXPECT_EQ(boundary > 0, &surface == &surfaces.front().first);
    }
  }
}

TEST(Seams, BetweenSheetsHaveTheSameVerticesOnAllSides)
{
  for (const int pages : { 3, 4 })
  {
    for (const bool pureQuads : { false, true })
    {
      const RemeshResult mesh = Remeshed(Book(pages, 9), 100 * pages, pureQuads);
      EXPECT_TRUE(mesh.Notes.empty());
      EXPECT_EQ(mesh.EulerCharacteristicBefore, 1);
      EXPECT_EQ(mesh.EulerCharacteristicAfter, 1);
      EXPECT_EQ(mesh.Triangles, 0);
      const auto isOnSpine = [&](Index v) { return mesh.Points[v].head<2>().norm() < 1e-9; };
      double length = 0.0;
      for (const auto& [edge, faces] : Meshes::FacesAtEdges(mesh.Faces))
      {
        if (isOnSpine(edge[0]) && isOnSpine(edge[1]))
        {
          EXPECT_EQ(faces, pages);
          length += (mesh.Points[edge[0]] - mesh.Points[edge[1]]).norm();
        }
        else
        {
          EXPECT_LE(faces, 2);
        }
      }
      EXPECT_NEAR(length, 1.0, 1e-9);
    }
  }
}

TEST(Seams, OfSheetsOfDifferentSizesAreJoined)
{
  // Two pages ask for edges that are shorter at the spine's upper half, the third one for the same everywhere.
  const Surface book = Book(3, 12);
  RemeshOptions options;
  options.NumberOfFaces = 500;
  for (std::size_t p = 0; p < book.Points.size(); ++p)
  {
    options.Sizing.push_back(p % 13 > 6 && p < 13 * 25 ? 0.4 : 1.0);
  }
  const RemeshResult mesh = Remesh(std::make_shared<Surface>(book)).Compute(options);
  // Sizes that jump are not met beside the jump.
  for (const std::string& note : mesh.Notes)
  {
    EXPECT_NE(note.find("as long as the sizes ask for"), std::string::npos) << note;
  }
  EXPECT_EQ(mesh.EulerCharacteristicAfter, 1);
  for (const auto& [edge, faces] : Meshes::FacesAtEdges(mesh.Faces))
  {
    const bool isOnSpine =
      mesh.Points[edge[0]].head<2>().norm() < 1e-9 && mesh.Points[edge[1]].head<2>().norm() < 1e-9;
    EXPECT_TRUE(!isOnSpine || faces == 3);
  }
}
