// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Conversion/Input/Triangulator.h"

#include <DirectionFields/Soup/PolygonEars.h>

#include "vtkCallbackCommand.h"

#include <algorithm>
#include <numeric>

namespace DirectionFields
{
namespace
{
/// From this number of corners on VTK takes long, and a fan would have a corner of too many
/// triangles.
constexpr std::size_t ManyCorners = 256;
/// A polygon of fewer corners has no two loops.
constexpr std::size_t FewestWithLoops = 6;
}

Triangulator::Triangulator(vtkPoints* points, TriangulatedPolyData& result)
  : Points(points)
  , Result(result)
{
  this->Polygon->Points->SetDataTypeToDouble();
  // vtkPolygon warns about each polygon that it cannot cut, but such a polygon becomes a fan. An
  // observer keeps the warnings from the screen.
  vtkNew<vtkCallbackCommand> silence;
  this->Polygon->AddObserver("WarningEvent", silence);
  this->Polygon->AddObserver("ErrorEvent", silence);
}

void Triangulator::AddStrip(vtkIdType cell, vtkIdType size, const vtkIdType* points)
{
  for (vtkIdType i = 0; i + 2 < size; ++i)
  {
    // Every other triangle of a strip runs backwards.
    const vtkIdType odd = i % 2;
    this->AddTriangle(cell, points[i], points[i + 1 + odd], points[i + 2 - odd]);
  }
}

void Triangulator::AddPolygon(vtkIdType cell, vtkIdType size, const vtkIdType* points)
{
  if (size == 3)
  {
    this->AddTriangle(cell, points[0], points[1], points[2]);
    return;
  }
  this->SetCorners(size, points);
  const auto corners = static_cast<vtkIdType>(this->Corners.size());
  if (size < 3)
  {
    return;
  }
  if (corners < 3)
  {
    // Nothing but repetitions: one collapsed triangle, so that the cell is counted as collapsed.
    this->AddTriangle(cell, points[0], points[0], points[0]);
  }
  else if (corners == 3 || !this->Cut())
  {
    for (vtkIdType i = 1; i + 1 < corners; ++i)
    {
      this->AddTriangle(cell, this->Corners[0], this->Corners[i], this->Corners[i + 1]);
    }
  }
  else
  {
    for (std::size_t i = 0; i + 2 < this->Ears.size(); i += 3)
    {
      this->AddTriangle(cell, this->Corners[this->Ears[i]], this->Corners[this->Ears[i + 1]],
        this->Corners[this->Ears[i + 2]]);
    }
  }
}

void Triangulator::AddCopy(vtkIdType cell, vtkIdType earlierCell, bool isReversed)
{
  const std::vector<vtkIdType>& cells = this->Result.CellOfTriangle;
  const auto [first, last] = std::equal_range(cells.begin(), cells.end(), earlierCell);
  for (auto at = first - cells.begin(), end = last - cells.begin(); at < end; ++at)
  {
    const Triangle triangle = this->Result.Mesh.Triangles[at];
    this->AddTriangle(
      cell, triangle[0], triangle[isReversed ? 2 : 1], triangle[isReversed ? 1 : 2]);
  }
}

void Triangulator::AddTriangle(vtkIdType cell, vtkIdType i, vtkIdType j, vtkIdType k)
{
  this->Result.Mesh.Triangles.push_back(
    { static_cast<Index>(i), static_cast<Index>(j), static_cast<Index>(k) });
  this->Result.CellOfTriangle.push_back(cell);
}

void Triangulator::SetCorners(vtkIdType size, const vtkIdType* points)
{
  this->Corners.clear();
  for (vtkIdType i = 0; i < size; ++i)
  {
    if (this->Corners.empty() || this->Corners.back() != points[i])
    {
      this->Corners.push_back(points[i]);
    }
  }
  while (this->Corners.size() > 1 && this->Corners.front() == this->Corners.back())
  {
    this->Corners.pop_back();
  }
}

bool Triangulator::Cut()
{
  const std::size_t corners = this->Corners.size();
  this->Places.resize(corners);
  for (std::size_t i = 0; i < corners; ++i)
  {
    this->Points->GetPoint(this->Corners[i], this->Places[i].data());
    if (!this->Places[i].allFinite())
    {
      return false;
    }
  }
  if (corners >= ManyCorners)
  {
    return this->CutWithCore(true);
  }
  // VTK takes holes that are joined to the outline by bridges for crossings.
  if (corners >= FewestWithLoops && ReturnsToPlaces(this->Places) && this->CutWithCore(false))
  {
    return true;
  }
  return this->CutWithVTK() || this->CutWithCore(false);
}

bool Triangulator::CutWithCore(bool force)
{
  const std::vector<Index> ears = CutEars(this->Places, force);
  this->Ears.assign(ears.begin(), ears.end());
  return !this->Ears.empty();
}

bool Triangulator::CutWithVTK()
{
  const auto corners = static_cast<vtkIdType>(this->Corners.size());
  if (this->Polygon->PointIds->GetNumberOfIds() != corners)
  {
    this->Polygon->PointIds->SetNumberOfIds(corners);
    std::iota(this->Polygon->PointIds->begin(), this->Polygon->PointIds->end(), vtkIdType(0));
    this->Polygon->Points->SetNumberOfPoints(corners);
  }
  for (vtkIdType i = 0; i < corners; ++i)
  {
    this->Polygon->Points->SetPoint(i, this->Places[i].data());
  }
  // The one signature that all versions of VTK share; vtkPolygon hides it in some.
  vtkCell* polygon = this->Polygon;
  if (polygon->Triangulate(0, this->EarIds, this->EarPoints) == 0 ||
    this->EarIds->GetNumberOfIds() != 3 * (corners - 2))
  {
    return false;
  }
  this->Ears.assign(this->EarIds->begin(), this->EarIds->end());
  return true;
}
}
