// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef CellRegions_h
#define CellRegions_h

#include <DirectionFields/Types.h>

#include "vtkType.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

class vtkPolyData;

namespace DirectionFields
{
/// The faces that are divided, triangles or others, each a cell or a part of one.
struct FaceCells
{
  std::size_t Count;
  std::function<vtkIdType(std::size_t)> CellOf;
};

/// The regions that a cell array divides a surface into.
struct CellRegions
{
  /// Of each face, from 0 on in the order in which they first appear; empty without an array.
  std::vector<Index> OfFaces;
  /// The array's values, by those numbers.
  std::vector<std::string> Names;
};

/// Reads a cell array of one component: integers, strings, or numbers that are whole.
/// @param name of the array; null, an empty name and "None" are no array
/// Throws std::invalid_argument, its text a sentence for the user, where there is no such array,
/// where it has other values, and where it has as many as numbers of the cells would be.
CellRegions FindRegions(vtkPolyData* polyData, const FaceCells& faces, const char* name);
}

#endif
