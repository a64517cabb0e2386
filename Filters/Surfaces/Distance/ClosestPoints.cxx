// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/ClosestPoints.h"

#include "Distance/NormalRanges.h"

#include "Support/LargeArray.h"
#include "Support/Threads.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace DirectionFields
{
namespace
{
/// A triangle by its number, and its middle.
struct Member
{
  std::array<float, 3> Middle;
  Index Triangle;
};

/// Neighbours in a tree, as many as fill a node of Size triangles, or less than that at the end.
struct Range
{
  Member* Begin;
  Member* End;
  std::int64_t Size;
  Index Count() const { return static_cast<Index>(this->End - this->Begin); }
};

/// Puts half of a node's triangles before the others, along the axis on which their middles are
/// farthest apart. Of middles at the same place the first goes first.
std::array<Range, 2> Halves(const Range& range)
{
  const std::int64_t half = range.Size / 2;
  if (range.Count() <= half)
  {
    return { Range{ range.Begin, range.End, half }, Range{ range.End, range.End, half } };
  }
  std::array<float, 3> low = range.Begin->Middle;
  std::array<float, 3> high = low;
  for (const Member* member = range.Begin; member != range.End; ++member)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      low[axis] = std::min(low[axis], member->Middle[axis]);
      high[axis] = std::max(high[axis], member->Middle[axis]);
    }
  }
  int widest = 0;
  for (int axis = 1; axis < 3; ++axis)
  {
    widest = high[axis] - low[axis] > high[widest] - low[widest] ? axis : widest;
  }
  Member* const middle = range.Begin + half;
  std::nth_element(range.Begin, middle, range.End,
    [widest](const Member& a, const Member& b)
    {
      const float x = a.Middle[widest];
      const float y = b.Middle[widest];
      return x != y ? x < y : a.Triangle < b.Triangle;
    });
  return { Range{ range.Begin, middle, half }, Range{ middle, range.End, half } };
}

void SortWithin(const Range& range, Index leaf)
{
  if (range.Count() > leaf)
  {
    for (const Range& half : Halves(range))
    {
      SortWithin(half, leaf);
    }
  }
}

/// Brings triangles into the order of a tree, down to nodes of at most this number of triangles.
void Sort(LargeArray<Member>& members, Index leaf)
{
  constexpr std::size_t mostRanges = 32;
  const auto count = static_cast<Index>(members.size());
  std::int64_t size = leaf;
  while (size < count)
  {
    size *= leaf;
  }
  std::vector<Range> ranges = { { members.data(), members.data() + count, size } };
  while (ranges.size() < mostRanges && ranges.front().Size > MediumPiece)
  {
    std::vector<Range> halves(2 * ranges.size());
    Threads::Run(static_cast<Index>(ranges.size()),
      [&](Index k)
      {
        const std::array<Range, 2> pair = Halves(ranges[k]);
        std::copy(pair.begin(), pair.end(), halves.begin() + 2 * static_cast<std::ptrdiff_t>(k));
      });
    ranges = std::move(halves);
  }
  Threads::Run(static_cast<Index>(ranges.size()), [&](Index k) { SortWithin(ranges[k], leaf); });
}
}

std::array<double, 3> ClosestPoints::ClosestWeights(const Vector3& p, const Corners& t)
{
  const Vector3 ab = t[1] - t[0];
  const Vector3 ac = t[2] - t[0];
  const Vector3 ap = p - t[0];
  const double d1 = ab.dot(ap);
  const double d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0)
  {
    return { 1.0, 0.0, 0.0 };
  }
  const Vector3 bp = p - t[1];
  const double d3 = ab.dot(bp);
  const double d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3)
  {
    return { 0.0, 1.0, 0.0 };
  }
  const double vc = d1 * d4 - d3 * d2;
  // Corners at one place are no edge to divide by.
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 && d1 > d3)
  {
    const double v = d1 / (d1 - d3);
    return { 1.0 - v, v, 0.0 };
  }
  const Vector3 cp = p - t[2];
  const double d5 = ab.dot(cp);
  const double d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6)
  {
    return { 0.0, 0.0, 1.0 };
  }
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 && d2 > d6)
  {
    const double w = d2 / (d2 - d6);
    return { 1.0 - w, 0.0, w };
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0)
  {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return { 0.0, 1.0 - w, w };
  }
  const double sum = va + vb + vc;
  return { va / sum, vb / sum, vc / sum };
}

