// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "UnitLength/SingularityPairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace DirectionFields::Internal
{
namespace
{
/// The number of sources that each triangle remembers. More of them cost time and hardly ever lead
/// to another pair.
constexpr int Nearest = 2;
/// The boundary counts as one source, which comes before all triangles where distances are equal.
constexpr Index Boundary = -1;
constexpr Index Nothing = -2;
/// In mean lengths of an edge. From triangle to triangle it is about 0.6.
constexpr double BucketWidth = 0.25;

/// A triangle that waits for its label.
struct Entry
{
  double Distance;
  Index Source;
  Index Triangle;
  /// The half-edge of the triangle that leads back.
  Index Back;
};

/// A queue by distance, up to the width of a bucket: entries of one bucket come in the order in
/// which they were added. Linear in the entries, unlike a heap.
class BucketQueue
{
public:
  /// @param width   of a bucket, wanted; it is larger where steps differ very much
  /// @param longest step, from an entry to those that it adds
  BucketQueue(double width, double longest)
    : Width(std::max(width, longest / MostBuckets))
    , Buckets(static_cast<std::size_t>(longest / this->Width) + 2)
  {
  }

  void Add(const Entry& entry)
  {
    const auto bucket = static_cast<std::size_t>(entry.Distance / this->Width);
    this->Buckets[std::max(bucket, this->Current) % this->Buckets.size()].push_back(entry);
    ++this->Size;
  }

  bool IsEmpty() const { return this->Size == 0; }

  Entry Take()
  {
    for (;;)
    {
      std::vector<Entry>& bucket = this->Buckets[this->Current % this->Buckets.size()];
      if (this->Next < bucket.size())
      {
        --this->Size;
        return bucket[this->Next++];
      }
      bucket.clear();
      this->Next = 0;
      ++this->Current;
    }
  }

private:
  static constexpr double MostBuckets = 4096.0;
  double Width;
  std::vector<std::vector<Entry>> Buckets;
  std::size_t Current = 0;
  std::size_t Next = 0;
  std::size_t Size = 0;
};

/// Searches from all singularities of negative index at once, and from the boundary.
class Search
{
public:
  Search(const UnitLengthProblem& problem, const std::vector<int>& indices)
    : Problem(problem)
    , Mesh(problem.Geometry.Mesh)
    , First(problem.Component.FirstTriangle)
    , Indices(indices)
    , Labels(static_cast<std::size_t>(problem.Component.Triangles()))
    , Queue(BucketWidth, LongestStep(problem))
  {
    for (Index t = 0; t < problem.Component.Triangles(); ++t)
    {
      this->Missing += indices[t] > 0 ? Nearest : 0;
      if (indices[t] < 0)
      {
        this->Queue.Add({ 0.0, t, t, None });
      }
    }
    const bool any = std::any_of(indices.begin(), indices.end(), [](int k) { return k != 0; });
    for (Index t = 0; any && !problem.Component.Closed && t < problem.Component.Triangles(); ++t)
    {
      for (Index h = 3 * (this->First + t); h < 3 * (this->First + t) + 3; ++h)
      {
        if (this->Mesh.Twin(h) == None && this->CanCross(h))
        {
          this->Queue.Add({ this->ToSide(h), Boundary, t, h });
        }
      }
    }
  }

  void Run()
  {
    while (!this->Queue.IsEmpty() && this->Missing > 0)
    {
      const Entry entry = this->Queue.Take();
      const Index t = entry.Triangle;
      Label* const label = this->FreeLabel(t, entry.Source);
      if (!label)
      {
        continue;
      }
      *label = { entry.Source, entry.Back, entry.Distance };
      this->Missing -= this->Indices[t] > 0 ? 1 : 0;
      for (Index h = 3 * (this->First + t); h < 3 * (this->First + t) + 3; ++h)
      {
        const Index twin = this->Mesh.Twin(h);
        if (twin != None && h != entry.Back &&
          this->FreeLabel(twin / 3 - this->First, entry.Source) && this->CanCross(h))
        {
          this->Queue.Add({ entry.Distance + this->ToSide(h) + this->ToSide(twin), entry.Source,
            twin / 3 - this->First, twin });
        }
      }
    }
  }

  std::vector<SingularityPair> Pairs() const
  {
    std::vector<SingularityPair> pairs;
    for (Index t = 0; t < this->Problem.Component.Triangles(); ++t)
    {
      for (const Label& label : this->Labels[t])
      {
        const int index = this->Indices[t];
        if (label.Source != Nothing && (index > 0 || (index < 0 && label.Source == Boundary)))
        {
          pairs.push_back(
            { this->First + t, label.Source == Boundary ? None : this->First + label.Source,
              index > 0 ? -1 : 1, label.Distance, this->Path(t, label.Source) });
        }
      }
    }
    std::sort(pairs.begin(), pairs.end(),
      [](const SingularityPair& a, const SingularityPair& b)
      { return std::tie(a.Distance, a.From, a.To) < std::tie(b.Distance, b.From, b.To); });
    return pairs;
  }

private:
  struct Label
  {
    Index Source = Nothing;
    /// The half-edge of the triangle that leads back to the source; None in the source.
    Index Back = None;
    double Distance = 0.0;
  };
  using Slots = std::array<Label, Nearest>;

  /// Where a triangle may remember another source; null if it cannot, or knows this one.
  Label* FreeLabel(Index t, Index source)
  {
    for (Label& label : this->Labels[t])
    {
      if (label.Source == source)
      {
        return nullptr;
      }
      if (label.Source == Nothing)
      {
        return &label;
      }
    }
    return nullptr;
  }

  /// The longest step from triangle to triangle is no longer than this.
  static double LongestStep(const UnitLengthProblem& problem)
  {
    const TriangleMesh::Component& c = problem.Component;
    double longest = 0.0;
    for (Index e = c.FirstEdge; e < c.EndEdge; ++e)
    {
      longest = std::max(longest, problem.Geometry.Lengths.SquaredLength[e]);
    }
    return 2.0 * std::sqrt(longest);
  }

  /// A path that crosses an edge turns the values of one end against the other.
  bool CanCross(Index h) const
  {
    const Index first = this->Problem.Component.FirstVertex;
    return this->Mesh.Tail(h) != this->Mesh.Head(h) &&
      (this->Problem.IsFree(this->Mesh.Tail(h) - first) ||
        this->Problem.IsFree(this->Mesh.Head(h) - first));
  }

  /// From the barycentre of a triangle to the middle of a side: a third of the median.
  double ToSide(Index h) const
  {
    const auto squared = [this](Index side)
    { return this->Problem.Geometry.Lengths.SquaredLength[this->Mesh.Edge(side)]; };
    return std::sqrt(std::max(0.0,
             2.0 * (squared(TriangleMesh::Next(h)) + squared(TriangleMesh::Previous(h))) -
               squared(h))) /
      6.0;
  }

  std::vector<Index> Path(Index t, Index source) const
  {
    std::vector<Index> crossed;
    for (;;)
    {
      const Slots& slots = this->Labels[t];
      const Index back = std::find_if(slots.begin(), slots.end(),
        [source](const Label& l) {
          return l.Source == source;
        })->Back;
      if (back == None)
      {
        return crossed;
      }
      crossed.push_back(back);
      const Index twin = this->Mesh.Twin(back);
      if (twin == None)
      {
        return crossed;
      }
      t = twin / 3 - this->First;
    }
  }

  const UnitLengthProblem& Problem;
  const TriangleMesh& Mesh;
  Index First;
  const std::vector<int>& Indices;
  std::vector<Slots> Labels;
  BucketQueue Queue;
  /// How many sources the triangles of positive index have yet to be reached by.
  Index Missing = 0;
};
}

std::vector<SingularityPair> FindPairs(
  const UnitLengthProblem& problem, const std::vector<int>& indices)
{
  Search search(problem, indices);
  search.Run();
  return search.Pairs();
}
}
