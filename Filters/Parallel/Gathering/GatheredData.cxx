// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Gathering/GatheredData.h"

#include "ArrayKinds.h"

#include "vtkAppendPolyData.h"
#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkMultiProcessStream.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <string>
#include <vector>

namespace DirectionFields::Parallel
{
namespace
{
/// Where values of one kind, of points or of cells, come from and go to.
struct Way
{
  vtkDataSetAttributes* From;
  /// Null on the other processes.
  vtkDataSetAttributes* To;
  /// The tuples that this process sends.
  std::vector<vtkIdType> Own;
  /// For all processes, where each tuple goes; only where the surface is.
  std::vector<vtkIdType> Places;
  vtkIdType Tuples = 0;
};

/// The kinds of the arrays that can travel.
ArrayKinds KindsOf(vtkDataSetAttributes* data)
{
  vtkNew<vtkPointData> none;
  vtkMultiProcessStream stream;
  WriteKinds(data, none, stream);
  ArrayKinds kinds = ReadKinds(stream);
  const auto staysBehind = [data](const ArrayKind& kind)
  {
    vtkDataArray* const array = data->GetArray(kind.Name.c_str());
    return kind.Type == VTK_BIT || kind.Name == vtkDataSetAttributes::GhostArrayName() ||
      data->GetAbstractAttribute(vtkDataSetAttributes::GLOBALIDS) == array;
  };
  kinds.erase(std::remove_if(kinds.begin(), kinds.end(), staysBehind), kinds.end());
  return kinds;
}

/// The kinds that the process which gathers has, without those that others do not have.
ArrayKinds AgreeOnKinds(Processes& processes, int to, const Way& way)
{
  vtkMultiProcessStream stream;
  if (processes.Own() == to)
  {
    const ArrayKinds own = KindsOf(way.From);
    stream << static_cast<int>(own.size());
    for (const ArrayKind& kind : own)
    {
      stream << kind.Name << kind.Type << kind.Components << static_cast<int>(kind.IsVectors);
    }
  }
  processes.GetController()->Broadcast(stream, to);
  const ArrayKinds kinds = ReadKinds(stream);
  std::vector<vtkIdType> lacks;
  for (const ArrayKind& kind : kinds)
  {
    vtkDataArray* const array = way.From->GetArray(kind.Name.c_str());
    lacks.push_back(
      !way.Own.empty() && (!array || array->GetNumberOfComponents() != kind.Components));
  }
  const std::vector<vtkIdType> all = processes.AllGather(lacks);
  ArrayKinds agreed;
  for (std::size_t k = 0; k < kinds.size(); ++k)
  {
    bool isThere = true;
    for (std::size_t i = k; i < all.size(); i += kinds.size())
    {
      isThere = isThere && all[i] == 0;
    }
    if (isThere)
    {
      agreed.push_back(kinds[k]);
    }
  }
  return agreed;
}

/// The tuples that this process sends, of the type that all send.
vtkSmartPointer<vtkDataArray> OwnTuples(const ArrayKind& kind, const Way& way)
{
  vtkSmartPointer<vtkDataArray> own = NewArray(kind, static_cast<vtkIdType>(way.Own.size()));
  vtkDataArray* const array = way.From->GetArray(kind.Name.c_str());
  for (std::size_t i = 0; i < way.Own.size(); ++i)
  {
    // Copies from an array of another type convert the values.
    own->SetTuple(static_cast<vtkIdType>(i), way.Own[i], array);
  }
  return own;
}

void GatherArrays(Processes& processes, int to, const Way& way)
{
  const ArrayKinds kinds = AgreeOnKinds(processes, to, way);
  const std::vector<vtkIdType> tuples =
    processes.AllGather({ static_cast<vtkIdType>(way.Own.size()) });
  for (const ArrayKind& kind : kinds)
  {
    vtkSmartPointer<vtkDataArray> own;
    vtkSmartPointer<vtkDataArray> all;
    vtkSmartPointer<vtkDataArray> result;
    processes.Together(
      [&]
      {
        own = OwnTuples(kind, way);
        all = NewArray(kind, static_cast<vtkIdType>(way.Places.size()));
        result = NewArray(kind, way.Tuples);
      });
    std::vector<vtkIdType> lengths = tuples;
    for (vtkIdType& length : lengths)
    {
      length *= kind.Components;
    }
    std::vector<vtkIdType> first = Processes::FirstOf(lengths);
    // The functions of VTK take no null pointers for empty arrays.
    double none = 0.0;
    const auto start = [&none](vtkDataArray* array) -> void*
    { return array->GetNumberOfTuples() > 0 ? array->GetVoidPointer(0) : &none; };
    processes.GetController()->GetCommunicator()->GatherVVoidArray(start(own), start(all),
      own->GetNumberOfValues(), lengths.data(), first.data(), kind.Type, to);
    if (!way.To)
    {
      continue;
    }
    const std::size_t bytes =
      static_cast<std::size_t>(all->GetDataTypeSize()) * static_cast<std::size_t>(kind.Components);
    const auto* const read = static_cast<const char*>(start(all));
    auto* const written = static_cast<char*>(start(result));
    // Backwards, for the first piece that has a point to come last.
    for (std::size_t i = way.Places.size(); i-- > 0;)
    {
      std::memcpy(
        written + static_cast<std::size_t>(way.Places[i]) * bytes, read + i * bytes, bytes);
    }
    way.To->AddArray(result);
    if (kind.IsVectors)
    {
      way.To->SetActiveVectors(kind.Name.c_str());
    }
  }
}

/// For all own points or cells of all processes their numbers on the surface.
std::vector<vtkIdType> PlacesOf(const std::vector<vtkIdType>& all,
  const std::vector<vtkIdType>& first, const std::vector<vtkIdType>& own)
{
  std::vector<vtkIdType> places;
  for (std::size_t p = 0; p < own.size(); ++p)
  {
    places.insert(places.end(), all.begin() + first[p], all.begin() + first[p] + own[p]);
  }
  return places;
}

/// A surface that one process has from the beginning.
WholeSurface InPlace(Processes& processes, vtkPolyData* piece, int process)
{
  WholeSurface whole;
  whole.IsInPlace = true;
  GatheredSurface& gathered = whole.Gathered;
  gathered.Process = process;
  gathered.Pieces = 1;
  gathered.Cells = processes.Largest(piece->GetNumberOfPolys() + piece->GetNumberOfStrips());
  gathered.FirstPointOf.assign(static_cast<std::size_t>(processes.Count()) + 1, 0);
  gathered.FirstCellOf = gathered.FirstPointOf;
  gathered.OwnPointsOf.assign(static_cast<std::size_t>(processes.Count()), 0);
  gathered.OwnCellsOf = gathered.OwnPointsOf;
  if (processes.Own() == process)
  {
    gathered.Surface = piece;
  }
  return whole;
}

/// All points of a dataset, and the cells of those that are polygons and lines.
vtkSmartPointer<vtkPolyData> AsPolyData(vtkDataObject* data)
{
  vtkNew<vtkAppendPolyData> append;
  const auto add = [&append](vtkDataObject* object)
  {
    auto* const points = vtkPointSet::SafeDownCast(object);
    if (!points || points->GetNumberOfPoints() == 0)
    {
      return;
    }
    vtkNew<vtkPolyData> part;
    if (vtkPolyData::SafeDownCast(points))
    {
      part->ShallowCopy(points);
    }
    else
    {
      part->SetPoints(points->GetPoints());
      part->GetPointData()->ShallowCopy(points->GetPointData());
    }
    // Messages carry field data as text, which nothing reads here.
    part->GetFieldData()->Initialize();
    append->AddInputData(part);
  };
  if (auto* const composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    const auto at = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
    {
      add(at->GetCurrentDataObject());
    }
  }
  else
  {
    add(data);
  }
  if (append->GetNumberOfInputConnections(0) == 0)
  {
    return vtkSmartPointer<vtkPolyData>::New();
  }
  append->Update();
  return append->GetOutput();
}

bool AreAlike(vtkPolyData* one, vtkPolyData* other)
{
  if (one->GetNumberOfPoints() != other->GetNumberOfPoints() ||
    one->GetNumberOfCells() != other->GetNumberOfCells())
  {
    return false;
  }
  for (vtkIdType i = 0; i < one->GetNumberOfPoints(); ++i)
  {
    double a[3];
    double b[3];
    one->GetPoint(i, a);
    other->GetPoint(i, b);
    if (!std::equal(a, a + 3, b))
    {
      return false;
    }
  }
  return true;
}
}

WholeSurface GatherWhole(Processes& processes, vtkPolyData* piece, int to)
{
  const std::vector<vtkIdType> sizes =
    processes.AllGather({ piece->GetNumberOfPolys() + piece->GetNumberOfStrips() });
  const auto largest =
    static_cast<int>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  const bool isOnOne = std::count(sizes.begin(), sizes.end(), 0) + 1 == processes.Count();
  if (isOnOne && (to < 0 || to == largest))
  {
    return InPlace(processes, piece, largest);
  }
  WholeSurface whole;
  whole.Gathered = GatherSurface(processes, piece, {}, {}, to);
  const GatheredSurface& gathered = whole.Gathered;
  const SurfacePiece& own = gathered.Piece;
  vtkPolyData* const surface = gathered.Surface;
  Way points;
  Way cells;
  processes.Together(
    [&]
    {
      points.From = piece->GetPointData();
      points.To = surface ? surface->GetPointData() : nullptr;
      points.Own = own.Own.Points;
      cells.From = piece->GetCellData();
      cells.To = surface ? surface->GetCellData() : nullptr;
      cells.Own = own.Polys.Cells;
      cells.Own.insert(cells.Own.end(), own.Strips.Cells.begin(), own.Strips.Cells.end());
      if (surface)
      {
        points.Tuples = surface->GetNumberOfPoints();
        points.Places = PlacesOf(gathered.PointsOf, gathered.FirstPointOf, gathered.OwnPointsOf);
        cells.Tuples = surface->GetNumberOfCells();
        cells.Places = PlacesOf(gathered.CellsOf, gathered.FirstCellOf, gathered.OwnCellsOf);
        surface->GetFieldData()->ShallowCopy(piece->GetFieldData());
      }
    });
  GatherArrays(processes, gathered.Process, points);
  GatherArrays(processes, gathered.Process, cells);
  return whole;
}

vtkSmartPointer<vtkPolyData> GatherParts(Processes& processes, vtkDataObject* own, int to)
{
  vtkSmartPointer<vtkPolyData> part;
  processes.Together([&] { part = AsPolyData(own); });
  std::vector<vtkSmartPointer<vtkDataObject>> parts;
  processes.GetController()->Gather(part.Get(), parts, to);
  vtkSmartPointer<vtkPolyData> result;
  processes.Together(
    [&]
    {
      if (processes.Own() != to)
      {
        return;
      }
      std::vector<vtkPolyData*> unlike;
      vtkNew<vtkAppendPolyData> append;
      for (const vtkSmartPointer<vtkDataObject>& object : parts)
      {
        auto* const one = vtkPolyData::SafeDownCast(object);
        const bool isNew = one && one->GetNumberOfPoints() > 0 &&
          std::none_of(unlike.begin(), unlike.end(),
            [one](vtkPolyData* other) { return AreAlike(one, other); });
        if (isNew)
        {
          unlike.push_back(one);
          append->AddInputData(one);
        }
      }
      result = vtkSmartPointer<vtkPolyData>::New();
      if (!unlike.empty())
      {
        append->Update();
        result->ShallowCopy(append->GetOutput());
      }
    });
  return result;
}
}
