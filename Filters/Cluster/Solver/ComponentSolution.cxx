// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Solver/ComponentSolution.h"

#include "Computation/ComponentSetup.h"
#include "Computation/Guide.h"
#include "Computation/SystemFactors.h"
#include "Mesh/CoverSymmetry.h"
#include "Mesh/StopSignal.h"
#include "Progress.h"
#include "Sections/ReferenceSection.h"
#include "Solver/DistributedEigenpair.h"
#include "Solver/DistributedHierarchy.h"
#include "Solver/DistributedMatrices.h"
#include "Solver/DistributedSystem.h"
#include "Solver/MovedComponents.h"
#include "Support/Division.h"
#include "Systems/SystemSolution.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <new>

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
      for (const Part& part : this->Parts)
      {
        overlap += part.Reference.OverlapWith(axis, SectionOn(part, section), part.IsOwned);
      }
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
    for (const Part& part : this->Parts)
    {
      best += part.Reference.FindCandidate(SectionOn(part, section), part.IsOwned);
    }
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

double ShareOf(const DistributedGuide& guide, int component)
{
  return guide.Shares.empty() ? 1.0 : guide.Shares[component];
}

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
    CoverSymmetry(mesh, component, degree).MakeSymmetric(messages, section);
    GiveRows(matrices, section, vector);
  }
}

