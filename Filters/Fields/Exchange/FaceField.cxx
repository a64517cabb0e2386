// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Exchange/FaceField.h"

#include "Interpolation/FieldInterpolant.h"
#include "Support/Threads.h"

#include <array>
#include <cmath>

namespace DirectionFields
{
namespace
{
/// Sums of vectors below this cancel.
constexpr double LeastPower = 1e-9;

Complex Unit(const Complex& z, const Complex& otherwise)
{
  const double modulus = std::abs(z);
  return modulus > LeastPower && std::isfinite(modulus) ? z / modulus : otherwise;
}

constexpr std::array<double, 3> AtMiddle = { 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0 };

/// Where a face's power stands against a half-edge, to its left.
Complex Against(const FlatTriangle& flat, int corner, const Complex& power, int degree)
{
  return power * IntegerPower(std::conj(flat.Along(corner)), degree);
}
}

FaceField AtCentroids(const GivenField& field)
{
  return AtPlaces(
    field, std::vector<std::array<double, 3>>(field.GetSurface().Triangles.size(), AtMiddle));
}

FaceField AtPlaces(const GivenField& field, const std::vector<std::array<double, 3>>& weights)
{
  const SurfaceGeometry& geometry = field.GetGeometry();
  FaceField faces;
  faces.Degree = field.GetDegree();
  faces.Power.resize(geometry.Mesh.GetNumberOfTriangles());
  ParallelFor(geometry.Mesh.GetNumberOfTriangles(), HeavyPiece,
    [&](Index begin, Index end)
    {
      for (Index t = begin; t < end; ++t)
      {
        const FieldInterpolant interpolant(geometry, faces.Degree, field.GetSection().data(), t);
        const std::array<double, 3>& given = weights[geometry.Mesh.InputTriangle(t)];
        std::array<double, 3> place = given;
        for (int c = 0; given != AtMiddle && c < 3; ++c)
        {
          place[field.MeshCorner(t, c)] = given[c];
        }
        faces.Power[t] = Unit(interpolant.At(interpolant.Flat().Place(place)), 1.0);
      }
    });
  return faces;
}

FaceField FromVectors(const SurfaceGeometry& geometry, int degree,
  const std::vector<Vector3>& vectors, std::size_t perRow)
{
  const TriangleMesh& mesh = geometry.Mesh;
  FaceField faces;
  faces.Degree = degree;
  faces.Power.resize(mesh.GetNumberOfTriangles());
  ParallelFor(mesh.GetNumberOfTriangles(), HeavyPiece,
    [&](Index begin, Index end)
    {
      for (Index t = begin; t < end; ++t)
      {
        const TriangleInSpace axes = InSpace(geometry, t);
        Complex sum = 0.0;
        for (std::size_t k = 0; k < perRow; ++k)
        {
          const Vector3& vector =
            vectors[static_cast<std::size_t>(mesh.InputTriangle(t)) * perRow + k];
          const Vector3 direction = vector.stableNormalized();
          const Complex tangential(direction.dot(axes.X), direction.dot(axes.Y));
          sum += IntegerPower(Unit(tangential, 0.0), degree);
        }
        faces.Power[t] = Unit(sum, 0.0);
      }
    });
  return faces;
}

std::vector<Vector3> DirectionsInSpace(const GivenField& field, const FaceField& faces, int k)
{
  const SurfaceGeometry& geometry = field.GetGeometry();
  const double period = 2.0 * Pi / faces.Degree;
  std::vector<Vector3> directions(field.GetSurface().Triangles.size(), Vector3::Zero());
  ParallelFor(static_cast<Index>(directions.size()), HeavyPiece,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        const Index t = field.GetMeshTriangles()[i];
        if (t == None || faces.Power[t] == 0.0)
        {
          continue;
        }
        const TriangleInSpace axes = InSpace(geometry, t);
        const int axis = std::abs(axes.Normal[0]) < 1.0 - 1e-6 ? 0 : 1;
        const double wanted = std::atan2(axes.Y[axis], axes.X[axis]);
        const double first = std::arg(faces.Power[t]) / faces.Degree;
        const double angle = first + period * (std::round((wanted - first) / period) + k);
        directions[i] = std::cos(angle) * axes.X + std::sin(angle) * axes.Y;
      }
    });
  return directions;
}

