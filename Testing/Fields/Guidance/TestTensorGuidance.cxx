// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DirectionField.h"
#include "Meshes/TensorFields.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
Result Field(const Surface& surface, const TensorGuidance& guidance, int degree)
{
  Options options;
  options.Degree = degree;
  options.ConstrainGuidance = true;
  return DirectionField(surface).Compute(options, guidance.Guidance);
}

/// The cosine of the largest angle between the lines of two guidances where both have weight; the
/// second is turned back.
double LeastCosine(const TensorGuidance& a, const TensorGuidance& b, const Matrix& turn)
{
  double least = 1.0;
  for (std::size_t i = 0; i < a.Anisotropy.size(); ++i)
  {
    EXPECT_NEAR(a.Guidance.Weights[i], b.Guidance.Weights[i], 1e-4);
    if (a.Guidance.Weights[i] > 0.0 && b.Guidance.Weights[i] > 0.0)
    {
      const Vector3 back = turn.transpose() * b.Guidance.Vectors[i];
      least = std::min(least, std::abs(a.Guidance.Vectors[i].dot(back)));
    }
  }
  return least;
}

std::string Refused(const Surface& surface, const SurfaceTensors& tensors)
{
  try
  {
    GuideByTensors(surface, tensors);
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "";
}
}

TEST(TensorGuidance, KirschPlateIsFollowedFromPointsAndTriangles)
{
  const Surface plate = Plate(240, 60);
  for (const bool atTriangles : { false, true })
  {
    const TensorGuidance guidance =
      GuideByTensors(plate, atTriangles ? AtTriangles(plate, Kirsch) : AtPoints(plate, Kirsch));
    for (const int degree : { 2, 4 })
    {
      const Result field = Field(plate, guidance, degree);
      const double error = Error(field, plate, KirschDeviator);
      EXPECT_LT(error, 0.3) << degree;
      EXPECT_EQ(Singular(field), 0) << degree;
    }
  }
  // The stress at the rim is three times that far away, and 0 along the rim.
  const TensorGuidance raw = GuideByTensors(plate, AtPoints(plate, Kirsch), { {}, 0.1 });
  EXPECT_NEAR(*std::max_element(raw.MajorValue.begin(), raw.MajorValue.end()), 3.0, 1e-2);
  EXPECT_NEAR(*std::min_element(raw.MinorValue.begin(), raw.MinorValue.end()), -1.0, 1e-2);
}

TEST(TensorGuidance, NoiseOfThePlateIsAveragedAwayOnCoarseMeshesToo)
{
  for (const Surface& plate : { Plate(240, 60), Plate(192, 48), EvenRing(192, 48) })
  {
    const double size = std::sqrt(MeanSquare(plate, KirschDeviator));
    const SurfaceTensors exact = AtPoints(plate, Kirsch);
    // What varies is not noise: at the hole, too, the directions are those of the tensors.
    EXPECT_LT(Error(Field(plate, GuideByTensors(plate, exact), 2), plate, KirschDeviator), 0.15);
    for (const auto& [noise, part] : { std::pair(0.1, 0.25), std::pair(0.3, 1.0 / 3.0) })
    {
      SurfaceTensors tensors = exact;
      AddNoise(noise * size, 3, tensors);
      const Result field = Field(plate, GuideByTensors(plate, tensors), 2);
      const double error = Error(field, plate, KirschDeviator);
      EXPECT_LT(error, part * RawError(tensors, plate, KirschDeviator)) << noise;
      EXPECT_EQ(Singular(field), 0) << noise;
    }
  }
}

TEST(TensorGuidance, IsotropicPointsAreTheSingularities)
{
  constexpr int cells = 100;
  const Surface square = Square(cells);
  const TensorAt at = [](const Vector3& p) { return Plane(Four(p), 0.3); };
  const double size = std::sqrt(MeanSquare(square, Four));
  SurfaceTensors tensors = AtPoints(square, at);
  const Result exact = Field(square, GuideByTensors(square, tensors), 2);
  EXPECT_EQ(Singular(exact), 4);
  EXPECT_LT(FarthestZero(exact, square, Four) * cells, 1.0);
  AddNoise(0.1 * size, 1, tensors);
  const Result noisy = Field(square, GuideByTensors(square, tensors), 2);
  EXPECT_EQ(Singular(noisy), 4);
  EXPECT_LT(FarthestZero(noisy, square, Four) * cells, 3.0);
  EXPECT_LT(Error(noisy, square, Four), 0.25 * RawError(tensors, square, Four));
}

