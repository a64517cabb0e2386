// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Triangulator.h"

#include "vtkCallbackCommand.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields
{
Triangulator::Triangulator(vtkPoints* points, TriangulatedPolyData& result)
  : Points(points)
  , Result(result)
{
  // vtkPolygon warns about each polygon that it cannot cut, but a fan is an answer to those.
  // An observer keeps the warnings from the screen.
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
  const vtkIdType corners = this->Polygon->PointIds->GetNumberOfIds();
  if (size < 3)
  {
    return;
  }
  if (corners < 3)
  {
    // Nothing but repetitions: one collapsed triangle, so that the cell is counted as such.
    this->AddTriangle(cell, points[0], points[0], points[0]);
  }
  else if (corners == 3 || !this->CutEars())
  {
    for (vtkIdType i = 1; i + 1 < corners; ++i)
    {
      this->AddTriangle(cell, this->Corners[0], this->Corners[i], this->Corners[i + 1]);
    }
  }
  else
  {
    for (vtkIdType i = 0; i + 2 < this->Ears->GetNumberOfIds(); i += 3)
    {
      this->AddTriangle(cell, this->Corners[this->Ears->GetId(i)],
        this->Corners[this->Ears->GetId(i + 1)], this->Corners[this->Ears->GetId(i + 2)]);
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
  const vtkIdType corners = static_cast<vtkIdType>(this->Corners.size());
  this->Polygon->PointIds->SetNumberOfIds(corners);
  for (vtkIdType i = 0; i < corners; ++i)
  {
    this->Polygon->PointIds->SetId(i, i);
  }
}

bool Triangulator::CutEars()
{
  const vtkIdType corners = static_cast<vtkIdType>(this->Corners.size());
  this->Polygon->Points->SetDataTypeToDouble();
  this->Polygon->Points->SetNumberOfPoints(corners);
  for (vtkIdType i = 0; i < corners; ++i)
  {
    double point[3];
    this->Points->GetPoint(this->Corners[i], point);
    if (!std::isfinite(point[0]) || !std::isfinite(point[1]) || !std::isfinite(point[2]))
    {
      return false;
    }
    this->Polygon->Points->SetPoint(i, point);
  }
  // The one signature that all versions of VTK share; vtkPolygon hides it in some.
  vtkCell* polygon = this->Polygon;
  return polygon->Triangulate(0, this->Ears, this->EarPoints) != 0 &&
    this->Ears->GetNumberOfIds() == 3 * (corners - 2);
}
}
