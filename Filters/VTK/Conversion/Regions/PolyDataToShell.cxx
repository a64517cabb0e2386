// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Conversion/Regions/PolyDataToShell.h"

#include "Conversion/Input/CellCorners.h"
#include "Conversion/Input/PolyDataCheck.h"
#include "Conversion/Regions/CellRegions.h"
#include "Conversion/Regions/MeshLines.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace DirectionFields
{
namespace
{
/// The polygons; their cells have the numbers after those of vertices and lines.
vtkIdType FirstPolygon(vtkPolyData* polyData)
{
  return polyData->GetNumberOfVerts() + polyData->GetNumberOfLines();
}

void AddFaces(vtkPolyData* polyData, ShellMesh& mesh)
{
  const vtkIdType first = FirstPolygon(polyData);
  const vtkIdType count = polyData->GetNumberOfPolys();
  CheckCorners(polyData->GetPolys(), first, polyData->GetNumberOfPoints());
  WithCorners(polyData->GetPolys(),
    [&](const auto* offsets, const auto* corners)
    {
      for (vtkIdType c = 0; c < count; ++c)
      {
        const auto size = offsets[c + 1] - offsets[c];
        if (size != 3 && size != 4)
        {
          throw std::invalid_argument("Cell " + std::to_string(first + c) + " has " +
            std::to_string(size) + " corners, but there are shells of 3 and 4 corners only. " +
            "Triangulate makes triangles of all polygons, Field Aligned Remesh quads.");
        }
        std::array<Index, 4> face = { None, None, None, None };
        for (int k = 0; k < static_cast<int>(size); ++k)
        {
          face[static_cast<std::size_t>(k)] = static_cast<Index>(corners[offsets[c] + k]);
        }
        mesh.Faces.push_back(face);
      }
    });
}

/// The array that has the regions: for AutomaticRegions that which came with the mesh, if it is
/// still there.
std::string RegionsOf(vtkPolyData* polyData, const char* name)
{
  const std::string wanted = name ? name : "";
  vtkCellData* const data = polyData->GetCellData();
  if (wanted != AutomaticRegions || data->HasArray(AutomaticRegions))
  {
    return wanted;
  }
  const std::string kept = KeptRegionArray(polyData->GetFieldData());
  return data->HasArray(kept.c_str()) ? kept : std::string();
}

void AddRegions(vtkPolyData* polyData, const char* name, ShellMesh& mesh)
{
  const vtkIdType first = FirstPolygon(polyData);
  const CellRegions regions = FindRegions(polyData,
    { mesh.Faces.size(), [&](std::size_t f) { return first + static_cast<vtkIdType>(f); } }, name);
  for (const std::string& value : regions.Names)
  {
    const bool isString = value.front() == '"';
    mesh.FaceSets.push_back(
      { isString ? value.substr(1, value.size() - 2) : std::string(name) + " " + value, {} });
  }
  for (std::size_t f = 0; f < regions.OfFaces.size(); ++f)
  {
    mesh.FaceSets[static_cast<std::size_t>(regions.OfFaces[f])].Members.push_back(
      static_cast<Index>(f));
  }
}

void AddDirections(vtkPolyData* polyData, const std::string& name, ShellMesh& mesh)
{
  vtkDataArray* array = polyData->GetCellData()->GetArray(name.c_str());
  if (name.empty() || (!array && name == "None"))
  {
    return;
  }
  if (!array || array->GetNumberOfComponents() != 3)
  {
    throw std::invalid_argument("There is no cell array \"" + name +
      "\" of 3 components. Choose another for Direction Array; Cell Directions of Direction Field "
      "makes such arrays.");
  }
  const vtkIdType first = FirstPolygon(polyData);
  mesh.Directions.resize(mesh.Faces.size());
  for (std::size_t f = 0; f < mesh.Faces.size(); ++f)
  {
    array->GetTuple(first + static_cast<vtkIdType>(f), mesh.Directions[f].data());
  }
}
}

ShellMesh PolyDataToShell(vtkPolyData* polyData, const char* regions, const char* directions,
  std::vector<std::string>& warnings)
{
  CheckPolyData(polyData);
  if (polyData->GetNumberOfStrips() > 0)
  {
    throw std::invalid_argument(
      "There are triangle strips, which have no elements. Triangulate makes triangles of them.");
  }
  ShellMesh mesh;
  mesh.Points.resize(static_cast<std::size_t>(polyData->GetNumberOfPoints()));
  for (std::size_t p = 0; p < mesh.Points.size(); ++p)
  {
    polyData->GetPoint(static_cast<vtkIdType>(p), mesh.Points[p].data());
  }
  AddFaces(polyData, mesh);
  AddRegions(polyData, RegionsOf(polyData, regions).c_str(), mesh);
  AddDirections(polyData, directions ? directions : "", mesh);
  bool isOther = false;
  mesh.PointSets = KeptChains(polyData->GetFieldData(), mesh, isOther);
  if (isOther)
  {
    warnings.push_back(
      "The lines that came with the mesh are of another one, since they do not run along its edges: "
      "there are no sets of nodes for them. Write the mesh that Field Aligned Remesh has made.");
  }
  const auto isBorder = [](const NamedSet& set) { return set.Name.rfind("Border ", 0) == 0; };
  if (mesh.FaceSets.empty() && std::any_of(mesh.PointSets.begin(), mesh.PointSets.end(), isBorder))
  {
    warnings.push_back(
      "The mesh has borders of regions, but its regions are not in the file: there "
      "is a set of elements for each if their array is the Region Array.");
  }
  return mesh;
}
}
