// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Sizes/ErrorSizes.h"

#include "Distance/ClosestPoints.h"
#include "Meshes/Remeshed.h"
#include "Meshes/Surfaces.h"
#include "Preparation/WantedSizes.h"
#include "Remesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

using namespace DirectionFields;
using namespace DirectionFields::Internal;

namespace
{
std::vector<double> AtPoints(const Surface& surface, double (*value)(const Vector3&))
{
  std::vector<double> values;
  for (const Vector3& p : surface.Points)
  {
    values.push_back(value(p));
  }
  return values;
}

double Front(const Vector3& p)
{
  return std::tanh((p.x() + 0.3 * p.y() - 0.6) / 0.06);
}

/// The largest errors of the function over the surface's points where it is interpolated between
/// the vertices of a mesh, on the triangles beside a diagonal of each face.
double LargestError(
  const Surface& surface, const RemeshResult& mesh, double (*function)(const Vector3&))
{
  std::vector<ClosestPoints::Corners> triangles;
  std::vector<std::array<Index, 3>> corners;
  for (const std::array<Index, 4>& face : mesh.Faces)
  {
    corners.push_back({ face[0], face[1], face[2] });
    if (face[3] != None)
    {
      corners.push_back({ face[0], face[2], face[3] });
    }
  }
  for (const std::array<Index, 3>& t : corners)
  {
    triangles.push_back({ mesh.Points[t[0]], mesh.Points[t[1]], mesh.Points[t[2]] });
  }
  const ClosestPoints closest(triangles);
  double largest = 0.0;
  for (const Vector3& p : surface.Points)
  {
    const ClosestPoints::Answer at = closest.Find(p);
    double value = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      value += at.Weights[c] * function(mesh.Points[corners[at.Triangle][c]]);
    }
    largest = std::max(largest, std::abs(value - function(p)));
  }
  return largest;
}

RemeshResult Meshed(const Surface& surface, const RemeshOptions& options)
{
  return Remesh(std::make_shared<Surface>(surface)).Compute(options);
}
}

/// On a sphere of radius r both principal curvatures are 1 / r, on a cylinder one of them is.
TEST(ErrorSizes, CurvatureSumsAreThoseOfSpheresAndCylinders)
{
  const Surface sphere =
    Meshes::Transformed(Meshes::Icosphere(4), 0.25 * Eigen::Matrix3d::Identity(), Vector3::Zero());
  for (const double sum : CurvatureSums(sphere))
  {
    EXPECT_NEAR(sum, 8.0, 0.2);
  }
  const Surface cylinder = Meshes::Cylinder(80, 40, 3.0);
  const std::vector<double> sums = CurvatureSums(cylinder);
  for (std::size_t p = 0; p < sums.size(); ++p)
  {
    EXPECT_NEAR(sums[p], 1.0, 0.05);
  }
}

/// Sharp edges are no curvature: those of a cube have none, since its sides are flat.
TEST(ErrorSizes, SharpEdgesAreNoCurvature)
{
  for (const double sum : CurvatureSums(Meshes::FlatlySubdivided(Meshes::Cube(), 4)))
  {
    EXPECT_NEAR(sum, 0.0, 1e-9);
  }
}

/// Quadratic functions are their own fit; those of a plane have no other second derivatives.
TEST(ErrorSizes, DerivativeSumsOfQuadraticFunctionsAreExact)
{
  const Surface square = Meshes::BadSquare(16, 3);
  const std::vector<double> sums = DerivativeSums(square,
    AtPoints(square,
      [](const Vector3& p)
      { return 3.0 + p.x() - 2.0 * p.y() + 1.5 * p.x() * p.x() - 0.5 * p.y() * p.y(); }));
  for (const double sum : sums)
  {
    EXPECT_NEAR(sum, 3.0 + 1.0, 1e-7);
  }
  for (const double sum :
    DerivativeSums(square, AtPoints(square, [](const Vector3& p) { return p.x() - p.y(); })))
  {
    EXPECT_NEAR(sum, 0.0, 1e-9);
  }
}

