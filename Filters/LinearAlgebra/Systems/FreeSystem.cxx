// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Systems/FreeSystem.h"

#include "Support/Free.h"
#include "Systems/ConjugateGradients.h"

namespace DirectionFields::Internal
{
namespace
{
Operators PrincipalMatrices(const Operators& operators, const FreeVertices& free)
{
  Operators principal;
  principal.Energy = free.Principal(operators.Energy);
  principal.Mass = free.Principal(operators.Mass);
  return principal;
}
}

FreeSystem::FreeSystem(const Operators& operators, const std::vector<Index>& given, double scale)
  : Given(given)
  , Free(given, static_cast<Index>(operators.Energy.cols()))
  , Matrices(PrincipalMatrices(operators, this->Free))
  , Hierarchy(this->Matrices, scale, LeftOver::Drop)
{
}

SystemSolution MinimizeEnergyByMultigrid(const ShiftedSystem& system, FreeSystem& freeSystem,
  const ComplexVector& rightHandSide, const GivenValues& given)
{
  const ComplexVector u = freeSystem.Free.Scattered(given);
  SystemSolution solution;
  if (freeSystem.Free.IsEmpty())
  {
    solution.Vector = u;
    return solution;
  }
  const ComplexVector b = freeSystem.Free.Gathered(rightHandSide - system.Times(u));
  ShiftedSystem inner{ freeSystem.Matrices, system.EnergyFactor, system.MassFactor,
    system.Tolerance, system.Progress };
  const WorkLimit limit(
    freeSystem.Matrices.Energy, ShiftedSystem::DirectSolves, ShiftedSystem::DirectWork);
  inner.Limit = system.Limit ? &limit : nullptr;
  const SystemSolution free =
    ConjugateGradients(inner, freeSystem.Hierarchy, {}, b, freeSystem.Solved);
  solution.Residual = free.Residual;
  solution.Vector = freeSystem.Free.Joined(free.Vector, given);
  return solution;
}
}
