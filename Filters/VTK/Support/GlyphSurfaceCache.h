// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef GlyphSurfaceCache_h
#define GlyphSurfaceCache_h

#include "Conversion/Input/PolyDataToSurface.h"

#include <DirectionFields/Glyphs.h>
#include <DirectionFields/Progress.h>

#include "vtkType.h"

#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

class vtkObject;
class vtkPolyData;

namespace DirectionFields
{
/// The surfaces of the last input, one for each of its blocks, with the places of glyphs on them.
/// In the next execution a block whose points and cells are the same keeps its surface, even if its
/// data changed; blocks are compared in their order.
class GlyphSurfaceCache
{
public:
  /// The next block is the first one.
  void Begin();
  /// The surface of the next block. Throws as PolyDataToSurface does.
  /// @param input has passed CheckPolyData
  GlyphSurface& Next(vtkPolyData* input, const Progress& progress);
  /// Forgets blocks that were not asked for since Begin.
  void End();

private:
  /// An object and when it was modified: no two objects were modified at the same time.
  using State = std::pair<const vtkObject*, vtkMTimeType>;

  struct Block
  {
    std::shared_ptr<TriangulatedPolyData> Surface;
    std::vector<char> GhostPoints;
    /// Of polygons, strips and the marks of ghosts.
    std::array<State, 3> Cells;
    std::unique_ptr<GlyphSurface> Glyphs;
  };

  static std::array<State, 3> CellsOf(vtkPolyData* input);
  /// Whether a block has points and cells of these very values, as far as that is told quickly.
  static bool IsOf(vtkPolyData* input, const Block& block);

  std::vector<Block> Blocks;
  std::size_t Position = 0;
};
}

#endif
