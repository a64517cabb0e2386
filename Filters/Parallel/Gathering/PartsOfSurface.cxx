// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Gathering/PartsOfSurface.h"

#include "Gathering/Scattering.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace DirectionFields::Parallel
{
namespace
{
constexpr int TagOfParts = 4713;

/// The process that has an item of the surface, and the item's number there.
struct Owner
{
  int Process = 0;
  vtkIdType Number = 0;
};

/// For each of a surface's points or cells the first process with it among its own.
std::vector<Owner> OwnersOf(const std::vector<vtkIdType>& list, const std::vector<vtkIdType>& first,
  const std::vector<vtkIdType>& own, vtkIdType count)
{
  std::vector<Owner> owners(static_cast<std::size_t>(count));
  for (std::size_t p = own.size(); p-- > 0;)
  {
    for (vtkIdType k = 0; k < own[p]; ++k)
    {
      owners[list[first[p] + k]] = { static_cast<int>(p), k };
    }
  }
  return owners;
}

/// Copies cells with their points out of a dataset, for one process after the other.
class PartCopier
{
public:
  explicit PartCopier(vtkPolyData* whole)
    : Whole(whole)
    , NewPoint(static_cast<std::size_t>(whole->GetNumberOfPoints()), -1)
  {
  }

  /// @param cells ascending
  void Copy(const std::vector<vtkIdType>& cells, vtkPolyData* part)
  {
    const std::array<vtkCellArray*, 4> kinds = { this->Whole->GetVerts(), this->Whole->GetLines(),
      this->Whole->GetPolys(), this->Whole->GetStrips() };
    std::array<vtkNew<vtkCellArray>, 4> copies;
    part->GetCellData()->CopyAllOn();
    part->GetCellData()->CopyAllocate(this->Whole->GetCellData());
    vtkNew<vtkIdList> corners;
    std::vector<vtkIdType> points;
    std::size_t kind = 0;
    vtkIdType firstCell = 0;
    vtkIdType newCell = 0;
    for (const vtkIdType cell : cells)
    {
      while (cell - firstCell >= kinds[kind]->GetNumberOfCells())
      {
        firstCell += kinds[kind++]->GetNumberOfCells();
      }
      kinds[kind]->GetCellAtId(cell - firstCell, corners);
      for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k)
      {
        vtkIdType& number = this->NewPoint[corners->GetId(k)];
        if (number < 0)
        {
          number = static_cast<vtkIdType>(points.size());
          points.push_back(corners->GetId(k));
        }
        corners->SetId(k, number);
      }
      copies[kind]->InsertNextCell(corners);
      part->GetCellData()->CopyData(this->Whole->GetCellData(), cell, newCell++);
    }
    part->SetVerts(copies[0]);
    part->SetLines(copies[1]);
    part->SetPolys(copies[2]);
    part->SetStrips(copies[3]);
    this->CopyPoints(points, part);
  }

private:
  void CopyPoints(const std::vector<vtkIdType>& points, vtkPolyData* part)
  {
    vtkNew<vtkPoints> places;
    places->SetDataType(
      this->Whole->GetPoints() ? this->Whole->GetPoints()->GetDataType() : VTK_FLOAT);
    part->GetPointData()->CopyAllOn();
    part->GetPointData()->CopyAllocate(this->Whole->GetPointData());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      places->InsertNextPoint(this->Whole->GetPoint(points[i]));
      part->GetPointData()->CopyData(
        this->Whole->GetPointData(), points[i], static_cast<vtkIdType>(i));
      this->NewPoint[points[i]] = -1;
    }
    part->SetPoints(places);
  }

  vtkPolyData* Whole;
  std::vector<vtkIdType> NewPoint;
};

