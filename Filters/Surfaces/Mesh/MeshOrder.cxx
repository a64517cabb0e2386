// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/MeshOrder.h"

#include "Support/MortonCurve.h"
#include "Support/Threads.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace DirectionFields::Internal
{
Fan FindFan(const TriangleMesh& mesh, Index start)
{
  Fan fan{ start, 0 };
  Index h = start;
  do
  {
    ++fan.Corners;
    fan.First = std::min(fan.First, h);
    h = mesh.NextOutgoing(h);
  } while (h != None && h != start);
  if (h == None)
  {
    for (h = start; mesh.Twin(h) != None; ++fan.Corners)
    {
      h = TriangleMesh::Next(mesh.Twin(h));
    }
    fan.First = h;
  }
  return fan;
}

void MeshOrder::Sort(const std::vector<Vector3>& points)
{
  this->OrderComponents();
  this->SortVertices(points);
  this->SortTriangles();
}

void MeshOrder::OrderComponents()
{
  const Index triangles = this->Mesh.GetNumberOfTriangles();
  const auto components = static_cast<Index>(this->Mesh.Components.size());
  LargeArray<Keyed<std::uint32_t>> first(components);
  for (Index c = 0; c < components; ++c)
  {
    first[c] = { std::numeric_limits<std::uint32_t>::max(), c };
  }
  std::uint32_t last = 0;
  for (Index t = 0; t < triangles; ++t)
  {
    const auto input = static_cast<std::uint32_t>(this->Mesh.TriangleInput[t]);
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

void MeshOrder::SortVertices(const std::vector<Vector3>& points)
{
  TriangleMesh& mesh = this->Mesh;
  const Index vertices = mesh.GetNumberOfVertices();
  const auto components = static_cast<Index>(mesh.Components.size());
  LargeArray<Index> component(vertices);
  LargeArray<Index> begin(components + 1, 0);
  for (Index v = 0; v < vertices; ++v)
  {
    component[v] = this->TriangleComponent[mesh.VertexHalfEdge[v] / 3];
    ++begin[component[v] + 1];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  for (Index c = 0; c < components; ++c)
  {
    mesh.Components[c].FirstVertex = begin[c];
    mesh.Components[c].EndVertex = begin[c + 1];
  }
  const LargeArray<Index> order =
    MortonCurve::SortedInGroups(points, mesh.VertexPoint, component, components);

  LargeArray<Index> number(vertices);
  const LargeArray<Index> pointOf = std::move(mesh.VertexPoint);
  const LargeArray<Index> halfEdgeOf = std::move(mesh.VertexHalfEdge);
  mesh.VertexPoint.resize(vertices);
  mesh.VertexHalfEdge.resize(vertices);
  ParallelFor(vertices, LightPiece,
    [&](Index first, Index last)
    {
      for (Index v = first; v < last; ++v)
      {
        number[order[v]] = v;
        mesh.VertexPoint[v] = pointOf[order[v]];
        mesh.VertexHalfEdge[v] = halfEdgeOf[order[v]];
      }
    });
  ParallelFor(mesh.GetNumberOfHalfEdges(), LightPiece,
    [&](Index first, Index last)
    {
      for (Index h = first; h < last; ++h)
      {
        mesh.Corners[h] = number[mesh.Corners[h]];
      }
    });
}

void MeshOrder::SortTriangles()
{
  TriangleMesh& mesh = this->Mesh;
  const Index triangles = mesh.GetNumberOfTriangles();
  this->CountTriangles();
  LargeArray<Keyed<std::uint32_t>> sorted(triangles);
  Index last = 0;
  for (Index t = 0; t < triangles; ++t)
  {
    sorted[t] = { static_cast<std::uint32_t>(mesh.TriangleInput[t]), t };
    last = std::max(last, mesh.TriangleInput[t]);
  }
  RadixSort(sorted, BitsBelow(last + 1));
  for (Keyed<std::uint32_t>& triangle : sorted)
  {
    const auto corner = mesh.Corners.begin() + 3 * triangle.Item;
    triangle.Value = static_cast<std::uint32_t>(*std::min_element(corner, corner + 3));
  }
  RadixSort(sorted, BitsBelow(mesh.GetNumberOfVertices()));
  LargeArray<Index> number(triangles);
  for (Index t = 0; t < triangles; ++t)
  {
    number[sorted[t].Item] = t;
  }
  this->MoveTriangles(sorted, number);
  ParallelFor(mesh.GetNumberOfVertices(), LightPiece,
    [&](Index first, Index end)
    {
      for (Index v = first; v < end; ++v)
      {
        const Index h = mesh.VertexHalfEdge[v];
        mesh.VertexHalfEdge[v] = FindFan(mesh, 3 * number[h / 3] + h % 3).First;
      }
    });
}

void MeshOrder::CountTriangles()
{
  std::vector<TriangleMesh::Component>& components = this->Mesh.Components;
  LargeArray<Index> begin(components.size() + 1, 0);
  for (const Index component : this->TriangleComponent)
  {
    ++begin[component + 1];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    components[c].FirstTriangle = begin[c];
    components[c].EndTriangle = begin[c + 1];
  }
}

void MeshOrder::MoveTriangles(
  const LargeArray<Keyed<std::uint32_t>>& order, const LargeArray<Index>& number)
{
  TriangleMesh& mesh = this->Mesh;
  const auto triangles = static_cast<Index>(order.size());
  const auto renumbered = [&number](Index h) { return 3 * number[h / 3] + h % 3; };
  const LargeArray<Index> corners = std::move(mesh.Corners);
  const LargeArray<Index> twins = std::move(mesh.Twins);
  const LargeArray<Index> input = std::move(mesh.TriangleInput);
  const std::vector<char> nonManifold = std::move(mesh.NonManifold);
  mesh.Corners.resize(corners.size());
  mesh.Twins.resize(twins.size());
  mesh.TriangleInput.resize(input.size());
  mesh.NonManifold.resize(nonManifold.size());
  ParallelFor(triangles, LightPiece,
    [&](Index first, Index end)
    {
      for (Index t = first; t < end; ++t)
      {
        mesh.TriangleInput[t] = input[order[t].Item];
        for (Index c = 0; c < 3; ++c)
        {
          const Index h = 3 * order[t].Item + c;
          mesh.Corners[3 * t + c] = corners[h];
          mesh.Twins[3 * t + c] = twins[h] == None ? None : renumbered(twins[h]);
          if (!nonManifold.empty())
          {
            mesh.NonManifold[3 * t + c] = nonManifold[h];
          }
        }
      }
    });
  if (!mesh.Mirrors.empty())
  {
    const LargeArray<Index> mirrors = std::move(mesh.Mirrors);
    const std::vector<char> isBack = std::move(mesh.IsBack);
    mesh.Mirrors.resize(mirrors.size());
    mesh.IsBack.resize(isBack.size());
    for (Index t = 0; t < triangles; ++t)
    {
      const Index mirror = mirrors[order[t].Item];
      mesh.Mirrors[t] = mirror == None ? None : number[mirror];
      mesh.IsBack[t] = isBack[order[t].Item];
    }
  }
}
}
