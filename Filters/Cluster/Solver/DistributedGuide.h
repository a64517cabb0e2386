// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DistributedGuide_h
#define DistributedGuide_h

#include "Curvature/Curvature.h"
#include "Mesh/DistributedMesh.h"
#include "Mesh/Messages.h"
#include "Mesh/PieceWithSurroundings.h"
#include "Options.h"
#include "Processes.h"
#include "Result.h"

#include <optional>
#include <string>
#include <vector>

namespace DirectionFields::Parallel
{
/// The values that a field on several processes is drawn to, and its constraints, over the vertices
/// of the mesh.
struct DistributedGuide
{
  /// Whether the field is drawn to anything, and whether any vertex may be constrained: the same on
  /// all processes, for all must go the same way. The lists say nothing of that on a process
  /// without vertices.
  bool IsDrawn = false;
  bool IsConstrained = false;
  /// Right at owned vertices; empty for nothing.
  std::vector<Complex> Drawn;
  /// As Constraints, right at the vertices of the piece and next to it; empty where nothing of the
  /// whole surface is constrained.
  std::vector<ConstraintKind> Kind;
  std::vector<Complex> Value;
  /// The curvature that the field is drawn to, and the share of the strength that each component of
  /// the whole surface has; nothing where the field follows something else.
  std::optional<Curvature> Curved;
  std::vector<double> Shares;
  double ShareOf(int component) const
  {
    return this->Shares.empty() ? 1.0 : this->Shares[component];
  }
  /// Why the options can only be had of the gathered surface; the same on all processes.
  std::string Reason;
};

/// All processes call it; throws ProcessesError.
/// @param options  that WhyNotDistributed has nothing against
/// @param guidance of the input's points
DistributedGuide MakeGuide(Processes& processes, const Messages& messages,
  const DistributedMesh& mesh, const PieceWithSurroundings& piece, const Options& options,
  const Guidance& guidance);
}

#endif
