// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Curvature/ShapeAverages.h"

#include "Support/Threads.h"
#include "Support/VectorMath.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace DirectionFields::Internal
{
namespace
{
/// The cotangent weights are those of linear interpolation: means of them have no drift. Negative
/// ones would make noise larger.
constexpr double LeastWeight = 0.02;

/// Calls body(h, neighbour, outgoing) for the edges of a vertex, by a half-edge that runs out or
/// in.
template <typename Body>
void ForEachEdge(const TriangleMesh& mesh, Index v, const Body& body)
{
  const Index first = mesh.Outgoing(v);
  Index h = first;
  Index last = first;
  do
  {
    body(h, mesh.Head(h), true);
    last = h;
    h = mesh.NextOutgoing(h);
  } while (h != None && h != first);
  if (h == None)
  {
    const Index incoming = TriangleMesh::Previous(last);
    body(incoming, mesh.Tail(incoming), false);
  }
}

float EdgeWeight(const SurfaceGeometry& geometry, Index h)
{
  return static_cast<float>(std::max(geometry.Lengths.EdgeWeight(geometry.Mesh, h), LeastWeight));
}
}

ShapeAverages::ShapeAverages(const SurfaceGeometry& geometry, const std::vector<Shape>& shapes)
  : Start(shapes.size() + 1, 0)
  , Own(shapes.size(), 1.0)
  , WeightSum(shapes.size(), 0.0)
{
  const TriangleMesh& mesh = geometry.Mesh;
  const auto vertices = static_cast<Index>(shapes.size());
  ParallelFor(vertices, LightPiece,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        if (shapes[v].IsFitted())
        {
          ForEachEdge(mesh, v,
            [&](Index, Index j, bool) { this->Start[v + 1] += shapes[j].IsFitted() ? 1 : 0; });
        }
      }
    });
  std::partial_sum(this->Start.begin(), this->Start.end(), this->Start.begin());
  this->Couplings.resize(this->Start.back());
  ParallelFor(vertices, HeavyPiece,
    [&](Index begin, Index end) { this->Fill(geometry, shapes, begin, end); });
}

void ShapeAverages::EndAt(const SurfaceGeometry& geometry, const std::vector<char>& ends)
{
  const TriangleMesh& mesh = geometry.Mesh;
  ParallelFor(mesh.GetNumberOfVertices(), MediumPiece,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        bool isNextToEnd = ends[v] != 0;
        ForEachEdge(mesh, v,
          [&](Index, Index j, bool)
          { isNextToEnd = isNextToEnd || ends[j] != 0 || this->Start[j] == this->Start[j + 1]; });
        if (!isNextToEnd)
        {
          continue;
        }
        double sum = 0.0;
        ForEachEdge(mesh, v, [&](Index h, Index, bool) { sum += EdgeWeight(geometry, h); });
        const auto part = static_cast<float>(this->WeightSum[v] / sum);
        for (Index k = this->Start[v]; k < this->Start[v + 1]; ++k)
        {
          Coupling& coupling = this->Couplings[k];
          const float factor = ends[coupling.Vertex] != 0 ? 0.0F : part;
          coupling.Weight *= factor;
          coupling.Real *= factor;
          coupling.Imaginary *= factor;
        }
        if (this->Start[v] < this->Start[v + 1])
        {
          this->Own[v] = ends[v] != 0 ? 0.0 : 1.0 - Share;
        }
        this->WeightSum[v] = sum;
      }
    });
}

void ShapeAverages::Fill(
  const SurfaceGeometry& geometry, const std::vector<Shape>& shapes, Index begin, Index end)
{
  const TriangleMesh& mesh = geometry.Mesh;
  const Index first = this->Start[begin];
  const Index count = this->Start[end] - first;
  std::vector<double> angles(count);
  std::vector<double> cosines(count);
  std::vector<double> sines(count);
  Index next = first;
  for (Index v = begin; v < end; ++v)
  {
    const Index row = next;
    double sum = 0.0;
    if (shapes[v].IsFitted())
    {
      ForEachEdge(mesh, v,
        [&](Index h, Index j, bool outgoing)
        {
          if (shapes[j].IsFitted())
          {
            const double rotation = geometry.Transport.RotationAlong(mesh, h);
            angles[next - first] = outgoing ? -2.0 * rotation : 2.0 * rotation;
            this->Couplings[next].Vertex = j;
            this->Couplings[next].Weight = EdgeWeight(geometry, h);
            sum += this->Couplings[next].Weight;
            ++next;
          }
        });
    }
    this->WeightSum[v] = sum;
    for (Index k = row; k < next; ++k)
    {
      this->Couplings[k].Weight = static_cast<float>(this->Couplings[k].Weight * (Share / sum));
      this->Own[v] -= this->Couplings[k].Weight;
    }
  }
  CosinesAndSines(angles.data(), count, cosines.data(), sines.data());
  for (Index k = 0; k < count; ++k)
  {
    Coupling& coupling = this->Couplings[first + k];
    coupling.Real = static_cast<float>(coupling.Weight * cosines[k]);
    coupling.Imaginary = static_cast<float>(coupling.Weight * sines[k]);
  }
}
}
