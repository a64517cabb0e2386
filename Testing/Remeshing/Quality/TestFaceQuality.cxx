// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Quality/QualityReport.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace DirectionFields;

namespace
{
FaceQuality Of(const std::vector<Vector3>& points)
{
  return QualityOf(points, { { 0, 1, 2, points.size() == 4 ? 3 : None } });
}

void ExpectQuality(
  const std::vector<Vector3>& points, double scaledJacobian, double aspectRatio, double warpage)
{
  const FaceQuality quality = Of(points);
  EXPECT_NEAR(quality.ScaledJacobian[0], scaledJacobian, 1e-14);
  EXPECT_NEAR(quality.AspectRatio[0], aspectRatio, 1e-14 * aspectRatio);
  EXPECT_NEAR(quality.Warpage[0], warpage, 1e-14);
}

const std::vector<Vector3> Square = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
}

/// All three are best for squares and even triangles.
TEST(FaceQuality, OfEvenFaces)
{
  ExpectQuality(Square, 1.0, 1.0, 0.0);
  ExpectQuality({ { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, std::sqrt(0.75), 0 } }, 1.0, 1.0, 0.0);
}

TEST(FaceQuality, OfLongAndSlantedFaces)
{
  // A rectangle of 3 x 1: 3 times 8 over 4 times 3.
  ExpectQuality({ { 0, 0, 5 }, { 3, 0, 5 }, { 3, 1, 5 }, { 0, 1, 5 } }, 1.0, 2.0, 0.0);
  // A rhombus of 60 degrees: the circumference is 4, the area sin 60 degrees.
  const double height = std::sqrt(0.75);
  ExpectQuality({ { 0, 0, 0 }, { 1, 0, 0 }, { 1.5, height, 0 }, { 0.5, height, 0 } }, height,
    1.0 / height, 0.0);
  // A right triangle of 3, 4 and 5.
  ExpectQuality({ { 0, 0, 0 }, { 4, 0, 0 }, { 0, 3, 0 } }, 2.0 / std::sqrt(3.0) * 3.0 / 5.0,
    5.0 * 12.0 / (4.0 * std::sqrt(3.0) * 6.0), 0.0);
}

/// Two opposite corners of a square are lifted by h: its normals at the corners are (+-h, +-h, 1).
TEST(FaceQuality, OfWarpedFaces)
{
  for (const double h : { 0.1, 0.5, 2.0 })
  {
    const double cosine = (1.0 - 2.0 * h * h) / (1.0 + 2.0 * h * h);
    const FaceQuality quality = Of({ { 0, 0, 0 }, { 1, 0, h }, { 1, 1, 0 }, { 0, 1, h } });
    EXPECT_NEAR(quality.Warpage[0], 1.0 - std::pow(cosine, 3), 1e-14);
  }
}

TEST(FaceQuality, OfFoldedFacesAndThoseWithoutArea)
{
  // The third corner is pulled inside: its angle is above 180 degrees.
  const FaceQuality dart = Of({ { 0, 0, 0 }, { 1, 0, 0 }, { 0.3, 0.3, 0 }, { 0, 1, 0 } });
  EXPECT_LT(dart.ScaledJacobian[0], -0.5);
  EXPECT_NEAR(dart.Warpage[0], 2.0, 1e-14);
  ExpectQuality({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 } }, 0.0, 1e30, 1.0);
  ExpectQuality(std::vector<Vector3>(4, Vector3::Ones()), 0.0, 1e30, 1.0);
  ExpectQuality(std::vector<Vector3>(3, Vector3::Ones()), 0.0, 1e30, 0.0);
}

/// Squares and products of the lengths would be out of range.
TEST(FaceQuality, DoesNotDependOnTheUnit)
{
  const std::vector<Vector3> kite = { { 0, 0, 0 }, { 1, 0, 0.2 }, { 1.3, 1.2, 0 }, { 0, 1, 0.1 } };
  const FaceQuality quality = Of(kite);
  for (const int exponent : { -1000, -500, 60, 900 })
  {
    std::vector<Vector3> scaled;
    for (const Vector3& point : kite)
    {
      scaled.push_back(std::ldexp(1.0, exponent) * point);
    }
    ExpectQuality(scaled, quality.ScaledJacobian[0], quality.AspectRatio[0], quality.Warpage[0]);
  }
}

TEST(QualityReport, CountsFacesThatFail)
{
  const FaceQuality quality{ { 1.0, 0.5, 0.2, 0.9 }, { 1.0, 2.0, 5.0, 6.0 },
    { 0.0, 0.1, 0.0, 0.3 } };
  const QualityReport free = ReportQuality(quality);
  EXPECT_EQ(free.LeastScaledJacobian, 0.2);
  EXPECT_NEAR(free.MeanScaledJacobian, 0.65, 1e-15);
  EXPECT_EQ(free.LargestAspectRatio, 6.0);
  EXPECT_EQ(free.LargestWarpage, 0.3);
  EXPECT_TRUE(free.Pass.empty() && free.Sentences.empty() && !free.IsLimited);

  // A face on the limit keeps it.
  EXPECT_EQ(ReportQuality(quality, { 0.5, 0.0, 0.0 }).Pass, std::vector<char>({ 1, 1, 0, 1 }));
  EXPECT_EQ(ReportQuality(quality, { 0.0, 5.0, 0.0 }).Pass, std::vector<char>({ 1, 1, 1, 0 }));
  EXPECT_EQ(ReportQuality(quality, { 0.0, 0.0, 0.05 }).Pass, std::vector<char>({ 1, 0, 1, 0 }));
  const QualityReport all = ReportQuality(quality, { 0.5, 5.0, 0.05 });
  EXPECT_EQ(all.FailedFaces, 3);
  ASSERT_EQ(all.Sentences.size(), 1U);
  EXPECT_EQ(all.Sentences[0].substr(0, all.Sentences[0].find(". ")),
    "3 of 4 faces fail the limits: 1 with a scaled Jacobian below 0.5, 1 with an aspect ratio "
    "above 5, 2 with a warpage above 0.05");
  EXPECT_TRUE(ReportQuality(quality, { 0.1, 9.0, 1.0 }).Sentences.empty());
}
