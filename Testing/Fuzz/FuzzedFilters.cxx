// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FuzzedFilters.h"

#include "FilterRuns.h"
#include "FuzzedSurface.h"
#include "Meshes/PolyData.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompareDirectionFields.h"
#include "vtkDirectionField.h"
#include "vtkDirectionFieldGlyphs.h"
#include "vtkDirectionFieldSingularities.h"
#include "vtkDirectionFieldStreamlines.h"
#include "vtkDoubleArray.h"
#include "vtkFieldAlignedRemesh.h"
#include "vtkFieldData.h"
#include "vtkGuidanceCurves.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStripePattern.h"

#include <algorithm>
#include <cmath>
#include <random>

using FilterRuns::Filter;
using FilterRuns::MeshPointer;
using FilterRuns::Outcome;

namespace
{
/// Each of two filters has so many bytes of options, the field and what is checked the last ones.
constexpr std::size_t FilterSize = 12;
constexpr std::size_t FieldAt = 2 * FilterSize;
constexpr std::size_t HeadSize = 32;

/// The bytes of the options of one filter.
struct OptionBytes
{
  const Bytes& All;
  std::size_t First;
  /// The length of the mesh's box.
  double Size;

  unsigned operator[](std::size_t i) const { return this->All.At(this->First + i); }
  bool Bit(std::size_t i, unsigned bit) const { return ((*this)[i] >> bit) % 2 != 0; }
  /// 0, a part of the size from 0.02 to 2, or now and then a number that breaks computations.
  double Length(std::size_t i) const
  {
    const unsigned byte = (*this)[i];
    return byte >= 240 ? Special(byte)
      : byte == 0      ? 0.0
                       : this->Size * 0.02 * std::pow(100.0, byte / 240.0);
  }
};

/// The length of the box; 0 where there is none.
double SizeOf(vtkPolyData* mesh)
{
  const double length = mesh->GetNumberOfPoints() > 0 ? mesh->GetLength() : 0.0;
  return std::isfinite(length) ? length : 0.0;
}

/// Directions and magnitudes that have nothing to do with the surface.
void AddRandomField(vtkPolyData* mesh, int degree, unsigned seed)
{
  std::minstd_rand random(seed + 1);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int k = 0; k <= degree; ++k)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(
      k < degree ? ("Direction" + std::to_string(k)).c_str() : "RepresentationMagnitude");
    array->SetNumberOfComponents(k < degree ? 3 : 1);
    array->SetNumberOfTuples(mesh->GetNumberOfPoints());
    for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
    {
      array->SetValue(i, k < degree ? uniform(random) : std::abs(uniform(random)));
    }
    mesh->GetPointData()->AddArray(array);
  }
}

