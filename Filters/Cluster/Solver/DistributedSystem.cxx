// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Solver/DistributedSystem.h"

#include "Eigenpairs/Eigenpair.h"
#include "Progress.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace DirectionFields::Parallel
{
namespace
{
/// The most steps of conjugate gradients.
constexpr PetscInt MostSteps = 500;

/// The data of PETSc's callbacks.
struct Context
{
  DistributedHierarchy& Hierarchy;
  const std::function<bool(double)>& GoOn;
  /// The residual that is small enough.
  double Enough = 0.0;
  bool IsStopped = false;
};

PetscErrorCode ApplyCycle(PC preconditioner, Vec right, Vec solution)
{
  void* data = nullptr;
  PCShellGetContext(preconditioner, &data);
  try
  {
    static_cast<Context*>(data)->Hierarchy.Apply(right, solution);
  }
  catch (const std::exception&)
  {
    return PETSC_ERR_LIB;
  }
  return NoError;
}

PetscErrorCode HasConverged(
  KSP, PetscInt step, PetscReal residual, KSPConvergedReason* reason, void* data)
{
  auto* const context = static_cast<Context*>(data);
  *reason = KSP_CONVERGED_ITERATING;
  if (context->GoOn && !context->GoOn(FractionDone(static_cast<int>(step))))
  {
    context->IsStopped = true;
    *reason = KSP_DIVERGED_ITS;
  }
  else if (!std::isfinite(residual))
  {
    *reason = KSP_DIVERGED_NANORINF;
  }
  else if (residual <= context->Enough)
  {
    *reason = KSP_CONVERGED_RTOL;
  }
  return NoError;
}

OwnedVec NewVector(Mat matrix)
{
  OwnedVec vector;
  Require(MatCreateVecs(matrix, vector.New(), nullptr));
  return vector;
}

/// Sets each own row's value.
template <typename Value>
void Fill(Vec vector, std::size_t rows, const Value& value)
{
  PetscScalar* values = nullptr;
  Require(VecGetArray(vector, &values));
  for (std::size_t k = 0; k < rows; ++k)
  {
    values[k] = value(k, values[k]);
  }
  Require(VecRestoreArray(vector, &values));
}

/// Energy A + Mass M
OwnedMat Combined(Mat energy, Mat mass, const SystemFactors& factors)
{
  OwnedMat matrix;
  Require(MatDuplicate(energy, MAT_COPY_VALUES, matrix.New()));
  Require(MatScale(matrix, factors.Energy));
  Require(MatAXPY(matrix, factors.Mass, mass, SAME_NONZERO_PATTERN));
  return matrix;
}

/// Solves K u = b by conjugate gradients.
/// @param hierarchy null where the matrix is a mass matrix, which its diagonal is near enough to
DistributedSystem::Solution SolveByGradients(Mat matrix, Vec right, double tolerance,
  DistributedHierarchy* hierarchy, DistributedHierarchy& any,
  const std::function<bool(double)>& goOn)
{
  DistributedSystem::Solution solution;
  solution.Vector = NewVector(matrix);
  PetscReal size = 0.0;
  Require(VecNorm(right, NORM_2, &size));
  if (size == 0.0)
  {
    return solution;
  }
  OwnedKsp solver;
  Context context{ hierarchy ? *hierarchy : any, goOn, tolerance * size };
  Require(KSPCreate(PetscObjectComm(reinterpret_cast<PetscObject>(matrix)), solver.New()));
  Require(KSPSetOperators(solver, matrix, matrix));
  Require(KSPSetType(solver, KSPCG));
  Require(KSPSetNormType(solver, KSP_NORM_UNPRECONDITIONED));
  Require(KSPSetTolerances(solver, tolerance, 0.0, PETSC_DEFAULT, MostSteps));
  Require(KSPSetConvergenceTest(solver, HasConverged, &context, nullptr));
  PC preconditioner = nullptr;
  Require(KSPGetPC(solver, &preconditioner));
  if (hierarchy)
  {
    Require(PCSetType(preconditioner, PCSHELL));
    Require(PCShellSetContext(preconditioner, &context));
    Require(PCShellSetApply(preconditioner, ApplyCycle));
  }
  else
  {
    Require(PCSetType(preconditioner, PCJACOBI));
  }
  const PetscErrorCode code = KSPSolve(solver, right, solution.Vector);
  KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
  PetscReal residual = 0.0;
  Require(KSPGetConvergedReason(solver, &reason));
  Require(KSPGetResidualNorm(solver, &residual));
  Require(code);
  if (context.IsStopped)
  {
    throw Stopped();
  }
  solution.Residual = residual / size;
  solution.Indefinite =
    reason == KSP_DIVERGED_INDEFINITE_MAT || reason == KSP_DIVERGED_INDEFINITE_PC;
  return solution;
}

/// The shift of a hierarchy that nearly inverts a multiple of Energy A + Mass M.
double ShiftFor(const SystemFactors& factors)
{
  return factors.Energy > 0.0 ? std::max(0.0, factors.Mass / factors.Energy) : 0.0;
}
}

DistributedSystem::DistributedSystem(const Messages& messages, const DistributedMesh& mesh,
  const DistributedMatrices& matrices, const DistributedGuide& guide)
  : Matrices(matrices)
{
  messages.Together(
    [&]
    {
      this->IsGiven.assign(matrices.Vertices.size(), 0);
      this->IsNearGiven.assign(matrices.Vertices.size(), 0);
    });
  if (guide.IsConstrained)
  {
    this->GivenValues = NewVector(matrices.Energy);
    double given = 0.0;
    std::vector<Index> fan;
    const TriangleMesh& triangles = mesh.GetMesh();
    const auto isGiven = [&](Index v) { return guide.Kind[v] != ConstraintKind::None; };
    const auto readRow = [&](std::size_t k, const PetscScalar&)
    {
      const Index v = matrices.Vertices[k];
      this->IsGiven[k] = isGiven(v) ? 1 : 0;
      triangles.GetFan(v, fan);
      bool isNear = isGiven(v);
      for (const Index h : fan)
      {
        isNear = isNear || isGiven(triangles.Head(h)) ||
          isGiven(triangles.Tail(TriangleMesh::Previous(h)));
      }
      this->IsNearGiven[k] = isNear ? 1 : 0;
      given += isGiven(v) ? 1.0 : 0.0;
      return isGiven(v) ? PetscScalar(guide.Value[v]) : PetscScalar(0.0);
    };
    messages.Together([&] { Fill(this->GivenValues, matrices.Vertices.size(), readRow); });
    this->Given = static_cast<Index>(messages.Sum(given));
    this->IsConstrained = this->Given > 0;
  }
  if (guide.IsDrawn)
  {
    this->MakeGuidance(messages, guide.Drawn);
  }
}

void DistributedSystem::MakeGuidance(const Messages& messages, const std::vector<Complex>& drawn)
{
  const std::vector<Index>& vertices = this->Matrices.Vertices;
  const OwnedVec diagonal = NewVector(this->Matrices.Mass);
  Require(MatGetDiagonal(this->Matrices.Mass, diagonal));
  // Areas are 0 where the guidance does not count.
  std::vector<double> areas;
  messages.Together([&] { areas.resize(vertices.size()); });
  double largest = 0.0;
  Fill(diagonal, vertices.size(),
    [&](std::size_t k, const PetscScalar& value)
    {
      areas[k] = this->IsNearGiven[k] ? 0.0 : 2.0 * PetscRealPart(value);
      const Complex& q = drawn[vertices[k]];
      if (areas[k] > 0.0)
      {
        largest = std::max({ largest, std::abs(q.real()), std::abs(q.imag()) });
      }
      return value;
    });
  largest = messages.Largest(largest);
  if (!(largest > 0.0))
  {
    return;
  }
  // Squares of tiny guidance underflow.
  double sums[2] = { 0.0, 0.0 };
  for (std::size_t k = 0; k < vertices.size(); ++k)
  {
    const Complex& q = drawn[vertices[k]];
    sums[0] += areas[k];
    sums[1] += areas[k] * std::norm(Complex(q.real() / largest, q.imag() / largest));
  }
  messages.Sum(sums, 2);
  const double factor = std::sqrt(sums[0] / sums[1]);
  const OwnedVec scaled = NewVector(this->Matrices.Mass);
  Fill(scaled, vertices.size(),
    [&](std::size_t k, const PetscScalar&)
    {
      const Complex& q = drawn[vertices[k]];
      return PetscScalar(factor * q.real() / largest, factor * q.imag() / largest);
    });
  this->MassTimes = NewVector(this->Matrices.Mass);
  Require(MatMult(this->Matrices.Mass, scaled, this->MassTimes));
  this->IsGuided = true;
}

void DistributedSystem::TurnToGuidance(Vec u) const
{
  if (!this->IsGuided)
  {
    return;
  }
  PetscScalar overlap = 0.0;
  Require(VecDot(this->MassTimes, u, &overlap));
  const double size = std::abs(overlap);
  if (size > 0.0)
  {
    Require(VecScale(u, overlap / size));
  }
}

DistributedSystem::Solution DistributedSystem::Solve(const SystemFactors& factors, double tolerance,
  DistributedHierarchy& hierarchy, const std::function<bool(double)>& goOn) const
{
  const OwnedVec right = NewVector(this->Matrices.Energy);
  if (this->IsGuided)
  {
    Require(VecCopy(this->MassTimes, right));
    Fill(right, this->IsNearGiven.size(),
      [&](std::size_t k, const PetscScalar& value)
      { return this->IsNearGiven[k] ? PetscScalar(0.0) : factors.Guidance * value; });
  }
  const OwnedMat matrix = Combined(this->Matrices.Energy, this->Matrices.Mass, factors);
  if (this->IsConstrained)
  {
    return this->SolveFree(matrix, right, factors, tolerance, hierarchy.GetScale(), goOn);
  }
  hierarchy.SetShift(ShiftFor(factors));
  return SolveByGradients(
    matrix, right, tolerance, factors.Energy > 0.0 ? &hierarchy : nullptr, hierarchy, goOn);
}

DistributedSystem::Solution DistributedSystem::SolveFree(Mat matrix, Vec right,
  const SystemFactors& factors, double tolerance, double scale,
  const std::function<bool(double)>& goOn) const
{
  MPI_Comm communicator = PetscObjectComm(reinterpret_cast<PetscObject>(matrix));
  std::vector<PetscInt> free;
  DoOnAll(communicator,
    [&]
    {
      for (std::size_t k = 0; k < this->IsGiven.size(); ++k)
      {
        if (!this->IsGiven[k])
        {
          free.push_back(this->Matrices.FirstRow + static_cast<PetscInt>(k));
        }
      }
    });
  OwnedIndices rows;
  Require(ISCreateGeneral(
    communicator, static_cast<PetscInt>(free.size()), free.data(), PETSC_COPY_VALUES, rows.New()));
  // b - K g at the free vertices
  const OwnedVec product = NewVector(matrix);
  Require(MatMult(matrix, this->GivenValues, product));
  Require(VecAXPY(right, -1.0, product));
  OwnedMat freeMatrix;
  OwnedMat freeEnergy;
  OwnedMat freeMass;
  for (const auto& [whole, part] : { std::pair<Mat, OwnedMat*>{ matrix, &freeMatrix },
         { this->Matrices.Energy, &freeEnergy }, { this->Matrices.Mass, &freeMass } })
  {
    Require(MatCreateSubMatrix(whole, rows, rows, MAT_INITIAL_MATRIX, part->New()));
  }
  Solution solution;
  solution.Vector = NewVector(matrix);
  Require(VecCopy(this->GivenValues, solution.Vector));
  PetscInt count = 0;
  Require(ISGetSize(rows, &count));
  if (count == 0)
  {
    return solution;
  }
  OwnedScatter scatter;
  const OwnedVec freeRight = NewVector(freeMatrix);
  Require(VecScatterCreate(right, rows, freeRight, nullptr, scatter.New()));
  Require(VecScatterBegin(scatter, right, freeRight, INSERT_VALUES, SCATTER_FORWARD));
  Require(VecScatterEnd(scatter, right, freeRight, INSERT_VALUES, SCATTER_FORWARD));
  DistributedHierarchy hierarchy(freeEnergy, freeMass, scale, ShiftFor(factors));
  const Solution inner = SolveByGradients(
    freeMatrix, freeRight, tolerance, factors.Energy > 0.0 ? &hierarchy : nullptr, hierarchy, goOn);
  Require(VecScatterBegin(scatter, inner.Vector, solution.Vector, INSERT_VALUES, SCATTER_REVERSE));
  Require(VecScatterEnd(scatter, inner.Vector, solution.Vector, INSERT_VALUES, SCATTER_REVERSE));
  solution.Residual = inner.Residual;
  solution.Indefinite = inner.Indefinite;
  return solution;
}
}
