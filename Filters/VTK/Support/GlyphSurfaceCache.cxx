// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Support/GlyphSurfaceCache.h"

#include "Support/SameSurface.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkPolyData.h"

namespace DirectionFields
{
void GlyphSurfaceCache::Begin()
{
  this->Position = 0;
}

void GlyphSurfaceCache::End()
{
  this->Blocks.resize(this->Position);
}

std::array<GlyphSurfaceCache::State, 3> GlyphSurfaceCache::CellsOf(vtkPolyData* input)
{
  const auto stateOf = [](vtkObject* object) {
    return State{ object, object ? object->GetMTime() : 0 };
  };
  return { stateOf(input->GetPolys()), stateOf(input->GetStrips()),
    stateOf(input->GetCellData()->GetAbstractArray(vtkDataSetAttributes::GhostArrayName())) };
}

bool GlyphSurfaceCache::IsOf(vtkPolyData* input, const Block& block)
{
  if (!block.Glyphs || GhostPoints(input) != block.GhostPoints)
  {
    return false;
  }
  // Points may be moved in place, which their modification time does not tell: they are compared by
  // value. So are triangles. To compare polygons they would have to be cut.
  return IsSurfaceOf(input, *block.Surface) ||
    (CellsOf(input) == block.Cells && ArePointsOf(input, *block.Surface));
}

GlyphSurface& GlyphSurfaceCache::Next(vtkPolyData* input, const Progress& progress)
{
  if (this->Position == this->Blocks.size())
  {
    this->Blocks.emplace_back();
  }
  Block& block = this->Blocks[this->Position];
  if (!IsOf(input, block))
  {
    auto surface = std::make_shared<TriangulatedPolyData>(PolyDataToSurface(input, progress));
    std::vector<char> ghostPoints = GhostPoints(input);
    if (!block.Glyphs || !IsSameSurface(surface->Mesh, block.Surface->Mesh) ||
      ghostPoints != block.GhostPoints)
    {
      // The old surface's data are released before the new one needs memory.
      block = {};
      auto glyphs = std::make_unique<GlyphSurface>(
        std::shared_ptr<const DirectionFields::Surface>(surface, &surface->Mesh),
        surface->Mesh.Ghost, ghostPoints);
      block.Surface = std::move(surface);
      block.GhostPoints = std::move(ghostPoints);
      block.Glyphs = std::move(glyphs);
    }
    block.Cells = CellsOf(input);
  }
  ++this->Position;
  return *block.Glyphs;
}
}
