// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Options.h"

#include <cmath>
#include <stdexcept>

namespace DirectionFields
{
namespace
{
void Require(bool valid, const char* what)
{
  if (!valid)
  {
    throw std::invalid_argument(what);
  }
}

}

/// The comparisons are written so that they refuse NaN, too.
void Check(const Options& options)
{
  Require(options.Degree >= 1 && options.Degree <= 16, "Degree must be 1 to 16.");
  Require(options.EnergyBias >= -1.0 && options.EnergyBias <= 1.0, "EnergyBias must be -1 to 1.");
  Require(
    options.Tolerance >= 1e-12 && options.Tolerance <= 0.1, "Tolerance must be 1e-12 to 0.1.");
  Require(options.MaximumIterations >= 1 && options.MaximumIterations <= 10000,
    "MaximumIterations must be 1 to 10000.");
  Require(options.SingularityCost >= 0.0 && options.SingularityCost <= 4.0,
    "SingularityCost must be 0 to 4.");
  Require(options.NumberOfThreads >= 0 && options.NumberOfThreads <= 1024,
    "NumberOfThreads must be 0 to 1024.");
  Require(options.CurvatureScale >= 0.0 && options.CurvatureScale <= 32.0,
    "CurvatureScale must be 0 to 32.");
  Require(options.AlignmentStrength >= 0.0 && options.AlignmentStrength <= 1.0,
    "AlignmentStrength must be 0 to 1.");
  Require(options.Shift >= 0.0 && std::isfinite(options.Shift), "Shift must be at least 0.");
  Require(options.FeatureAngle >= 0.0 && options.FeatureAngle <= 180.0,
    "FeatureAngle must be 0 to 180 degrees.");
  Require(options.MinimumFeatureLength >= 0.0, "MinimumFeatureLength must be at least 0.");
  Require(options.CurvatureTolerance >= 0.0, "CurvatureTolerance must be at least 0.");
  Require(options.ConsistencyAngle >= 0.0 && options.ConsistencyAngle <= 180.0,
    "ConsistencyAngle must be 0 to 180 degrees.");
  const bool usesCurvature =
    options.Alignment == Alignment::PrincipalCurvature || options.ConstrainCurvature;
  Require(!usesCurvature || options.Degree == 2 || options.Degree == 4,
    "Set Directions per point (Degree) to 2 or 4: principal curvature gives a line or a cross "
    "field. For others turn Alignment and Constrain Curvature off, or align to Point Vectors.");
}

void Check(const Guidance& guidance, const Options& options, std::size_t points)
{
  const bool needed = options.Alignment == Alignment::PointVectors || options.ConstrainGuidance;
  Require(!needed || guidance.Vectors.size() == points,
    "Choose a point array of three components as Guidance Vectors: Point Vectors and Constrain "
    "Guidance need a vector at each point.");
  Require(!needed || guidance.Weights.empty() || guidance.Weights.size() == points,
    "Choose other Guidance Weights: they must be one number a point.");
}
}
