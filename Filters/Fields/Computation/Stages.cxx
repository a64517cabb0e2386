// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Computation/Stages.h"

#include "Computation/ComponentSetup.h"
#include "Geometry/DihedralAngles.h"
#include "Geometry/IntrinsicTriangulation.h"
#include "Sections/SectionDirections.h"
#include "Support/Division.h"
#include "Support/Threads.h"

#include <utility>

namespace DirectionFields::Internal
{
namespace
{
MergedMesh MeshOf(const Surface& surface, MergePoints which)
{
  switch (which)
  {
    case MergePoints::On:
      return MergedMesh::OfPlaces(surface);
    case MergePoints::Automatic:
      return MergedMesh::AcrossSeams(surface);
    case MergePoints::Off:
      break;
  }
  return MergedMesh::OfPoints(surface);
}
}

Stages::Stages(
  std::shared_ptr<const Surface> surface, MergePoints mergePoints, const std::vector<double>& sizes)
  : Stages(surface, mergePoints, MeshOf(*surface, mergePoints), sizes)
{
}

Stages::Stages(std::shared_ptr<const Surface> surface, MergePoints mergePoints, MergedMesh&& mesh,
  const std::vector<double>& sizes)
  : Input(std::move(surface))
  , Merges(mergePoints)
  , FirstPoint(std::move(mesh.FirstPoint))
  , Geometry(std::move(mesh.Mesh), *this->Input, sizes)
{
}

Stages::Stages(const Surface& surface)
  : Stages(std::make_shared<const Surface>(surface))
{
}

const BoundaryPoints& Stages::GetBoundaryPoints()
{
  if (!this->Boundary)
  {
    this->Boundary.emplace(this->Geometry.Mesh, this->Input->Points);
  }
  return *this->Boundary;
}

Index Stages::CountMergedPoints() const
{
  Index merged = 0;
  for (Index i = 0; i < static_cast<Index>(this->FirstPoint.size()); ++i)
  {
    merged += this->FirstPoint[i] != i;
  }
  return merged;
}

const std::vector<double>& Stages::GetDihedralAngles()
{
  if (!this->Dihedral)
  {
    this->Dihedral = DihedralAngles(this->Geometry);
  }
  return *this->Dihedral;
}

const Curvature& Stages::GetCurvature(double scale)
{
  if (!this->Curved || this->CurvatureScale != scale)
  {
    this->CurvatureAtPoints.reset();
    this->Curved.emplace(this->Geometry, this->GetDihedralAngles(), scale);
    this->CurvatureScale = scale;
  }
  return *this->Curved;
}

const VertexTensors& Stages::GetTensors(
  const std::shared_ptr<const SurfaceTensors>& tensors, double scale)
{
  if (!this->Tensors || this->TensorsGiven != tensors || this->TensorScale != scale)
  {
    this->Tensors.emplace(this->Geometry, *tensors, scale, Progress());
    this->TensorsGiven = tensors;
    this->TensorScale = scale;
  }
  return *this->Tensors;
}

const OutputPoints& Stages::GetOutputPoints()
{
  if (!this->Points)
  {
    this->Points.emplace(this->Geometry.Mesh, *this->Input, this->FirstPoint);
  }
  return *this->Points;
}

CurvatureReport ReportOf(
  const SurfaceGeometry& geometry, const Curvature& curvature, const OutputPoints& points)
{
  constexpr Index piece = 1 << 13;
  std::vector<Complex> smaller(curvature.Hopf.size());
  std::vector<double> mean = curvature.Mean;
  std::vector<double> gaussian = curvature.Gaussian;
  const std::vector<TriangleMesh::Component>& components = geometry.Mesh.GetComponents();
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    const double unit = geometry.Lengths.Unit[c];
    ParallelFor(components[c].Vertices(), piece,
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
  return { points.Spread(DirectionsOf(curvature.Hopf, geometry.Frames, 2), zero),
    points.Spread(DirectionsOf(smaller, geometry.Frames, 2), zero), points.Spread(mean, 0.0),
    points.Spread(gaussian, 0.0) };
}

const std::shared_ptr<const CurvatureReport>& Stages::GetCurvatureReport(double scale)
{
  if (this->CurvatureAtPoints && this->CurvatureScale == scale)
  {
    return this->CurvatureAtPoints;
  }
  this->CurvatureAtPoints = std::make_shared<const CurvatureReport>(
    ReportOf(this->Geometry, this->GetCurvature(scale), this->GetOutputPoints()));
  return this->CurvatureAtPoints;
}

EnergyStage& Stages::GetEnergy(const Options& options, const Progress& progress)
{
  if (this->Energy && AreSameUpTo(OptionStage::Energy, this->Energy->MadeFor, options))
  {
    return *this->Energy;
  }
  this->Energy.reset();
  EnergyStage stage{ options, {}, {}, {} };
  // Flipping takes less time than assembly does, so that only the matrices are kept.
  std::optional<IntrinsicTriangulation> delaunay;
  if (options.IntrinsicDelaunay)
  {
    delaunay.emplace(this->Geometry);
  }
  const IntrinsicGeometry& triangulation =
    delaunay ? static_cast<const IntrinsicGeometry&>(*delaunay) : this->Geometry;
  const std::vector<TriangleMesh::Component>& components = this->Geometry.Mesh.GetComponents();
  const double vertices = this->Geometry.Mesh.GetNumberOfVertices();
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    stage.Components.push_back(SetUpComponent(this->Geometry, c, triangulation, options,
      progress.Part(components[c].FirstVertex / vertices, components[c].EndVertex / vertices)));
  }
  this->Energy = std::move(stage);
  return *this->Energy;
}

UnitStage& Stages::GetUnit(EnergyStage& energy, std::size_t component, const Options& options) const
{
  if (options.IntrinsicDelaunay && !energy.Delaunay)
  {
    energy.Delaunay.emplace(this->Geometry);
  }
  const IntrinsicGeometry& triangulation =
    energy.Delaunay ? static_cast<const IntrinsicGeometry&>(*energy.Delaunay) : this->Geometry;
  energy.Units.resize(energy.Components.size());
  if (!energy.Units[component])
  {
    energy.Units[component] = std::make_unique<UnitStage>(triangulation, this->Geometry,
      this->Geometry.Mesh.GetComponents()[component], options, energy.Components[component]);
  }
  return *energy.Units[component];
}
}
