// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "OwnField/FreeEnds.h"

#include "Geometry/DihedralAngles.h"

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
  std::vector<Index> ends;
  for (Index v = 0; v < this->Mesh.GetNumberOfVertices(); ++v)
  {
    if (this->IsFreeEnd(v))
    {
      ends.push_back(v);
    }
  }
  const std::vector<double> dihedral =
    ends.empty() ? std::vector<double>() : DihedralAngles(geometry);
  for (const Index v : ends)
  {
    const std::vector<Index> line = this->LineFrom(v);
    const Index end = this->Mesh.Head(line.back());
    // A line of two free ends is visited from the first one.
    if ((this->IsFreeEnd(end) && end < v) ||
      this->LengthOfFlat(line, dihedral) < ShortestLine * face)
    {
      continue;
    }
    const Fluxes fluxes = this->FluxesOf(line, section);
    if (std::abs(fluxes.Sum()) > LeastFlux)
    {
      // The side of less flux is turned: it has more room.
      const bool turnsLeft = std::abs(fluxes.Left) < std::abs(fluxes.Right);
      this->Lines.push_back({ v, end, turnsLeft == (fluxes.Sum() < 0.0) ? 1 : -1 });
    }
  }
}

/// The length of a line in the surface's unit, 0 of one that is sharp.
double FreeEnds::LengthOfFlat(
  const std::vector<Index>& line, const std::vector<double>& dihedral) const
{
  double length = 0.0;
  double bend = 0.0;
  for (const Index h : line)
  {
    const double edge =
      (this->Geometry.Positions[this->Mesh.Head(h)] - this->Geometry.Positions[this->Mesh.Tail(h)])
        .norm();
    length += edge;
    bend += edge * std::abs(dihedral[this->Mesh.Edge(h)]);
  }
  return bend > Sharpest * length ? 0.0 : length;
}

/// The half-edges of a line from a free end on.
std::vector<Index> FreeEnds::LineFrom(Index v) const
{
  std::vector<Index> line;
  std::vector<Index> fan;
  do
  {
    const Index before = line.empty() ? None : this->Mesh.Edge(line.back());
    this->Mesh.GetFan(v, fan);
    line.push_back(*std::find_if(fan.begin(), fan.end(),
      [&](Index h)
      { return this->IsFeature[this->Mesh.Edge(h)] != 0 && this->Mesh.Edge(h) != before; }));
    v = this->Mesh.Head(line.back());
  } while (this->Sides[v] == 2 && !this->Mesh.IsBoundary(v));
  return line;
}

/// The rotation of a field along a half-edge by the half-edge's weight.
double FreeEnds::FluxAlong(Index h, const std::vector<Complex>& section) const
{
  const double weight = this->Geometry.Lengths.EdgeWeight(this->Mesh, h);
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
  for (std::size_t k = 0; k <= line.size(); ++k)
  {
    // From the last vertex it is the edge back.
    const Index ahead = k < line.size() ? line[k] : this->Mesh.Twin(line.back());
    const Index v = this->Mesh.Tail(ahead);
    const bool isEnd = k == 0 || k == line.size();
    if (isEnd && !this->IsFreeEnd(v))
    {
      continue;
    }
    this->Mesh.GetFan(v, fan);
    std::rotate(fan.begin(), std::find(fan.begin(), fan.end(), ahead), fan.end());
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
    this->AddDirections(line.First, line.Turn, directions);
    if (this->IsFreeEnd(line.Last))
    {
      this->AddDirections(line.Last, -line.Turn, directions);
    }
  }
  return directions;
}
}
