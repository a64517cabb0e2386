// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Guidance/Constraints.h"

#include "Features/FeatureChains.h"
#include "Guidance/FeatureSigns.h"
#include "Guidance/Guidance.h"
#include "Sections/DoubleCover.h"
#include "Sections/Singularities.h"
#include "Support/Free.h"
#include "Support/PointOrder.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace DirectionFields::Internal
{
namespace
{
/// Edges whose dihedral angles differ by less than this are equally sharp.
constexpr double EqualSharpness = 1e-9;
/// Two directions of a corner whose n-th powers add up to less than this cancel.
constexpr double Cancelled = 0.6;
/// The anisotropy |k_max - k_min| l below which a vertex has no principal directions.
constexpr double Umbilic = 1e-6;
/// A curvature constraint stays where at least this many neighbours are constrained, too; also the
/// number of rounds.
constexpr Index FewestNeighbours = 2;
constexpr int LonelyRounds = 2;
/// Angles of a triangle that differ by less than this are equal up to rounding.
constexpr double EqualAngles = 1e-9;

/// Which of two neighbours of a vertex ties go to. Neither winding nor numbering may matter, for
/// the pieces of a surface on several processes are numbered in another way than the whole.
bool ComesFirst(const SurfaceGeometry& geometry, Index one, Index other)
{
  const Vector3& here = geometry.Positions[one];
  const Vector3& there = geometry.Positions[other];
  return here == there ? geometry.Mesh.Point(one) < geometry.Mesh.Point(other)
                       : ComesFirstInGrids(here, there);
}

/// Whether the edge that leaves a boundary vertex weighs more in the energy than the one that
/// arrives: its cotangent is that of the angle opposite of it.
bool WeighsMore(const SurfaceGeometry& geometry, Index leaving, Index arriving)
{
  const TriangleMesh& mesh = geometry.Mesh;
  const double there = geometry.Lengths.CornerAngle(mesh, TriangleMesh::Previous(leaving));
  const double here = geometry.Lengths.CornerAngle(mesh, TriangleMesh::Previous(arriving));
  return std::abs(there - here) > EqualAngles
    ? there < here
    : ComesFirst(geometry, mesh.Head(leaving), mesh.Tail(arriving));
}

/// Least squares need a factor whose time and memory grow faster than the surface.
void RequireInReach(const TriangleMesh& mesh, const std::vector<ConstraintKind>& kind)
{
  for (const TriangleMesh::Component& component : mesh.GetComponents())
  {
    if (component.Vertices() > MostLeastSquaresVertices &&
      std::any_of(kind.begin() + component.FirstVertex, kind.begin() + component.EndVertex,
        [](ConstraintKind one) { return one != ConstraintKind::None; }))
    {
      throw std::invalid_argument(
        "Set Constraint Solver to Energy: Least Squares takes connected components of up to " +
        std::to_string(MostLeastSquaresVertices) + " points, and one has " +
        std::to_string(component.Vertices()) + ".");
    }
  }
}
}

Constraints::Constraints(
  const Input& input, const Options& options, std::vector<std::string>& notes)
  : Kind(input.Geometry.Mesh.GetNumberOfVertices(), ConstraintKind::None)
  , Value(input.Geometry.Mesh.GetNumberOfVertices(), 0.0)
{
  const auto note = [&](bool asked, ConstraintKind kind, const char* what)
  {
    if (asked && std::count(this->Kind.begin(), this->Kind.end(), kind) == 0)
    {
      notes.emplace_back(what);
    }
  };
  // The kinds come by falling priority: earlier constraints stay.
  if (options.ConstrainGuidance)
  {
    this->AddGiven(input);
    note(input.Strengths.empty(), ConstraintKind::Given,
      "Choose other Guidance Vectors or Weights: Constrain Guidance changes nothing, since no "
      "vector has positive weight and a part in the tangent plane.");
  }
  this->AddBoundary(input, options);
  this->MirrorBoundary(input, options);
  const std::vector<TriangleMesh::Component>& components = input.Geometry.Mesh.GetComponents();
  const bool anyBoundary = std::any_of(components.begin(), components.end(),
    [](const TriangleMesh::Component& component) { return !component.Closed; });
  if (options.ConstrainBoundary && !anyBoundary)
  {
    notes.emplace_back(
      "Turn Constrain Boundary off: it changes nothing, since the surface has no boundary.");
  }
  if (options.ConstrainSharpEdges)
  {
    this->AddSharpEdges(input, options);
    note(true, ConstraintKind::SharpEdge,
      "Lower the Feature Angle: Constrain Sharp Edges changes nothing, since no free vertex has an "
      "edge that is sharper.");
  }
  if (options.ConstrainCurvature)
  {
    this->AddCurvature(input, options);
    this->DropInconsistent(input, options);
    for (int time = 0; time < LonelyRounds; ++time)
    {
      this->DropLonely(input);
    }
    if (options.DropConstraintsAtSingularities)
    {
      this->DropAtSingularities(input, options);
    }
    note(true, ConstraintKind::Curvature,
      "Lower the Curvature Tolerance: Constrain Curvature changes nothing, since no free vertex has "
      "a stronger curvature with a consistent direction.");
  }
  this->MirrorInterior(input, options);
  this->Count = static_cast<Index>(
    this->Kind.size() - std::count(this->Kind.begin(), this->Kind.end(), ConstraintKind::None));
  if (this->Any() && options.ConstraintSolver == ConstraintSolver::LeastSquares)
  {
    RequireInReach(input.Geometry.Mesh, this->Kind);
  }
  if (!this->Any())
  {
    Free(this->Kind);
    Free(this->Value);
  }
}

void Constraints::Set(Index vertex, ConstraintKind kind, const Complex& value)
{
  if (this->Kind[vertex] == ConstraintKind::None)
  {
    this->Kind[vertex] = kind;
    this->Value[vertex] = value / std::abs(value);
  }
}

void Constraints::AddGiven(const Input& input)
{
  for (std::size_t v = 0; v < input.Given.size(); ++v)
  {
    if (std::abs(input.Given[v]) > 0.0 && (input.Strengths.empty() || input.Strengths[v] >= 1.0))
    {
      this->Set(static_cast<Index>(v), ConstraintKind::Given, input.Given[v]);
    }
  }
}

void Constraints::AddBoundary(const Input& input, const Options& options)
{
  const TriangleMesh& mesh = input.Geometry.Mesh;
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    if (!mesh.IsBoundary(v))
    {
      continue;
    }
    const Index next = mesh.Outgoing(v);
    Index last = next;
    while (mesh.NextOutgoing(last) != None)
    {
      last = mesh.NextOutgoing(last);
    }
    const Index previous = TriangleMesh::Previous(last);
    const bool nonManifold = mesh.IsNonManifold(next) || mesh.IsNonManifold(previous);
    const bool useNext = options.ConstrainBoundary || mesh.IsNonManifold(next);
    const bool usePrevious = options.ConstrainBoundary || mesh.IsNonManifold(previous);
    // The directions of the next boundary edge and of the previous one, both with the boundary. In
    // the mean of their n-th powers a right-angled corner keeps a cross, as a straight boundary
    // keeps any field; where they cancel, the one that weighs more stands for both.
    const Complex forward = 1.0;
    const Complex onward =
      std::polar(1.0, options.Degree * (input.Geometry.Transport.AngleSum[v] - Pi));
    const Complex mean = forward + onward;
    if (useNext && usePrevious)
    {
      this->Set(v, nonManifold ? ConstraintKind::NonManifold : ConstraintKind::Boundary,
        std::abs(mean) > Cancelled                     ? mean
          : WeighsMore(input.Geometry, next, previous) ? forward
                                                       : onward);
    }
    else if (useNext || usePrevious)
    {
      this->Set(v, ConstraintKind::NonManifold, useNext ? forward : onward);
    }
  }
}

