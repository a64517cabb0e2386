// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Conversion/Regions/CurveLines.h"

#include "Conversion/Input/PolyDataCheck.h"

#include "vtkAbstractArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

namespace DirectionFields
{
namespace
{
/// A point of the second input. Throws std::invalid_argument.
Vector3 PlaceOf(vtkPolyData* polyData, vtkIdType id, const char* cell)
{
  Vector3 place;
  polyData->GetPoints()->GetPoint(id, place.data());
  if (!place.allFinite())
  {
    throw std::invalid_argument("Point " + std::to_string(id) +
      " of the second input, the curves, has a coordinate that is NaN or infinite. Remove it " +
      cell + ".");
  }
  return place;
}

/// Appends the lines of polydata.
void AddLines(vtkPolyData* polyData, KeptLines& kept)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < polyData->GetNumberOfLines(); ++i)
  {
    polyData->GetLines()->GetCellAtId(i, ids);
    std::vector<Vector3> curve;
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      curve.push_back(PlaceOf(polyData, ids->GetId(k), "with its line"));
    }
    kept.Curves.push_back(std::move(curve));
    kept.OfCurves.push_back({ polyData, polyData->GetNumberOfVerts() + i });
  }
}

/// Appends the points of the vertices, or all of data without cells.
void AddPoints(vtkPolyData* polyData, KeptLines& kept)
{
  std::set<vtkIdType> taken;
  const auto add = [&](vtkIdType id, const GivenCell& cell)
  {
    if (taken.insert(id).second)
    {
      kept.Points.push_back(PlaceOf(polyData, id, "with its vertex"));
      kept.OfPoints.push_back(cell);
    }
  };
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < polyData->GetNumberOfVerts(); ++i)
  {
    polyData->GetVerts()->GetCellAtId(i, ids);
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      add(ids->GetId(k), { polyData, i });
    }
  }
  for (vtkIdType p = 0; polyData->GetNumberOfCells() == 0 && p < polyData->GetNumberOfPoints(); ++p)
  {
    add(p, { nullptr, 0 });
  }
}

void Add(vtkPolyData* polyData, bool hasPoints, KeptLines& kept)
{
  CheckPolyData(polyData);
  AddLines(polyData, kept);
  if (hasPoints)
  {
    AddPoints(polyData, kept);
  }
}

/// The same array of other data, or null.
vtkAbstractArray* Matching(vtkAbstractArray* array, vtkPolyData* other)
{
  vtkAbstractArray* const own = other->GetCellData()->GetAbstractArray(array->GetName());
  const bool isSame = own && own->GetDataType() == array->GetDataType() &&
    own->GetNumberOfComponents() == array->GetNumberOfComponents();
  return isSame ? own : nullptr;
}

void SetMissing(vtkAbstractArray* array, vtkIdType at)
{
  if (auto* const numbers = vtkDataArray::SafeDownCast(array))
  {
    const bool isReal = numbers->GetDataType() == VTK_FLOAT || numbers->GetDataType() == VTK_DOUBLE;
    for (int c = 0; c < numbers->GetNumberOfComponents(); ++c)
    {
      numbers->SetComponent(at, c, isReal ? std::numeric_limits<double>::quiet_NaN() : 0.0);
    }
  }
}
}

KeptLines LinesOf(vtkDataObject* data, bool hasPoints)
{
  KeptLines kept;
  if (auto* const polyData = vtkPolyData::SafeDownCast(data))
  {
    Add(polyData, hasPoints, kept);
  }
  else if (auto* const composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    vtkSmartPointer<vtkCompositeDataIterator> blocks;
    blocks.TakeReference(composite->NewIterator());
    for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem())
    {
      if (auto* const block = vtkPolyData::SafeDownCast(blocks->GetCurrentDataObject()))
      {
        Add(block, hasPoints, kept);
      }
    }
  }
  return kept;
}

std::vector<double> StrengthsOf(const KeptLines& lines)
{
  std::vector<double> strengths(lines.Curves.size(), 1.0);
  bool isAny = false;
  for (std::size_t i = 0; i < strengths.size(); ++i)
  {
    const GivenCell& cell = lines.OfCurves[i];
    vtkDataArray* const array = cell.Data->GetCellData()->GetArray("Strength");
    if (array && array->GetNumberOfComponents() == 1)
    {
      isAny = true;
      strengths[i] = array->GetComponent(cell.Cell, 0);
      if (!(strengths[i] >= 0.0 && strengths[i] <= 1.0))
      {
        throw std::invalid_argument("Line " + std::to_string(i) +
          " of the curves has the Strength " + std::to_string(strengths[i]) +
          ": it must be 0 to 1, or the cell array have another name.");
      }
    }
  }
  return isAny ? strengths : std::vector<double>();
}

void CarryCellArrays(const std::vector<GivenCell>& sources, vtkCellData* output)
{
  std::set<vtkPolyData*> all;
  vtkPolyData* first = nullptr;
  for (const GivenCell& source : sources)
  {
    if (source.Data)
    {
      first = first ? first : source.Data.Get();
      all.insert(source.Data);
    }
  }
  for (int k = 0; first && k < first->GetCellData()->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* const array = first->GetCellData()->GetAbstractArray(k);
    const bool isFree = array->GetName() && !output->HasArray(array->GetName()) &&
      std::string(array->GetName()) != vtkDataSetAttributes::GhostArrayName();
    if (!isFree ||
      !std::all_of(
        all.begin(), all.end(), [&](vtkPolyData* data) { return Matching(array, data); }))
    {
      continue;
    }
    const auto own = vtkSmartPointer<vtkAbstractArray>::Take(array->NewInstance());
    own->SetName(array->GetName());
    own->SetNumberOfComponents(array->GetNumberOfComponents());
    own->SetNumberOfTuples(static_cast<vtkIdType>(sources.size()));
    for (std::size_t i = 0; i < sources.size(); ++i)
    {
      const auto at = static_cast<vtkIdType>(i);
      if (sources[i].Data)
      {
        own->SetTuple(at, sources[i].Cell, Matching(array, sources[i].Data));
      }
      else
      {
        SetMissing(own, at);
      }
    }
    output->AddArray(own);
  }
}
}
