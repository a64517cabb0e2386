// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Support/OutputSummaries.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace DirectionFields
{
namespace
{
/// A number with its noun.
std::string Count(std::size_t number, const std::string& noun, const std::string& several = "")
{
  return std::to_string(number) + ' ' +
    (number == 1 ? noun : (several.empty() ? noun + 's' : several));
}

/// A length, an angle or a ratio with three digits.
std::string Figure(double value)
{
  std::ostringstream text;
  text.precision(3);
  text << value;
  return text.str();
}

double Sum(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0);
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

std::string Summary(const Streamlines& lines, SeedType seeds)
{
  std::string text = Count(lines.Length.size(), "line");
  if (seeds == SeedType::EvenlySpaced)
  {
    text += ' ' + Figure(lines.Spacing) + " apart";
  }
  else if (seeds == SeedType::Singularities)
  {
    const auto singularities = std::count_if(lines.Nodes.begin(), lines.Nodes.end(),
      [](const StreamlineNode& node) { return node.Type == StreamlineNodeType::Singularity; });
    text +=
      " out of " + Count(static_cast<std::size_t>(singularities), "singularity", "singularities");
  }
  else
  {
    text += " through the points given";
  }
  text += ", " + Figure(Sum(lines.Length)) + " long together";
  const auto closed = std::count_if(
    lines.Closed.begin(), lines.Closed.end(), [](char isClosed) { return isClosed != 0; });
  if (closed > 0)
  {
    text += ", " + std::to_string(closed) + " closed";
  }
  return text + (lines.IsLimited ? ", not all of them" : "");
}

std::string Summary(const StripePattern& pattern)
{
  const std::string lines = Count(pattern.Length.size(), "stripe");
  return lines +
    (pattern.Spacing > 0.0 ? ' ' + Figure(pattern.Spacing) + " apart" : ", spacing of an array") +
    ", " + Figure(Sum(pattern.Length)) + " long together, " +
    Count(static_cast<std::size_t>(pattern.BranchPoints), "branch point") + ", misfit " +
    Figure(pattern.Misfit);
}

std::string Summary(const RemeshResult& mesh, double leastScaledJacobian)
{
  if (mesh.Faces.empty())
  {
    return "no faces, for there are no triangles";
  }
  std::string text;
  if (mesh.Quads > 0)
  {
    text = Count(static_cast<std::size_t>(mesh.Quads), "quad") + ", ";
  }
  if (mesh.Triangles > 0)
  {
    text += Count(static_cast<std::size_t>(mesh.Triangles), "triangle") + ", ";
  }
  return text +
    Count(
      static_cast<std::size_t>(mesh.IrregularVertices), "irregular vertex", "irregular vertices") +
    ", edge length " + Figure(mesh.EdgeLength) + ", scaled Jacobian " +
    Figure(leastScaledJacobian) + " or more, " + Figure(mesh.MaximumDistance) +
    " or less from the surface";
}

std::string Summary(const Glyphs& glyphs)
{
  const std::string text = Count(glyphs.Point.size(), "glyph");
  return glyphs.Spacing > 0.0 ? text + ' ' + Figure(glyphs.Spacing) + " or more apart" : text;
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
  if (!isChanged)
  {
    return text + ", as given";
  }
  text += objective == RotationObjective::Smoothest ? ", edited to the smoothest field"
                                                    : ", edited with least change";
  if (!edited.WrongTriangles.empty())
  {
    text += ", " + Count(edited.WrongTriangles.size(), "triangle") + " with wrong indices";
  }
  return text;
}
}
