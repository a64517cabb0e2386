// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FuzzedFilters.h"

#include "FilterRuns.h"
#include "FuzzedOptions.h"
#include "FuzzedSurface.h"

#include "Cxx/Checks.h"
#include "Meshes/PolyData.h"

#include "vtkCellData.h"
#include "vtkDirectionField.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <vector>

using FilterRuns::Filter;
using FilterRuns::MeshPointer;
using FilterRuns::Outcome;

namespace
{
/// Each of two filters has so many bytes of options, the field and what is checked the last ones.
constexpr std::size_t FilterSize = 12;
constexpr std::size_t FieldAt = 2 * FilterSize;
constexpr std::size_t HeadSize = 32;
/// Bytes from here on stand for the surfaces of hundreds of triangles.
constexpr unsigned FirstLarge = 230;

/// The length of the box; 0 where there is none.
double SizeOf(vtkPolyData* mesh)
{
  const double length = mesh->GetNumberOfPoints() > 0 ? mesh->GetLength() : 0.0;
  return std::isfinite(length) ? length : 0.0;
}

/// The mesh with a field, mostly the smoothest one.
MeshPointer FieldOn(vtkPolyData* mesh, const Bytes& bytes)
{
  const unsigned kind = bytes.At(FieldAt);
  const int degree = 1 + static_cast<int>((3 + bytes.At(FieldAt + 1)) % (kind % 16 == 15 ? 16 : 6));
  auto field = MeshPointer::New();
  if (kind % 4 != 3)
  {
    vtkNew<vtkDirectionField> filter;
    filter->SetDegree(degree);
    filter->SetNumberOfThreads(1);
    filter->SetConstrainBoundary(kind % 8 == 5);
    filter->SetConstrainSharpEdges(kind % 8 == 6);
    filter->SetMergePoints(static_cast<int>(kind / 16 % 3));
    // Its errors are those of other targets.
    vtkNew<Checks::Messages> unheard;
    unheard->Observe(filter);
    filter->SetInputData(mesh);
    filter->Update();
    field->DeepCopy(filter->GetOutput());
  }
  if (field->GetNumberOfPoints() == 0)
  {
    field->DeepCopy(mesh);
    AddRandomField(field, degree, kind);
  }
  if (bytes.At(FieldAt + 2) >= 200)
  {
    Damage(field, bytes.At(FieldAt + 3), bytes.At(FieldAt + 2));
  }
  return field;
}

/// The most that an array has; 0 without it.
double Most(vtkFieldData* data, const char* name)
{
  vtkDataArray* const array = data->GetArray(name);
  double most = 0.0;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    most = std::max(most, array->GetComponent(i, 0));
  }
  return most;
}

/// No more lines than allowed, with an end each.
std::string LinesFlaw(const Outcome& lines, const OptionBytes& options)
{
  vtkPolyData* const output = lines.Outputs[0];
  if (output->GetNumberOfLines() > 1 + static_cast<int>(options[5] % 64))
  {
    return "more lines than allowed";
  }
  vtkDataArray* const ends = output->GetCellData()->GetArray("ReasonForTermination");
  for (vtkIdType i = 0; ends && i < ends->GetNumberOfTuples(); ++i)
  {
    if (ends->GetComponent(i, 1) < 0.0 || ends->GetComponent(i, 1) > 9.0)
    {
      return "a line that ends for no reason";
    }
  }
  return "";
}

/// Singularities of an edited field are those of its triangles.
std::string EditsFlaw(const Outcome& edited)
{
  const auto sum = [](vtkFieldData* data, const char* name)
  {
    vtkDataArray* const array = data->GetArray(name);
    double all = 0.0;
    for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
    {
      all += array->GetComponent(i, 0);
    }
    return all;
  };
  vtkPolyData* const field = edited.Outputs[0];
  const double cells = sum(field->GetCellData(), "SingularityIndex");
  if (cells != sum(edited.Outputs[1]->GetPointData(), "SingularityIndex"))
  {
    return "other singularities than those of the triangles";
  }
  const bool hasSums = field->GetFieldData()->HasArray("IndexSum") != 0;
  return hasSums && cells != sum(field->GetFieldData(), "IndexSum") ? "another sum of indices" : "";
}

