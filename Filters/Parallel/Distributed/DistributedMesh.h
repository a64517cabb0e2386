// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DistributedMesh_h
#define DistributedMesh_h

#include "Distributed/Messages.h"
#include "Distributed/PieceWithSurroundings.h"
#include "Distributed/SharedPoints.h"
#include "Geometry/SurfaceGeometry.h"
#include "Processes.h"

#include <memory>
#include <string>
#include <vector>

namespace DirectionFields::Parallel
{
/// The mesh of a piece with its surroundings, and what each of its vertices is to the other processes. A vertex
/// is owned by the owner of its point; all owned ones together are those of the whole surface.
class DistributedMesh
{
public:
  /// All processes call it; throws ProcessesError.
  DistributedMesh(Processes& processes, const Messages& messages,
    const PieceWithSurroundings& piece, const SharedPoints& shared);

  /// Empty where the meshes of the pieces are one mesh, else why they are not, as a part of a sentence. The same
  /// on all processes.
  const std::string& GetReason() const { return this->Reason; }

  /// Whether that is because triangles are wound against each other, which WindAlike may mend.
  bool IsWoundOtherwise() const { return this->WoundOtherwise; }

  const SurfaceGeometry& GetGeometry() const { return *this->Geometry; }
  const TriangleMesh& GetMesh() const { return this->Geometry->Mesh; }
  bool IsOwned(Index vertex) const { return this->Owned[vertex] != 0; }
  /// The components of the whole surface, ordered by their first triangles, those of the first process first.
  int CountComponents() const { return this->Components; }
  /// The component of the whole surface that a component of the mesh belongs to; -1 for one of which no point
  /// belongs to the piece.
  int ComponentOf(std::size_t part) const { return this->ComponentOfPart[part]; }

  /// Fills in the values of the vertices that others own and that belong to the piece or are next to it.
  /// @param values one for each vertex of the mesh
  template <typename T>
  void Complete(std::vector<T>& values) const
  {
    std::vector<std::vector<T>> sent(this->Sent.size());
    for (std::size_t p = 0; p < this->Sent.size(); ++p)
    {
      for (const Index vertex : this->Sent[p])
      {
        sent[p].push_back(values[vertex]);
      }
    }
    const std::vector<std::vector<T>> received = this->Exchange.Exchange(sent);
    for (std::size_t p = 0; p < received.size(); ++p)
    {
      for (std::size_t k = 0; k < received[p].size(); ++k)
      {
        values[this->Received[p][k]] = received[p][k];
      }
    }
  }

private:
  /// Why the own mesh is none that others' fit to; empty where it is one.
  std::string FindFaults(const PieceWithSurroundings& piece) const;
  bool HasChangedEdgesNearGhosts(const PieceWithSurroundings& piece) const;
  void FindOwned(const PieceWithSurroundings& piece, const SharedPoints& shared);
  void FindExchange(
    Processes& processes, const PieceWithSurroundings& piece, const SharedPoints& shared);
  void JoinComponents(
    Processes& processes, const PieceWithSurroundings& piece, const SharedPoints& shared);
  bool Disagrees(const PieceWithSurroundings& piece) const;

  const Messages& Exchange;
  std::unique_ptr<SurfaceGeometry> Geometry;
  std::string Reason;
  bool WoundOtherwise = false;
  /// The vertex of each point of the piece; None where there is none.
  std::vector<Index> VertexOfPoint;
  std::vector<char> Owned;
  std::vector<int> ComponentOfPart;
  int Components = 0;
  /// The vertices whose values go to each process, and those whose values come from it.
  std::vector<std::vector<Index>> Sent;
  std::vector<std::vector<Index>> Received;
};
}

#endif
