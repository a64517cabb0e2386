// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Eigenpairs/NestedIteration.h"

#include "Eigenpairs/RayleighRitz.h"
#include "Support/Free.h"
#include "Support/Threads.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
constexpr int Width = SectionBlock::Width;
/// A level is left once the relative residual of the smallest pair is below this: the
/// discretization of a coarser level is off by more.
constexpr float Tolerance = 0.2f;
/// A value below this part of the order of magnitude of the smallest eigenvalue counts as 0. The
/// residual of its section is rounding, along which no step may go.
constexpr double ZeroPart = 1e-3;
constexpr int MostSteps = 8;
constexpr int MostStepsOnCoarsest = 20;
/// On the finest level each step costs as much as five V-cycles of the one section that is wanted
/// in the end. There the steps end, too, once one has changed the smallest value by no more than a
/// part of it: FirstChange for the first step, which as a rule removes the error of interpolation,
/// then SettledChange.
constexpr int MostStepsOnFinest = 4;
constexpr double FirstChange = 0.25;
constexpr double SettledChange = 0.02;
/// The work of a step for each entry of its level (see WorkLimit).
constexpr double WorkPerEntry = 30.0;

/// Squared norms of A u - theta M u and of A u for one pair.
struct Norms
{
  double Residual = 0.0;
  double Energy = 0.0;
  Norms& operator+=(const Norms& other)
  {
    this->Residual += other.Residual;
    this->Energy += other.Energy;
    return *this;
  }
};

/// The block iteration of one level.
class BlockIteration
{
public:
  BlockIteration(
    const Operators* operators, const Hierarchy::Level& level, double scale, NestedPairs& pairs)
    : Finest(operators)
    , Zero(ZeroPart * scale)
    , Matrices(level.Matrices)
    , IsCoarsest(level.FromCoarser.Begin.empty())
    , Pairs(pairs)
    , Correction(level.Rows())
  {
    this->Multiply(pairs.Block);
    if (this->IsWhole())
    {
      // Ritz pairs of the coarser level are such on this one, since its matrices are projections.
      return;
    }
    const std::vector<SmallMatrix> products = InnerProducts(level.Rows(),
      { { &pairs.Block.Vectors, &pairs.Block.Energy },
        { &pairs.Block.Vectors, &pairs.Block.Mass } });
    this->Take(RayleighRitz(products[0], products[1], Width));
    if (this->IsWhole())
    {
      SetLinearCombination({ { &pairs.Block, this->Ritz.Vectors } }, pairs.Block);
    }
  }

  /// Whether all four pairs have been found.
  bool IsWhole() const { return this->Pairs.Values.size() == Width; }

  /// Puts the residuals A x - theta M x in Correction. Returns the relative size of the one whose
  /// theta is the smallest that is not 0; 0 where all four values are 0.
  float Residuals()
  {
    const SectionBlock& block = this->Pairs.Block;
    const int first = this->FirstNonzero();
    if (first == Width)
    {
      return 0.0f;
    }
    const Norms norms = ParallelSum<Norms>(block.Rows(), CompactMatrix::PieceRows, {},
      [&](Index begin, Index end)
      {
        Norms part;
        for (Index v = begin; v < end; ++v)
        {
          const CompactValues<Width> energy(block.Energy.data(), v);
          CompactValues<Width> rest = energy;
          const CompactValues<Width> mass(block.Mass.data(), v);
          for (int b = 0; b < Width; ++b)
          {
            const auto theta = static_cast<float>(this->Pairs.Values[b]);
            rest.Real[b] -= theta * mass.Real[b];
            rest.Imaginary[b] -= theta * mass.Imaginary[b];
          }
          part.Residual +=
            rest.Real[first] * rest.Real[first] + rest.Imaginary[first] * rest.Imaginary[first];
          part.Energy += energy.Real[first] * energy.Real[first] +
            energy.Imaginary[first] * energy.Imaginary[first];
          for (int b = 0; b < first; ++b)
          {
            rest.Real[b] = 0.0f;
            rest.Imaginary[b] = 0.0f;
          }
          rest.Store(this->Correction.Vectors.data(), v);
        }
        return part;
      });
    return static_cast<float>(std::sqrt(norms.Residual / norms.Energy));
  }

