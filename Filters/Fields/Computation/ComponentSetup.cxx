// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Computation/ComponentSetup.h"

#include "Sections/Assembly.h"
#include "Sections/DoubleCover.h"
#include "Sections/ReferenceSection.h"

#include <utility>

namespace DirectionFields::Internal
{
double SmallestScale(const SurfaceGeometry& geometry, std::size_t component, int degree)
{
  return 2.0 * Pi * degree / geometry.Lengths.ComponentArea[component];
}

ComponentStage SetUpComponent(const SurfaceGeometry& geometry, std::size_t c,
  const IntrinsicGeometry& triangulation, const Options& options, const Progress& progress)
{
  const TriangleMesh::Component& component = geometry.Mesh.GetComponents()[c];
  Operators matrices =
    AssembleOperators(triangulation, component, options.Degree, options.EnergyBias);
  EigenpairSettings settings;
  settings.Tolerance = options.Tolerance;
  settings.MaximumIterations = options.MaximumIterations;
  settings.Scale = SmallestScale(geometry, c, options.Degree);
  const ReferenceSection reference(geometry, component, options.Degree);
  SmallestPairs pairs = FindSmallestPairs(
    matrices, [&] { return reference.Start(); }, options.Solver, settings, progress);
  reference.FixPhase(pairs.First.Vector);
  if (component.IsCover)
  {
    DoubleCover(geometry, component, options.Degree)
      .MakeSymmetric(pairs.First.Vector, matrices.Mass);
  }
  return ComponentStage(
    std::move(matrices), std::move(pairs), settings.Scale, geometry.Lengths.Unit[c]);
}
}
