// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef MeshLines_h
#define MeshLines_h

#include "Conversion/Regions/CurveLines.h"

#include <DirectionFields/Chains/MeshChain.h>
#include <DirectionFields/SolverFiles/ShellMesh.h>

#include <string>
#include <vector>

class vtkFieldData;
class vtkPoints;
class vtkPolyData;

namespace DirectionFields
{
/// Fills an empty output with a line for each chain of a mesh, and a vertex for each that is a
/// point. Points are shared where chains meet.
/// @param points of the mesh
/// @param names  of the regions, by their numbers; empty without regions
/// @param kept   curves and points whose cell arrays the lines have
void AddChains(const std::vector<MeshChain>& chains, vtkPoints* points,
  const std::vector<std::string>& names, const KeptLines& kept, vtkPolyData* output);

/// Adds the point array `GivenPoint`: the number of the given point that each point of a mesh is,
/// or -1.
void AddGivenPoints(const std::vector<MeshChain>& chains, vtkPolyData* output);

/// The names and points of chains as arrays that stay with the mesh in files: ChainNames,
/// ChainOffsets and ChainPoints. Without chains there are none.
void KeepChains(const std::vector<MeshChain>& chains, vtkFieldData* data);

/// The name of the cell array that has the regions of a mesh, as an array that stays with it in
/// files: RegionArray. Without a name there is none.
void KeepRegionArray(const std::string& name, vtkFieldData* data);
/// The name that was kept with a mesh; empty for none.
std::string KeptRegionArray(vtkFieldData* data);

/// The chains that were kept with a mesh, a set of points each; empty if there are none.
/// @param isOther true where there are some, but of another mesh: they do not run along edges
std::vector<NamedSet> KeptChains(vtkFieldData* data, const ShellMesh& mesh, bool& isOther);
}

#endif
