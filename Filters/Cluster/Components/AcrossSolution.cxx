// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Components/AcrossSolution.h"

#include "Computation/Guide.h"
#include "Computation/SystemFactors.h"
#include "Mesh/CoverSymmetry.h"
#include "Progress.h"
#include "Sections/ReferenceSection.h"
#include "Solver/DistributedEigenpair.h"
#include "Solver/DistributedHierarchy.h"
#include "Solver/DistributedMatrices.h"
#include "Solver/DistributedSystem.h"
#include "Support/Division.h"
#include "Systems/SystemSolution.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace DirectionFields::Parallel
{
namespace
{
/// Systems are solved to this part of their tolerance: cycles of several processes leave other
/// errors than cycles of one process, and the fields are compared.
constexpr double TightTolerance = 0.01;

/// Copies own rows to their vertices.
void TakeRows(const DistributedMatrices& matrices, Vec rows, std::vector<Complex>& section)
{
  const PetscScalar* values = nullptr;
  Require(VecGetArrayRead(rows, &values));
  for (std::size_t k = 0; k < matrices.Vertices.size(); ++k)
  {
    section[matrices.Vertices[k]] = values[k];
  }
  Require(VecRestoreArrayRead(rows, &values));
}

/// Copies own rows from their vertices.
void GiveRows(const DistributedMatrices& matrices, const std::vector<Complex>& section, Vec rows)
{
  PetscScalar* values = nullptr;
  Require(VecGetArray(rows, &values));
  for (std::size_t k = 0; k < matrices.Vertices.size(); ++k)
  {
    values[k] = section[matrices.Vertices[k]];
  }
  Require(VecRestoreArray(rows, &values));
}

/// The phase rule of ReferenceSection for a component in pieces.
class GlobalPhase
{
public:
  GlobalPhase(const Messages& messages, const DistributedMesh& mesh, int component, int degree)
    : Exchange(messages)
  {
    const TriangleMesh& triangles = mesh.GetMesh();
    double box[6];
    std::fill(box, box + 6, -std::numeric_limits<double>::max());
    const auto readParts = [&]
    {
      for (const std::size_t c : mesh.PartsOf(component))
      {
        const TriangleMesh::Component& part = triangles.GetComponents()[c];
        this->Parts.push_back({ part, ReferenceSection(mesh.GetGeometry(), part, degree), {} });
        for (Index v = part.FirstVertex; v < part.EndVertex; ++v)
        {
          this->Parts.back().IsOwned.push_back(mesh.IsOwned(v) ? 1 : 0);
          const Vector3& place = mesh.GetGeometry().Positions[v];
          for (int k = 0; k < 3 && mesh.IsOwned(v); ++k)
          {
            box[k] = std::max(box[k], -place[k]);
            box[3 + k] = std::max(box[3 + k], place[k]);
          }
        }
      }
    };
    messages.Together(readParts);
    for (double& side : box)
    {
      side = messages.Largest(side);
    }
    for (Part& part : this->Parts)
    {
      part.Reference.SetBox({ -box[0], -box[1], -box[2] }, { box[3], box[4], box[5] });
    }
  }

  /// The factor of modulus 1 that a section has to be multiplied by.
  Complex Of(const std::vector<Complex>& section) const
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      ReferenceSection::Overlap overlap;
      this->Exchange.Together(
        [&]
        {
          for (const Part& part : this->Parts)
          {
            overlap += part.Reference.OverlapWith(axis, SectionOn(part, section), part.IsOwned);
          }
        });
      double sums[3] = { overlap.Sum.real(), overlap.Sum.imag(), overlap.Size };
      this->Exchange.Sum(sums, 3);
      overlap.Sum = Complex(sums[0], sums[1]);
      overlap.Size = sums[2];
      if (overlap.Decides())
      {
        return overlap.Sum / std::abs(overlap.Sum);
      }
    }
    ReferenceSection::Candidate best;
    this->Exchange.Together(
      [&]
      {
        for (const Part& part : this->Parts)
        {
          best += part.Reference.FindCandidate(SectionOn(part, section), part.IsOwned);
        }
      });
    const std::vector<double> all =
      this->Exchange
        .AllGather(std::vector<double>{ best.Value, best.Overlap.real(), best.Overlap.imag() })
        .Values;
    best = {};
    for (std::size_t k = 0; k < all.size(); k += 3)
    {
      best += { all[k], 0, Complex(all[k + 1], all[k + 2]) };
    }
    return std::abs(best.Overlap) > 0.0 ? best.Overlap / std::abs(best.Overlap) : Complex(1.0);
  }

private:
  struct Part
  {
    const TriangleMesh::Component& Range;
    ReferenceSection Reference;
    std::vector<char> IsOwned;
  };
  static ComplexVector SectionOn(const Part& part, const std::vector<Complex>& section)
  {
    return Eigen::Map<const ComplexVector>(
      section.data() + part.Range.FirstVertex, part.Range.Vertices());
  }

  const Messages& Exchange;
  std::vector<Part> Parts;
};

/// The input of a component's fields.
struct Problem
{
  const DistributedMatrices& Matrices;
  const DistributedSystem& System;
  DistributedHierarchy& Hierarchy;
  const DistributedEigenpair& Smallest;
  const Options& Asked;
  /// Of the alignment's strength, 0 to 1.
  double Share = 1.0;
  const std::function<bool(double)>& GoOn;
};