/// The boundary of a cover comes in pairs of loops, each with the directions of its own
/// orientation: one loop of each pair decides for both.
void Constraints::MirrorBoundary(const Input& input, const Options& options)
{
  const TriangleMesh& mesh = input.Geometry.Mesh;
  std::vector<char> decided(
    mesh.GetRepairs().NonOrientableComponents > 0 ? this->Kind.size() : 0, 0);
  for (std::size_t c = 0; c < mesh.GetComponents().size() && !decided.empty(); ++c)
  {
    const TriangleMesh::Component& component = mesh.GetComponents()[c];
    const DoubleCover cover(input.Geometry, component, options.Degree);
    for (Index start = component.FirstVertex; component.IsCover && start < component.EndVertex;
         ++start)
    {
      for (Index v = start; mesh.IsBoundary(v) && !decided[v]; v = mesh.Head(mesh.Outgoing(v)))
      {
        const Index mirror = mesh.MirrorVertex(v);
        decided[v] = decided[mirror] = 1;
        this->Kind[mirror] = this->Kind[v];
        this->Value[mirror] = cover.Mirrored(v, this->Value[v]);
      }
    }
  }
}

/// Makes all other constraints of a cover equal on both of its sides, where rounding may have made
/// a difference.
void Constraints::MirrorInterior(const Input& input, const Options& options)
{
  const TriangleMesh& mesh = input.Geometry.Mesh;
  for (const TriangleMesh::Component& component : mesh.GetComponents())
  {
    const DoubleCover cover(input.Geometry, component, options.Degree);
    for (Index v = component.FirstVertex; component.IsCover && v < component.EndVertex; ++v)
    {
      const Index mirror = mesh.MirrorVertex(v);
      if (mesh.IsFrontVertex(v) &&
        (this->Kind[v] != ConstraintKind::Boundary && this->Kind[v] != ConstraintKind::NonManifold))
      {
        this->Kind[mirror] = this->Kind[v];
        this->Value[mirror] = cover.Mirrored(v, this->Value[v]);
      }
    }
  }
}

