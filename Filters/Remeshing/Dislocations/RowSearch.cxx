// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Dislocations/RowSearch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// So many edges on each side of a chain are compared with the wanted lengths: rows that are put in
/// crowd those beside them first, and smoothing carries that no farther in one round.
constexpr std::size_t Reach = 4;
/// What rows have to gain for each of their ends inside of the surface, in squares of logarithms of
/// edges, and altogether. An end at an irregular vertex that becomes regular costs half of it.
constexpr double PerEnd = 1.0;
constexpr double LeastGain = 0.05;
/// Rows are not taken out where fewer edges are across.
constexpr std::size_t FewestAcross = 5;
constexpr double Infinite = std::numeric_limits<double>::infinity();

double SquaredLog(double ratio)
{
  const double log = std::log(ratio);
  return log * log;
}

/// The edges across a chain at one of its vertices: how many would have the wanted length, and
/// where those that are there lead to.
struct Across
{
  double Wanted = 0.0;
  std::vector<Index> Ends;

  /// By how much the sum of the squares of the logarithms of lengths over wanted ones gets less if
  /// there are two edges more or less on the same way.
  double Gain(bool inserts) const
  {
    const auto now = static_cast<double>(this->Ends.size());
    const double then = inserts ? now + 2.0 : now - 2.0;
    return now * SquaredLog(this->Wanted / now) - then * SquaredLog(this->Wanted / then);
  }
};

/// The vertices of a chain, and the half-edge of the chain by which each is found.
struct Places
{
  std::vector<Index> Vertices;
  std::vector<Index> HalfEdges;
  std::vector<Across> Around;
};

struct Candidate
{
  double Gain;
  RowEdit Edit;
  /// The vertices of the rows and beside them, and those within reach.
  std::vector<Index> Touched;
  std::vector<Index> Near;
};

/// A part of a chain, from one of its vertices to another one, and what it gains.
struct Part
{
  std::size_t Begin;
  std::size_t End;
  double Gain;
};

class RowSearch
{
public:
  RowSearch(const FaceMesh& mesh, const EdgeLoops& chains, const std::vector<double>& wanted)
    : Mesh(mesh)
    , Chains(chains)
    , Wanted(wanted)
  {
  }

  void AddCandidates(const std::vector<Index>& chain, std::vector<Candidate>& all) const
  {
    const Places places = this->PlacesOf(chain);
    for (const bool inserts : { true, false })
    {
      const std::optional<Part> best =
        this->BestPart(places, this->Gains(places, inserts), inserts);
      if (best)
      {
        Candidate candidate = this->CandidateFor(chain, places, *best, inserts);
        std::vector<Index> sorted = candidate.Touched;
        std::sort(sorted.begin(), sorted.end());
        if (std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end())
        {
          all.push_back(std::move(candidate));
        }
      }
    }
  }

private:
  void Walk(Index h, Index from, Across& across) const
  {
    for (std::size_t k = 0; k < Reach; ++k)
    {
      const Index u = this->Chains.Tail(h);
      const Index v = this->Chains.Head(h);
      const bool isAround =
        std::find(across.Ends.begin(), across.Ends.end(), v) != across.Ends.end();
      if (isAround)
      {
        return;
      }
      across.Wanted += 2.0 * (this->Mesh.Points[v] - this->Mesh.Points[u]).norm() /
        (this->Wanted[u] + this->Wanted[v]);
      across.Ends.push_back(v);
      const bool isOverLine = this->Mesh.Vertices[v].Line > 0 && !this->Chains.IsLine(h);
      if (v == from || isOverLine || !this->Chains.IsRegular(v))
      {
        return;
      }
      h = this->Chains.Ahead(h);
    }
  }

  Places PlacesOf(const std::vector<Index>& chain) const
  {
    Places places;
    places.Vertices.push_back(this->Chains.Tail(chain.front()));
    places.HalfEdges.push_back(chain.front());
    places.Around.emplace_back();
    for (const Index h : chain)
    {
      places.Vertices.push_back(this->Chains.Head(h));
      places.HalfEdges.push_back(h);
      places.Around.emplace_back();
      if (h != chain.back() && this->Chains.IsRegular(places.Vertices.back()))
      {
        this->Walk(this->Chains.Next(h), places.Vertices.back(), places.Around.back());
        this->Walk(this->Chains.ToRight(h), places.Vertices.back(), places.Around.back());
      }
    }
    return places;
  }

