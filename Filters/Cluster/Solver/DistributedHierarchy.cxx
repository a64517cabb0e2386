// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Solver/DistributedHierarchy.h"

#include "Solver/TransportAggregation.h"

#include <utility>

namespace DirectionFields::Parallel
{
namespace
{
/// The coarsest level has no more rows than this, where coarsening goes on to its end; each process
/// has its factor.
constexpr PetscInt CoarsestRows = 600;
/// Coarsening ends where a level would have more than this part of the rows of the finer one.
constexpr double SlowestCoarsening = 0.7;
/// A coarsest level of more rows than this has one factor over all processes.
constexpr PetscInt MostRowsOfEach = 6000;
/// The degree of the polynomials, and the part of the largest eigenvalue from which on they damp.
constexpr PetscInt SmoothingSteps = 2;
constexpr double SmoothingFrom = 0.15;
constexpr double SmoothingTo = 1.1;
/// Added to the coarsest energy, relative to the scale of its smallest eigenvalue: that may be 0.
constexpr double AddedShift = 0.01;

PetscInt RowsOf(Mat matrix)
{
  PetscInt rows = 0;
  Require(MatGetSize(matrix, &rows, nullptr));
  return rows;
}

/// R (A P)
void MakeGalerkin(Mat restriction, Mat matrix, Mat prolongator, OwnedMat& coarse)
{
  OwnedMat product;
  Require(MatMatMult(matrix, prolongator, MAT_INITIAL_MATRIX, PETSC_DEFAULT, product.New()));
  Require(MatMatMult(restriction, product, MAT_INITIAL_MATRIX, PETSC_DEFAULT, coarse.New()));
}
}

DistributedHierarchy::DistributedHierarchy(Mat energy, Mat mass, double scale, double shift)
  : Scale(scale)
{
  this->Levels.emplace_back();
  this->Levels.back().Energy = energy;
  this->Levels.back().Mass = mass;
  while (RowsOf(this->Levels.back().Energy) > CoarsestRows && this->Coarsen())
  {
  }
  this->MakeSolvers(shift);
}

void DistributedHierarchy::SetShift(double shift)
{
  if (shift != this->Shift)
  {
    this->MakeSolvers(shift);
  }
}

void DistributedHierarchy::MakeSolvers(double shift)
{
  this->Shift = shift;
  for (std::size_t l = 0; l < this->Levels.size(); ++l)
  {
    this->MakeSolver(l, l + 1 < this->Levels.size() ? shift : shift + AddedShift * this->Scale);
  }
}

bool DistributedHierarchy::Coarsen()
{
  Level& fine = this->Levels.back();
  OwnedMat prolongator =
    MakeProlongator(fine.Energy, fine.Mass, static_cast<int>(this->Levels.size()) - 1);
  PetscInt coarseRows = 0;
  Require(MatGetSize(prolongator, nullptr, &coarseRows));
  if (coarseRows > SlowestCoarsening * RowsOf(fine.Energy) || coarseRows < 1)
  {
    return false;
  }
  fine.Prolongator = std::move(prolongator);
  Require(MatHermitianTranspose(fine.Prolongator, MAT_INITIAL_MATRIX, fine.Restriction.New()));
  Level coarse;
  MakeGalerkin(fine.Restriction, fine.Energy, fine.Prolongator, coarse.OwnEnergy);
  MakeGalerkin(fine.Restriction, fine.Mass, fine.Prolongator, coarse.OwnMass);
  coarse.Energy = coarse.OwnEnergy;
  coarse.Mass = coarse.OwnMass;
  this->Levels.push_back(std::move(coarse));
  return true;
}

void DistributedHierarchy::MakeSolver(std::size_t l, double shift)
{
  Level& level = this->Levels[l];
  level.Shifted = OwnedMat();
  if (shift > 0.0)
  {
    Require(MatDuplicate(level.Energy, MAT_COPY_VALUES, level.Shifted.New()));
    Require(MatAXPY(level.Shifted, shift, level.Mass, SAME_NONZERO_PATTERN));
  }
  Require(MatCreateVecs(level.Energy, level.Right.New(), level.Solution.New()));
  Require(VecDuplicate(level.Right, level.Rest.New()));
  Require(
    KSPCreate(PetscObjectComm(reinterpret_cast<PetscObject>(level.Energy)), level.Solver.New()));
  Require(KSPSetOperators(level.Solver, level.System(), level.System()));
  Require(KSPSetErrorIfNotConverged(level.Solver, PETSC_FALSE));
  PC preconditioner = nullptr;
  Require(KSPGetPC(level.Solver, &preconditioner));
  if (l + 1 == this->Levels.size())
  {
    Require(KSPSetType(level.Solver, KSPPREONLY));
    if (RowsOf(level.Energy) <= MostRowsOfEach)
    {
      Require(PCSetType(preconditioner, PCREDUNDANT));
    }
    else
    {
      Require(PCSetType(preconditioner, PCLU));
      Require(PCFactorSetMatSolverType(preconditioner, MATSOLVERMUMPS));
    }
  }
  else
  {
    Require(KSPSetType(level.Solver, KSPCHEBYSHEV));
    Require(KSPChebyshevEstEigSet(level.Solver, 0.0, SmoothingFrom, 0.0, SmoothingTo));
    Require(KSPSetNormType(level.Solver, KSP_NORM_NONE));
    Require(KSPSetConvergenceTest(level.Solver, KSPConvergedSkip, nullptr, nullptr));
    Require(
      KSPSetTolerances(level.Solver, PETSC_DEFAULT, PETSC_DEFAULT, PETSC_DEFAULT, SmoothingSteps));
    Require(PCSetType(preconditioner, PCJACOBI));
  }
  Require(KSPSetUp(level.Solver));
}

void DistributedHierarchy::Apply(Vec right, Vec solution, std::size_t l)
{
  if (l > 0)
  {
    this->ApplyCycle(right, solution, l);
    return;
  }
  static const PetscLogEvent event = []
  {
    PetscLogEvent number = 0;
    Require(PetscLogEventRegister("V-cycle", KSP_CLASSID, &number));
    return number;
  }();
  ++this->Cycles;
  Require(PetscLogEventBegin(event, 0, 0, 0, 0));
  this->ApplyCycle(right, solution, 0);
  Require(PetscLogEventEnd(event, 0, 0, 0, 0));
}

void DistributedHierarchy::ApplyCycle(Vec right, Vec solution, std::size_t l)
{
  Level& level = this->Levels[l];
  Require(KSPSetInitialGuessNonzero(level.Solver, PETSC_FALSE));
  Require(KSPSolve(level.Solver, right, solution));
  if (l + 1 == this->Levels.size())
  {
    return;
  }
  Level& coarser = this->Levels[l + 1];
  Require(MatMult(level.System(), solution, level.Rest));
  Require(VecAYPX(level.Rest, -1.0, right));
  Require(MatMult(level.Restriction, level.Rest, coarser.Right));
  this->ApplyCycle(coarser.Right, coarser.Solution, l + 1);
  Require(MatMultAdd(level.Prolongator, coarser.Solution, solution, solution));
  Require(KSPSetInitialGuessNonzero(level.Solver, PETSC_TRUE));
  Require(KSPSolve(level.Solver, right, solution));
}
}