void Constraints::AddSharpEdges(const Input& input, const Options& options)
{
  const TriangleMesh& mesh = input.Geometry.Mesh;
  const double bound = options.FeatureAngle * Pi / 180.0;
  const FeatureChains features(
    input.Geometry, input.DihedralAngles, { bound, options.MinimumFeatureLength });
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    Index sharpest = None;
    double sharpness = bound;
    Index h = mesh.Outgoing(v);
    do
    {
      const double angle = std::abs(input.DihedralAngles[mesh.Edge(h)]);
      const bool equal = sharpest != None && std::abs(angle - sharpness) <= EqualSharpness;
      const bool sharper =
        equal ? mesh.Point(mesh.Head(h)) < mesh.Point(mesh.Head(sharpest)) : angle > sharpness;
      if (features.IsFeature(mesh.Edge(h)) && sharper)
      {
        sharpest = h;
        sharpness = std::max(sharpness, angle);
      }
      h = mesh.NextOutgoing(h);
    } while (h != None && h != mesh.Outgoing(v));
    if (sharpest != None && this->Kind[v] == ConstraintKind::None)
    {
      // The edge's angles in the cone and in the plane that it is projected to differ by some
      // degrees. That in the cone fits the transport to the neighbours: the other one would turn
      // the whole field beside the edges, at a cost that grows as edges get shorter.
      const double angle = input.Geometry.Transport.EdgeAngle[sharpest];
      this->Set(v, ConstraintKind::SharpEdge, std::polar(1.0, options.Degree * angle));
      const Vector3 edge =
        (input.Geometry.Positions[mesh.Head(sharpest)] - input.Geometry.Positions[v])
          .stableNormalized();
      const Complex projected = input.Geometry.Frames.Tangential(v, edge);
      if (mesh.IsFrontVertex(v) && std::abs(projected) > 1e-9)
      {
        const double turn = options.Degree * (std::arg(projected) - angle);
        this->Turns.push_back({ v, mesh.MirrorVertex(v), std::polar(1.0, turn) });
      }
    }
  }
  if (options.Degree % 2 != 0)
  {
    ChooseFeatureSigns(input.Geometry, options.Degree, this->Kind, this->Value);
  }
}

void Constraints::TurnToEdgesInSpace(std::vector<Complex>& section) const
{
  for (const Turn& turn : this->Turns)
  {
    section[turn.Vertex] *= turn.Factor;
    if (turn.Mirror != None)
    {
      section[turn.Mirror] *= std::conj(turn.Factor);
    }
  }
}