  /// One step with the residuals that Residuals left. Whether it is the last one.
  bool Step(const Cycle& cycle, std::size_t level, bool isLast)
  {
    SectionBlock& w = this->Correction;
    // The products of w have not been computed yet: their storage is free for the cycle's result.
    cycle.Apply<Width>(w.Vectors.data(), w.Mass.data(), level);
    w.Vectors.swap(w.Mass);
    this->Multiply(w);

    const bool searched = this->Search.Rows() > 0;
    const int first = this->FirstNonzero();
    const double before = this->Pairs.Values[first];
    this->FindRitzPairs();
    if (!this->IsWhole())
    {
      return true;
    }
    // Without a coarser level the first steps say nothing; and where the value rises, that
    // of the coarser level was rounding.
    const double after = this->Pairs.Values[first];
    isLast = isLast ||
      (level == 0 && !this->IsCoarsest &&
        std::abs(before - after) <= (searched ? SettledChange : FirstChange) * after);
    this->TakeRitzVectors(level > 0 || !isLast, isLast);
    return isLast;
  }

private:
  /// The Ritz pairs of the space of the sections X, the corrections W and the last step S.
  void FindRitzPairs()
  {
    const SectionBlock& x = this->Pairs.Block;
    const SectionBlock& w = this->Correction;
    const SectionBlock& s = this->Search;
    const bool searched = s.Rows() > 0;
    std::vector<std::pair<const CompactSections*, const CompactSections*>> pairs = {
      { &x.Vectors, &w.Energy },
      { &x.Vectors, &w.Mass },
      { &w.Vectors, &w.Energy },
      { &w.Vectors, &w.Mass },
    };
    if (searched)
    {
      for (const CompactSections* other : { &x.Vectors, &w.Vectors, &s.Vectors })
      {
        pairs.emplace_back(other, &s.Energy);
        pairs.emplace_back(other, &s.Mass);
      }
    }
    const std::vector<SmallMatrix> products = InnerProducts(x.Rows(), pairs);
    const int parts = searched ? 3 : 2;
    SmallMatrix energy(parts * Width, parts * Width);
    SmallMatrix mass(parts * Width, parts * Width);
    const auto set = [&](int i, int j, const SmallMatrix& a, const SmallMatrix& m)
    {
      energy.block(i * Width, j * Width, Width, Width) = a;
      energy.block(j * Width, i * Width, Width, Width) = a.adjoint();
      mass.block(i * Width, j * Width, Width, Width) = m;
      mass.block(j * Width, i * Width, Width, Width) = m.adjoint();
    };
    set(0, 0, SmallMatrix(this->Pairs.Values.cast<Complex>().asDiagonal()),
      SmallMatrix::Identity(Width, Width));
    set(0, 1, products[0], products[1]);
    set(1, 1, products[2], products[3]);
    for (int other = 0; searched && other < 3; ++other)
    {
      set(other, 2, products[4 + 2 * other], products[5 + 2 * other]);
    }
    this->Take(RayleighRitz(energy, mass, Width));
  }

  /// The sections become the Ritz vectors, and the last step the change of them.
  /// @param isLast no step follows that would need the last one
  void TakeRitzVectors(bool withMass, bool isLast)
  {
    SectionBlock& x = this->Pairs.Block;
    const SectionBlock& w = this->Correction;
    SectionBlock& s = this->Search;
    const bool searched = s.Rows() > 0;
    std::vector<std::pair<const SectionBlock*, SmallMatrix>> terms{
      { &x, SmallMatrix(this->Ritz.Vectors.topRows(Width)) }, { &w, this->OfCorrection() }
    };
    if (searched)
    {
      terms.emplace_back(&s, this->OfSearch());
    }
    SetLinearCombination(terms, x, withMass);
    if (isLast)
    {
      return;
    }
    if (searched)
    {
      SetLinearCombination({ { &w, this->OfCorrection() }, { &s, this->OfSearch() } }, s);
    }
    else
    {
      s = SectionBlock(x.Rows());
      SetLinearCombination({ { &w, this->OfCorrection() } }, s);
    }
  }

