// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Streamlines/LineSeeds.h"

#include "Support/Threads.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// Distance of places in large triangles, as a part of the spacing.
constexpr double PlacePart = 0.25;
/// Places along an edge at most.
constexpr double MostAlongEdge = 4096.0;
/// Seeds at vertices are moved by this part of the distance to the middle of a triangle, where
/// directions are defined.
constexpr double OffVertex = 1e-3;
/// How much the area around a vertex weighs against |u|.
constexpr double AreaPart = 1e-4;

bool IsSeeded(const GivenField& field, Index triangle, const std::vector<char>& excluded)
{
  return field.GetMesh().IsFront(triangle) && (excluded.empty() || excluded[triangle] == 0);
}

/// The triangles around a vertex.
struct Star
{
  double Area = 0.0;
  /// The half-edge at the vertex in the largest of them, which does not depend on numbers.
  Index Largest = None;

  Star(const SurfaceGeometry& geometry, Index vertex)
  {
    const Index first = geometry.Mesh.Outgoing(vertex);
    Index h = first;
    do
    {
      const double area = geometry.Lengths.Area[h / 3];
      if (this->Largest == None || area > geometry.Lengths.Area[this->Largest / 3])
      {
        this->Largest = h;
      }
      this->Area += area;
      h = geometry.Mesh.NextOutgoing(h);
    } while (h != None && h != first);
  }
};

/// Adds places that divide a triangle into parts of the given size, in the unit of the component.
void AddInner(const GivenField& field, Index triangle, double size, std::vector<SeedPlace>& places)
{
  const SurfaceGeometry& geometry = field.GetGeometry();
  double longest = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    longest =
      std::max(longest, geometry.Lengths.SquaredLength[geometry.Mesh.Edge(3 * triangle + c)]);
  }
  if (longest <= size * size)
  {
    return;
  }
  const FieldInterpolant power(geometry, field.GetDegree(), field.GetSection().data(), triangle);
  const FlatTriangle& flat = power.Flat();
  longest = std::max({ flat.Length(0), flat.Length(1), flat.Length(2) });
  const int edge = longest == flat.Length(0) ? 0 : longest == flat.Length(1) ? 1 : 2;
  const Complex& along = flat.Along(edge);
  const auto parts = static_cast<int>(std::min(std::ceil(longest / size), MostAlongEdge));
  for (int i = 0; parts > 1 && i < parts; ++i)
  {
    for (int j = 0; i + j < parts; ++j)
    {
      const double a = (i + 1.0 / 3.0) / parts;
      const double b = (j + 1.0 / 3.0) / parts;
      const Complex place = flat.Place({ a, b, 1.0 - a - b });
      places.push_back({ triangle, None, place, along, std::abs(power.At(place)) });
    }
  }
}

/// The place beside a vertex; its triangle is None where none may be.
/// @param mean area of the triangles around a vertex
SeedPlace BesideVertex(
  const GivenField& field, Index vertex, double mean, const std::vector<char>& excluded)
{
  const SurfaceGeometry& geometry = field.GetGeometry();
  const double magnitude = std::abs(field.GetSection()[vertex]);
  SeedPlace place;
  if (!geometry.Mesh.IsFrontVertex(vertex) || magnitude == 0.0)
  {
    return place;
  }
  const Star star(geometry, vertex);
  const Index h = star.Largest;
  if (!IsSeeded(field, h / 3, excluded))
  {
    return place;
  }
  std::array<double, 3> weights = { OffVertex / 3.0, OffVertex / 3.0, OffVertex / 3.0 };
  weights[h % 3] += 1.0 - OffVertex;
  const FlatTriangle flat(geometry, h / 3);
  const double area = std::min(star.Area / mean, 10.0);
  return { h / 3, vertex, flat.Place(weights), flat.Along(h % 3),
    magnitude * (1.0 + AreaPart * area) };
}
}

std::vector<SeedPlace> SeedPlaces(
  const GivenField& field, Index component, double spacing, const std::vector<char>& excluded)
{
  const SurfaceGeometry& geometry = field.GetGeometry();
  const TriangleMesh::Component& range = geometry.Mesh.GetComponents()[component];
  const double size = PlacePart * spacing / geometry.Lengths.Unit[component];
  const double mean = 6.0 * geometry.Lengths.ComponentArea[component] / range.Triangles();
  std::vector<SeedPlace> places(range.Vertices());
  ParallelFor(range.Vertices(), LightPiece,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        places[i] = BesideVertex(field, range.FirstVertex + i, mean, excluded);
      }
    });
  places.erase(std::remove_if(places.begin(), places.end(),
                 [](const SeedPlace& place) { return place.Triangle == None; }),
    places.end());
  const Index pieces = NumberOfPieces(range.Triangles(), LightPiece);
  std::vector<std::vector<SeedPlace>> inner(pieces);
  ParallelFor(range.Triangles(), LightPiece,
    [&](Index begin, Index end)
    {
      for (Index t = range.FirstTriangle + begin; t < range.FirstTriangle + end; ++t)
      {
        if (IsSeeded(field, t, excluded))
        {
          AddInner(field, t, 2.0 * size, inner[begin / LightPiece]);
        }
      }
    });
  for (const std::vector<SeedPlace>& more : inner)
  {
    places.insert(places.end(), more.begin(), more.end());
  }
  return places;
}

LineStart StartAt(const GivenField& field, const SeedPlace& place, int k)
{
  const FieldInterpolant power(
    field.GetGeometry(), field.GetDegree(), field.GetSection().data(), place.Triangle);
  const Complex first =
    TracedField::DirectionNear(power.At(place.Place), field.GetDegree(), place.Along, 1);
  return { place.Triangle, place.Place, first * std::polar(1.0, 2.0 * Pi * k / field.GetDegree()),
    1 };
}
}
