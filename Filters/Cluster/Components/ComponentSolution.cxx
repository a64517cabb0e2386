// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Components/ComponentSolution.h"

#include "Components/AcrossSolution.h"
#include "Components/MovedComponents.h"
#include "Components/ProcessGroups.h"
#include "Computation/ComponentSetup.h"
#include "Computation/Guide.h"
#include "Mesh/StopSignal.h"
#include "Progress.h"
#include "Solver/PetscObjects.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <memory>
#include <new>

namespace DirectionFields::Parallel
{
namespace
{
/// Which components of the whole surface are solved for in which way.
struct Shares
{
  /// The components that are on this process alone, and then those that have been moved here.
  std::vector<int> Own;
  /// The components that lie across processes.
  std::vector<int> Across;
  /// The part of the vertices that this process solves for that the own ones have.
  double OwnPart = 0.0;
};

Shares SharesOf(const Messages& messages, const DistributedMesh& mesh, const MovedComponents& moved)
{
  Shares shares;
  double own = moved.Here().empty() ? 0.0 : moved.GetGeometry().Positions.size();
  double across = 0.0;
  const auto& parts = mesh.GetMesh().GetComponents();
  for (int component = 0; component < mesh.CountComponents(); ++component)
  {
    if (mesh.ProcessOf(component) < 0)
    {
      if (!moved.IsMoved(component))
      {
        shares.Across.push_back(component);
        for (const std::size_t part : mesh.PartsOf(component))
        {
          across += parts[part].Vertices();
        }
      }
    }
    else if (mesh.ProcessOf(component) == messages.Own())
    {
      shares.Own.push_back(component);
      own += parts[mesh.PartsOf(component).front()].Vertices();
    }
  }
  shares.OwnPart = shares.Across.empty() ? 1.0 : own / std::max(1.0, own + across);
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
      own.Share = guide.ShareOf(component);
      SolveAlone(
        moved.GetGeometry(), k - first, own, options, part, movedSection, reports[component]);
      return;
    }
    const std::size_t own = mesh.PartsOf(component).front();
    ComponentGuide guided = GuideOf(mesh.GetMesh(), own,
      guide.IsDrawn ? guide.Drawn : std::vector<Complex>(), guide.Kind, guide.Value);
    guided.Share = guide.ShareOf(component);
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

/// Solves for the components that lie across processes, each by the processes that have parts of
/// it; those without common processes at once.
/// @param goOn says nothing of the other processes
void SolveShared(Processes& processes, const Messages& messages, const DistributedMesh& mesh,
  const ProcessGroups& groups, const Shares& shares, const DistributedGuide& guide,
  const Options& options, const std::function<bool(double)>& goOn, std::vector<PetscInt>& rowOf,
  DistributedSolution& solution)
{
  StopSignal signal(messages);
  std::exception_ptr failure;
  const auto count = static_cast<double>(groups.Own().size());
  double ambiguous = 0.0;
  for (std::size_t k = 0; k < groups.Own().size(); ++k)
  {
    const ProcessGroups::Group& group = groups.Own()[k];
    const Messages members(group.Communicator);
    // Whoever has failed says so to those that wait for it, and they do without this component.
    if (members.Any(failure || signal.IsRaised()))
    {
      continue;
    }
    const auto part = [&](double done)
    {
      const double all =
        shares.OwnPart + (1.0 - shares.OwnPart) * (static_cast<double>(k) + done) / count;
      return !members.Any(!goOn(all) || signal.IsRaised());
    };
    try
    {
      const bool isAmbiguous = SolveAcross(members, group, mesh, guide, options, part, rowOf,
        solution.Section, solution.Reports[group.Component]);
      ambiguous += isAmbiguous && members.Own() == 0 ? 1.0 : 0.0;
    }
    catch (const TooLittleMemory&)
    {
      failure = std::current_exception();
    }
    catch (const std::bad_alloc&)
    {
      EndAllForMemory("");
    }
    catch (const Stopped&)
    {
      failure = std::make_exception_ptr(ProcessesError(""));
    }
    catch (...)
    {
      failure = std::current_exception();
    }
    if (failure)
    {
      signal.Raise();
    }
  }
  if (!signal.WaitForAll([&] { return goOn(1.0); }) && !failure)
  {
    failure = std::make_exception_ptr(ProcessesError(""));
  }
  signal.Finish();
  processes.Together(
    [&]
    {
      if (failure)
      {
        std::rethrow_exception(failure);
      }
    });
  solution.Ambiguous = static_cast<int>(messages.Sum(ambiguous));
}

/// Tells all processes the reports of each about the components that it has alone, and of the first
/// process of each group.
void ShareReports(const Messages& messages, const Shares& shares, const ProcessGroups& groups,
  std::vector<ComponentReport>& reports)
{
  std::vector<int> known = shares.Own;
  for (const ProcessGroups::Group& group : groups.Own())
  {
    if (group.Members.front() == messages.Own())
    {
      known.push_back(group.Component);
    }
  }
  std::vector<ComponentReport> own;
  for (const int component : known)
  {
    own.push_back(reports[component]);
  }
  const std::vector<int> components = messages.AllGather(known).Values;
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
  auto moved = std::make_unique<MovedComponents>(processes, messages, mesh, piece, guide);
  const Shares shares = SharesOf(messages, mesh, *moved);
  SolveOwn(processes, messages, mesh, *moved, shares, guide, options, goOn, section, reports);
  // Those that all solve for need its memory.
  moved.reset();
  const ProcessGroups groups(messages, mesh, shares.Across);
  SolveShared(processes, messages, mesh, groups, shares, guide, options, goOn, rowOf, solution);
  ShareReports(messages, shares, groups, reports);
  mesh.Complete(section);
  return solution;
}
}