TEST(TensorGuidance, TorusUnderPressureIsFollowedAroundItsTube)
{
  const Surface torus = Torus(160, 80);
  for (const bool atTriangles : { false, true })
  {
    const TensorGuidance guidance = GuideByTensors(
      torus, atTriangles ? AtTriangles(torus, TorusStress) : AtPoints(torus, TorusStress));
    const Result field = Field(torus, guidance, 2);
    double sum = 0.0;
    for (std::size_t i = 0; i < torus.Points.size(); ++i)
    {
      const Vector3& p = torus.Points[i];
      const Vector3 along = Vector3(-p.y(), p.x(), 0.0).normalized();
      const double off = 90.0 - Deviation(field, static_cast<Index>(i), along);
      sum += off * off;
    }
    EXPECT_LT(std::sqrt(sum / static_cast<double>(torus.Points.size())), 0.15) << atTriangles;
    EXPECT_EQ(Singular(field), 0);
    EXPECT_EQ(guidance.IsotropicShare, 0.0);
  }
}

TEST(TensorGuidance, MinorIsAtRightAnglesAndLargerMagnitudeChoosesCompression)
{
  const Surface square = Square(10);
  const SurfaceTensors tensors = AtPoints(square,
    [](const Vector3&) {
      return Plane({ 1.0, 0.0 }, -2.0);
    });
  const TensorGuidance major = GuideByTensors(square, tensors);
  for (const TensorDirection direction :
    { TensorDirection::Minor, TensorDirection::LargerMagnitude })
  {
    const TensorGuidance other = GuideByTensors(square, tensors, { direction });
    for (std::size_t i = 0; i < square.Points.size(); ++i)
    {
      EXPECT_NEAR(major.Guidance.Vectors[i].dot(other.Guidance.Vectors[i]), 0.0, 1e-6);
      EXPECT_NEAR(other.MajorValue[i], -1.0, 1e-6);
      EXPECT_NEAR(other.MinorValue[i], -3.0, 1e-6);
      EXPECT_NEAR(other.Anisotropy[i], 1.0, 1e-6);
    }
  }
  // Pure shear has no larger magnitude.
  const SurfaceTensors shear = AtPoints(square,
    [](const Vector3&) {
      return Plane({ 0.0, 1.0 }, 0.0);
    });
  const TensorGuidance none = GuideByTensors(square, shear, { TensorDirection::LargerMagnitude });
  EXPECT_LT(*std::max_element(none.Guidance.Weights.begin(), none.Guidance.Weights.end()), 1e-6);
  const Vector3 diagonal = GuideByTensors(square, shear).Guidance.Vectors[60];
  EXPECT_NEAR(std::abs(diagonal.x() * diagonal.y()), 0.5, 1e-6);
}

TEST(TensorGuidance, NeitherFrameNorUnitNorSideNorNormalPartMatters)
{
  const Surface torus = Torus(40, 20);
  const TensorGuidance given = GuideByTensors(torus, AtPoints(torus, TorusStress));
  const Matrix turn = ObliqueRotation(0.9);
  const Surface turned = Transformed(torus, turn, Vector3(1.0, 2.0, 3.0));
  for (const double unit : { 1e-150, 1.0, 1e150 })
  {
    SurfaceTensors tensors;
    tensors.Components = 9;
    for (const Vector3& p : torus.Points)
    {
      Matrix skew = Matrix::Zero();
      skew(0, 1) = 0.25;
      skew(1, 0) = -0.25;
      const Matrix other =
        unit * (turn * (TorusStress(p) + 0.5 * Matrix::Identity()) * turn.transpose() + skew);
      for (int row = 0; row < 3; ++row)
      {
        tensors.Values.insert(
          tensors.Values.end(), { other(row, 0), other(row, 1), other(row, 2) });
      }
    }
    const TensorGuidance again = GuideByTensors(turned, tensors);
    EXPECT_GT(LeastCosine(given, again, turn), 1.0 - 1e-8);
    EXPECT_NEAR(again.MajorValue[7] / unit, given.MajorValue[7] + 0.5, 1e-6);
    EXPECT_GT(again.AsymmetricPart, 0.2);
    EXPECT_LT(again.AsymmetricPart, 0.5);
  }
  EXPECT_EQ(given.AsymmetricPart, 0.0);
  Surface reversed = torus;
  for (Triangle& t : reversed.Triangles)
  {
    std::swap(t[1], t[2]);
  }
  for (const bool atTriangles : { false, true })
  {
    const auto tensors = [&](const Surface& surface)
    { return atTriangles ? AtTriangles(surface, TorusStress) : AtPoints(surface, TorusStress); };
    EXPECT_GT(LeastCosine(GuideByTensors(torus, tensors(torus)),
                GuideByTensors(reversed, tensors(reversed)), Matrix::Identity()),
      1.0 - 1e-8);
  }
}