/// As many squares as are wanted cover the surface, and lengths grow no faster than they may.
TEST(ErrorSizes, LengthsMeetTheNumberOfFaces)
{
  const Surface square = Meshes::Square(60);
  const std::vector<double> sums = DerivativeSums(square, AtPoints(square, Front));
  ErrorWish wish;
  wish.Squares = 2000.0;
  const ErrorLengths made = LengthsForError(square, sums, wish);
  EXPECT_NEAR(RelativeArea(square, made.Lengths), 2000.0, 40.0);
  for (const Triangle& t : square.Triangles)
  {
    const double length = (square.Points[t[0]] - square.Points[t[1]]).norm();
    EXPECT_LE(std::abs(made.Lengths[t[0]] - made.Lengths[t[1]]), std::log(1.3) * length + 1e-12);
  }
  // The error that was met asks for the same lengths.
  ErrorWish again;
  again.Error = made.Error;
  EXPECT_NEAR(RelativeArea(square, LengthsForError(square, sums, again).Lengths), 2000.0, 100.0);
}

TEST(ErrorSizes, ASphereIsAsFarAsTheErrorAllows)
{
  RemeshOptions options;
  options.SizeSource = SizeSource::Curvature;
  options.MaximumError = 0.004;
  const RemeshResult mesh = Meshed(Meshes::Icosphere(6), options);
  EXPECT_EQ(mesh.ErrorOfSizes, 0.004);
  EXPECT_NEAR(mesh.MaximumDistance, 0.004, 0.0016);
  EXPECT_EQ(Meshes::FlawOf(mesh), "");
}

/// With as many faces, half the distance from a plate with a limb.
TEST(ErrorSizes, HalvesTheDistanceOfEvenFaces)
{
  Surface body = Meshes::Square(100);
  for (Vector3& p : body.Points)
  {
    p.z() = 0.3 * std::exp(-200.0 * (p - Vector3(0.5, 0.5, 0.0)).squaredNorm());
  }
  RemeshOptions options;
  options.NumberOfFaces = 1000;
  const RemeshResult even = Meshed(body, options);
  options.SizeSource = SizeSource::Curvature;
  const RemeshResult adapted = Meshed(body, options);
  const auto farthest = [](const RemeshResult& mesh)
  { return std::max(mesh.MaximumDistance, mesh.MaximumDistanceToMesh); };
  EXPECT_LE(farthest(adapted), 0.5 * farthest(even));
  EXPECT_LE(adapted.Faces.size(), 1.1 * even.Faces.size());
}

/// With as many faces, half the error of a front.
TEST(ErrorSizes, HalvesTheInterpolationErrorOfEvenFaces)
{
  const Surface square = Meshes::Square(80);
  RemeshOptions options;
  options.NumberOfFaces = 1000;
  const RemeshResult even = Meshed(square, options);
  options.SizeSource = SizeSource::SecondDerivatives;
  options.Sizing = AtPoints(square, Front);
  const RemeshResult fitted = Meshed(square, options);
  EXPECT_LE(LargestError(square, fitted, Front), 0.5 * LargestError(square, even, Front));
  EXPECT_LE(fitted.Faces.size(), 1.1 * even.Faces.size());
}

