// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Comparison/FieldDifference.h"

#include "Distance/SurfaceDistance.h"
#include "Interpolation/FieldInterpolant.h"
#include "Interpolation/InterpolantZero.h"
#include "Support/Threads.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace DirectionFields
{
namespace
{
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double LeastTangential = 1e-6;

bool IsGhost(const Surface& surface, Index triangle)
{
  return !surface.Ghost.empty() && surface.Ghost[triangle] != 0;
}

/// The vertex of each point of the surface; None where no triangle uses it.
std::vector<Index> VerticesOfPoints(const GivenField& field)
{
  const Surface& surface = field.GetSurface();
  std::vector<Index> vertices(surface.Points.size(), None);
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    const Index at = field.GetMeshTriangles()[t];
    for (int c = 0; at != None && c < 3; ++c)
    {
      Index& vertex = vertices[surface.Triangles[t][c]];
      vertex = vertex == None ? field.GetMesh().Tail(3 * at + field.MeshCorner(at, c)) : vertex;
    }
  }
  return vertices;
}

/// The index of the component of a triangle.
std::size_t ComponentOf(const TriangleMesh& mesh, Index triangle)
{
  const auto& components = mesh.GetComponents();
  const auto after = std::upper_bound(components.begin(), components.end(), triangle,
    [](Index t, const TriangleMesh::Component& c) { return t < c.FirstTriangle; });
  return static_cast<std::size_t>(after - components.begin()) - 1;
}

/// The power of the directions at a point in the tangent plane of its vertex; 0 where there are
/// none.
Complex PowerAt(
  const SurfaceGeometry& geometry, Index vertex, const PointDirections& directions, Index point)
{
  const Vector3 direction = directions.Direction(point, 0);
  const double magnitude = directions.Magnitude(point);
  if (!direction.allFinite() || !std::isfinite(magnitude) || !(magnitude > 0.0))
  {
    return 0.0;
  }
  const Complex tangential = geometry.Frames.Tangential(vertex, direction.stableNormalized());
  const double length = std::abs(tangential);
  return length > LeastTangential ? IntegerPower(tangential / length, directions.Degree)
                                  : Complex(0.0);
}

/// A third of the triangles at each point of the surface, ghosts left out, in the square of the
/// largest unit of a component, as that of the surface may be too large for squares.
std::vector<double> AreasOfPoints(const GivenField& field)
{
  const Surface& surface = field.GetSurface();
  const SurfaceGeometry& geometry = field.GetGeometry();
  std::vector<double> areas(surface.Points.size(), 0.0);
  const std::vector<double>& units = geometry.Lengths.Unit;
  const double largest = units.empty() ? 1.0 : *std::max_element(units.begin(), units.end());
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    const Index at = field.GetMeshTriangles()[t];
    if (at != None && !IsGhost(surface, static_cast<Index>(t)))
    {
      const double unit = units[ComponentOf(geometry.Mesh, at)] / largest;
      for (const Index point : surface.Triangles[t])
      {
        areas[point] += geometry.Lengths.Area[at] * unit * unit / 3.0;
      }
    }
  }
  return areas;
}

/// The place of a zero of one field on the mesh of another one that has the same surface.
MeshPlace PlaceOn(const GivenField& field, const GivenField& from, Index meshTriangle,
  const std::array<double, 3>& weights)
{
  const Index triangle = from.GetMesh().InputTriangle(meshTriangle);
  MeshPlace place;
  place.Triangle = field.GetMeshTriangles()[triangle];
  for (int c = 0; place.Triangle != None && c < 3; ++c)
  {
    place.Weights[field.MeshCorner(place.Triangle, c)] = weights[from.MeshCorner(meshTriangle, c)];
  }
  return place;
}

/// A list of singularities and their places on the mesh of the first field.
struct Singularities
{
  std::vector<ComparedSingularity> List;
  std::vector<MeshPlace> Places;

  void Add(int number, const GivenField& field, const GivenField& first)
  {
    const std::vector<int> indices = field.Indices();
    const Surface& surface = field.GetSurface();
    for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
    {
      const Index at = field.GetMeshTriangles()[t];
      if (at == None || indices[at] == 0 || IsGhost(surface, static_cast<Index>(t)))
      {
        continue;
      }
      const FieldInterpolant interpolant(
        field.GetGeometry(), field.GetDegree(), field.GetSection().data(), at);
      const bool isSimple = std::abs(indices[at]) == 1;
      const std::array<double, 3> middle = { 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0 };
      const std::array<double, 3> weights =
        isSimple ? interpolant.Flat().Weights(FindZero(interpolant, indices[at]).Place) : middle;
      this->List.push_back({ number, indices[at], static_cast<Index>(t),
        field.InSpace(at).Position(weights), None, NotANumber });
      this->Places.push_back(PlaceOn(first, field, at, weights));
    }
  }
};

/// A singularity and how far it is.
struct Neighbour
{
  Index Number = None;
  double Distance = std::numeric_limits<double>::infinity();
};

