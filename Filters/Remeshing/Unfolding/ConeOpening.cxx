// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Unfolding/ConeOpening.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

namespace DirectionFields::Internal
{
namespace
{
/// Angles between the neighbours of a cone become no wider than this, if they can.
constexpr double WidestAngle = 0.9 * Pi;
/// Up to this part of the radius places are those of polar coordinates.
constexpr double InnerPart = 0.2;
/// Where the surface has turned away by so much, seen from the cone, it cannot be laid flat.
constexpr double MostSlope = 0.5;

/// The angles around a cone in space and in the map, as they are between its three neighbours.
class StretchedAngles
{
public:
  /// @param angles from each neighbour to the next one
  /// @param wanted what they become together
  StretchedAngles(const std::array<double, 3>& angles, double wanted)
    : Wanted(wanted)
  {
    const double factor = wanted / (2.0 * Pi);
    const double largest = factor * *std::max_element(angles.begin(), angles.end());
    const double even = wanted / 3.0;
    const double share = largest > std::max(WidestAngle, even)
      ? std::max(0.0, (WidestAngle - even) / (largest - even))
      : 1.0;
    for (int k = 0; k < 3; ++k)
    {
      this->InSpace[k + 1] = this->InSpace[k] + angles[k];
      this->InMap[k + 1] = this->InMap[k] + even + share * (factor * angles[k] - even);
    }
  }

  double GetNeighbour(int k) const { return this->InSpace[k]; }
  double At(double angle) const
  {
    const double turns = std::floor(angle / (2.0 * Pi));
    const double rest = angle - 2.0 * Pi * turns;
    const int k = rest < this->InSpace[1] ? 0 : rest < this->InSpace[2] ? 1 : 2;
    const double part = (rest - this->InSpace[k]) / (this->InSpace[k + 1] - this->InSpace[k]);
    return turns * this->Wanted + this->InMap[k] + part * (this->InMap[k + 1] - this->InMap[k]);
  }

private:
  double Wanted;
  std::array<double, 4> InSpace{};
  std::array<double, 4> InMap{};
};

/// The vertices around a cone, with the surface laid flat along the triangle that the cone is in.
class ConeDisk
{
public:
  ConeDisk(const MovablePlaces& places, Index cone)
    : Places(places)
    , Cone(cone)
  {
    const Vector3 first = this->Away(this->Neighbour(0));
    this->Normal = first.cross(this->Away(this->Neighbour(1))).normalized();
    this->X = first.normalized();
    this->Y = this->Normal.cross(this->X);
  }

  struct Vertex
  {
    Index Number;
    /// Around the cone, on the way on which it was reached.
    double Angle;
    Transition ToCone;
  };

  /// From each neighbour to the next one.
  std::array<double, 3> AnglesBetweenNeighbours() const
  {
    std::array<double, 3> angles;
    for (int k = 0; k < 3; ++k)
    {
      angles[k] =
        std::arg(this->Flat(this->Neighbour((k + 1) % 3)) / this->Flat(this->Neighbour(k)));
    }
    return angles;
  }

  double Distance(Index v) const
  {
    return this->Away(v).norm() * this->Places.PerLength[this->Cone];
  }

  /// The vertices of some, ascending, within a radius, the neighbours first.
  std::vector<Vertex> Within(
    double radius, const std::vector<Index>& corners, const StretchedAngles& angles) const
  {
    std::vector<Vertex> reached;
    std::unordered_set<Index> known;
    for (int k = 0; k < 3; ++k)
    {
      const Index t = this->Places.TrianglesAt(this->Cone)[k];
      known.insert(this->Neighbour(k));
      reached.push_back({ this->Neighbour(k), angles.GetNeighbour(k),
        this->Places.Plane.Composed(this->Places.Plane.Inverse(this->Places.FromVertex(t, 0)),
          this->Places.FromVertex(t, 1)) });
    }
    for (std::size_t k = 0; k < reached.size(); ++k)
    {
      const Vertex from = reached[k];
      for (const Index t : this->Places.TrianglesAt(from.Number))
      {
        const Triangle& corner = this->Places.Mesh.Triangles[t].Vertex;
        if (this->Places.IsInTriangle(corner[0]))
        {
          continue;
        }
        const int c = corner[0] == from.Number ? 0 : corner[1] == from.Number ? 1 : 2;
        const Transition ofTriangle = this->Places.Plane.Composed(
          from.ToCone, this->Places.Plane.Inverse(this->Places.FromVertex(t, c)));
        for (int d = 0; d < 3; ++d)
        {
          const Index v = corner[d];
          if (this->Distance(v) < radius &&
            std::abs(this->Normal.dot(this->Away(v))) < MostSlope * this->Away(v).norm() &&
            std::binary_search(corners.begin(), corners.end(), v) && known.insert(v).second)
          {
            reached.push_back({ v, from.Angle + std::arg(this->Flat(v) / this->Flat(from.Number)),
              this->Places.Plane.Composed(ofTriangle, this->Places.FromVertex(t, d)) });
          }
        }
      }
    }
    return reached;
  }

private:
  Index Neighbour(int k) const
  {
    return this->Places.Mesh.Triangles[this->Places.TrianglesAt(this->Cone)[k]].Vertex[1];
  }
  Vector3 Away(Index v) const
  {
    return this->Places.Mesh.Positions[v] - this->Places.Mesh.Positions[this->Cone];
  }
  Complex Flat(Index v) const
  {
    return Complex(this->Away(v).dot(this->X), this->Away(v).dot(this->Y));
  }

  const MovablePlaces& Places;
  Index Cone;
  Vector3 Normal;
  Vector3 X;
  Vector3 Y;
};
}

void OpenCone(MovablePlaces& places, Index cone, const std::vector<Index>& movable,
  const std::vector<Index>& corners, double radius)
{
  const ConeDisk disk(places, cone);
  const std::array<double, 3> between = disk.AnglesBetweenNeighbours();
  if (!(*std::min_element(between.begin(), between.end()) > 0.0))
  {
    // The triangle is too thin to tell.
    return;
  }
  const StretchedAngles angles(between, places.WantedAngle(cone));
  const std::vector<ConeDisk::Vertex> vertices = disk.Within(radius, corners, angles);
  const Complex centre = places.Plane.Place(places.Places[cone]);
  std::vector<Complex> polar;
  Complex turn(0.0);
  for (const ConeDisk::Vertex& vertex : vertices)
  {
    polar.push_back(std::polar(disk.Distance(vertex.Number), angles.At(vertex.Angle)));
    turn += (places.PlaceIn(vertex.ToCone, vertex.Number) - centre) * std::conj(polar.back());
  }
  const Complex phase = std::polar(1.0, std::arg(turn));
  for (std::size_t k = 0; k < vertices.size(); ++k)
  {
    const ConeDisk::Vertex& vertex = vertices[k];
    if (places.GetFreedom(vertex.Number) < 2 ||
      !std::binary_search(movable.begin(), movable.end(), vertex.Number))
    {
      continue;
    }
    const double outwards = std::abs(polar[k]) / radius;
    const double weight = k < 3 ? 1.0 : std::clamp((1.0 - outwards) / (1.0 - InnerPart), 0.0, 1.0);
    const Complex former = places.PlaceIn(vertex.ToCone, vertex.Number);
    places.MoveTo(
      vertex.Number, former + weight * (centre + phase * polar[k] - former), vertex.ToCone);
  }
}
}