ClosestPoints::ClosestPoints(std::vector<Corners> triangles)
  : Number(triangles.size())
{
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    this->Number[t] = static_cast<Index>(t);
  }
  this->Build(std::move(triangles));
}

ClosestPoints::ClosestPoints(const Surface& surface)
{
  const auto size = static_cast<Index>(surface.Points.size());
  std::vector<Corners> triangles;
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    const Triangle& ids = surface.Triangles[t];
    if (std::all_of(ids.begin(), ids.end(),
          [&](Index p) { return p >= 0 && p < size && surface.Points[p].allFinite(); }))
    {
      triangles.push_back(
        { surface.Points[ids[0]], surface.Points[ids[1]], surface.Points[ids[2]] });
      this->Number.push_back(static_cast<Index>(t));
    }
  }
  this->Build(std::move(triangles));
}

void ClosestPoints::Build(std::vector<Corners>&& triangles)
{
  const auto count = static_cast<Index>(triangles.size());
  if (count == 0)
  {
    return;
  }
  double largest = 0.0;
  for (const Corners& corners : triangles)
  {
    for (const Vector3& p : corners)
    {
      largest = std::max(largest, p.cwiseAbs().maxCoeff());
    }
  }
  this->Scale =
    largest > 0.0 ? std::ldexp(1.0, -std::clamp(std::ilogb(largest), -1000, 1000)) : 1.0;
  LargeArray<Member> order(count);
  ParallelFor(count, MediumPiece,
    [&](Index begin, Index end)
    {
      for (Index t = begin; t < end; ++t)
      {
        order[t].Triangle = t;
        for (int axis = 0; axis < 3; ++axis)
        {
          const double sum = this->Scale * triangles[t][0][axis] +
            this->Scale * triangles[t][1][axis] + this->Scale * triangles[t][2][axis];
          order[t].Middle[axis] = std::isfinite(sum) ? static_cast<float>(sum / 3.0) : 0.0F;
        }
      }
    });
  Sort(order, Width);
  this->Triangles.resize(count);
  std::vector<Index> number(count);
  ParallelFor(count, MediumPiece,
    [&](Index begin, Index end)
    {
      for (Index t = begin; t < end; ++t)
      {
        number[t] = this->Number[order[t].Triangle];
        for (int c = 0; c < 3; ++c)
        {
          this->Triangles[t][c] = this->Scale * triangles[order[t].Triangle][c];
        }
      }
    });
  this->Number = std::move(number);
  this->BuildLevels();
  this->Normals = std::make_shared<NormalRanges>(this->Triangles, this->Levels.size());
  if (this->HasOverlappingBoxes())
  {
    this->BuildSlabs();
  }
}

void ClosestPoints::BuildLevels()
{
  for (auto below = static_cast<Index>(this->Triangles.size()); this->Levels.empty() || below > 1;)
  {
    const Index nodes = NumberOfPieces(below, Width);
    std::vector<Node> level(nodes);
    const std::vector<Node>* const lower = this->Levels.empty() ? nullptr : &this->Levels.back();
    ParallelFor(nodes, MediumPiece,
      [&](Index begin, Index end)
      {
        // The last node of a level may have less than it could: the box of its last part is there
        // several times.
        for (Index child = Width * begin; child < Width * end; ++child)
        {
          const Index k = std::min(child, below - 1);
          for (int axis = 0; axis < 3; ++axis)
          {
            double low = 0.0;
            double high = 0.0;
            if (lower != nullptr)
            {
              low = (*lower)[k].Low[axis].minCoeff();
              high = (*lower)[k].High[axis].maxCoeff();
            }
            else
            {
              const Corners& t = this->Triangles[k];
              low = std::min({ t[0][axis], t[1][axis], t[2][axis] });
              high = std::max({ t[0][axis], t[1][axis], t[2][axis] });
            }
            level[child / Width].Low[axis][child % Width] = low;
            level[child / Width].High[axis][child % Width] = high;
          }
        }
      });
    this->Levels.push_back(std::move(level));
    below = nodes;
  }
}

