// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef MovedComponents_h
#define MovedComponents_h

#include "Computation/Guide.h"
#include "Geometry/SurfaceGeometry.h"
#include "Mesh/DistributedMesh.h"
#include "Mesh/Messages.h"
#include "Mesh/PieceWithSurroundings.h"
#include "Processes.h"
#include "Solver/DistributedGuide.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace DirectionFields::Parallel
{
/// Components that lie across processes, each of which has no more triangles than a process has in
/// the mean: each is moved to one process, evenly among them, so that all are solved for at once,
/// as on one process. That takes a third of the memory and half of the work that a triangle takes
/// where all processes solve for it, so that a component of a process's share fits into its memory.
/// No process becomes the home of more than twice its share.
class MovedComponents
{
public:
  /// All processes call it; throws ProcessesError.
  MovedComponents(Processes& processes, const Messages& messages, const DistributedMesh& mesh,
    const PieceWithSurroundings& piece, const DistributedGuide& guide);

  /// Whether a component of the whole surface is moved; the same on all processes.
  bool IsMoved(int component) const { return this->Home[component] >= 0; }
  /// The components that have been moved here: each is a component of the geometry.
  const std::vector<int>& Here() const { return this->ComponentsHere; }
  /// Their surface; there is none where there are none.
  const SurfaceGeometry& GetGeometry() const { return *this->Geometry; }
  ComponentGuide GuideOf(std::size_t part) const;

  /// Takes sections to where the components came from. All processes call it; throws
  /// ProcessesError.
  /// @param moved   over the vertices of the geometry
  /// @param section over the vertices of the mesh; gets the values of the owned ones
  void SendBack(Processes& processes, const Messages& messages, const std::vector<Complex>& moved,
    std::vector<Complex>& section) const;

private:
  void ChooseHomes(
    const Messages& messages, const DistributedMesh& mesh, const PieceWithSurroundings& piece);

  /// The process that each component of the whole surface is moved to; -1 for none.
  std::vector<int> Home;
  std::vector<int> ComponentsHere;
  std::unique_ptr<SurfaceGeometry> Geometry;
  /// As in DistributedGuide, over the vertices of the geometry.
  std::vector<Complex> Drawn;
  std::vector<ConstraintKind> Kind;
  std::vector<Complex> Value;
  /// For each process the vertices of the mesh that went there, and the vertices of the geometry
  /// that came from it.
  std::vector<std::vector<Index>> Sent;
  std::vector<std::vector<Index>> Received;
};
}

#endif
