// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DistributedField.h"

#include "Components/ComponentSolution.h"
#include "Computation/FieldToResult.h"
#include "Computation/Guide.h"
#include "Computation/Stages.h"
#include "Mesh/CommonWinding.h"
#include "Mesh/CoveredPiece.h"
#include "Mesh/DistributedMesh.h"
#include "Mesh/Messages.h"
#include "Mesh/OutputPoints.h"
#include "Mesh/OwnCommunicator.h"
#include "Mesh/PieceWithSurroundings.h"
#include "Mesh/SharedPoints.h"
#include "Sections/SectionDirections.h"
#include "Solver/DistributedGuide.h"
#include "Solver/PetscObjects.h"
#include "Solver/PreviousPhase.h"
#include "Support/Threads.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <memory>
#include <new>
#include <string>
#include <utility>

namespace DirectionFields::Parallel
{
namespace
{
/// The points whose owner is another process, and the points that others have from here, in the
/// same order.
PointExchange ExchangeOf(
  const SharedPoints& shared, const SurfacePiece& piece, const Messages& messages)
{
  std::vector<std::map<vtkIdType, vtkIdType>> sent(static_cast<std::size_t>(messages.Count()));
  std::vector<std::map<vtkIdType, vtkIdType>> received = sent;
  for (const auto& [own, others] : shared.Others)
  {
    const vtkIdType number = shared.Number[own];
    const vtkIdType point = piece.Own.Points[own];
    const int owner = shared.OwnerOf(number);
    if (owner != messages.Own())
    {
      received[owner][number] = point;
      continue;
    }
    for (const int other : others)
    {
      sent[other][number] = point;
    }
  }
  PointExchange exchange;
  exchange.Numbers = shared.Number;
  exchange.Tolerance = shared.Tolerance;
  exchange.UseIds = shared.UseIds;
  exchange.Sent.resize(sent.size());
  exchange.Received.resize(sent.size());
  for (std::size_t p = 0; p < sent.size(); ++p)
  {
    for (const auto& [number, point] : sent[p])
    {
      exchange.Sent[p].push_back(point);
    }
    for (const auto& [number, point] : received[p])
    {
      exchange.Received[p].push_back(point);
    }
  }
  return exchange;
}

/// Leaves the points and triangles of the input, with the components of the whole.
void KeepInput(const DistributedMesh& mesh, const PieceWithSurroundings& piece,
  std::size_t inputTriangles, Result& result)
{
  const auto points =
    static_cast<std::size_t>(piece.FrontPoints > 0 ? piece.FrontPoints : piece.InputPoints);
  for (std::size_t i = 0; i < points; ++i)
  {
    if (piece.Number[i] < 0)
    {
      result.Representation[i] = 0.0;
    }
  }
  result.Representation.resize(points);
  result.EnergyDensity.resize(points);
  result.Normal.resize(points);
  result.XAxis.resize(points);
  result.OriginalPoint.resize(points);
  // Sheets come apart nowhere but at the rim of the surroundings, where triangles are missing.
  result.SplitTriangles.clear();
  if (!result.Constraint.empty())
  {
    result.Constraint.resize(points);
    result.ConstraintDirection.resize(points);
  }
  std::vector<int> index(inputTriangles, 0);
  std::vector<Index> component(inputTriangles, None);
  const std::size_t own = piece.FrontPoints > 0 ? piece.FrontTriangles : piece.InputTriangle.size();
  for (std::size_t t = 0; t < own; ++t)
  {
    index[piece.InputTriangle[t]] = result.SingularityIndex[t];
    component[piece.InputTriangle[t]] = result.Component[t] == None
      ? None
      : mesh.ComponentOf(static_cast<std::size_t>(result.Component[t]));
  }
  result.SingularityIndex = std::move(index);
  result.Component = std::move(component);
}

/// The counts of all pieces' parts together, and whether there is a boundary.
void AddUpCounts(const Messages& messages, const DistributedMesh& mesh, Result& result,
  std::vector<ComponentReport>& reports)
{
  const std::size_t components = reports.size();
  std::vector<double> sums(5 * components, 0.0);
  const TriangleMesh& triangles = mesh.GetMesh();
  for (std::size_t c = 0; c < triangles.GetComponents().size(); ++c)
  {
    if (mesh.ComponentOf(c) < 0)
    {
      continue;
    }
    double* const sum = sums.data() + 5 * mesh.ComponentOf(c);
    const ComponentReport& part = result.Components[c];
    sum[0] += part.EulerCharacteristic;
    sum[1] += part.Vertices;
    sum[2] += part.Triangles;
    sum[3] += part.IndexSum;
    const TriangleMesh::Component& range = triangles.GetComponents()[c];
    for (Index v = range.FirstVertex; v < range.EndVertex; ++v)
    {
      sum[4] += mesh.IsOwned(v) && triangles.IsBoundary(v) ? 1.0 : 0.0;
    }
  }
  messages.Sum(sums.data(), static_cast<int>(sums.size()));
  for (std::size_t c = 0; c < components; ++c)
  {
    double* const sum = sums.data() + 5 * c;
    // Both sides have the same.
    std::for_each(sum, sum + 4,
      [sides = mesh.IsCover(static_cast<int>(c)) ? 2.0 : 1.0](double& count) { count /= sides; });
    reports[c].EulerCharacteristic = static_cast<int>(sum[0]);
    reports[c].Vertices = static_cast<Index>(sum[1]);
    reports[c].Triangles = static_cast<Index>(sum[2]);
    reports[c].IndexSum = static_cast<int>(sum[3]);
    reports[c].Closed = sum[4] == 0.0;
  }
  result.Components = reports;
}

/// The repairs of all pieces.
void AddUpRepairs(const Messages& messages, const PieceWithSurroundings& piece,
  const DistributedMesh& mesh, Repairs& repairs)
{
  double sums[2] = { 0.0, 0.0 };
  for (std::size_t t = 0; t < piece.InputTriangle.size(); ++t)
  {
    const Triangle& corners = piece.Surface.Triangles[t];
    sums[0] += corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
  }
  // Where there are any, none is among the surroundings.
  sums[1] = mesh.GetGeometry().Lengths.DegenerateTriangles;
  messages.Sum(sums, 2);
  repairs = {};
  repairs.CollapsedTriangles = static_cast<Index>(sums[0]);
  repairs.DegenerateTriangles = static_cast<Index>(sums[1]);
}

SurfaceFigures AddUpFigures(const Messages& messages, const SurfaceFigures& own)
{
  const std::vector<double> values{ own.Lower[0], own.Lower[1], own.Lower[2], own.Upper[0],
    own.Upper[1], own.Upper[2], own.Area, static_cast<double>(own.Positive),
    static_cast<double>(own.Negative) };
  const std::vector<double> all = messages.AllGather(values).Values;
  SurfaceFigures sum;
  for (std::size_t k = 0; k < all.size(); k += values.size())
  {
    SurfaceFigures part;
    part.Lower = Vector3(all.data() + k);
    part.Upper = Vector3(all.data() + k + 3);
    part.Area = all[k + 6];
    part.Positive = static_cast<Index>(all[k + 7]);
    part.Negative = static_cast<Index>(all[k + 8]);
    sum += part;
  }
  return sum;
}

/// @param components how many have several smoothest fields
std::string DescribeAmbiguous(int components)
{
  return std::string(
           components == 1 ? "A component has" : std::to_string(components) + " components have") +
    " several smoothest fields, as symmetric surfaces do: one process, or another number of them, "
    "may choose another one. Set Distribution to Gather for that of one process, or guide the "
    "field.";
}

/// Adds the curvature that the field follows, at the points of the input.
void AddCurvature(const DistributedMesh& mesh, const PieceWithSurroundings& piece,
  const OutputPoints& points, const Curvature& curvature, Result& result)
{
  CurvatureReport report = ReportOf(mesh.GetGeometry(), curvature, points);
  const auto inputPoints = static_cast<std::size_t>(piece.InputPoints);
  report.PrincipalDirection0.resize(inputPoints);
  report.PrincipalDirection1.resize(inputPoints);
  report.Mean.resize(inputPoints);
  report.Gaussian.resize(inputPoints);
  result.Curvature = std::make_shared<const CurvatureReport>(std::move(report));
  if (curvature.IsInsideOut)
  {
    result.Notes.emplace_back(InsideOutNote);
  }
}

/// The share of the vertices of the whole surface whose vectors have faded.
double FadedShare(
  const Messages& messages, const DistributedMesh& mesh, const std::vector<Complex>& section)
{
  std::vector<double> longest(static_cast<std::size_t>(mesh.CountComponents()), 0.0);
  const auto forEachOwned = [&](const auto& body)
  {
    for (int component = 0; component < mesh.CountComponents(); ++component)
    {
      for (const std::size_t c : mesh.PartsOf(component))
      {
        const TriangleMesh::Component& part = mesh.GetMesh().GetComponents()[c];
        for (Index v = part.FirstVertex; v < part.EndVertex; ++v)
        {
          if (mesh.IsOwned(v))
          {
            body(component, std::abs(section[v]));
          }
        }
      }
    }
  };
  forEachOwned([&](int component, double length)
    { longest[component] = std::max(longest[component], length); });
  messages.Largest(longest.data(), static_cast<int>(longest.size()));
  double counts[2] = { 0.0, 0.0 };
  forEachOwned(
    [&](int component, double length)
    {
      counts[0] += length < FadedPart * longest[component] ? 1.0 : 0.0;
      counts[1] += 1.0;
    });
  messages.Sum(counts, 2);
  return counts[0] / std::max(1.0, counts[1]);
}

/// The mesh of a piece, and how it has come about.
struct Pieced
{
  std::string Reason;
  PieceWithSurroundings Around;
  std::unique_ptr<DistributedMesh> Mesh;
  CommonWinding Winding;
};

/// Winds the pieces alike where that can be, and covers components that have only one side.
Pieced MakeMesh(Processes& processes, const Messages& messages, const Surface& surface,
  const SurfacePiece& piece, const SharedPoints& shared)
{
  Pieced made;
  made.Around = AddSurroundings(processes, messages, surface, piece, shared);
  made.Mesh = std::make_unique<DistributedMesh>(processes, messages, made.Around, shared);
  if (made.Mesh->IsWoundOtherwise())
  {
    made.Winding = WindAlike(processes, messages, made.Mesh->GetMesh(), made.Around);
    made.Mesh.reset();
    if (made.Winding.OneSided > 0)
    {
      Covering covering =
        CoverOneSided(processes, messages, piece, shared, made.Around, made.Winding.IsOneSided);
      made.Reason = covering.Reason;
      if (!made.Reason.empty())
      {
        return made;
      }
      made.Around = std::move(covering.Piece);
      made.Mesh =
        std::make_unique<DistributedMesh>(processes, messages, made.Around, covering.Shared);
      const bool hasFlat = made.Mesh->GetGeometry().Lengths.DegenerateTriangles > 0;
      made.Reason = messages.Any(hasFlat)
        ? "a part of it has only one side, and it has triangles without area"
        : "";
    }
    else
    {
      made.Mesh = std::make_unique<DistributedMesh>(processes, messages, made.Around, shared);
    }
  }
  made.Reason = made.Reason.empty() ? made.Mesh->GetReason() : made.Reason;
  return made;
}

/// Values at the points of the input as values at both sides of them, where there is a cover.
template <typename T>
std::vector<T> OnBothSides(std::vector<T> values, const PieceWithSurroundings& piece)
{
  if (piece.FrontPoints > 0 && !values.empty())
  {
    values.resize(static_cast<std::size_t>(piece.FrontPoints));
    values.reserve(2 * values.size());
    std::copy_n(values.begin(), piece.FrontPoints, std::back_inserter(values));
  }
  return values;
}

/// Guidance at both sides.
Guidance OnBothSides(
  Processes& processes, const Guidance& guidance, const PieceWithSurroundings& piece)
{
  Guidance both;
  processes.Together(
    [&]
    {
      both = guidance;
      both.Vectors = OnBothSides(std::move(both.Vectors), piece);
      both.Weights = OnBothSides(std::move(both.Weights), piece);
    });
  return both;
}

void Compute(Processes& processes, const Messages& messages, const Surface& surface,
  const SurfacePiece& piece, const Options& options, const Guidance& guidance,
  const std::vector<Vector3>& previous, const std::function<bool(double)>& goOn,
  DistributedField& field)
{
  const SharedPoints shared = MatchBorders(processes, messages, piece);
  field.Reason = shared.Reason;
  field.SharedPoints = shared.Shared;
  if (!field.Reason.empty())
  {
    return;
  }
  Pieced pieced = MakeMesh(processes, messages, surface, piece, shared);
  field.Reason = pieced.Reason;
  if (!field.Reason.empty())
  {
    return;
  }
  const DistributedMesh& mesh = *pieced.Mesh;
  PieceWithSurroundings& around = pieced.Around;
  const DistributedGuide guide =
    MakeGuide(processes, messages, mesh, around, options, OnBothSides(processes, guidance, around));
  field.Reason = guide.Reason;
  if (!field.Reason.empty())
  {
    return;
  }
  DistributedSolution solution =
    SolveDistributed(processes, messages, mesh, around, guide, options, goOn);
  std::vector<Complex>& section = solution.Section;
  std::vector<Vector3> before;
  processes.Together([&] { before = OnBothSides(previous, around); });
  FollowPrevious(
    processes, messages, mesh, around, guide, std::move(before), options.Degree, section);
  const double faded = FadedShare(messages, mesh, section);
  processes.Together(
    [&]
    {
      field.Field.Degree = options.Degree;
      NoteFading(faded, field.Field.Notes);
      if (solution.Ambiguous > 0)
      {
        field.Field.Notes.push_back(DescribeAmbiguous(solution.Ambiguous));
      }
      const OutputPoints points(mesh.GetMesh(), around.Surface, {});
      AddSection(mesh.GetGeometry(), around.Surface, points, section, field.Field);
      if (guide.Curved)
      {
        AddCurvature(mesh, around, points, *guide.Curved, field.Field);
      }
      if (guide.IsConstrained)
      {
        const Vector3 zero = Vector3::Zero();
        field.Field.Constraint = points.Spread(guide.Kind, ConstraintKind::None);
        field.Field.ConstraintDirection =
          points.Spread(DirectionsOf(guide.Value, mesh.GetGeometry().Frames, options.Degree), zero);
      }
    });
  AddUpCounts(messages, mesh, field.Field, solution.Reports);
  AddUpRepairs(messages, around, mesh, field.Field.Repaired);
  field.Field.Repaired.ReversedTriangles = pieced.Winding.Reversed;
  field.Field.Repaired.NonOrientableComponents = pieced.Winding.OneSided;
  SurfaceFigures own;
  processes.Together(
    [&]
    {
      // The other sides are no more surface.
      if (around.FrontPoints > 0)
      {
        std::fill(around.Surface.Ghost.begin() + around.FrontTriangles,
          around.Surface.Ghost.begin() + static_cast<Index>(around.InputTriangle.size()), 1);
      }
      own = FiguresOf(around.Surface, field.Field.SingularityIndex);
      KeepInput(mesh, around, surface.Triangles.size(), field.Field);
      field.Exchange = ExchangeOf(shared, piece, messages);
    });
  field.Figures = AddUpFigures(messages, own);
}
}

bool CanDistribute()
{
  return true;
}

DistributedField ComputeDistributed(Processes& processes, const Surface& surface,
  const SurfacePiece& piece, const Options& options, const Guidance& guidance,
  const std::vector<Vector3>& previous, const std::function<bool(double)>& goOn)
{
  DistributedField field;
  const OwnCommunicator communicator(processes.GetController());
  if (!communicator.IsThere)
  {
    field.Reason = "its processes are not those of MPI";
    return field;
  }
  Threads threads(options.NumberOfThreads);
  const Threads::Scope scope(threads);
  const Messages messages(communicator.Handle);
  StartPetsc(communicator.Handle);
  try
  {
    ShareErrors(processes,
      [&]
      { Compute(processes, messages, surface, piece, options, guidance, previous, goOn, field); });
  }
  catch (const std::bad_alloc&)
  {
    // Where the others do not know of it, they wait for this one.
    EndAllForMemory("");
  }
  return field;
}
}
