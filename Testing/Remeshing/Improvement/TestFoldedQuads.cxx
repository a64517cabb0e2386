// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Improvement/FoldedQuads.h"

#include <gtest/gtest.h>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

TEST(FoldedQuads, AreCutAlongTheDiagonalThatLiesInside)
{
  // A dart, concave at its corner 2, beside a square.
  const std::vector<Vector3> points = { { 0.0, 0.0, 0.0 }, { 2.0, 0.0, 0.0 }, { 0.5, 0.5, 0.0 },
    { 0.0, 2.0, 0.0 }, { -2.0, 2.0, 0.0 }, { -2.0, 0.0, 0.0 } };
  Faces faces{ { { 0, 1, 2, 3 }, { 0, 3, 4, 5 } }, { 1, 1 } };
  EXPECT_LE(ScaledJacobian(points, faces.Corners[0]), 0.0);
  EXPECT_EQ(CutFoldedQuads(faces, points), 1);
  const std::vector<Faces::Face> expected = { { 0, 1, 2, None }, { 0, 3, 4, 5 },
    { 0, 2, 3, None } };
  EXPECT_EQ(faces.Corners, expected);
  EXPECT_EQ(faces.IsRegular, (std::vector<char>{ 0, 1, 0 }));
  EXPECT_EQ(CutFoldedQuads(faces, points), 0);
}

TEST(FoldedQuads, GetNoEdgeThatIsThereAlready)
{
  // The same dart, but a triangle below has the good diagonal: the other one is left.
  const std::vector<Vector3> points = { { 0.0, 0.0, 0.0 }, { 2.0, 0.0, 0.0 }, { 0.5, 0.5, 0.0 },
    { 0.0, 2.0, 0.0 }, { 0.0, 0.0, -1.0 } };
  Faces faces{ { { 0, 1, 2, 3 }, { 0, 2, 4, None } }, { 1, 0 } };
  CutFoldedQuads(faces, points);
  for (const Faces::Face& face : faces.Corners)
  {
    EXPECT_TRUE(Faces::Size(face) == 3);
  }
  EXPECT_EQ(faces.Corners[0], (Faces::Face{ 1, 2, 3, None }));
}
