// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfacePiece.h"

#include <DirectionFields/Coordinates.h>

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
#include <stdexcept>
#include <string>

namespace DirectionFields::Parallel
{
namespace
{
/// Adds a cell to cells whose sizes may have been left out until now.
void AddCell(vtkIdType cell, vtkIdType size, const vtkIdType* corners, PieceCells& cells)
{
  if (size != 3 && cells.Sizes.empty())
  {
    cells.Sizes.assign(cells.Cells.size(), 3);
  }
  if (size != 3 || !cells.Sizes.empty())
  {
    cells.Sizes.push_back(size);
  }
  cells.Cells.push_back(cell);
  cells.Corners.insert(cells.Corners.end(), corners, corners + size);
}

/// Shares the cells of a kind out among the piece's own and the copies of other pieces' cells.
void ReadCells(vtkCellArray* cells, vtkIdType firstCell, vtkUnsignedCharArray* marks,
  PieceCells& own, PieceCells& ghosts)
{
  const vtkIdType count = cells->GetNumberOfCells();
  own.Cells.reserve(static_cast<std::size_t>(count));
  own.Corners.reserve(static_cast<std::size_t>(cells->GetNumberOfConnectivityIds()));
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const int mark = marks ? marks->GetValue(firstCell + i) : 0;
    if ((mark & vtkDataSetAttributes::HIDDENCELL) == 0)
    {
      cells->GetCellAtId(i, corners);
      AddCell(firstCell + i, corners->GetNumberOfIds(), corners->GetPointer(0),
        (mark & vtkDataSetAttributes::DUPLICATECELL) ? ghosts : own);
    }
  }
}

constexpr vtkIdType Unused = -1;

/// Refuses points that are nowhere, or too far away to be computed with.
void RequirePlaces(const PiecePoints& points, bool isSingle)
{
  CoordinateCheck check(isSingle);
  for (std::size_t k = 0; k < points.Points.size(); ++k)
  {
    const double* const place = points.Coordinates.data() + 3 * k;
    if (!check.MayBe(place))
    {
      check.Refuse(static_cast<std::size_t>(points.Points[k]), place);
    }
  }
  const std::string error = check.GetError();
  if (!error.empty())
  {
    throw std::invalid_argument(error);
  }
}

/// Numbers the points that cells use and that have no number yet, and reads them.
void ReadPoints(vtkPolyData* polyData, const std::vector<char>& isUsed,
  std::vector<vtkIdType>& numbers, vtkIdType firstNumber, PiecePoints& points)
{
  vtkDataArray* ids = polyData->GetPointData()->GetGlobalIds();
  for (std::size_t i = 0; i < isUsed.size(); ++i)
  {
    if (isUsed[i] && numbers[i] == Unused)
    {
      const auto point = static_cast<vtkIdType>(i);
      numbers[i] = firstNumber + static_cast<vtkIdType>(points.Points.size());
      points.Points.push_back(point);
      double place[3];
      polyData->GetPoint(point, place);
      points.Coordinates.insert(points.Coordinates.end(), place, place + 3);
      if (ids)
      {
        points.GlobalIds.push_back(static_cast<vtkIdType>(ids->GetTuple1(point)));
      }
    }
  }
}

/// Marks the points of cells.
void MarkPoints(const PieceCells& cells, std::vector<char>& isUsed)
{
  for (const vtkIdType corner : cells.Corners)
  {
    if (corner < 0 || corner >= static_cast<vtkIdType>(isUsed.size()))
    {
      throw std::out_of_range("A polygon or strip has point " + std::to_string(corner) +
        ", but there are only " + std::to_string(isUsed.size()) +
        " points. Mend the file or the filter that it comes from.");
    }
    isUsed[static_cast<std::size_t>(corner)] = 1;
  }
}

void Renumber(const std::vector<vtkIdType>& numbers, PieceCells& cells)
{
  for (vtkIdType& corner : cells.Corners)
  {
    corner = numbers[static_cast<std::size_t>(corner)];
  }
}

/// Calls body(a, b) for every side of every triangle of the cells; for polygons their own sides are
/// enough.
template <typename Body>
void ForEachSide(const SurfacePiece& piece, const Body& body)
{
  std::size_t first = 0;
  for (std::size_t i = 0; i < piece.Polys.Cells.size(); ++i)
  {
    const auto size = static_cast<std::size_t>(piece.Polys.Size(i));
    for (std::size_t k = 0; k < size; ++k)
    {
      body(piece.Polys.Corners[first + k], piece.Polys.Corners[first + (k + 1) % size]);
    }
    first += size;
  }
  first = 0;
  for (std::size_t i = 0; i < piece.Strips.Cells.size(); ++i)
  {
    const auto size = static_cast<std::size_t>(piece.Strips.Size(i));
    const vtkIdType* const corners = piece.Strips.Corners.data() + first;
    for (std::size_t k = 0; k + 2 < size; ++k)
    {
      body(corners[k], corners[k + 1]);
      body(corners[k + 1], corners[k + 2]);
      body(corners[k], corners[k + 2]);
    }
    first += size;
  }
}

/// Sets the edges that only one triangle has: sides are sorted by their lesser ends, the few of
/// each by the other one.
void FindBorder(SurfacePiece& piece)
{
  const std::size_t points = piece.Own.Points.size();
  std::vector<vtkIdType> first(points + 1, 0);
  ForEachSide(piece,
    [&](vtkIdType a, vtkIdType b) { ++first[static_cast<std::size_t>(std::min(a, b)) + 1]; });
  for (std::size_t i = 0; i < points; ++i)
  {
    first[i + 1] += first[i];
  }
  std::vector<vtkIdType> others(static_cast<std::size_t>(first[points]));
  std::vector<vtkIdType> next = first;
  ForEachSide(
    piece, [&](vtkIdType a, vtkIdType b) { others[next[std::min(a, b)]++] = std::max(a, b); });
  for (std::size_t i = 0; i < points; ++i)
  {
    const auto begin = others.begin() + first[i];
    const auto end = others.begin() + first[i + 1];
    std::sort(begin, end);
    for (auto other = begin; other != end;)
    {
      const auto following = std::upper_bound(other, end, *other);
      if (following - other == 1 && *other != static_cast<vtkIdType>(i))
      {
        piece.BorderEdges.push_back(static_cast<vtkIdType>(i));
        piece.BorderEdges.push_back(*other);
      }
      other = following;
    }
  }
}
}