  /// What rows gain at each vertex of a chain; minus infinity where there can be none.
  std::vector<double> Gains(const Places& places, bool inserts) const
  {
    const std::size_t count = places.Vertices.size();
    std::vector<double> gains(count, -Infinite);
    for (std::size_t k = 1; k + 1 < count; ++k)
    {
      const std::size_t edges = places.Around[k].Ends.size();
      if (edges >= (inserts ? 1 : FewestAcross))
      {
        gains[k] = places.Around[k].Gain(inserts);
      }
    }
    // The boundary has the edges of the row beside it.
    const auto atBoundary = [&](std::size_t k, std::size_t beside)
    {
      if (this->Chains.IsMouth(places.Vertices[k]))
      {
        gains[k] = gains[beside];
      }
    };
    if (count > 2)
    {
      atBoundary(0, 1);
      atBoundary(count - 1, count - 2);
    }
    for (std::size_t k = 0; k < count && !inserts; ++k)
    {
      if (gains[k] > -Infinite &&
        !MayMerge(this->Chains, this->Mesh, places.HalfEdges[k], places.Vertices[k]))
      {
        gains[k] = -Infinite;
      }
    }
    return gains;
  }

  double CostOfEnd(Index v, bool inserts) const
  {
    const Index faces = this->Chains.CountFaces(v);
    const bool becomesRegular = faces == (inserts ? 3 : 5);
    if (!this->Chains.IsInside(v) || !(faces == 4 || becomesRegular))
    {
      return Infinite;
    }
    return becomesRegular ? 0.5 * PerEnd : PerEnd;
  }

  /// The part of at least two vertices with the largest sum of gains, less the costs of its ends.
  std::optional<Part> BestPart(
    const Places& places, const std::vector<double>& gains, bool inserts) const
  {
    const std::size_t count = gains.size();
    const auto isAtBoundary = [&](std::size_t k) { return k == 0 || k + 1 == count; };
    Part best = { count, count, LeastGain };
    // The sum up to each vertex, and the least one, with the cost there, that a part begins with.
    double sum = 0.0;
    double least = Infinite;
    double next = Infinite;
    std::size_t begin = count;
    for (std::size_t k = 0; k < count; ++k)
    {
      if (!(gains[k] > -Infinite))
      {
        sum = 0.0;
        least = next = Infinite;
        continue;
      }
      if (next < least)
      {
        least = next;
        begin = k - 1;
      }
      next = sum + (isAtBoundary(k) ? 0.0 : this->CostOfEnd(places.Vertices[k - 1], inserts));
      sum += gains[k];
      if (least < Infinite)
      {
        const double end = isAtBoundary(k) ? 0.0 : this->CostOfEnd(places.Vertices[k + 1], inserts);
        best = sum - least - end > best.Gain ? Part{ begin, k, sum - least - end } : best;
      }
    }
    return best.Begin < count ? std::optional<Part>(best) : std::nullopt;
  }

  Candidate CandidateFor(
    const std::vector<Index>& chain, const Places& places, const Part& part, bool inserts) const
  {
    const std::size_t last = places.Vertices.size() - 1;
    Candidate result;
    result.Gain = part.Gain;
    result.Edit.Inserts = inserts;
    result.Edit.BeginsAtBoundary = part.Begin == 0;
    result.Edit.EndsAtBoundary = part.End == last;
    const std::size_t from = part.Begin == 0 ? 0 : part.Begin - 1;
    const std::size_t to = std::min(part.End + 1, last);
    result.Edit.HalfEdges.assign(chain.begin() + static_cast<std::ptrdiff_t>(from),
      chain.begin() + static_cast<std::ptrdiff_t>(to));
    for (std::size_t k = from; k <= to; ++k)
    {
      result.Touched.push_back(places.Vertices[k]);
      if (k >= part.Begin && k <= part.End)
      {
        const std::array<Index, 2> beside =
          this->Chains.Beside(places.HalfEdges[k], places.Vertices[k]);
        result.Touched.insert(result.Touched.end(), beside.begin(), beside.end());
        const std::vector<Index>& near = places.Around[k].Ends;
        result.Near.insert(result.Near.end(), near.begin(), near.end());
      }
    }
    return result;
  }

  const FaceMesh& Mesh;
  const EdgeLoops& Chains;
  const std::vector<double>& Wanted;
};
}

std::vector<RowEdit> FindRows(
  const FaceMesh& mesh, const EdgeLoops& chains, const std::vector<double>& wanted)
{
  const RowSearch search(mesh, chains, wanted);
  std::vector<Candidate> all;
  for (const std::vector<Index>& chain : chains.GetAll())
  {
    search.AddCandidates(chain, all);
  }
  std::stable_sort(
    all.begin(), all.end(), [](const Candidate& a, const Candidate& b) { return a.Gain > b.Gain; });
  std::vector<char> isNear(mesh.Points.size(), 0);
  std::vector<RowEdit> edits;
  for (Candidate& candidate : all)
  {
    const std::vector<Index>& touched = candidate.Touched;
    if (std::none_of(touched.begin(), touched.end(), [&](Index v) { return isNear[v] != 0; }))
    {
      const auto mark = [&](Index v) { isNear[v] = 1; };
      std::for_each(touched.begin(), touched.end(), mark);
      std::for_each(candidate.Near.begin(), candidate.Near.end(), mark);
      edits.push_back(std::move(candidate.Edit));
    }
  }
  return edits;
}
}
