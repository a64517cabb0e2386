// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef PolyDataToShell_h
#define PolyDataToShell_h

#include <DirectionFields/SolverFiles/ShellMesh.h>

#include <string>
#include <vector>

class vtkPolyData;

namespace DirectionFields
{
/// Takes for a region array the one that came with the mesh.
constexpr const char* AutomaticRegions = "Automatic";

/// The triangles and quads of polydata as shells; other cells but polygons of more corners and
/// strips are left out. Chains that were kept with the mesh are its sets of points.
/// Throws std::invalid_argument or std::out_of_range, its text a sentence for the user, for damaged
/// data, other polygons, strips, and where there are no such arrays.
/// @param regions    AutomaticRegions, or a cell array as FindRegions takes it, whose values become
///                   sets of faces: the strings, or the array's name and the number
/// @param warnings   gets a sentence where there are chains, but of another mesh
/// @param directions a cell array of 3 components; null, an empty name and "None" are no array
ShellMesh PolyDataToShell(vtkPolyData* polyData, const char* regions, const char* directions,
  std::vector<std::string>& warnings);
}

#endif
