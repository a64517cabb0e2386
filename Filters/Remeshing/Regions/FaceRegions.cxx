// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Regions/FaceRegions.h"

#include "FaceMesh/VertexStars.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// A part of the area of enclosed faces that decides for all of them.
constexpr double Decisive = 0.95;

/// The faces, with lines where borders are.
VertexStars WithBorders(const FaceMesh& mesh, const std::vector<char>& isBorder)
{
  std::vector<FaceMesh::LineEdge> borders;
  std::copy_if(mesh.LineEdges.begin(), mesh.LineEdges.end(), std::back_inserter(borders),
    [&](const FaceMesh::LineEdge& edge) { return edge.Line > 0 && isBorder[edge.Line] != 0; });
  return { mesh.Cells, static_cast<Index>(mesh.Points.size()), borders };
}

/// Calls visit(g) for the faces beside a face, but across borders.
template <typename Visit>
void ForNeighbours(const VertexStars& faces, Index f, const Visit& visit)
{
  const Faces::Face& face = faces.Face(f);
  const int size = Faces::Size(face);
  for (int c = 0; c < size; ++c)
  {
    const Index v = face[c];
    const Index w = face[(c + 1) % size];
    const Index g = faces.IsLineEdge(v, w) ? None : faces.Across(f, v, w);
    if (g != None)
    {
      visit(g);
    }
  }
}
}

std::vector<Index> RegionsOfFaces(const FaceMesh& mesh, const std::vector<Index>& regions,
  const std::vector<Index>& closest, const std::vector<char>& isBorder)
{
  const VertexStars faces = WithBorders(mesh, isBorder);
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
      ForNeighbours(faces, f,
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
