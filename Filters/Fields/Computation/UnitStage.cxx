// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Computation/UnitStage.h"

#include "Matrices/OperatorProducts.h"
#include "Matrices/VectorOperations.h"
#include "UnitLength/UnitLengthField.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// The weight of a guidance over sigma at which fields of unit length are about as far from it as
/// the linear systems' are at the same strength, for degrees 1 and 2 and for all others; found by
/// trial on scans and parts.
constexpr double PullOfFewDirections = 12.0;
constexpr double PullOfManyDirections = 6.0;
/// Stronger pulls only make the numbers larger, not the field another one.
constexpr double MostPull = 1e3;
}

UnitStage::UnitStage(const IntrinsicGeometry& triangulation, const IntrinsicGeometry& surface,
  const TriangleMesh::Component& component, const Options& options, ComponentStage& stage)
  : Triangulation(triangulation)
  , Surface(surface)
  , Component(component)
  , Degree(options.Degree)
  , Stage(stage)
  , Energy(UnitEnergyMatrix(
      triangulation, component, options.Degree, options.EnergyBias, stage.GetMatrices().Energy))
{
}

double UnitStage::PullStrength(const ComponentGuide& guide, const Options& options) const
{
  const double sigma = this->Stage.Sigma();
  return (this->Degree <= 2 ? PullOfFewDirections : PullOfManyDirections) * sigma *
    std::min(MostPull, std::sqrt(this->Stage.Gap(options, guide.Share) / sigma));
}

ComplexVector UnitStage::Pull(const ComponentGuide& guide, double strength) const
{
  const auto rows = static_cast<Index>(guide.Guidance.size());
  if (rows == 0)
  {
    return {};
  }
  const SparseMatrix& mass = this->Stage.GetMatrices().Mass;
  Eigen::VectorXd area = VertexAreas(mass);
  ClearNear(guide.Given.Vertices, mass, area);
  const double largest = LargestPart(guide.Guidance, area);
  if (!(largest > 0.0))
  {
    return {};
  }
  ComplexVector pull = ComplexVector::Zero(rows);
  double sum = 0.0;
  for (Index v = 0; v < rows; ++v)
  {
    const Complex scaled(guide.Guidance[v].real() / largest, guide.Guidance[v].imag() / largest);
    if (scaled != 0.0)
    {
      pull[v] = area[v] * scaled;
      sum += std::abs(pull[v]);
    }
  }
  if (!(sum > 0.0))
  {
    return {};
  }
  pull *= strength * area.sum() / sum;
  return pull;
}

void UnitStage::Improve(const ComponentGuide& guide, const Options& options,
  const Progress& progress, ComplexVector& u, ComponentReport& report)
{
  const Operators& matrices = this->Stage.GetMatrices();
  const double strength = guide.Guidance.size() > 0 ? this->PullStrength(guide, options) : 0.0;
  // The mirror images of a cover's edges are known in the surface's own triangulation only.
  UnitLengthProblem problem{ this->Component.IsCover ? this->Surface : this->Triangulation,
    this->Surface, this->Component, this->Degree, this->Energy, matrices.Mass,
    strength > 0.0 ? this->Pull(guide, strength) : ComplexVector{}, {} };
  const SoftTerms* const soft = this->Stage.SoftTermsOf(guide);
  const bool isDrawn = problem.Pull.size() > 0;
  if (soft)
  {
    // For sections of modulus 1 the terms of both kinds are the same but for a constant.
    problem.Pull = isDrawn ? ComplexVector(problem.Pull + soft->GetPull()) : soft->GetPull();
  }
  FreeSystem* free = nullptr;
  if (!guide.Given.Vertices.empty() || soft)
  {
    problem.IsGiven.assign(u.size(), 0);
    for (std::size_t k = 0; k < guide.Given.Vertices.size(); ++k)
    {
      problem.IsGiven[guide.Given.Vertices[k]] = 1;
      u[guide.Given.Vertices[k]] = guide.Given.Values[static_cast<Eigen::Index>(k)];
    }
    if (!options.Preview)
    {
      free = &this->Stage.FreeSystemOf(guide);
    }
  }
  UnitLengthSettings settings;
  settings.SingularityCost = options.SingularityCost * 2.0 * Pi * std::log(2.0);
  settings.Starts = options.NumberOfStarts;
  settings.Rate = this->Stage.Sigma();
  // Soft constraints are in the free system's energy.
  settings.Pull = isDrawn ? strength : 0.0;
  if (options.Preview || (free && free->Free.IsEmpty()))
  {
    MakeUnit(u);
    report.UnitEnergyBefore = report.UnitEnergyAfter = problem.Energy(u);
  }
  else
  {
    const UnitLengthReport made =
      MakeUnitLength(problem, free ? free->Hierarchy : this->Stage.GetHierarchy(),
        free ? &free->Free : nullptr, settings, progress, u);
    report.UnitEnergyBefore = made.EnergyBefore;
    report.UnitEnergyAfter = made.EnergyAfter;
    report.CancelledPairs = made.CancelledPairs;
    report.UnitSteps = made.Steps;
  }
  const SectionProducts products(matrices, u);
  report.SmoothnessEnergy =
    this->Stage.PerArea(std::max(0.0, RealDot(u, products.Energy)) / RealDot(u, products.Mass));
}
}
