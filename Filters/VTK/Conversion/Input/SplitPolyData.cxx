// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Conversion/Input/SplitPolyData.h"

#include "Conversion/Input/FieldArrays.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cstddef>

namespace DirectionFields
{
namespace
{
/// The points of the input, then the points that were split off, each with the data of its
/// original.
void SplitPoints(const std::vector<Index>& originalPoint, vtkPolyData* output)
{
  const auto points = static_cast<vtkIdType>(originalPoint.size());
  vtkNew<vtkPoints> splitPoints;
  splitPoints->SetDataType(output->GetPoints()->GetDataType());
  // VTK gives its sizes in KiB.
  RequireMemory(1024 *
    (output->GetPointData()->GetActualMemorySize() + output->GetPoints()->GetActualMemorySize()));
  splitPoints->SetNumberOfPoints(points);
  vtkNew<vtkPointData> splitData;
  // Nothing is to be left out, whatever the input's flags say.
  splitData->CopyAllOn();
  splitData->CopyAllocate(output->GetPointData(), points);
  auto originals = MakeArray<vtkIdTypeArray>(ArrayNames::OriginalPointIds, 1, originalPoint.size());
  for (vtkIdType i = 0; i < points; ++i)
  {
    const vtkIdType original = originalPoint[i];
    splitPoints->SetPoint(i, output->GetPoint(original));
    splitData->CopyData(output->GetPointData(), original, i);
    originals->SetValue(i, original);
  }
  output->SetPoints(splitPoints);
  output->GetPointData()->ShallowCopy(splitData);
  output->GetPointData()->AddArray(originals);
}

/// Gives a polygon or a strip the points of its triangles, the first that claims a corner of the
/// cell first.
/// @param first, last the cell's triangles are first ... last - 1
/// @param corners     of the cell; where a triangle's point stands, its point of the split surface
///                    takes the place
void SplitCorners(const TriangulatedPolyData& input, const Result& field, std::size_t first,
  std::size_t last, bool isStrip, vtkIdList* corners)
{
  std::vector<char> settled(static_cast<std::size_t>(corners->GetNumberOfIds()), 0);
  for (std::size_t t = first; t < last; ++t)
  {
    // Triangles that took no part have no points of their own.
    for (int c = 0; c < 3 && field.Component[t] != None; ++c)
    {
      // A strip may come back to a point on another sheet, but its triangles know their places.
      const std::size_t begin = isStrip ? t - first : 0;
      const std::size_t end = isStrip ? begin + 3 : settled.size();
      for (std::size_t k = begin; k < end; ++k)
      {
        const auto place = static_cast<vtkIdType>(k);
        if (!settled[k] && corners->GetId(place) == input.Mesh.Triangles[t][c])
        {
          settled[k] = 1;
          corners->SetId(place, field.SplitTriangles[t][c]);
        }
      }
    }
  }
}

void SplitCells(const TriangulatedPolyData& input, const Result& field, vtkPolyData* output)
{
  const vtkIdType firstPoly = output->GetNumberOfVerts() + output->GetNumberOfLines();
  const vtkIdType firstStrip = firstPoly + output->GetNumberOfPolys();
  vtkNew<vtkCellArray> polys;
  vtkNew<vtkCellArray> strips;
  polys->DeepCopy(output->GetPolys());
  strips->DeepCopy(output->GetStrips());
  vtkNew<vtkIdList> corners;
  const std::size_t triangles = field.SplitTriangles.size();
  std::size_t last = 0;
  for (std::size_t first = 0; first < triangles; first = last)
  {
    // The triangles of a cell stand in a row.
    const vtkIdType cell = input.Cell(first);
    while (last < triangles && input.Cell(last) == cell)
    {
      ++last;
    }
    const bool isStrip = cell >= firstStrip;
    vtkCellArray* cells = isStrip ? strips : polys;
    const vtkIdType local = cell - (isStrip ? firstStrip : firstPoly);
    cells->GetCellAtId(local, corners);
    SplitCorners(input, field, first, last, isStrip, corners);
    cells->ReplaceCellAtId(local, corners);
  }
  output->SetPolys(polys);
  output->SetStrips(strips);
  // Some versions of VTK have copied the input's links from points to cells, which do not know the
  // split-off points.
  output->DeleteLinks();
}

std::vector<vtkIdType> UnusedPoints(vtkPolyData* polyData)
{
  std::vector<char> used(static_cast<std::size_t>(polyData->GetNumberOfPoints()), 0);
  vtkNew<vtkIdList> corners;
  for (vtkCellArray* cells : { polyData->GetPolys(), polyData->GetStrips() })
  {
    for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
    {
      cells->GetCellAtId(cell, corners);
      for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k)
      {
        used[static_cast<std::size_t>(corners->GetId(k))] = 1;
      }
    }
  }
  std::vector<vtkIdType> unused;
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    if (!used[i])
    {
      unused.push_back(static_cast<vtkIdType>(i));
    }
  }
  return unused;
}
}

std::vector<vtkIdType> SplitPolyData(
  const TriangulatedPolyData& input, const Result& field, vtkPolyData* output)
{
  if (field.SplitTriangles.empty())
  {
    return {};
  }
  SplitPoints(field.OriginalPoint, output);
  SplitCells(input, field, output);
  return UnusedPoints(output);
}
}
