// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_TensorGuidance_h
#define DirectionFields_TensorGuidance_h

#include "Guidance/SurfaceTensors.h"
#include "Progress.h"
#include "Surface.h"

namespace DirectionFields
{
/// The tangential part of the tensor T in the frame X, Y of a vertex is q = (X.TX - Y.TY) / 2 + i
/// X.TY, a section of degree 2, and H = (X.TX + Y.TY) / 2: H + |q| and H - |q| are its principal
/// values, arg(q) / 2 is the angle of the first. No eigenvectors are sorted, and isotropic points
/// are the zeros of q: wedges, singularities of index 1 of a line field, and trisectors, of index
/// -1. The normal part of T does not count. q and H are averaged as the shapes of curvature are
/// (Documentation/Method/Tensors.md), as far as their noise makes necessary. Tensors of triangles
/// are carried to the corners, and weighted by the corners' angles. At seams the tensor of the
/// first of the points counts.
///
/// Throws std::invalid_argument for options out of their ranges, for the wrong number of values or
/// components and for values that are not finite, with the place of the first; MeshError and
/// Stopped. Takes linear time.
TensorGuidance GuideByTensors(const Surface& surface, const SurfaceTensors& tensors,
  const TensorGuidanceOptions& options = {}, const Progress& progress = {});
}

#endif
