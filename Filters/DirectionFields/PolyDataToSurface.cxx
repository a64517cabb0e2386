// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "PolyDataToSurface.h"

#include "Support/Threads.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>

namespace DirectionFields
{
namespace
{
constexpr vtkIdType MostPoints = std::numeric_limits<Index>::max();
/// Points or triangles that a thread takes at a time.
constexpr Index PieceSize = 1 << 14;
/// Three half-edges each.
constexpr vtkIdType MostTriangles = std::numeric_limits<Index>::max() / 3;
/// Cells between two reports of the progress, some milliseconds even where ears must be cut.
constexpr vtkIdType CellsPerReport = 16384;

[[noreturn]] void RefuseId(vtkIdType cell, vtkIdType id, vtkIdType points)
{
  throw std::out_of_range("Cell " + std::to_string(cell) + " uses point " + std::to_string(id) +
    ", but the input has " + std::to_string(points) +
    " points, numbered from 0. Correct the connectivity of the mesh.");
}

/// Appends the triangles of one cell after the other.
class Triangulator
{
public:
  Triangulator(vtkPoints* points, TriangulatedPolyData& result)
    : Points(points)
    , NumberOfPoints(points ? points->GetNumberOfPoints() : 0)
    , Result(result)
  {
    // vtkPolygon warns about each polygon that it cannot cut, but a fan is an answer to those.
    // An observer keeps the warnings from the screen.
    vtkNew<vtkCallbackCommand> silence;
    this->Polygon->AddObserver("WarningEvent", silence);
    this->Polygon->AddObserver("ErrorEvent", silence);
  }

  void AddStrip(vtkIdType cell, vtkIdType size, const vtkIdType* points)
  {
    for (vtkIdType i = 0; i + 2 < size; ++i)
    {
      // Every other triangle of a strip runs backwards.
      const vtkIdType odd = i % 2;
      this->AddTriangle(cell, points[i], points[i + 1 + odd], points[i + 2 - odd]);
    }
  }

  void AddPolygon(vtkIdType cell, vtkIdType size, const vtkIdType* points)
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

private:
  void AddTriangle(vtkIdType cell, vtkIdType i, vtkIdType j, vtkIdType k)
  {
    for (const vtkIdType id : { i, j, k })
    {
      if (id < 0 || id >= this->NumberOfPoints)
      {
        RefuseId(cell, id, this->NumberOfPoints);
      }
    }
    this->Result.Mesh.Triangles.push_back(
      { static_cast<Index>(i), static_cast<Index>(j), static_cast<Index>(k) });
    this->Result.CellOfTriangle.push_back(cell);
  }

  /// The corners without consecutive repetitions, which would disturb the cutting of ears.
  void SetCorners(vtkIdType size, const vtkIdType* points)
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

