// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DirectionField.h"
#include "Guidance/TensorGuidance.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
using Matrix = Eigen::Matrix3d;
using TensorAt = std::function<Matrix(const Vector3&)>;

constexpr double HoleRadius = 0.15;

/// The plane tensor of mean h and deviator q.
Matrix Plane(const Complex& q, double h)
{
  Matrix tensor = Matrix::Zero();
  tensor.topLeftCorner<2, 2>() << h + q.real(), q.imag(), q.imag(), h - q.real();
  return tensor;
}

/// Half of the difference of the principal stresses and the mean around a hole in a plate that is
/// pulled along x (G. Kirsch 1898).
Complex KirschDeviator(const Vector3& p)
{
  const double s = HoleRadius * HoleRadius / (p.x() * p.x() + p.y() * p.y());
  const double t = std::atan2(p.y(), p.x());
  const Complex polar(0.5 * (-s + (1.0 - 2.0 * s + 3.0 * s * s) * std::cos(2.0 * t)),
    -0.5 * (1.0 + 2.0 * s - 3.0 * s * s) * std::sin(2.0 * t));
  return polar * std::polar(1.0, 2.0 * t);
}

Matrix Kirsch(const Vector3& p)
{
  const double s = HoleRadius * HoleRadius / (p.x() * p.x() + p.y() * p.y());
  return Plane(KirschDeviator(p), 0.5 - s * std::cos(2.0 * std::atan2(p.y(), p.x())));
}

/// The square plate [-1, 1]^2 with a hole, its points closer to each other near the hole, as meshes
/// for stress have it: the distances from the middle grow by the same factor from ring to ring.
Surface Plate(int around, int across)
{
  Surface plate = PlateWithHole(around, across, HoleRadius, false);
  for (Vector3& p : plate.Points)
  {
    const double end = p.norm() / p.lpNorm<Eigen::Infinity>();
    const double t = (p.norm() - HoleRadius) / (end - HoleRadius);
    p *= HoleRadius * std::pow(end / HoleRadius, t) / p.norm();
  }
  return plate;
}

std::vector<double> Areas(const Surface& surface)
{
  std::vector<double> areas(surface.Points.size(), 0.0);
  for (const Triangle& t : surface.Triangles)
  {
    const Vector3& p = surface.Points[t[0]];
    const double area = (surface.Points[t[1]] - p).cross(surface.Points[t[2]] - p).norm() / 6.0;
    for (const Index corner : t)
    {
      areas[corner] += area;
    }
  }
  return areas;
}

/// The membrane stress in a torus of radii 1 and 0.4 under pressure 1, of thickness 1.
Matrix TorusStress(const Vector3& p)
{
  const Vector3 outwards = Vector3(p.x(), p.y(), 0.0).normalized();
  const Vector3 along(-outwards.y(), outwards.x(), 0.0);
  const Vector3 normal = (p - outwards).normalized();
  const Vector3 around = along.cross(normal);
  const double distance = std::hypot(p.x(), p.y());
  return 0.2 * (1.0 + distance) / distance * around * around.transpose() +
    0.2 * along * along.transpose();
}

void Append(const Matrix& t, std::vector<double>& values)
{
  values.insert(values.end(), { t(0, 0), t(1, 1), t(2, 2), t(0, 1), t(1, 2), t(0, 2) });
}

SurfaceTensors AtPoints(const Surface& surface, const TensorAt& at)
{
  SurfaceTensors tensors;
  for (const Vector3& p : surface.Points)
  {
    Append(at(p), tensors.Values);
  }
  return tensors;
}

SurfaceTensors AtTriangles(const Surface& surface, const TensorAt& at)
{
  SurfaceTensors tensors;
  tensors.AtTriangles = true;
  for (const Triangle& t : surface.Triangles)
  {
    Append(at((surface.Points[t[0]] + surface.Points[t[1]] + surface.Points[t[2]]) / 3.0),
      tensors.Values);
  }
  return tensors;
}

void AddNoise(double size, unsigned seed, SurfaceTensors& tensors)
{
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal(0.0, size);
  for (double& value : tensors.Values)
  {
    value += normal(generator);
  }
}

Result Field(const Surface& surface, const TensorGuidance& guidance, int degree)
{
  Options options;
  options.Degree = degree;
  options.ConstrainGuidance = true;
  return DirectionField(surface).Compute(options, guidance.Guidance);
}

double MeanSquare(const Surface& surface, const std::function<Complex(const Vector3&)>& q)
{
  double sum = 0.0;
  for (const Vector3& p : surface.Points)
  {
    sum += std::norm(q(p));
  }
  return sum / static_cast<double>(surface.Points.size());
}

