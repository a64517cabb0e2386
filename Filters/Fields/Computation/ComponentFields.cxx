// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Computation/ComponentFields.h"

#include "Sections/DoubleCover.h"
#include "Sections/ReferenceSection.h"
#include "Sections/ShapePhase.h"

#include <algorithm>

namespace DirectionFields::Internal
{
ComponentFields SolveComponents(Stages& stages, EnergyStage& energy, const Guide& guide,
  const std::vector<Complex>& phaseReference, const Options& options, bool othersFollow,
  const Progress& progress)
{
  const TriangleMesh& mesh = stages.GetMesh();
  ComponentFields fields;
  fields.Section.resize(mesh.GetNumberOfVertices());
  fields.Reports.resize(mesh.GetComponents().size());
  for (std::size_t c = 0; c < mesh.GetComponents().size(); ++c)
  {
    const TriangleMesh::Component& component = mesh.GetComponents()[c];
    if (guide.Any())
    {
      progress.Report(static_cast<double>(component.FirstVertex) / mesh.GetNumberOfVertices());
    }
    const ComponentGuide own = guide.Of(mesh, c);
    energy.Components[c].SetOthersFollow(othersFollow);
    ComplexVector u = energy.Components[c].Solve(own, options, progress, fields.Reports[c]);
    const bool isPhaseFree =
      own.Given.Vertices.empty() && own.Soft.IsEmpty() && own.Guidance.isZero(0.0);
    if (isPhaseFree && !phaseReference.empty())
    {
      TurnTowards(Eigen::Map<const ComplexVector>(
                    phaseReference.data() + component.FirstVertex, component.Vertices()),
        component.IsCover, u);
    }
    const DoubleCover cover(stages.GetGeometry(), component, options.Degree);
    if (component.IsCover)
    {
      cover.Symmetrize(u);
    }
    if (options.UnitLength)
    {
      const double vertices = mesh.GetNumberOfVertices();
      const Progress remaining =
        progress.Part(component.FirstVertex / vertices, component.EndVertex / vertices);
      stages.GetUnit(energy, c, options).Improve(own, options, remaining, u, fields.Reports[c]);
      if (isPhaseFree && phaseReference.empty())
      {
        TurnTowardsShape(stages.GetGeometry(), stages.GetDihedralAngles(), c, options.Degree, u);
      }
      if (component.IsCover)
      {
        cover.Symmetrize(u);
      }
    }
    std::copy(u.begin(), u.end(), fields.Section.begin() + component.FirstVertex);
  }
  return fields;
}
}