  /// False if the polygon cannot be cut; else Ears holds the triangles as positions in Corners.
  bool CutEars()
  {
    const vtkIdType corners = static_cast<vtkIdType>(this->Corners.size());
    this->Polygon->Points->SetDataTypeToDouble();
    this->Polygon->Points->SetNumberOfPoints(corners);
    for (vtkIdType i = 0; i < corners; ++i)
    {
      const vtkIdType id = this->Corners[i];
      if (id < 0 || id >= this->Points->GetNumberOfPoints())
      {
        return false;
      }
      double point[3];
      this->Points->GetPoint(id, point);
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

  vtkPoints* Points;
  vtkIdType NumberOfPoints;
  TriangulatedPolyData& Result;
  std::vector<vtkIdType> Corners;
  vtkNew<vtkPolygon> Polygon;
  vtkNew<vtkIdList> Ears;
  vtkNew<vtkPoints> EarPoints;
};

/// Copies points of one type; false if they are of another.
template <typename Value>
bool CopyPoints(vtkDataArray* points, std::vector<Vector3>& copies)
{
  auto* const array = vtkAOSDataArrayTemplate<Value>::FastDownCast(points);
  if (!array)
  {
    return false;
  }
  const Value* const values = array->GetPointer(0);
  ParallelFor(static_cast<Index>(copies.size()), PieceSize,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        const Value* const point = values + 3 * static_cast<vtkIdType>(i);
        copies[i] = Vector3(point[0], point[1], point[2]);
      }
    });
  return true;
}

/// Copies cells that are all triangles, stored with ids of one type; false if the type is another.
/// @param firstCell number of the first one
template <typename Id>
bool CopyTriangles(
  vtkCellArray* cells, vtkIdType firstCell, vtkIdType points, TriangulatedPolyData& result)
{
  auto* const array = vtkAOSDataArrayTemplate<Id>::FastDownCast(cells->GetConnectivityArray());
  if (!array)
  {
    return false;
  }
  const auto triangles = static_cast<Index>(cells->GetNumberOfCells());
  const Id* const ids = array->GetPointer(0);
  result.Mesh.Triangles.resize(triangles);
  result.FirstCell = firstCell;
  // Of each piece the first id that there is no point of.
  std::vector<vtkIdType> invalid(NumberOfPieces(triangles, PieceSize), -1);
  ParallelFor(triangles, PieceSize,
    [&](Index begin, Index end)
    {
      vtkIdType& found = invalid[begin / PieceSize];
      for (Index t = begin; t < end; ++t)
      {
        for (int c = 0; c < 3; ++c)
        {
          const vtkIdType at = 3 * static_cast<vtkIdType>(t) + c;
          const vtkIdType id = ids[at];
          found = found < 0 && (id < 0 || id >= points) ? at : found;
          result.Mesh.Triangles[t][c] = static_cast<Index>(id);
        }
      }
    });
  for (const vtkIdType at : invalid)
  {
    if (at >= 0)
    {
      RefuseId(firstCell + at / 3, ids[at], points);
    }
  }
  return true;
}

/// Whether isSame(i) for i = 0 ... count - 1.
template <typename Body>
bool AllAreSame(Index count, const Body& isSame)
{
  return ParallelSum<int>(count, PieceSize, 0,
           [&](Index begin, Index end)
           {
             Index i = begin;
             while (i < end && isSame(i))
             {
               ++i;
             }
             return i < end ? 1 : 0;
           }) == 0;
}

/// Whether points of one type have these very bytes, those of NaN, too.
template <typename Value>
bool SamePoints(vtkDataArray* points, const std::vector<Vector3>& copies)
{
  auto* const array = vtkAOSDataArrayTemplate<Value>::FastDownCast(points);
  if (!array)
  {
    return false;
  }
  const Value* const values = array->GetPointer(0);
  return AllAreSame(static_cast<Index>(copies.size()),
    [values, copy = copies.data()](Index i)
    {
      const Value* const point = values + 3 * static_cast<vtkIdType>(i);
      const Vector3 now(point[0], point[1], point[2]);
      return std::memcmp(now.data(), copy[i].data(), sizeof(now)) == 0;
    });
}

template <typename Id>
bool SameTriangles(vtkCellArray* cells, const std::vector<Triangle>& copies)
{
  auto* const array = vtkAOSDataArrayTemplate<Id>::FastDownCast(cells->GetConnectivityArray());
  if (!array)
  {
    return false;
  }
  const Id* const ids = array->GetPointer(0);
  return AllAreSame(static_cast<Index>(copies.size()),
    [ids, copy = copies.data()](Index t)
    {
      const Id* const corner = ids + 3 * static_cast<vtkIdType>(t);
      return corner[0] == copy[t][0] && corner[1] == copy[t][1] && corner[2] == copy[t][2];
    });
}

/// Whether the cells are triangles of which CopyTriangles takes all.
bool AreCopied(vtkPolyData* polyData)
{
  return !polyData->GetCellData()->HasArray(vtkDataSetAttributes::GhostArrayName()) &&
    polyData->GetStrips()->GetNumberOfCells() == 0 && polyData->GetPolys()->IsHomogeneous() == 3;
}

void RequireNumberable(const char* what, vtkIdType count, vtkIdType most)
{
  if (count > most)
  {
    throw std::length_error("The input has " + std::to_string(count) + " " + what +
      ", but at most " + std::to_string(most) +
      " can be processed. Decimate it or process it in parts.");
  }
}
}

bool IsSurfaceOf(vtkPolyData* polyData, const TriangulatedPolyData& surface)
{
  const std::vector<Vector3>& points = surface.Mesh.Points;
  const std::vector<Triangle>& triangles = surface.Mesh.Triangles;
  vtkCellArray* polys = polyData->GetPolys();
  if (points.empty() || polyData->GetNumberOfPoints() != static_cast<vtkIdType>(points.size()) ||
    polys->GetNumberOfCells() != static_cast<vtkIdType>(triangles.size()) ||
    !surface.Mesh.Ghost.empty() || !surface.CellOfTriangle.empty() ||
    surface.FirstCell != polyData->GetNumberOfVerts() + polyData->GetNumberOfLines() ||
    !AreCopied(polyData))
  {
    return false;
  }
  vtkDataArray* data = polyData->GetPoints()->GetData();
  return (SamePoints<float>(data, points) || SamePoints<double>(data, points)) &&
    (SameTriangles<vtkTypeInt64>(polys, triangles) || SameTriangles<vtkTypeInt32>(polys, triangles));
}

TriangulatedPolyData PolyDataToSurface(vtkPolyData* polyData, const ProgressFunction& progress)
{
  TriangulatedPolyData result;
  vtkPoints* points = polyData->GetPoints();
  const vtkIdType numberOfPoints = polyData->GetNumberOfPoints();
  vtkCellArray* polys = polyData->GetPolys();
  vtkCellArray* strips = polyData->GetStrips();
  vtkIdType numberOfTriangles = 0;
  for (vtkCellArray* cells : { polys, strips })
  {
    numberOfTriangles += cells->GetNumberOfConnectivityIds() - 2 * cells->GetNumberOfCells();
  }
  RequireNumberable("points", numberOfPoints, MostPoints);
  RequireNumberable("triangles", numberOfTriangles, MostTriangles);

  result.Mesh.Points.resize(static_cast<size_t>(numberOfPoints));
  if (numberOfPoints == 0)
  {
    return result;
  }
  if (!CopyPoints<float>(points->GetData(), result.Mesh.Points) &&
    !CopyPoints<double>(points->GetData(), result.Mesh.Points))
  {
    for (vtkIdType i = 0; i < numberOfPoints; ++i)
    {
      points->GetPoint(i, result.Mesh.Points[i].data());
    }
  }
  auto ghosts = vtkUnsignedCharArray::SafeDownCast(
    polyData->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  vtkIdType cell = polyData->GetNumberOfVerts() + polyData->GetNumberOfLines();
  if (AreCopied(polyData) &&
    (CopyTriangles<vtkTypeInt64>(polys, cell, numberOfPoints, result) ||
      CopyTriangles<vtkTypeInt32>(polys, cell, numberOfPoints, result)))
  {
    return result;
  }

  result.Mesh.Triangles.reserve(static_cast<size_t>(std::max<vtkIdType>(numberOfTriangles, 0)));
  result.CellOfTriangle.reserve(result.Mesh.Triangles.capacity());

  const auto isMarked = [ghosts](vtkIdType cell, unsigned char as)
  { return ghosts && cell < ghosts->GetNumberOfValues() && (ghosts->GetValue(cell) & as) != 0; };
  const auto isHidden = [&isMarked](vtkIdType cell)
  { return isMarked(cell, vtkDataSetAttributes::HIDDENCELL); };

  const vtkIdType numberOfCells = polys->GetNumberOfCells() + strips->GetNumberOfCells();
  vtkIdType done = 0;
  const auto goOn = [&]
  {
    result.Aborted = done++ % CellsPerReport == 0 && progress &&
      !progress(static_cast<double>(done) / static_cast<double>(numberOfCells));
    return !result.Aborted;
  };

  Triangulator triangulator(points, result);
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < polys->GetNumberOfCells() && goOn(); ++i, ++cell)
  {
    if (!isHidden(cell))
    {
      polys->GetCellAtId(i, ids);
      triangulator.AddPolygon(cell, ids->GetNumberOfIds(), ids->GetPointer(0));
    }
  }
  for (vtkIdType i = 0; !result.Aborted && i < strips->GetNumberOfCells() && goOn(); ++i, ++cell)
  {
    if (!isHidden(cell))
    {
      strips->GetCellAtId(i, ids);
      triangulator.AddStrip(cell, ids->GetNumberOfIds(), ids->GetPointer(0));
    }
  }
  for (size_t t = 0; ghosts && t < result.CellOfTriangle.size(); ++t)
  {
    if (isMarked(result.CellOfTriangle[t], vtkDataSetAttributes::DUPLICATECELL))
    {
      result.Mesh.Ghost.resize(result.CellOfTriangle.size(), 0);
      result.Mesh.Ghost[t] = 1;
    }
  }
  return result;
}
}
