// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DirectionField.h"

#include "Connection.h"
#include "Metric.h"
#include "Operators.h"
#include "ReferenceSection.h"
#include "Singularities.h"
#include "SmallestEigenpair.h"
#include "TangentFrames.h"
#include "TriangleMesh.h"

#include <cmath>
#include <numeric>
#include <stdexcept>

namespace DirectionFields
{
namespace
{
void Check(const Options& options)
{
  const auto require = [](bool valid, const char* what)
  {
    if (!valid)
    {
      throw std::invalid_argument(what);
    }
  };
  // Written so that NaN is refused as well.
  require(options.Degree >= 1 && options.Degree <= 16, "Degree must be 1 to 16.");
  require(options.EnergyBias >= -1.0 && options.EnergyBias <= 1.0, "EnergyBias must be -1 to 1.");
  require(
    options.Tolerance >= 1e-12 && options.Tolerance <= 0.1, "Tolerance must be 1e-12 to 0.1.");
  require(options.MaximumIterations >= 1 && options.MaximumIterations <= 10000,
    "MaximumIterations must be 1 to 10000.");
}
}

/// What depends on the surface alone.
struct DirectionField::Stages
{
  explicit Stages(const Surface& surface)
    : Points(surface.Points)
    , InputTriangles(static_cast<Index>(surface.Triangles.size()))
    , Mesh(surface)
    , Geometry(this->Mesh, this->Points)
    , Transport(this->Mesh, this->Geometry, this->Points)
    , Frames(this->Mesh, this->Geometry, this->Transport, this->Points)
  {
  }

  std::vector<Vector3> Points;
  Index InputTriangles;
  TriangleMesh Mesh;
  Metric Geometry;
  Connection Transport;
  TangentFrames Frames;
};

Vector3 Result::Direction(Index point, int k) const
{
  const Vector3& n = this->Normal[point];
  const Vector3& x = this->XAxis[point];
  const Vector3 y = n.cross(x);
  const double period = 2.0 * Pi / this->Degree;
  const double phase = std::arg(this->Representation[point]) / this->Degree;
  // Where the first axis of space is nearly normal, the second.
  const int axis = std::abs(n[0]) < 1.0 - 1e-6 ? 0 : 1;
  const double nearest = std::round((std::atan2(y[axis], x[axis]) - phase) / period);
  const double angle = phase + (nearest + k) * period;
  return std::cos(angle) * x + std::sin(angle) * y;
}

DirectionField::DirectionField(const Surface& surface)
  : Surface_(std::make_unique<Stages>(surface))
{
}

DirectionField::~DirectionField() = default;
DirectionField::DirectionField(DirectionField&&) noexcept = default;
DirectionField& DirectionField::operator=(DirectionField&&) noexcept = default;

Result DirectionField::Compute(const Options& options, const ProgressFunction& progress) const
{
  Check(options);
  const Stages& stages = *this->Surface_;
  const TriangleMesh& mesh = stages.Mesh;
  Result result;
  result.Degree = options.Degree;
  result.Repaired = mesh.GetRepairs();
  result.Repaired.DegenerateTriangles = stages.Geometry.DegenerateTriangles;

  std::vector<Complex> field(mesh.GetNumberOfVertices());
  for (std::size_t c = 0; c < mesh.GetComponents().size(); ++c)
  {
    const TriangleMesh::Component& component = mesh.GetComponents()[c];
    const auto report = [&](int solves)
    {
      // Convergence takes some 10 to 20 solves as a rule.
      const double within = solves == 0 ? 0.0 : 1.0 - 0.6 * std::exp(-0.1 * (solves - 1));
      return !progress ||
        progress((component.FirstVertex + within * component.Vertices()) /
          mesh.GetNumberOfVertices());
    };
    const Operators operators = AssembleOperators(mesh, stages.Geometry, stages.Transport, component,
      options.Degree, options.EnergyBias);
    EigenpairSettings settings;
    settings.Tolerance = options.Tolerance;
    settings.MaximumIterations = options.MaximumIterations;
    settings.Scale = 2.0 * Pi * options.Degree / stages.Geometry.ComponentArea[c];
    const ReferenceSection reference(
      mesh, stages.Frames, stages.Points, component, options.Degree);
    Eigenpair pair =
      SmallestEigenpair(operators.Energy, operators.Mass, reference.Start(), settings, report);
    if (pair.Aborted)
    {
      Result aborted;
      aborted.Degree = options.Degree;
      aborted.Repaired = result.Repaired;
      aborted.Aborted = true;
      return aborted;
    }
    reference.FixPhase(pair.Vector);
    const double unit = stages.Geometry.Unit[c];
    for (Index v = 0; v < component.Vertices(); ++v)
    {
      field[component.FirstVertex + v] = pair.Vector[v];
    }

    ComponentReport figures;
    figures.Eigenvalue = pair.Value / unit / unit;
    figures.Residual = pair.Residual;
    figures.Iterations = pair.Iterations;
    figures.EulerCharacteristic = component.Vertices() - component.Edges() + component.Triangles();
    figures.Vertices = component.Vertices();
    figures.Triangles = component.Triangles();
    figures.Closed = component.Closed;
    figures.Converged = pair.Residual <= options.Tolerance;
    result.Components.push_back(figures);
  }

  const std::vector<int> indices =
    SingularityIndices(mesh, stages.Transport, options.Degree, field);
  result.SingularityIndex.assign(stages.InputTriangles, 0);
  result.Component.assign(stages.InputTriangles, None);
  for (std::size_t c = 0; c < mesh.GetComponents().size(); ++c)
  {
    const TriangleMesh::Component& component = mesh.GetComponents()[c];
    for (Index t = component.FirstTriangle; t < component.EndTriangle; ++t)
    {
      result.SingularityIndex[mesh.InputTriangle(t)] = indices[t];
      result.Component[mesh.InputTriangle(t)] = static_cast<Index>(c);
      result.Components[c].IndexSum += indices[t];
    }
  }
  result.Representation.assign(stages.Points.size(), 0.0);
  result.Normal.assign(stages.Points.size(), Vector3::Zero());
  result.XAxis.assign(stages.Points.size(), Vector3::Zero());
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    const Index point = mesh.Point(v);
    result.Representation[point] = field[v];
    result.Normal[point] = stages.Frames.Normal[v];
    result.XAxis[point] = stages.Frames.X[v];
  }
  return result;
}
}
