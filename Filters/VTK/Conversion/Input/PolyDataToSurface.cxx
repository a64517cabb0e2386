// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Conversion/Input/PolyDataToSurface.h"

#include "Conversion/Input/DuplicatePolygons.h"
#include "Conversion/Input/FieldArrays.h"
#include "Conversion/Input/PolyDataCheck.h"
#include "Conversion/Input/Triangulator.h"

#include <DirectionFields/Coordinates.h>
#include <DirectionFields/MeshError.h>
#include <DirectionFields/Support/Threads.h>

#include "vtkAOSDataArrayTemplate.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace DirectionFields
{
namespace
{
constexpr vtkIdType MostPoints = std::numeric_limits<Index>::max();
/// Each triangle has three half-edges, which Index numbers as well.
constexpr vtkIdType MostTriangles = std::numeric_limits<Index>::max() / 3;
/// Points or triangles that a thread takes at a time.
constexpr Index PieceSize = 1 << 14;
/// Cells between two reports of the progress. They take some milliseconds even where ears must be
/// cut.
constexpr vtkIdType CellsPerReport = 16384;

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
/// @param firstCell the number of the first cell
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
  // The first id in each piece for which there is no point.
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

/// Whether points of one type have these very bytes, NaN included.
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

/// The array vtkGhostType of the points or the cells; null where there is none.
class GhostMarks
{
public:
  explicit GhostMarks(vtkDataSetAttributes* data)
    : Array(
        vtkUnsignedCharArray::SafeDownCast(data->GetArray(vtkDataSetAttributes::GhostArrayName())))
  {
  }

  bool AreThere() const { return this->Array != nullptr; }

  /// Whether any of some marks is on a point or a cell.
  bool Has(vtkIdType at, int marks) const
  {
    return this->Array && (this->Array->GetValue(at) & marks) != 0;
  }

private:
  vtkUnsignedCharArray* Array;
};

void RequireNumberable(const char* what, vtkIdType count, vtkIdType most)
{
  if (count > most)
  {
    throw std::length_error("The input has " + std::to_string(count) + " " + what +
      ", but at most " + std::to_string(most) +
      " can be processed. Decimate it or process it in parts.");
  }
}

/// The number of triangles if no cell is hidden and no corner of a polygon is repeated, else more.
vtkIdType LargestNumberOfTriangles(vtkPolyData* polyData)
{
  vtkIdType number = 0;
  for (vtkCellArray* cells : { polyData->GetPolys(), polyData->GetStrips() })
  {
    number += cells->GetNumberOfConnectivityIds() - 2 * cells->GetNumberOfCells();
  }
  return number;
}

/// Copies points of any type.
void CopyAnyPoints(vtkPoints* points, std::vector<Vector3>& copies)
{
  copies.resize(static_cast<std::size_t>(points->GetNumberOfPoints()));
  if (CopyPoints<float>(points->GetData(), copies) || CopyPoints<double>(points->GetData(), copies))
  {
    return;
  }
  for (std::size_t i = 0; i < copies.size(); ++i)
  {
    points->GetPoint(static_cast<vtkIdType>(i), copies[i].data());
  }
}

/// Copies the cells if they are nothing but triangles; else false.
bool CopyAllTriangles(vtkPolyData* polyData, TriangulatedPolyData& result)
{
  const vtkIdType firstCell = polyData->GetNumberOfVerts() + polyData->GetNumberOfLines();
  const vtkIdType points = polyData->GetNumberOfPoints();
  return AreCopied(polyData) &&
    (CopyTriangles<vtkTypeInt64>(polyData->GetPolys(), firstCell, points, result) ||
      CopyTriangles<vtkTypeInt32>(polyData->GetPolys(), firstCell, points, result));
}

/// Cuts all cells that are not hidden into triangles, in their order. Throws Stopped.
void CutCells(vtkPolyData* polyData, const GhostMarks& ghosts, TriangulatedPolyData& result,
  const Progress& progress)
{
  vtkCellArray* polys = polyData->GetPolys();
  vtkCellArray* strips = polyData->GetStrips();
  const vtkIdType numberOfPolys = polys->GetNumberOfCells();
  const vtkIdType numberOfCells = numberOfPolys + strips->GetNumberOfCells();
  const vtkIdType firstPoly = polyData->GetNumberOfVerts() + polyData->GetNumberOfLines();
  const DuplicatePolygons duplicates(polys,
    [&](vtkIdType i) { return ghosts.Has(firstPoly + i, vtkDataSetAttributes::HIDDENCELL); });
  Triangulator triangulator(polyData->GetPoints(), result);
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < numberOfCells; ++i)
  {
    if (i % CellsPerReport == 0)
    {
      progress.Report(static_cast<double>(i + 1) / static_cast<double>(numberOfCells));
    }
    const vtkIdType cell = firstPoly + i;
    if (ghosts.Has(cell, vtkDataSetAttributes::HIDDENCELL))
    {
      continue;
    }
    const DuplicatePolygons::Earlier earlier = duplicates.Of(i);
    if (earlier.Polygon >= 0)
    {
      triangulator.AddCopy(cell, firstPoly + earlier.Polygon, earlier.IsReversed);
    }
    else if (i < numberOfPolys)
    {
      polys->GetCellAtId(i, ids);
      triangulator.AddPolygon(cell, ids->GetNumberOfIds(), ids->GetPointer(0));
    }
    else
    {
      strips->GetCellAtId(i - numberOfPolys, ids);
      triangulator.AddStrip(cell, ids->GetNumberOfIds(), ids->GetPointer(0));
    }
  }
}

/// Makes the triangles of cells that another piece owns ghosts.
void MarkGhosts(const GhostMarks& ghosts, TriangulatedPolyData& result)
{
  for (std::size_t t = 0; ghosts.AreThere() && t < result.CellOfTriangle.size(); ++t)
  {
    if (ghosts.Has(result.CellOfTriangle[t], vtkDataSetAttributes::DUPLICATECELL))
    {
      result.Mesh.Ghost.resize(result.CellOfTriangle.size(), 0);
      result.Mesh.Ghost[t] = 1;
    }
  }
}
}

