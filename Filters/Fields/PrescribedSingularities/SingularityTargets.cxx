// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "PrescribedSingularities/SingularityTargets.h"

#include "TrivialConnection/RotationAtPlace.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <stdexcept>

namespace DirectionFields::Internal
{
namespace
{
/// The number of triangles, spread over the component, that are candidates for missing
/// singularities.
constexpr Index MostCandidates = 4096;

/// A target in the making. Of a cover it has the front side only, until it is finished.
class TargetBuilder
{
public:
  TargetBuilder(const IntrinsicGeometry& geometry, const TriangleMesh::Component& component,
    int degree, const TrivialConnection& rotation, const std::vector<Vector3>& positions)
    : Geometry(geometry)
    , Mesh(geometry.Mesh)
    , Component(component)
    , Degree(degree)
    , Rotation(rotation)
    , Positions(positions)
  {
  }

  RotationTarget Build(const std::vector<PrescribedSingularity>& singularities,
    const EditOptions& options, std::vector<std::string>& notes)
  {
    this->Target.Objective = options.Objective;
    this->Target.Indices = this->Rotation.GetBaseIndices();
    if (!options.AddsToBase)
    {
      this->ClearRegions(singularities, options.IsWholeList);
    }
    for (const PrescribedSingularity& singularity : singularities)
    {
      this->Target.Indices[this->Local(singularity.Place.Triangle)] += singularity.Index;
      this->Target.Places.push_back(singularity.Place);
    }
    this->CheckSums(options.Balances, notes);
    this->SpreadAll(notes);
    this->Mirror();
    return std::move(this->Target);
  }

private:
  Index Local(Index triangle) const { return triangle - this->Component.FirstTriangle; }
  bool IsFront(Index localTriangle) const
  {
    return this->Mesh.IsFront(this->Component.FirstTriangle + localTriangle);
  }
  double Holonomy(Index localTriangle) const
  {
    return this->Degree *
      this->Geometry.Transport.Curvature[this->Component.FirstTriangle + localTriangle];
  }
  Index TailOf(Index localTriangle, int c) const
  {
    return this->Mesh.Tail(3 * (this->Component.FirstTriangle + localTriangle) + c);
  }
  Vector3 Middle(Index localTriangle) const
  {
    return this->Positions[this->TailOf(localTriangle, 0)] / 3.0 +
      this->Positions[this->TailOf(localTriangle, 1)] / 3.0 +
      this->Positions[this->TailOf(localTriangle, 2)] / 3.0;
  }

  /// Forgets the base's indices in regions with a singularity, or in all.
  void ClearRegions(const std::vector<PrescribedSingularity>& singularities, bool all)
  {
    const TreeCotree& trees = this->Rotation.GetTrees();
    std::vector<char> isCleared(trees.GetNumberOfRegions(), static_cast<char>(all));
    for (const PrescribedSingularity& singularity : singularities)
    {
      isCleared[trees.GetRegion(this->Local(singularity.Place.Triangle))] = 1;
    }
    for (std::size_t t = 0; t < this->Target.Indices.size(); ++t)
    {
      if (isCleared[trees.GetRegion(static_cast<Index>(t))])
      {
        this->Target.Indices[t] = 0;
      }
    }
  }

  /// Compares the sums of closed regions with the base's, which hold for any field.
  void CheckSums(bool balances, std::vector<std::string>& notes)
  {
    const TreeCotree& trees = this->Rotation.GetTrees();
    std::vector<int> sum(trees.GetNumberOfRegions(), 0);
    std::vector<int> needed(trees.GetNumberOfRegions(), 0);
    for (Index t = 0; t < static_cast<Index>(this->Target.Indices.size()); ++t)
    {
      if (this->IsFront(t))
      {
        sum[trees.GetRegion(t)] += this->Target.Indices[t];
        needed[trees.GetRegion(t)] += this->Rotation.GetBaseIndices()[t];
      }
    }
    for (Index region = 0; region < trees.GetNumberOfRegions(); ++region)
    {
      const int missing = needed[region] - sum[region];
      if (missing == 0 || trees.IsOpen(region))
      {
        continue;
      }
      if (!balances)
      {
        this->Refuse(sum[region], needed[region]);
      }
      this->Balance(region, missing);
      notes.push_back("The indices added up to " + std::to_string(sum[region]) + " instead of " +
        std::to_string(needed[region]) + ": " + std::to_string(std::abs(missing)) +
        (missing > 0 ? " of index +1" : " of index -1") + " were added (Balance Automatically).");
    }
  }

