// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Field/Guide.h"

#include "Field/Guidance.h"
#include "Field/Stages.h"

#include <algorithm>

namespace DirectionFields::Internal
{
namespace
{
std::vector<Complex> GivenSection(
  const Stages& stages, const Options& options, const Guidance& guidance)
{
  if (options.Alignment != Alignment::PointVectors && !options.ConstrainGuidance)
  {
    return {};
  }
  const std::vector<Index>& first = stages.GetFirstPoints();
  return GuidanceSection(
    stages.GetGeometry(), first.empty() ? guidance : Merged(guidance, first), options.Degree);
}

Constraints ConstraintsOf(Stages& stages, const Options& options, const std::vector<Complex>& given,
  std::vector<std::string>& notes)
{
  if (UsesCurvature(options) && options.Degree == 2 &&
    stages.GetMesh().GetRepairs().NonOrientableComponents > 0)
  {
    notes.emplace_back("A line field cannot follow the curvature of a surface that cannot be "
                       "oriented: the larger and the smaller curvature change places on a "
                       "walk around it. Take Degree 4.");
  }
  return Constraints(
    { stages.GetGeometry(),
      options.ConstrainSharpEdges ? stages.GetDihedralAngles() : std::vector<double>{},
      UsesCurvature(options) ? &stages.GetCurvature() : nullptr, given },
    options, notes);
}

std::vector<Complex> DrawnSection(Stages& stages, const Options& options,
  const std::vector<Complex>& given, std::vector<std::string>& notes)
{
  std::vector<Complex> drawn;
  switch (options.Alignment)
  {
    case Alignment::None:
      return drawn;
    case Alignment::PointVectors:
      drawn = given;
      break;
    case Alignment::PrincipalCurvature:
      drawn =
        CurvatureSection(stages.GetCurvature().Hopf, options.Degree, options.CurvatureDirection);
      if (options.Degree == 2)
      {
        ClearCovers(stages.GetMesh(), drawn);
      }
      break;
  }
  if (std::all_of(drawn.begin(), drawn.end(), [](const Complex& q) { return q == 0.0; }))
  {
    notes.emplace_back("Alignment changes nothing: the guidance is zero everywhere.");
    drawn.clear();
  }
  else if (options.Alignment == Alignment::PrincipalCurvature)
  {
    Continue(stages.GetGeometry(), options.Degree, drawn);
  }
  return drawn;
}
}

Guide::Guide(
  Stages& stages, const Options& options, const Guidance& guidance, std::vector<std::string>& notes)
  : Given(GivenSection(stages, options, guidance))
  , Constrained(ConstraintsOf(stages, options, this->Given, notes))
  , Drawn(DrawnSection(stages, options, this->Given, notes))
{
}

ComponentGuide Guide::Of(const TriangleMesh::Component& component) const
{
  ComponentGuide part;
  if (!this->Drawn.empty())
  {
    part.Guidance = Eigen::Map<const ComplexVector>(
      this->Drawn.data() + component.FirstVertex, component.Vertices());
  }
  std::vector<Complex> values;
  for (Index v = component.FirstVertex; this->Constrained.Any() && v < component.EndVertex; ++v)
  {
    if (this->Constrained.Kind[v] != ConstraintKind::None)
    {
      part.Given.Vertices.push_back(v - component.FirstVertex);
      values.push_back(this->Constrained.Value[v]);
    }
  }
  part.Given.Values =
    Eigen::Map<const ComplexVector>(values.data(), static_cast<Eigen::Index>(values.size()));
  return part;
}

bool UsesCurvature(const Options& options)
{
  return options.Alignment == Alignment::PrincipalCurvature || options.ConstrainCurvature;
}
}
