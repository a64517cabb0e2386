// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DirectionField.h"

#include "Field/ComponentField.h"
#include "Field/Constraints.h"
#include "Field/Guidance.h"
#include "Field/Stages.h"
#include "Mesh/MergePoints.h"
#include "Mesh/OutputPoints.h"
#include "Mesh/OwnedParts.h"
#include "Sections/DoubleCover.h"
#include "Sections/Singularities.h"
#include "Support/Threads.h"
#include "Support/VectorMath.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <string>

namespace DirectionFields
{
namespace
{
constexpr Index PieceSize = 1 << 13;

/// Turns a section by one global phase towards another one; a symmetric section over a cover by half a
/// turn or not at all. Nothing is done where the two have nothing in common.
void TurnTowards(const ComplexVector& reference, bool isCover, ComplexVector& u)
{
  Complex sum = u.dot(reference);
  if (std::abs(sum) <= 1e-3 * u.cwiseAbs().dot(reference.cwiseAbs()))
  {
    return;
  }
  if (isCover)
  {
    sum = sum.real() < 0.0 ? -1.0 : 1.0;
  }
  u *= sum / std::abs(sum);
}

/// The direction of the principal square root.
Complex HalfTurned(const Complex& z)
{
  // First by the larger part, whose square may not underflow.
  const double larger = std::max(std::abs(z.real()), std::abs(z.imag()));
  Complex unit(z.real() / larger, z.imag() / larger);
  unit /= std::sqrt(std::norm(unit));
  // The larger of cosine and sine first, the other without cancellation.
  if (unit.real() >= 0.0)
  {
    const double cosine = std::sqrt(0.5 + 0.5 * unit.real());
    return { cosine, 0.5 * unit.imag() / cosine };
  }
  const double sine = std::copysign(std::sqrt(0.5 - 0.5 * unit.real()), unit.imag());
  return { 0.5 * unit.imag() / sine, sine };
}

/// Tangent vectors of the angles that n-th powers have.
std::vector<Vector3> InSpace(
  const TangentFrames& frames, const std::vector<Complex>& section, int degree)
{
  std::vector<Vector3> vectors(section.size(), Vector3::Zero());
  ParallelFor(static_cast<Index>(section.size()), PieceSize,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        if (section[v] != 0.0)
        {
          const Complex direction = degree == 2
            ? HalfTurned(section[v])
            : std::polar(1.0, std::arg(section[v]) / degree);
          vectors[v] = direction.real() * frames.X[v] + direction.imag() * frames.Y(v);
        }
      }
    });
  return vectors;
}

CurvatureReport ReportCurvature(Stages& stages, const OutputPoints& points)
{
  const Curvature& curvature = stages.GetCurvature();
  std::vector<Complex> smaller(curvature.Hopf.size());
  std::vector<double> mean = curvature.Mean;
  std::vector<double> gaussian = curvature.Gaussian;
  const std::vector<TriangleMesh::Component>& components = stages.GetMesh().GetComponents();
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    const double unit = stages.GetMetric().Unit[c];
    ParallelFor(components[c].Vertices(), PieceSize,
      [&](Index begin, Index end)
      {
        for (Index v = components[c].FirstVertex + begin; v < components[c].FirstVertex + end; ++v)
        {
          smaller[v] = -curvature.Hopf[v];
          mean[v] = Divided(mean[v], unit);
          gaussian[v] = PerSquare(gaussian[v], unit);
        }
      });
  }
  const Vector3 zero = Vector3::Zero();
  return { points.Spread(InSpace(stages.GetFrames(), curvature.Hopf, 2), zero),
    points.Spread(InSpace(stages.GetFrames(), smaller, 2), zero), points.Spread(mean, 0.0),
    points.Spread(gaussian, 0.0) };
}

void AddTriangles(const TriangleMesh& mesh, const Surface& surface, const std::vector<int>& indices,
  Result& result)
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
}

