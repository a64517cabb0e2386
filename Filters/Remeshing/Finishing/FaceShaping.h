// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FaceShaping_h
#define DirectionFields_FaceShaping_h

#include "Distance/ClosestPoints.h"
#include "FaceMesh/FaceMesh.h"
#include "FaceMesh/MovableFaces.h"
#include "Progress.h"
#include "PureQuads/TrianglePairs.h"

#include <optional>
#include <vector>

namespace DirectionFields::Internal
{
struct ShapingSettings
{
  /// Steps in which the vertices move; 0 only joins triangles.
  int Steps = 0;
  /// Of the field: 4 or 6.
  int Degree = 4;
  /// Faces may be changed.
  bool EditsFaces = true;
  /// Bad faces are repaired.
  bool RepairsFaces = true;
  /// Quads may become triangles where faces get better.
  bool MayMakeTriangles = false;
  /// How far edges of lines may stray from them, in wanted lengths; 0 for as far as it comes.
  double MostStraying = 0.0;
  /// SmoothingDomain::IsRough.
  bool IsRough = false;
  /// Triangles are joined in pairs before anything else.
  std::optional<JoinPolicy> Joins;
};

/// Moves the vertices of a mesh so that its faces become regular, turns edges where that leaves
/// fewer irregular vertices, and repairs bad faces. The steps before the edits tell which faces can
/// become good; the steps after them even out the others. Throws Stopped.
/// @param surface    its triangles
/// @param lines      the segments of each feature
/// @param edgeLength wanted at each vertex
/// @param patches    that vertices keep to
void ShapeFaces(FaceMesh& mesh, const ShapingSettings& settings, const ClosestPoints& surface,
  const std::vector<ClosestPoints>& lines, const std::vector<double>& edgeLength,
  const VertexPatches& patches, const Progress& progress = {});
}

#endif
