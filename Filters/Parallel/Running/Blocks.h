// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef Blocks_h
#define Blocks_h

#include "Processes.h"

#include "vtkSmartPointer.h"

#include <cstddef>
#include <functional>
#include <vector>

class vtkDataObject;
class vtkInformation;
class vtkPolyData;

namespace DirectionFields::Parallel
{
/// Works on one surface, or the empty piece of one.
using SurfaceWork =
  std::function<void(vtkPolyData* input, const std::vector<vtkPolyData*>& outputs)>;

/// Calls work for each surface of a dataset in the same order on all processes: for the dataset
/// itself, or for each block of a composite one. Blocks belong together by their place in the tree;
/// a process that has less of the tree takes part with empty pieces. All processes call it.
/// @param input     of any type that AcceptBlocks allows; blocks that are no surface give no output
/// @param outputs   of the input's type; filled
void ForEachSurface(Processes& processes, vtkDataObject* input,
  const std::vector<vtkDataObject*>& outputs, const SurfaceWork& work);

/// Lets a port take composite datasets as a whole: the pipeline itself would hand over only the
/// blocks that a process has.
void AcceptBlocks(vtkInformation* port);
}

#endif