/// Solves for a component that lies across processes.
/// @param rowOf as in AssembleMatrices
/// @return whether other fields are as smooth as this one, and nothing has chosen among them
bool SolveAcross(Processes& processes, const Messages& messages, const DistributedMesh& mesh,
  int component, const DistributedGuide& guide, const Options& options,
  const std::function<bool(double)>& goOn, std::vector<PetscInt>& rowOf,
  std::vector<Complex>& section, ComponentReport& report)
{
  const DistributedMatrices matrices = AssembleMatrices(
    processes, messages, mesh, component, options.Degree, options.EnergyBias, rowOf);
  DistributedSettings settings;
  settings.Tolerance = options.Tolerance;
  settings.MaximumIterations = options.MaximumIterations;
  // The area of a surface is that of one of its sides.
  const double sides = mesh.IsCover(component) ? 2.0 : 1.0;
  settings.Scale = 2.0 * Pi * options.Degree * sides / matrices.Area;
  settings.GoOn = goOn;
  DistributedHierarchy hierarchy(matrices.Energy, matrices.Mass, settings.Scale);
  const DistributedEigenpair pair = FindSmallestPair(matrices, hierarchy, settings);
  FixPhase(messages, mesh, component, options.Degree, matrices, section, pair.Vector);
  const DistributedSystem system(messages, mesh, matrices, guide);
  bool isSmoothest = false;
  const OwnedVec field =
    SolveProblem({ matrices, system, hierarchy, pair, options, ShareOf(guide, component), goOn },
      report, isSmoothest);
  TakeRows(matrices, field, section);
  if (mesh.IsCover(component))
  {
    CoverSymmetry(mesh, component, options.Degree).Symmetrize(section);
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

/// Which components of the whole surface are solved for in which way.
struct Shares
{
  /// The components that are on this process alone, and then those that have been moved here.
  std::vector<int> Own;
  /// The components that lie across processes.
  std::vector<int> Across;
  /// The part of this process's vertices that the own ones have.
  double OwnPart = 0.0;
};

Shares SharesOf(const Messages& messages, const DistributedMesh& mesh, const MovedComponents& moved)
{
  Shares shares;
  double vertices = 0.0;
  for (int component = 0; component < mesh.CountComponents(); ++component)
  {
    if (mesh.ProcessOf(component) < 0)
    {
      if (!moved.IsMoved(component))
      {
        shares.Across.push_back(component);
      }
    }
    else if (mesh.ProcessOf(component) == messages.Own())
    {
      shares.Own.push_back(component);
      vertices += mesh.GetMesh().GetComponents()[mesh.PartsOf(component).front()].Vertices();
    }
  }
  shares.OwnPart = shares.Across.empty()
    ? 1.0
    : vertices / std::max<Index>(1, mesh.GetMesh().GetNumberOfVertices());
  shares.Own.insert(shares.Own.end(), moved.Here().begin(), moved.Here().end());
  return shares;
}

/// Solves for a component that is on this process alone, as one process does.
/// @param section over the vertices of the geometry
void SolveAlone(const SurfaceGeometry& geometry, std::size_t part, const ComponentGuide& own,
  const Options& options, const Progress& progress, std::vector<Complex>& section,
  ComponentReport& report)
{
  ComponentStage stage =
    SetUpComponent(geometry, part, geometry, options, progress.Part(0.0, 0.65));
  const ComplexVector u = stage.Solve(own, options, progress.Part(0.65, 1.0), report);
  std::copy(u.begin(), u.end(), section.begin() + geometry.Mesh.GetComponents()[part].FirstVertex);
  report.Constraints = static_cast<Index>(own.Given.Vertices.size());
}

/// Solves on each process for the components that it has alone, on all processes at once.
/// @param goOn says nothing of the other processes
void SolveOwn(Processes& processes, const Messages& messages, const DistributedMesh& mesh,
  const MovedComponents& moved, const Shares& shares, const DistributedGuide& guide,
  const Options& options, const std::function<bool(double)>& goOn, std::vector<Complex>& section,
  std::vector<ComponentReport>& reports)
{
  StopSignal signal(messages);
  const ProgressFunction goOnOrStop = [&](double done)
  { return goOn(shares.OwnPart * done) && !signal.IsRaised(); };
  const Progress progress(goOnOrStop);
  const auto count = static_cast<double>(shares.Own.size());
  const std::size_t first = shares.Own.size() - moved.Here().size();
  std::vector<Complex> movedSection;
  const auto solveOne = [&](std::size_t k)
  {
    const int component = shares.Own[k];
    const Progress part =
      progress.Part(static_cast<double>(k) / count, static_cast<double>(k + 1) / count);
    if (k >= first)
    {
      ComponentGuide own = moved.GuideOf(k - first);
      own.Share = ShareOf(guide, component);
      SolveAlone(
        moved.GetGeometry(), k - first, own, options, part, movedSection, reports[component]);
      return;
    }
    const std::size_t own = mesh.PartsOf(component).front();
    ComponentGuide guided = GuideOf(mesh.GetMesh(), own,
      guide.IsDrawn ? guide.Drawn : std::vector<Complex>(), guide.Kind, guide.Value);
    guided.Share = ShareOf(guide, component);
    SolveAlone(mesh.GetGeometry(), own, guided, options, part, section, reports[component]);
  };
  const auto solve = [&]
  {
    try
    {
      if (!moved.Here().empty())
      {
        movedSection.resize(moved.GetGeometry().Positions.size());
      }
      for (std::size_t k = 0; k < shares.Own.size(); ++k)
      {
        solveOne(k);
      }
    }
    catch (const Stopped&)
    {
      signal.Raise();
      throw ProcessesError("");
    }
    catch (...)
    {
      signal.Raise();
      throw;
    }
  };
  try
  {
    processes.Together(solve);
  }
  catch (...)
  {
    signal.Finish();
    throw;
  }
  signal.Finish();
  moved.SendBack(processes, messages, movedSection, section);
}

/// Tells all processes the reports of each about the components that it has alone.
void ShareReports(
  const Messages& messages, const Shares& shares, std::vector<ComponentReport>& reports)
{
  std::vector<ComponentReport> own;
  for (const int component : shares.Own)
  {
    own.push_back(reports[component]);
  }
  const std::vector<int> components = messages.AllGather(shares.Own).Values;
  const std::vector<ComponentReport> all = messages.AllGather(own).Values;
  for (std::size_t k = 0; k < components.size(); ++k)
  {
    reports[components[k]] = all[k];
  }
}
}

DistributedSolution SolveDistributed(Processes& processes, const Messages& messages,
  const DistributedMesh& mesh, const PieceWithSurroundings& piece, const DistributedGuide& guide,
  const Options& options, const std::function<bool(double)>& goOn)
{
  DistributedSolution solution;
  std::vector<Complex>& section = solution.Section;
  std::vector<ComponentReport>& reports = solution.Reports;
  std::vector<PetscInt> rowOf;
  processes.Together(
    [&]
    {
      section.assign(static_cast<std::size_t>(mesh.GetMesh().GetNumberOfVertices()), 0.0);
      rowOf.resize(section.size());
      reports.resize(static_cast<std::size_t>(mesh.CountComponents()));
    });
  const MovedComponents moved(processes, messages, mesh, piece, guide);
  const Shares shares = SharesOf(messages, mesh, moved);
  SolveOwn(processes, messages, mesh, moved, shares, guide, options, goOn, section, reports);
  ShareReports(messages, shares, reports);
  const auto count = static_cast<double>(shares.Across.size());
  for (std::size_t k = 0; k < shares.Across.size(); ++k)
  {
    const auto part = [&](double done)
    {
      const double all =
        shares.OwnPart + (1.0 - shares.OwnPart) * (static_cast<double>(k) + done) / count;
      return !messages.Any(!goOn(all));
    };
    const int component = shares.Across[k];
    try
    {
      const bool isAmbiguous = SolveAcross(processes, messages, mesh, component, guide, options,
        part, rowOf, section, reports[component]);
      solution.Ambiguous += isAmbiguous ? 1 : 0;
    }
    catch (const std::bad_alloc&)
    {
      EndAllForMemory("");
    }
  }
  mesh.Complete(section);
  return solution;
}
}
