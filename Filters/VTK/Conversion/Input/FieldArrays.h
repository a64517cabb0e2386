// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef FieldArrays_h
#define FieldArrays_h

#include <DirectionFields/Support/LargeArray.h>
#include <DirectionFields/Support/Threads.h>
#include <DirectionFields/Types.h>

#include "vtkNew.h"
#include "vtkType.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

class vtkIdTypeArray;
class vtkIntArray;
class vtkPoints;
class vtkPolyData;

namespace DirectionFields
{
/// The names of the field's arrays. The field filter writes them, and the glyph filter looks for
/// some of them.
namespace ArrayNames
{
constexpr const char* RepresentationMagnitude = "RepresentationMagnitude";
constexpr const char* EnergyDensity = "EnergyDensity";
constexpr const char* ConstraintKind = "ConstraintKind";
constexpr const char* ConstraintDirection = "ConstraintDirection";
constexpr const char* PrincipalDirection0 = "PrincipalDirection0";
constexpr const char* PrincipalDirection1 = "PrincipalDirection1";
constexpr const char* MeanCurvature = "MeanCurvature";
constexpr const char* GaussianCurvature = "GaussianCurvature";
constexpr const char* OriginalPointIds = "OriginalPointIds";
constexpr const char* GuidanceVectors = "GuidanceVectors";
constexpr const char* GuidanceWeights = "GuidanceWeights";
constexpr const char* GuidanceStrengths = "GuidanceStrengths";
/// Field data of blocks that curves do not guide, while they guide others.
constexpr const char* GuidedElsewhere = "GuidedElsewhere";
constexpr const char* SingularityIndex = "SingularityIndex";
constexpr const char* FaceSingularityIndex = "FaceSingularityIndex";
constexpr const char* Repairs = "Repairs";
constexpr const char* Warnings = "Warnings";
constexpr const char* Summary = "Summary";

/// The name of the array of the k-th direction at each point, k = 0 ... n-1.
std::string Direction(int k);
/// Whether an array describes the field of a degree at a point, and hence is zero at points that
/// the field does not reach.
bool IsOfTheField(const char* name, int degree);
}

/// Calls body(begin, end) for pieces of the tuples 0 ... tuples - 1, on the threads of the
/// computation. There may be more tuples than Index can number.
template <typename Body>
void ForEachPieceOfTuples(std::size_t tuples, const Body& body)
{
  constexpr std::size_t perPiece = 1 << 13;
  ParallelFor(static_cast<Index>((tuples + perPiece - 1) / perPiece), 1,
    [&](Index begin, Index end) { body(begin * perPiece, std::min(end * perPiece, tuples)); });
}

/// Throws std::bad_alloc if there is no room for an array. Some builds of VTK, Debian's among them,
/// end the program where an array of theirs finds none.
void RequireMemory(std::size_t bytes);
/// The same before arrays grow to some bytes: what an array has grown to stands beside what it is
/// moved to, which is twice as large.
inline void RequireMemoryToGrow(std::size_t bytes)
{
  RequireMemory(3 * bytes);
}

/// An array whose values are not set yet.
template <typename ArrayT>
vtkNew<ArrayT> MakeArray(const char* name, int components, std::size_t tuples)
{
  vtkNew<ArrayT> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  RequireMemory(sizeof(typename ArrayT::ValueType) * components * tuples);
  array->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
  PreferLargePages(array->GetPointer(0), array->GetDataTypeSize() * components * tuples);
  return array;
}

/// The value in a type that may have a smaller range: a value beyond the range becomes the largest
/// one.
template <typename To, typename From>
To Narrowed(From value)
{
  if constexpr (std::is_floating_point<To>::value)
  {
    constexpr double largest = std::numeric_limits<To>::max();
    return static_cast<To>(std::clamp<double>(value, -largest, largest));
  }
  else
  {
    return static_cast<To>(value);
  }
}

/// Writes tuple i of an array of three components.
template <typename Value>
void WriteVector(const Vector3& vector, Value* values, std::size_t i)
{
  for (int c = 0; c < 3; ++c)
  {
    values[3 * i + c] = static_cast<Value>(vector[c]);
  }
}

template <typename ArrayT>
vtkNew<ArrayT> MakeVectors(const char* name, const std::vector<Vector3>& vectors)
{
  static_assert(sizeof(Vector3) == 3 * sizeof(double));
  auto array = MakeArray<ArrayT>(name, 3, vectors.size());
  auto* const values = array->GetPointer(0);
  const double* const coordinates = vectors.empty() ? nullptr : vectors.data()->data();
  ForEachPieceOfTuples(vectors.size(),
    [&](std::size_t begin, std::size_t end)
    {
      // The compiler converts several coordinates at once in a loop over all of them.
      for (std::size_t i = 3 * begin; i < 3 * end; ++i)
      {
        values[i] = static_cast<typename ArrayT::ValueType>(coordinates[i]);
      }
    });
  return array;
}

template <typename ArrayT, typename Value>
vtkNew<ArrayT> MakeScalars(const char* name, const std::vector<Value>& values)
{
  auto array = MakeArray<ArrayT>(name, 1, values.size());
  auto* const narrowed = array->GetPointer(0);
  ForEachPieceOfTuples(values.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        narrowed[i] = Narrowed<typename ArrayT::ValueType>(values[i]);
      }
    });
  return array;
}

/// An array of one component with the values that a function gives.
template <typename ArrayT, typename Value>
vtkNew<ArrayT> MakeValues(const char* name, std::size_t size, const Value& value)
{
  auto array = MakeArray<ArrayT>(name, 1, size);
  for (std::size_t i = 0; i < size; ++i)
  {
    array->SetValue(static_cast<vtkIdType>(i), static_cast<typename ArrayT::ValueType>(value(i)));
  }
  return array;
}

/// The array ReasonForTermination of lines.
/// @param reason of a line's begin (0) or end (1), in the numbers of vtkStreamTracer
vtkNew<vtkIntArray> MakeReasons(
  std::size_t lines, const std::function<int(std::size_t, int)>& reason);

/// Points of double precision where pointDataType is VTK_DOUBLE, else of single precision.
vtkNew<vtkPoints> MakePoints(const std::vector<Vector3>& positions, int pointDataType);
/// The offsets or the connectivity of cells.
vtkNew<vtkIdTypeArray> MakeIds(const std::vector<std::int64_t>& ids);

/// Gives an empty output lines, whose points follow each other, or vertices.
/// @param offsets of the lines' first points, and the number of points
void SetPolyLines(const std::vector<Vector3>& positions, const std::vector<std::int64_t>& offsets,
  int pointDataType, vtkPolyData* output);
void SetVertices(const std::vector<Vector3>& positions, int pointDataType, vtkPolyData* output);
}

#endif
