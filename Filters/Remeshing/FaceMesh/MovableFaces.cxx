// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaceMesh/MovableFaces.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
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

SurfacePatch::SurfacePatch(std::vector<ClosestPoints::Corners> triangles)
  : Places(triangles)
{
  constexpr double least = 0.2;
  Vector3 sum = Vector3::Zero();
  for (const ClosestPoints::Corners& t : triangles)
  {
    this->Normals.push_back((t[1] - t[0]).cross(t[2] - t[0]));
    sum += this->Normals.back();
  }
  const bool isOneSided = std::all_of(this->Normals.begin(), this->Normals.end(),
    [&](const Vector3& normal) { return normal.dot(sum) >= least * normal.norm() * sum.norm(); });
  this->Side = isOneSided ? sum : Vector3(Vector3::Zero());
}

bool SurfacePatch::IsTurned(
  const std::vector<Vector3>& points, const Faces::Face& face, double reach) const
{
  const Vector3 area = AreaVector(points, face);
  constexpr double flat = 0.2;
  const double along = area.dot(this->Side);
  if (std::abs(along) > flat * area.norm() * this->Side.norm())
  {
    return along < 0.0;
  }
  const Vector3 middle = MiddleOf(points, face);
  const Index t = this->Places.Find(middle).Triangle;
  return t != None && this->Normals[t].dot(area) < 0.0 &&
    (reach == 0.0 || this->Places.Find(middle, area, reach).Triangle == None);
}

double Straying(const ClosestPoints& line, const Vector3& a, const Vector3& b)
{
  constexpr int samples = 8;
  double most = 0.0;
  for (int k = 1; k < samples; ++k)
  {
    const double t = static_cast<double>(k) / samples;
    most = std::max(most, line.Find((1.0 - t) * a + t * b).SquaredDistance);
  }
  return std::sqrt(most);
}