  [[noreturn]] void Refuse(int sum, int needed) const
  {
    const int missing = needed - sum;
    const bool isWhole = this->Rotation.GetTrees().GetNumberOfRegions() == 1 &&
      this->Rotation.GetConstrained().GivenUnknowns.empty();
    const std::string numbers =
      "The indices of the singularities add up to " + std::to_string(sum) + ", but ";
    const std::string remedy = " Add singularities whose indices add up to " +
      std::to_string(missing) + ", or turn Balance Automatically on";
    if (isWhole)
    {
      const int perEuler = needed / this->Degree;
      throw std::invalid_argument(numbers + "on this closed component they must add up to " +
        std::to_string(needed) + ", the degree " + std::to_string(this->Degree) +
        " times the Euler characteristic " + std::to_string(perEuler) + "." + remedy + ".");
    }
    throw std::invalid_argument(numbers + "in the part of the surface that is bounded by " +
      "constrained directions they must add up to " + std::to_string(needed) + "." + remedy +
      ", or turn Keep Constraints off.");
  }

  /// Puts missing singularities where the base has such, first those that are farthest from all
  /// others; then into other triangles, farthest first.
  void Balance(Index region, int missing)
  {
    const int sign = missing > 0 ? 1 : -1;
    const std::vector<int>& base = this->Rotation.GetBaseIndices();
    std::vector<Vector3> taken;
    std::vector<Index> ofBase;
    std::vector<Index> others;
    const Index stride = std::max<Index>(1, this->Component.Triangles() / MostCandidates);
    for (Index t = 0; t < this->Component.Triangles(); ++t)
    {
      if (!this->IsFront(t) || this->Rotation.GetTrees().GetRegion(t) != region)
      {
        continue;
      }
      if (this->Target.Indices[t] != 0)
      {
        taken.push_back(this->Middle(t));
      }
      else if (base[t] * sign > 0)
      {
        ofBase.push_back(t);
      }
      else if (t % stride == 0)
      {
        others.push_back(t);
      }
    }
    int left = std::abs(missing);
    for (std::vector<Index>* candidates : { &ofBase, &others })
    {
      left = this->TakeFarthest(*candidates, sign, left, taken);
    }
    if (left > 0)
    {
      throw std::invalid_argument(
        "The mesh has too few triangles for the singularities that Balance Automatically would have to add. "
        "Subdivide it.");
    }
  }

  /// @return the number that is left over
  int TakeFarthest(
    const std::vector<Index>& candidates, int sign, int count, std::vector<Vector3>& taken)
  {
    std::vector<double> distance(candidates.size(), std::numeric_limits<double>::infinity());
    std::size_t known = 0;
    for (; count > 0; --count)
    {
      std::size_t best = candidates.size();
      for (std::size_t k = 0; k < candidates.size(); ++k)
      {
        for (std::size_t i = known; i < taken.size() && distance[k] >= 0.0; ++i)
        {
          distance[k] = std::min(distance[k], (this->Middle(candidates[k]) - taken[i]).norm());
        }
        if (distance[k] >= 0.0 && (best == candidates.size() || distance[k] > distance[best]))
        {
          best = k;
        }
      }
      known = taken.size();
      if (best == candidates.size())
      {
        break;
      }
      distance[best] = -1.0;
      this->Target.Indices[candidates[best]] += sign;
      taken.push_back(this->Middle(candidates[best]));
    }
    return count;
  }

  /// Moves indices that triangles cannot have to others.
  void SpreadAll(std::vector<std::string>& notes)
  {
    int moved = 0;
    const std::vector<int> before = this->Target.Indices;
    for (Index t = 0; t < static_cast<Index>(before.size()); ++t)
    {
      if (before[t] != 0 && this->IsFront(t) && !CanHaveIndex(before[t], this->Holonomy(t)))
      {
        moved += this->SpreadFrom(t);
      }
    }
    if (moved > 0)
    {
      notes.push_back(std::to_string(moved) +
        " units of index were moved to triangles nearby, since a triangle can hardly carry more than one. "
        "Give singularities of index +1 or -1 in triangles of their own to choose where.");
    }
  }

  int SpreadFrom(Index from)
  {
    int& index = this->Target.Indices[from];
    const int sign = index > 0 ? 1 : -1;
    int left = 0;
    while (index != 0 && !CanHaveIndex(index, this->Holonomy(from)))
    {
      index -= sign;
      ++left;
    }
    const int moved = left;
    if (this->Blocked.empty())
    {
      this->Blocked.assign(this->Component.Vertices(), 0);
      for (Index t = 0; t < static_cast<Index>(this->Target.Indices.size()); ++t)
      {
        if (this->Target.Indices[t] != 0)
        {
          this->Block(t);
        }
      }
    }
    left = this->TakeNearest(from, sign, left, true);
    left = this->TakeNearest(from, sign, left, false);
    // Indices that no triangle takes stay here; the note on wrong triangles mentions them.
    index += sign * left;
    return moved - left;
  }