bool ArePointsOf(vtkPolyData* polyData, const TriangulatedPolyData& surface)
{
  const std::vector<Vector3>& points = surface.Mesh.Points;
  if (points.empty() || polyData->GetNumberOfPoints() != static_cast<vtkIdType>(points.size()))
  {
    return false;
  }
  vtkDataArray* data = polyData->GetPoints()->GetData();
  return SamePoints<float>(data, points) || SamePoints<double>(data, points);
}

bool IsSurfaceOf(vtkPolyData* polyData, const TriangulatedPolyData& surface)
{
  const std::vector<Triangle>& triangles = surface.Mesh.Triangles;
  vtkCellArray* polys = polyData->GetPolys();
  if (polys->GetNumberOfCells() != static_cast<vtkIdType>(triangles.size()) ||
    !surface.Mesh.Ghost.empty() || !surface.CellOfTriangle.empty() ||
    surface.FirstCell != polyData->GetNumberOfVerts() + polyData->GetNumberOfLines() ||
    !AreCopied(polyData))
  {
    return false;
  }
  return ArePointsOf(polyData, surface) &&
    (SameTriangles<vtkTypeInt64>(polys, triangles) ||
      SameTriangles<vtkTypeInt32>(polys, triangles));
}

namespace
{
/// Throws MeshError where a triangle has a corner that is nowhere, or too far away to compute with.
/// @param isSingle whether points are handed on in single precision
void RequirePlaces(const Surface& surface, bool isSingle)
{
  CoordinateCheck check(isSingle);
  std::atomic<bool> areFine{ true };
  ForEachPieceOfTuples(surface.Points.size(),
    [&](std::size_t begin, std::size_t end)
    {
      bool areHere = true;
      for (std::size_t i = begin; i < end; ++i)
      {
        areHere = areHere && check.MayBe(surface.Points[i].data());
      }
      if (!areHere)
      {
        areFine.store(false, std::memory_order_relaxed);
      }
    });
  if (areFine)
  {
    return;
  }
  // Points of no triangle may have any coordinates.
  std::vector<char> isUsed(surface.Points.size(), 0);
  for (const Triangle& triangle : surface.Triangles)
  {
    for (const Index point : triangle)
    {
      // Ids of no point are refused with the mesh.
      if (point >= 0 && point < static_cast<Index>(isUsed.size()))
      {
        isUsed[point] = 1;
      }
    }
  }
  for (std::size_t i = 0; i < isUsed.size(); ++i)
  {
    const double* const place = surface.Points[i].data();
    if (isUsed[i] != 0 && !check.MayBe(place))
    {
      check.Refuse(i, place);
    }
  }
  const std::string error = check.GetError();
  if (!error.empty())
  {
    throw MeshError(MeshError::Kind::NonFinitePoint, static_cast<Index>(check.GetFirst()), error);
  }
}
}

TriangulatedPolyData PolyDataToSurface(vtkPolyData* polyData, const Progress& progress)
{
  TriangulatedPolyData result;
  const vtkIdType numberOfTriangles = LargestNumberOfTriangles(polyData);
  RequireNumberable("points", polyData->GetNumberOfPoints(), MostPoints);
  RequireNumberable("triangles", numberOfTriangles, MostTriangles);
  RequireNumberable("cells", polyData->GetNumberOfCells(), MostPoints);
  const vtkIdType points = polyData->GetNumberOfPoints();
  const bool isSingle = points > 0 && polyData->GetPoints()->GetDataType() == VTK_FLOAT;
  if (points > 0)
  {
    CopyAnyPoints(polyData->GetPoints(), result.Mesh.Points);
    if (CopyAllTriangles(polyData, result))
    {
      RequirePlaces(result.Mesh, isSingle);
      return result;
    }
  }
  const vtkIdType firstPoly = polyData->GetNumberOfVerts() + polyData->GetNumberOfLines();
  CheckCorners(polyData->GetPolys(), firstPoly, points);
  CheckCorners(polyData->GetStrips(), firstPoly + polyData->GetNumberOfPolys(), points);
  if (points == 0)
  {
    return result;
  }
  result.Mesh.Triangles.reserve(
    static_cast<std::size_t>(std::max<vtkIdType>(numberOfTriangles, 0)));
  result.CellOfTriangle.reserve(result.Mesh.Triangles.capacity());
  const GhostMarks ghosts(polyData->GetCellData());
  CutCells(polyData, ghosts, result, progress);
  MarkGhosts(ghosts, result);
  RequirePlaces(result.Mesh, isSingle);
  return result;
}

std::vector<char> GhostPoints(vtkPolyData* polyData)
{
  const GhostMarks ghosts(polyData->GetPointData());
  std::vector<char> excluded;
  if (ghosts.AreThere())
  {
    excluded.resize(static_cast<std::size_t>(polyData->GetNumberOfPoints()), 0);
    for (std::size_t i = 0; i < excluded.size(); ++i)
    {
      excluded[i] = ghosts.Has(static_cast<vtkIdType>(i),
        vtkDataSetAttributes::DUPLICATEPOINT | vtkDataSetAttributes::HIDDENPOINT);
    }
  }
  return excluded;
}
}
