// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Solvers/Eigenpairs/NestedIteration.h"

#include "Solvers/Multigrid/LevelMatrices.h"
#include "Support/Threads.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace DirectionFields
{
namespace
{
constexpr int Width = SectionBlock::Width;
/// Relative residual of the smallest pair where a level is left: the discretization of a coarser one
/// is off by more than that.
constexpr float Tolerance = 0.2f;
/// A value below this part of the order of magnitude of the smallest eigenvalue is 0. The residual of
/// its section is rounding, along which no step may go.
constexpr double ZeroPart = 1e-3;
constexpr int MostSteps = 8;
constexpr int MostStepsOnCoarsest = 20;
/// On the finest level each step costs as much as five V-cycles of the one section that it is about in
/// the end. There it ends, too, where a step has changed the smallest value by no more than a part: the
/// first one by what interpolation had added, as a rule.
constexpr int MostStepsOnFinest = 4;
constexpr double FirstChange = 0.25;
constexpr double SettledChange = 0.02;

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
  BlockIteration(const Operators* operators, const Hierarchy::Level& level, double scale,
    NestedPairs& pairs)
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
    const std::vector<SmallMatrix> products =
      Products(level.Rows(), { { &pairs.Block.Vectors, &pairs.Block.Energy },
                               { &pairs.Block.Vectors, &pairs.Block.Mass } });
    this->Take(RayleighRitz(products[0], products[1], Width));
    if (this->IsWhole())
    {
      Combine({ { &pairs.Block, this->Ritz.Vectors } }, pairs.Block);
    }
  }

  /// All four pairs are there.
  bool IsWhole() const { return this->Pairs.Values.size() == Width; }

  /// Puts the residuals in Correction; returns the relative size of that of the smallest value but
  /// 0, and 0 where there is none.
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
          part.Residual += rest.Real[first] * rest.Real[first] +
            rest.Imaginary[first] * rest.Imaginary[first];
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
    SectionBlock& x = this->Pairs.Block;
    SectionBlock& w = this->Correction;
    SectionBlock& s = this->Search;
    const bool searched = s.Rows() > 0;
    // Storage that will be written to next.
    cycle.Apply<Width>(w.Vectors.data(), w.Mass.data(), level);
    w.Vectors.swap(w.Mass);
    this->Multiply(w);

    std::vector<std::pair<const CompactSections*, const CompactSections*>> pairs{
      { &x.Vectors, &w.Energy }, { &x.Vectors, &w.Mass }, { &w.Vectors, &w.Energy },
      { &w.Vectors, &w.Mass }
    };
    if (searched)
    {
      for (const CompactSections* other : { &x.Vectors, &w.Vectors, &s.Vectors })
      {
        pairs.emplace_back(other, &s.Energy);
        pairs.emplace_back(other, &s.Mass);
      }
    }
    const std::vector<SmallMatrix> products = Products(x.Rows(), pairs);
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
    const int first = this->FirstNonzero();
    const double before = this->Pairs.Values[first];
    this->Take(RayleighRitz(energy, mass, Width));
    if (!this->IsWhole())
    {
      return true;
    }
    // Without a coarser level the first steps say nothing; and where the value rises, what the
    // coarser level took for it was rounding.
    const double now = this->Pairs.Values[first];
    isLast = isLast ||
      (level == 0 && !this->IsCoarsest &&
        std::abs(before - now) <= (searched ? SettledChange : FirstChange) * now);
    std::vector<std::pair<const SectionBlock*, SmallMatrix>> terms{
      { &x, SmallMatrix(this->Ritz.Vectors.topRows(Width)) }, { &w, this->OfCorrection() }
    };
    if (searched)
    {
      terms.emplace_back(&s, this->OfSearch());
    }
    Combine(terms, x, level > 0 || !isLast);
    if (!isLast && searched)
    {
      Combine({ { &w, this->OfCorrection() }, { &s, this->OfSearch() } }, s);
    }
    else if (!isLast)
    {
      s = SectionBlock(x.Rows());
      Combine({ { &w, this->OfCorrection() } }, s);
    }
    return isLast;
  }

private:
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
      this->Matrices.Multiply<Width>(
        block.Vectors.data(), block.Energy.data(), block.Mass.data());
    }
  }

  const Operators* Finest;
  double Zero;
  const LevelMatrices& Matrices;
  bool IsCoarsest;
  NestedPairs& Pairs;
  /// Its vectors are the residuals before the step.
  SectionBlock Correction;
  /// The last step. Empty before the second one.
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
  const Cycle& cycle, const std::function<bool()>& goOn)
{
  const std::vector<Hierarchy::Level>& levels = hierarchy.GetLevels();
  NestedPairs pairs;
  pairs.Block = Irregular(levels.back().Rows());
  for (std::size_t level = levels.size(); level-- > 0;)
  {
    if (level + 1 < levels.size())
    {
      SectionBlock finer(levels[level].Rows());
      levels[level].FromCoarser.Prolong<Width>(
        pairs.Block.Vectors.data(), finer.Vectors.data());
      pairs.Block = std::move(finer);
    }
    BlockIteration iteration(level == 0 ? &operators : nullptr, levels[level],
      hierarchy.GetScale(), pairs);
    const int most = level + 1 == levels.size() ? MostStepsOnCoarsest
      : level == 0                               ? MostStepsOnFinest
                                                 : MostSteps;
    bool goes = iteration.IsWhole();
    for (int step = 0; goes && step < most; ++step)
    {
      if (!goOn())
      {
        pairs.Values.resize(0);
        return pairs;
      }
      goes = iteration.Residuals() > Tolerance &&
        !iteration.Step(cycle, level, step + 1 == most);
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
