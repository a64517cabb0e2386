// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Guidance/CurveGuidance.h"

#include "Distance/ClosestPoints.h"
#include "Distance/SurfaceDistance.h"
#include "Guidance/CurveSamples.h"
#include "Interpolation/FieldInterpolant.h"
#include "Interpolation/GivenField.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace DirectionFields
{
namespace
{
using Internal::CurveSample;

/// Corners that are about opposite of an edge that a curve runs along are not on it.
constexpr double LeastWeight = 1e-3;
constexpr double LeastTangential = 1e-6;
constexpr Index SamplesPerReport = 4096;

/// The mean length of the edges in the unit of the surface.
double MeanEdge(const SurfaceGeometry& geometry)
{
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t c = 0; c < geometry.Mesh.GetComponents().size(); ++c)
  {
    const double edges = geometry.Mesh.GetComponents()[c].Edges();
    sum += edges * geometry.Lengths.Unit[c];
    count += edges;
  }
  return count > 0.0 ? sum / count : 0.0;
}

/// Weighted directions of curves at the vertices of a mesh, added up.
struct DirectionSums
{
  explicit DirectionSums(std::size_t vertices)
    : Sum(vertices, 0.0)
    , Weight(vertices, 0.0)
  {
  }
  bool IsEmpty() const { return this->Sum.empty(); }
  void Add(Index v, double weight, double angle)
  {
    this->Sum[v] += std::polar(weight, angle);
    this->Weight[v] += weight;
  }
  std::vector<Complex> Sum;
  std::vector<double> Weight;
};

/// What curves ask for at each vertex.
struct VertexGuidance
{
  /// The n-th power of the direction, of the length of its weight.
  std::vector<Complex> Values;
  /// Empty where all are 1.
  std::vector<double> Strengths;
};

/// The directions that curves ask for at the vertices of a mesh.
class Strokes
{
public:
  /// @param anySoft whether strengths other than 1 are to come
  Strokes(const GivenField& surface, int degree, bool anySoft)
    : Given(surface)
    , Geometry(surface.GetGeometry())
    , Degree(degree)
    , Hard(this->Geometry.Mesh.GetNumberOfVertices())
    , Soft(anySoft ? this->Hard.Sum.size() : 0)
    , Lengths(this->Soft.Sum.size(), 0.0)
  {
  }

  /// Adds a piece of a curve of a strength that lies in a triangle of the surface.
  void Add(
    const ClosestPoints::Answer& found, const Vector3& tangent, double strength, bool fillsSeeds)
  {
    const Index front = this->Given.GetMeshTriangles()[found.Triangle];
    if (front == None)
    {
      return;
    }
    const Index mirror = this->Geometry.Mesh.Mirror(3 * front);
    for (const Index triangle : { front, mirror == None ? None : mirror / 3 })
    {
      if (triangle != None)
      {
        this->AddToTriangle(triangle, found, tangent, strength, fillsSeeds);
      }
    }
  }

  /// Carries the directions on to all vertices within a radius, and weights them by their
  /// distances.
  VertexGuidance Spread(double radius, double falloff) const;

private:
  void AddToTriangle(Index triangle, const ClosestPoints::Answer& found, const Vector3& tangent,
    double strength, bool fillsSeeds);
  /// What the curves say themselves.
  VertexGuidance OnCurves(std::vector<char>& isKnown) const;
  /// Sets a vertex to the mean of the neighbours that are known.
  void TakeFromNeighbours(
    Index vertex, const std::vector<char>& isKnown, VertexGuidance& guidance) const;
  /// A remainder of directions that cancel is no direction.
  static Complex Coherent(const Complex& value)
  {
    return std::abs(value) < CurveGuidance::LeastCoherence ? Complex(0.0) : value;
  }

  const GivenField& Given;
  const SurfaceGeometry& Geometry;
  int Degree;
  DirectionSums Hard;
  /// Weighted by tau / (1 - tau), too; empty where all are hard.
  DirectionSums Soft;
  /// The weights of Soft without that factor.
  std::vector<double> Lengths;
  std::vector<SurfaceDistance::Seed> Seeds;
};

void Strokes::AddToTriangle(Index triangle, const ClosestPoints::Answer& found,
  const Vector3& tangent, double strength, bool fillsSeeds)
{
  const TriangleMesh& mesh = this->Geometry.Mesh;
  const TriangleInSpace space = this->Given.InSpace(triangle);
  const Complex tangential(tangent.dot(space.X), tangent.dot(space.Y));
  const double length = std::abs(tangential);
  if (!(length > LeastTangential * tangent.stableNorm()))
  {
    return;
  }
  MeshPlace place;
  place.Triangle = triangle;
  for (int c = 0; c < 3; ++c)
  {
    place.Weights[this->Given.MeshCorner(triangle, c)] = found.Weights[c];
  }
  const FieldInterpolant interpolant(
    this->Geometry, this->Degree, this->Given.GetSection().data(), triangle);
  const Complex at = interpolant.Flat().Place(place.Weights);
  for (int c = 0; c < 3; ++c)
  {
    if (place.Weights[c] > LeastWeight)
    {
      const Index vertex = mesh.Tail(3 * triangle + c);
      const double angle = std::arg(tangential) - interpolant.AngleInFlat(c, 0.0, at);
      const double weight = length * place.Weights[c];
      if (strength < 1.0)
      {
        this->Soft.Add(vertex, weight * strength / (1.0 - strength), this->Degree * angle);
        this->Lengths[vertex] += weight;
      }
      else
      {
        this->Hard.Add(vertex, weight, this->Degree * angle);
      }
      if (fillsSeeds)
      {
        this->Seeds.push_back({ vertex, SurfaceDistance::ToCorner(this->Geometry, place, c), 0 });
      }
    }
  }
}

void Strokes::TakeFromNeighbours(
  Index vertex, const std::vector<char>& isKnown, VertexGuidance& guidance) const
{
  const TriangleMesh& mesh = this->Geometry.Mesh;
  Complex sum = 0.0;
  double strengths = 0.0;
  double count = 0.0;
  const auto add = [&](Index neighbour, double rotation, Index edge)
  {
    if (isKnown[neighbour] != 0)
    {
      const double weight =
        1.0 / std::sqrt(std::max(this->Geometry.Lengths.SquaredLength[edge], 1e-300));
      sum += weight * guidance.Values[neighbour] * std::polar(1.0, this->Degree * rotation);
      strengths += guidance.Strengths.empty() ? 0.0 : weight * guidance.Strengths[neighbour];
      count += weight;
    }
  };
  Index h = mesh.Outgoing(vertex);
  Index last = h;
  do
  {
    add(mesh.Head(h), -this->Geometry.Transport.RotationAlong(mesh, h), mesh.Edge(h));
    last = h;
    h = mesh.NextOutgoing(h);
  } while (h != None && h != mesh.Outgoing(vertex));
  if (h == None)
  {
    const Index incoming = TriangleMesh::Previous(last);
    add(mesh.Tail(incoming), this->Geometry.Transport.RotationAlong(mesh, incoming),
      mesh.Edge(incoming));
  }
  guidance.Values[vertex] = Coherent(count > 0.0 ? Complex(sum / count) : Complex(0.0));
  if (!guidance.Strengths.empty())
  {
    // Hard neighbours alone make a hard vertex, to the last bit.
    guidance.Strengths[vertex] = count > 0.0 ? std::min(1.0, strengths / count) : 0.0;
  }
}

VertexGuidance Strokes::OnCurves(std::vector<char>& isKnown) const
{
  const bool anySoft = !this->Soft.IsEmpty();
  VertexGuidance guidance;
  guidance.Values.assign(this->Hard.Sum.size(), 0.0);
  guidance.Strengths.assign(this->Soft.Sum.size(), 0.0);
  isKnown.assign(this->Hard.Sum.size(), 0);
  for (std::size_t v = 0; v < isKnown.size(); ++v)
  {
    const bool isHard = this->Hard.Weight[v] > 0.0;
    const DirectionSums& sums = isHard || !anySoft ? this->Hard : this->Soft;
    isKnown[v] = sums.Weight[v] > 0.0 ? 1 : 0;
    guidance.Values[v] = isKnown[v] != 0 ? Coherent(sums.Sum[v] / sums.Weight[v]) : Complex(0.0);
    if (anySoft && isKnown[v] != 0)
    {
      // The strength of the mean stiffness.
      guidance.Strengths[v] = isHard ? 1.0 : sums.Weight[v] / (sums.Weight[v] + this->Lengths[v]);
    }
  }
  return guidance;
}

VertexGuidance Strokes::Spread(double radius, double falloff) const
{
  const TriangleMesh& mesh = this->Geometry.Mesh;
  std::vector<char> isKnown;
  VertexGuidance guidance = this->OnCurves(isKnown);
  if (radius > 0.0)
  {
    double most = 0.0;
    for (const double unit : this->Geometry.Lengths.Unit)
    {
      most = std::max(most, radius / unit);
    }
    const SurfaceDistance distance(
      this->Geometry, this->Seeds, most, SurfaceDistance::Sources::Curves);
    std::vector<double> units(isKnown.size());
    for (std::size_t c = 0; c < mesh.GetComponents().size(); ++c)
    {
      const TriangleMesh::Component& component = mesh.GetComponents()[c];
      std::fill(units.begin() + component.FirstVertex, units.begin() + component.EndVertex,
        this->Geometry.Lengths.Unit[c]);
    }
    for (const Index v : distance.Order)
    {
      if (isKnown[v] == 0 && distance.Distance[v] * units[v] <= radius)
      {
        this->TakeFromNeighbours(v, isKnown, guidance);
        isKnown[v] = 1;
      }
    }
    for (const Index v : distance.Order)
    {
      const double deviations = distance.Distance[v] * units[v] / (falloff * radius);
      guidance.Values[v] *= std::exp(-0.5 * deviations * deviations);
    }
  }
  return guidance;
}

/// What vertices are asked for, at their points.
void HandToPoints(const Surface& surface, const GivenField& given, const VertexGuidance& at,
  CurveGuidance& guidance)
{
  const SurfaceGeometry& geometry = given.GetGeometry();
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    const Index inMesh = given.GetMeshTriangles()[t];
    for (int c = 0; inMesh != None && c < 3; ++c)
    {
      const Index vertex = geometry.Mesh.Tail(3 * inMesh + given.MeshCorner(inMesh, c));
      const Complex& value = at.Values[vertex];
      const double weight = std::abs(value);
      const double angle = std::arg(value) / given.GetDegree();
      const Index point = surface.Triangles[t][c];
      guidance.Weights[point] = weight;
      guidance.Vectors[point] = weight * std::cos(angle) * geometry.Frames.X[vertex] +
        weight * std::sin(angle) * geometry.Frames.Y(vertex);
      if (!at.Strengths.empty())
      {
        guidance.Strengths[point] = at.Strengths[vertex];
      }
    }
  }
}

