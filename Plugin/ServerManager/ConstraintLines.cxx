// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ConstraintLines.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCleanPolyData.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace
{
/// Of ConstraintKind, whether it is a line of the surface: boundary, sharp or of several triangles.
bool IsLine(double kind)
{
  return kind == 1.0 || kind == 2.0 || kind == 4.0;
}

/// An edge of a polygon, from the point of the smaller number.
struct Side
{
  std::pair<vtkIdType, vtkIdType> Ends;
  std::array<double, 3> Normal;
};

/// An edge, and the angle between the normals of its polygons in radians; pi where they are not two.
struct Bend
{
  std::pair<vtkIdType, vtkIdType> Ends;
  double Angle;
};

/// The sides of all polygons whose two ends are on lines.
std::vector<Side> SidesOnLines(vtkPolyData* field, vtkDataArray* kinds)
{
  std::vector<Side> sides;
  const auto cell = vtk::TakeSmartPointer(field->GetPolys()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    cell->GetCurrentCell(size, corners);
    for (vtkIdType k = 0; k < size; ++k)
    {
      const vtkIdType next = corners[(k + 1) % size];
      if (IsLine(kinds->GetTuple1(corners[k])) && IsLine(kinds->GetTuple1(next)))
      {
        Side side;
        side.Ends = std::minmax(corners[k], next);
        vtkPolygon::ComputeNormal(
          field->GetPoints(), static_cast<int>(size), corners, side.Normal.data());
        sides.push_back(side);
      }
    }
  }
  std::stable_sort(sides.begin(), sides.end(),
    [](const Side& left, const Side& right) { return left.Ends < right.Ends; });
  return sides;
}

std::vector<Bend> Bends(const std::vector<Side>& sides)
{
  std::vector<Bend> bends;
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end)
  {
    while (end < sides.size() && sides[end].Ends == sides[begin].Ends)
    {
      ++end;
    }
    bends.push_back({ sides[begin].Ends,
      end - begin == 2
        ? vtkMath::AngleBetweenVectors(sides[begin].Normal.data(), sides[begin + 1].Normal.data())
        : vtkMath::Pi() });
  }
  return bends;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ConstraintLines(vtkPolyData* field)
{
  auto lines = vtkSmartPointer<vtkPolyData>::New();
  vtkDataArray* const kinds = field->GetPointData()->GetArray("ConstraintKind");
  if (!kinds)
  {
    return lines;
  }
  const std::vector<Bend> bends = Bends(SidesOnLines(field, kinds));
  std::map<vtkIdType, double> sharpest;
  for (const Bend& bend : bends)
  {
    for (const vtkIdType end : { bend.Ends.first, bend.Ends.second })
    {
      sharpest[end] = std::max(sharpest[end], bend.Angle);
    }
  }
  vtkNew<vtkCellArray> cells;
  for (const Bend& bend : bends)
  {
    const auto [from, to] = bend.Ends;
    if (bend.Angle > 0.0 && 2.0 * bend.Angle >= std::min(sharpest[from], sharpest[to]))
    {
      cells->InsertNextCell({ from, to });
    }
  }
  vtkNew<vtkPolyData> all;
  all->SetPoints(field->GetPoints());
  all->SetLines(cells);
  // Only the points of the lines are sent to where they are drawn.
  vtkNew<vtkCleanPolyData> used;
  used->PointMergingOff();
  used->SetInputData(all);
  used->Update();
  lines->ShallowCopy(used->GetOutput());
  return lines;
}
