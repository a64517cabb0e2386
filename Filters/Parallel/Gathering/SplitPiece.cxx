// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Gathering/SplitPiece.h"

#include "ArrayKinds.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cstddef>
#include <map>
#include <utility>

namespace DirectionFields::Parallel
{
namespace
{
/// The corners of the own cells of each process, as numbers of the split surface's points.
struct SplitCorners
{
  std::vector<vtkIdType> Corners;
  std::vector<vtkIdType> First;
};

SplitCorners CornersOf(const GatheredSurface& gathered, vtkPolyData* whole)
{
  SplitCorners all;
  all.First.assign(1, 0);
  vtkNew<vtkIdList> corners;
  const vtkIdType polys = whole->GetNumberOfPolys();
  for (std::size_t p = 0; p < gathered.OwnCellsOf.size(); ++p)
  {
    for (vtkIdType k = 0; k < gathered.OwnCellsOf[p]; ++k)
    {
      const vtkIdType cell = gathered.CellsOf[gathered.FirstCellOf[p] + k];
      vtkCellArray* const cells = cell < polys ? whole->GetPolys() : whole->GetStrips();
      cells->GetCellAtId(cell < polys ? cell : cell - polys, corners);
      all.Corners.insert(all.Corners.end(), corners->begin(), corners->end());
    }
    all.First.push_back(static_cast<vtkIdType>(all.Corners.size()));
  }
  return all;
}

/// Gives the cells of a piece their corners of the split surface.
class Splitter
{
  const SurfacePiece& Piece;

public:
  Splitter(const SurfacePiece& piece, vtkIdType points)
    : Piece(piece)
    , Numbers(static_cast<std::size_t>(points), -1)
    , Originals(static_cast<std::size_t>(points))
  {
    for (std::size_t i = 0; i < this->Originals.size(); ++i)
    {
      this->Originals[i] = static_cast<vtkIdType>(i);
    }
  }

  /// The point of the piece that stands for a point of the split surface: the first one that an old
  /// point is split into takes its place.
  vtkIdType PointFor(vtkIdType old, vtkIdType number)
  {
    if (this->Numbers[old] < 0 || this->Numbers[old] == number)
    {
      this->Numbers[old] = number;
      return old;
    }
    const auto [entry, isNew] = this->Added.try_emplace(
      std::make_pair(old, number), static_cast<vtkIdType>(this->Originals.size()));
    if (isNew)
    {
      this->Originals.push_back(old);
      this->Numbers.push_back(number);
    }
    return entry->second;
  }

  void SplitCells(const PieceCells& some, vtkIdType firstCell,
    const std::vector<vtkIdType>& corners, std::size_t& next, vtkCellArray* cells)
  {
    vtkNew<vtkIdList> ids;
    std::size_t at = 0;
    for (std::size_t i = 0; i < some.Cells.size(); ++i)
    {
      const vtkIdType size = some.Size(i);
      ids->SetNumberOfIds(size);
      for (vtkIdType k = 0; k < size; ++k)
      {
        const vtkIdType old = this->Piece.Own.Points[some.Corners[at++]];
        ids->SetId(k, this->PointFor(old, corners[next++]));
      }
      cells->ReplaceCellAtId(some.Cells[i] - firstCell, ids);
    }
  }

  /// For each point of the piece its number on the split surface, -1 where none is known.
  std::vector<vtkIdType> Numbers;
  /// The old point of each.
  std::vector<vtkIdType> Originals;

private:
  std::map<std::pair<vtkIdType, vtkIdType>, vtkIdType> Added;
};

/// Gives a piece the points of its originals, with their data.
void AppendPoints(const std::vector<vtkIdType>& originals, vtkPolyData* output)
{
  const auto count = static_cast<vtkIdType>(originals.size());
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(OriginalPointIdsName);
  ids->SetNumberOfValues(count);
  vtkNew<vtkPoints> points;
  vtkNew<vtkPointData> data;
  if (output->GetPoints())
  {
    points->SetDataType(output->GetPoints()->GetDataType());
  }
  points->SetNumberOfPoints(count);
  data->CopyAllOn();
  data->CopyAllocate(output->GetPointData(), count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    points->SetPoint(i, output->GetPoint(originals[i]));
    data->CopyData(output->GetPointData(), originals[i], i);
    ids->SetValue(i, originals[i]);
  }
  output->SetPoints(points);
  output->GetPointData()->ShallowCopy(data);
  output->GetPointData()->AddArray(ids);
}
}

bool IsSplit(vtkPolyData* whole)
{
  return whole->GetPointData()->HasArray(OriginalPointIdsName) != 0;
}

SplitPiece SplitAsGathered(
  Processes& processes, const GatheredSurface& gathered, vtkPolyData* whole, vtkPolyData* output)
{
  const int from = gathered.Process;
  const SurfacePiece& piece = gathered.Piece;
  SplitCorners all;
  processes.Together(
    [&]
    {
      if (whole)
      {
        all = CornersOf(gathered, whole);
      }
    });
  const auto count =
    static_cast<vtkIdType>(piece.Polys.Corners.size() + piece.Strips.Corners.size());
  const std::vector<vtkIdType> corners = processes.Scatter(all.Corners, all.First, count, from);
  const std::vector<vtkIdType> known = processes.Scatter(gathered.PointsOf, gathered.FirstPointOf,
    static_cast<vtkIdType>(piece.Own.Points.size() + piece.GhostPoints.Points.size()), from);

  SplitPiece split;
  std::vector<vtkIdType> numbers;
  processes.Together(
    [&]
    {
      Splitter splitter(piece, output->GetNumberOfPoints());
      const vtkIdType firstPoly = output->GetNumberOfVerts() + output->GetNumberOfLines();
      const vtkIdType firstStrip = firstPoly + output->GetNumberOfPolys();
      vtkNew<vtkCellArray> polys;
      vtkNew<vtkCellArray> strips;
      polys->DeepCopy(output->GetPolys());
      strips->DeepCopy(output->GetStrips());
      std::size_t next = 0;
      splitter.SplitCells(piece.Polys, firstPoly, corners, next, polys);
      splitter.SplitCells(piece.Strips, firstStrip, corners, next, strips);
      // Points that only copied cells have.
      for (std::size_t k = 0; k < piece.GhostPoints.Points.size(); ++k)
      {
        splitter.Numbers[piece.GhostPoints.Points[k]] = known[piece.Own.Points.size() + k];
      }
      output->SetPolys(polys);
      output->SetStrips(strips);
      output->DeleteLinks();
      AppendPoints(splitter.Originals, output);
      numbers = std::move(splitter.Numbers);
      split.Places.resize(numbers.size());
      for (std::size_t i = 0; i < numbers.size(); ++i)
      {
        split.Places[i] = static_cast<vtkIdType>(i);
      }
    });
  const std::vector<vtkIdType> lengths =
    processes.AllGather({ static_cast<vtkIdType>(numbers.size()) });
  split.FirstPointOf = Processes::FirstOf(lengths);
  processes.Together([&]
    { split.PointsOf.resize(whole ? static_cast<std::size_t>(split.FirstPointOf.back()) : 0); });
  processes.Gather(numbers, lengths, split.PointsOf, from);
  return split;
}
}