TEST(TensorGuidance, WhatActsOnOrAcrossTheSurfaceIsLeftOut)
{
  const Surface plate = Plate(80, 20);
  const TensorAt loaded = [](const Vector3& p)
  {
    Matrix tensor = Kirsch(p);
    tensor(2, 2) = 5.0 + p.x();
    tensor(0, 2) = tensor(2, 0) = 2.0;
    tensor(1, 2) = tensor(2, 1) = -3.0 * p.y();
    return tensor;
  };
  const TensorGuidance given = GuideByTensors(plate, AtPoints(plate, Kirsch));
  const TensorGuidance again = GuideByTensors(plate, AtPoints(plate, loaded));
  EXPECT_GT(LeastCosine(given, again, Matrix::Identity()), 1.0 - 1e-12);
  EXPECT_NEAR(again.MajorValue[7], given.MajorValue[7], 1e-12);
  EXPECT_EQ(given.AcrossPart, 0.0);
  EXPECT_GT(again.AcrossPart, 0.2);
}

TEST(TensorGuidance, WhatIsIsotropicHasNoWeightAndIsFilledSmoothly)
{
  const Surface square = Square(60);
  const TensorGuidance none =
    GuideByTensors(square, AtPoints(square, [](const Vector3&) { return Matrix::Identity(); }));
  EXPECT_NEAR(none.IsotropicShare, 1.0, 1e-12);
  EXPECT_EQ(std::count(none.Guidance.Weights.begin(), none.Guidance.Weights.end(), 0.0),
    static_cast<std::ptrdiff_t>(square.Points.size()));
  EXPECT_NEAR(none.MajorValue[0], 1.0, 1e-6);
  const TensorAt half = [](const Vector3& p)
  { return Plane(std::polar(std::max(0.0, p.x() - 0.5), 3.0 * p.y()), 1.0); };
  const TensorGuidance guidance = GuideByTensors(square, AtPoints(square, half));
  EXPECT_NEAR(guidance.IsotropicShare, 0.5, 0.1);
  EXPECT_EQ(Singular(Field(square, guidance, 2)), 0);
  // There would be 26 if all of the noise counted for directions.
  SurfaceTensors noisy = AtPoints(square, half);
  AddNoise(0.02, 5, noisy);
  EXPECT_LE(Singular(Field(square, GuideByTensors(square, noisy), 2)), 2);
}

TEST(TensorGuidance, LinesFollowTensorsOnWhatCannotBeOriented)
{
  const Surface strip = MoebiusStrip(80, 8);
  const TensorAt at = [](const Vector3& p)
  {
    const Vector3 along = Vector3(-p.y(), p.x(), 0.0).normalized();
    return Matrix(along * along.transpose());
  };
  const TensorGuidance guidance = GuideByTensors(strip, AtPoints(strip, at));
  const Result field = Field(strip, guidance, 2);
  for (std::size_t i = 0; i < strip.Points.size(); ++i)
  {
    const Vector3& p = strip.Points[i];
    // The surface is not level away from its middle line.
    Vector3 along(-p.y(), p.x(), 0.0);
    along -= along.dot(field.Normal[i]) * field.Normal[i];
    EXPECT_LT(Deviation(field, static_cast<Index>(i), along.normalized()), 0.1);
  }
  EXPECT_EQ(Singular(field), 0);
}

TEST(TensorGuidance, WhatCannotBeUsedIsRefusedWithItsPlace)
{
  const Surface square = Square(4);
  SurfaceTensors tensors = AtPoints(square, Kirsch);
  tensors.Values.assign(tensors.Values.size(), 1.0);
  EXPECT_EQ(Refused(square, tensors), "");
  tensors.Values[6 * 13 + 2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(Refused(square, tensors).find("point 13"), std::string::npos);
  SurfaceTensors cells = AtTriangles(square, [](const Vector3&) { return Matrix::Identity(); });
  cells.Values[6 * 5] = std::numeric_limits<double>::infinity();
  EXPECT_NE(Refused(square, cells).find("triangle 5"), std::string::npos);
  cells.Components = 3;
  EXPECT_NE(Refused(square, cells).find("6 or 9 components: these have 3"), std::string::npos);
  tensors.Values.pop_back();
  EXPECT_NE(Refused(square, tensors).find("one tensor for each point"), std::string::npos);
  EXPECT_THROW(GuideByTensors(square,
                 AtPoints(square, [](const Vector3&) { return Matrix::Identity(); }), { {}, 33.0 }),
    std::invalid_argument);
}