/// For each of some singularities the nearest of others along the surface.
std::vector<Neighbour> Nearest(const IntrinsicGeometry& geometry, const Singularities& all,
  const std::vector<Index>& from, const std::vector<Index>& to)
{
  std::vector<SurfaceDistance::Seed> seeds;
  std::multimap<Index, Index> within;
  for (const Index i : to)
  {
    SurfaceDistance::AddSeeds(geometry, all.Places[i], i, seeds);
    within.emplace(all.Places[i].Triangle, i);
  }
  std::vector<Index> corners;
  for (const Index i : from)
  {
    for (int c = 0; c < 3; ++c)
    {
      corners.push_back(geometry.Mesh.Tail(3 * all.Places[i].Triangle + c));
    }
  }
  const SurfaceDistance distance(geometry, seeds, std::numeric_limits<double>::infinity(),
    SurfaceDistance::Sources::Points, corners);
  std::vector<Neighbour> nearest(from.size());
  for (std::size_t k = 0; k < from.size(); ++k)
  {
    const MeshPlace& place = all.Places[from[k]];
    nearest[k].Distance = distance.At(geometry, place, nearest[k].Number);
    // Within one triangle the shortest path is straight and avoids the corners.
    const auto range = within.equal_range(place.Triangle);
    for (auto i = range.first; i != range.second; ++i)
    {
      const double direct = (all.List[i->second].Position - all.List[from[k]].Position).norm() /
        geometry.Lengths.Unit[ComponentOf(geometry.Mesh, place.Triangle)];
      if (direct < nearest[k].Distance)
      {
        nearest[k] = { i->second, direct };
      }
    }
  }
  return nearest;
}

/// Matches those of the left that are nearest to each other, and takes them out. Returns whether
/// there were any.
bool MatchRound(
  const SurfaceGeometry& geometry, Singularities& all, std::array<std::vector<Index>, 2>& left)
{
  const std::vector<Neighbour> there = Nearest(geometry, all, left[0], left[1]);
  const std::vector<Neighbour> back = Nearest(geometry, all, left[1], left[0]);
  std::vector<Index> nearestOf(all.List.size(), None);
  for (std::size_t k = 0; k < left[1].size(); ++k)
  {
    nearestOf[left[1][k]] = back[k].Number;
  }
  // The two nearest of all match even if the distances there and back, which differ a little, do
  // not agree on it.
  std::size_t best = 0;
  for (std::size_t k = 0; k < there.size(); ++k)
  {
    best = there[k].Distance < there[best].Distance ? k : best;
  }
  bool any = false;
  for (std::size_t k = 0; k < left[0].size(); ++k)
  {
    const Index i = left[0][k];
    const Index j = there[k].Number;
    if (j == None || all.List[j].Match != None || (nearestOf[j] != i && k != best))
    {
      continue;
    }
    const std::size_t c = ComponentOf(geometry.Mesh, all.Places[i].Triangle);
    all.List[i].Match = j;
    all.List[j].Match = i;
    all.List[i].Distance = all.List[j].Distance = there[k].Distance * geometry.Lengths.Unit[c];
    any = true;
  }
  for (std::vector<Index>& side : left)
  {
    side.erase(
      std::remove_if(side.begin(), side.end(), [&](Index i) { return all.List[i].Match != None; }),
      side.end());
  }
  return any;
}
}

FieldDifference Compare(
  const GivenField& field, const PointDirections& one, const PointDirections& other)
{
  const SurfaceGeometry& geometry = field.GetGeometry();
  const std::vector<Index> vertices = VerticesOfPoints(field);
  const std::vector<double> areas = AreasOfPoints(field);
  FieldDifference difference;
  difference.Angle.assign(vertices.size(), 0.0);
  double area = 0.0;
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    const Index v = vertices[i];
    if (v == None)
    {
      continue;
    }
    // The points of one vertex may differ a little: each is compared by its own directions.
    const Complex first = PowerAt(geometry, v, one, static_cast<Index>(i));
    const Complex second = PowerAt(geometry, v, other, static_cast<Index>(i));
    if (first == 0.0 || second == 0.0)
    {
      difference.Angle[i] = NotANumber;
      continue;
    }
    const double angle =
      std::abs(std::arg(first * std::conj(second))) / field.GetDegree() * (180.0 / Pi);
    difference.Angle[i] = angle;
    difference.Mean += areas[i] * angle;
    difference.Maximum = areas[i] > 0.0 ? std::max(difference.Maximum, angle) : difference.Maximum;
    area += areas[i];
  }
  difference.Mean = area > 0.0 ? difference.Mean / area : 0.0;
  return difference;
}

std::vector<ComparedSingularity> MatchSingularities(
  const GivenField& one, const GivenField& other, const Progress& progress)
{
  Singularities all;
  all.Add(0, one, one);
  all.Add(1, other, one);
  std::map<int, std::array<std::vector<Index>, 2>> ofIndex;
  for (std::size_t i = 0; i < all.List.size(); ++i)
  {
    if (all.Places[i].Triangle != None)
    {
      ofIndex[all.List[i].SingularityIndex][static_cast<std::size_t>(all.List[i].Field)].push_back(
        static_cast<Index>(i));
    }
  }
  for (auto& [index, left] : ofIndex)
  {
    for (int round = 0; round < MostRounds && !left[0].empty() && !left[1].empty(); ++round)
    {
      progress.RequireToGoOn();
      if (!MatchRound(one.GetGeometry(), all, left))
      {
        break;
      }
    }
  }
  progress.Report(1.0);
  return all.List;
}
}
