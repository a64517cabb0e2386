// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DirectionField.h"
#include "Meshes/TensorFields.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
Options OfDegree(int degree)
{
  Options options;
  options.Degree = degree;
  options.AlignmentStrength = 1.0;
  return options;
}

Result Follow(const Surface& surface, const SurfaceTensors& tensors, const Options& options,
  const Guidance& guidance = {}, const TensorGuidanceOptions& how = {})
{
  DirectionField field(surface);
  field.FollowTensors(tensors, how);
  return field.Compute(options, guidance);
}

/// The largest angle between the lines of two fields of points in the same order, degrees.
double LargestDifference(const Result& a, const Result& b)
{
  double largest = 0.0;
  const auto points = static_cast<Index>(std::min(a.Normal.size(), b.Normal.size()));
  for (Index i = 0; i < points; ++i)
  {
    largest = std::max(largest, Deviation(a, i, b.Direction(i, 0)));
  }
  return largest;
}

int IndexSum(const Result& field)
{
  return std::accumulate(field.SingularityIndex.begin(), field.SingularityIndex.end(), 0);
}

bool HasNote(const Result& field, const std::string& words)
{
  return std::any_of(field.Notes.begin(), field.Notes.end(),
    [&](const std::string& note) { return note.find(words) != std::string::npos; });
}

bool IsOnRim(const Vector3& p)
{
  return p.norm() < 1.001 * HoleRadius || p.lpNorm<Eigen::Infinity>() > 0.999;
}
}

TEST(FollowedTensors, HaveTheDirectionsOfTheirGuidanceAndAreNoConstraints)
{
  const Surface plate = Plate(80, 20);
  const SurfaceTensors tensors = AtPoints(plate, Kirsch);
  for (const int degree : { 2, 4 })
  {
    Options options = OfDegree(degree);
    const Result followed = Follow(plate, tensors, options);
    options.ConstrainGuidance = true;
    const Result constrained =
      DirectionField(plate).Compute(options, GuideByTensors(plate, tensors).Guidance);
    EXPECT_LT(LargestDifference(followed, constrained), 1e-4) << degree;
    EXPECT_TRUE(followed.Constraint.empty());
    EXPECT_TRUE(followed.Notes.empty()) << followed.Notes[0];
  }
}

TEST(FollowedTensors, GiveWayToConstraints)
{
  const Surface plate = Plate(80, 20);
  const SurfaceTensors tensors = AtPoints(plate, Kirsch);
  Options options = OfDegree(2);
  const Result free = Follow(plate, tensors, options);
  options.ConstrainBoundary = true;
  options.ConstrainGuidance = true;
  Guidance guidance;
  guidance.Vectors.assign(plate.Points.size(), Vector3::Zero());
  constexpr Index given = 80 * 10 + 5;
  guidance.Vectors[given] = { 1.0, 1.0, 0.0 };
  const Result field = Follow(plate, tensors, options, guidance);
  EXPECT_EQ(Count(field, ConstraintKind::Boundary), 160);
  EXPECT_EQ(Count(field, ConstraintKind::Given), 1);
  EXPECT_LT(Deviation(field, given, { std::sqrt(0.5), std::sqrt(0.5), 0.0 }), 1e-6);
  Index same = 0;
  for (Index i = 0; i < static_cast<Index>(plate.Points.size()); ++i)
  {
    const Vector3& p = plate.Points[i];
    if (p.norm() < 1.001 * HoleRadius)
    {
      const Vector3 along = Vector3(-p.y(), p.x(), 0.0).normalized();
      EXPECT_LT(Deviation(field, i, along), 1e-3);
    }
    same += Deviation(field, i, free.Direction(i, 0)) < 1e-4 ? 1 : 0;
  }
  // All but the rims, those next to them, and the given one with its neighbours.
  EXPECT_GE(same, static_cast<Index>(plate.Points.size()) - 4 * 80 - 7);
}

