// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Reports/FieldWarnings.h"

#include "Support/Sentences.h"

#include <algorithm>

namespace DirectionFields
{
namespace
{
/// The repairs of the input; empty if there were none.
std::string Describe(const Repairs& repaired)
{
  Internal::Sentence text;
  const auto count = [&text](Index number, const char* one, const char* many, const char* remedy)
  {
    if (number > 0)
    {
      text << (text.tellp() > 0 ? "; " : "") << number << ' ' << (number == 1 ? one : many) << ' '
           << remedy;
    }
  };
  count(repaired.ReversedTriangles, "triangle wound against the majority",
    "triangles wound against the majority", "turned");
  count(repaired.DuplicateTriangles, "duplicate triangle", "duplicate triangles", "ignored");
  count(repaired.CollapsedTriangles, "triangle with a repeated corner",
    "triangles with a repeated corner", "ignored");
  count(repaired.DegenerateTriangles, "triangle without area", "triangles without area",
    "given a little area");
  count(repaired.NonOrientableComponents,
    "connected component that cannot be oriented, like a Möbius strip,",
    "connected components that cannot be oriented, like a Möbius strip,",
    "covered on both sides, with a seam in the normals");
  count(repaired.NonManifoldEdges, "edge of more than two triangles",
    "edges of more than two triangles", "split");
  count(repaired.NonManifoldPoints, "point where several sheets meet",
    "points where several sheets meet", "split");
  return text.str();
}

/// The components whose residual exceeds a tolerance.
struct Unsolved
{
  int Number = 0;
  double WorstResidual = 0.0;

  void Add(double residual)
  {
    ++this->Number;
    this->WorstResidual = std::max(this->WorstResidual, residual);
  }
};

/// Empty if the aligned and constrained systems of all components were solved.
std::string DescribeUnsolvedSystems(const Result& field, const Options& options)
{
  Unsolved systems;
  for (const ComponentReport& component : field.Components)
  {
    if (component.SystemResidual > SystemTolerance(options))
    {
      systems.Add(component.SystemResidual);
    }
  }
  if (systems.Number == 0)
  {
    return {};
  }
  Internal::Sentence text;
  text << (options.Solver == Solver::Multigrid ? "Set Solver to Automatic"
                                               : "Remesh the surface more evenly")
       << ": the aligned or constrained system of " << systems.Number << " of "
       << field.Components.size() << " connected components was solved to a relative residual of "
       << systems.WorstResidual << " only.";
  return text.str();
}

/// Empty if the eigenvalue problems of all components were solved.
std::string DescribeUnsolvedEigenvalues(const Result& field, const Options& options)
{
  Unsolved eigenpairs;
  double required = options.Tolerance;
  bool exhausted = false;
  for (const ComponentReport& component : field.Components)
  {
    if (component.Residual > component.RequiredResidual)
    {
      required = std::min(required, component.RequiredResidual);
      eigenpairs.Add(component.Residual);
      exhausted = exhausted || component.Iterations >= options.MaximumIterations;
    }
  }
  if (eigenpairs.Number == 0)
  {
    return {};
  }
  Internal::Sentence text;
  if (exhausted)
  {
    text << "Raise Maximum Iterations";
  }
  else if (options.Solver == Solver::Multigrid)
  {
    text << "Set Solver to Automatic, since multigrid does not get further here";
  }
  else
  {
    text << "Remesh the surface, since its triangles are of too different sizes or shapes";
  }
  text << ": the field of " << eigenpairs.Number << " of " << field.Components.size()
       << " connected components has not converged, the residual is " << eigenpairs.WorstResidual
       << ", not " << required << '.';
  return text.str();
}
}

std::string DescribeRepairs(const Repairs& repaired)
{
  const std::string repairs = Describe(repaired);
  return repairs.empty() ? repairs
                         : "Check the mesh if this is unexpected, it was mended: " + repairs + ".";
}

std::vector<std::string> Warnings(const Result& field, const Options& options)
{
  std::vector<std::string> warnings = { DescribeRepairs(field.Repaired) };
  warnings.insert(warnings.end(), field.Notes.begin(), field.Notes.end());
  warnings.push_back(DescribeUnsolvedSystems(field, options));
  warnings.push_back(DescribeUnsolvedEigenvalues(field, options));
  warnings.erase(std::remove(warnings.begin(), warnings.end(), ""), warnings.end());
  return warnings;
}
}
