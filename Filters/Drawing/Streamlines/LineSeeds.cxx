// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Streamlines/LineSeeds.h"

#include "Support/Threads.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>

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
/// Triangles whose height is less than this part of the distance of places are narrow.
constexpr double NarrowPart = 0.25;
/// Triangles that are longer than so many heights have rows of places along their longest edge.
constexpr double LongPart = 4.0;
/// Places along a narrow triangle are moved by this part of the distance to its middle, over the
/// number of places.
constexpr double Inwards = 0.1;
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

/// Whether a place has its turn before another one in triangles.
bool IsEarlier(const SeedPlace& a, const SeedPlace& b)
{
  return a.Rank != b.Rank ? a.Rank > b.Rank : a.Triangle < b.Triangle;
}

/// The earliest place in each cell of a grid in space, apart for surfaces that face different sides
/// there: of many triangles much narrower than a cell, as around the tip of a cone, few have one.
/// Which places these are does not depend on the order in which they come.
class ThinnedPlaces
{
public:
  void Add(const GivenField& field, double size, const SeedPlace& place)
  {
    const TriangleInSpace space = field.InSpace(place.Triangle);
    const Vector3 position =
      space.Position(FlatTriangle(field.GetGeometry(), place.Triangle).Weights(place.Place));
    std::array<std::int64_t, 4> cell;
    int widest = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      cell[axis] =
        static_cast<std::int64_t>(std::clamp(std::floor(position[axis] / size), -1e18, 1e18));
      widest = std::abs(space.Normal[axis]) > std::abs(space.Normal[widest]) ? axis : widest;
    }
    cell[3] = 2 * widest + (space.Normal[widest] < 0.0 ? 1 : 0);
    this->Add(cell, place);
  }
  void Add(const ThinnedPlaces& others)
  {
    for (const auto& [cell, place] : others.PlaceOf)
    {
      this->Add(cell, place);
    }
  }
  void AppendTo(std::vector<SeedPlace>& places) const
  {
    for (const auto& [cell, place] : this->PlaceOf)
    {
      places.push_back(place);
    }
  }

private:
  void Add(const std::array<std::int64_t, 4>& cell, const SeedPlace& place)
  {
    const auto [at, isNew] = this->PlaceOf.emplace(cell, place);
    if (!isNew && IsEarlier(place, at->second))
    {
      at->second = place;
    }
  }

  std::map<std::array<std::int64_t, 4>, SeedPlace> PlaceOf;
};

/// Places in triangles that are larger than a size: all of those that divide triangles as wide as
/// that, and some of those along the narrow ones.
struct InnerPlaces
{
  std::vector<SeedPlace> All;
  ThinnedPlaces Narrow;

  /// Adds the places that divide a triangle into parts of a size, in the unit of the component.
  /// @param unit of the component
  void Add(const GivenField& field, Index triangle, double size, double unit)
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
    const double height = 2.0 * flat.Area() / longest;
    const auto add = [&](const std::array<double, 3>& weights)
    {
      const Complex place = flat.Place(weights);
      const SeedPlace seed{ triangle, None, place, along, std::abs(power.At(place)) };
      if (height < size)
      {
        this->Narrow.Add(field, 0.5 * size * unit, seed);
      }
      else
      {
        this->All.push_back(seed);
      }
    };
    if (height < NarrowPart * size)
    {
      AddAlongEdge(edge, parts, add);
    }
    else if (longest > LongPart * height)
    {
      AddRows(
        edge, parts, static_cast<int>(std::min(std::ceil(height / size), MostAlongEdge)), add);
    }
    else
    {
      AddEvenly(parts, add);
    }
  }

