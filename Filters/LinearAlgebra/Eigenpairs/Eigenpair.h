// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Eigenpair_h
#define DirectionFields_Eigenpair_h

#include "Matrices/OperatorProducts.h"
#include "Matrices/WorkLimit.h"
#include "Progress.h"
#include "Types.h"

namespace DirectionFields::Internal
{
/// Smallest eigenpair of A u = lambda M u, A Hermitian positive semi-definite, M Hermitian positive
/// definite.
struct Eigenpair
{
  double Value = 0.0;
  /// u^* M u = 1.
  ComplexVector Vector;
  /// RelativeResidual of the pair.
  double Residual = 0.0;
  /// Up to this residual the pair counts as the smallest one: the tolerance, or less where that
  /// would not tell it from the next ones.
  double RequiredResidual = 0.0;
  /// Solves with the factor, or V-cycles; 0 where the dense solver was used.
  int Iterations = 0;
};

struct EigenpairSettings
{
  /// Largest residual of a converged pair. No eigenvalue is below that of such a pair by more than
  /// this part of it and of NextToNothing: the direct solver proves it where a residual of this
  /// size does not tell.
  double Tolerance = 1e-6;
  /// The pair is returned as it is after this many solves.
  int MaximumIterations = 200;
  /// The order of magnitude of the smallest eigenvalue of a typical surface. A shift by a small
  /// part of it makes the matrix definite where the smallest eigenvalue is 0.
  double Scale = 1.0;
  /// Far enough from a smallest eigenvalue 0 for a factorization, too near to blur small
  /// eigenvalues that lie close together.
  double NextToNothing() const { return 1e-5 * this->Scale; }
  /// Ends the iteration where another solver takes less work; null for no limit.
  const WorkLimit* Limit = nullptr;
};

/// The part of the work, 0 to 1, that this number of solves is likely to be: convergence takes 10
/// to 20 of them as a rule, yet may take many more.
double FractionDone(int solves);

inline bool HasConverged(const Eigenpair& pair)
{
  return pair.Residual <= pair.RequiredResidual;
}

/// Counts the solves of an iteration and tells its caller how far it is.
class SolveCounter
{
public:
  explicit SolveCounter(const Progress& progress = {})
    : Caller(progress)
  {
  }
  int GetCount() const { return this->Count; }
  /// The work so far (see WorkLimit).
  double GetWork() const { return this->Work; }
  void Spend(double work) { this->Work += work; }
  /// Tells how far the iteration is. Throws Stopped.
  void Report() const { this->Caller.Report(FractionDone(this->Count)); }
  /// Is called before each solve. Throws Stopped.
  void Next()
  {
    this->Report();
    ++this->Count;
  }

private:
  Progress Caller;
  int Count = 0;
  double Work = 0.0;
};

/// ‖A u - lambda M u‖ / max(‖A u‖, 1e-7 ‖|A| |u|‖). The second norm takes over where lambda = 0 up
/// to rounding; there the residual is 0 if it is no more than rounding, 1e-14 ‖|A| |u|‖, itself.
/// @param residual, energy, terms the three norms
double RelativeResidual(double residual, double energy, double terms);
/// @param energy the matrix A
/// @param u      with its products
double RelativeResidual(const SparseMatrix& energy, const SectionProducts& u, double lambda);
}

#endif