void Check(const CurveGuidanceOptions& options, std::size_t curves)
{
  if (options.Degree < 1 || options.Degree > 16 || !(options.Radius >= 0.0) ||
    !(options.Falloff > 0.0) || !(options.MaximumDistance >= 0.0))
  {
    throw std::invalid_argument(
      "Directions Per Point must be 1 to 16, Falloff greater than 0, Radius and Maximum Distance at least 0.");
  }
  const bool areStrengths = std::all_of(options.Strengths.begin(), options.Strengths.end(),
    [](double strength) { return strength >= 0.0 && strength <= 1.0; });
  if (!areStrengths || (!options.Strengths.empty() && options.Strengths.size() != curves))
  {
    throw std::invalid_argument("The strengths of curves must be 0 to 1, one for each curve.");
  }
}
}

struct SurfaceCurves::Kept
{
  /// Made for the last degree; it has no directions.
  std::unique_ptr<GivenField> Given;
  std::unique_ptr<ClosestPoints> Closest;
};

SurfaceCurves::SurfaceCurves(std::shared_ptr<const Surface> surface)
  : Input(std::move(surface))
  , Last(std::make_unique<Kept>())
{
}

SurfaceCurves::~SurfaceCurves() = default;

const GivenField& SurfaceCurves::FieldOf(int degree)
{
  if (!this->Last->Given || this->Last->Given->GetDegree() != degree)
  {
    PointDirections none;
    none.Degree = degree;
    none.Direction = [](Index, int) { return Vector3(Vector3::Zero()); };
    none.Magnitude = [](Index) { return 0.0; };
    this->Last->Given = std::make_unique<GivenField>(*this->Input, none);
  }
  return *this->Last->Given;
}

