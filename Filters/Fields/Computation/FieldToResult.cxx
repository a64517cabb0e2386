// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Computation/FieldToResult.h"

#include "Mesh/OutputPoints.h"
#include "Mesh/OwnedParts.h"
#include "Sections/DoubleCover.h"
#include "Sections/SectionDirections.h"
#include "Sections/Singularities.h"
#include "Support/Division.h"
#include "Support/Threads.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
constexpr Index PieceSize = 1 << 13;

/// The share of the vertices whose vectors have faded.
double FadedShare(const TriangleMesh& mesh, const std::vector<Complex>& section)
{
  std::size_t faded = 0;
  for (const TriangleMesh::Component& component : mesh.GetComponents())
  {
    double longest = 0.0;
    for (Index v = component.FirstVertex; v < component.EndVertex; ++v)
    {
      longest = std::max(longest, std::norm(section[v]));
    }
    const auto begin = section.begin();
    faded += std::count_if(begin + component.FirstVertex, begin + component.EndVertex,
      [&](const Complex& u) { return std::norm(u) < FadedPart * FadedPart * longest; });
  }
  return section.empty() ? 0.0 : static_cast<double>(faded) / section.size();
}

/// Where symmetry makes a value vanish up to rounding, but not those of all neighbours, its
/// direction becomes the first axis of the frame: the one that rounding leaves would depend on the
/// numbering of the points.
void TurnVanishing(const SurfaceGeometry& geometry, int degree, std::vector<Complex>& section)
{
  constexpr double vanishing = 1e-12 * 1e-12;
  const TriangleMesh& mesh = geometry.Mesh;
  std::vector<Index> fan;
  for (const TriangleMesh::Component& component : mesh.GetComponents())
  {
    double largest = 0.0;
    for (Index v = component.FirstVertex; v < component.EndVertex; ++v)
    {
      largest = std::max(largest, std::norm(section[v]));
    }
    for (Index v = component.FirstVertex; v < component.EndVertex; ++v)
    {
      // Few fans are looked at.
      if (!(std::norm(section[v]) < vanishing * largest) || !mesh.IsFrontVertex(v))
      {
        continue;
      }
      double beside = 0.0;
      mesh.GetFan(v, fan);
      for (const Index h : fan)
      {
        beside = std::max({ beside, std::norm(section[mesh.Head(h)]),
          std::norm(section[mesh.Tail(TriangleMesh::Previous(h))]) });
      }
      if (std::norm(section[v]) < vanishing * beside)
      {
        section[v] = std::abs(section[v]);
        if (component.IsCover)
        {
          section[mesh.MirrorVertex(v)] =
            DoubleCover(geometry, component, degree).Mirrored(v, section[v]);
        }
      }
    }
  }
}

/// Fills in the counts of each component's part that belongs to this piece of the surface.
void AddCounts(
  const TriangleMesh& mesh, const OwnedParts& owned, std::vector<ComponentReport>& reports)
{
  for (std::size_t c = 0; c < reports.size(); ++c)
  {
    const TriangleMesh::Component& component = mesh.GetComponents()[c];
    const OwnedParts::Counts& counts = owned.Components[c];
    ComponentReport& report = reports[c];
    report.EulerCharacteristic = counts.Vertices - counts.Edges + counts.Triangles;
    report.Vertices = counts.Vertices;
    report.Triangles = counts.Triangles;
    report.Closed = component.Closed && counts.Ghosts == 0;
  }
}

/// Counts the constraints of each component's part that belongs to this piece of the surface.
void CountConstraints(const TriangleMesh& mesh, const Surface& surface,
  const Constraints& constraints, std::vector<ComponentReport>& reports)
{
  const OwnedParts owned(mesh, surface);
  for (std::size_t c = 0; c < reports.size(); ++c)
  {
    const TriangleMesh::Component& component = mesh.GetComponents()[c];
    for (Index v = component.FirstVertex; v < component.EndVertex; ++v)
    {
      const bool counted = constraints.Kind[v] != ConstraintKind::None && mesh.IsFrontVertex(v) &&
        (owned.Vertex.empty() || owned.Vertex[v]);
      reports[c].Constraints += counted ? 1 : 0;
    }
  }
}

/// Fills in the triangles' arrays and the index sums. The reports are there already.
void AddTriangles(
  const TriangleMesh& mesh, const Surface& surface, const std::vector<int>& indices, Result& result)
{
  const auto fill = [&](std::vector<Index>& values, Index value)
  {
    values.reserve(surface.Triangles.size());
    PreferLargePages(values.data(), surface.Triangles.size() * sizeof(Index));
    values.assign(surface.Triangles.size(), value);
  };
  fill(result.SingularityIndex, 0);
  fill(result.Component, None);
  mesh.ForEachComponent(
    [&](Index c)
    {
      const TriangleMesh::Component& component = mesh.GetComponents()[c];
      result.Components[c].IndexSum = ParallelSum(component.Triangles(), PieceSize, 0,
        [&](Index begin, Index end)
        {
          int sum = 0;
          for (Index t = component.FirstTriangle + begin; t < component.FirstTriangle + end; ++t)
          {
            if (!mesh.IsFront(t))
            {
              continue;
            }
            const Index input = mesh.InputTriangle(t);
            result.SingularityIndex[input] = indices[t];
            result.Component[input] = c;
            const bool counts = surface.Ghost.empty() || surface.Ghost[input] == 0;
            sum += counts ? indices[t] : 0;
          }
          return sum;
        });
    });
}