/// Whether the places of the triangles are in many boxes each, on the average.
bool ClosestPoints::HasOverlappingBoxes() const
{
  constexpr double many = 16.0;
  double area = 0.0;
  double ofBoxes = 0.0;
  for (const Corners& t : this->Triangles)
  {
    area += 0.5 * (t[1] - t[0]).cross(t[2] - t[0]).norm();
    Vector3 sides = t[0].cwiseMax(t[1]).cwiseMax(t[2]) - t[0].cwiseMin(t[1]).cwiseMin(t[2]);
    std::sort(sides.data(), sides.data() + 3);
    ofBoxes += sides[1] * sides[2];
  }
  return ofBoxes > many * area;
}

namespace
{
/// The direction in the plane of a triangle that is normal to its longest edge, and the normal of
/// the triangle; any that are normal to that edge, or to each other, where it has no area.
std::array<Vector3, 2> DirectionsOfNeedle(const ClosestPoints::Corners& t)
{
  Vector3 longest = Vector3::Zero();
  for (std::size_t c = 0; c < 3; ++c)
  {
    const Vector3 edge = t[(c + 1) % 3] - t[c];
    longest = edge.squaredNorm() > longest.squaredNorm() ? edge : longest;
  }
  const Vector3 along =
    longest.isZero(0.0) ? Vector3(Vector3::UnitX()) : longest.stableNormalized();
  const Vector3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  Vector3 across = normal.stableNormalized().cross(along);
  across = across.isZero(0.0) ? along.unitOrthogonal() : across.stableNormalized();
  return { across, along.cross(across).normalized() };
}
}

void ClosestPoints::BuildSlabs()
{
  std::vector<Directions> directions(this->Triangles.size());
  ParallelFor(static_cast<Index>(directions.size()), MediumPiece,
    [&](Index begin, Index end)
    {
      for (Index t = begin; t < end; ++t)
      {
        directions[t] = DirectionsOfNeedle(this->Triangles[t]);
      }
    });
  Index covered = 1;
  for (std::size_t level = 0; level < this->Levels.size(); ++level)
  {
    this->AddLevelOfSlabs(directions, covered);
    covered *= Width;
  }
}

/// @param directions of the parts, become those of the nodes: the mean of both signs
/// @param covered    the triangles of a part
void ClosestPoints::AddLevelOfSlabs(std::vector<Directions>& directions, Index covered)
{
  // Shorter than 1 by more than rounding, so that heights are no larger than distances.
  constexpr double length = 1.0 - 1e-14;
  const auto triangles = static_cast<std::int64_t>(this->Triangles.size());
  const auto below = static_cast<Index>(directions.size());
  std::vector<Slabs> level(NumberOfPieces(below, Width));
  std::vector<Directions> means(level.size());
  const auto fill = [&](Index child)
  {
    const Index k = std::min(child, below - 1);
    Slabs& slabs = level[child / Width];
    const std::int64_t first = static_cast<std::int64_t>(k) * covered;
    const std::int64_t last = std::min<std::int64_t>(triangles, first + covered);
    for (std::size_t d = 0; d < 2; ++d)
    {
      const Vector3 direction = length * directions[k][d];
      double low = Infinity;
      double high = -Infinity;
      for (std::int64_t t = first; t < last; ++t)
      {
        for (const Vector3& corner : this->Triangles[t])
        {
          low = std::min(low, direction.dot(corner));
          high = std::max(high, direction.dot(corner));
        }
      }
      for (int axis = 0; axis < 3; ++axis)
      {
        slabs.Direction[d][axis][child % Width] = direction[axis];
      }
      slabs.Low[d][child % Width] = low;
      slabs.High[d][child % Width] = high;
      Vector3& mean = means[child / Width][d];
      mean = child % Width == 0
        ? directions[k][d]
        : Vector3(mean + (mean.dot(directions[k][d]) < 0.0 ? -1.0 : 1.0) * directions[k][d]);
    }
  };
  ParallelFor(static_cast<Index>(level.size()), std::max<Index>(1, MediumPiece / covered),
    [&](Index begin, Index end)
    {
      for (Index child = Width * begin; child < Width * end; ++child)
      {
        fill(child);
      }
    });
  for (Directions& mean : means)
  {
    mean[0].stableNormalize();
    const Vector3 rest = mean[1] - mean[1].dot(mean[0]) * mean[0];
    mean[1] = rest.norm() > 1e-6 * mean[1].norm() ? rest.normalized() : mean[0].unitOrthogonal();
    mean[1] = (mean[1] - mean[1].dot(mean[0]) * mean[0]).normalized();
  }
  directions = std::move(means);
  this->LevelsOfSlabs.push_back(std::move(level));
}

