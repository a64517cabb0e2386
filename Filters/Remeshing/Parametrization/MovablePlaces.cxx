// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Parametrization/MovablePlaces.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace DirectionFields::Internal
{
namespace
{
/// Sums of angles are multiples of a right angle, or of a third of a straight one, up to rounding.
constexpr double SameAngle = 0.1;

std::int64_t InUnits(double x)
{
  return std::llround(x * static_cast<double>(IntegerGrid::Unit));
}
}

MovablePlaces::MovablePlaces(const CutMesh& mesh, const std::vector<Transition>& own,
  const std::vector<char>& isPoint, const std::vector<double>& perLength,
  std::vector<GridPoint>& places)
  : Mesh(mesh)
  , Plane(mesh.Degree)
  , PerLength(perLength)
  , Places(places)
  , Own(own)
  , FirstInTriangle(static_cast<Index>(mesh.Positions.size()))
  , Freedom(mesh.Positions.size(), 2)
  , Axis(mesh.Positions.size(), 0)
  , HasAnyAngle(mesh.Positions.size(), 0)
  , Begin(mesh.Positions.size() + 1, 0)
  , Around(3 * mesh.Triangles.size())
{
  for (const CutMesh::Cone& cone : mesh.Cones)
  {
    const bool isInTriangle = mesh.IsCorner[cone.Vertex] == 0;
    this->HasAnyAngle[cone.Vertex] = isInTriangle ? 0 : 1;
    this->FirstInTriangle =
      isInTriangle ? std::min(this->FirstInTriangle, cone.Vertex) : this->FirstInTriangle;
  }
  for (const CutMesh::MapTriangle& t : mesh.Triangles)
  {
    for (const Index v : t.Vertex)
    {
      ++this->Begin[v + 1];
    }
  }
  std::partial_sum(this->Begin.begin(), this->Begin.end(), this->Begin.begin());
  std::vector<Index> next(this->Begin.begin(), this->Begin.end() - 1);
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    for (const Index v : mesh.Triangles[t].Vertex)
    {
      this->Around[next[v]++] = static_cast<Index>(t);
    }
  }
  this->LimitMoves(isPoint);
}

void MovablePlaces::LimitMoves(const std::vector<char>& isPoint)
{
  for (const CutMesh::MapTriangle& t : this->Mesh.Triangles)
  {
    for (int c = 0; c < 3; ++c)
    {
      for (const Index v : { t.Vertex[c], t.Vertex[(c + 1) % 3] })
      {
        this->HasAnyAngle[v] = this->HasAnyAngle[v] != 0 || t.Twin[c] == None ? 1 : 0;
      }
    }
  }
  for (std::size_t v = 0; v < isPoint.size(); ++v)
  {
    this->Freedom[v] = isPoint[v] != 0 ? 0 : 2;
  }
  for (const CutMesh::IsolineEdge& edge : this->Mesh.Isolines)
  {
    for (const int c : { edge.Corner, (edge.Corner + 1) % 3 })
    {
      const Index v = this->Mesh.Triangles[edge.Triangle].Vertex[c];
      const auto axis =
        static_cast<char>(this->Plane.Wrapped(edge.Axis - this->FromVertex(edge.Triangle, c).Turn) %
          (this->Mesh.Degree / 2));
      if (this->Freedom[v] == 2)
      {
        this->Freedom[v] = 1;
        this->Axis[v] = axis;
      }
      else if (this->Axis[v] != axis)
      {
        this->Freedom[v] = 0;
      }
    }
  }
}

void MovablePlaces::Move(Index v, double along, double across)
{
  // Features stay lines of the grid to the last bit.
  const std::array<double, 2> coordinates = this->Freedom[v] == 2
    ? this->Plane.Coordinates(Complex(along, across))
    : std::array<double, 2>{ along, 0.0 };
  this->Places[v] = this->Places[v] +
    this->Plane.Turned({ InUnits(coordinates[0]), InUnits(coordinates[1]) }, this->Axis[v]);
}

void MovablePlaces::MoveTo(Index v, const Complex& place, const Transition& toChart)
{
  const std::array<double, 2> coordinates = this->Plane.Coordinates(place);
  this->Places[v] = this->Plane.Apply(
    this->Plane.Inverse(toChart), { InUnits(coordinates[0]), InUnits(coordinates[1]) });
}

bool MovablePlaces::IsFlipped(Index t) const
{
  std::array<GridPoint, 3> corner;
  for (int c = 0; c < 3; ++c)
  {
    corner[c] =
      this->Plane.Apply(this->FromVertex(t, c), this->Places[this->Mesh.Triangles[t].Vertex[c]]);
  }
  return IntegerGrid::Orientation(corner[0], corner[1], corner[2]) <= 0;
}

double MovablePlaces::WantedAngle(Index cone) const
{
  return 2.0 * Pi * (this->Mesh.Degree - this->Mesh.ConeIndex[cone]) / this->Mesh.Degree;
}

double MovablePlaces::AngleAround(Index v) const
{
  double sum = 0.0;
  for (const Index t : this->TrianglesAt(v))
  {
    const Triangle& vertex = this->Mesh.Triangles[t].Vertex;
    const int c = vertex[0] == v ? 0 : vertex[1] == v ? 1 : 2;
    const Complex here = this->Corner(t, c);
    sum += std::arg((this->Corner(t, (c + 2) % 3) - here) / (this->Corner(t, (c + 1) % 3) - here));
  }
  return sum;
}

bool MovablePlaces::IsSurrounded(Index v) const
{
  const double wanted = this->IsInTriangle(v) ? this->WantedAngle(v) : 2.0 * Pi;
  // Where corners have the same place there is no angle, which is no match.
  return this->HasAnyAngle[v] != 0 || std::abs(this->AngleAround(v) - wanted) < SameAngle;
}
}