void Result::FirstAngles(Index begin, Index end, double* angles) const
{
  assert(end - begin <= FewPoints);
  const double period = 2.0 * Pi / this->Degree;
  const Index count = end - begin;
  std::array<Complex, FewPoints> axis;
  std::array<double, FewPoints> wanted;
  for (Index i = 0; i < count; ++i)
  {
    const Vector3& normal = this->Normal[begin + i];
    // Where the first axis of space is nearly normal, the second.
    const int c = std::abs(normal[0]) < 1.0 - 1e-6 ? 0 : 1;
    const Vector3& x = this->XAxis[begin + i];
    axis[i] = Complex(x[c], normal.cross(x)[c]);
  }
  Arguments(axis.data(), count, wanted.data());
  Arguments(this->Representation.data() + begin, count, angles);
  for (Index i = 0; i < count; ++i)
  {
    angles[i] /= this->Degree;
    angles[i] += period * std::round((wanted[i] - angles[i]) / period);
  }
}

Vector3 Result::Direction(Index point, int k) const
{
  double angle;
  this->FirstAngles(point, point + 1, &angle);
  angle += k * (2.0 * Pi / this->Degree);
  const Vector3& x = this->XAxis[point];
  return std::cos(angle) * x + std::sin(angle) * this->Normal[point].cross(x);
}

void Result::Directions(Index begin, Index end, Vector3* directions) const
{
  const Complex turn = std::polar(1.0, 2.0 * Pi / this->Degree);
  for (Index first = begin; first < end; first += FewPoints)
  {
    const Index last = std::min(end, first + FewPoints);
    std::array<double, FewPoints> angle;
    this->FirstAngles(first, last, angle.data());
    std::array<double, FewPoints> cosine;
    std::array<double, FewPoints> sine;
    CosinesAndSines(angle.data(), last - first, cosine.data(), sine.data());
    for (Index i = first; i < last; ++i)
    {
      const Vector3& x = this->XAxis[i];
      const Vector3 y = this->Normal[i].cross(x);
      Complex z(cosine[i - first], sine[i - first]);
      for (int k = 0; k < this->Degree; ++k, z *= turn)
      {
        *directions++ = z.real() * x + z.imag() * y;
      }
    }
  }
}

DirectionField::DirectionField(const Surface& surface)
  : DirectionField(std::make_shared<const Surface>(surface))
{
}

DirectionField::DirectionField(std::shared_ptr<const Surface> surface)
  : Input(std::move(surface))
{
}

DirectionField::~DirectionField() = default;
DirectionField::DirectionField(DirectionField&&) noexcept = default;
DirectionField& DirectionField::operator=(DirectionField&&) noexcept = default;

void DirectionField::SetPhaseReference(std::vector<Vector3> directions, int degree)
{
  this->PhaseReference.Vectors = std::move(directions);
  this->PhaseReferenceDegree = degree;
}

void DirectionField::MakeStages(const Options& options)
{
  if (this->Kept && this->Merges == options.MergePoints)
  {
    return;
  }
  this->Kept.reset();
  this->Points.reset();
  this->CurvatureAtPoints.reset();
  this->Merges = options.MergePoints;
  this->FirstPoint = this->Merges ? FirstAtSamePlace(*this->Input) : std::vector<Index>{};
  this->Kept = this->Merges ? std::make_unique<Stages>(Merged(*this->Input, this->FirstPoint))
                            : std::make_unique<Stages>(*this->Input);
}

