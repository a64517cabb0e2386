// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Components/MovedComponents.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <unordered_map>

namespace DirectionFields::Parallel
{
namespace
{
struct MovedTriangle
{
  vtkIdType Id;
  int Component;
  std::array<vtkIdType, 3> Corners;
};

struct MovedVertex
{
  vtkIdType Number;
  std::array<double, 3> Place;
  Complex Drawn = 0.0;
  Complex Value = 0.0;
  ConstraintKind Kind = ConstraintKind::None;
};

bool IsOwn(const PieceWithSurroundings& piece, Index inputTriangle)
{
  return inputTriangle < static_cast<Index>(piece.InputTriangle.size());
}

void AddTriangles(const DistributedMesh& mesh, const PieceWithSurroundings& piece, int component,
  std::vector<MovedTriangle>& moved)
{
  const TriangleMesh& triangles = mesh.GetMesh();
  for (const std::size_t c : mesh.PartsOf(component))
  {
    const TriangleMesh::Component& part = triangles.GetComponents()[c];
    for (Index t = part.FirstTriangle; t < part.EndTriangle; ++t)
    {
      const Index input = triangles.InputTriangle(t);
      if (IsOwn(piece, input))
      {
        MovedTriangle triangle{ piece.FirstTriangle + input, component, {} };
        for (int k = 0; k < 3; ++k)
        {
          triangle.Corners[k] = piece.Number[triangles.Point(triangles.Tail(3 * t + k))];
        }
        moved.push_back(triangle);
      }
    }
  }
}

/// Appends the owned vertices of a component, and what guides the field there.
void AddVertices(const DistributedMesh& mesh, const PieceWithSurroundings& piece,
  const DistributedGuide& guide, int component, std::vector<Index>& vertices,
  std::vector<MovedVertex>& moved)
{
  for (const std::size_t c : mesh.PartsOf(component))
  {
    const TriangleMesh::Component& part = mesh.GetMesh().GetComponents()[c];
    for (Index v = part.FirstVertex; v < part.EndVertex; ++v)
    {
      if (mesh.IsOwned(v))
      {
        MovedVertex vertex;
        vertex.Number = piece.Number[mesh.GetMesh().Point(v)];
        std::copy_n(mesh.GetGeometry().Positions[v].data(), 3, vertex.Place.data());
        vertex.Drawn = guide.IsDrawn ? guide.Drawn[v] : Complex(0.0);
        if (!guide.Kind.empty())
        {
          vertex.Kind = guide.Kind[v];
          vertex.Value = guide.Value[v];
        }
        vertices.push_back(v);
        moved.push_back(vertex);
      }
    }
  }
}

/// The triangles of all processes in the order of the whole surface. Gives back the memory of the
/// lists.
std::vector<MovedTriangle> InOrder(std::vector<std::vector<MovedTriangle>>& lists)
{
  std::size_t count = 0;
  for (const std::vector<MovedTriangle>& part : lists)
  {
    count += part.size();
  }
  std::vector<MovedTriangle> all;
  all.reserve(count);
  for (std::vector<MovedTriangle>& part : lists)
  {
    all.insert(all.end(), part.begin(), part.end());
    part = std::vector<MovedTriangle>();
  }
  std::sort(all.begin(), all.end(),
    [](const MovedTriangle& a, const MovedTriangle& b) { return a.Id < b.Id; });
  return all;
}

/// The surface of these triangles, with points as they come.
/// @param pointOf gets the point of each number
Surface SurfaceOf(const std::vector<MovedTriangle>& moved,
  const std::vector<std::vector<MovedVertex>>& vertices,
  std::unordered_map<vtkIdType, Index>& pointOf)
{
  Surface surface;
  surface.Triangles.reserve(moved.size());
  for (const MovedTriangle& triangle : moved)
  {
    Triangle corners;
    for (int k = 0; k < 3; ++k)
    {
      corners[k] =
        pointOf.try_emplace(triangle.Corners[k], static_cast<Index>(pointOf.size())).first->second;
    }
    surface.Triangles.push_back(corners);
  }
  surface.Points.resize(pointOf.size(), Vector3::Zero());
  for (const std::vector<MovedVertex>& part : vertices)
  {
    for (const MovedVertex& vertex : part)
    {
      surface.Points[pointOf.at(vertex.Number)] = Vector3(vertex.Place.data());
    }
  }
  return surface;
}
}

void MovedComponents::ChooseHomes(
  const Messages& messages, const DistributedMesh& mesh, const PieceWithSurroundings& piece)
{
  const auto components = static_cast<std::size_t>(mesh.CountComponents());
  std::vector<double> sizes(components, 0.0);
  std::vector<double> loads(static_cast<std::size_t>(messages.Count()), 0.0);
  const TriangleMesh& triangles = mesh.GetMesh();
  for (std::size_t component = 0; component < components; ++component)
  {
    for (const std::size_t c : mesh.PartsOf(static_cast<int>(component)))
    {
      const TriangleMesh::Component& part = triangles.GetComponents()[c];
      for (Index t = part.FirstTriangle; t < part.EndTriangle; ++t)
      {
        sizes[component] += IsOwn(piece, triangles.InputTriangle(t)) ? 1.0 : 0.0;
      }
    }
    if (mesh.ProcessOf(static_cast<int>(component)) == messages.Own())
    {
      loads[messages.Own()] += sizes[component];
    }
  }
  messages.Sum(sizes.data(), static_cast<int>(sizes.size()));
  messages.Sum(loads.data(), static_cast<int>(loads.size()));
  const double share =
    std::accumulate(sizes.begin(), sizes.end(), 0.0) / static_cast<double>(loads.size());
  this->Home.assign(components, -1);
  std::vector<int> moved;
  for (std::size_t component = 0; component < components; ++component)
  {
    const auto c = static_cast<int>(component);
    if (mesh.ProcessOf(c) < 0 && !mesh.IsCover(c) && sizes[component] <= share)
    {
      moved.push_back(static_cast<int>(component));
    }
  }
  // The largest first: then the last ones even out what the others left.
  std::stable_sort(moved.begin(), moved.end(), [&](int a, int b) { return sizes[a] > sizes[b]; });
  for (const int component : moved)
  {
    const auto least = std::min_element(loads.begin(), loads.end());
    *least += sizes[component];
    this->Home[component] = static_cast<int>(least - loads.begin());
  }
}

MovedComponents::MovedComponents(Processes& processes, const Messages& messages,
  const DistributedMesh& mesh, const PieceWithSurroundings& piece, const DistributedGuide& guide)
{
  this->ChooseHomes(messages, mesh, piece);
  const auto count = static_cast<std::size_t>(messages.Count());
  std::vector<std::vector<MovedTriangle>> triangles;
  std::vector<std::vector<MovedVertex>> vertices;
  processes.Together(
    [&]
    {
      triangles.resize(count);
      vertices.resize(count);
      this->Sent.resize(count);
      this->Received.resize(count);
      for (int component = 0; component < mesh.CountComponents(); ++component)
      {
        if (this->IsMoved(component))
        {
          const auto home = static_cast<std::size_t>(this->Home[component]);
          AddTriangles(mesh, piece, component, triangles[home]);
          AddVertices(mesh, piece, guide, component, this->Sent[home], vertices[home]);
        }
      }
    });
  triangles = messages.Exchange(triangles);
  vertices = messages.Exchange(vertices);
  processes.Together(
    [&]
    {
      const std::vector<MovedTriangle> all = InOrder(triangles);
      if (all.empty())
      {
        return;
      }
      std::unordered_map<vtkIdType, Index> pointOf;
      this->Geometry = std::make_unique<SurfaceGeometry>(SurfaceOf(all, vertices, pointOf));
      const TriangleMesh& here = this->Geometry->Mesh;
      for (const TriangleMesh::Component& part : here.GetComponents())
      {
        this->ComponentsHere.push_back(all[here.InputTriangle(part.FirstTriangle)].Component);
      }
      std::vector<Index> vertexOf(pointOf.size(), None);
      for (Index v = 0; v < here.GetNumberOfVertices(); ++v)
      {
        vertexOf[here.Point(v)] = v;
      }
      this->Drawn.resize(guide.IsDrawn ? vertexOf.size() : 0, 0.0);
      this->Kind.resize(guide.IsConstrained ? vertexOf.size() : 0, ConstraintKind::None);
      this->Value.resize(this->Kind.size(), 0.0);
      for (std::size_t p = 0; p < count; ++p)
      {
        for (const MovedVertex& vertex : vertices[p])
        {
          const Index v = vertexOf[pointOf.at(vertex.Number)];
          this->Received[p].push_back(v);
          if (guide.IsDrawn)
          {
            this->Drawn[v] = vertex.Drawn;
          }
          if (guide.IsConstrained)
          {
            this->Kind[v] = vertex.Kind;
            this->Value[v] = vertex.Value;
          }
        }
      }
    });
}

ComponentGuide MovedComponents::GuideOf(std::size_t part) const
{
  return Internal::GuideOf(this->Geometry->Mesh, part, this->Drawn, this->Kind, this->Value);
}

void MovedComponents::SendBack(Processes& processes, const Messages& messages,
  const std::vector<Complex>& moved, std::vector<Complex>& section) const
{
  std::vector<std::vector<Complex>> values;
  processes.Together(
    [&]
    {
      values.resize(this->Received.size());
      for (std::size_t p = 0; p < values.size(); ++p)
      {
        for (const Index v : this->Received[p])
        {
          values[p].push_back(moved[v]);
        }
      }
    });
  values = messages.Exchange(values);
  for (std::size_t p = 0; p < values.size(); ++p)
  {
    for (std::size_t k = 0; k < values[p].size(); ++k)
    {
      section[this->Sent[p][k]] = values[p][k];
    }
  }
}
}
