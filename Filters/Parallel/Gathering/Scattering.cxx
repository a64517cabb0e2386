// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Gathering/Scattering.h"

#include "ArrayKinds.h"
#include "Gathering/SplitPiece.h"

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkMultiProcessStream.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <string>

namespace DirectionFields::Parallel
{
namespace
{
bool IsEverything(const std::vector<vtkIdType>& places, vtkIdType tuples)
{
  if (static_cast<vtkIdType>(places.size()) != tuples)
  {
    return false;
  }
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (places[i] != static_cast<vtkIdType>(i))
    {
      return false;
    }
  }
  return true;
}

/// Copies tuples of an array in any order, zeros for -1.
void CopyTuples(vtkDataArray* source, const std::vector<vtkIdType>& wanted, char* target)
{
  const std::size_t bytes =
    static_cast<std::size_t>(source->GetDataTypeSize()) * source->GetNumberOfComponents();
  const auto* const read = static_cast<const char*>(source->GetVoidPointer(0));
  for (const vtkIdType tuple : wanted)
  {
    if (tuple >= 0)
    {
      std::memcpy(target, read + static_cast<std::size_t>(tuple) * bytes, bytes);
    }
    else
    {
      std::memset(target, 0, bytes);
    }
    target += bytes;
  }
}

/// Puts the tuples of an array to places in another one of its kind.
void PutTuples(vtkDataArray* source, const std::vector<vtkIdType>& places, vtkDataArray* target)
{
  const std::size_t bytes =
    static_cast<std::size_t>(source->GetDataTypeSize()) * source->GetNumberOfComponents();
  const auto* read = static_cast<const char*>(source->GetVoidPointer(0));
  auto* const written = static_cast<char*>(target->GetVoidPointer(0));
  for (const vtkIdType place : places)
  {
    std::memcpy(written + static_cast<std::size_t>(place) * bytes, read, bytes);
    read += bytes;
  }
}

/// The tuples of all processes, in the order of the processes.
struct TupleLists
{
  /// The tuples of the surface that each process wants, -1 for zeros; only where the surface is, as
  /// First.
  std::vector<vtkIdType> Wanted;
  /// The first of each process, and the number of all.
  std::vector<vtkIdType> First;
  /// Where this process puts the values that it has asked for.
  std::vector<vtkIdType> Places;
};

/// Arrays on their way from one process to all.
class TravellingArrays
{
public:
  TravellingArrays(const ArrayKinds& kinds, const TupleLists& lists)
    : Kinds(kinds)
    , Lists(lists)
  {
  }

  /// Makes room; tuples without a place are zero.
  /// @param isThere whether the arrays are on this process
  void Expect(bool isThere, vtkIdType tuples)
  {
    this->IsEverything = Parallel::IsEverything(this->Lists.Places, tuples);
    for (const ArrayKind& kind : this->Kinds)
    {
      this->Outputs.push_back(NewArray(kind, tuples));
      if (!this->IsEverything)
      {
        this->Outputs.back()->Fill(0.0);
        this->Parts.push_back(NewArray(kind, static_cast<vtkIdType>(this->Lists.Places.size())));
      }
      if (isThere)
      {
        const auto bytes =
          static_cast<std::size_t>(this->Outputs.back()->GetDataTypeSize() * kind.Components);
        this->Buffer.resize(std::max(this->Buffer.size(), bytes * this->Lists.Wanted.size()));
      }
    }
  }

