// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Unfolding/MapFolds.h"

#include "Unfolding/ConeOpening.h"
#include "Unfolding/PatchUnfolding.h"

#include "Support/Threads.h"

#include <algorithm>
#include <thread>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace DirectionFields::Internal
{
namespace
{
/// How far around flipped triangles vertices move, and how far around cones they are laid anew
/// before, in edges of the grid; tried one after the other.
struct Attempt
{
  double Width;
  double Opening;
};
constexpr std::array<Attempt, 2> Attempts = { Attempt{ 1.0, 0.0 }, { 2.0, 1.2 } };
/// A map without folds covers no more than this many times the area of a patch with folds, or of
/// its triangles in space.
constexpr double MostCovered = 1.5;
/// Rings of vertices that move at least.
constexpr int LeastRings = 3;

std::vector<Index> FindFlipped(const MovablePlaces& places)
{
  std::vector<Index> flipped;
  for (Index t = 0; t < static_cast<Index>(places.Mesh.Triangles.size()); ++t)
  {
    if (places.IsFlipped(t))
    {
      flipped.push_back(t);
    }
  }
  return flipped;
}

/// The vertices within about a distance of triangles, along edges.
class Surroundings
{
public:
  Surroundings(const MovablePlaces& places, const std::vector<Index>& triangles, double width)
    : Places(places)
  {
    for (const Index t : triangles)
    {
      for (const Index v : places.Mesh.Triangles[t].Vertex)
      {
        if (this->Reach.emplace(v, Left{ width, LeastRings }).second)
        {
          this->Vertices.push_back(v);
        }
      }
    }
    for (std::size_t k = 0; k < this->Vertices.size(); ++k)
    {
      this->GoOn(this->Vertices[k]);
    }
  }

  /// The vertices that are connected to each other.
  std::vector<std::vector<Index>> Split()
  {
    std::vector<std::vector<Index>> patches;
    for (const Index seed : this->Vertices)
    {
      if (this->Reach.erase(seed) == 0)
      {
        continue;
      }
      std::vector<Index> patch(1, seed);
      for (std::size_t k = 0; k < patch.size(); ++k)
      {
        for (const Index t : this->Places.TrianglesAt(patch[k]))
        {
          for (const Index v : this->Places.Mesh.Triangles[t].Vertex)
          {
            if (this->Reach.erase(v) > 0)
            {
              patch.push_back(v);
            }
          }
        }
      }
      patches.push_back(std::move(patch));
    }
    return patches;
  }

private:
  struct Left
  {
    double Distance;
    int Rings;
  };

  void GoOn(Index from)
  {
    const Left left = this->Reach.at(from);
    const std::vector<Vector3>& positions = this->Places.Mesh.Positions;
    for (const Index t : this->Places.TrianglesAt(from))
    {
      for (const Index v : this->Places.Mesh.Triangles[t].Vertex)
      {
        const double distance =
          left.Distance - (positions[v] - positions[from]).norm() * this->Places.PerLength[from];
        if ((distance > 0.0 || left.Rings > 0) &&
          this->Reach.emplace(v, Left{ std::max(0.0, distance), left.Rings - 1 }).second)
        {
          this->Vertices.push_back(v);
        }
      }
    }
  }

  const MovablePlaces& Places;
  std::unordered_map<Index, Left> Reach;
  std::vector<Index> Vertices;
};

/// The vertices that move, the triangles at them and their corners.
struct Patch
{
  Patch(const MovablePlaces& places, std::vector<Index>&& vertices)
    : Vertices(std::move(vertices))
  {
    std::sort(this->Vertices.begin(), this->Vertices.end());
    for (const Index v : this->Vertices)
    {
      const MovablePlaces::Triangles around = places.TrianglesAt(v);
      this->Triangles.insert(this->Triangles.end(), around.begin(), around.end());
    }
    MakeUnique(this->Triangles);
    for (const Index t : this->Triangles)
    {
      const Triangle& vertex = places.Mesh.Triangles[t].Vertex;
      this->Corners.insert(this->Corners.end(), vertex.begin(), vertex.end());
    }
    MakeUnique(this->Corners);
  }

  static void MakeUnique(std::vector<Index>& numbers)
  {
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  }

  std::vector<Index> Vertices;
  std::vector<Index> Triangles;
  std::vector<Index> Corners;
};

/// What is wrong with a map within a patch, the worse for a mesh the earlier.
struct Folds
{
  Folds(const MovablePlaces& places, const Patch& patch)
  {
    for (const Index v : patch.Corners)
    {
      if (!places.IsSurrounded(v))
      {
        const MovablePlaces::Triangles around = places.TrianglesAt(v);
        const bool isFold =
          std::any_of(around.begin(), around.end(), [&](Index t) { return places.IsFlipped(t); });
        this->Branches += isFold ? 0 : 1;
        ++this->WrongAngles;
      }
    }
    for (const Index t : patch.Triangles)
    {
      this->Flipped += places.IsFlipped(t) ? 1 : 0;
      this->Covered += std::max(0.0, places.AreaInMap(t));
    }
  }

  bool AreLessThan(const Folds& others) const
  {
    return std::tie(this->Branches, this->WrongAngles, this->Flipped) <
      std::tie(others.Branches, others.WrongAngles, others.Flipped);
  }

  /// How many vertices the map goes around by a wrong angle.
  Index WrongAngles = 0;
  /// How many of them have no flipped triangle.
  Index Branches = 0;
  Index Flipped = 0;
  double Covered = 0.0;
};

/// Whether a map without folds is worth it: the mesh would have many more faces where the vertices
/// have to go far.
bool IsWorthIt(
  const MovablePlaces& places, const Patch& patch, const Folds& before, const Folds& after)
{
  double inSpace = 0.0;
  for (const Index t : patch.Triangles)
  {
    inSpace += places.AreaInSpace(t);
  }
  return after.AreLessThan(before) &&
    after.Covered < MostCovered * std::max(before.Covered, inSpace);
}

/// How far a cone may be opened, in edges of the grid: not so far that another one is undone.
double OpeningOf(const MovablePlaces& places, const Patch& patch, Index cone, double most)
{
  double radius = most;
  for (const Index v : patch.Corners)
  {
    if (v != cone && places.IsInTriangle(v))
    {
      radius = std::min(radius,
        0.5 * places.PerLength[cone] *
          (places.Mesh.Positions[v] - places.Mesh.Positions[cone]).norm());
    }
  }
  return radius;
}

void Unfold(MovablePlaces& places, const Patch& patch, double opening, const Progress& progress)
{
  const Folds before(places, patch);
  std::vector<GridPoint> former;
  for (const Index v : patch.Vertices)
  {
    former.push_back(places.Places[v]);
  }
  for (const Index v : patch.Vertices)
  {
    if (places.IsInTriangle(v) && !places.IsSurrounded(v))
    {
      OpenCone(places, v, patch.Vertices, patch.Corners, OpeningOf(places, patch, v, opening));
    }
  }
  UnfoldPatch(places, patch.Vertices, patch.Triangles, progress);
  if (!IsWorthIt(places, patch, before, Folds(places, patch)))
  {
    for (std::size_t k = 0; k < former.size(); ++k)
    {
      places.Places[patch.Vertices[k]] = former[k];
    }
  }
}

/// Patches in groups that do not touch: none has a corner in common with a patch of another group,
/// and what is at other places makes no difference to it. Larger groups are first.
std::vector<std::vector<std::size_t>> GroupsOf(const std::vector<Patch>& patches)
{
  std::vector<std::size_t> first(patches.size());
  const auto rootOf = [&](std::size_t k)
  {
    while (first[k] != k)
    {
      k = first[k] = first[first[k]];
    }
    return k;
  };
  std::unordered_map<Index, std::size_t> patchAt;
  for (std::size_t k = 0; k < patches.size(); ++k)
  {
    first[k] = k;
    for (const Index v : patches[k].Corners)
    {
      const std::size_t a = rootOf(patchAt.emplace(v, k).first->second);
      const std::size_t b = rootOf(k);
      first[std::max(a, b)] = std::min(a, b);
    }
  }
  std::vector<std::vector<std::size_t>> groups(patches.size());
  std::vector<std::size_t> triangles(patches.size(), 0);
  for (std::size_t k = 0; k < patches.size(); ++k)
  {
    groups[rootOf(k)].push_back(k);
    triangles[rootOf(k)] += patches[k].Triangles.size();
  }
  std::stable_sort(groups.begin(), groups.end(),
    [&](const std::vector<std::size_t>& a, const std::vector<std::size_t>& b)
    { return (a.empty() ? 0 : triangles[a[0]]) > (b.empty() ? 0 : triangles[b[0]]); });
  groups.erase(std::find_if(groups.begin(), groups.end(),
                 [](const std::vector<std::size_t>& group) { return group.empty(); }),
    groups.end());
  return groups;
}
}

void UnfoldTriangles(MovablePlaces& places, const Progress& progress)
{
  const std::thread::id asker = std::this_thread::get_id();
  for (const auto [width, opening] : Attempts)
  {
    std::vector<Patch> patches;
    for (std::vector<Index>& vertices : Surroundings(places, FindFlipped(places), width).Split())
    {
      patches.emplace_back(places, std::move(vertices));
    }
    const std::vector<std::vector<std::size_t>> groups = GroupsOf(patches);
    Threads::Run(static_cast<Index>(groups.size()),
      [&, opening = opening](Index group)
      {
        // Only the calling thread may ask whether to go on.
        const Progress part = std::this_thread::get_id() == asker ? progress : Progress();
        for (const std::size_t k : groups[group])
        {
          part.RequireToGoOn();
          Unfold(places, patches[k], opening, part);
        }
      });
  }
}
}