const ClosestPoints& SurfaceCurves::GetTriangles()
{
  if (!this->Last->Closest)
  {
    this->Last->Closest = std::make_unique<ClosestPoints>(*this->Input);
  }
  return *this->Last->Closest;
}

CurveGuidance SurfaceCurves::Guide(const std::vector<std::vector<Vector3>>& curves,
  const CurveGuidanceOptions& options, const Progress& progress)
{
  const Surface& surface = *this->Input;
  Check(options, curves.size());
  CurveGuidance guidance;
  guidance.Vectors.assign(surface.Points.size(), Vector3::Zero());
  guidance.Weights.assign(surface.Points.size(), 0.0);
  guidance.Strengths.assign(options.Strengths.empty() ? 0 : surface.Points.size(), 0.0);
  if (surface.Triangles.empty())
  {
    return guidance;
  }
  const GivenField& given = this->FieldOf(options.Degree);
  const SurfaceGeometry& geometry = given.GetGeometry();
  progress.Report(0.2);
  const ClosestPoints& closest = this->GetTriangles();
  progress.Report(0.4);
  const double most = options.MaximumDistance > 0.0 ? options.MaximumDistance
                                                    : std::numeric_limits<double>::infinity();
  const auto strengthOf = [&](std::size_t curve)
  { return options.Strengths.empty() ? 1.0 : options.Strengths[curve]; };
  Strokes strokes(given, options.Degree, !options.Strengths.empty());
  const std::vector<CurveSample> samples = Internal::SamplesOf(
    curves, Internal::CurveSteps(curves, 0.5 * MeanEdge(geometry), surface.Triangles.size()));
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    if (i % SamplesPerReport == 0)
    {
      progress.Report(0.4 + 0.4 * static_cast<double>(i) / static_cast<double>(samples.size()));
    }
    const double strength = strengthOf(samples[i].Curve);
    if (strength == 0.0)
    {
      continue;
    }
    const ClosestPoints::Answer found = closest.Find(samples[i].Place, Vector3::Zero(), most);
    if (found.Triangle == None)
    {
      ++guidance.FarSamples;
      continue;
    }
    strokes.Add(found, samples[i].Tangent, strength, options.Radius > 0.0);
  }
  guidance.Samples = static_cast<Index>(samples.size());
  const VertexGuidance at = strokes.Spread(options.Radius, options.Falloff);
  HandToPoints(surface, given, at, guidance);
  progress.Report(1.0);
  return guidance;
}

CurveGuidance GuideByCurves(const Surface& surface, const std::vector<std::vector<Vector3>>& curves,
  const CurveGuidanceOptions& options, const Progress& progress)
{
  // The surface outlives the call.
  const std::shared_ptr<const Surface> own(std::shared_ptr<const Surface>(), &surface);
  return SurfaceCurves(own).Guide(curves, options, progress);
}
}
