// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DistributedMesh_h
#define DistributedMesh_h

#include "Geometry/SurfaceGeometry.h"
#include "Mesh/Messages.h"
#include "Mesh/PieceWithSurroundings.h"
#include "Mesh/SharedPoints.h"
#include "Processes.h"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace DirectionFields::Parallel
{
/// The mesh of a piece with its surroundings, and how each of its vertices is shared with other
/// processes. A vertex is owned by the owner of its point; the owned vertices of all processes are
/// the vertices of the whole surface.
class DistributedMesh
{
public:
  /// All processes call it; throws ProcessesError.
  DistributedMesh(Processes& processes, const Messages& messages,
    const PieceWithSurroundings& piece, const SharedPoints& shared);

  /// Empty where the meshes of the pieces are one mesh, else why they are not, as a part of a
  /// sentence. The same on all processes.
  const std::string& GetReason() const { return this->Reason; }

  /// Whether that is because triangles are wound against each other or cannot be wound alike:
  /// WindAlike mends the former, CoverOneSided the latter.
  bool IsWoundOtherwise() const { return this->WoundOtherwise; }

  /// In the unit of the whole component, and with right normals at all vertices.
  const SurfaceGeometry& GetGeometry() const { return *this->Geometry; }
  const TriangleMesh& GetMesh() const { return this->Geometry->Mesh; }
  bool IsOwned(Index vertex) const { return this->Owned[vertex] != 0; }
  /// The components of the whole surface, ordered by their first triangles, which count from the
  /// first process on.
  int CountComponents() const { return this->Components; }
  /// The component of the whole surface that a component of the mesh belongs to; -1 for one of
  /// which no point belongs to the piece.
  int ComponentOf(std::size_t part) const { return this->ComponentOfPart[part]; }
  /// The components of the mesh that belong to one of the whole surface, in ascending order.
  const std::vector<std::size_t>& PartsOf(int component) const { return this->Parts[component]; }
  /// The process on which a component of the whole surface is wholly, as one component of the mesh
  /// there; -1 where it lies across processes. The same on all of them.
  int ProcessOf(int component) const { return this->ProcessOfComponent[component]; }
  /// Whether a component of the whole surface is the cover of one that has only one side; it counts
  /// as one across processes wherever it is. The same on all processes.
  bool IsCover(int component) const { return this->Covers[component] != 0; }
  bool HasCovers() const
  {
    return std::find(this->Covers.begin(), this->Covers.end(), 1) != this->Covers.end();
  }
  /// Of covers: whether a vertex of the piece is on the front, and the vertex behind it.
  bool IsFront(Index vertex) const { return this->GetMesh().Point(vertex) < this->FrontPoints; }
  Index Behind(Index vertex) const { return this->VertexBehind[vertex]; }

  /// Fills in the values of the vertices that others own and that belong to the piece or are next
  /// to it.
  /// @param values one for each vertex of the mesh
  template <typename T>
  void Complete(std::vector<T>& values) const
  {
    Exchange(this->All, values, this->AllTravellers);
  }
  /// The same for values of any kind.
  /// @param size the bytes of a value
  void CompleteBytes(char* values, std::size_t size) const;
  /// The same for one component of the whole surface that lies across processes, by those that have
  /// parts of it.
  /// @param members   of these processes
  /// @param processes which they are, in ascending order
  template <typename T>
  void Complete(std::vector<T>& values, int component, const Messages& members,
    const std::vector<int>& processes) const
  {
    const Travellers& all = this->TravellersOf[component];
    Travellers travellers;
    for (const int p : processes)
    {
      travellers.Sent.push_back(all.Sent[p]);
      travellers.Received.push_back(all.Received[p]);
    }
    Exchange(members, values, travellers);
  }

private:
  /// The vertices whose values go to each process, and the vertices whose values come from it.
  struct Travellers
  {
    std::vector<std::vector<Index>> Sent;
    std::vector<std::vector<Index>> Received;
  };

  template <typename T>
  static void Exchange(
    const Messages& messages, std::vector<T>& values, const Travellers& travellers)
  {
    std::vector<std::vector<T>> sent;
    messages.Together(
      [&]
      {
        for (const std::vector<Index>& vertices : travellers.Sent)
        {
          std::vector<T>& own = sent.emplace_back();
          for (const Index vertex : vertices)
          {
            own.push_back(values[vertex]);
          }
        }
      });
    const std::vector<std::vector<T>> received = messages.Exchange(sent);
    for (std::size_t p = 0; p < received.size(); ++p)
    {
      for (std::size_t k = 0; k < received[p].size(); ++k)
      {
        values[travellers.Received[p][k]] = received[p][k];
      }
    }
  }

  /// Why the own mesh is none that others' fit to; empty where it is one.
  std::string FindFaults(const PieceWithSurroundings& piece) const;
  bool HasChangedEdgesNearGhosts(const PieceWithSurroundings& piece) const;
  void FindOwned(const PieceWithSurroundings& piece, const SharedPoints& shared);
  void FindExchange(
    Processes& processes, const PieceWithSurroundings& piece, const SharedPoints& shared);
  /// @param matters whether a vertex's value is wanted of its owner, where that is another process
  Travellers FindTravellers(Processes& processes, const PieceWithSurroundings& piece,
    const SharedPoints& shared, const std::vector<char>& matters) const;
  void JoinComponents(
    Processes& processes, const PieceWithSurroundings& piece, const SharedPoints& shared);
  /// Assigns the exchanged vertices to the components of the whole surface.
  /// @param partOf the component of the mesh of each vertex
  void FindTravellersOfComponents(const std::vector<int>& partOf);
  /// Finds the covers, and what is behind their vertices.
  void FindCovers(Processes& processes, const PieceWithSurroundings& piece);
  bool Disagrees(const PieceWithSurroundings& piece) const;
  /// The length of the mean edge of each component of the whole surface. All processes call it.
  std::vector<double> MeanEdges(Processes& processes, const PieceWithSurroundings& piece) const;
  /// Whether an edge is short beside the mean edge of its part here, but not beside that of the
  /// whole component, or the other way round.
  bool HasDoubtfulEdges(const std::vector<double>& meanEdges) const;
  double LengthOf(Index edge) const;

  const Messages& All;
  std::unique_ptr<SurfaceGeometry> Geometry;
  std::string Reason;
  bool WoundOtherwise = false;
  /// The vertex of each point of the piece; None where there is none.
  std::vector<Index> VertexOfPoint;
  std::vector<char> Owned;
  std::vector<int> ComponentOfPart;
  int Components = 0;
  /// For each component of the whole surface; nothing is exchanged for a component on one process.
  std::vector<std::vector<std::size_t>> Parts;
  std::vector<int> ProcessOfComponent;
  std::vector<char> Covers;
  Index FrontPoints = 0;
  /// For each vertex of a cover; empty where there are no covers.
  std::vector<Index> VertexBehind;
  Travellers AllTravellers;
  std::vector<Travellers> TravellersOf;
};
}

#endif
