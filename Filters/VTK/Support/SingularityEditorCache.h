// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SingularityEditorCache_h
#define SingularityEditorCache_h

#include "Conversion/Input/PolyDataToSurface.h"

#include <DirectionFields/PrescribedSingularities/SingularityEditor.h>
#include <DirectionFields/Progress.h>

#include "vtkType.h"

#include <memory>
#include <utility>
#include <vector>

class vtkObject;
class vtkPolyData;

namespace DirectionFields
{
/// The fields of the last input, one for each of its blocks, with all data for edits of their
/// singularities. In the next execution a block whose points, cells, directions and constraints are
/// the same keeps its solver; blocks are compared in their order.
class SingularityEditorCache
{
public:
  struct Block
  {
    std::shared_ptr<TriangulatedPolyData> Surface;
    std::unique_ptr<SingularityEditor> Editor;
  };

  /// The next block is the first one.
  void Begin() { this->Position = 0; }
  /// The data of the next block. Its Editor is null where it has no triangles. Throws as
  /// PolyDataToSurface does, and std::invalid_argument for missing directions.
  /// @param input            has passed CheckPolyData
  /// @param keepsConstraints whether the points that ConstraintKind tells keep their directions
  Block& Next(vtkPolyData* input, bool keepsConstraints, const Progress& progress);
  /// Forgets blocks that were not asked for since Begin.
  void End() { this->Blocks.resize(this->Position); }
  void Clear() { this->Blocks.clear(); }
  /// The same for an input that is not kept.
  static Block Make(
    vtkPolyData* input, std::shared_ptr<TriangulatedPolyData> surface, bool keepsConstraints);

private:
  /// An object and when it was modified: no two objects were modified at the same time.
  using State = std::pair<const vtkObject*, vtkMTimeType>;
  struct Entry
  {
    Block Kept;
    /// Of the arrays that the field is read from.
    std::vector<State> Field;
    bool KeepsConstraints = false;
  };
  static std::vector<State> FieldOf(vtkPolyData* input);

  std::vector<Entry> Blocks;
  std::size_t Position = 0;
};
}

#endif