TEST(FollowedTensors, DrawLessTheLowerTheStrength)
{
  const Surface plate = Plate(80, 20);
  const SurfaceTensors tensors = AtPoints(plate, Kirsch);
  double last = 0.8;
  for (const double strength : { 1.0, 0.99, 0.5 })
  {
    Options options = OfDegree(2);
    options.AlignmentStrength = strength;
    const double error = Error(Follow(plate, tensors, options), plate, KirschDeviator);
    EXPECT_TRUE(strength == 1.0 ? error < last : error > last + 0.5) << strength << ' ' << error;
    last = error;
  }
  Options options = OfDegree(2);
  options.AlignmentStrength = 0.0;
  const ComponentReport smooth = Follow(plate, tensors, options).Components[0];
  EXPECT_NEAR(smooth.SmoothnessEnergy, smooth.Eigenvalue, 1e-6);
  options.UseShift = true;
  options.Shift = 1e9;
  EXPECT_LT(Error(Follow(plate, tensors, options), plate, KirschDeviator), 0.5);
}

TEST(FollowedTensors, JoinPointsAsTheOptionsDo)
{
  const Surface torus = Torus(40, 20);
  const Surface soup = Soup(torus);
  const Result joined = Follow(soup, AtPoints(soup, TorusStress), OfDegree(2));
  const Result whole = Follow(torus, AtPoints(torus, TorusStress), OfDegree(2));
  ASSERT_EQ(joined.Components.size(), 1u);
  for (std::size_t t = 0; t < torus.Triangles.size(); ++t)
  {
    for (int c = 0; c < 3; ++c)
    {
      const Vector3 there = joined.Direction(soup.Triangles[t][c], 0);
      EXPECT_LT(Deviation(whole, torus.Triangles[t][c], there), 1e-4);
    }
  }
  Options apart = OfDegree(2);
  apart.MergePoints = MergePoints::Off;
  EXPECT_EQ(
    Follow(soup, AtPoints(soup, TorusStress), apart).Components.size(), torus.Triangles.size());
}

TEST(FollowedTensors, AreReadAgainWhenTheyChange)
{
  const Surface torus = Torus(40, 20);
  const SurfaceTensors stress = AtPoints(torus, TorusStress);
  SurfaceTensors opposite = stress;
  for (double& value : opposite.Values)
  {
    value = -value;
  }
  DirectionField field(torus);
  field.FollowTensors(stress, {});
  const Result before = field.Compute(OfDegree(2));
  field.FollowTensors(opposite, {});
  const Result after = field.Compute(OfDegree(2));
  EXPECT_NEAR(LargestDifference(before, after), 90.0, 1e-3);
  EXPECT_NEAR(
    field.GetTensorGuidance()->MinorValue[3], -GuideByTensors(torus, stress).MajorValue[3], 1e-12);
  field.FollowTensors(opposite, { TensorDirection::Minor });
  EXPECT_LT(LargestDifference(before, field.Compute(OfDegree(2))), 1e-4);
  field.FollowNoTensors();
  const Result smoothest = field.Compute(OfDegree(2));
  EXPECT_EQ(field.GetTensorGuidance(), nullptr);
  EXPECT_NEAR(smoothest.Components[0].SmoothnessEnergy, smoothest.Components[0].Eigenvalue, 1e-9);
}

TEST(FollowedTensors, NeedDegreesThatHaveTheirDirections)
{
  const Surface torus = Torus(12, 6);
  const SurfaceTensors stress = AtPoints(torus, TorusStress);
  for (const int degree : { 1, 3, 6 })
  {
    try
    {
      Follow(torus, stress, OfDegree(degree));
      ADD_FAILURE() << degree;
    }
    catch (const std::invalid_argument& error)
    {
      EXPECT_NE(std::string(error.what()).find("to 2 or 4"), std::string::npos);
    }
  }
}

