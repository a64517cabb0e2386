// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef CarriedCellData_h
#define CarriedCellData_h

#include "Conversion/Input/TriangulatedPolyData.h"

#include <DirectionFields/Remesh.h>

#include <string>
#include <vector>

class vtkCellData;
class vtkPolyData;

namespace DirectionFields
{
/// How the data of cells get to the faces of a mesh.
struct CellDataRules
{
  /// Of the triangles, as the mesh was made with; empty for none.
  const std::vector<Index>& Regions;
  /// The array that the regions are from: each face has the value of its region. Empty for none.
  std::string RegionArray;
  /// The array whose integral is kept, empty for none.
  std::string ConservedArray;
};

/// Throws std::invalid_argument, its text a sentence for the user, where an input has no array of
/// numbers of that name, it is that of the regions, or
/// one that the mesh does not take over.
void CheckConserved(vtkPolyData* input, const CellDataRules& rules);

/// Gives the faces of a mesh the data of the cells that they cover: of arrays of real numbers the
/// mean weighted by area, of integers and strings the value that covers most of the face, of
/// others, and of the active normals, that of the closest cell. Arrays of the field are left out.
/// @return sentences for the user
std::vector<std::string> CarryCellData(vtkPolyData* input, const TriangulatedPolyData& surface,
  const RemeshResult& mesh, const CellDataRules& rules, vtkCellData* output);
}

#endif
