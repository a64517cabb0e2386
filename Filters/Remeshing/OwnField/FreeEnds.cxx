// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "OwnField/FreeEnds.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace DirectionFields::Internal
{
namespace
{
/// Where sizes jump by less than e to this power, 20, a map is better without the singularities:
/// measured on a square, with straight lines of .15 to .8 of its width at 25 to 60 degrees.
constexpr double LeastFlux = 3.0;
/// Features sharper than this on the average, in radians, are where the surface is bent. Its
/// principal curvatures guide the field there, and their flux is not one of the lines.
constexpr double Sharpest = 15.0 / 180.0 * Pi;
/// In lengths of edges of the mesh to be made.
constexpr double ShortestLine = 3.0;

double HalfCotangent(const IntrinsicGeometry& geometry, Index h)
{
  const TriangleMesh& mesh = geometry.Mesh;
  const auto& squared = geometry.Lengths.SquaredLength;
  const double across = squared[mesh.Edge(TriangleMesh::Next(h))] +
    squared[mesh.Edge(TriangleMesh::Previous(h))] - squared[mesh.Edge(h)];
  return across / (8.0 * geometry.Lengths.Area[h / 3]);
}

/// The angle between the triangles on both sides of a half-edge.
double BendAlong(const SurfaceGeometry& geometry, Index h)
{
  const auto normal = [&](Index t)
  {
    const auto at = [&](Index c) { return geometry.Positions[geometry.Mesh.Tail(3 * t + c)]; };
    return Vector3((at(1) - at(0)).cross(at(2) - at(0)));
  };
  const Index twin = geometry.Mesh.Twin(h);
  if (twin == None)
  {
    return 0.0;
  }
  const Vector3 a = normal(h / 3);
  const Vector3 b = normal(twin / 3);
  return std::atan2(a.cross(b).norm(), a.dot(b));
}
}

FreeEnds::FreeEnds(const SurfaceGeometry& geometry, int degree, const std::vector<char>& isFeature,
  const std::vector<Complex>& section, double face)
  : Geometry(geometry)
  , Mesh(geometry.Mesh)
  , Degree(degree)
  , IsFeature(isFeature)
  , Sides(geometry.Mesh.GetNumberOfVertices(), 0)
{
  for (Index e = 0; e < this->Mesh.GetNumberOfEdges(); ++e)
  {
    const Index h = this->Mesh.HalfEdge(e);
    const int isSide = isFeature[e] != 0 || this->Mesh.Twin(h) == None ? 1 : 0;
    this->Sides[this->Mesh.Tail(h)] += isSide;
    this->Sides[this->Mesh.Head(h)] += isSide;
  }
  for (Index v = 0; v < this->Mesh.GetNumberOfVertices(); ++v)
  {
    if (!this->IsFreeEnd(v))
    {
      continue;
    }
    const std::vector<Index> line = this->LineFrom(v);
    // A line of two free ends is visited from the first one.
    if ((this->IsFreeEnd(line.back()) && line.back() < v) ||
      this->LengthOfFlat(line) < ShortestLine * face)
    {
      continue;
    }
    const Fluxes fluxes = this->FluxesOf(line, section);
    if (std::abs(fluxes.Sum()) > LeastFlux)
    {
      // The side of less flux is turned: it has more room.
      const bool turnsLeft = std::abs(fluxes.Left) < std::abs(fluxes.Right);
      this->Lines.push_back({ line, turnsLeft == (fluxes.Sum() < 0.0) ? 1 : -1 });
    }
  }
}

/// The length of a line in the surface's unit, 0 of one that is sharp.
double FreeEnds::LengthOfFlat(const std::vector<Index>& line) const
{
  double length = 0.0;
  double bend = 0.0;
  std::vector<Index> fan;
  for (std::size_t k = 1; k < line.size(); ++k)
  {
    const double edge =
      (this->Geometry.Positions[line[k]] - this->Geometry.Positions[line[k - 1]]).norm();
    this->Mesh.GetFan(line[k - 1], fan);
    const auto h = std::find_if(
      fan.begin(), fan.end(), [&](Index each) { return this->Mesh.Head(each) == line[k]; });
    length += edge;
    bend += edge * BendAlong(this->Geometry, *h);
  }
  return bend > Sharpest * length ? 0.0 : length;
}

std::vector<Index> FreeEnds::LineFrom(Index v) const
{
  std::vector<Index> line{ v };
  std::vector<Index> fan;
  Index before = None;
  do
  {
    Index next = None;
    this->Mesh.GetFan(v, fan);
    for (const Index h : fan)
    {
      const Index head = this->Mesh.Head(h);
      next = this->IsFeature[this->Mesh.Edge(h)] != 0 && head != before ? head : next;
    }
    before = v;
    v = next;
    line.push_back(v);
  } while (this->Sides[v] == 2 && !this->Mesh.IsBoundary(v));
  return line;
}

/// The rotation of a field along a half-edge by the half-edge's weight.
double FreeEnds::FluxAlong(Index h, const std::vector<Complex>& section) const
{
  const Index twin = this->Mesh.Twin(h);
  const double weight =
    HalfCotangent(this->Geometry, h) + (twin != None ? HalfCotangent(this->Geometry, twin) : 0.0);
  const double transport = this->Geometry.Transport.RotationAlong(this->Mesh, h);
  const Complex turn = section[this->Mesh.Head(h)] *
    std::conj(section[this->Mesh.Tail(h)] * std::polar(1.0, this->Degree * transport));
  return weight * std::arg(turn) / this->Degree;
}

FreeEnds::Fluxes FreeEnds::FluxesOf(
  const std::vector<Index>& line, const std::vector<Complex>& section) const
{
  Fluxes fluxes;
  std::vector<Index> fan;
  for (std::size_t k = 0; k < line.size(); ++k)
  {
    const bool isEnd = k == 0 || k + 1 == line.size();
    if (isEnd && !this->IsFreeEnd(line[k]))
    {
      continue;
    }
    this->Mesh.GetFan(line[k], fan);
    const Index ahead = k + 1 < line.size() ? line[k + 1] : line[k - 1];
    std::rotate(fan.begin(),
      std::find_if(fan.begin(), fan.end(), [&](Index h) { return this->Mesh.Head(h) == ahead; }),
      fan.end());
    // Counter-clockwise from the edge ahead its left side comes first.
    double* side = isEnd ? &fluxes.Ends : &fluxes.Left;
    for (std::size_t at = 1; at < fan.size(); ++at)
    {
      if (this->IsFeature[this->Mesh.Edge(fan[at])] == 0)
      {
        *side += this->FluxAlong(fan[at], section);
      }
      else
      {
        side = &fluxes.Right;
      }
    }
  }
  return fluxes;
}

/// @param turn how many times 2 pi / n the field turns once around the end, counter-clockwise from
///             the line back to it
void FreeEnds::AddDirections(Index end, int turn, std::vector<Vector3>& directions) const
{
  std::vector<Index> fan;
  this->Mesh.GetFan(end, fan);
  const Index back = *std::find_if(
    fan.begin(), fan.end(), [&](Index h) { return this->IsFeature[this->Mesh.Edge(h)] != 0; });
  const double along = this->Geometry.Transport.EdgeAngle[back];
  for (const Index h : fan)
  {
    const Index v = this->Mesh.Head(h);
    if (this->Sides[v] > 0)
    {
      continue;
    }
    double around = this->Geometry.Transport.EdgeAngle[h] - along;
    around += around < 0.0 ? 2.0 * Pi : 0.0;
    const double angle = along + turn * around / this->Degree;
    directions[v] = std::cos(angle) * this->Geometry.Frames.X[end] +
      std::sin(angle) * this->Geometry.Frames.Y(end);
  }
}

std::vector<Vector3> FreeEnds::Directions() const
{
  std::vector<Vector3> directions(this->Mesh.GetNumberOfVertices(), Vector3::Zero());
  for (const Line& line : this->Lines)
  {
    this->AddDirections(line.Vertices.front(), line.Turn, directions);
    if (this->IsFreeEnd(line.Vertices.back()))
    {
      this->AddDirections(line.Vertices.back(), -line.Turn, directions);
    }
  }
  return directions;
}
}