  int FirstNonzero() const
  {
    int first = 0;
    while (first < Width && this->Pairs.Values[first] < this->Zero)
    {
      ++first;
    }
    return first;
  }
  void Take(RitzPairs ritz)
  {
    this->Ritz = std::move(ritz);
    this->Pairs.Values = this->Ritz.Values;
  }
  SmallMatrix OfCorrection() const { return this->Ritz.Vectors.middleRows(Width, Width); }
  SmallMatrix OfSearch() const { return this->Ritz.Vectors.bottomRows(Width); }
  void Multiply(SectionBlock& block) const
  {
    if (this->Finest)
    {
      DirectionFields::Multiply(
        *this->Finest, block.Vectors.data(), block.Energy.data(), block.Mass.data());
    }
    else
    {
      this->Matrices.Multiply<Width>(block.Vectors.data(), block.Energy.data(), block.Mass.data());
    }
  }

  /// The operators on the finest level, whose products are more exact; else null.
  const Operators* Finest;
  double Zero;
  const LevelMatrices& Matrices;
  bool IsCoarsest;
  NestedPairs& Pairs;
  /// Before a step its vectors are the residuals, then the corrections W that cycles make of them.
  SectionBlock Correction;
  /// The last step S; empty before the second one.
  SectionBlock Search;
  RitzPairs Ritz;
};

/// Sections without any pattern that a symmetry could make orthogonal to an eigenvector.
SectionBlock Irregular(Index rows)
{
  SectionBlock block(rows);
  for (Index v = 0; v < rows; ++v)
  {
    for (int b = 0; b < Width; ++b)
    {
      const double angle = 2.4 * static_cast<double>(v) * (b + 1) + 0.7 * b;
      block.Vectors[2 * Width * v + b] = static_cast<float>(std::cos(angle));
      block.Vectors[2 * Width * v + Width + b] = static_cast<float>(std::sin(angle));
    }
  }
  return block;
}
}

NestedPairs IterateNested(const Operators& operators, const Hierarchy& hierarchy,
  const Cycle& cycle, const Progress& progress)
{
  const std::vector<Hierarchy::Level>& levels = hierarchy.GetLevels();
  NestedPairs pairs;
  pairs.Block = Irregular(levels.back().Rows());
  for (std::size_t level = levels.size(); level-- > 0;)
  {
    if (level + 1 < levels.size())
    {
      SectionBlock finer(levels[level].Rows());
      levels[level].FromCoarser.Prolong<Width>(pairs.Block.Vectors.data(), finer.Vectors.data());
      pairs.Block = std::move(finer);
    }
    BlockIteration iteration(
      level == 0 ? &operators : nullptr, levels[level], hierarchy.GetScale(), pairs);
    const int most = level + 1 == levels.size() ? MostStepsOnCoarsest
      : level == 0                              ? MostStepsOnFinest
                                                : MostSteps;
    bool goes = iteration.IsWhole();
    const double entries = levels[level].Matrices.Energy.Entries() + levels[level].Rows();
    pairs.Work += WorkPerEntry * entries;
    for (int step = 0; goes && step < most; ++step)
    {
      progress.RequireToGoOn();
      pairs.Work += WorkPerEntry * entries;
      goes = iteration.Residuals() > Tolerance && !iteration.Step(cycle, level, step + 1 == most);
    }
    if (!iteration.IsWhole())
    {
      pairs.Values.resize(0);
      return pairs;
    }
  }
  Free(pairs.Block.Mass);
  return pairs;
}
}