Vector3 MovableFaces::NormalAt(Index v, const std::vector<Vector3>& points) const
{
  Vector3 sum = Vector3::Zero();
  for (const Index f : this->Cells.At(v))
  {
    sum += AreaVector(points, this->Cells.Face(f));
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
  regular.Area = AreaVector(points, face);
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
  return this->Spaced(v, sum / static_cast<double>(this->Cells.At(v).size()), points);
}

Vector3 MovableFaces::Spaced(
  Index v, const Vector3& ideal, const std::vector<Vector3>& points) const
{
  const std::vector<Index>& ends = this->Cells.LineEnds(v);
  if (!this->HasCloseLines() || this->Domain.Line[v] <= 0 || ends.size() != 2)
  {
    return ideal;
  }
  // An edge from one neighbour to the other would stray four times as far as those to them.
  const Vector3 middle = 0.5 * (points[ends[0]] + points[ends[1]]);
  const Vector3 ahead = (points[ends[1]] - points[ends[0]]).normalized();
  const Vector3 way = points[v] - middle;
  const double straying = (way - way.dot(ahead) * ahead).norm() / 4.0;
  const bool isCurved = straying > 0.5 * this->Domain.MostStraying * this->Domain.EdgeLength[v];
  return isCurved ? Vector3(0.5 * (ideal + middle)) : ideal;
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
  ideal = this->Spaced(v, ideal / static_cast<double>(this->Cells.At(v).size()), points);
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
    : this->SurfaceAt(v).Find(place, normal, reach, this->Nearest[v]);
  if (line <= 0 && answer.Place != None)
  {
    this->Nearest[v] = answer.Place;
  }
  if (answer.Triangle == None)
  {
    return otherwise;
  }
  if (this->Domain.KeepsSides && line <= 0)
  {
    constexpr double most = 0.05;
    const Vector3 way = answer.Position - place;
    const double along = std::abs(way.dot(normal.normalized()));
    const double across = std::sqrt(std::max(0.0, way.squaredNorm() - along * along));
    if (across > along + most * this->Domain.EdgeLength[v])
    {
      return otherwise;
    }
  }
  return answer.Position;
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

Index MovableFaces::PatchOf(const Faces::Face& face) const
{
  const std::vector<Index>& patches = this->Domain.Patches.Of;
  const int size = Faces::Size(face);
  bool isBesideLine = false;
  Index patch = None;
  for (int c = 0; c < size; ++c)
  {
    isBesideLine = isBesideLine || this->Domain.Line[face[c]] != 0;
    patch = std::max(patch, patches[face[c]]);
  }
  // Lines turn faces over: their vertices do not move away from them.
  if (!isBesideLine)
  {
    return None;
  }
  for (int c = 0; patch == None && c < size; ++c)
  {
    Index v = face[c];
    Index w = face[(c + 1) % size];
    if (this->Cells.IsLineEdge(v, w))
    {
      continue;
    }
    // A hub has all faces of a fan.
    if (this->Cells.At(w).size() < this->Cells.At(v).size())
    {
      std::swap(v, w);
    }
    for (const Index f : this->Cells.At(v))
    {
      const Faces::Face& other = this->Cells.Face(f);
      const bool isBeside =
        other != face && std::find(other.begin(), other.end(), w) != other.end();
      for (int k = 0; isBeside && k < Faces::Size(other); ++k)
      {
        patch = std::max(patch, patches[other[k]]);
      }
    }
  }
  return patch;
}

bool MovableFaces::IsTurned(const Faces::Face& face) const
{
  if (!this->Domain.Patches.All)
  {
    return false;
  }
  const Index patch = this->PatchOf(face);
  return patch != None && (*this->Domain.Patches.All)[patch].IsTurned(this->Points, face);
}

double MovableFaces::Quality(const Faces::Face& face) const
{
  constexpr double flat = 0.05;
  constexpr double leastTurn = 0.64;
  double quality = ScaledJacobian(this->Points, face);
  const int size = Faces::Size(face);
  for (int c = 0; this->HasCloseLines() && quality > flat && c < size; ++c)
  {
    const Index v = face[c];
    const Index before = face[(c + size - 1) % size];
    const Index after = face[(c + 1) % size];
    if (this->Domain.Line[v] > 0 && this->Cells.LineEnds(v).size() == 2 &&
      this->Cells.IsLineEdge(v, before) && this->Cells.IsLineEdge(v, after))
    {
      const Vector3 to = this->Points[before] - this->Points[v];
      const Vector3 from = this->Points[after] - this->Points[v];
      quality = to.dot(from) < -leastTurn * to.norm() * from.norm() ? flat : quality;
    }
  }
  return quality > 0.0 && this->IsTurned(face) ? -quality : quality;
}

double MovableFaces::LeastQuality(Index v) const
{
  double least = 1.0;
  const Vector3 normal =
    this->Domain.Line[v] == 0 ? this->NormalAt(v, this->Points) : Vector3::Zero();
  for (const Index f : this->Cells.At(v))
  {
    const Faces::Face& face = this->Cells.Face(f);
    double quality = this->Quality(face);
    // A triangle has no side of its own to be folded to.
    if (face[3] == None && AreaVector(this->Points, face).dot(normal) < 0.0)
    {
      quality = -std::abs(quality);
    }
    least = std::min(least, quality);
  }
  return least;
}

double MovableFaces::Distance(const Faces::Face& face) const
{
  if (this->Domain.IsRough)
  {
    return 0.0;
  }
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

double MovableFaces::DistanceFrom(
  const std::vector<Index>& vertices, Index v, const Vector3& place) const
{
  std::vector<ClosestPoints::Corners> triangles;
  for (const Index w : vertices)
  {
    for (const Index f : this->Cells.At(w))
    {
      const Faces::Face& face = this->Cells.Face(f);
      for (int c = 2; c < Faces::Size(face); ++c)
      {
        triangles.push_back(
          { this->Points[face[0]], this->Points[face[c - 1]], this->Points[face[c]] });
      }
    }
  }
  const ClosestPoints::Answer answer = ClosestPoints(std::move(triangles)).Find(place);
  return answer.Triangle != None ? std::sqrt(answer.SquaredDistance) / this->Domain.EdgeLength[v]
                                 : 1.0;
}

bool MovableFaces::MayLeaveLine(Index v, Index before, Index after) const
{
  const Index line = this->Domain.Line[v];
  return !this->HasCloseLines() || line <= 0 ||
    Straying(this->Domain.Lines[line - 1], this->Points[before], this->Points[after]) <=
    this->Domain.MostStraying * this->Domain.EdgeLength[v];
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