/// Root mean square of the angle to the direction of a plane deviator over the area, degrees, where
/// that is more than a twentieth of its own.
double Error(
  const Result& field, const Surface& surface, const std::function<Complex(const Vector3&)>& q)
{
  const double least = 0.05 * std::sqrt(MeanSquare(surface, q));
  const std::vector<double> areas = Areas(surface);
  double sum = 0.0;
  double area = 0.0;
  for (std::size_t i = 0; i < surface.Points.size(); ++i)
  {
    const Complex at = q(surface.Points[i]);
    if (std::abs(at) > least)
    {
      const Complex z = std::polar(1.0, 0.5 * std::arg(at));
      const double off = Deviation(field, static_cast<Index>(i), Vector3(z.real(), z.imag(), 0.0));
      sum += areas[i] * off * off;
      area += areas[i];
    }
  }
  return std::sqrt(sum / area);
}

/// The error of the tensors' own eigenvectors.
double RawError(const SurfaceTensors& tensors, const Surface& surface,
  const std::function<Complex(const Vector3&)>& q)
{
  const double least = 0.05 * std::sqrt(MeanSquare(surface, q));
  const std::vector<double> areas = Areas(surface);
  double sum = 0.0;
  double area = 0.0;
  for (std::size_t i = 0; i < surface.Points.size(); ++i)
  {
    const Complex at = q(surface.Points[i]);
    const double* t = &tensors.Values[6 * i];
    const Complex raw(0.5 * (t[0] - t[1]), t[3]);
    if (std::abs(at) > least)
    {
      const double off = 0.5 * std::arg(raw / at) * 180.0 / Pi;
      sum += areas[i] * off * off;
      area += areas[i];
    }
  }
  return std::sqrt(sum / area);
}

Index Singular(const Result& field)
{
  return static_cast<Index>(std::count_if(field.SingularityIndex.begin(),
    field.SingularityIndex.end(), [](int index) { return index != 0; }));
}

/// The tensor of deviator prod (z - wedge) prod conj(z - trisector) on the unit square.
struct Zeros
{
  std::vector<Complex> Wedges;
  std::vector<Complex> Trisectors;

  Complex operator()(const Vector3& p) const
  {
    const Complex z(p.x(), p.y());
    Complex q = 1.0;
    for (const Complex& w : this->Wedges)
    {
      q *= z - w;
    }
    for (const Complex& t : this->Trisectors)
    {
      q *= std::conj(z - t);
    }
    return q;
  }
};

const Zeros Four{ { { 0.25, 0.3 }, { 0.73, 0.71 } }, { { 0.71, 0.27 }, { 0.28, 0.74 } } };

/// Each singular triangle is within so many edges of the zero of its sign, and each zero has one.
void ExpectZeros(
  const Result& field, const Surface& surface, const Zeros& zeros, double edge, double edges)
{
  EXPECT_EQ(Singular(field), static_cast<Index>(zeros.Wedges.size() + zeros.Trisectors.size()));
  for (const auto& [sign, places] : { std::pair(1, zeros.Wedges), std::pair(-1, zeros.Trisectors) })
  {
    for (const Complex& place : places)
    {
      double nearest = 1.0;
      for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
      {
        const Triangle& corners = surface.Triangles[t];
        const Vector3 middle =
          (surface.Points[corners[0]] + surface.Points[corners[1]] + surface.Points[corners[2]]) /
          3.0;
        if (field.SingularityIndex[t] == sign)
        {
          nearest = std::min(nearest, std::abs(Complex(middle.x(), middle.y()) - place));
        }
      }
      EXPECT_LT(nearest / edge, edges) << place;
    }
  }
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

TEST(TensorGuidance, NoiseOfThePlateIsAveragedAway)
{
  const Surface plate = Plate(240, 60);
  const double size = std::sqrt(MeanSquare(plate, KirschDeviator));
  for (const auto& [noise, part] : { std::pair(0.1, 0.25), std::pair(0.3, 1.0 / 3.0) })
  {
    SurfaceTensors tensors = AtPoints(plate, Kirsch);
    AddNoise(noise * size, 3, tensors);
    const Result field = Field(plate, GuideByTensors(plate, tensors), 2);
    const double error = Error(field, plate, KirschDeviator);
    EXPECT_LT(error, part * RawError(tensors, plate, KirschDeviator)) << noise;
    EXPECT_EQ(Singular(field), 0) << noise;
  }
}

TEST(TensorGuidance, IsotropicPointsAreTheSingularities)
{
  constexpr int cells = 100;
  const Surface square = Square(cells);
  const TensorAt at = [](const Vector3& p) { return Plane(Four(p), 0.3); };
  const double size = std::sqrt(MeanSquare(square, Four));
  SurfaceTensors tensors = AtPoints(square, at);
  ExpectZeros(Field(square, GuideByTensors(square, tensors), 2), square, Four, 1.0 / cells, 1.0);
  AddNoise(0.1 * size, 1, tensors);
  const Result noisy = Field(square, GuideByTensors(square, tensors), 2);
  ExpectZeros(noisy, square, Four, 1.0 / cells, 3.0);
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
