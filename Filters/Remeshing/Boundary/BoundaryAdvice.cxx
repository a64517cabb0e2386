// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Boundary/BoundaryAdvice.h"

#include "Support/Sentences.h"
#include "Support/SortedEnds.h"

#include <algorithm>
#include <map>

namespace DirectionFields::Internal
{
namespace
{
/// The first vertex of the component that each vertex is in.
class Components
{
public:
  explicit Components(const FaceMesh& mesh)
    : First(mesh.Points.size())
  {
    for (std::size_t v = 0; v < this->First.size(); ++v)
    {
      this->First[v] = static_cast<Index>(v);
    }
    for (const Faces::Face& face : mesh.Cells.Corners)
    {
      for (int c = 1; c < Faces::Size(face); ++c)
      {
        const Index a = this->Of(face[0]);
        const Index b = this->Of(face[c]);
        this->First[std::max(a, b)] = std::min(a, b);
      }
    }
  }

  Index Of(Index v)
  {
    while (this->First[v] != v)
    {
      this->First[v] = this->First[this->First[v]];
      v = this->First[v];
    }
    return v;
  }

private:
  std::vector<Index> First;
};

/// The number of components whose boundary has an odd number of edges.
Index CountOdd(const FaceMesh& mesh)
{
  std::map<std::array<Index, 2>, int> times;
  for (const Faces::Face& face : mesh.Cells.Corners)
  {
    const int size = Faces::Size(face);
    for (int c = 0; c < size; ++c)
    {
      const Index a = face[c];
      const Index b = face[(c + 1) % size];
      ++times[SortedEnds(a, b)];
    }
  }
  Components components(mesh);
  std::map<Index, int> edges;
  for (const auto& [ends, faces] : times)
  {
    edges[components.Of(ends[0])] += faces == 1 ? 1 : 0;
  }
  return static_cast<Index>(std::count_if(
    edges.begin(), edges.end(), [](const auto& item) { return item.second % 2 != 0; }));
}
}

std::vector<std::string> BoundaryAdvice(
  const FaceMesh& mesh, const BoundaryFigures& figures, BoundarySpacing spacing, Index triangles)
{
  std::vector<std::string> sentences;
  if (spacing != BoundarySpacing::Free && figures.Points == 0)
  {
    sentences.push_back(
      "The surface has no boundary: Boundary Spacing changes nothing. Set it to Free.");
  }
  const bool isKept = spacing == BoundarySpacing::Keep;
  const auto number = static_cast<std::size_t>(triangles);
  if (triangles > 0 && isKept && triangles <= CountOdd(mesh))
  {
    sentences.push_back(Count(number, "triangle") + (number == 1 ? " is" : " are") +
      " left among the quads, one in each component whose boundary has an odd number of edges, "
      "which quads alone cannot have. Add or remove a point of the boundary there, or do not keep "
      "its points.");
  }
  else if (triangles > 0)
  {
    sentences.push_back(Count(number, "triangle") + (number == 1 ? " is" : " are") +
      " left among the quads, since the faces between features there are too few to be joined. "
      "More faces, or a larger Feature Angle, would do.");
  }
  const Index missing = figures.Points - figures.Kept;
  if (isKept && (missing > 0 || figures.Others > 0))
  {
    sentences.push_back("The boundary of the mesh is not that of the surface: " +
      Count(static_cast<std::size_t>(missing), "point") + " of it are no vertices, and " +
      Count(static_cast<std::size_t>(figures.Others), "vertex", "vertices") +
      " are none of its points, since the faces there are too few or the surface is narrower than "
      "a face. More faces, or shorter edges, would do.");
  }
  return sentences;
}
}
