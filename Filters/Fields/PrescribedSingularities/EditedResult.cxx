// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "PrescribedSingularities/EditedResult.h"

#include "Computation/FieldToResult.h"
#include "Curvature/Curvature.h"
#include "Geometry/DihedralAngles.h"
#include "Guidance/Guidance.h"
#include "Mesh/OutputPoints.h"

#include <algorithm>

namespace DirectionFields
{
Result ToResult(const SingularityEditor& editor, const EditedField& edited)
{
  const GivenField& base = editor.GetBase();
  const std::vector<Index>& first = editor.GetFirstPoints();
  Result result;
  result.Degree = base.GetDegree();
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    result.Repaired.MergedPoints += first[i] != static_cast<Index>(i) ? 1 : 0;
  }
  AddSection(base.GetGeometry(), base.GetSurface(),
    OutputPoints(base.GetMesh(), base.GetSurface(), first), edited.Section, result);
  result.Notes = edited.Notes;
  return result;
}

std::vector<Complex> GuidanceFor(const SingularityEditor& editor, const Options& options,
  const Guidance& guidance, std::vector<std::string>& notes)
{
  Check(options);
  const SurfaceGeometry& geometry = editor.GetBase().GetGeometry();
  std::vector<Complex> section;
  if (options.Alignment == Alignment::PrincipalCurvature)
  {
    const Curvature curvature(geometry, DihedralAngles(geometry));
    section = CurvatureSection(curvature, options.Degree, options.CurvatureDirection);
    if (DependsOnSide(options.Degree, options.CurvatureDirection))
    {
      ClearCovers(geometry.Mesh, section);
    }
  }
  else if (options.Alignment == Alignment::PointVectors)
  {
    const std::vector<Index>& first = editor.GetFirstPoints();
    section =
      GuidanceSection(geometry, first.empty() ? guidance : Merged(guidance, first), options.Degree);
  }
  const bool isZero =
    std::all_of(section.begin(), section.end(), [](const Complex& q) { return q == 0.0; });
  if (isZero && options.Alignment != Alignment::None)
  {
    notes.emplace_back(
      "Choose another Alignment: this one changes nothing, since the guidance is zero everywhere.");
  }
  return isZero ? std::vector<Complex>() : section;
}
}