/// The ids that the cells of a dataset belong to.
vtkIdTypeArray* IdsOf(PartsBelongTo belong, vtkPolyData* whole)
{
  return vtkIdTypeArray::SafeDownCast(belong == PartsBelongTo::Cells
      ? static_cast<vtkDataSetAttributes*>(whole->GetPointData())->GetAbstractArray("CellId")
      : static_cast<vtkDataSetAttributes*>(whole->GetCellData())->GetAbstractArray("PointId"));
}

/// Cuts a dataset into the parts of the processes, whose ids become numbers among the process's own
/// cells or points.
std::vector<vtkSmartPointer<vtkPolyData>> Cut(
  const GatheredSurface& gathered, PartsBelongTo belong, vtkPolyData* whole)
{
  const bool areCells = belong == PartsBelongTo::Cells;
  const std::vector<Owner> owners = areCells
    ? OwnersOf(gathered.CellsOf, gathered.FirstCellOf, gathered.OwnCellsOf,
        gathered.Surface->GetNumberOfCells())
    : OwnersOf(gathered.PointsOf, gathered.FirstPointOf, gathered.OwnPointsOf,
        gathered.Surface->GetNumberOfPoints());
  vtkNew<vtkPolyData> numbered;
  numbered->ShallowCopy(whole);
  std::vector<std::vector<vtkIdType>> cellsOf(gathered.OwnCellsOf.size());
  if (vtkIdTypeArray* const ids = IdsOf(belong, whole))
  {
    vtkNew<vtkIdTypeArray> numbers;
    numbers->DeepCopy(ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfValues(); ++i)
    {
      const Owner owner = owners[ids->GetValue(i)];
      numbers->SetValue(i, owner.Number);
      cellsOf[owner.Process].push_back(i);
    }
    vtkDataSetAttributes* const data = areCells
      ? static_cast<vtkDataSetAttributes*>(numbered->GetPointData())
      : static_cast<vtkDataSetAttributes*>(numbered->GetCellData());
    data->AddArray(numbers);
  }
  PartCopier copier(numbered);
  std::vector<vtkSmartPointer<vtkPolyData>> parts;
  for (const std::vector<vtkIdType>& cells : cellsOf)
  {
    parts.push_back(vtkSmartPointer<vtkPolyData>::New());
    copier.Copy(cells, parts.back());
  }
  return parts;
}

/// The numbers among own points or cells as ids of the piece.
void UsePieceIds(const SurfacePiece& piece, PartsBelongTo belong, vtkPolyData* part)
{
  std::vector<vtkIdType> idOf = piece.Own.Points;
  if (belong == PartsBelongTo::Cells)
  {
    idOf = piece.Polys.Cells;
    idOf.insert(idOf.end(), piece.Strips.Cells.begin(), piece.Strips.Cells.end());
  }
  vtkIdTypeArray* const ids = IdsOf(belong, part);
  for (vtkIdType i = 0; ids && i < ids->GetNumberOfValues(); ++i)
  {
    ids->SetValue(i, idOf[ids->GetValue(i)]);
  }
}
}

void ScatterParts(Processes& processes, const GatheredSurface& gathered, PartsBelongTo belong,
  vtkPolyData* whole, vtkPolyData* own)
{
  const int from = gathered.Process;
  const bool isThere = processes.Own() == from;
  std::vector<vtkSmartPointer<vtkPolyData>> parts;
  processes.Together(
    [&]
    {
      if (isThere)
      {
        parts = Cut(gathered, belong, whole);
      }
    });
  vtkMultiProcessController* const controller = processes.GetController();
  for (int p = 0; isThere && p < processes.Count(); ++p)
  {
    if (p != from)
    {
      controller->Send(parts[p], p, TagOfParts);
    }
  }
  if (isThere)
  {
    own->ShallowCopy(parts[from]);
  }
  else
  {
    controller->Receive(own, from, TagOfParts);
  }
  AddMissingArrays(processes, from, whole, own);
  BroadcastFieldData(
    processes, from, isThere ? whole->GetFieldData() : nullptr, own->GetFieldData());
  processes.Together([&] { UsePieceIds(gathered.Piece, belong, own); });
}
}
