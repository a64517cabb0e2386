// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DistributedHierarchy_h
#define DistributedHierarchy_h

#include "Solver/PetscObjects.h"

#include <cstddef>
#include <vector>

namespace DirectionFields::Parallel
{
/// A hierarchy of ever smaller matrices whose rows lie on several processes, and a V-cycle that
/// nearly inverts A + shift M with it: PETSc's matrices and products, and the aggregation of
/// LinearAlgebra.
///
/// Each process aggregates its own vertices, so that aggregates need no messages; the prolongator
/// is smoothed by the whole matrix, across processes. The restriction is an explicit R = P^H, for
/// PETSc by itself would take P^T, and P^T A P loses the transport. Smoothing is by Chebyshev
/// polynomials in the matrix over its diagonal, which do not depend on how rows are distributed
/// over processes.
class DistributedHierarchy
{
public:
  struct Level
  {
    /// A and M; the matrices of the finest level are the caller's.
    Mat Energy = nullptr;
    Mat Mass = nullptr;
    OwnedMat OwnEnergy;
    OwnedMat OwnMass;
    /// Interpolates sections of the next coarser level, and the adjoint; null on the coarsest.
    OwnedMat Prolongator;
    OwnedMat Restriction;
    /// A + shift M, where shift is not 0.
    OwnedMat Shifted;
    OwnedKsp Solver;
    OwnedVec Right;
    OwnedVec Solution;
    OwnedVec Rest;

    Mat System() const { return this->Shifted ? static_cast<Mat>(this->Shifted) : this->Energy; }
  };

  /// All processes call it; throws std::runtime_error on all of them.
  /// @param energy, mass must outlive the hierarchy
  /// @param scale the order of magnitude of the smallest eigenvalue
  /// @param shift at least 0
  DistributedHierarchy(Mat energy, Mat mass, double scale, double shift = 0.0);

  const std::vector<Level>& GetLevels() const { return this->Levels; }
  std::size_t CountLevels() const { return this->Levels.size(); }
  double GetScale() const { return this->Scale; }
  /// Makes it a hierarchy for another shift, at least 0.
  void SetShift(double shift);
  /// solution = B right on a level, B nearly the inverse of A + shift M, Hermitian and positive
  /// definite. PETSc's option -log_view lists the cycles of the finest level as "V-cycle".
  void Apply(Vec right, Vec solution, std::size_t level = 0);
  /// How often Apply was called for the finest level.
  int GetCycles() const { return this->Cycles; }

private:
  bool Coarsen();
  void ApplyCycle(Vec right, Vec solution, std::size_t level);
  void MakeSolvers(double shift);
  void MakeSolver(std::size_t level, double shift);

  std::vector<Level> Levels;
  double Scale;
  double Shift = 0.0;
  int Cycles = 0;
};
}

#endif