/// A number of the field becomes another one.
void Damage(vtkPolyData* field, unsigned where, unsigned number)
{
  vtkDataArray* const array =
    field->GetPointData()->GetArray(where % 2 != 0 ? "Direction0" : "RepresentationMagnitude");
  if (array && array->GetNumberOfTuples() > 0)
  {
    array->SetComponent(
      where / 2 % array->GetNumberOfTuples(), 0, number % 17 == 16 ? 0.0 : Special(number));
  }
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
    vtkObject::SetGlobalWarningDisplay(0);
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

/// Some points of the mesh, or places beside it, as singularities.
MeshPointer SomePoints(vtkPolyData* mesh, const OptionBytes& options)
{
  auto points = MeshPointer::New();
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  vtkNew<vtkIntArray> indices;
  indices->SetName("SingularityIndex");
  for (unsigned k = 0; k < options[8] % 4 && mesh->GetNumberOfPoints() > 0; ++k)
  {
    double place[3];
    mesh->GetPoint((options[9] + 7 * k) % mesh->GetNumberOfPoints(), place);
    place[k] += options[10] >= 250 ? Special(options[10]) : 0.001 * options[10] * options.Size;
    places->InsertNextPoint(place);
    indices->InsertNextValue(
      options[11] >= 250 ? 1 << (options[11] - 240) : static_cast<int>((options[11] + k) % 5) - 2);
  }
  points->SetPoints(places);
  points->GetPointData()->AddArray(indices);
  return points;
}

Filter Streamlines(vtkPolyData* mesh, const OptionBytes& options)
{
  Filter filter;
  filter.Make = [options]
  {
    auto lines = vtkSmartPointer<vtkDirectionFieldStreamlines>::New();
    lines->SetSeedType(static_cast<int>(options[0] % 3));
    lines->SetStopAtCrossings(options.Bit(0, 3));
    lines->SetIntegrationDirection(static_cast<int>(options[0] / 16 % 3));
    lines->SetSeparatingDistance(options.Length(1));
    lines->SetSeparatingDistanceRatio(0.1 + 0.003 * options[2]);
    lines->SetMaximumStreamlineLength(options.Length(3));
    lines->SetMinimumStreamlineLength(options[4] < 128 ? 0.0 : options.Length(4));
    lines->SetMaximumNumberOfLines(1 + static_cast<int>(options[5] % 64));
    lines->SetOffset(options[6] < 240 ? 0.01 * options[6] - 1.0 : Special(options[6]));
    return lines;
  };
  filter.Inputs = { mesh, options.Bit(7, 0) ? SomePoints(mesh, options) : nullptr };
  return filter;
}

Filter Edits(vtkPolyData* mesh, const OptionBytes& options)
{
  Filter filter;
  filter.Make = [options]
  {
    auto edit = vtkSmartPointer<vtkDirectionFieldSingularities>::New();
    edit->SetSingularityMode(static_cast<int>(options[0] % 2));
    edit->SetObjective(static_cast<int>(options[0] / 2 % 2));
    edit->SetBalanceAutomatically(options.Bit(0, 2));
    edit->SetRefineWhereNeeded(options.Bit(0, 3) && options.Bit(0, 4));
    edit->SetKeepConstraints(!options.Bit(0, 5));
    edit->SetAlignment(static_cast<int>(options[1] % 3));
    edit->SetAlignmentStrength(options[2] / 255.0);
    edit->SetGuidanceVectors(options[1] < 128 ? "Direction0" : "GuidanceVectors");
    edit->SetKeepStages(options.Bit(7, 1));
    return edit;
  };
  filter.Inputs = { mesh, options[7] % 4 != 0 ? SomePoints(mesh, options) : nullptr };
  return filter;
}

Filter Comparison(vtkPolyData* mesh, const OptionBytes& options)
{
  Filter filter;
  filter.Make = [options]
  {
    auto comparison = vtkSmartPointer<vtkCompareDirectionFields>::New();
    comparison->SetMatchSingularities(!options.Bit(0, 0));
    comparison->SetDivergenceAndCurl(options.Bit(0, 1));
    return comparison;
  };
  auto other = MeshPointer::New();
  other->DeepCopy(mesh);
  const unsigned kind = options[1] % 4;
  if (kind == 1)
  {
    vtkNew<vtkDirectionField> field;
    field->SetDegree(1 + static_cast<int>(options[2] % 6));
    field->SetNumberOfThreads(1);
    field->SetConstrainBoundary(true);
    field->SetInputData(mesh);
    field->Update();
    other->DeepCopy(field->GetOutput());
  }
  else if (kind == 2)
  {
    int degree = 0;
    while (mesh->GetPointData()->HasArray(("Direction" + std::to_string(degree)).c_str()))
    {
      ++degree;
    }
    AddRandomField(other, degree, options[2]);
  }
  else if (kind == 3)
  {
    Damage(other, options[2], options[3]);
  }
  filter.Inputs = { mesh, other };
  return filter;
}

Filter Glyphs(vtkPolyData* mesh, const OptionBytes& options)
{
  Filter filter;
  filter.Make = [options]
  {
    auto glyphs = vtkSmartPointer<vtkDirectionFieldGlyphs>::New();
    glyphs->SetGlyphType(static_cast<int>(options[0] % 5));
    glyphs->SetGlyphMode(static_cast<int>(options[0] / 8 % 2));
    glyphs->SetFollowSurface(options.Bit(0, 4));
    glyphs->SetSide(static_cast<int>(options[1] % 4));
    glyphs->SetSpacing(options.Length(2));
    glyphs->SetMaximumNumberOfGlyphs(1 + static_cast<int>(options[3] % 60));
    return glyphs;
  };
  filter.Inputs = { mesh };
  return filter;
}

Filter Stripes(vtkPolyData* mesh, const OptionBytes& options)
{
  Filter filter;
  filter.Make = [options]
  {
    auto stripes = vtkSmartPointer<vtkStripePattern>::New();
    stripes->SetStripeDirection(static_cast<int>(options[0] % 2));
    stripes->SetTextureCoordinates(options.Bit(0, 1));
    stripes->SetBands(!options.Bit(0, 2));
    stripes->SetSpacing(options.Length(1));
    return stripes;
  };
  filter.Inputs = { mesh };
  return filter;
}

Filter Curves(vtkPolyData* mesh, vtkPolyData* curves, const OptionBytes& options)
{
  Filter filter;
  filter.Make = [options]
  {
    auto guidance = vtkSmartPointer<vtkGuidanceCurves>::New();
    guidance->SetDegree(1 + static_cast<int>(options[0] % 6));
    guidance->SetRadius(options.Length(1));
    guidance->SetMaximumDistance(options.Length(2));
    return guidance;
  };
  filter.Inputs = { mesh, curves };
  return filter;
}

Filter Remesh(vtkPolyData* mesh, const OptionBytes& options)
{
  Filter filter;
  filter.Make = [options]
  {
    auto remesh = vtkSmartPointer<vtkFieldAlignedRemesh>::New();
    remesh->SetElement(static_cast<int>(options[0] % 2));
    remesh->SetPureQuads(options.Bit(0, 1));
    remesh->SetKeepFeatures(!options.Bit(0, 2));
    remesh->SetNumberOfFaces(1 + static_cast<int>(options[1]));
    remesh->SetSmoothingIterations(static_cast<int>(options[2] % 4));
    remesh->SetFeatureAngle(options[3] < 128 ? 30.0 : options[3] - 120.0);
    return remesh;
  };
  filter.Inputs = { mesh };
  return filter;
}

Filter Field(vtkPolyData* mesh, const OptionBytes& options)
{
  Filter filter;
  filter.Make = [options]
  {
    auto field = vtkSmartPointer<vtkDirectionField>::New();
    field->SetDegree(1 + static_cast<int>(options[0] % 6));
    field->SetAlignment(static_cast<int>(options[1] % 3));
    field->SetConstrainBoundary(options.Bit(1, 2));
    field->SetConstrainSharpEdges(options.Bit(1, 3));
    field->SetConstrainGuidance(options.Bit(1, 4));
    field->SetUnitLength(options.Bit(1, 5));
    field->SetCellDirections(options.Bit(1, 6));
    field->SetConstrainCurvature(options.Bit(1, 7));
    field->SetGuidanceVectors(options.Bit(2, 0) ? "GuidanceVectors" : "Direction0");
    field->SetIntrinsicDelaunay(options.Bit(2, 1));
    return field;
  };
  filter.Inputs = { mesh };
  return filter;
}

/// @param kind   which filter
/// @param mesh   its first input
/// @param second its second one, where that is lines or points
Filter AnyFilter(unsigned kind, vtkPolyData* mesh, vtkPolyData* second, const OptionBytes& options)
{
  switch (kind % 8)
  {
    case 0:
      return Streamlines(mesh, options);
    case 1:
    {
      Filter edits = Edits(mesh, options);
      edits.Inputs[1] = options.Bit(7, 2) ? MeshPointer(second) : edits.Inputs[1];
      return edits;
    }
    case 2:
      return Comparison(mesh, options);
    case 3:
      return Glyphs(mesh, options);
    case 4:
      return Stripes(mesh, options);
    case 5:
      return Curves(mesh, second, options);
    case 6:
      return Remesh(mesh, options);
    default:
      return Field(mesh, options);
  }
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

std::string FuzzedFilters(FilterGroup group, const std::uint8_t* data, std::size_t size)
{
  Bytes bytes(data, size);
  vtkObject::SetGlobalWarningDisplay(0);
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
  const OptionBytes first{ head, 0, SizeOf(field) };
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
  const OptionBytes second{ head, FilterSize, first.Size };
  // The lines of one filter are curves for the next, and points its singularities.
  const bool areLines = kind % 8 == 0;
  const MeshPointer other = outcome.Outputs.back();
  const Filter two =
    AnyFilter(kinds / 8, areLines && kinds >= 128 ? field : outcome.Outputs.front(),
      areLines ? outcome.Outputs.front() : other, second);
  return FlawOf(two, FilterRuns::Execute(two), kinds / 8, second, checks);
}
