// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef MeshPiece_h
#define MeshPiece_h

#include "Mesh/DistributedMesh.h"
#include "Mesh/Messages.h"
#include "Mesh/PieceOfSurface.h"

#include <cstddef>
#include <vector>

namespace DirectionFields::Parallel
{
/// The piece of a process, for computations from neighbour to neighbour.
class MeshPiece final : public Internal::PieceOfSurface
{
public:
  /// @param messages, mesh must outlive the piece
  MeshPiece(const Messages& messages, const DistributedMesh& mesh)
    : Exchange(messages)
    , Mesh(mesh)
  {
  }

  bool IsOwned(Index vertex) const override { return this->Mesh.IsOwned(vertex); }
  bool Any(bool value) const override { return this->Exchange.Any(value); }
  void Sum(std::vector<double>& numbers) const override
  {
    std::vector<double> sums(static_cast<std::size_t>(this->Mesh.CountComponents()), 0.0);
    for (int component = 0; component < this->Mesh.CountComponents(); ++component)
    {
      for (const std::size_t part : this->Mesh.PartsOf(component))
      {
        sums[component] += numbers[part];
      }
    }
    this->Exchange.Sum(sums.data(), static_cast<int>(sums.size()));
    for (int component = 0; component < this->Mesh.CountComponents(); ++component)
    {
      for (const std::size_t part : this->Mesh.PartsOf(component))
      {
        numbers[part] = sums[component];
      }
    }
  }

private:
  void CompleteBytes(char* values, std::size_t size) const override
  {
    this->Mesh.CompleteBytes(values, size);
  }

  const Messages& Exchange;
  const DistributedMesh& Mesh;
};
}

#endif
