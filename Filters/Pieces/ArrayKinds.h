// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef ArrayKinds_h
#define ArrayKinds_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkDataSetAttributes;
class vtkMultiProcessStream;

namespace DirectionFields::Parallel
{
/// The point array that says where a surface was split.
constexpr const char* OriginalPointIdsName = "OriginalPointIds";

/// Type, name and role of an array of numbers, known before its values come.
struct ArrayKind
{
  std::string Name;
  int Type = 0;
  int Components = 0;
  bool IsVectors = false;
};

using ArrayKinds = std::vector<ArrayKind>;

/// Writes the kinds of the computed arrays; given arrays are left out.
void WriteKinds(
  vtkDataSetAttributes* computed, vtkDataSetAttributes* given, vtkMultiProcessStream& stream);
ArrayKinds ReadKinds(vtkMultiProcessStream& stream);

/// An array of a kind, whose values are not set.
vtkSmartPointer<vtkDataArray> NewArray(const ArrayKind& kind, vtkIdType tuples);

/// Adds the arrays that are missing, of zeros.
void AddZeros(const ArrayKinds& kinds, vtkIdType tuples, vtkDataSetAttributes* data);
}

#endif