/// Flat surfaces and linear functions have even faces; what is no function is told.
TEST(ErrorSizes, SaysWhatItCannotTake)
{
  const Surface square = Meshes::Square(20);
  RemeshOptions options;
  options.NumberOfFaces = 400;
  options.SizeSource = SizeSource::Curvature;
  EXPECT_EQ(Meshed(square, options).Faces.size(), 400U);
  options.Sizing.assign(square.Points.size(), 1.0);
  EXPECT_THROW(Meshed(square, options), std::invalid_argument);
  options.SizeSource = SizeSource::SecondDerivatives;
  EXPECT_EQ(Meshed(square, options).Faces.size(), 400U);
  options.SizingIsLength = true;
  EXPECT_THROW(Meshed(square, options), std::invalid_argument);
  options.SizingIsLength = false;
  options.Sizing[7] = std::numeric_limits<double>::quiet_NaN();
  try
  {
    Meshed(square, options);
    FAIL();
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_EQ(std::string(error.what()).find("The function at point 7 is NaN"), 0U);
  }
  options.Sizing = AtPoints(square, Front);
  options.MaximumError = 1e-12;
  EXPECT_THROW(Meshed(square, options), std::invalid_argument);
  options.MaximumError = -1.0;
  EXPECT_THROW(Meshed(square, options), std::invalid_argument);
}

/// The distance of faces from a sphere is the one that is asked for, also around the eight irregular
/// vertices, beside which faces are larger than elsewhere, and they are not far more than needed.
TEST(ErrorSizes, DistancesFromASphereAreThoseAskedFor)
{
  for (const double scale : { 1.0, 1e-3 })
  {
    const auto sphere = std::make_shared<Surface>(Meshes::Transformed(
      Meshes::Icosphere(5), scale * Eigen::Matrix3d::Identity(), Vector3(scale, 0.0, 0.0)));
    for (const double error : { 0.02, 0.005, 0.001 })
    {
      RemeshOptions options;
      options.SizeSource = SizeSource::Curvature;
      options.MaximumError = error * scale;
      const RemeshResult mesh = Remesh(sphere).Compute(options);
      EXPECT_LE(mesh.MaximumDistance, 1.1 * options.MaximumError) << error;
      // A square of edges h is h^2 / 4 from the unit sphere: pi / error squares.
      EXPECT_LE(static_cast<double>(mesh.Faces.size()), 1.6 * std::acos(-1.0) / error) << error;
    }
  }
}

/// Where a distance is not met the user is told which one there is.
TEST(ErrorSizes, SayWhereADistanceIsMissed)
{
  const auto rough = std::make_shared<Surface>(Meshes::Roughened(Meshes::Icosphere(5), 0.3, 1));
  RemeshOptions options;
  options.SizeSource = SizeSource::Curvature;
  options.MaximumError = 0.002;
  const RemeshResult mesh = Remesh(rough).Compute(options);
  const bool isSaid = std::any_of(mesh.Notes.begin(), mesh.Notes.end(),
    [](const std::string& note)
    { return note.find("where Maximum Error asks for 0.002") != std::string::npos; });
  EXPECT_GT(mesh.MaximumDistance, 1.1 * options.MaximumError);
  EXPECT_TRUE(isSaid);
}

/// Smaller faces at thin parts make the others larger, as without sizes: bodies flatter than faces
/// are wide have the number asked for, not many times as many.
TEST(ErrorSizes, ThinPartsKeepTheNumberOfFaces)
{
  const auto flat = [](const Surface& body, double width, double height)
  {
    const Eigen::Matrix3d linear = Vector3(1.0, width, height).asDiagonal();
    return std::make_shared<Surface>(Meshes::Transformed(body, linear, Vector3::Zero()));
  };
  const auto ratio = [](std::shared_ptr<const Surface> surface, Index faces)
  {
    RemeshOptions options;
    options.NumberOfFaces = faces;
    options.SizeSource = SizeSource::Curvature;
    const RemeshResult mesh = Remesh(std::move(surface)).Compute(options);
    return static_cast<double>(mesh.Faces.size()) / static_cast<double>(faces);
  };
  EXPECT_NEAR(ratio(flat(Meshes::Potato(3), 0.3, 0.1), 500), 1.0, 0.1);
  EXPECT_NEAR(ratio(flat(Meshes::Icosphere(3), 0.3, 0.03), 120), 1.0, 0.1);
}
