// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Surfaces in pieces, each with triangles of the others for ghosts.

#include "DirectionField.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
/// Piece of each triangle: a third each by the height of its middle.
std::vector<int> Pieces(const Surface& surface)
{
  std::vector<int> pieces;
  for (const Triangle& t : surface.Triangles)
  {
    const double z =
      (surface.Points[t[0]].z() + surface.Points[t[1]].z() + surface.Points[t[2]].z()) / 3.0;
    pieces.push_back(z < -0.3 ? 0 : z < 0.4 ? 1 : 2);
  }
  return pieces;
}

/// The triangles of a piece, and for ghosts those within the given number of layers around, in an
/// order of its own. Points are not renumbered.
Surface PieceOf(const Surface& whole, const std::vector<int>& pieces, int piece, int layers)
{
  std::vector<char> taken(whole.Triangles.size(), 0);
  for (std::size_t t = 0; t < taken.size(); ++t)
  {
    taken[t] = pieces[t] == piece;
  }
  for (int layer = 0; layer < layers; ++layer)
  {
    std::vector<char> touched(whole.Points.size(), 0);
    for (std::size_t t = 0; t < taken.size(); ++t)
    {
      for (const Index point : whole.Triangles[t])
      {
        touched[point] |= taken[t];
      }
    }
    for (std::size_t t = 0; t < taken.size(); ++t)
    {
      for (const Index point : whole.Triangles[t])
      {
        taken[t] |= touched[point];
      }
    }
  }
  Surface part;
  part.Points = whole.Points;
  for (std::size_t t = taken.size(); t-- > 0;)
  {
    if (taken[t])
    {
      Triangle corners = whole.Triangles[t];
      std::rotate(corners.begin(), corners.begin() + piece, corners.end());
      part.Triangles.push_back(corners);
      part.Ghost.push_back(pieces[t] != piece);
    }
  }
  return part;
}
}

TEST(Ghosts, PiecesAddUpToTheWhole)
{
  for (const Surface& surface : { Potato(2), Torus(24, 12), Hemisphere(2) })
  {
    const Result whole = DirectionField(surface).Compute({});
    const std::vector<int> pieces = Pieces(surface);
    for (const int layers : { 1, 2, 3 })
    {
      ComponentReport sum;
      for (int piece = 0; piece < 3; ++piece)
      {
        const Surface part = PieceOf(surface, pieces, piece, layers);
        const Result result = DirectionField(part).Compute({});
        int indices = 0;
        for (std::size_t t = 0; t < part.Triangles.size(); ++t)
        {
          indices += part.Ghost[t] ? 0 : result.SingularityIndex[t];
        }
        for (const ComponentReport& component : result.Components)
        {
          sum.EulerCharacteristic += component.EulerCharacteristic;
          sum.Vertices += component.Vertices;
          sum.Triangles += component.Triangles;
          indices -= component.IndexSum;
          EXPECT_FALSE(component.Closed);
        }
        EXPECT_EQ(indices, 0);
      }
      EXPECT_EQ(sum.EulerCharacteristic, whole.Components[0].EulerCharacteristic);
      EXPECT_EQ(sum.Vertices, whole.Components[0].Vertices);
      EXPECT_EQ(sum.Triangles, whole.Components[0].Triangles);
    }
  }
}

TEST(Ghosts, TakePartInTheSolve)
{
  // Each piece knows the whole: the field is the same everywhere, and its indices are counted once.
  const Surface surface = Potato(2);
  const std::vector<int> pieces = Pieces(surface);
  Options options;
  options.Tolerance = 1e-11;
  const Result whole = DirectionField(surface).Compute(options);
  int indices = 0;
  for (int piece = 0; piece < 3; ++piece)
  {
    const Surface part = PieceOf(surface, pieces, piece, 100);
    ASSERT_EQ(part.Triangles.size(), surface.Triangles.size());
    const Result result = DirectionField(part).Compute(options);
    ASSERT_EQ(result.Components.size(), 1u);
    EXPECT_NEAR(result.Components[0].Eigenvalue, whole.Components[0].Eigenvalue, 1e-9);
    for (Index i = 0; i < static_cast<Index>(surface.Points.size()); ++i)
    {
      EXPECT_LT((result.Direction(i, 0) - whole.Direction(i, 0)).norm(), 1e-6);
    }
    indices += result.Components[0].IndexSum;
    EXPECT_NE(result.Components[0].IndexSum, 8);
  }
  EXPECT_EQ(indices, 8);
}

TEST(Ghosts, ConstraintsCountInOnePiece)
{
  const Surface surface = Hemisphere(2);
  const std::vector<int> pieces = Pieces(surface);
  Options options;
  options.ConstrainBoundary = true;
  const Index all = DirectionField(surface).Compute(options).Components[0].Constraints;
  // The boundary, at the height 0, is in piece 1 alone; that of the layer around piece 2 is none of
  // its own.
  const auto count = [&](int piece)
  {
    return DirectionField(PieceOf(surface, pieces, piece, 2))
      .Compute(options)
      .Components[0]
      .Constraints;
  };
  EXPECT_EQ(count(1), all);
  EXPECT_EQ(count(2), 0);
}
