// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Computation/Guide.h"

#include "Computation/Stages.h"
#include "Guidance/Guidance.h"
#include "Support/Threads.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

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

std::vector<double> StrengthsOf(
  const Stages& stages, const Options& options, const Guidance& guidance)
{
  if (!options.ConstrainGuidance || guidance.Strengths.empty())
  {
    return {};
  }
  const std::vector<Index>& first = stages.GetFirstPoints();
  return GuidanceStrengths(stages.GetMesh(), first.empty() ? guidance : Merged(guidance, first));
}

Constraints ConstraintsOf(Stages& stages, const Options& options, const std::vector<Complex>& given,
  const std::vector<double>& strengths, std::vector<std::string>& notes)
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
    notes.emplace_back(InsideOutNote);
  }
  return Constraints(
    { stages.GetGeometry(),
      options.ConstrainSharpEdges ? stages.GetDihedralAngles() : std::vector<double>{},
      UsesCurvature(options) ? &stages.GetCurvature(options.CurvatureScale) : nullptr, given,
      strengths },
    options, notes);
}

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

std::vector<double> CurvatureShares(
  const SurfaceGeometry& geometry, const std::vector<Complex>& hopf)
{
  std::vector<double> bends;
  for (std::size_t c = 0; c < geometry.Mesh.GetComponents().size(); ++c)
  {
    bends.push_back(Bend(geometry, hopf, c));
  }
  return SharesOfBends(std::move(bends));
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

std::string Percent(double part)
{
  return part < 0.01 ? "less than 1 %" : std::to_string(std::lround(100.0 * part)) + " %";
}

/// Says what the user may not expect of tensors.
/// @param section the guidance that they make
void NoteTensors(const TriangleMesh& mesh, const VertexTensors& tensors,
  const std::vector<Complex>& section, std::vector<std::string>& notes)
{
  // Above the rounding of single precision.
  constexpr double asymmetric = 1e-5;
  constexpr double across = 0.3;
  const auto& components = mesh.GetComponents();
  const auto empty = std::count_if(components.begin(), components.end(),
    [&](const TriangleMesh::Component& component)
    {
      return std::all_of(section.begin() + component.FirstVertex,
        section.begin() + component.EndVertex, [](const Complex& q) { return q == 0.0; });
    });
  if (empty == static_cast<std::ptrdiff_t>(components.size()))
  {
    notes.emplace_back(
      "Choose another Tensor Array: this one changes nothing, since its tensors are the same in all "
      "directions of the surface, up to noise and rounding.");
  }
  else if (empty > 0)
  {
    notes.push_back(
      "Check the tensors if that is unexpected: they are the same in all directions of "
      "the surface, up to noise and rounding, on " +
      std::to_string(empty) + " of " + std::to_string(components.size()) +
      " connected components, which have the smoothest field.");
  }
  if (tensors.AsymmetricPart > asymmetric)
  {
    notes.push_back("Check the tensors if that is unexpected: their part that is not symmetric, up "
                    "to " +
      Percent(tensors.AsymmetricPart) + " of the largest component, does not count.");
  }
  if (tensors.AcrossPart > across)
  {
    notes.push_back(
      "Check that the tensors are in the axes of space, not of the elements: the shear "
      "across the surface is more than " +
      Percent(tensors.AcrossPart) + " of them at half of the points.");
  }
}
}

Guide::Guide(Stages& stages, const Options& options, const Guidance& guidance,
  std::vector<std::string>& notes, const FollowedTensors* tensors)
  : Given(GivenSection(stages, options, guidance))
  , Strengths(StrengthsOf(stages, options, guidance))
  , Constrained(ConstraintsOf(stages, options, this->Given, this->Strengths, notes))
  , Drawn(DrawnSection(stages, options, this->Given, notes))
  , Tensors(tensors)
{
  if (tensors)
  {
    this->Follow(stages, options, notes);
  }
  if (!this->Strengths.empty())
  {
    this->Soften(notes);
  }
  if (!this->Drawn.empty() && options.Alignment == Alignment::PrincipalCurvature)
  {
    this->Shares =
      CurvatureShares(stages.GetGeometry(), stages.GetCurvature(options.CurvatureScale).Hopf);
  }
}

void Guide::Soften(std::vector<std::string>& notes)
{
  bool isAny = false;
  this->Soft.assign(this->Given.size(), 0.0);
  for (std::size_t v = 0; v < this->Given.size(); ++v)
  {
    const double weight = std::abs(this->Given[v]);
    const bool isFree =
      !this->Constrained.Any() || this->Constrained.Kind[v] == ConstraintKind::None;
    if (weight > 0.0 && this->Strengths[v] > 0.0 && isFree)
    {
      this->Soft[v] = this->Given[v] / weight * Stiffness(weight, this->Strengths[v]);
      isAny = isAny || this->Soft[v] != 0.0;
    }
  }
  if (!isAny)
  {
    this->Soft.clear();
    if (!this->Constrained.Any())
    {
      notes.emplace_back(
        "Choose other Guidance Vectors, Weights or Strengths: Constrain Guidance changes nothing, "
        "since no vector has positive weight and strength and a part in the tangent plane.");
    }
  }
}

