// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remesh.h"

#include "Mesh/MergePoints.h"
#include "Preparation/SurfaceUnit.h"
#include "Preparation/WantedSizes.h"
#include "Sizes/BoundarySizes.h"
#include "Sizes/ErrorSizes.h"
#include "Sizes/SizeField.h"
#include "Support/Sentences.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace DirectionFields
{
namespace
{
/// Whether lengths are for a number of faces: then they may change where others have to, as where
/// thin parts have smaller faces.
bool AreForNumber(const RemeshOptions& options)
{
  return options.SizeSource != SizeSource::Sizing && !options.UseEdgeLength &&
    !(options.MaximumError > 0.0);
}

/// Sizes that are lengths are the same as sizes relative to a length.
void TakeLengths(RelativeSizes&& sizes, RemeshOptions& options, std::vector<std::string>& notes)
{
  options.UseEdgeLength = !AreForNumber(options);
  options.EdgeLength = sizes.EdgeLength;
  options.Sizing = std::move(sizes.Sizes);
  notes.insert(notes.end(), sizes.Notes.begin(), sizes.Notes.end());
}
}

void Check(const RemeshOptions& options, std::size_t points, std::size_t triangles)
{
  const auto require = [](bool holds, const char* what)
  {
    if (!holds)
    {
      throw std::invalid_argument(what);
    }
  };
  require(
    options.UseEdgeLength || options.NumberOfFaces >= 1, "Number Of Faces has to be at least 1.");
  require(!options.UseEdgeLength || (options.EdgeLength > 0.0 && std::isfinite(options.EdgeLength)),
    "Edge Length has to be a positive number.");
  require(options.Sizing.empty() || options.Sizing.size() == points,
    "There has to be one wanted size for each point of the surface.");
  require(!options.SizingIsLength || !options.Sizing.empty() || points == 0,
    "Lengths of edges at the points are asked for, but there are none. Choose a Sizing Array that "
    "has them.");
  require(options.SizeSource == SizeSource::Sizing || !options.SizingIsLength,
    "Sizes come from Lengths At Points or from Size Source, not from both. Set Size Mode to Number "
    "Of Faces, or Size Source to Sizing Array.");
  require(options.SizeSource != SizeSource::Curvature || options.Sizing.empty(),
    "Sizes come from a Sizing Array or from the curvature, not from both.");
  require(
    options.SizeSource != SizeSource::SecondDerivatives || !options.Sizing.empty() || points == 0,
    "The function whose second derivatives are to give the sizes is missing. Choose it as Sizing "
    "Array.");
  require(options.MaximumError >= 0.0 && std::isfinite(options.MaximumError),
    "Maximum Error has to be at least 0.");
  require(options.Gradation == 0.0 || (options.Gradation > 1.0 && std::isfinite(options.Gradation)),
    "Gradation has to be above 1, or 0 for any.");
  require(options.Regions.empty() || options.Regions.size() == triangles,
    "There has to be one region for each triangle of the surface.");
  require(options.RegionNames.empty() ||
      std::all_of(options.Regions.begin(), options.Regions.end(),
        [&](Index r) { return r >= 0 && r < static_cast<Index>(options.RegionNames.size()); }),
    "There has to be one name for each region.");
  require(options.FeatureAngle >= 0.0 && options.FeatureAngle <= 180.0,
    "Feature Angle has to be between 0 and 180 degrees.");
  require(options.MinimumFeatureLength >= 0.0 && std::isfinite(options.MinimumFeatureLength),
    "Minimum Feature Length has to be at least 0.");
  require(options.AlignmentStrength >= 0.0 && options.AlignmentStrength <= 1.0,
    "Alignment Strength has to be between 0 and 1.");
  require(options.SingularityCost >= 0.0 && options.SingularityCost <= 4.0,
    "Singularity Cost has to be between 0 and 4.");
  require(options.SmoothingIterations >= 0 && options.SmoothingIterations <= 1000,
    "Smoothing Iterations has to be between 0 and 1000.");
  require(options.NumberOfThreads >= 0 && options.NumberOfThreads <= 1024,
    "NumberOfThreads has to be between 0 and 1024.");
}

bool AreSame(const RemeshOptions& a, const RemeshOptions& b)
{
  const auto all = [](const RemeshOptions& options)
  {
    // This does not compile where an option is not among them.
    const auto& [element, faces, usesLength, length, sizing, areLengths, source, error, gradation,
      pairs, pure, spacing, thin, features, angle, shortest, soft, regions, names, alignment,
      strength, cost, smoothing, threads] = options;
    return std::tie(element, faces, usesLength, length, sizing, areLengths, source, error,
      gradation, pairs, pure, spacing, thin, features, angle, shortest, soft, regions, names,
      alignment, strength, cost, smoothing, threads);
  };
  return all(a) == all(b);
}

double EdgeLengthFor(double area, const RemeshOptions& options)
{
  if (options.UseEdgeLength)
  {
    return options.EdgeLength;
  }
  const double face = area / options.NumberOfFaces;
  return std::sqrt(options.Element == Element::Quads ? face : 4.0 / std::sqrt(3.0) * face);
}

namespace
{
/// Of the components; a surface in several parts has the faces of each.
double LargestArea(const Surface& surface)
{
  const MergedMesh merged = MergedMesh::AcrossSeams(surface);
  const TriangleMesh& mesh = merged.Mesh;
  const std::vector<Vector3> positions = mesh.Positions(surface.Points);
  double largest = 0.0;
  for (const TriangleMesh::Component& component : mesh.GetComponents())
  {
    double area = 0.0;
    for (Index t = component.FirstTriangle; t < component.EndTriangle; ++t)
    {
      const Vector3& origin = positions[mesh.Tail(3 * t)];
      area += 0.5 *
        (positions[mesh.Head(3 * t)] - origin)
          .cross(positions[mesh.Tail(3 * t + 2)] - origin)
          .norm();
    }
    largest = std::max(largest, component.IsCover ? 0.5 * area : area);
  }
  return largest;
}
}

void Remesh::RequireShort(const RemeshOptions& options) const
{
  // Two for each edge of a box: fewer show no shape.
  constexpr Index fewFaces = 24;
  const bool areLengths = options.SizingIsLength && !options.Sizing.empty();
  const double shortest = areLengths
    ? *std::min_element(options.Sizing.begin(), options.Sizing.end())
    : options.EdgeLength;
  const double extent = this->Unit * Extent(*this->Given);
  if (!(extent > 0.0) || !(shortest > extent))
  {
    return;
  }
  const double largest = LargestArea(*this->Given);
  if (!(largest > 0.0))
  {
    return;
  }
  RemeshOptions few;
  few.NumberOfFaces = fewFaces;
  few.Element = options.Element;
  const std::string possible = Figure(this->Unit * EdgeLengthFor(largest, few));
  throw std::invalid_argument(areLengths ? "Edges as long as the Sizing Array says, " +
        Figure(shortest) + " at the shortest, are longer than the whole surface, which is " +
        Figure(extent) + " from corner to corner. Lengths of " + possible +
        " leave room for 24 faces; Calculator makes them."
                                         : "An Edge Length of " + Figure(shortest) +
        " is longer than the whole surface, which is " + Figure(extent) +
        " from corner to corner. One of " + possible + " leaves room for 24 faces.");
}

void Remesh::RequirePossible(const RemeshOptions& options) const
{
  // More has no map, and would take more memory than there is.
  constexpr double mostFaces = 1e8;
  const bool areLengths = options.SizingIsLength && !options.Sizing.empty();
  if (!areLengths && !options.UseEdgeLength)
  {
    return;
  }
  this->RequireShort(options);
  const std::size_t points = this->Given->Points.size();
  const RelativeSizes sizes = areLengths
    ? SizesFor(*this->Given, options.Sizing, this->Unit)
    : RelativeSizes{ options.EdgeLength / this->Unit, options.Sizing, {} };
  const double area = RelativeArea(*this->Given, ClampedSizes(sizes.Sizes, points));
  const double perSquare = options.Element == Element::Quads ? 1.0 : 4.0 / std::sqrt(3.0);
  // The square of a length may be 0.
  const double faces = perSquare * area / sizes.EdgeLength / sizes.EdgeLength;
  if (!(faces > mostFaces))
  {
    return;
  }
  const double factor = std::sqrt(perSquare * area / mostFaces) / sizes.EdgeLength;
  const std::string needed = std::isfinite(faces) ? "about " + Figure(faces) : "too many";
  if (areLengths)
  {
    const double least = *std::min_element(options.Sizing.begin(), options.Sizing.end());
    throw std::invalid_argument("Edges as long as the Sizing Array says, " + Figure(least) +
      " at the shortest, need " + needed + " faces, more than 100 million. Lengths that are " +
      Figure(factor) +
      " times as large, as Calculator makes them, are not refused, and take about 2 "
      "kB a face.");
  }
  throw std::invalid_argument("An Edge Length of " + Figure(options.EdgeLength) + " needs " +
    needed + " faces, more than 100 million. Lengths of " + Figure(factor * options.EdgeLength) +
    " and more are not refused, and take about 2 kB a face.");
}

RemeshOptions Remesh::WithSizes(const RemeshOptions& given, double& error) const
{
  RemeshOptions options = given;
  if (given.SizeSource == SizeSource::Sizing || this->Given->Triangles.empty())
  {
    return options;
  }
  for (std::size_t p = 0; p < given.Sizing.size(); ++p)
  {
    if (!std::isfinite(given.Sizing[p]))
    {
      throw std::invalid_argument("The function at point " + std::to_string(p) +
        " is NaN or infinite, and has no second derivatives. All values of the Sizing Array have "
        "to be finite.");
    }
  }
  const bool isOfShape = given.SizeSource == SizeSource::Curvature;
  // A length of the user's, and a value of the function.
  const double unit = isOfShape ? this->Unit : 1.0;
  const double area =
    RelativeArea(*this->Given, std::vector<double>(this->Given->Points.size(), 1.0));
  const double length =
    given.UseEdgeLength ? given.EdgeLength / this->Unit : EdgeLengthFor(area, given);
  ErrorWish wish;
  wish.Error = given.MaximumError / unit;
  wish.Squares = area / (length * length);
  wish.Gradation = GradationOfErrors(given);
  wish.AreChords = isOfShape;
  ErrorLengths lengths = LengthsForError(*this->Given,
    isOfShape ? CurvatureSums(*this->Given) : DerivativeSums(*this->Given, given.Sizing), wish);
  for (double& each : lengths.Lengths)
  {
    each *= this->Unit;
  }
  error = lengths.Error * unit;
  options.Sizing = std::move(lengths.Lengths);
  options.SizingIsLength = true;
  options.Gradation = 0.0;
  return options;
}

RemeshOptions Remesh::InUnitOfInput(
  const RemeshOptions& given, std::vector<std::string>& notes) const
{
  RemeshOptions options = given;
  if (given.SizingIsLength)
  {
    TakeLengths(SizesFor(*this->Input, given.Sizing, this->Unit), options, notes);
  }
  else if (const auto outside =
             static_cast<std::size_t>(std::count_if(given.Sizing.begin(), given.Sizing.end(),
               [](double size) {
                 return std::isfinite(size) && size > 0.0 &&
                   (size > LargestSize || size < 1.0 / LargestSize);
               }));
           outside > 0)
  {
    notes.push_back("Sizes are taken from 1/8 to 8 only: at " + Count(outside, "point") +
      " that of the Sizing Array is out of this range, and the nearest one is taken.");
  }
  const auto unusable = static_cast<std::size_t>(std::count_if(given.Sizing.begin(),
    given.Sizing.end(), [](double size) { return !(size > 0.0 && std::isfinite(size)); }));
  if (unusable > 0)
  {
    notes.push_back("At " + Count(unusable, "point") +
      " the Sizing Array has no positive number: sizes count as 1 there. Calculator makes others of "
      "them.");
  }
  if (!given.SizingIsLength && given.UseEdgeLength)
  {
    options.EdgeLength = std::clamp(given.EdgeLength / this->Unit,
      std::numeric_limits<double>::min(), std::numeric_limits<double>::max());
  }
  if (given.Gradation > 0.0 && !given.Sizing.empty())
  {
    options.Sizing = ClampedSizes(options.Sizing, this->Input->Points.size());
    LimitGradation(
      *this->Input, given.Gradation, [&](double area) { return EdgeLengthFor(area, options); },
      options.Sizing);
  }
  if (given.BoundarySpacing == BoundarySpacing::Keep)
  {
    const std::vector<double> sizes = ClampedSizes(options.Sizing, this->Input->Points.size());
    std::vector<double> lengths = LengthsForBoundary(*this->Input, sizes,
      EdgeLengthFor(RelativeArea(*this->Input, sizes), options), options.UseEdgeLength);
    for (double& length : lengths)
    {
      length *= this->Unit;
    }
    if (!lengths.empty())
    {
      TakeLengths(SizesFor(*this->Input, lengths, this->Unit, "Lengths that the boundary asks for"),
        options, notes);
    }
  }
  return options;
}
}