SurfacePiece ReadPiece(vtkPolyData* polyData)
{
  SurfacePiece piece;
  const vtkIdType points = polyData->GetNumberOfPoints();
  auto* const marks = vtkUnsignedCharArray::SafeDownCast(
    polyData->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  const vtkIdType firstPoly = polyData->GetNumberOfVerts() + polyData->GetNumberOfLines();
  ReadCells(polyData->GetPolys(), firstPoly, marks, piece.Polys, piece.Ghosts);
  // Of copied strips only the points are looked for: a strip is no polygon.
  PieceCells ghostStrips;
  ReadCells(polyData->GetStrips(), firstPoly + polyData->GetNumberOfPolys(), marks, piece.Strips,
    ghostStrips);

  std::vector<char> isUsed(static_cast<std::size_t>(points), 0);
  std::vector<vtkIdType> numbers(static_cast<std::size_t>(points), Unused);
  MarkPoints(piece.Polys, isUsed);
  MarkPoints(piece.Strips, isUsed);
  ReadPoints(polyData, isUsed, numbers, 0, piece.Own);
  MarkPoints(piece.Ghosts, isUsed);
  MarkPoints(ghostStrips, isUsed);
  ReadPoints(
    polyData, isUsed, numbers, static_cast<vtkIdType>(piece.Own.Points.size()), piece.GhostPoints);
  const bool isSingle = points > 0 && polyData->GetPoints()->GetDataType() == VTK_FLOAT;
  RequirePlaces(piece.Own, isSingle);
  RequirePlaces(piece.GhostPoints, isSingle);
  for (PieceCells* const cells : { &piece.Polys, &piece.Strips, &piece.Ghosts })
  {
    Renumber(numbers, *cells);
  }
  FindBorder(piece);

  piece.HasPoints = !piece.Own.Points.empty();
  piece.HasDoublePoints = points > 0 && polyData->GetPoints()->GetDataType() == VTK_DOUBLE;
  piece.HasGlobalIds = polyData->GetPointData()->GetGlobalIds() != nullptr;
  return piece;
}
}
