// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Reports/FieldSummary.h"

#include "Support/Sentences.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <vector>

namespace DirectionFields
{
namespace
{
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
  Internal::Sentence text;
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
    text += ", " + Count(static_cast<std::size_t>(constraints), "point") + " constrained";
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
  Internal::Sentence text;
  text << ", unit length";
  if (options.Preview)
  {
    text << ", a preview";
  }
  // On a plane the smoothest field has unit length as it is.
  if (const long change = std::lround(percent))
  {
    text << " with " << std::abs(change) << " % " << (change > 0 ? "less" : "more") << " energy";
  }
  return text.str();
}

std::string DescribeIndices(const std::vector<int>& indices)
{
  const auto positive = std::count_if(indices.begin(), indices.end(), [](int k) { return k > 0; });
  const auto negative = std::count_if(indices.begin(), indices.end(), [](int k) { return k < 0; });
  const std::string sum =
    ", index sum " + std::to_string(std::accumulate(indices.begin(), indices.end(), 0));
  if (positive + negative == 0)
  {
    return "no singularities" + sum;
  }
  return Count(static_cast<std::size_t>(positive + negative), "singularity", "singularities") +
    " (" + std::to_string(positive) + " +, " + std::to_string(negative) + " -)" + sum;
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
    text += " over " + Count(components.size(), "component");
  }
  return text + DescribeConvergence(components, options) + DescribeGuidance(components, options) +
    DescribeUnitLength(components, options);
}

std::string Summary(const CurveGuidance& guidance, std::size_t curves)
{
  const auto guided = std::count_if(
    guidance.Weights.begin(), guidance.Weights.end(), [](double weight) { return weight > 0.0; });
  return Count(static_cast<std::size_t>(guided), "point") + " of " +
    std::to_string(guidance.Weights.size()) + " guided by " + Count(curves, "curve");
}

std::string Summary(
  const FieldDifference& difference, const std::vector<ComparedSingularity>* singularities)
{
  // Less is rounding.
  constexpr double leastAngle = 1e-6;
  const auto angle = [](double degrees) { return Figure(degrees < leastAngle ? 0.0 : degrees); };
  std::string text = "angles between the fields " + angle(difference.Mean) +
    " degrees on average, " + angle(difference.Maximum) + " at most";
  if (singularities)
  {
    const auto count = [&](int field, bool isMatched)
    {
      return std::to_string(std::count_if(singularities->begin(), singularities->end(),
        [&](const ComparedSingularity& at)
        { return at.Field == field && (at.Match != None) == isMatched; }));
    };
    text += "; " + count(0, true) + " singularities match, " + count(0, false) +
      " are in the first only, " + count(1, false) + " in the second only";
  }
  return text;
}

std::string SummaryOfFile(const Result& field, const std::string& name)
{
  return DescribeIndices(field.SingularityIndex) + ", read from " +
    name.substr(name.find_last_of("/\\") + 1);
}

std::string SummaryOfEdit(
  const Result& field, const EditedField& edited, RotationObjective objective)
{
  const bool isChanged = std::any_of(edited.Components.begin(), edited.Components.end(),
    [](const EditedComponent& component) { return component.IsChanged; });
  std::string text = DescribeIndices(field.SingularityIndex);
  const auto unmet = std::count_if(edited.Components.begin(), edited.Components.end(),
    [](const EditedComponent& component) { return component.IsUnmet; });
  const std::string rest = unmet == 0
    ? ""
    : ", the list cannot be met on " + Count(static_cast<std::size_t>(unmet), "component");
  if (!isChanged)
  {
    return text + ", as given" + rest;
  }
  text += objective == RotationObjective::Smoothest ? ", edited to the smoothest field"
                                                    : ", edited with least change";
  if (!edited.WrongTriangles.empty())
  {
    text += ", " + Count(edited.WrongTriangles.size(), "triangle") + " with wrong indices";
  }
  return text + rest;
}

std::string DescribeTensors(
  const TensorGuidance& tensors, const std::string& name, const SurfaceFigures& figures, int degree)
{
  const double percent = 100.0 * tensors.IsotropicShare;
  std::ostringstream text;
  text << ", along " << name << ": ";
  if (degree == 2)
  {
    text << Count(static_cast<std::size_t>(figures.Positive), "wedge") << ", "
         << Count(static_cast<std::size_t>(figures.Negative), "trisector") << ", ";
  }
  if (percent > 0.0 && percent < 1.0)
  {
    text << "less than 1";
  }
  else
  {
    text << std::lround(percent);
  }
  text << " % isotropic";
  return text.str();
}
}
