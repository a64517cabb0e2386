// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DirectionField.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
Options Lines(CurvatureDirection direction, double strength)
{
  Options options;
  options.Degree = 2;
  options.Alignment = Alignment::PrincipalCurvature;
  options.CurvatureDirection = direction;
  options.AlignmentStrength = strength;
  return options;
}

Surface InsideOut(Surface surface)
{
  for (Triangle& t : surface.Triangles)
  {
    std::swap(t[0], t[1]);
  }
  return surface;
}

/// The square [0, 2]^2 with waves along x, whose heights are of this size.
Surface Waves(int cells, double size)
{
  Surface surface = Square(cells, 2.0);
  for (Vector3& p : surface.Points)
  {
    p.z() = size * std::cos(2.0 * Pi * p.x());
  }
  return surface;
}

Surface Single(Surface surface)
{
  for (Vector3& p : surface.Points)
  {
    for (double& x : p)
    {
      const volatile auto rounded = static_cast<float>(x);
      x = rounded;
    }
  }
  return surface;
}

Index Singular(const Result& result)
{
  return static_cast<Index>(result.SingularityIndex.size()) -
    static_cast<Index>(
      std::count(result.SingularityIndex.begin(), result.SingularityIndex.end(), 0));
}

bool Notes(const Result& result, const std::string& what)
{
  return std::any_of(result.Notes.begin(), result.Notes.end(),
    [&](const std::string& note) { return note.find(what) != std::string::npos; });
}
}

TEST(CurvatureOptions, WhatIsInsideOutIsSeenFromOutside)
{
  const Surface potato = Potato(4);
  for (const CurvatureDirection direction : { CurvatureDirection::Maximum,
         CurvatureDirection::Minimum, CurvatureDirection::LeastBent, CurvatureDirection::MostBent })
  {
    const Options options = Lines(direction, 0.95);
    const Result right = DirectionField(potato).Compute(options);
    const Result wrong = DirectionField(InsideOut(potato)).Compute(options);
    EXPECT_FALSE(Notes(right, "inside out"));
    EXPECT_TRUE(Notes(wrong, "inside out"));
    EXPECT_EQ(wrong.Notes.size(), 1u);
    double off = 0.0;
    for (Index i = 0; i < static_cast<Index>(potato.Points.size()); ++i)
    {
      EXPECT_NEAR(right.Curvature->Mean[i], wrong.Curvature->Mean[i], 1e-6);
      EXPECT_NEAR(right.Curvature->Gaussian[i], wrong.Curvature->Gaussian[i], 1e-6);
      off += Deviation(wrong, i, right.Direction(i, 0));
    }
    EXPECT_LT(off / static_cast<double>(potato.Points.size()), 0.1);
  }
}

TEST(CurvatureOptions, OpenSurfacesHaveNoInside)
{
  for (const Surface& surface : { InsideOut(Waves(20, 0.1)), InsideOut(Hemisphere(3)) })
  {
    const Result result = DirectionField(surface).Compute(Lines(CurvatureDirection::Maximum, 0.5));
    EXPECT_FALSE(Notes(result, "inside out"));
  }
  EXPECT_LT(DirectionField(InsideOut(Hemisphere(3)))
              .Compute(Lines(CurvatureDirection::Maximum, 0.5))
              .Curvature->Mean[0],
    0.0);
}

TEST(CurvatureOptions, LeastAndMostBentDoNotSwapWhereTheSurfaceIsConcave)
{
  const Surface waves = Waves(80, 0.06);
  const auto off = [&](CurvatureDirection direction, bool crests)
  {
    const Result result = DirectionField(waves).Compute(Lines(direction, 0.9999));
    double sum = 0.0;
    double count = 0.0;
    for (Index i = 0; i < static_cast<Index>(waves.Points.size()); ++i)
    {
      const Vector3& p = waves.Points[i];
      const bool inside = p.x() > 0.2 && p.x() < 1.8 && p.y() > 0.2 && p.y() < 1.8;
      if (inside && (crests ? p.z() > 0.04 : p.z() < -0.04))
      {
        // The direction across the waves lies in the plane of x and z.
        sum += std::asin(std::min(1.0, std::abs(result.Direction(i, 0).y()))) * 180.0 / Pi;
        count += 1.0;
      }
    }
    return sum / count;
  };
  for (const bool crests : { true, false })
  {
    EXPECT_LT(off(CurvatureDirection::MostBent, crests), 2.0);
    EXPECT_GT(off(CurvatureDirection::LeastBent, crests), 88.0);
  }
  EXPECT_LT(off(CurvatureDirection::Maximum, true), 2.0);
  EXPECT_GT(off(CurvatureDirection::Maximum, false), 88.0);
  EXPECT_GT(off(CurvatureDirection::Minimum, true), 88.0);
  EXPECT_LT(off(CurvatureDirection::Minimum, false), 2.0);
}