TEST(FollowedTensors, NotesSayWhatMayNotBeMeant)
{
  const Surface torus = Torus(40, 20);
  for (const double pressure : { 0.0, 1.0 })
  {
    const Result none = Follow(torus,
      AtPoints(torus, [&](const Vector3&) { return Matrix(pressure * Matrix::Identity()); }),
      OfDegree(2));
    EXPECT_TRUE(HasNote(none, "Choose another Tensor Array")) << pressure;
    EXPECT_NEAR(none.Components[0].SmoothnessEnergy, none.Components[0].Eigenvalue, 1e-9);
  }

  const Surface two = Joined(torus, Transformed(torus, Matrix::Identity(), { 5.0, 0.0, 0.0 }));
  const Result half = Follow(two,
    AtPoints(
      two, [](const Vector3& p) { return p.x() < 2.0 ? TorusStress(p) : Matrix::Identity(); }),
    OfDegree(2));
  ASSERT_EQ(half.Notes.size(), 1u);
  EXPECT_TRUE(HasNote(half, "on 1 of 2 connected components"));

  // As if x were around the tube and y along it.
  const SurfaceTensors ofElements = AtPoints(torus,
    [](const Vector3&) {
      return Plane({ 1.0, 0.0 }, 0.0);
    });
  const Result turned = Follow(torus, ofElements, OfDegree(2));
  ASSERT_EQ(turned.Notes.size(), 1u);
  EXPECT_TRUE(HasNote(turned, "in the axes of space, not of the elements"));

  SurfaceTensors rotating;
  rotating.Components = 9;
  for (const Vector3& p : torus.Points)
  {
    Matrix t = TorusStress(p);
    t(0, 1) += 0.05;
    t(1, 0) -= 0.05;
    for (int row = 0; row < 3; ++row)
    {
      rotating.Values.insert(rotating.Values.end(), { t(row, 0), t(row, 1), t(row, 2) });
    }
  }
  const Result asymmetric = Follow(torus, rotating, OfDegree(2));
  ASSERT_EQ(asymmetric.Notes.size(), 1u);
  EXPECT_TRUE(HasNote(asymmetric, "not symmetric"));
}

TEST(FollowedTensors, OneToSixIsotropicPointsAreFoundAndNoneMore)
{
  constexpr int cells = 100;
  const Surface square = Square(cells);
  const std::vector<Complex> places = { { 0.25, 0.3 }, { 0.71, 0.27 }, { 0.73, 0.71 },
    { 0.28, 0.74 }, { 0.5, 0.13 }, { 0.48, 0.88 } };
  for (std::size_t number = 1; number <= places.size(); ++number)
  {
    for (const bool onlyWedges : { true, false })
    {
      Zeros zeros;
      for (std::size_t k = 0; k < number; ++k)
      {
        (onlyWedges || k % 2 == 0 ? zeros.Wedges : zeros.Trisectors).push_back(places[k]);
      }
      SurfaceTensors tensors =
        AtPoints(square, [&](const Vector3& p) { return Plane(zeros(p), 0.3); });
      const Result exact = Follow(square, tensors, OfDegree(2));
      EXPECT_EQ(Singular(exact), static_cast<Index>(number));
      EXPECT_LT(FarthestZero(exact, square, zeros) * cells, 1.0) << number;
      AddNoise(0.1 * std::sqrt(MeanSquare(square, zeros)), 7, tensors);
      const Result noisy = Follow(square, tensors, OfDegree(2));
      EXPECT_EQ(Singular(noisy), static_cast<Index>(number)) << onlyWedges;
      EXPECT_LT(Error(noisy, square, zeros), 0.25 * RawError(tensors, square, zeros)) << number;
    }
  }
}

