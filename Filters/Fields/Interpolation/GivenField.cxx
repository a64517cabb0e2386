// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Interpolation/GivenField.h"

#include "Interpolation/FieldInterpolant.h"
#include "Mesh/MergePoints.h"
#include "Sections/Singularities.h"
#include "Support/Threads.h"
#include "Support/VectorMath.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace DirectionFields
{
namespace
{
/// Directions that deviate by less are the same but for rounding to single precision.
constexpr double SameDirection = 1e-4;
/// The tangential part of a direction that is left over of one along the normal.
constexpr double LeastTangential = 1e-6;
/// Magnitudes are divided by the largest where that is larger, or smaller than the inverse, and are
/// at least a part of the largest.
constexpr double MostMagnitude = 1e50;
constexpr double LeastOfLargest = 1e-100;

bool IsFinite(const Surface& surface, const Triangle& triangle)
{
  const auto size = static_cast<Index>(surface.Points.size());
  return std::all_of(triangle.begin(), triangle.end(),
    [&](Index i) { return i >= 0 && i < size && surface.Points[i].allFinite(); });
}

bool AllAreFinite(const Surface& surface)
{
  return ParallelSum(static_cast<Index>(surface.Triangles.size()), LightPiece, 0,
           [&](Index begin, Index end)
           {
             int bad = 0;
             for (Index t = begin; t < end; ++t)
             {
               bad += IsFinite(surface, surface.Triangles[t]) ? 0 : 1;
             }
             return bad;
           }) == 0;
}

/// The surface with triangles collapsed that cannot be computed on, so that the others keep their
/// numbers.
Surface WithoutUnsound(const Surface& surface)
{
  Surface sound = surface;
  // Points that are not finite are of no use, but a collapsed triangle has one.
  for (Vector3& point : sound.Points)
  {
    if (!point.allFinite())
    {
      point.setZero();
    }
  }
  for (Triangle& triangle : sound.Triangles)
  {
    if (!IsFinite(surface, triangle))
    {
      triangle = { 0, 0, 0 };
    }
  }
  if (sound.Points.empty())
  {
    sound.Triangles.clear();
  }
  return sound;
}

bool IsDirection(const Vector3& direction, double magnitude)
{
  return direction.allFinite() && !direction.isZero(0.0) && std::isfinite(magnitude) &&
    magnitude > 0.0;
}

/// Whether a direction is one of those at another point of the same place.
bool IsOneOf(const PointDirections& directions, Index point, const Vector3& direction)
{
  double nearest = 2.0;
  for (int k = 0; k < directions.Degree; ++k)
  {
    nearest =
      std::min(nearest, (directions.Direction(point, k).stableNormalized() - direction).norm());
  }
  return nearest < SameDirection;
}
}

PointDirections DirectionsOf(const Result& field)
{
  PointDirections directions;
  directions.Degree = field.Degree;
  directions.Direction = [&field](Index point, int k) { return field.Direction(point, k); };
  directions.Magnitude = [&field](Index point) { return std::abs(field.Representation[point]); };
  return directions;
}

PointDirections DirectionsOf(int degree, const std::vector<Vector3>& vectors)
{
  if (degree < 1 || vectors.size() % static_cast<std::size_t>(degree) != 0)
  {
    throw std::invalid_argument("Each point must have as many vectors as the degree, at least 1.");
  }
  PointDirections directions;
  directions.Degree = degree;
  directions.Direction = [&vectors, degree](Index point, int k)
  { return vectors[static_cast<std::size_t>(point) * degree + k]; };
  directions.Magnitude = [](Index) { return 1.0; };
  return directions;
}

TriangleInSpace InSpace(const SurfaceGeometry& geometry, Index meshTriangle)
{
  const TriangleMesh& mesh = geometry.Mesh;
  TriangleInSpace result;
  for (int c = 0; c < 3; ++c)
  {
    result.Corners[c] = geometry.Positions[mesh.Tail(3 * meshTriangle + c)];
  }
  const Vector3 edge = (result.Corners[1] - result.Corners[0]).stableNormalized();
  const Vector3 other = (result.Corners[2] - result.Corners[0]).stableNormalized();
  const Vector3 normal = edge.cross(other);
  if (normal.squaredNorm() > 1e-24)
  {
    result.Normal = normal.normalized();
    result.X = edge;
  }
  else
  {
    result.Normal = geometry.Frames.Normal[mesh.Tail(3 * meshTriangle)];
    const Vector3 tangential = edge - edge.dot(result.Normal) * result.Normal;
    result.X = tangential.norm() > LeastTangential ? Vector3(tangential.normalized())
                                                   : AnyOrthogonal(result.Normal);
  }
  result.Y = result.Normal.cross(result.X);
  return result;
}

FieldSurface::FieldSurface(const Surface& surface, bool joinsSeams)
{
  const bool isSound = AllAreFinite(surface);
  const Surface mended = isSound ? Surface() : WithoutUnsound(surface);
  const Surface& sound = isSound ? surface : mended;
  MergedMesh mesh = joinsSeams ? MergedMesh::AcrossSeams(sound) : MergedMesh::OfPoints(sound);
  this->FirstPoint = std::move(mesh.FirstPoint);
  this->Geometry = std::make_unique<SurfaceGeometry>(std::move(mesh.Mesh), sound);
  this->MeshTriangle.assign(surface.Triangles.size(), None);
  const TriangleMesh& triangles = this->Geometry->Mesh;
  ParallelFor(triangles.GetNumberOfTriangles(), LightPiece,
    [&](Index begin, Index end)
    {
      for (Index t = begin; t < end; ++t)
      {
        if (triangles.IsFront(t))
        {
          this->MeshTriangle[triangles.InputTriangle(t)] = t;
        }
      }
    });
}

GivenField::GivenField(const Surface& surface, const PointDirections& directions)
  : GivenField(surface, std::make_shared<const FieldSurface>(surface), directions)
{
}

GivenField::GivenField(const Surface& surface, std::shared_ptr<const FieldSurface> made,
  const PointDirections& directions)
  : Input(surface)
  , Degree(directions.Degree)
  , Made(std::move(made))
{
  if (!this->Made->FirstPoint.empty() && !SeamsAgree(directions, this->Made->FirstPoint))
  {
    this->Made = std::make_shared<const FieldSurface>(surface, false);
  }
  this->ReadSection(directions);
}

bool GivenField::SeamsAgree(const PointDirections& directions, const std::vector<Index>& first)
{
  // Only points of triangles are asked, which those at seams are.
  return ParallelSum(static_cast<Index>(first.size()), LightPiece, 0,
           [&](Index begin, Index end)
           {
             int different = 0;
             for (Index i = begin; i < end && different == 0; ++i)
             {
               if (first[i] == i)
               {
                 continue;
               }
               const Vector3 here = directions.Direction(i, 0);
               const Vector3 there = directions.Direction(first[i], 0);
               const bool isHere = IsDirection(here, directions.Magnitude(i));
               const bool isThere = IsDirection(there, directions.Magnitude(first[i]));
               different += isHere && isThere
                 ? !IsOneOf(directions, first[i], here.stableNormalized())
                 : isHere != isThere;
             }
             return different;
           }) == 0;
}

double GivenField::LargestMagnitude(const PointDirections& directions) const
{
  const TriangleMesh& mesh = this->GetMesh();
  const Index vertices = mesh.GetNumberOfVertices();
  std::vector<double> largest(NumberOfPieces(vertices, MediumPiece) + 1, 0.0);
  ParallelFor(vertices, MediumPiece,
    [&](Index begin, Index end)
    {
      double most = 0.0;
      for (Index v = begin; v < end; ++v)
      {
        const double magnitude = directions.Magnitude(mesh.Point(v));
        most = std::isfinite(magnitude) ? std::max(most, magnitude) : most;
      }
      largest[begin / MediumPiece] = most;
    });
  return *std::max_element(largest.begin(), largest.end());
}

void GivenField::ReadSection(const PointDirections& directions)
{
  const TriangleMesh& mesh = this->GetMesh();
  this->Section.resize(mesh.GetNumberOfVertices());
  const double largest = this->LargestMagnitude(directions);
  // Only their ratios count, but squares must be numbers.
  const bool isExtreme = largest > MostMagnitude || largest < 1.0 / MostMagnitude;
  const double factor = isExtreme ? 1.0 / std::max(largest, 1e-300) : 1.0;
  ParallelFor(mesh.GetNumberOfVertices(), MediumPiece,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        const Vector3 direction = directions.Direction(mesh.Point(v), 0);
        const double magnitude = directions.Magnitude(mesh.Point(v));
        this->Section[v] = 0.0;
        if (IsDirection(direction, magnitude))
        {
          const Complex tangential =
            this->GetGeometry().Frames.Tangential(v, direction.stableNormalized());
          const double length = Modulus(tangential);
          if (length > LeastTangential)
          {
            const double size = std::max(magnitude, LeastOfLargest * largest);
            this->Section[v] = factor * size * IntegerPower(tangential / length, this->Degree);
          }
        }
      }
    });
}

std::vector<int> GivenField::Indices() const
{
  return SingularityIndices(this->GetGeometry(), this->Degree, this->Section);
}

int GivenField::MeshCorner(Index meshTriangle, int c) const
{
  const Triangle& points = this->Input.Triangles[this->GetMesh().InputTriangle(meshTriangle)];
  for (int corner = 0; corner < 3; ++corner)
  {
    if (this->PointAt(meshTriangle, corner) == points[c])
    {
      return corner;
    }
  }
  return None;
}

Index GivenField::PointAt(Index meshTriangle, int meshCorner) const
{
  const TriangleMesh& mesh = this->GetMesh();
  const Index point = mesh.Point(mesh.Tail(3 * meshTriangle + meshCorner));
  if (!this->Made->FirstPoint.empty())
  {
    for (const Index i : this->Input.Triangles[mesh.InputTriangle(meshTriangle)])
    {
      if (this->Made->FirstPoint[i] == point)
      {
        return i;
      }
    }
  }
  return point;
}
}