void ClosestPoints::Consider(
  Index at, const Vector3& place, const Vector3& normal, Answer& best) const
{
  const Corners& corners = this->Triangles[at];
  if (!normal.isZero(0.0) && NormalRanges::NormalOf(corners).dot(normal) < 0.0)
  {
    return;
  }
  const std::array<double, 3> weights = ClosestWeights(place, corners);
  const Vector3 point = weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
  const double squared = (point - place).squaredNorm();
  const Index number = this->Number[at];
  if (squared < best.SquaredDistance ||
    (squared == best.SquaredDistance && (best.Triangle == None || number < best.Triangle)))
  {
    best = { number, point, squared, weights, at };
  }
}

ClosestPoints::Answer ClosestPoints::Find(
  const Vector3& givenPlace, const Vector3& normal, double distance, Index guess) const
{
  Answer best;
  if (this->Triangles.empty() || !givenPlace.allFinite())
  {
    return best;
  }
  const Vector3 place = this->Scale * givenPlace;
  best.SquaredDistance = (this->Scale * distance) * (this->Scale * distance);
  if (guess != None)
  {
    this->Consider(guess, place, normal, best);
  }
  struct Entry
  {
    double Distance;
    Index Node;
    int Level;
  };
  // Of heights between the planes of slabs, by rounding.
  const double error = 1e-15 * (2.0 + place.lpNorm<1>());
  // A level leaves at most three entries behind, and 4^16 are more triangles than can be numbered.
  std::array<Entry, 64> stack;
  std::size_t top = 0;
  stack[top++] = { 0.0, 0, static_cast<int>(this->Levels.size()) - 1 };
  while (top > 0)
  {
    const Entry entry = stack[--top];
    if (entry.Distance > best.SquaredDistance)
    {
      continue;
    }
    const Index first = Width * entry.Node;
    const Index below = entry.Level > 0 ? static_cast<Index>(this->Levels[entry.Level - 1].size())
                                        : static_cast<Index>(this->Triangles.size());
    Node::Numbers distances = this->Levels[entry.Level][entry.Node].SquaredDistances(place);
    if (!this->LevelsOfSlabs.empty())
    {
      const Slabs& slabs = this->LevelsOfSlabs[entry.Level][entry.Node];
      distances = distances.max(slabs.SquaredDistances(place, error));
    }
    if (entry.Level > 0 && !normal.isZero(0.0))
    {
      const auto products = this->Normals->LargestProducts(entry.Level, entry.Node, normal);
      distances = (products < 0.0).select(Infinity, distances);
    }
    // The nearest one last, which is taken from the stack first.
    std::array<Entry, Width> children;
    int count = 0;
    for (Index k = 0; k < std::min(Width, below - first); ++k)
    {
      if (distances[k] <= best.SquaredDistance && distances[k] < Infinity)
      {
        int at = count++;
        for (; at > 0 && children[at - 1].Distance < distances[k]; --at)
        {
          children[at] = children[at - 1];
        }
        children[at] = { distances[k], first + k, entry.Level - 1 };
      }
    }
    if (entry.Level > 0)
    {
      std::copy_n(children.begin(), count, stack.begin() + top);
      top += count;
      continue;
    }
    while (count > 0 && children[--count].Distance <= best.SquaredDistance)
    {
      this->Consider(children[count].Node, place, normal, best);
    }
  }
  best.Position /= this->Scale;
  best.SquaredDistance /= this->Scale * this->Scale;
  return best;
}
}