TEST(FollowedTensors, IndicesOfPressurizedShellsSumUpToThatOfTheSurface)
{
  Matrix scale = Matrix::Identity();
  scale(2, 2) = 1.6;
  const Surface ellipsoid = Transformed(Icosphere(4), scale, Vector3::Zero());
  const SurfaceTensors stress =
    AtPoints(ellipsoid, [](const Vector3& p) { return EllipsoidStress(p, 1.0, 1.6); });
  for (const int degree : { 2, 4 })
  {
    const Result field = Follow(ellipsoid, stress, OfDegree(degree));
    EXPECT_EQ(IndexSum(field), 2 * degree);
    for (std::size_t t = 0; t < ellipsoid.Triangles.size(); ++t)
    {
      const double height = std::abs(ellipsoid.Points[ellipsoid.Triangles[t][0]].z());
      EXPECT_TRUE(field.SingularityIndex[t] == 0 || height > 1.5) << height;
    }
    const Surface torus = Torus(40, 20);
    const Result none = Follow(torus, AtPoints(torus, TorusStress), OfDegree(degree));
    EXPECT_EQ(Singular(none), 0);
  }
}

TEST(FollowedTensors, NoiseOfATorusIsAveragedAway)
{
  const Surface torus = Torus(160, 80);
  const auto error = [&](const Result& field)
  {
    double sum = 0.0;
    for (Index i = 0; i < static_cast<Index>(torus.Points.size()); ++i)
    {
      const Vector3& p = torus.Points[i];
      const double off = 90.0 - Deviation(field, i, Vector3(-p.y(), p.x(), 0.0).normalized());
      sum += off * off;
    }
    return std::sqrt(sum / static_cast<double>(torus.Points.size()));
  };
  // The deviator is a tenth of 1 / distance.
  for (const auto& [noise, most] : { std::pair(0.1, 0.25 * 3.3), std::pair(0.3, 10.5 / 3.0) })
  {
    SurfaceTensors tensors = AtPoints(torus, TorusStress);
    AddNoise(0.1 * noise, 2, tensors);
    const Result field = Follow(torus, tensors, OfDegree(2));
    EXPECT_LT(error(field), most) << noise;
    EXPECT_EQ(Singular(field), 0) << noise;
  }
}

TEST(FollowedTensors, TrianglesAndPointsAgreeTheBetterTheFinerTheMesh)
{
  double last = 90.0;
  for (const int around : { 40, 80 })
  {
    const Surface plate = Plate(around, around / 4);
    const Result points = Follow(plate, AtPoints(plate, Kirsch), OfDegree(4));
    const Result triangles = Follow(plate, AtTriangles(plate, Kirsch), OfDegree(4));
    double sum = 0.0;
    Index count = 0;
    for (Index i = 0; i < static_cast<Index>(plate.Points.size()); ++i)
    {
      if (!IsOnRim(plate.Points[i]))
      {
        const double off = Deviation(points, i, triangles.Direction(i, 0));
        sum += off * off;
        ++count;
      }
    }
    const double difference = std::sqrt(sum / count);
    EXPECT_LT(difference, 0.6 * last);
    last = difference;
  }
  EXPECT_LT(last, 1.0);
}

TEST(FollowedTensors, JumpsOfCellsStaySharp)
{
  constexpr int cells = 40;
  const Surface square = Square(cells);
  const Complex soft = std::polar(1.0, Pi / 3.0 * 2.0);
  const SurfaceTensors tensors = AtTriangles(
    square, [&](const Vector3& p) { return Plane(p.x() < 0.5 ? Complex(1.0) : soft, 0.0); });
  const Result field = Follow(square, tensors, OfDegree(2));
  for (Index i = 0; i < static_cast<Index>(square.Points.size()); ++i)
  {
    const double x = square.Points[i].x();
    if (std::abs(x - 0.5) * cells > 1.5)
    {
      const Vector3 wanted = x < 0.5 ? Vector3(1.0, 0.0, 0.0) : Vector3(0.5, std::sqrt(0.75), 0.0);
      EXPECT_LT(Deviation(field, i, wanted), 0.5) << x;
    }
  }
}
