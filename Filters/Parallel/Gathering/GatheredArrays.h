// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef GatheredArrays_h
#define GatheredArrays_h

#include "Processes.h"
#include "SurfacePiece.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkType.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace DirectionFields::Parallel
{
/// Values of all processes, one process after another.
template <typename T>
struct Gathered
{
  /// How many each process has.
  std::vector<vtkIdType> Lengths;
  /// The first of each, and the number of all.
  std::vector<vtkIdType> First;
  /// Empty but on the process that gathers.
  std::vector<T> Values;
};

/// Cells of one kind of all processes.
struct GatheredCells
{
  Gathered<vtkIdType> Corners;
  /// Empty where all have three.
  Gathered<vtkIdType> Sizes;
  /// The first cell of each process, and the number of all.
  std::vector<vtkIdType> First;
};

/// Numbers that each process announces to all before anything is gathered.
class Announcements
{
public:
  /// @return where to look for the number
  std::size_t Add(vtkIdType value)
  {
    this->Values.push_back(value);
    return this->Values.size() - 1;
  }

  void Exchange(Processes& processes)
  {
    this->Count = static_cast<std::size_t>(processes.Count());
    this->All = processes.AllGather(this->Values);
  }

  std::vector<vtkIdType> Of(std::size_t number) const
  {
    std::vector<vtkIdType> values(this->Count);
    for (std::size_t p = 0; p < this->Count; ++p)
    {
      values[p] = this->All[p * this->Values.size() + number];
    }
    return values;
  }

  vtkIdType Sum(std::size_t number) const
  {
    const std::vector<vtkIdType> values = this->Of(number);
    return std::accumulate(values.begin(), values.end(), vtkIdType(0));
  }

  vtkIdType Largest(std::size_t number) const
  {
    const std::vector<vtkIdType> values = this->Of(number);
    return *std::max_element(values.begin(), values.end());
  }

private:
  std::size_t Count = 0;
  std::vector<vtkIdType> Values;
  std::vector<vtkIdType> All;
};

/// Takes the announced length of a list, and makes room for it on one process.
template <typename T>
void Expect(const Announcements& announced, std::size_t number, bool isThere, Gathered<T>& list)
{
  list.Lengths = announced.Of(number);
  list.First = Processes::FirstOf(list.Lengths);
  list.Values.resize(isThere ? static_cast<std::size_t>(list.First.back()) : 0);
}

/// The cells of one kind on their way.
struct TravellingCells
{
  TravellingCells(const PieceCells& own, Announcements& announced)
    : Own(own)
    , Cells(announced.Add(static_cast<vtkIdType>(own.Cells.size())))
    , Corners(announced.Add(static_cast<vtkIdType>(own.Corners.size())))
    , HasSizes(announced.Add(own.Sizes.empty() ? 0 : 1))
  {
  }

  void Expect(const Announcements& announced, bool isThere)
  {
    Parallel::Expect(announced, this->Corners, isThere, this->All.Corners);
    this->All.First = Processes::FirstOf(announced.Of(this->Cells));
    this->SomeHaveSizes = announced.Sum(this->HasSizes) > 0;
    if (this->SomeHaveSizes)
    {
      Parallel::Expect(announced, this->Cells, isThere, this->All.Sizes);
      this->OwnSizes = this->Own.Sizes.empty() ? std::vector<vtkIdType>(this->Own.Cells.size(), 3)
                                               : this->Own.Sizes;
    }
  }

  void Gather(Processes& processes, int to)
  {
    processes.Gather(this->Own.Corners, this->All.Corners.Lengths, this->All.Corners.Values, to);
    if (this->SomeHaveSizes)
    {
      processes.Gather(this->OwnSizes, this->All.Sizes.Lengths, this->All.Sizes.Values, to);
    }
  }

  GatheredCells All;

private:
  const PieceCells& Own;
  std::vector<vtkIdType> OwnSizes;
  std::size_t Cells;
  std::size_t Corners;
  std::size_t HasSizes;
  bool SomeHaveSizes = false;
};

/// The values of an array at points or cells, as doubles.
inline std::vector<double> ReadValues(vtkDataArray* array, const std::vector<vtkIdType>& places)
{
  const int components = array->GetNumberOfComponents();
  std::vector<double> values(places.size() * components);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    array->GetTuple(places[i], values.data() + i * components);
  }
  return values;
}