TEST(CurvatureOptions, LinesFollowTheLeastBentDirectionOfWhatCannotBeOriented)
{
  const Surface bottle = KleinBottle(60, 40);
  const Result least = DirectionField(bottle).Compute(Lines(CurvatureDirection::LeastBent, 0.9));
  EXPECT_TRUE(least.Notes.empty());
  EXPECT_LT(least.Components[0].Lambda, least.Components[0].Eigenvalue);
  const Result maximum = DirectionField(bottle).Compute(Lines(CurvatureDirection::Maximum, 0.9));
  EXPECT_TRUE(Notes(maximum, "change places"));
  EXPECT_DOUBLE_EQ(maximum.Components[0].Lambda, maximum.Components[0].Eigenvalue);
}

TEST(CurvatureOptions, ALargerScaleSmoothsMore)
{
  Surface surface = Potato(5);
  surface = Jittered(surface, 0.004, 5);
  DirectionField field(surface);
  Options options;
  options.Alignment = Alignment::PrincipalCurvature;
  options.AlignmentStrength = 1.0;
  options.CurvatureScale = 1.0;
  Index last = Singular(field.Compute(options));
  for (const double scale : { 3.0, 6.0, 12.0 })
  {
    options.CurvatureScale = scale;
    const Result result = field.Compute(options);
    EXPECT_LT(Singular(result), 0.8 * static_cast<double>(last)) << scale;
    EXPECT_EQ(result.Curvature->Mean, DirectionField(surface).Compute(options).Curvature->Mean);
    last = Singular(result);
  }
  for (const double bad : { -1.0, 33.0, std::nan("") })
  {
    options.CurvatureScale = bad;
    EXPECT_THROW(field.Compute(options), std::invalid_argument);
  }
}

TEST(CurvatureOptions, FlatSurfacesFollowNothingHoweverTheyAreTurned)
{
  for (const double angle : { 0.3, 1.0, 2.0 })
  {
    const Surface flat =
      Single(Transformed(Square(40), ObliqueRotation(angle), Vector3(0.3, 4.0, -2.0)));
    for (const int degree : { 2, 4 })
    {
      Options options = Lines(CurvatureDirection::Maximum, 0.95);
      options.Degree = degree;
      const Result result = DirectionField(flat).Compute(options);
      EXPECT_EQ(Singular(result), 0);
      EXPECT_TRUE(Notes(result, "zero everywhere"));
      Options plain;
      plain.Degree = degree;
      EXPECT_EQ(result.Representation, DirectionField(flat).Compute(plain).Representation);
    }
  }
}

TEST(CurvatureOptions, AFlatPlateBesideACurvedBodyFollowsNothing)
{
  const Surface plate = Transformed(Square(40), ObliqueRotation(1.0), { 3.0, 0.0, 0.0 });
  const Result result = DirectionField(Single(Joined(Potato(4), plate)))
                          .Compute(Lines(CurvatureDirection::Maximum, 0.95));
  ASSERT_EQ(result.Components.size(), 2u);
  EXPECT_LT(result.Components[0].Lambda, 0.0);
  EXPECT_DOUBLE_EQ(result.Components[1].Lambda, result.Components[1].Eigenvalue);
  EXPECT_EQ(std::count_if(result.SingularityIndex.end() - 3200, result.SingularityIndex.end(),
              [](int index) { return index != 0; }),
    0);
}

TEST(CurvatureOptions, AnAlmostFlatPlateFollowsLittleBesideACurvedBodyAndMuchAlone)
{
  const Surface plate = Transformed(Waves(40, 1e-5), ObliqueRotation(1.0), { 3.0, 0.0, 0.0 });
  const Options options = Lines(CurvatureDirection::MostBent, 0.9);
  const Result alone = DirectionField(plate).Compute(options);
  const Result both = DirectionField(Joined(Potato(4), plate)).Compute(options);
  ASSERT_EQ(both.Components.size(), 2u);
  const auto gap = [](const ComponentReport& c) { return c.Eigenvalue - c.Lambda; };
  EXPECT_GT(gap(alone.Components[0]), 10.0);
  EXPECT_LT(gap(both.Components[1]), 0.01 * gap(alone.Components[0]));
  EXPECT_GT(gap(both.Components[1]), 0.0);
  // Waves of a hundredth of the length are shape.
  const Surface bent = Transformed(Waves(40, 0.02), ObliqueRotation(1.0), { 3.0, 0.0, 0.0 });
  EXPECT_EQ(DirectionField(Joined(Potato(4), bent)).Compute(options).Components[1].Lambda,
    DirectionField(bent).Compute(options).Components[0].Lambda);
}
