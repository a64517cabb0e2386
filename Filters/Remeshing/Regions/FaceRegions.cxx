// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Regions/FaceRegions.h"

#include <algorithm>
#include <map>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// A part of the area of enclosed faces that decides for all of them.
constexpr double Decisive = 0.95;

std::array<Index, 2> EndsOf(Index a, Index b)
{
  return { std::min(a, b), std::max(a, b) };
}

/// The faces on the other side of each side of a face that is no border.
class OpenSides
{
public:
  OpenSides(const FaceMesh& mesh, const std::vector<char>& isBorder)
    : Corners(mesh.Cells.Corners)
  {
    for (const FaceMesh::LineEdge& edge : mesh.LineEdges)
    {
      if (edge.Line > 0 && isBorder[edge.Line] != 0)
      {
        this->Borders.push_back(EndsOf(edge.Ends[0], edge.Ends[1]));
      }
    }
    std::sort(this->Borders.begin(), this->Borders.end());
    for (std::size_t f = 0; f < this->Corners.size(); ++f)
    {
      const int size = Faces::Size(this->Corners[f]);
      for (int c = 0; c < size; ++c)
      {
        this->Sides.push_back(
          { EndsOf(this->Corners[f][c], this->Corners[f][(c + 1) % size]), static_cast<Index>(f) });
      }
    }
    std::sort(this->Sides.begin(), this->Sides.end());
  }

  template <typename Visit>
  void ForNeighbours(Index face, const Visit& visit) const
  {
    const int size = Faces::Size(this->Corners[face]);
    for (int c = 0; c < size; ++c)
    {
      const std::array<Index, 2> ends =
        EndsOf(this->Corners[face][c], this->Corners[face][(c + 1) % size]);
      if (std::binary_search(this->Borders.begin(), this->Borders.end(), ends))
      {
        continue;
      }
      auto first = std::lower_bound(this->Sides.begin(), this->Sides.end(), Side{ ends, 0 });
      auto last = first;
      while (last != this->Sides.end() && last->first == ends)
      {
        ++last;
      }
      // Where more than two sheets meet, each ends.
      for (; last - first == 2 && first != last; ++first)
      {
        if (first->second != face)
        {
          visit(first->second);
          break;
        }
      }
    }
  }

private:
  using Side = std::pair<std::array<Index, 2>, Index>;
  const std::vector<Faces::Face>& Corners;
  std::vector<std::array<Index, 2>> Borders;
  std::vector<Side> Sides;
};
}

std::vector<Index> RegionsOfFaces(const FaceMesh& mesh, const std::vector<Index>& regions,
  const std::vector<Index>& closest, const std::vector<char>& isBorder)
{
  const OpenSides sides(mesh, isBorder);
  const auto count = static_cast<Index>(mesh.Cells.Corners.size());
  std::vector<Index> region(count);
  std::vector<char> isSeen(count, 0);
  for (Index start = 0; start < count; ++start)
  {
    if (isSeen[start] != 0)
    {
      continue;
    }
    std::vector<Index> patch = { start };
    isSeen[start] = 1;
    std::map<Index, double> area;
    double whole = 0.0;
    for (std::size_t k = 0; k < patch.size(); ++k)
    {
      const Index f = patch[k];
      const double own = AreaOf(mesh.Points, mesh.Cells.Corners[f]);
      area[regions[closest[f]]] += own;
      whole += own;
      sides.ForNeighbours(f,
        [&](Index g)
        {
          if (isSeen[g] == 0)
          {
            isSeen[g] = 1;
            patch.push_back(g);
          }
        });
    }
    const auto largest = std::max_element(
      area.begin(), area.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    const bool isDecided = largest->second >= Decisive * whole;
    for (const Index f : patch)
    {
      region[f] = isDecided ? largest->first : regions[closest[f]];
    }
  }
  return region;
}

void FindInRegions(const PreparedSurface& surface, const FaceMesh& mesh,
  const std::vector<Index>& regions, const std::vector<Index>& ofFaces, std::vector<Index>& closest)
{
  std::map<Index, std::vector<Index>> facesOf;
  for (std::size_t f = 0; f < ofFaces.size(); ++f)
  {
    if (regions[closest[f]] != ofFaces[f])
    {
      facesOf[ofFaces[f]].push_back(static_cast<Index>(f));
    }
  }
  if (facesOf.empty())
  {
    return;
  }
  const std::vector<ClosestPoints::Corners> all = surface.GetTriangles();
  std::map<Index, std::vector<Index>> trianglesOf;
  for (std::size_t t = 0; t < all.size(); ++t)
  {
    const auto found = facesOf.find(regions[surface.InputTriangle(static_cast<Index>(t))]);
    if (found != facesOf.end())
    {
      trianglesOf[found->first].push_back(static_cast<Index>(t));
    }
  }
  for (const auto& [region, triangles] : trianglesOf)
  {
    std::vector<ClosestPoints::Corners> own;
    own.reserve(triangles.size());
    for (const Index t : triangles)
    {
      own.push_back(all[t]);
    }
    const ClosestPoints places(std::move(own));
    for (const Index f : facesOf[region])
    {
      const ClosestPoints::Answer at = places.Find(MiddleOf(mesh.Points, mesh.Cells.Corners[f]));
      closest[f] = at.Triangle != None ? surface.InputTriangle(triangles[at.Triangle]) : closest[f];
    }
  }
}
}