  void Scatter(
    Processes& processes, int from, vtkDataSetAttributes* computed, vtkDataSetAttributes* output)
  {
    const bool isThere = processes.Own() == from;
    for (std::size_t k = 0; k < this->Kinds.size(); ++k)
    {
      const ArrayKind& kind = this->Kinds[k];
      if (isThere)
      {
        CopyTuples(computed->GetArray(kind.Name.c_str()), this->Lists.Wanted, this->Buffer.data());
      }
      vtkDataArray* const array = this->Outputs[k];
      vtkDataArray* const part = this->IsEverything ? array : this->Parts[k].Get();
      processes.Scatter(this->Buffer.data(), this->Lists.First, kind.Components, kind.Type,
        part->GetVoidPointer(0), static_cast<vtkIdType>(this->Lists.Places.size()), from);
      if (!this->IsEverything)
      {
        PutTuples(part, this->Lists.Places, array);
      }
      output->AddArray(array);
      if (kind.IsVectors)
      {
        output->SetActiveVectors(kind.Name.c_str());
      }
    }
  }

private:
  const ArrayKinds& Kinds;
  const TupleLists& Lists;
  bool IsEverything = false;
  std::vector<vtkSmartPointer<vtkDataArray>> Outputs;
  std::vector<vtkSmartPointer<vtkDataArray>> Parts;
  /// One array of all processes.
  std::vector<char> Buffer;
};

/// Where the cells of a piece are, in the order of the gathered list.
std::vector<vtkIdType> CellPlaces(const SurfacePiece& piece)
{
  std::vector<vtkIdType> cells;
  for (const PieceCells* const some : { &piece.Polys, &piece.Strips, &piece.Ghosts })
  {
    cells.insert(cells.end(), some->Cells.begin(), some->Cells.end());
  }
  return cells;
}

std::vector<vtkIdType> PointPlaces(const SurfacePiece& piece)
{
  std::vector<vtkIdType> points = piece.Own.Points;
  points.insert(points.end(), piece.GhostPoints.Points.begin(), piece.GhostPoints.Points.end());
  return points;
}

/// Numbers and texts; VTK's own messages carry field data as text, which has not all digits, and
/// none that its reader takes for the lowest number there is.
void WriteFieldData(vtkFieldData* data, vtkMultiProcessStream& stream)
{
  std::vector<vtkAbstractArray*> arrays;
  for (int k = 0; k < data->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* const array = data->GetAbstractArray(k);
    if (vtkDataArray::SafeDownCast(array) || vtkStringArray::SafeDownCast(array))
    {
      arrays.push_back(array);
    }
  }
  const auto text = [](const char* name) { return std::string(name ? name : ""); };
  stream << static_cast<int>(arrays.size());
  for (vtkAbstractArray* const array : arrays)
  {
    const int components = array->GetNumberOfComponents();
    const auto tuples = static_cast<vtkTypeInt64>(array->GetNumberOfTuples());
    stream << text(array->GetName()) << array->GetDataType() << components << tuples;
    for (int c = 0; c < components; ++c)
    {
      stream << text(array->GetComponentName(c));
    }
    auto* const texts = vtkStringArray::SafeDownCast(array);
    for (vtkIdType i = 0; i < tuples * components; ++i)
    {
      if (texts)
      {
        stream << texts->GetValue(i);
      }
      else
      {
        stream << static_cast<vtkDataArray*>(array)->GetComponent(i / components, i % components);
      }
    }
  }
}

void ReadFieldData(vtkMultiProcessStream& stream, vtkFieldData* data)
{
  int arrays = 0;
  stream >> arrays;
  for (int k = 0; k < arrays; ++k)
  {
    std::string text;
    int type = 0;
    int components = 0;
    vtkTypeInt64 tuples = 0;
    stream >> text >> type >> components >> tuples;
    const auto array = vtkSmartPointer<vtkAbstractArray>::Take(vtkAbstractArray::CreateArray(type));
    array->SetName(text.c_str());
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
    for (int c = 0; c < components; ++c)
    {
      stream >> text;
      if (!text.empty())
      {
        array->SetComponentName(c, text.c_str());
      }
    }
    for (vtkIdType i = 0; i < tuples * components; ++i)
    {
      if (auto* const texts = vtkStringArray::SafeDownCast(array))
      {
        stream >> text;
        texts->SetValue(i, text);
        continue;
      }
      double value = 0.0;
      stream >> value;
      vtkDataArray::SafeDownCast(array)->SetComponent(i / components, i % components, value);
    }
    data->AddArray(array);
  }
}
}

void AddMissingArrays(Processes& processes, int from, vtkPolyData* whole, vtkPolyData* own)
{
  vtkMultiProcessStream stream;
  if (processes.Own() == from)
  {
    vtkNew<vtkPolyData> none;
    WriteKinds(whole->GetPointData(), none->GetPointData(), stream);
    WriteKinds(whole->GetCellData(), none->GetCellData(), stream);
  }
  processes.GetController()->Broadcast(stream, from);
  for (vtkDataSetAttributes* const data : { static_cast<vtkDataSetAttributes*>(own->GetPointData()),
         static_cast<vtkDataSetAttributes*>(own->GetCellData()) })
  {
    AddZeros(ReadKinds(stream), 0, data);
  }
}

void BroadcastFieldData(
  Processes& processes, int from, vtkFieldData* computed, vtkFieldData* output)
{
  vtkMultiProcessStream stream;
  if (processes.Own() == from)
  {
    WriteFieldData(computed, stream);
  }
  processes.GetController()->Broadcast(stream, from);
  ReadFieldData(stream, output);
}

void ScatterData(
  Processes& processes, const GatheredSurface& gathered, vtkPolyData* whole, vtkPolyData* output)
{
  const int from = gathered.Process;
  const bool isThere = processes.Own() == from;
  vtkNew<vtkPolyData> none;
  vtkPolyData* const result = isThere ? whole : none.Get();
  vtkMultiProcessStream stream;
  if (isThere)
  {
    WriteKinds(result->GetPointData(), gathered.Surface->GetPointData(), stream);
    WriteKinds(result->GetCellData(), gathered.Surface->GetCellData(), stream);
    stream << static_cast<int>(IsSplit(whole));
  }
  processes.GetController()->Broadcast(stream, from);
  const ArrayKinds pointKinds = ReadKinds(stream);
  const ArrayKinds cellKinds = ReadKinds(stream);
  int isSplit = 0;
  stream >> isSplit;

  TupleLists points;
  TupleLists cells;
  if (isSplit)
  {
    SplitPiece split = SplitAsGathered(processes, gathered, whole, output);
    points = { std::move(split.PointsOf), std::move(split.FirstPointOf), std::move(split.Places) };
  }
  TravellingArrays pointArrays(pointKinds, points);
  TravellingArrays cellArrays(cellKinds, cells);
  processes.Together(
    [&]
    {
      if (!isSplit)
      {
        points = { gathered.PointsOf, gathered.FirstPointOf, PointPlaces(gathered.Piece) };
      }
      cells = { gathered.CellsOf, gathered.FirstCellOf, CellPlaces(gathered.Piece) };
      pointArrays.Expect(isThere, output->GetNumberOfPoints());
      cellArrays.Expect(isThere, output->GetNumberOfCells());
    });
  pointArrays.Scatter(processes, from, result->GetPointData(), output->GetPointData());
  cellArrays.Scatter(processes, from, result->GetCellData(), output->GetCellData());
  BroadcastFieldData(processes, from, result->GetFieldData(), output->GetFieldData());
}
}