/// The aligned or constrained field. The gap grows where the system turns out to be indefinite.
DistributedSystem::Solution SolveAt(const Problem& problem, double gap, ComponentReport& report)
{
  const double smallest = problem.Smallest.Value;
  for (;;)
  {
    SystemFactors factors;
    report.Lambda = 0.0;
    if (problem.System.HasGuidance())
    {
      factors = FactorsAt(smallest, gap);
      report.Lambda = std::isinf(gap) ? std::numeric_limits<double>::lowest()
                                      : PerSquare(smallest - gap, problem.Matrices.Unit);
    }
    DistributedSystem::Solution solution = problem.System.Solve(
      factors, TightTolerance * SystemTolerance(problem.Asked), problem.Hierarchy, problem.GoOn);
    if (!solution.Indefinite)
    {
      return solution;
    }
    if (!problem.System.HasGuidance() || gap >= smallest)
    {
      throw NotPositiveDefinite();
    }
    gap = GrownGap(gap, smallest, problem.Hierarchy.GetScale());
  }
}

/// The field of the component, and its figures in the report.
/// @param isSmoothest becomes whether nothing guides the field
OwnedVec SolveProblem(const Problem& problem, ComponentReport& report, bool& isSmoothest)
{
  const DistributedMatrices& matrices = problem.Matrices;
  const DistributedEigenpair& smallest = problem.Smallest;
  const double scale = problem.Hierarchy.GetScale();
  const double gap = SystemGap(
    problem.Asked, problem.Share, { smallest.Value, smallest.Residual }, scale, matrices.Unit);
  report.Lambda = PerSquare(smallest.Value, matrices.Unit);
  DistributedSystem::Solution solution;
  PetscReal length = 0.0;
  if (problem.System.HasGiven() ||
    (problem.System.HasGuidance() && gap > SmallestSystemGap(smallest.Value, scale)))
  {
    solution = SolveAt(problem, gap, report);
    Require(VecNorm(solution.Vector, NORM_INFINITY, &length));
  }
  isSmoothest = length == 0.0;
  if (isSmoothest)
  {
    Require(VecDuplicate(smallest.Vector, solution.Vector.New()));
    Require(VecCopy(smallest.Vector, solution.Vector));
    problem.System.TurnToGuidance(solution.Vector);
  }
  OwnedVec product;
  PetscScalar energy = 0.0;
  PetscScalar mass = 0.0;
  Require(VecDuplicate(solution.Vector, product.New()));
  Require(MatMult(matrices.Energy, solution.Vector, product));
  Require(VecDot(product, solution.Vector, &energy));
  Require(MatMult(matrices.Mass, solution.Vector, product));
  Require(VecDot(product, solution.Vector, &mass));
  const double size = PetscRealPart(mass);
  report.SmoothnessEnergy = PerSquare(std::max(0.0, PetscRealPart(energy) / size), matrices.Unit);
  report.SystemResidual = solution.Residual;
  // Modulus 1 in the mean square.
  Require(VecScale(solution.Vector, std::sqrt(matrices.Area / size)));
  return std::move(solution.Vector);
}

/// Fixes the phase of the smallest eigenvector.
void FixPhase(const Messages& messages, const DistributedMesh& mesh, int component, int degree,
  const DistributedMatrices& matrices, std::vector<Complex>& section, Vec vector)
{
  TakeRows(matrices, vector, section);
  const GlobalPhase phase(messages, mesh, component, degree);
  Require(VecScale(vector, phase.Of(section)));
  if (mesh.IsCover(component))
  {
    TakeRows(matrices, vector, section);
    std::optional<const CoverSymmetry> symmetry;
    messages.Together([&] { symmetry.emplace(mesh, component, degree); });
    symmetry->MakeSymmetric(messages, section);
    GiveRows(matrices, section, vector);
  }
}
}

bool SolveAcross(const Messages& members, const ProcessGroups::Group& group,
  const DistributedMesh& mesh, const DistributedGuide& guide, const Options& options,
  const std::function<bool(double)>& goOn, std::vector<PetscInt>& rowOf,
  std::vector<Complex>& section, ComponentReport& report)
{
  const int component = group.Component;
  const DistributedMatrices matrices = AssembleMatrices(
    members, group.Members, mesh, component, options.Degree, options.EnergyBias, rowOf);
  DistributedSettings settings;
  settings.Tolerance = options.Tolerance;
  settings.MaximumIterations = options.MaximumIterations;
  // The area of a surface is that of one of its sides.
  const double sides = mesh.IsCover(component) ? 2.0 : 1.0;
  settings.Scale = 2.0 * Pi * options.Degree * sides / matrices.Area;
  settings.GoOn = goOn;
  DistributedHierarchy hierarchy(matrices.Energy, matrices.Mass, settings.Scale);
  const DistributedEigenpair pair = FindSmallestPair(matrices, hierarchy, settings);
  FixPhase(members, mesh, component, options.Degree, matrices, section, pair.Vector);
  const DistributedSystem system(members, mesh, matrices, guide);
  bool isSmoothest = false;
  const OwnedVec field =
    SolveProblem({ matrices, system, hierarchy, pair, options, guide.ShareOf(component), goOn },
      report, isSmoothest);
  TakeRows(matrices, field, section);
  if (mesh.IsCover(component))
  {
    members.Together([&] { CoverSymmetry(mesh, component, options.Degree).Symmetrize(section); });
  }
  report.Eigenvalue = PerSquare(pair.Value, matrices.Unit);
  report.Residual = pair.Residual;
  report.RequiredResidual = pair.RequiredResidual;
  report.Iterations = pair.Iterations;
  report.SolverUsed = Solver::Multigrid;
  report.Constraints = system.CountGiven() / (mesh.IsCover(component) ? 2 : 1);
  report.Converged =
    pair.Residual <= pair.RequiredResidual && report.SystemResidual <= SystemTolerance(options);
  return isSmoothest && pair.IsRepeated;
}
}
