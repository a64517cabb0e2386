// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Field/Stages.h"

#include "Geometry/IntrinsicTriangulation.h"
#include "Sections/DoubleCover.h"
#include "Sections/ReferenceSection.h"

#include <utility>

namespace DirectionFields
{
Stages::Stages(const Surface& surface)
  : Mesh(surface)
  , Positions(this->Mesh.Positions(surface.Points))
  , Geometry(this->Mesh, this->Positions)
  , Transport(this->Mesh, this->Geometry, this->Positions)
  , Frames(this->Mesh, this->Transport, this->Positions)
  , Boundary(this->Mesh, surface.Points)
{
}

double Stages::GetScale(std::size_t component, int degree) const
{
  return 2.0 * Pi * degree / this->Geometry.ComponentArea[component];
}

const std::vector<double>& Stages::GetDihedralAngles()
{
  if (!this->Dihedral)
  {
    this->Dihedral = DihedralAngles(this->Mesh, this->Positions);
  }
  return *this->Dihedral;
}

const Curvature& Stages::GetCurvature()
{
  if (!this->Curved)
  {
    this->Curved.emplace(this->Mesh, this->Geometry, this->Transport, this->Frames, this->Positions,
      this->GetDihedralAngles());
  }
  return *this->Curved;
}

EnergyStage* Stages::GetEnergy(const Options& options, const ProgressFunction& progress)
{
  const EnergyOptions key(options);
  if (this->Energy && this->Energy->Key == key)
  {
    return &*this->Energy;
  }
  this->Energy.reset();
  EnergyStage stage{ key, {}, {}, {}, {}, {} };
  // Flipping takes less time than assembly: nothing of it is kept but the matrices.
  std::optional<IntrinsicTriangulation> delaunay;
  if (options.IntrinsicDelaunay)
  {
    delaunay.emplace(this->Mesh, this->Geometry, this->Transport);
  }
  const std::vector<TriangleMesh::Component>& components = this->Mesh.GetComponents();
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    const TriangleMesh::Component& component = components[c];
    stage.Matrices.push_back(AssembleOperators(delaunay ? delaunay->Mesh : this->Mesh,
      delaunay ? delaunay->Geometry : this->Geometry,
      delaunay ? delaunay->Transport : this->Transport, component, options.Degree,
      options.EnergyBias));
    EigenpairSettings settings;
    settings.Tolerance = options.Tolerance;
    settings.MaximumIterations = options.MaximumIterations;
    settings.Scale = this->GetScale(c, options.Degree);
    const ReferenceSection reference(
      this->Frames, this->Positions, component, options.Degree);
    SmallestPairs pairs;
    try
    {
      const double vertices = this->Mesh.GetNumberOfVertices();
      pairs = FindSmallestPairs(
        stage.Matrices.back(), [&] { return reference.Start(); }, options.Solver, settings,
        Progress(progress).Part(component.FirstVertex / vertices, component.EndVertex / vertices));
    }
    catch (const Stopped&)
    {
      return nullptr;
    }
    reference.FixPhase(pairs.First.Vector);
    if (component.IsCover)
    {
      DoubleCover(this->Mesh, this->Transport, component, options.Degree)
        .MakeSymmetric(pairs.First.Vector, stage.Matrices.back().Mass);
    }
    stage.Smoothest.push_back(std::move(pairs));
    stage.Free.emplace_back();
    stage.Solved.emplace_back();
    stage.Terms.emplace_back();
  }
  this->Energy = std::move(stage);
  return &*this->Energy;
}
}
