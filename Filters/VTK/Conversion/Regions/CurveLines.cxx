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
#include "vtkVariant.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
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

/// Whether two cells are the same in what numbers or names them: integers and texts, not numbers
/// that are measured.
bool AreAlike(vtkCellData* data, vtkIdType a, vtkIdType b)
{
  for (int k = 0; k < data->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* const array = data->GetAbstractArray(k);
    const bool isReal = array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
    for (int c = 0; c < array->GetNumberOfComponents() && !isReal; ++c)
    {
      const vtkIdType size = array->GetNumberOfComponents();
      if (!(array->GetVariantValue(a * size + c) == array->GetVariantValue(b * size + c)))
      {
        return false;
      }
    }
  }
  return true;
}

/// Lines of two points that meet end to end where no other line is, as slices and Feature Edges
/// have them, are parts of one curve.
class JoinedSegments
{
public:
  explicit JoinedSegments(vtkPolyData* polyData)
    : Data(polyData->GetCellData())
    , FirstCell(polyData->GetNumberOfVerts())
  {
    vtkNew<vtkIdList> ids;
    for (vtkIdType i = 0; i < polyData->GetNumberOfLines(); ++i)
    {
      polyData->GetLines()->GetCellAtId(i, ids);
      this->Lines.emplace_back(ids->begin(), ids->end());
      for (const vtkIdType p : this->Lines.back())
      {
        this->At[p].push_back(i);
      }
    }
  }

  /// The points of each curve, from the end that comes first, and its first line.
  std::vector<std::pair<std::vector<vtkIdType>, vtkIdType>> Join() const
  {
    std::vector<std::pair<std::vector<vtkIdType>, vtkIdType>> curves;
    std::vector<char> isTaken(this->Lines.size(), 0);
    for (vtkIdType i = 0; i < static_cast<vtkIdType>(this->Lines.size()); ++i)
    {
      if (isTaken[i] == 0)
      {
        isTaken[i] = 1;
        std::vector<vtkIdType> points = this->Lines[i];
        this->Extend(i, points, isTaken);
        std::reverse(points.begin(), points.end());
        this->Extend(i, points, isTaken);
        std::reverse(points.begin(), points.end());
        curves.emplace_back(std::move(points), i);
      }
    }
    return curves;
  }

private:
  /// Goes on at the last point.
  void Extend(vtkIdType line, std::vector<vtkIdType>& points, std::vector<char>& isTaken) const
  {
    while (this->Lines[line].size() == 2)
    {
      const std::vector<vtkIdType>& here = this->At.at(points.back());
      const vtkIdType next = here[here[0] == line ? here.size() - 1 : 0];
      if (here.size() != 2 || isTaken[next] != 0 || this->Lines[next].size() != 2 ||
        !AreAlike(this->Data, this->FirstCell + line, this->FirstCell + next))
      {
        return;
      }
      isTaken[next] = 1;
      points.push_back(this->Lines[next][this->Lines[next][0] == points.back() ? 1 : 0]);
      line = next;
    }
  }

  vtkCellData* Data;
  vtkIdType FirstCell;
  std::vector<std::vector<vtkIdType>> Lines;
  /// The lines at each point.
  std::map<vtkIdType, std::vector<vtkIdType>> At;
};

/// Appends the lines of polydata, those of two points joined.
void AddJoinedLines(vtkPolyData* polyData, KeptLines& kept)
{
  for (const auto& [points, line] : JoinedSegments(polyData).Join())
  {
    std::vector<Vector3> curve;
    for (const vtkIdType p : points)
    {
      curve.push_back(PlaceOf(polyData, p, "with its line"));
    }
    kept.Curves.push_back(std::move(curve));
    kept.OfCurves.push_back({ polyData, polyData->GetNumberOfVerts() + line });
  }
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

void Add(vtkPolyData* polyData, bool isKept, KeptLines& kept)
{
  CheckPolyData(polyData);
  if (!isKept)
  {
    AddLines(polyData, kept);
    return;
  }
  kept.HasFaces = kept.HasFaces || polyData->GetNumberOfPolys() + polyData->GetNumberOfStrips() > 0;
  AddJoinedLines(polyData, kept);
  AddPoints(polyData, kept);
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

KeptLines LinesOf(vtkDataObject* data, bool isKept)
{
  KeptLines kept;
  if (auto* const polyData = vtkPolyData::SafeDownCast(data))
  {
    Add(polyData, isKept, kept);
  }
  else if (auto* const composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    vtkSmartPointer<vtkCompositeDataIterator> blocks;
    blocks.TakeReference(composite->NewIterator());
    for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem())
    {
      if (auto* const block = vtkPolyData::SafeDownCast(blocks->GetCurrentDataObject()))
      {
        Add(block, isKept, kept);
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