void Guide::Follow(Stages& stages, const Options& options, std::vector<std::string>& notes)
{
  const VertexTensors& tensors =
    stages.GetTensors(this->Tensors->Tensors, this->Tensors->Options.Scale);
  std::vector<Complex> section =
    TensorSection(stages.GetGeometry(), tensors, options.Degree, this->Tensors->Options.Direction);
  NoteTensors(stages.GetMesh(), tensors, section, notes);
  if (std::all_of(section.begin(), section.end(), [](const Complex& q) { return q == 0.0; }))
  {
    return;
  }
  if (FollowsExactly(options))
  {
    this->Constrain(stages.GetMesh(), section);
  }
  else
  {
    this->Drawn = std::move(section);
  }
}

/// The constraints have priority, and their neighbours are free, as they are of any other guidance.
void Guide::Constrain(const TriangleMesh& mesh, const std::vector<Complex>& section)
{
  const bool isFree = !this->Constrained.Any();
  const auto isConstrained = [&](Index v)
  { return !isFree && this->Constrained.Kind[v] != ConstraintKind::None; };
  std::vector<char> isNear(section.size(), 0);
  for (Index e = 0; e < mesh.GetNumberOfEdges() && !isFree; ++e)
  {
    const Index i = mesh.Tail(mesh.HalfEdge(e));
    const Index j = mesh.Head(mesh.HalfEdge(e));
    isNear[i] |= isConstrained(j) ? 1 : 0;
    isNear[j] |= isConstrained(i) ? 1 : 0;
  }
  this->ExactKind.assign(section.size(), ConstraintKind::None);
  this->ExactValue.assign(section.size(), 0.0);
  for (Index v = 0; v < static_cast<Index>(section.size()); ++v)
  {
    const double weight = std::abs(section[v]);
    if (isConstrained(v))
    {
      this->ExactKind[v] = this->Constrained.Kind[v];
      this->ExactValue[v] = this->Constrained.Value[v];
    }
    else if (weight > 0.0 && isNear[v] == 0)
    {
      this->ExactKind[v] = ConstraintKind::Given;
      this->ExactValue[v] = section[v] / weight;
    }
  }
}

std::shared_ptr<const TensorGuidance> Guide::TensorsAtPoints(Stages& stages) const
{
  if (!this->Tensors)
  {
    return {};
  }
  return std::make_shared<const TensorGuidance>(AtPoints(stages.GetGeometry(),
    stages.GetTensors(this->Tensors->Tensors, this->Tensors->Options.Scale),
    this->Tensors->Options.Direction, stages.GetOutputPoints().Vertex));
}

ComponentGuide Guide::Of(const TriangleMesh& mesh, std::size_t c) const
{
  ComponentGuide part = this->ExactKind.empty()
    ? GuideOf(mesh, c, this->Drawn, this->Constrained.Kind, this->Constrained.Value)
    : GuideOf(mesh, c, this->Drawn, this->ExactKind, this->ExactValue);
  part.Share = this->Shares.empty() ? 1.0 : this->Shares[c];
  if (!this->Soft.empty())
  {
    part.Soft = this->SoftOf(mesh.GetComponents()[c]);
  }
  return part;
}

SoftConstraints Guide::SoftOf(const TriangleMesh::Component& component) const
{
  SoftConstraints soft;
  std::vector<Complex> values;
  for (Index v = component.FirstVertex; v < component.EndVertex; ++v)
  {
    const bool isFree = this->ExactKind.empty() || this->ExactKind[v] == ConstraintKind::None;
    if (this->Soft[v] != 0.0 && isFree)
    {
      soft.Vertices.push_back(v - component.FirstVertex);
      values.push_back(this->Soft[v]);
    }
  }
  soft.Values =
    Eigen::Map<const ComplexVector>(values.data(), static_cast<Eigen::Index>(values.size()));
  return soft;
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

std::vector<double> SharesOfBends(std::vector<double> bends)
{
  constexpr double slight = 0.02;
  const double most = bends.empty() ? 0.0 : *std::max_element(bends.begin(), bends.end());
  for (double& share : bends)
  {
    const double relative = most > 0.0 ? share / (slight * most) : 1.0;
    share = std::min(1.0, relative * relative);
  }
  return bends;
}

bool FollowsExactly(const Options& options)
{
  return options.AlignmentStrength >= 1.0 && !options.UseShift;
}

bool UsesCurvature(const Options& options)
{
  return options.Alignment == Alignment::PrincipalCurvature || options.ConstrainCurvature;
}
}