/// EnergyDensity in the unit of the input.
std::vector<double> DensityPerArea(
  const SurfaceGeometry& geometry, int degree, const std::vector<Complex>& section)
{
  std::vector<double> density = EnergyDensity(geometry, degree, section);
  geometry.Mesh.ForEachComponent(
    [&](Index c)
    {
      const TriangleMesh::Component& component = geometry.Mesh.GetComponents()[c];
      const double unit = geometry.Lengths.Unit[c];
      ParallelFor(component.Vertices(), PieceSize,
        [&](Index begin, Index end)
        {
          for (Index v = component.FirstVertex + begin; v < component.FirstVertex + end; ++v)
          {
            density[v] = PerSquare(density[v], unit);
          }
        });
    });
  return density;
}
}

void NoteFading(double share, std::vector<std::string>& notes)
{
  // A field that has faded at fewer points needs no note.
  constexpr double noted = 0.5;
  if (share > noted)
  {
    notes.push_back("The field has faded at " + std::to_string(std::lround(100.0 * share)) +
      " % of the points, to less than 1e-5 of its greatest magnitude: directions are arbitrary "
      "there and depend on the solver, as on very rough surfaces. Switch on Unit Length, or smooth "
      "the surface first.");
  }
}

Result ToResult(Stages& stages, const Options& options, const Guide& guide, ComponentFields fields,
  std::vector<std::string> notes)
{
  const Constraints& constraints = guide.GetConstraints();
  Result result;
  result.Degree = options.Degree;
  result.UnitLength = options.UnitLength;
  result.Repaired.MergedPoints = stages.CountMergedPoints();
  if (!options.UnitLength)
  {
    NoteFading(FadedShare(stages.GetMesh(), fields.Section), notes);
    TurnVanishing(stages.GetGeometry(), options.Degree, fields.Section);
  }
  result.Notes = std::move(notes);
  result.Components = std::move(fields.Reports);
  const OutputPoints& points = stages.GetOutputPoints();
  // The energy is that of the section before it is turned to the edges.
  std::vector<double> density;
  if (constraints.HasTurns())
  {
    density = DensityPerArea(stages.GetGeometry(), options.Degree, fields.Section);
    constraints.TurnToEdgesInSpace(fields.Section);
  }
  AddSection(stages.GetGeometry(), stages.GetInput(), points, fields.Section, result);
  if (constraints.HasTurns())
  {
    result.EnergyDensity = points.Spread(density, 0.0);
  }
  if (constraints.Any())
  {
    const Vector3 zero = Vector3::Zero();
    CountConstraints(stages.GetMesh(), stages.GetInput(), constraints, result.Components);
    result.Constraint = points.Spread(constraints.Kind, ConstraintKind::None);
    std::vector<Complex> values = constraints.Value;
    constraints.TurnToEdgesInSpace(values);
    result.ConstraintDirection =
      points.Spread(DirectionsOf(values, stages.GetGeometry().Frames, options.Degree), zero);
  }
  if (UsesCurvature(options))
  {
    result.Curvature = stages.GetCurvatureReport(options.CurvatureScale);
  }
  return result;
}

void AddSection(const SurfaceGeometry& geometry, const Surface& surface, const OutputPoints& points,
  const std::vector<Complex>& section, Result& result)
{
  const TriangleMesh& mesh = geometry.Mesh;
  const Index merged = result.Repaired.MergedPoints;
  result.Repaired = mesh.GetRepairs();
  result.Repaired.DegenerateTriangles = geometry.Lengths.DegenerateTriangles;
  result.Repaired.MergedPoints = merged;
  result.Components.resize(mesh.GetComponents().size());
  AddCounts(mesh, OwnedParts(mesh, surface), result.Components);
  AddTriangles(mesh, surface, SingularityIndices(geometry, result.Degree, section), result);
  result.EnergyDensity = points.Spread(DensityPerArea(geometry, result.Degree, section), 0.0);
  const Vector3 zero = Vector3::Zero();
  result.Representation = points.Spread(section, Complex(0.0));
  result.Normal = points.Spread(geometry.Frames.Normal, zero);
  result.XAxis = points.Spread(geometry.Frames.X, zero);
  result.OriginalPoint = points.Original;
  result.SplitTriangles = points.SplitTriangles;
}
}
