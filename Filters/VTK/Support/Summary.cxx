// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Support/Summary.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <sstream>
#include <vector>

namespace DirectionFields
{
namespace
{
/// A number with its noun.
std::string Count(Index number, const char* noun)
{
  return std::to_string(number) + ' ' + noun + (number == 1 ? "" : "s");
}

std::string DescribeSingularities(const SurfaceFigures& figures)
{
  const Index positive = figures.Positive;
  const Index negative = figures.Negative;
  if (positive + negative == 0)
  {
    return "no singularities";
  }
  const Index number = positive + negative;
  return std::to_string(number) + (number == 1 ? " singularity (" : " singularities (") +
    std::to_string(positive) + " +, " + std::to_string(negative) + " -)";
}

/// The components that have triangles of this piece.
std::vector<ComponentReport> OwnComponents(const Result& field)
{
  std::vector<ComponentReport> components;
  std::copy_if(field.Components.begin(), field.Components.end(), std::back_inserter(components),
    [](const ComponentReport& component) { return component.Triangles > 0; });
  return components;
}

/// How many components' solvers ended before they had converged; empty where all have.
std::string DescribeConvergence(
  const std::vector<ComponentReport>& components, const Options& options)
{
  Index unsolved = 0;
  double worst = 0.0;
  for (const ComponentReport& component : components)
  {
    if (!component.Converged)
    {
      ++unsolved;
      // The two residuals have tolerances of their own: one that holds its own is not to blame.
      const bool eigenpair = component.Residual > options.Tolerance;
      worst = std::max(worst, eigenpair ? component.Residual : component.SystemResidual);
    }
  }
  if (unsolved == 0)
  {
    return {};
  }
  std::ostringstream text;
  text << ", ";
  if (components.size() > 1)
  {
    text << unsolved << " of " << components.size() << " components ";
  }
  text.precision(2);
  text << "not converged (residual " << worst << ")";
  return text.str();
}

/// The options beyond smoothness that shaped the field; empty for the smoothest field.
std::string DescribeGuidance(const std::vector<ComponentReport>& components, const Options& options)
{
  bool aligned = false;
  Index constraints = 0;
  for (const ComponentReport& component : components)
  {
    aligned = aligned || component.Lambda < component.Eigenvalue;
    constraints += component.Constraints;
  }
  std::string text;
  if (aligned && options.Alignment != Alignment::None)
  {
    text += ", aligned";
  }
  if (constraints > 0)
  {
    text += ", " + Count(constraints, "point") + " constrained";
  }
  return text;
}

/// How much less the directions bend, in whole percent; empty without Options::UnitLength.
std::string DescribeUnitLength(
  const std::vector<ComponentReport>& components, const Options& options)
{
  if (!options.UnitLength)
  {
    return {};
  }
  double before = 0.0;
  double after = 0.0;
  for (const ComponentReport& component : components)
  {
    before += component.UnitEnergyBefore;
    after += component.UnitEnergyAfter;
  }
  // Fewer singularities may have been worth some bending.
  const double percent = before > 0.0 ? 100.0 * (before - after) / before : 0.0;
  std::ostringstream text;
  text << ", unit length";
  // On a plane the smoothest field has unit length as it is.
  if (const long change = std::lround(percent))
  {
    text << " with " << std::abs(change) << " % " << (change > 0 ? "less" : "more") << " energy";
  }
  return text.str();
}
}

std::string Summary(const SurfaceFigures& figures, const Result& field, const Options& options)
{
  const std::vector<ComponentReport> components = OwnComponents(field);
  if (components.empty())
  {
    return "no field, for there are no triangles";
  }
  Index indexSum = 0;
  for (const ComponentReport& component : components)
  {
    indexSum += component.IndexSum;
  }
  std::string text = DescribeSingularities(figures) + ", index sum " + std::to_string(indexSum);
  if (components.size() > 1)
  {
    text += " over " + Count(static_cast<Index>(components.size()), "component");
  }
  return text + DescribeConvergence(components, options) + DescribeGuidance(components, options) +
    DescribeUnitLength(components, options);
}
}
