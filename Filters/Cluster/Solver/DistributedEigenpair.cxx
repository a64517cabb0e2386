// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Solver/DistributedEigenpair.h"

#include "Eigenpairs/Eigenpair.h"
#include "Eigenpairs/RayleighRitz.h"
#include "Progress.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace DirectionFields::Parallel
{
namespace
{
/// The sections that go from level to level.
constexpr PetscInt Width = 4;
/// The vectors of the space on the finest level, and how many it keeps when it begins anew.
constexpr int LargestSpace = 9;
constexpr int KeptVectors = 4;
/// Steps on the coarsest level, from any sections, and on the levels between.
constexpr int CoarsestSteps = 12;
constexpr int StepsBetween = 2;
/// The iteration has stalled where this many cycles in a row have gained nothing.
constexpr int MostSlowCycles = 100;
/// As for one process: the residual that tells the smallest pair from others.
constexpr double TellingResidual = 1e-5;
/// Eigenvalues that differ by less than this part are the same one, repeated; those that differ by
/// more than the second part are not. In between as many steps towards the second pair tell.
constexpr double SameValue = 1e-4;
constexpr double OtherValue = 0.1;
constexpr int StepsToSecond = 8;

/// ‖|A| |u|‖
double SumOfMagnitudes(Mat matrix, Vec u)
{
  OwnedVec magnitudes;
  OwnedVec product;
  OwnedMat moduli;
  Require(VecDuplicate(u, magnitudes.New()));
  Require(VecDuplicate(u, product.New()));
  Require(VecCopy(u, magnitudes));
  Require(VecAbs(magnitudes));
  PetscInt first = 0;
  PetscInt end = 0;
  Require(MatGetOwnershipRange(matrix, &first, &end));
  // An upper bound that needs no copy of the matrix: |A| |u| with the largest |u| of all.
  PetscReal largest = 0.0;
  Require(VecMax(magnitudes, nullptr, &largest));
  PetscScalar* sums = nullptr;
  Require(VecGetArray(product, &sums));
  for (PetscInt row = first; row < end; ++row)
  {
    PetscInt count = 0;
    const PetscScalar* values = nullptr;
    Require(MatGetRow(matrix, row, &count, nullptr, &values));
    double sum = 0.0;
    for (PetscInt k = 0; k < count; ++k)
    {
      sum += std::abs(values[k]);
    }
    sums[row - first] = sum * largest;
    Require(MatRestoreRow(matrix, row, &count, nullptr, &values));
  }
  Require(VecRestoreArray(product, &sums));
  PetscReal norm = 0.0;
  Require(VecNorm(product, NORM_2, &norm));
  return norm;
}

using Vectors = std::vector<OwnedVec>;

OwnedVec NewVector(Mat matrix)
{
  OwnedVec vector;
  Require(MatCreateVecs(matrix, vector.New(), nullptr));
  return vector;
}

/// The smallest Ritz pairs of the space of some sections, which they become.
/// @return the values
Eigen::VectorXd ReplaceByRitzPairs(
  const DistributedHierarchy::Level& level, PetscInt wanted, Vectors& vectors)
{
  const auto count = static_cast<PetscInt>(vectors.size());
  std::vector<Vec> all(vectors.begin(), vectors.end());
  SmallMatrix projected[2] = { SmallMatrix(count, count), SmallMatrix(count, count) };
  const OwnedVec product = NewVector(level.Energy);
  for (PetscInt column = 0; column < count; ++column)
  {
    for (int which = 0; which < 2; ++which)
    {
      Require(MatMult(which == 0 ? level.Energy : level.Mass, all[column], product));
      Require(VecMDot(product, count, all.data(), projected[which].col(column).data()));
    }
  }
  const RitzPairs ritz = RayleighRitz(projected[0], projected[1], wanted);
  Vectors pairs;
  for (Eigen::Index k = 0; k < ritz.Values.size(); ++k)
  {
    pairs.push_back(NewVector(level.Energy));
    const Eigen::VectorXcd coefficients = ritz.Vectors.col(k);
    Require(VecZeroEntries(pairs.back()));
    Require(VecMAXPY(pairs.back(), count, coefficients.data(), all.data()));
  }
  vectors = std::move(pairs);
  return ritz.Values;
}

/// Steps towards the smallest pairs of a level: the cycle is applied to the residuals, and the Ritz
/// pairs of the results and of the pairs so far are taken.
void Refine(DistributedHierarchy& hierarchy, std::size_t l, int steps, Vectors& vectors)
{
  const DistributedHierarchy::Level& level = hierarchy.GetLevels()[l];
  Eigen::VectorXd values = ReplaceByRitzPairs(level, Width, vectors);
  const OwnedVec residual = NewVector(level.Energy);
  const OwnedVec mass = NewVector(level.Energy);
  for (int step = 0; step < steps; ++step)
  {
    const std::size_t count = vectors.size();
    for (std::size_t k = 0; k < count; ++k)
    {
      Require(MatMult(level.Energy, vectors[k], residual));
      Require(MatMult(level.Mass, vectors[k], mass));
      Require(VecAXPY(residual, -values[static_cast<Eigen::Index>(k)], mass));
      vectors.push_back(NewVector(level.Energy));
      hierarchy.Apply(residual, vectors.back(), l);
    }
    values = ReplaceByRitzPairs(level, Width, vectors);
  }
}

/// Sections of the coarsest level, as good as any.
Vectors AnySections(const DistributedHierarchy::Level& level)
{
  PetscInt rows = 0;
  Require(MatGetSize(level.Energy, &rows, nullptr));
  // One generator for all: PETSc's own begins anew with each vector, which would be the same one.
  OwnedRandom random;
  Require(PetscRandomCreate(
    PetscObjectComm(reinterpret_cast<PetscObject>(Mat(level.Energy))), random.New()));
  Require(PetscRandomSetType(random, PETSCRAND48));
  Vectors vectors;
  for (PetscInt k = 0; k < std::min(2 * Width, rows); ++k)
  {
    vectors.push_back(NewVector(level.Energy));
    Require(VecSetRandom(vectors.back(), random));
  }
  return vectors;
}

/// Approximations of the smallest pairs' sections on the finest level.
Vectors IterateNested(DistributedHierarchy& hierarchy)
{
  std::size_t l = hierarchy.CountLevels() - 1;
  Vectors vectors = AnySections(hierarchy.GetLevels()[l]);
  Refine(hierarchy, l, CoarsestSteps, vectors);
  while (l-- > 0)
  {
    const DistributedHierarchy::Level& level = hierarchy.GetLevels()[l];
    Vectors finer;
    for (const OwnedVec& coarse : vectors)
    {
      finer.push_back(NewVector(level.Energy));
      Require(MatMult(level.Prolongator, coarse, finer.back()));
    }
    vectors = std::move(finer);
    if (l > 0)
    {
      Refine(hierarchy, l, StepsBetween, vectors);
    }
  }
  return vectors;
}

/// Scales u to u^* M u = 1 and measures its pair.
void Measure(const DistributedMatrices& matrices, double terms, DistributedEigenpair& pair)
{
  const OwnedVec energy = NewVector(matrices.Energy);
  const OwnedVec mass = NewVector(matrices.Energy);
  Require(MatMult(matrices.Mass, pair.Vector, mass));
  PetscScalar size = 0.0;
  Require(VecDot(mass, pair.Vector, &size));
  const double perLength = 1.0 / std::sqrt(PetscRealPart(size));
  Require(VecScale(pair.Vector, perLength));
  Require(VecScale(mass, perLength));
  Require(MatMult(matrices.Energy, pair.Vector, energy));
  PetscScalar value = 0.0;
  Require(VecDot(energy, pair.Vector, &value));
  // A is positive semi-definite: a value below zero is rounding.
  pair.Value = std::max(0.0, PetscRealPart(value));
  PetscReal energyNorm = 0.0;
  PetscReal residual = 0.0;
  Require(VecNorm(energy, NORM_2, &energyNorm));
  Require(VecAXPY(energy, -pair.Value, mass));
  Require(VecNorm(energy, NORM_2, &residual));
  pair.Residual = RelativeResidual(residual, energyNorm, terms);
}

/// A space of sections with their products, orthonormal in M up to rounding.
class ProductSpace
{
public:
  explicit ProductSpace(const DistributedHierarchy::Level& level)
    : Level(level)
  {
  }

  int Size() const { return static_cast<int>(this->Sections.size()); }

  /// Adds the part of a section that is not in the space.
  void Add(OwnedVec section)
  {
    const int count = this->Size();
    if (count > 0)
    {
      Eigen::VectorXcd parts(count);
      const std::vector<Vec> masses(this->MassTimes.begin(), this->MassTimes.end());
      Require(VecMDot(section, count, masses.data(), parts.data()));
      parts = -parts;
      const std::vector<Vec> all(this->Sections.begin(), this->Sections.end());
      Require(VecMAXPY(section, count, parts.data(), const_cast<Vec*>(all.data())));
    }
    OwnedVec energy = NewVector(this->Level.Energy);
    OwnedVec mass = NewVector(this->Level.Energy);
    Require(MatMult(this->Level.Mass, section, mass));
    PetscScalar square = 0.0;
    Require(VecDot(mass, section, &square));
    const double length = std::sqrt(std::max(0.0, PetscRealPart(square)));
    if (!(length > 0.0))
    {
      return;
    }
    Require(VecScale(section, 1.0 / length));
    Require(VecScale(mass, 1.0 / length));
    Require(MatMult(this->Level.Energy, section, energy));
    this->Sections.push_back(std::move(section));
    this->EnergyTimes.push_back(std::move(energy));
    this->MassTimes.push_back(std::move(mass));
    this->Extend();
  }

  RitzPairs Ritz(int wanted) const { return RayleighRitz(this->Energy, this->Mass, wanted); }

  OwnedVec Section(const Eigen::VectorXcd& coefficients) const
  {
    return this->Combined(this->Sections, coefficients);
  }

  /// A u - value M u
  OwnedVec Residual(const Eigen::VectorXcd& coefficients, double value) const
  {
    OwnedVec residual = this->Combined(this->EnergyTimes, coefficients);
    const OwnedVec mass = this->Combined(this->MassTimes, coefficients);
    Require(VecAXPY(residual, -value, mass));
    return residual;
  }

  /// Leaves the space of some Ritz vectors.
  void Keep(const RitzPairs& ritz)
  {
    Vectors kept[3];
    const Vectors* const all[3] = { &this->Sections, &this->EnergyTimes, &this->MassTimes };
    for (int which = 0; which < 3; ++which)
    {
      for (Eigen::Index k = 0; k < ritz.Values.size(); ++k)
      {
        kept[which].push_back(this->Combined(*all[which], ritz.Vectors.col(k)));
      }
    }
    this->Sections = std::move(kept[0]);
    this->EnergyTimes = std::move(kept[1]);
    this->MassTimes = std::move(kept[2]);
    this->Energy = ritz.Values.cast<Complex>().asDiagonal();
    this->Mass = SmallMatrix::Identity(ritz.Values.size(), ritz.Values.size());
  }

private:
  /// Fills in the last row and column of both projected matrices.
  void Extend()
  {
    const int count = this->Size();
    const std::vector<Vec> all(this->Sections.begin(), this->Sections.end());
    const std::pair<SmallMatrix*, const OwnedVec*> both[2] = {
      { &this->Energy, &this->EnergyTimes.back() }, { &this->Mass, &this->MassTimes.back() }
    };
    for (const auto& [projected, product] : both)
    {
      Eigen::VectorXcd column(count);
      Require(VecMDot(*product, count, all.data(), column.data()));
      projected->conservativeResize(count, count);
      projected->col(count - 1) = column;
      projected->row(count - 1) = column.adjoint();
      (*projected)(count - 1, count - 1) = column[count - 1].real();
    }
  }

  OwnedVec Combined(const Vectors& vectors, const Eigen::VectorXcd& coefficients) const
  {
    OwnedVec sum = NewVector(this->Level.Energy);
    std::vector<Vec> all(vectors.begin(), vectors.end());
    Require(VecZeroEntries(sum));
    Require(VecMAXPY(sum, static_cast<PetscInt>(all.size()), coefficients.data(), all.data()));
    return sum;
  }

  const DistributedHierarchy::Level& Level;
  Vectors Sections;
  Vectors EnergyTimes;
  Vectors MassTimes;
  SmallMatrix Energy;
  SmallMatrix Mass;
};

/// Adds the correction of a Ritz pair to the space.
void Expand(DistributedHierarchy& hierarchy, int which, ProductSpace& space, RitzPairs& ritz)
{
  if (space.Size() >= LargestSpace)
  {
    space.Keep(ritz);
    ritz = space.Ritz(KeptVectors);
  }
  const OwnedVec residual = space.Residual(ritz.Vectors.col(which), ritz.Values[which]);
  OwnedVec correction;
  Require(VecDuplicate(residual, correction.New()));
  hierarchy.Apply(residual, correction);
  space.Add(std::move(correction));
  ritz = space.Ritz(KeptVectors);
}

/// Whether the smallest eigenvalue is repeated, where its pair has been found.
bool IsRepeated(DistributedHierarchy& hierarchy, double scale, ProductSpace& space, RitzPairs& ritz)
{
  for (int step = 0;; ++step)
  {
    if (ritz.Values.size() < 2)
    {
      return false;
    }
    // Eigenvalues near zero are told by the order of magnitude of those of other surfaces.
    const double part = (ritz.Values[1] - ritz.Values[0]) / std::max(ritz.Values[1], 1e-3 * scale);
    if (part <= SameValue || part > OtherValue || step == StepsToSecond)
    {
      return part <= SameValue;
    }
    Expand(hierarchy, 1, space, ritz);
  }
}
}

DistributedEigenpair FindSmallestPair(const DistributedMatrices& matrices,
  DistributedHierarchy& hierarchy, const DistributedSettings& settings)
{
  DistributedEigenpair pair;
  pair.RequiredResidual = std::min(settings.Tolerance, TellingResidual);
  const auto report = [&](int cycles)
  {
    if (settings.GoOn && !settings.GoOn(cycles < 0 ? 0.0 : FractionDone(cycles)))
    {
      throw Stopped();
    }
  };
  report(-1);
  ProductSpace space(hierarchy.GetLevels().front());
  for (OwnedVec& section : IterateNested(hierarchy))
  {
    space.Add(std::move(section));
  }
  RitzPairs ritz = space.Ritz(KeptVectors);
  double terms = 0.0;
  pair.Residual = std::numeric_limits<double>::infinity();
  for (int best = 0;;)
  {
    report(hierarchy.GetCycles());
    DistributedEigenpair next;
    next.Vector = space.Section(ritz.Vectors.col(0));
    terms = terms > 0.0 ? terms : SumOfMagnitudes(matrices.Energy, next.Vector);
    Measure(matrices, terms, next);
    if (next.Residual < pair.Residual)
    {
      best = hierarchy.GetCycles();
      pair.Vector = std::move(next.Vector);
      pair.Value = next.Value;
      pair.Residual = next.Residual;
    }
    pair.Iterations = hierarchy.GetCycles();
    if (pair.Residual <= pair.RequiredResidual || pair.Iterations >= settings.MaximumIterations ||
      pair.Iterations - best >= MostSlowCycles)
    {
      pair.IsRepeated = IsRepeated(hierarchy, settings.Scale, space, ritz);
      return pair;
    }
    Expand(hierarchy, 0, space, ritz);
  }
}
}
