// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Computation/Guide.h"

#include "Computation/Stages.h"
#include "Guidance/Guidance.h"
#include "Support/Threads.h"

#include <algorithm>
#include <cmath>

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
  if (UsesCurvature(options) && DependsOnSide(options.Degree, options.CurvatureDirection) &&
    stages.GetMesh().GetRepairs().NonOrientableComponents > 0)
  {
    notes.emplace_back(
      "Set Curvature Direction to Least Bent or Most Bent, or take 4 directions per point: on a "
      "surface that cannot be oriented the larger and the smaller curvature change places on a "
      "walk around it.");
  }
  if (UsesCurvature(options) && stages.GetCurvature(options.CurvatureScale).IsInsideOut)
  {
    notes.emplace_back(
      "Turn the triangles if that was not meant: a closed part of the surface is wound inside out. "
      "Its curvature is taken as seen from outside.");
  }
  return Constraints(
    { stages.GetGeometry(),
      options.ConstrainSharpEdges ? stages.GetDihedralAngles() : std::vector<double>{},
      UsesCurvature(options) ? &stages.GetCurvature(options.CurvatureScale) : nullptr, given },
    options, notes);
}

/// How curved a component is for its size: the root of the mean of |q|^2 area.
double Bend(const SurfaceGeometry& geometry, const std::vector<Complex>& hopf, std::size_t c)
{
  const TriangleMesh::Component& component = geometry.Mesh.GetComponents()[c];
  const double squares = ParallelSum<double>(component.Triangles(), MediumPiece, 0.0,
    [&](Index begin, Index end)
    {
      double sum = 0.0;
      for (Index t = component.FirstTriangle + begin; t < component.FirstTriangle + end; ++t)
      {
        for (Index h = 3 * t; h < 3 * t + 3; ++h)
        {
          sum += geometry.Lengths.Area[t] / 3.0 * std::norm(hopf[geometry.Mesh.Tail(h)]);
        }
      }
      return sum;
    });
  return std::sqrt(squares);
}

/// The share of the strength that a component has of which almost nothing is curved beside others
/// that are: all of it down to a fiftieth of the most curved one, below that by the square.
std::vector<double> CurvatureShares(
  const SurfaceGeometry& geometry, const std::vector<Complex>& hopf)
{
  constexpr double slight = 0.02;
  std::vector<double> shares;
  for (std::size_t c = 0; c < geometry.Mesh.GetComponents().size(); ++c)
  {
    shares.push_back(Bend(geometry, hopf, c));
  }
  const double most = shares.empty() ? 0.0 : *std::max_element(shares.begin(), shares.end());
  for (double& share : shares)
  {
    const double relative = most > 0.0 ? share / (slight * most) : 1.0;
    share = std::min(1.0, relative * relative);
  }
  return shares;
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
      drawn = CurvatureSection(
        stages.GetCurvature(options.CurvatureScale), options.Degree, options.CurvatureDirection);
      if (DependsOnSide(options.Degree, options.CurvatureDirection))
      {
        ClearCovers(stages.GetMesh(), drawn);
      }
      break;
  }
  if (std::all_of(drawn.begin(), drawn.end(), [](const Complex& q) { return q == 0.0; }))
  {
    notes.emplace_back(
      "Choose another Alignment: this one changes nothing, since the guidance is zero everywhere.");
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
  if (!this->Drawn.empty() && options.Alignment == Alignment::PrincipalCurvature)
  {
    this->Shares =
      CurvatureShares(stages.GetGeometry(), stages.GetCurvature(options.CurvatureScale).Hopf);
  }
}

ComponentGuide Guide::Of(const TriangleMesh& mesh, std::size_t c) const
{
  ComponentGuide part =
    GuideOf(mesh, c, this->Drawn, this->Constrained.Kind, this->Constrained.Value);
  part.Share = this->Shares.empty() ? 1.0 : this->Shares[c];
  return part;
}

ComponentGuide GuideOf(const TriangleMesh& mesh, std::size_t c, const std::vector<Complex>& drawn,
  const std::vector<ConstraintKind>& kind, const std::vector<Complex>& value)
{
  const TriangleMesh::Component& component = mesh.GetComponents()[c];
  ComponentGuide part;
  if (!drawn.empty())
  {
    part.Guidance =
      Eigen::Map<const ComplexVector>(drawn.data() + component.FirstVertex, component.Vertices());
  }
  std::vector<Complex> values;
  for (Index v = component.FirstVertex; !kind.empty() && v < component.EndVertex; ++v)
  {
    if (kind[v] != ConstraintKind::None)
    {
      part.Given.Vertices.push_back(v - component.FirstVertex);
      values.push_back(value[v]);
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
