// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_CutExample_h
#define DirectionFields_CutExample_h

#include "Charts/CutGraph.h"
#include "Charts/CutMesh.h"
#include "Extraction/ExtractionMesh.h"
#include "Guidance/Guidance.h"
#include "Parametrization/IntegerGridMap.h"

#include <random>
#include <set>
#include <string>
#include <vector>

/// Surfaces with a field, cut open so that they can be mapped.
namespace Meshes
{
using namespace DirectionFields;
using namespace DirectionFields::Internal;

/// The section of a field with many singularities: an independent angle at each vertex.
inline std::vector<Complex> RandomSection(const SurfaceGeometry& geometry, unsigned seed)
{
  std::mt19937 engine(seed);
  std::vector<Complex> section(geometry.Mesh.GetNumberOfVertices());
  for (Complex& z : section)
  {
    z = std::polar(1.0, engine() / 4294967296.0 * 2.0 * Pi);
  }
  return section;
}

/// The section of the field along a vector at each point, for example the tangents of the parallels
/// of a torus.
template <typename Direction>
std::vector<Complex> SectionAlong(
  const SurfaceGeometry& geometry, int degree, const Direction& direction)
{
  Guidance guidance;
  guidance.Vectors.resize(geometry.Positions.size());
  for (Index v = 0; v < geometry.Mesh.GetNumberOfVertices(); ++v)
  {
    guidance.Vectors[geometry.Mesh.Point(v)] = direction(geometry.Positions[v]);
  }
  return GuidanceSection(geometry, guidance, degree);
}

/// The first component of a surface, cut along its cut graph.
struct CutExample
{
  /// @param isFeature of each edge; empty for no features besides the boundary
  template <typename MakeSection>
  CutExample(const Surface& surface, int degree, const MakeSection& section,
    const std::vector<char>& isFeature = {})
    : Geometry(surface)
    , Section(section(this->Geometry))
    , Matching(this->Geometry, degree, this->Section)
    , IsFrameless(FramelessVertices(this->Geometry, degree, isFeature))
    , Features(this->Geometry, this->Matching, isFeature, this->IsFrameless,
        std::vector<double>(this->Geometry.Mesh.GetComponents().size(), 0.1))
    , Component(this->Geometry.Mesh.GetComponents().front())
    , Graph(this->Geometry, this->Component, this->Matching, this->Features, this->IsFrameless)
    , Mesh(this->Geometry, this->Component, this->Matching, this->Features, this->IsFrameless,
        this->Graph, this->Section)
  {
  }
  CutExample(const CutExample&) = delete;

  static CutExample Random(const Surface& surface, int degree, unsigned seed)
  {
    return { surface, degree,
      [&](const SurfaceGeometry& geometry) { return RandomSection(geometry, seed); } };
  }
  /// The field along the x-axis, projected to the surface.
  static CutExample AlongX(const Surface& surface, int degree)
  {
    return { surface, degree, [&](const SurfaceGeometry& geometry) {
              return SectionAlong(
                geometry, degree, [](const Vector3&) { return Vector3(1.0, 0.0, 0.0); });
            } };
  }
  /// The field along the parallels of a surface of revolution about the z-axis.
  static CutExample AlongParallels(const Surface& surface, int degree)
  {
    return { surface, degree,
      [&](const SurfaceGeometry& geometry)
      {
        return SectionAlong(
          geometry, degree, [](const Vector3& p) { return Vector3(-p.y(), p.x(), 0.0); });
      } };
  }

  /// The settings for edges of one length.
  IntegerGridMap::Settings Settings(double perLength) const
  {
    IntegerGridMap::Settings settings;
    settings.PerLength.assign(this->Mesh.Positions.size(), perLength);
    return settings;
  }

  SurfaceGeometry Geometry;
  std::vector<Complex> Section;
  FieldMatching Matching;
  std::vector<char> IsFrameless;
  FeatureLines Features;
  const TriangleMesh::Component& Component;
  CutGraph Graph;
  CutMesh Mesh;
};

/// Twice the area of the images of all triangles of a mesh in parallelograms of the grid, exactly, in
/// units of 1 / IntegerGrid::Unit^2. Flipped triangles count as negative.
__extension__ using WideInteger = __int128;
inline WideInteger TwiceAreaOfTriangle(const GridPoint& p, const GridPoint& q, const GridPoint& r)
{
  const GridPoint u = q - p;
  const GridPoint v = r - p;
  return static_cast<WideInteger>(u.A) * v.B - static_cast<WideInteger>(u.B) * v.A;
}
inline WideInteger TwiceAreaOf(const std::vector<GridPoint>& corners)
{
  WideInteger area = 0;
  for (std::size_t h = 0; h < corners.size(); h += 3)
  {
    area += TwiceAreaOfTriangle(corners[h], corners[h + 1], corners[h + 2]);
  }
  return area;
}
inline WideInteger TwiceAreaOf(const ExtractionMesh& mesh)
{
  WideInteger area = 0;
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    if (mesh.IsTriangle(t))
    {
      area += TwiceAreaOfTriangle(mesh.Place(3 * t), mesh.Place(3 * t + 1), mesh.Place(3 * t + 2));
    }
  }
  return area;
}
constexpr WideInteger SquaredUnit = static_cast<WideInteger>(IntegerGrid::Unit) * IntegerGrid::Unit;

/// The first fault of the links and charts of a mesh; empty if there is none.
inline std::string FlawOf(const ExtractionMesh& mesh)
{
  std::set<std::array<Index, 2>> edges;
  for (Index h = 0; h < 3 * mesh.GetNumberOfTriangles(); ++h)
  {
    if (!mesh.IsTriangle(h / 3))
    {
      continue;
    }
    if (!mesh.IsVertex(mesh.Tail(h)))
    {
      return "a corner that is no vertex";
    }
    if (!edges.insert({ mesh.Tail(h), mesh.Head(h) }).second)
    {
      return "an edge twice";
    }
    const Index g = mesh.Twin(h);
    if (g == None)
    {
      continue;
    }
    if (mesh.Twin(g) != h || mesh.Tail(g) != mesh.Head(h) || mesh.Head(g) != mesh.Tail(h) ||
      mesh.Feature(g) != mesh.Feature(h))
    {
      return "neighbours that are not mutual";
    }
    if (mesh.GetPlane().Apply(mesh.Across(h), mesh.Place(g)) !=
        mesh.Place(ExtractionMesh::Next(h)) ||
      mesh.GetPlane().Apply(mesh.Across(h), mesh.Place(ExtractionMesh::Next(g))) != mesh.Place(h))
    {
      return "charts that do not agree";
    }
  }
  return "";
}
}

#endif