  /// Gives the triangles that are nearest over edges an index each.
  /// @param apart whether to keep a ring of triangles between singularities
  /// @return the number that is left over
  int TakeNearest(Index from, int sign, int count, bool apart)
  {
    std::vector<char> isSeen(this->Component.Triangles(), 0);
    std::vector<Index> queue = { from };
    isSeen[from] = 1;
    for (std::size_t k = 0; k < queue.size() && count > 0; ++k)
    {
      if (this->IsPlaceFor(queue[k], sign, apart))
      {
        this->Target.Indices[queue[k]] += sign;
        this->Block(queue[k]);
        --count;
      }
      for (int c = 0; c < 3; ++c)
      {
        const Index h = 3 * (this->Component.FirstTriangle + queue[k]) + c;
        const Index twin = this->Mesh.Twin(h);
        if (twin != None && !isSeen[this->Local(twin / 3)] &&
          !this->Rotation.GetConstrained().IsFixed(this->Mesh.Edge(h) - this->Component.FirstEdge))
        {
          isSeen[this->Local(twin / 3)] = 1;
          queue.push_back(this->Local(twin / 3));
        }
      }
    }
    return count;
  }

  bool IsPlaceFor(Index localTriangle, int sign, bool apart) const
  {
    if (!this->IsFront(localTriangle) || this->Target.Indices[localTriangle] != 0 ||
      !CanHaveIndex(sign, this->Holonomy(localTriangle)))
    {
      return false;
    }
    for (int c = 0; c < 3 && apart; ++c)
    {
      if (this->Blocked[this->TailOf(localTriangle, c) - this->Component.FirstVertex])
      {
        return false;
      }
    }
    return true;
  }

  /// Lets no other singularity come to a triangle's corners and their neighbours.
  void Block(Index localTriangle)
  {
    std::vector<Index> fan;
    for (int c = 0; c < 3; ++c)
    {
      const Index vertex = this->TailOf(localTriangle, c);
      this->Blocked[vertex - this->Component.FirstVertex] = 1;
      this->Mesh.GetFan(vertex, fan);
      for (const Index h : fan)
      {
        this->Blocked[this->Mesh.Head(h) - this->Component.FirstVertex] = 1;
        this->Blocked[this->Mesh.Tail(TriangleMesh::Previous(h)) - this->Component.FirstVertex] = 1;
      }
    }
  }

  /// Singularities are the same on both sides of a cover.
  void Mirror()
  {
    if (!this->Component.IsCover)
    {
      return;
    }
    const std::vector<int> base = this->Target.Indices;
    for (Index t = 0; t < static_cast<Index>(base.size()); ++t)
    {
      const Index mirror = this->Mesh.Mirror(3 * (this->Component.FirstTriangle + t)) / 3;
      if (this->IsFront(t))
      {
        this->Target.Indices[this->Local(mirror)] = base[t];
      }
    }
    const std::size_t places = this->Target.Places.size();
    for (std::size_t k = 0; k < places; ++k)
    {
      const MeshPlace& place = this->Target.Places[k];
      MeshPlace mirrored;
      for (int c = 0; c < 3; ++c)
      {
        // A half-edge seen from the other side runs the other way: its tail is the head there.
        const Index h = TriangleMesh::Next(this->Mesh.Mirror(3 * place.Triangle + c));
        mirrored.Triangle = h / 3;
        mirrored.Weights[h % 3] = place.Weights[c];
      }
      this->Target.Places.push_back(mirrored);
    }
  }

  const IntrinsicGeometry& Geometry;
  const TriangleMesh& Mesh;
  const TriangleMesh::Component& Component;
  int Degree;
  const TrivialConnection& Rotation;
  const std::vector<Vector3>& Positions;
  RotationTarget Target;
  /// The vertices that no triangle may have which gets a singularity; empty as long as nothing is
  /// moved.
  std::vector<char> Blocked;
};
}

RotationTarget MakeTarget(const IntrinsicGeometry& geometry,
  const TriangleMesh::Component& component, int degree, const TrivialConnection& rotation,
  const std::vector<Vector3>& positions, const std::vector<PrescribedSingularity>& singularities,
  const EditOptions& options, std::vector<std::string>& notes)
{
  return TargetBuilder(geometry, component, degree, rotation, positions)
    .Build(singularities, options, notes);
}
}
