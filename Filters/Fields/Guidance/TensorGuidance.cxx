// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Guidance/TensorGuidance.h"

#include "Guidance/TensorSection.h"
#include "Interpolation/GivenField.h"

#include <vector>

namespace DirectionFields
{
TensorGuidance GuideByTensors(const Surface& surface, const SurfaceTensors& tensors,
  const TensorGuidanceOptions& options, const Progress& progress)
{
  Internal::Check(surface, tensors, options);
  const FieldSurface made(surface);
  const SurfaceGeometry& geometry = *made.Geometry;
  progress.Report(0.3);
  const Internal::VertexTensors at(geometry, tensors, options.Scale, progress.Part(0.3, 0.95));
  std::vector<Index> vertices(surface.Points.size(), None);
  // The first vertex of a point counts, and points that share a vertex have that of the first.
  for (Index v = geometry.Mesh.GetNumberOfVertices() - 1; v >= 0; --v)
  {
    vertices[geometry.Mesh.Point(v)] = v;
  }
  for (std::size_t i = 0; i < made.FirstPoint.size(); ++i)
  {
    vertices[i] = vertices[made.FirstPoint[i]];
  }
  TensorGuidance guidance = Internal::AtPoints(geometry, at, options.Direction, vertices);
  progress.Report(1.0);
  return guidance;
}
}
