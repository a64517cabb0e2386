// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Curves/PartRefinement.h"

#include "Support/SortedEnds.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace DirectionFields::Internal
{
namespace
{
/// Triangles with fewer parts are left as they are.
constexpr std::size_t FewParts = 16;
/// The sine of the least angle of parts.
constexpr double LeastSine = 0.2;
/// Parts whose longest edge is a smaller part of the mean distance of points may be slivers.
constexpr double Short = 0.125;
/// How many points may be put in for each one.
constexpr std::size_t MostPerPoint = 4;
/// How many triangles a way to longer edges may have.
constexpr int LongestWay = 64;

class Refinement
{
public:
  Refinement(SplittableMesh& mesh, const PartSplits& splits)
    : Mesh(mesh)
    , Splits(splits)
  {
  }

  void Run()
  {
    this->FindShort();
    std::vector<Index> left;
    for (Index t = 0; t < static_cast<Index>(this->Mesh.GetTriangles().size()); ++t)
    {
      left.push_back(t);
    }
    std::size_t room = MostPerPoint * this->Mesh.GetPoints().size();
    while (!left.empty() && room > 0)
    {
      const Index t = left.back();
      left.pop_back();
      if (this->IsSliver(t))
      {
        const std::array<Index, 2> ends = this->LongestAround(t);
        const std::vector<Vector3>& points = this->Mesh.GetPoints();
        const Vector3 place = 0.5 * (points[ends[0]] + points[ends[1]]);
        if (!this->HasRoom(ends, place))
        {
          continue;
        }
        const Index middle = this->Splits.Split(ends[0], ends[1], place);
        --room;
        left.push_back(t);
        const std::vector<Index> fresh = this->Mesh.At(middle);
        left.insert(left.end(), fresh.begin(), fresh.end());
      }
    }
  }

private:
  /// The square of the length below which edges are short, of each triangle of the surface.
  void FindShort()
  {
    std::vector<double> area(this->Mesh.GetTriangles().size(), 0.0);
    for (std::size_t t = 0; t < area.size(); ++t)
    {
      const Triangle& c = this->Mesh.GetTriangles()[t];
      const std::vector<Vector3>& points = this->Mesh.GetPoints();
      const Index parent = this->Mesh.Parent(static_cast<Index>(t));
      if (this->Mesh.Parts(parent).size() >= FewParts)
      {
        area[parent] += (points[c[1]] - points[c[0]]).cross(points[c[2]] - points[c[0]]).norm();
      }
    }
    for (std::size_t t = 0; t < area.size(); ++t)
    {
      const auto parent = static_cast<Index>(t);
      this->SquaredShort.push_back(area[t] > 0.0
          ? Short * Short * area[t] / static_cast<double>(this->Mesh.Parts(parent).size())
          : 0.0);
    }
  }

  double Squared(Index p, Index q) const
  {
    return (this->Mesh.GetPoints()[p] - this->Mesh.GetPoints()[q]).squaredNorm();
  }

  /// The ends of the longest edge, the first one in order of several.
  std::array<Index, 2> LongestOf(Index t) const
  {
    const Triangle& c = this->Mesh.GetTriangles()[t];
    std::array<Index, 2> longest = SortedEnds(c[0], c[1]);
    for (const std::array<Index, 2>& edge : { SortedEnds(c[1], c[2]), SortedEnds(c[2], c[0]) })
    {
      const double own = this->Squared(edge[0], edge[1]);
      const double most = this->Squared(longest[0], longest[1]);
      longest = own > most || (own == most && edge < longest) ? edge : longest;
    }
    return longest;
  }

  /// The part across an edge of one, if it is one of the same triangle.
  Index Across(Index t, const std::array<Index, 2>& ends) const
  {
    const std::vector<Index> between = this->Mesh.Between(ends[0], ends[1]);
    if (between.size() != 2)
    {
      return None;
    }
    const Index other = between[between[0] == t ? 1 : 0];
    return this->Mesh.Parent(other) == this->Mesh.Parent(t) ? other : None;
  }

  bool Stays(Index t, const std::array<Index, 2>& ends) const
  {
    return this->Splits.IsFixed(ends[0], ends[1]) || this->Across(t, ends) == None;
  }

  /// Whether an angle is small, and not given by two edges that stay.
  bool IsSliver(Index t) const
  {
    const Triangle& c = this->Mesh.GetTriangles()[t];
    if (this->Mesh.Parts(this->Mesh.Parent(t)).size() < FewParts)
    {
      return false;
    }
    std::size_t k = 0;
    for (std::size_t i = 1; i < 3; ++i)
    {
      k = this->Squared(c[i], c[(i + 1) % 3]) < this->Squared(c[k], c[(k + 1) % 3]) ? i : k;
    }
    const Index tip = c[(k + 2) % 3];
    const Vector3 a = this->Mesh.GetPoints()[c[k]] - this->Mesh.GetPoints()[tip];
    const Vector3 b = this->Mesh.GetPoints()[c[(k + 1) % 3]] - this->Mesh.GetPoints()[tip];
    const double area = a.cross(b).norm();
    const bool isShort =
      std::max(a.squaredNorm(), b.squaredNorm()) < this->SquaredShort[this->Mesh.Parent(t)];
    return !isShort && area > 0.0 && area < LeastSine * a.norm() * b.norm() &&
      !(this->Stays(t, SortedEnds(tip, c[k])) && this->Stays(t, SortedEnds(tip, c[(k + 1) % 3])));
  }

  /// Whether a place on an edge is not at another corner of a triangle there.
  bool HasRoom(const std::array<Index, 2>& ends, const Vector3& place) const
  {
    constexpr double least = 0.1;
    const double length = std::sqrt(this->Squared(ends[0], ends[1]));
    const std::vector<Index> between = this->Mesh.Between(ends[0], ends[1]);
    return std::all_of(between.begin(), between.end(),
      [&](Index t)
      {
        const Triangle& c = this->Mesh.GetTriangles()[t];
        return std::all_of(c.begin(), c.end(),
          [&](Index p) { return (this->Mesh.GetPoints()[p] - place).norm() > least * length; });
      });
  }

  /// From part to part across longer and longer edges.
  std::array<Index, 2> LongestAround(Index t) const
  {
    std::array<Index, 2> ends = this->LongestOf(t);
    for (int k = 0; k < LongestWay; ++k)
    {
      const Index other = this->Across(t, ends);
      const std::array<Index, 2> next = other == None ? ends : this->LongestOf(other);
      if (next == ends)
      {
        break;
      }
      t = other;
      ends = next;
    }
    return ends;
  }

  SplittableMesh& Mesh;
  const PartSplits& Splits;
  std::vector<double> SquaredShort;
};
}

void RefineParts(SplittableMesh& mesh, const PartSplits& splits)
{
  Refinement(mesh, splits).Run();
}
}
