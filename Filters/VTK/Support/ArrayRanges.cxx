// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Support/ArrayRanges.h"

#include <DirectionFields/Support/Threads.h>

#include "vtkAOSDataArrayTemplate.h"
#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkInformationInformationVectorKey.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>

namespace DirectionFields
{
namespace
{
constexpr int MostComponents = 3;
/// VTK gives other ranges than the least and the greatest number beyond 1e38.
constexpr double MostSquare = 1e76;
constexpr std::size_t TuplesPerPiece = 1 << 13;

/// The least and the greatest of some numbers.
struct Range
{
  double Least = std::numeric_limits<double>::infinity();
  double Greatest = -std::numeric_limits<double>::infinity();

  void Add(double value)
  {
    this->Least = value < this->Least ? value : this->Least;
    this->Greatest = value > this->Greatest ? value : this->Greatest;
  }
};

/// The ranges of the components, and behind them that of the squares of the lengths.
struct Ranges : std::array<Range, MostComponents + 1>
{
  /// Zero, unless a square of a length is infinite or not a number.
  double Nothing = 0.0;

  Ranges& operator+=(const Ranges& other)
  {
    for (std::size_t k = 0; k < this->size(); ++k)
    {
      (*this)[k].Add(other[k].Least);
      (*this)[k].Add(other[k].Greatest);
    }
    this->Nothing += other.Nothing;
    return *this;
  }
};

template <int Components, typename Value>
Ranges RangesOf(const Value* values, std::size_t begin, std::size_t end)
{
  Ranges ranges;
  for (std::size_t i = begin; i < end; ++i)
  {
    double square = 0.0;
    for (int c = 0; c < Components; ++c)
    {
      const auto value = static_cast<double>(values[Components * i + c]);
      ranges[c].Add(value);
      square += value * value;
    }
    ranges[Components].Add(square);
    ranges.Nothing += 0.0 * square;
  }
  return ranges;
}

void SetRange(vtkInformation* information, vtkInformationDoubleVectorKey* key, const Range& range)
{
  const double ends[] = { range.Least, range.Greatest };
  information->Set(key, ends, 2);
}

/// Puts the ranges of components below the key for all values and that for finite ones.
void SetPerComponent(vtkInformation* information, const Ranges& ranges, int components)
{
  vtkInformationVector* const all = vtkInformationVector::New();
  all->SetNumberOfInformationObjects(components);
  for (int c = 0; c < components; ++c)
  {
    SetRange(all->GetInformationObject(c), vtkDataArray::COMPONENT_RANGE(), ranges[c]);
  }
  information->Set(vtkDataArray::PER_COMPONENT(), all);
  information->Set(vtkDataArray::PER_FINITE_COMPONENT(), all);
  // Others hold it: the garbage collector need not look.
  all->FastDelete();
}

template <int Components, typename Value>
void KeepRangesOf(vtkAOSDataArrayTemplate<Value>* array)
{
  const auto tuples = static_cast<std::size_t>(array->GetNumberOfTuples());
  const Value* const values = array->GetPointer(0);
  const Ranges ranges =
    ParallelSum<Ranges>(static_cast<Index>((tuples + TuplesPerPiece - 1) / TuplesPerPiece), 1, {},
      [&](Index begin, Index end)
      {
        return RangesOf<Components>(
          values, begin * TuplesPerPiece, std::min(end * TuplesPerPiece, tuples));
      });
  const Range& squares = ranges[Components];
  if (tuples == 0 || ranges.Nothing != 0.0 || squares.Greatest > MostSquare)
  {
    return;
  }
  vtkInformation* const information = array->GetInformation();
  SetPerComponent(information, ranges, Components);
  if (Components > 1)
  {
    // The finite lengths are left to VTK, which copies their range to arrays of other values, as of
    // a part of the surface.
    SetRange(information, vtkDataArray::L2_NORM_RANGE(),
      { std::sqrt(squares.Least), std::sqrt(squares.Greatest) });
  }
}

/// False where the array is of another type.
template <typename Value>
bool KeepRangesOfType(vtkDataArray* array)
{
  auto* const typed = vtkAOSDataArrayTemplate<Value>::FastDownCast(array);
  switch (typed ? typed->GetNumberOfComponents() : 0)
  {
    case 1:
      KeepRangesOf<1>(typed);
      break;
    case 2:
      KeepRangesOf<2>(typed);
      break;
    case 3:
      KeepRangesOf<3>(typed);
      break;
    default:
      break;
  }
  return typed;
}

/// @param array may be null
template <typename... Values>
void KeepRangesOfTypes(vtkDataArray* array)
{
  // Arrays that an input holds, too, have the ranges that VTK keeps with it.
  if (array && array->GetReferenceCount() == 1)
  {
    (KeepRangesOfType<Values>(array) || ...);
  }
}

void KeepRanges(vtkDataArray* array)
{
  KeepRangesOfTypes<float, double, int, vtkIdType>(array);
}
}

void KeepRanges(vtkDataObject* output)
{
  auto* const polyData = vtkPolyData::SafeDownCast(output);
  if (!polyData)
  {
    return;
  }
  for (vtkFieldData* const data :
    std::initializer_list<vtkFieldData*>{ polyData->GetPointData(), polyData->GetCellData() })
  {
    for (int k = 0; k < data->GetNumberOfArrays(); ++k)
    {
      KeepRanges(data->GetArray(k));
    }
  }
  if (polyData->GetPoints() && polyData->GetPoints()->GetReferenceCount() == 1)
  {
    KeepRanges(polyData->GetPoints()->GetData());
  }
}
}
