// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaceMesh/MovableFaces.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
Vector3 AreaVector(const Faces::Face& face, const std::vector<Vector3>& points)
{
  const Vector3 u = points[face[2]] - points[face[0]];
  const Vector3 v =
    face[3] == None ? points[face[2]] - points[face[1]] : points[face[3]] - points[face[1]];
  return 0.5 * u.cross(face[3] == None ? Vector3(-(points[face[1]] - points[face[0]])) : v);
}

/// Of regular polygons with one number of corners: the weights that fit one to given corners, the
/// corners of the one whose first is 1, and the length of an edge.
struct Roots
{
  explicit Roots(int size)
    : EdgePerRadius(2.0 * std::sin(Pi / size))
  {
    for (int c = 0; c < size; ++c)
    {
      this->Weight[c] = std::polar(1.0 / size, -2.0 * Pi * c / size);
      this->Corner[c] = std::polar(1.0, 2.0 * Pi * c / size);
    }
  }
  std::array<Complex, 4> Weight;
  std::array<Complex, 4> Corner;
  double EdgePerRadius;
};

const Roots& RootsOf(int size)
{
  static const Roots three(3);
  static const Roots four(4);
  return size == 3 ? three : four;
}
}

Vector3 MovableFaces::NormalAt(Index v, const std::vector<Vector3>& points) const
{
  Vector3 sum = Vector3::Zero();
  for (const Index f : this->Cells.At(v))
  {
    sum += AreaVector(this->Cells.Face(f), points);
  }
  return sum;
}

MovableFaces::Regular MovableFaces::RegularFace(Index f, const std::vector<Vector3>& points) const
{
  const Faces::Face& face = this->Cells.Face(f);
  const int size = Faces::Size(face);
  Vector3 center = Vector3::Zero();
  double length = 0.0;
  for (int c = 0; c < size; ++c)
  {
    center += points[face[c]] / size;
    length += this->Domain.EdgeLength[face[c]] / size;
  }
  Regular regular;
  regular.Area = AreaVector(face, points);
  const Vector3 normal = regular.Area.normalized();
  Vector3 x = points[face[0]] - center;
  x -= normal * normal.dot(x);
  x.normalize();
  const Vector3 y = normal.cross(x);
  const Roots& roots = RootsOf(size);
  Complex best = 0.0;
  for (int c = 0; c < size; ++c)
  {
    const Vector3 p = points[face[c]] - center;
    best += Complex(p.dot(x), p.dot(y)) * roots.Weight[c];
  }
  const double radius = length / roots.EdgePerRadius;
  const double modulus = std::abs(best);
  best *= modulus > 0.0 ? 0.9 + 0.1 * std::min(radius / modulus, 2.0) : 0.0;
  for (int c = 0; c < size; ++c)
  {
    const Complex z = best * roots.Corner[c];
    const Vector3 place = center + z.real() * x + z.imag() * y;
    regular.Corners[c] = place.allFinite() ? place : points[face[c]];
  }
  return regular;
}

Vector3 MovableFaces::Ideal(Index v, const std::vector<Vector3>& points) const
{
  Vector3 sum = Vector3::Zero();
  for (const Index f : this->Cells.At(v))
  {
    sum += this->RegularFace(f, points).Corners[this->CornerAt(f, v)];
  }
  return sum / static_cast<double>(this->Cells.At(v).size());
}

Vector3 MovableFaces::Relaxed(
  Index v, const std::vector<Vector3>& points, const std::vector<Regular>& regular) const
{
  Vector3 ideal = Vector3::Zero();
  Vector3 normal = Vector3::Zero();
  for (const Index f : this->Cells.At(v))
  {
    ideal += regular[f].Corners[this->CornerAt(f, v)];
    normal += regular[f].Area;
  }
  ideal /= static_cast<double>(this->Cells.At(v).size());
  return this->Projected(v, 0.5 * (points[v] + ideal), normal, points[v]);
}

Vector3 MovableFaces::Projected(
  Index v, const Vector3& place, const std::vector<Vector3>& points) const
{
  const Vector3 normal =
    this->Domain.Line[v] > 0 ? Vector3(Vector3::Zero()) : this->NormalAt(v, points);
  return this->Projected(v, place, normal, points[v]);
}

Vector3 MovableFaces::Projected(
  Index v, const Vector3& place, const Vector3& normal, const Vector3& otherwise) const
{
  const double reach = 4.0 * this->Domain.EdgeLength[v];
  const Index line = this->Domain.Line[v];
  const ClosestPoints::Answer answer = line > 0
    ? this->Domain.Lines[line - 1].Find(place, Vector3::Zero(), reach)
    : this->Domain.Surface.Find(place, normal, reach, this->Nearest[v]);
  if (line <= 0 && answer.Place != None)
  {
    this->Nearest[v] = answer.Place;
  }
  return answer.Triangle != None ? answer.Position : otherwise;
}

void MovableFaces::Relax(const std::vector<Index>& vertices, int times)
{
  for (int k = 0; k < times; ++k)
  {
    for (const Index v : vertices)
    {
      if (this->IsFree(v))
      {
        this->Points[v] =
          this->Projected(v, 0.5 * (this->Points[v] + this->Ideal(v, this->Points)), this->Points);
      }
    }
  }
}

int MovableFaces::CornerAt(Index f, Index v) const
{
  const Faces::Face& face = this->Cells.Face(f);
  return static_cast<int>(std::find(face.begin(), face.end(), v) - face.begin());
}

double MovableFaces::LeastQuality(Index v) const
{
  double least = 1.0;
  const Vector3 normal =
    this->Domain.Line[v] == 0 ? this->NormalAt(v, this->Points) : Vector3::Zero();
  for (const Index f : this->Cells.At(v))
  {
    const Faces::Face& face = this->Cells.Face(f);
    double quality = ScaledJacobian(this->Points, face);
    // A triangle has no side of its own to be folded to.
    if (face[3] == None && AreaVector(face, this->Points).dot(normal) < 0.0)
    {
      quality = -quality;
    }
    least = std::min(least, quality);
  }
  return least;
}

double MovableFaces::Distance(const Faces::Face& face) const
{
  const int size = Faces::Size(face);
  Vector3 middle = Vector3::Zero();
  double length = 0.0;
  for (int c = 0; c < size; ++c)
  {
    middle += this->Points[face[c]] / size;
    length += this->Domain.EdgeLength[face[c]] / size;
  }
  const ClosestPoints::Answer answer = this->Domain.Surface.Find(middle, Vector3::Zero(), length);
  return answer.Triangle != None ? std::sqrt(answer.SquaredDistance) / length : 1.0;
}

double MovableFaces::LargestDistance(Index v) const
{
  double largest = 0.0;
  for (const Index f : this->Cells.At(v))
  {
    largest = std::max(largest, this->Distance(f));
  }
  return largest;
}
}