/// An array on its way, which is left behind unless all pieces with points have it alike.
struct TravellingArray
{
  static TravellingArray OfPoints(vtkPolyData* polyData, const SurfacePiece& piece,
    const std::string& name, Announcements& announced)
  {
    return { polyData->GetPointData()->GetArray(name.c_str()), piece, piece.Own.Points, name,
      announced };
  }
  static TravellingArray OfCells(vtkPolyData* polyData, const SurfacePiece& piece,
    const PieceCells& cells, const std::string& name, Announcements& announced)
  {
    return { polyData->GetCellData()->GetArray(name.c_str()), piece, cells.Cells, name, announced };
  }

  /// @param places the points or cells whose values travel
  TravellingArray(vtkDataArray* array, const SurfacePiece& piece,
    const std::vector<vtkIdType>& places, std::string name, Announcements& announced)
    : Name(std::move(name))
    , TakesPart(piece.HasPoints)
  {
    const int components = this->TakesPart && array ? array->GetNumberOfComponents() : 0;
    if (components > 0)
    {
      this->Own = ReadValues(array, places);
    }
    this->Components = announced.Add(components);
    this->Missing = announced.Add(this->TakesPart && components == 0 ? 1 : 0);
    this->Values = announced.Add(static_cast<vtkIdType>(this->Own.size()));
  }

  void Expect(const Announcements& announced, bool isThere)
  {
    this->Width = announced.Largest(this->Components);
    bool isAlike = announced.Sum(this->Missing) == 0 && this->Width > 0;
    for (const vtkIdType components : announced.Of(this->Components))
    {
      isAlike = isAlike && (components == 0 || components == this->Width);
    }
    this->Width = isAlike ? this->Width : 0;
    if (isAlike)
    {
      Parallel::Expect(announced, this->Values, isThere, this->All);
    }
  }

  void Gather(Processes& processes, int to)
  {
    if (this->Width > 0)
    {
      processes.Gather(this->Own, this->All.Lengths, this->All.Values, to);
    }
  }

  /// @param first the point of the pieces that each point of the surface is
  void AddTo(vtkPolyData* surface, const std::vector<vtkIdType>& first) const
  {
    if (this->Width == 0)
    {
      return;
    }
    vtkNew<vtkDoubleArray> values;
    values->SetName(this->Name.c_str());
    values->SetNumberOfComponents(static_cast<int>(this->Width));
    values->SetNumberOfTuples(static_cast<vtkIdType>(first.size()));
    for (std::size_t i = 0; i < first.size(); ++i)
    {
      std::copy_n(this->All.Values.data() + first[i] * this->Width, this->Width,
        values->GetPointer(static_cast<vtkIdType>(i) * this->Width));
    }
    surface->GetPointData()->AddArray(values);
  }

  /// Adds an array of cells: its values on polygons, then those on strips, each one process after
  /// another.
  friend void AddCells(
    const TravellingArray& polys, const TravellingArray& strips, vtkPolyData* surface)
  {
    if (polys.Width == 0)
    {
      return;
    }
    vtkNew<vtkDoubleArray> values;
    values->SetName(polys.Name.c_str());
    values->SetNumberOfComponents(static_cast<int>(polys.Width));
    const std::size_t polyValues = polys.All.Values.size();
    values->SetNumberOfTuples(
      static_cast<vtkIdType>(polyValues + strips.All.Values.size()) / polys.Width);
    std::copy(polys.All.Values.begin(), polys.All.Values.end(), values->GetPointer(0));
    std::copy(strips.All.Values.begin(), strips.All.Values.end(),
      values->GetPointer(static_cast<vtkIdType>(polyValues)));
    surface->GetCellData()->AddArray(values);
  }

private:
  std::string Name;
  bool TakesPart;
  std::vector<double> Own;
  Gathered<double> All;
  std::size_t Components;
  std::size_t Missing;
  std::size_t Values;
  vtkIdType Width = 0;
};

}

#endif
