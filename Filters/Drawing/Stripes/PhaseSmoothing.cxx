// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Stripes/PhaseSmoothing.h"

#include "Matrices/VectorOperations.h"
#include "Multigrid/Hierarchy.h"
#include "Stripes/StripeMatrices.h"
#include "Systems/ConjugateGradients.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// The relative residual of the solved system: a hundredth of the correction is left undone.
constexpr double Tolerance = 1e-2;
/// Constants cost no energy; with this part of the smallest eigenvalue that an even surface of that
/// area has, the matrix is definite.
constexpr double ConstantsCost = 1e-6;

/// The wanted step along a half-edge less the step, -1/2 to 1/2.
double Lack(const WantedPhases& wanted, const std::vector<double>& phases, Index h)
{
  const WantedPhases::Step step = wanted.Along(h);
  const double atHead = phases[wanted.Node(wanted.GetMesh().Head(h))];
  const double atTail = phases[wanted.Node(wanted.GetMesh().Tail(h))];
  const double lack = step.Increment - ((step.Flips ? -atHead : atHead) - atTail);
  return lack - std::round(lack);
}

/// The derivatives of half of the sum by the phases, with their sign changed.
ComplexVector Downhill(const WantedPhases& wanted, const WantedPhases::Component& component,
  const SparseMatrix& weights, const std::vector<double>& phases)
{
  const TriangleMesh& mesh = wanted.GetMesh();
  const Index sheets = component.HasTwoSheets ? 2 : 1;
  ComplexVector downhill = Uninitialized(sheets * component.Nodes());
  ParallelFor(component.Nodes(), HeavyPiece,
    [&](Index begin, Index end)
    {
      std::vector<Index> fan;
      for (Index v = begin; v < end; ++v)
      {
        const Index vertex = wanted.Vertex(component.FirstNode + v);
        const Index* const rows = weights.innerIndexPtr() + weights.outerIndexPtr()[sheets * v];
        const Index* const last = weights.innerIndexPtr() + weights.outerIndexPtr()[sheets * v + 1];
        const auto weightOf = [&](Index other, bool flips)
        {
          const Index node = wanted.Node(other) - component.FirstNode;
          const Index row = sheets * node + (flips ? 1 : 0);
          return -weights.valuePtr()[std::lower_bound(rows, last, row) - weights.innerIndexPtr()]
                    .real();
        };
        mesh.GetFan(vertex, fan);
        double sum = 0.0;
        for (const Index h : fan)
        {
          sum -= weightOf(mesh.Head(h), wanted.Along(h).Flips) * Lack(wanted, phases, h);
        }
        if (mesh.IsBoundary(vertex))
        {
          // The last edge has no half-edge but the one that comes in.
          const Index in = TriangleMesh::Previous(fan.back());
          const double lack = Lack(wanted, phases, in);
          const bool flips = wanted.Along(in).Flips;
          sum -= weightOf(mesh.Tail(in), flips) * (flips ? lack : -lack);
        }
        downhill[sheets * v] = sum;
        if (sheets == 2)
        {
          downhill[2 * v + 1] = -sum;
        }
      }
    });
  return downhill;
}
}

void SmoothPhases(const WantedPhases& wanted, const WantedPhases::Component& component,
  const Progress& progress, std::vector<double>& phases)
{
  const Operators matrices = AssembleStripeMatrices(wanted, component, false);
  const double scale =
    2.0 * Pi / wanted.GetField().GetGeometry().Lengths.ComponentArea[component.Number];
  const Hierarchy hierarchy(matrices, scale, LeftOver::Drop);
  const ComplexVector right = Downhill(wanted, component, matrices.Energy, phases);
  progress.Report(0.5);
  const ShiftedSystem system{ matrices, 1.0, ConstantsCost * scale, Tolerance, progress };
  ReducedBasis solved;
  const SystemSolution solution = ConjugateGradients(system, hierarchy, {}, right, solved);
  const Index sheets = component.HasTwoSheets ? 2 : 1;
  for (Index v = 0; v < component.Nodes(); ++v)
  {
    const double turn = sheets == 1
      ? solution.Vector[v].real()
      : 0.5 * (solution.Vector[2 * v] - solution.Vector[2 * v + 1]).real();
    double& phase = phases[component.FirstNode + v];
    phase += std::isfinite(turn) ? turn : 0.0;
    phase -= std::floor(phase);
  }
}
}