std::vector<int> FaceSingularityIndices(const IntrinsicGeometry& geometry, const FaceField& faces)
{
  const TriangleMesh& mesh = geometry.Mesh;
  const auto powerOf = [&](Index t) { return Unit(faces.Power[t], 1.0); };
  // The least rotation from the triangle of each edge's half-edge to that of its twin, once for
  // both of its ends.
  std::vector<double> rotation(mesh.GetNumberOfEdges(), 0.0);
  ParallelFor(mesh.GetNumberOfEdges(), HeavyPiece,
    [&](Index begin, Index end)
    {
      for (Index e = begin; e < end; ++e)
      {
        const Index h = mesh.HalfEdge(e);
        const Index twin = mesh.Twin(h);
        if (twin != None)
        {
          const FlatTriangle here(geometry, h / 3);
          const FlatTriangle there(geometry, twin / 3);
          const double halfTurn = faces.Degree % 2 == 0 ? 1.0 : -1.0;
          rotation[e] =
            std::arg(halfTurn * Against(there, twin % 3, powerOf(twin / 3), faces.Degree) *
              std::conj(Against(here, h % 3, powerOf(h / 3), faces.Degree)));
        }
      }
    });
  std::vector<int> indices(mesh.GetNumberOfVertices(), 0);
  ParallelFor(mesh.GetNumberOfVertices(), MediumPiece,
    [&](Index begin, Index end)
    {
      std::vector<Index> fan;
      for (Index v = begin; v < end; ++v)
      {
        if (mesh.IsBoundary(v))
        {
          continue;
        }
        mesh.GetFan(v, fan);
        double angles = 0.0;
        double turned = 0.0;
        for (const Index h : fan)
        {
          angles += geometry.Lengths.CornerAngle(mesh, h);
          const Index crossed = TriangleMesh::Previous(h);
          const double along = rotation[mesh.Edge(crossed)];
          turned += mesh.GivesDirection(crossed) ? along : -along;
        }
        const double turns = (turned + faces.Degree * (2.0 * Pi - angles)) / (2.0 * Pi);
        indices[v] = static_cast<int>(std::lround(turns));
      }
    });
  return indices;
}

std::vector<Complex> ToVertices(const SurfaceGeometry& geometry, const FaceField& faces)
{
  const TriangleMesh& mesh = geometry.Mesh;
  const std::vector<Complex> none(mesh.GetNumberOfVertices(), 0.0);
  // The part of each corner, weighted by its angle, and that angle.
  std::vector<Complex> parts(mesh.GetNumberOfHalfEdges(), 0.0);
  ParallelFor(mesh.GetNumberOfTriangles(), HeavyPiece,
    [&](Index begin, Index end)
    {
      for (Index t = begin; t < end; ++t)
      {
        const FieldInterpolant triangle(geometry, faces.Degree, none.data(), t);
        const Complex middle = triangle.Flat().Place(AtMiddle);
        const std::array<double, 3> angles = geometry.Lengths.CornerAngles(mesh, t);
        for (int c = 0; c < 3; ++c)
        {
          // The direction at angle 0 in the cone has this angle on the flat triangle.
          const double zero = triangle.AngleInFlat(c, 0.0, middle);
          parts[3 * t + c] = angles[c] * faces.Power[t] * std::polar(1.0, -faces.Degree * zero);
        }
      }
    });
  std::vector<Complex> section(mesh.GetNumberOfVertices(), 0.0);
  ParallelFor(mesh.GetNumberOfVertices(), MediumPiece,
    [&](Index begin, Index end)
    {
      std::vector<Index> fan;
      for (Index v = begin; v < end; ++v)
      {
        mesh.GetFan(v, fan);
        Complex sum = 0.0;
        double weights = 0.0;
        for (const Index h : fan)
        {
          sum += parts[h];
          weights += std::abs(parts[h]);
        }
        section[v] = weights > 0.0 ? Complex(sum / weights) : Complex(0.0);
      }
    });
  return section;
}
}