void Constraints::AddCurvature(const Input& input, const Options& options)
{
  for (std::size_t c = 0; c < input.Geometry.Mesh.GetComponents().size(); ++c)
  {
    const TriangleMesh::Component& component = input.Geometry.Mesh.GetComponents()[c];
    const double radius = std::sqrt(input.Geometry.Lengths.ComponentArea[c] / (4.0 * Pi));
    if (component.IsCover && DependsOnSide(options.Degree, options.CurvatureDirection))
    {
      // The larger curvature of one side is the smaller one of the other.
      continue;
    }
    for (Index v = component.FirstVertex; v < component.EndVertex; ++v)
    {
      const double mean = std::abs(input.Curved->Mean[v]) * radius;
      const double gaussian = std::abs(input.Curved->Gaussian[v]) * radius * radius;
      const Complex value =
        CurvatureValue(*input.Curved, v, options.Degree, options.CurvatureDirection);
      if ((mean > options.CurvatureTolerance || gaussian > options.CurvatureTolerance) &&
        std::abs(input.Curved->Hopf[v]) * radius > Umbilic && std::abs(value) > 0.0)
      {
        this->Set(v, ConstraintKind::Curvature, value);
      }
    }
  }
}

/// All comparisons are made before anything is dropped, so that the result depends on no order.
void Constraints::DropInconsistent(const Input& input, const Options& options)
{
  const double bound = options.ConsistencyAngle * Pi / 180.0;
  const TriangleMesh& mesh = input.Geometry.Mesh;
  std::vector<char> drop(this->Kind.size(), 0);
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    const Index i = mesh.Tail(mesh.HalfEdge(e));
    const Index j = mesh.Head(mesh.HalfEdge(e));
    if (this->Kind[i] != ConstraintKind::None && this->Kind[j] != ConstraintKind::None)
    {
      const Complex arrived =
        this->Value[i] * std::polar(1.0, options.Degree * input.Geometry.Transport.Rotation[e]);
      if (std::abs(std::arg(this->Value[j] * std::conj(arrived))) > options.Degree * bound)
      {
        drop[i] = drop[j] = 1;
      }
    }
  }
  this->DropCurvature(drop);
}

/// Neighbours that disagree are gone by now, so that the constrained ones agree. A constraint that
/// stands alone, or at the end of a line, is noise more often than not.
void Constraints::DropLonely(const Input& input)
{
  const TriangleMesh& mesh = input.Geometry.Mesh;
  std::vector<Index> neighbours(this->Kind.size(), 0);
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    const Index i = mesh.Tail(mesh.HalfEdge(e));
    const Index j = mesh.Head(mesh.HalfEdge(e));
    neighbours[i] += this->Kind[j] != ConstraintKind::None;
    neighbours[j] += this->Kind[i] != ConstraintKind::None;
  }
  std::vector<char> drop(this->Kind.size());
  for (std::size_t v = 0; v < drop.size(); ++v)
  {
    drop[v] = neighbours[v] < FewestNeighbours;
  }
  this->DropCurvature(drop);
}

void Constraints::DropAtSingularities(const Input& input, const Options& options)
{
  const TriangleMesh& mesh = input.Geometry.Mesh;
  const std::vector<int> index = SingularityIndices(input.Geometry, options.Degree, this->Value);
  std::vector<char> drop(this->Kind.size(), 0);
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    const std::array<Index, 3> corners = { mesh.Tail(3 * t), mesh.Tail(3 * t + 1),
      mesh.Tail(3 * t + 2) };
    const bool all = std::all_of(corners.begin(), corners.end(),
      [this](Index v) { return this->Kind[v] != ConstraintKind::None; });
    if (all && index[t] != 0)
    {
      for (const Index v : corners)
      {
        drop[v] = 1;
      }
    }
  }
  this->DropCurvature(drop);
}

void Constraints::DropCurvature(const std::vector<char>& drop)
{
  for (std::size_t v = 0; v < drop.size(); ++v)
  {
    if (drop[v] && this->Kind[v] == ConstraintKind::Curvature)
    {
      this->Kind[v] = ConstraintKind::None;
      this->Value[v] = 0.0;
    }
  }
}
}
