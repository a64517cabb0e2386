// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FaceShaping_h
#define DirectionFields_FaceShaping_h

#include "Distance/ClosestPoints.h"
#include "FaceMesh/FaceMesh.h"
#include "Progress.h"

#include <vector>

namespace DirectionFields::Internal
{
struct ShapingSettings
{
  /// Steps in which the vertices move; nothing is done for 0.
  int Steps = 0;
  /// The field is of degree 4: faces may be changed.
  bool AreQuads = true;
  /// Bad faces are mended.
  bool Mends = true;
  /// Quads may become triangles where faces get better.
  bool MayMakeTriangles = false;
  /// Triangles are joined in pairs before anything else.
  bool JoinsTriangles = false;
  /// The faces are to be split: they are edited, but only the vertices that edits concern move. To make large faces
  /// regular would draw them away from thin parts of the surface.
  bool IsDraft = false;
};

/// Moves the vertices of a mesh so that its faces become regular, turns edges where that leaves fewer irregular
/// vertices, and mends bad faces. Steps before that tell which faces can become good; those after it bring the others
/// into line. Throws Stopped.
/// @param surface    its triangles
/// @param lines      the segments of each feature
/// @param edgeLength wanted at each vertex
void ShapeFaces(FaceMesh& mesh, const ShapingSettings& settings, const ClosestPoints& surface,
  const std::vector<ClosestPoints>& lines, const std::vector<double>& edgeLength,
  const Progress& progress = {});
}

#endif
