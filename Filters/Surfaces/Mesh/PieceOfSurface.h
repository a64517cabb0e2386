// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_PieceOfSurface_h
#define DirectionFields_PieceOfSurface_h

#include "Types.h"

#include <cstddef>
#include <type_traits>
#include <vector>

namespace DirectionFields::Internal
{
/// What a computation over the vertices of a mesh that goes from neighbour to neighbour has to know
/// of other meshes. This one is the whole surface, with nothing beside it. Classes that derive from
/// it stand for pieces whose meshes overlap: all pieces call the same functions in the same order.
class PieceOfSurface
{
public:
  PieceOfSurface() = default;
  virtual ~PieceOfSurface() = default;
  PieceOfSurface(const PieceOfSurface&) = delete;
  PieceOfSurface& operator=(const PieceOfSurface&) = delete;

  /// Whether the value at a vertex is computed here. Those of the others come from Complete, as far
  /// as they are neighbours of such vertices.
  virtual bool IsOwned(Index) const { return true; }
  /// Whether a statement holds on any piece.
  virtual bool Any(bool value) const { return value; }
  /// Adds up the numbers of what all pieces have of the same component of the surface.
  /// @param numbers one for each component of the mesh
  virtual void Sum(std::vector<double>& /*numbers*/) const {}
  /// Replaces the values of vertices that others own.
  /// @param values one for each vertex of the mesh
  template <typename T>
  void Complete(std::vector<T>& values) const
  {
    static_assert(std::is_trivially_copyable_v<T>);
    this->CompleteBytes(reinterpret_cast<char*>(values.data()), sizeof(T));
  }

private:
  /// @param size the bytes of a value
  virtual void CompleteBytes(char* /*values*/, std::size_t /*size*/) const {}
};
}

#endif