/// Both orders of two fields differ by the same angles, and a field not from itself.
std::string ComparisonFlaw(const Filter& filter, const Outcome& outcome)
{
  const char* name = "MaximumAngleDifference";
  const double most = Most(outcome.Outputs[0]->GetFieldData(), name);
  Filter other = filter;
  std::swap(other.Inputs[0], other.Inputs[1]);
  const Outcome swapped = FilterRuns::Execute(other);
  if (!swapped.Flaw.empty() || !swapped.Error.empty())
  {
    return "the other order: " + swapped.Flaw + swapped.Error;
  }
  if (!(std::abs(Most(swapped.Outputs[0]->GetFieldData(), name) - most) < 1e-6))
  {
    return "other angles in the other order";
  }
  other.Inputs[1] = other.Inputs[0];
  const Outcome self = FilterRuns::Execute(other);
  return self.Error.empty() && !(Most(self.Outputs[0]->GetFieldData(), name) < 1e-5)
    ? "a field that is not like itself"
    : "";
}

/// The first statement that does not hold of an execution.
std::string FlawOf(const Filter& filter, const Outcome& outcome, unsigned kind,
  const OptionBytes& options, unsigned checks)
{
  std::string flaw = outcome.Flaw;
  if (flaw.empty() && checks % 4 == 1)
  {
    flaw = FilterRuns::FlawOfSecondUse(filter, outcome);
  }
  if (flaw.empty() && checks % 4 == 2)
  {
    flaw = FilterRuns::FlawOnTwoThreads(filter, outcome);
  }
  if (flaw.empty() && outcome.Error.empty() && kind % 8 == 0)
  {
    flaw = LinesFlaw(outcome, options);
  }
  if (flaw.empty() && outcome.Error.empty() && kind % 8 == 1)
  {
    flaw = EditsFlaw(outcome);
  }
  if (flaw.empty() && outcome.Error.empty() && kind % 8 == 2)
  {
    flaw = ComparisonFlaw(filter, outcome);
  }
  return flaw;
}
}

std::string FuzzedFilters(
  FilterGroup group, const std::uint8_t* data, std::size_t size, bool isSmall)
{
  std::vector<std::uint8_t> all(data, data + size);
  if (isSmall && size > HeadSize && all[HeadSize] >= FirstLarge)
  {
    all[HeadSize] -= FirstLarge;
  }
  Bytes bytes(all.data(), all.size());
  const Bytes head = bytes;
  bytes.Skip(HeadSize);
  DirectionFields::Surface surface = ReadSurface(bytes);
  const unsigned extreme = head.At(FieldAt + 4);
  for (DirectionFields::Vector3& point : surface.Points)
  {
    // From 1e-165 to 1e165.
    point *= extreme >= 200 ? std::pow(10.0, 6.0 * (static_cast<int>(extreme) - 227.5)) : 1.0;
  }
  const MeshPointer mesh =
    Meshes::ToPolyData(surface, head.At(FieldAt + 5) % 4 == 1 ? VTK_FLOAT : VTK_DOUBLE);
  const MeshPointer field = FieldOn(mesh, head);
  const OptionBytes first{ head, 0, SizeOf(field), isSmall };
  const unsigned checks = head.At(FieldAt + 6);
  const unsigned kinds = head.At(FieldAt + 7);
  const unsigned kind = group == FilterGroup::Pairs ? kinds : static_cast<unsigned>(group);
  const MeshPointer points = SomePoints(field, first);
  const Filter one = AnyFilter(kind, field, points, first);
  const Outcome outcome = FilterRuns::Execute(one);
  if (group != FilterGroup::Pairs || !outcome.Flaw.empty())
  {
    return FlawOf(one, outcome, kind, first, checks);
  }
  const OptionBytes second{ head, FilterSize, first.Size, isSmall };
  // The lines of one filter are curves for the next, and points its singularities.
  const bool areLines = kind % 8 == 0;
  const MeshPointer other = outcome.Outputs.back();
  const Filter two =
    AnyFilter(kinds / 8, areLines && kinds >= 128 ? field : outcome.Outputs.front(),
      areLines ? outcome.Outputs.front() : other, second);
  return FlawOf(two, FilterRuns::Execute(two), kinds / 8, second, checks);
}