private:
  /// Parts of a triangle that is about as wide as long.
  template <typename Taker>
  static void AddEvenly(int parts, const Taker& add)
  {
    for (int i = 0; parts > 1 && i < parts; ++i)
    {
      for (int j = 0; i + j < parts; ++j)
      {
        const double a = (i + 1.0 / 3.0) / parts;
        const double b = (j + 1.0 / 3.0) / parts;
        add({ a, b, 1.0 - a - b });
      }
    }
  }
  /// From the middles of the parts of an edge a little way into the triangle.
  template <typename Taker>
  static void AddAlongEdge(int edge, int parts, const Taker& add)
  {
    for (int i = 0; parts > 1 && i < parts; ++i)
    {
      const double inwards = Inwards / parts;
      std::array<double, 3> weights = { inwards / 3.0, inwards / 3.0, inwards / 3.0 };
      weights[edge] += (1.0 - inwards) * (1.0 - (i + 0.5) / parts);
      weights[(edge + 1) % 3] += (1.0 - inwards) * (i + 0.5) / parts;
      add(weights);
    }
  }
  /// Rows of parts along the longest edge, which get shorter towards the other corner.
  template <typename Taker>
  static void AddRows(int edge, int parts, int rows, const Taker& add)
  {
    for (int row = 0; parts > 1 && row < rows; ++row)
    {
      std::array<double, 3> weights;
      weights[(edge + 2) % 3] = (row + 1.0 / 3.0) / rows;
      const double left = 1.0 - weights[(edge + 2) % 3];
      const int ofRow = std::max(1, static_cast<int>(std::ceil(left * parts)));
      for (int i = 0; i < ofRow; ++i)
      {
        weights[edge] = left * (1.0 - (i + 0.5) / ofRow);
        weights[(edge + 1) % 3] = left * (i + 0.5) / ofRow;
        add(weights);
      }
    }
  }
};

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
  std::vector<InnerPlaces> inner(pieces);
  ParallelFor(range.Triangles(), LightPiece,
    [&](Index begin, Index end)
    {
      for (Index t = range.FirstTriangle + begin; t < range.FirstTriangle + end; ++t)
      {
        if (IsSeeded(field, t, excluded))
        {
          inner[begin / LightPiece].Add(field, t, 2.0 * size, geometry.Lengths.Unit[component]);
        }
      }
    });
  ThinnedPlaces narrow;
  for (const InnerPlaces& more : inner)
  {
    places.insert(places.end(), more.All.begin(), more.All.end());
    narrow.Add(more.Narrow);
  }
  narrow.AppendTo(places);
  return places;
}

namespace
{
/// Longer triangles, in the spacing, count with their length, whatever lies beside them.
constexpr double MostSteps = 4096.0;

/// Cells of a grid in space, apart for surfaces that face different sides there.
class CellsInSpace
{
public:
  CellsInSpace(const GivenField& field, double size)
    : Field(field)
    , Size(size)
  {
  }

  std::size_t Count() const { return this->Cells.size(); }

  /// Adds the cells along the longest edge of a triangle.
  void Add(Index triangle, int edge, double length)
  {
    const TriangleInSpace space = this->Field.InSpace(triangle);
    int widest = 0;
    space.Normal.cwiseAbs().maxCoeff(&widest);
    const int facing = 2 * widest + (space.Normal[widest] < 0.0 ? 1 : 0);
    const auto steps = static_cast<int>(std::ceil(length));
    for (int i = 0; i < steps; ++i)
    {
      std::array<double, 3> weights = {};
      weights[edge] = 1.0 - (i + 0.5) / steps;
      weights[(edge + 1) % 3] = (i + 0.5) / steps;
      const Vector3 position = space.Position(weights);
      std::array<std::int64_t, 4> cell;
      for (int axis = 0; axis < 3; ++axis)
      {
        cell[axis] = static_cast<std::int64_t>(
          std::clamp(std::floor(position[axis] / this->Size), -1e18, 1e18));
      }
      cell[3] = facing;
      this->Cells.insert(cell);
    }
  }

private:
  const GivenField& Field;
  double Size;
  std::set<std::array<std::int64_t, 4>> Cells;
};
}

double FilledSquares(const GivenField& field, Index component, double spacing, double most)
{
  const SurfaceGeometry& geometry = field.GetGeometry();
  const TriangleMesh::Component& range = geometry.Mesh.GetComponents()[component];
  CellsInSpace narrow(field, spacing * geometry.Lengths.Unit[component]);
  double squares = 0.0;
  for (Index t = range.FirstTriangle; t < range.EndTriangle; ++t)
  {
    double longest = 0.0;
    int edge = 0;
    for (int k = 0; k < 3; ++k)
    {
      const double length =
        std::sqrt(geometry.Lengths.SquaredLength[geometry.Mesh.Edge(3 * t + k)]) / spacing;
      edge = length > longest ? k : edge;
      longest = std::max(longest, length);
    }
    const double filled = geometry.Lengths.Area[t] / spacing / spacing;
    // Lower than the spacing.
    const bool isNarrow = longest > 1.0 && 2.0 * filled < longest;
    if (isNarrow && longest <= MostSteps)
    {
      narrow.Add(t, edge, longest);
    }
    else
    {
      squares += isNarrow ? longest : filled;
    }
    if (squares + static_cast<double>(narrow.Count()) > most)
    {
      break;
    }
  }
  return squares + static_cast<double>(narrow.Count());
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
