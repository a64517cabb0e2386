// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Unfolding/MovablePlaces.h"

#include <algorithm>
#include <cmath>
#include <limits>
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
  , Angle(mesh.Positions.size(), 2.0 * Pi)
  , Begin(mesh.Positions.size() + 1, 0)
  , Around(3 * mesh.Triangles.size())
{
  for (const CutMesh::Cone& cone : mesh.Cones)
  {
    const bool isInTriangle = mesh.IsCorner[cone.Vertex] == 0;
    this->Angle[cone.Vertex] = isInTriangle ? 2.0 * Pi : 0.0;
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
  this->FindAngles();
}

void MovablePlaces::LimitMoves(const std::vector<char>& isPoint)
{
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

void MovablePlaces::FindAngles()
{
  for (const CutMesh::MapTriangle& t : this->Mesh.Triangles)
  {
    for (int c = 0; c < 3; ++c)
    {
      for (const Index v : { t.Vertex[c], t.Vertex[(c + 1) % 3] })
      {
        if (t.Twin[c] == None && this->Angle[v] > 0.0)
        {
          // Where the boundary is no line of the grid its vertices stay.
          this->Freedom[v] = this->Freedom[v] == 1 ? 1 : 0;
          this->Angle[v] = this->Freedom[v] == 1 ? Pi : 0.0;
        }
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
    corner[c] = this->CornerPoint(t, c);
  }
  return IntegerGrid::Orientation(corner[0], corner[1], corner[2]) <= 0;
}

double MovablePlaces::AreaInMap(Index t) const
{
  const Complex a = this->Corner(t, 1) - this->Corner(t, 0);
  const Complex b = this->Corner(t, 2) - this->Corner(t, 0);
  return 0.5 * (std::conj(a) * b).imag();
}

double MovablePlaces::AreaInSpace(Index t) const
{
  const Triangle& v = this->Mesh.Triangles[t].Vertex;
  const double size = (this->PerLength[v[0]] + this->PerLength[v[1]] + this->PerLength[v[2]]) / 3.0;
  const std::vector<Vector3>& positions = this->Mesh.Positions;
  return 0.5 * size * size *
    (positions[v[1]] - positions[v[0]]).cross(positions[v[2]] - positions[v[0]]).norm();
}

bool MovablePlaces::StaysFlat(Index t) const
{
  int axis = 0;
  int most = 0;
  bool isAlongOne = true;
  for (int c = 0; c < 3; ++c)
  {
    const Index v = this->Mesh.Triangles[t].Vertex[c];
    const Index next = this->Mesh.Triangles[t].Vertex[(c + 1) % 3];
    if (this->Freedom[v] == 0 && this->Freedom[next] == 0 &&
      this->CornerPoint(t, c) == this->CornerPoint(t, (c + 1) % 3))
    {
      return true;
    }
    if (this->Freedom[v] == 1)
    {
      const int own =
        this->Plane.Wrapped(this->Axis[v] + this->FromVertex(t, c).Turn) % (this->Mesh.Degree / 2);
      isAlongOne = isAlongOne && (most == 0 || own == axis);
      axis = own;
    }
    most = std::max<int>(most, this->Freedom[v]);
  }
  const auto across = [&](int c) { return this->Plane.Turned(this->CornerPoint(t, c), -axis).B; };
  return most == 1 && isAlongOne && across(0) == across(1) && across(0) == across(2);
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
    const Complex first = this->Corner(t, (c + 1) % 3) - this->Corner(t, c);
    const Complex last = this->Corner(t, (c + 2) % 3) - this->Corner(t, c);
    if (first == 0.0 || last == 0.0)
    {
      return std::numeric_limits<double>::quiet_NaN();
    }
    sum += std::arg(last * std::conj(first));
  }
  return sum;
}

bool MovablePlaces::IsSurrounded(Index v) const
{
  const double wanted = this->IsInTriangle(v) ? this->WantedAngle(v) : this->Angle[v];
  // Where corners have the same place there is no angle, which is no match.
  return wanted == 0.0 || std::abs(this->AngleAround(v) - wanted) < SameAngle;
}
}
