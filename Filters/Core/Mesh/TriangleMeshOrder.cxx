// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/TriangleMesh.h"

#include "Support/MortonCurve.h"
#include "Support/RadixSort.h"
#include "Support/Threads.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

namespace DirectionFields
{
namespace
{
/// Triangles, vertices or half-edges that a thread takes at a time.
constexpr Index PieceSize = 1 << 13;
}

/// Orders the components by their first triangles in the input.
void TriangleMesh::OrderComponents()
{
  const Index triangles = this->GetNumberOfTriangles();
  const auto components = static_cast<Index>(this->Components.size());
  LargeArray<Keyed<std::uint32_t>> first(components);
  for (Index c = 0; c < components; ++c)
  {
    first[c] = { std::numeric_limits<std::uint32_t>::max(), c };
  }
  std::uint32_t last = 0;
  for (Index t = 0; t < triangles; ++t)
  {
    const auto input = static_cast<std::uint32_t>(this->TriangleInput[t]);
    std::uint32_t& least = first[this->TriangleComponent[t]].Value;
    least = std::min(least, input);
    last = std::max(last, input);
  }
  RadixSort(first, BitsBelow(static_cast<Index>(last) + 1));
  LargeArray<Index> place(components);
  for (Index c = 0; c < components; ++c)
  {
    place[first[c].Item] = c;
  }
  for (Index& component : this->TriangleComponent)
  {
    component = place[component];
  }
}

/// Sorts the vertices of each component along a Morton curve of its own, so that no other component
/// has a say in it.
void TriangleMesh::SortVertices(const std::vector<Vector3>& points)
{
  const Index vertices = this->GetNumberOfVertices();
  const auto components = static_cast<Index>(this->Components.size());
  LargeArray<Index> component(vertices);
  LargeArray<Index> begin(components + 1, 0);
  for (Index v = 0; v < vertices; ++v)
  {
    component[v] = this->TriangleComponent[this->VertexHalfEdge[v] / 3];
    ++begin[component[v] + 1];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  for (Index c = 0; c < components; ++c)
  {
    this->Components[c].FirstVertex = begin[c];
    this->Components[c].EndVertex = begin[c + 1];
  }
  const LargeArray<Index> order =
    MortonCurve::SortedInGroups(points, this->VertexPoint, component, components);

  LargeArray<Index> number(vertices);
  const LargeArray<Index> pointOf = std::move(this->VertexPoint);
  const LargeArray<Index> halfEdgeOf = std::move(this->VertexHalfEdge);
  this->VertexPoint.resize(vertices);
  this->VertexHalfEdge.resize(vertices);
  ParallelFor(vertices, PieceSize,
    [&](Index first, Index last)
    {
      for (Index v = first; v < last; ++v)
      {
        number[order[v]] = v;
        this->VertexPoint[v] = pointOf[order[v]];
        this->VertexHalfEdge[v] = halfEdgeOf[order[v]];
      }
    });
  ParallelFor(this->GetNumberOfHalfEdges(), PieceSize,
    [&](Index first, Index last)
    {
      for (Index h = first; h < last; ++h)
      {
        this->Corners[h] = number[this->Corners[h]];
      }
    });
}

/// Sorts the triangles by their lowest vertices, and so by component.
void TriangleMesh::SortTriangles()
{
  const Index triangles = this->GetNumberOfTriangles();
  LargeArray<Keyed<std::uint32_t>> order(triangles);
  LargeArray<Index> begin(this->Components.size() + 1, 0);
  Index last = 0;
  for (Index t = 0; t < triangles; ++t)
  {
    order[t] = { static_cast<std::uint32_t>(this->TriangleInput[t]), t };
    last = std::max(last, this->TriangleInput[t]);
    ++begin[this->TriangleComponent[t] + 1];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  for (std::size_t c = 0; c < this->Components.size(); ++c)
  {
    this->Components[c].FirstTriangle = begin[c];
    this->Components[c].EndTriangle = begin[c + 1];
  }
  RadixSort(order, BitsBelow(last + 1));
  for (Keyed<std::uint32_t>& triangle : order)
  {
    const auto corner = this->Corners.begin() + 3 * triangle.Item;
    triangle.Value = static_cast<std::uint32_t>(*std::min_element(corner, corner + 3));
  }
  RadixSort(order, BitsBelow(this->GetNumberOfVertices()));

  LargeArray<Index> number(triangles);
  for (Index t = 0; t < triangles; ++t)
  {
    number[order[t].Item] = t;
  }
  const auto renumbered = [&number](Index h) { return 3 * number[h / 3] + h % 3; };
  const LargeArray<Index> corners = std::move(this->Corners);
  const LargeArray<Index> twins = std::move(this->Twins);
  const LargeArray<Index> input = std::move(this->TriangleInput);
  const std::vector<char> crowded = std::move(this->Crowded);
  this->Corners.resize(corners.size());
  this->Twins.resize(twins.size());
  this->TriangleInput.resize(input.size());
  this->Crowded.resize(crowded.size());
  ParallelFor(triangles, PieceSize,
    [&](Index first, Index end)
    {
      for (Index t = first; t < end; ++t)
      {
        this->TriangleInput[t] = input[order[t].Item];
        for (Index c = 0; c < 3; ++c)
        {
          const Index h = 3 * order[t].Item + c;
          this->Corners[3 * t + c] = corners[h];
          this->Twins[3 * t + c] = twins[h] == None ? None : renumbered(twins[h]);
          if (!crowded.empty())
          {
            this->Crowded[3 * t + c] = crowded[h];
          }
        }
      }
    });
  if (!this->Images.empty())
  {
    const LargeArray<Index> images = std::move(this->Images);
    const std::vector<char> isBack = std::move(this->IsBack);
    this->Images.resize(images.size());
    this->IsBack.resize(isBack.size());
    for (Index t = 0; t < triangles; ++t)
    {
      const Index image = images[order[t].Item];
      this->Images[t] = image == None ? None : number[image];
      this->IsBack[t] = isBack[order[t].Item];
    }
  }
  ParallelFor(this->GetNumberOfVertices(), PieceSize,
    [&](Index first, Index end)
    {
      for (Index v = first; v < end; ++v)
      {
        this->VertexHalfEdge[v] = this->FindFan(renumbered(this->VertexHalfEdge[v])).First;
      }
    });
}
}
