// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_OutputPoints_h
#define DirectionFields_OutputPoints_h

#include "Mesh/TriangleMesh.h"
#include "Support/LargeArray.h"
#include "Support/Threads.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The points that results are given at: the points of the input, then one for each vertex whose
/// point has another vertex already. Of a cover there are only the front vertices.
class OutputPoints
{
public:
  /// @param mesh    of the surface, or of the surface with points merged
  /// @param surface as it came in
  /// @param merged  for each point the one that stands for it in the mesh; empty if none was merged
  OutputPoints(const TriangleMesh& mesh, const Surface& surface, const std::vector<Index>& merged);

  /// Values over the vertices as an array over the output points, zero where there is no vertex.
  template <typename T>
  std::vector<T> Spread(const std::vector<T>& values, const T& zero) const
  {
    // Vectors of Eigen are not set to anything here, which saves a pass.
    std::vector<T> spread(this->Vertex.size());
    PreferLargePages(spread.data(), spread.size() * sizeof(T));
    ParallelFor(static_cast<Index>(spread.size()), 1 << 13,
      [&](Index begin, Index end)
      {
        for (Index i = begin; i < end; ++i)
        {
          spread[i] = this->Vertex[i] != None ? values[this->Vertex[i]] : zero;
        }
      });
    return spread;
  }

  /// Vertex of each output point; None where no triangle uses it.
  std::vector<Index> Vertex;
  /// Input point of each output point.
  std::vector<Index> Original;
  /// Corners of the input's triangles as output points; empty where nothing was split. Winding and
  /// first corner are the input's.
  std::vector<Triangle> SplitTriangles;
};
}

#endif