Result DirectionField::Compute(
  const Options& options, const Guidance& guidance, const ProgressFunction& progress)
{
  Check(options);
  Check(guidance, options, this->Input->Points.size());
  Threads threads(options.NumberOfThreads);
  const Threads::Scope scope(threads);
  const auto goOn = [&](double fraction) { return !progress || progress(fraction); };
  const auto aborted = [&options]
  {
    Result nothing;
    nothing.Degree = options.Degree;
    nothing.Aborted = true;
    return nothing;
  };
  if (!goOn(0.0))
  {
    return aborted();
  }
  this->MakeStages(options);
  if (!goOn(0.0))
  {
    return aborted();
  }
  Stages& stages = *this->Kept;
  const TriangleMesh& mesh = stages.GetMesh();
  Result result;
  result.Degree = options.Degree;
  result.Repaired = mesh.GetRepairs();
  result.Repaired.DegenerateTriangles = stages.GetMetric().DegenerateTriangles;

  const BoundaryPoints& boundary = stages.GetBoundaryPoints();
  if (!options.MergePoints && boundary.LookLikeSoup())
  {
    result.Notes.emplace_back(std::to_string(boundary.Coincident) + " of the " +
      std::to_string(boundary.Count) +
      " points on the boundary of the surface lie exactly on another one: triangles touch there that "
      "are not connected. Switch on MergePoints to connect them.");
  }

  const bool usesVectors =
    options.Alignment == Alignment::PointVectors || options.ConstrainGuidance;
  const std::vector<Complex> given = usesVectors
    ? GuidanceSection(mesh, stages.GetFrames(),
        options.MergePoints ? Merged(guidance, this->FirstPoint) : guidance, options.Degree)
    : std::vector<Complex>{};
  const bool usesCurvature =
    options.Alignment == Alignment::PrincipalCurvature || options.ConstrainCurvature;
  if (usesCurvature && options.Degree == 2 && mesh.GetRepairs().NonOrientableComponents > 0)
  {
    result.Notes.emplace_back("A line field cannot follow the curvature of a surface that cannot be "
                              "oriented: the larger and the smaller curvature change places on a "
                              "walk around it. Take Degree 4.");
  }
  const Constraints constraints(
    { mesh, stages.GetConnection(), stages.GetFrames(), stages.GetPositions(),
      options.ConstrainSharpEdges ? stages.GetDihedralAngles() : std::vector<double>{},
      usesCurvature ? &stages.GetCurvature() : nullptr, stages.GetMetric().ComponentArea, given },
    options, result.Notes);
  std::vector<Complex> drawn;
  if (options.Alignment != Alignment::None)
  {
    drawn = options.Alignment == Alignment::PointVectors
      ? given
      : CurvatureSection(stages.GetCurvature().Hopf, options.Degree, options.CurvatureDirection);
    if (options.Alignment == Alignment::PrincipalCurvature && options.Degree == 2)
    {
      ClearCovers(mesh, drawn);
    }
    if (std::all_of(drawn.begin(), drawn.end(), [](const Complex& q) { return q == 0.0; }))
    {
      result.Notes.emplace_back("Alignment changes nothing: the guidance is zero everywhere.");
      drawn.clear();
    }
  }

  if (!goOn(0.0))
  {
    return aborted();
  }
  // The linear systems take about as long as half of the eigenvalue problem does.
  const bool systems = constraints.Any() || !drawn.empty();
  const double energyPart = systems ? 0.65 : 1.0;
  EnergyStage* energy = stages.GetEnergy(
    options, [&](double fraction) { return goOn(energyPart * fraction); });
  const bool isReferred = this->PhaseReferenceDegree == options.Degree &&
    this->PhaseReference.Vectors.size() == this->Input->Points.size();
  const std::vector<Complex> reference = isReferred
    ? GuidanceSection(mesh, stages.GetFrames(), this->PhaseReference, options.Degree)
    : std::vector<Complex>{};
  std::vector<Complex> field(mesh.GetNumberOfVertices());
  const OwnedParts owned(mesh, *this->Input);
  for (std::size_t c = 0; energy != nullptr && c < mesh.GetComponents().size(); ++c)
  {
    const TriangleMesh::Component& component = mesh.GetComponents()[c];
    bool stopped = false;
    const auto goOnWithSystem = [&]
    {
      stopped = stopped ||
        (systems &&
          !goOn(energyPart +
            (1.0 - energyPart) * component.FirstVertex / std::max(1, mesh.GetNumberOfVertices())));
      return !stopped;
    };
    if (!goOnWithSystem())
    {
      energy = nullptr;
      break;
    }
    const Eigenpair& smoothest = energy->Smoothest[c].First;
    const double unit = stages.GetMetric().Unit[c];
    ComponentProblem problem{ energy->Matrices[c], energy->Smoothest[c], energy->Free[c],
      energy->Solved[c], energy->Terms[c], stages.GetScale(c, options.Degree), unit, {}, {},
      goOnWithSystem };
    if (!drawn.empty())
    {
      problem.Guidance = Eigen::Map<const ComplexVector>(
        drawn.data() + component.FirstVertex, component.Vertices());
    }
    std::vector<Complex> values;
    for (Index v = component.FirstVertex; constraints.Any() && v < component.EndVertex; ++v)
    {
      if (constraints.Kind[v] != ConstraintKind::None)
      {
        problem.Given.Vertices.push_back(v - component.FirstVertex);
        values.push_back(constraints.Value[v]);
      }
    }
    problem.Given.Values =
      Eigen::Map<const ComplexVector>(values.data(), static_cast<Eigen::Index>(values.size()));

    ComponentReport figures;
    ComplexVector u = SolveComponent(problem, options, figures);
    if (stopped)
    {
      energy = nullptr;
      break;
    }
    if (isReferred && values.empty() && problem.Guidance.isZero(0.0))
    {
      TurnTowards(Eigen::Map<const ComplexVector>(
                    reference.data() + component.FirstVertex, component.Vertices()),
        component.IsCover, u);
    }
    if (component.IsCover)
    {
      DoubleCover(mesh, stages.GetConnection(), component, options.Degree).Symmetrize(u);
    }
    std::copy(u.begin(), u.end(), field.begin() + component.FirstVertex);
    figures.Eigenvalue = PerSquare(smoothest.Value, unit);
    figures.Residual = smoothest.Residual;
    figures.Iterations = smoothest.Iterations;
    const OwnedParts::Counts& counts = owned.Components[c];
    figures.EulerCharacteristic = counts.Vertices - counts.Edges + counts.Triangles;
    figures.Vertices = counts.Vertices;
    figures.Triangles = counts.Triangles;
    figures.Constraints = static_cast<Index>(std::count_if(problem.Given.Vertices.begin(),
      problem.Given.Vertices.end(),
      [&](Index v)
      {
        const Index vertex = component.FirstVertex + v;
        return mesh.IsFrontVertex(vertex) && (owned.Vertex.empty() || owned.Vertex[vertex]);
      }));
    figures.Closed = component.Closed && counts.Ghosts == 0;
    figures.Converged =
      smoothest.Residual <= options.Tolerance && figures.SystemResidual <= SystemTolerance(options);
    result.Components.push_back(figures);
  }
  if (energy == nullptr)
  {
    return aborted();
  }

  AddTriangles(mesh, *this->Input,
    SingularityIndices(mesh, stages.GetConnection(), options.Degree, field), result);
  if (!this->Points)
  {
    this->Points = std::make_unique<OutputPoints>(mesh, *this->Input, this->FirstPoint);
  }
  const OutputPoints& points = *this->Points;
  const Vector3 zero = Vector3::Zero();
  result.Representation = points.Spread(field, Complex(0.0));
  result.Normal = points.Spread(stages.GetFrames().Normal, zero);
  result.XAxis = points.Spread(stages.GetFrames().X, zero);
  if (constraints.Any())
  {
    result.Constraint = points.Spread(constraints.Kind, ConstraintKind::None);
    result.ConstraintDirection =
      points.Spread(InSpace(stages.GetFrames(), constraints.Value, options.Degree), zero);
  }
  if (usesCurvature)
  {
    if (!this->CurvatureAtPoints)
    {
      this->CurvatureAtPoints =
        std::make_shared<const CurvatureReport>(ReportCurvature(stages, points));
    }
    result.Curvature = this->CurvatureAtPoints;
  }
  result.OriginalPoint = points.Original;
  result.SplitTriangles = points.SplitTriangles;
  return result;
}
}
