// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FuzzedOptions.h"

#include "Cxx/Checks.h"

#include "vtkCompareDirectionFields.h"
#include "vtkDirectionField.h"
#include "vtkDirectionFieldGlyphs.h"
#include "vtkDirectionFieldSingularities.h"
#include "vtkDirectionFieldStreamlines.h"
#include "vtkDoubleArray.h"
#include "vtkFieldAlignedRemesh.h"
#include "vtkGuidanceCurves.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStripePattern.h"

#include <cmath>
#include <random>
#include <string>

using FilterRuns::Filter;
using FilterRuns::MeshPointer;

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
    // Refined again and again, surfaces for large ones have 65 536 times as many triangles.
    indices->InsertNextValue(options[11] >= 250
        ? 1 << ((options[11] - 240) % (options.AreFew ? 6 : 16))
        : static_cast<int>((options[11] + k) % 5) - 2);
  }
  points->SetPoints(places);
  points->GetPointData()->AddArray(indices);
  return points;
}

namespace
{
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
    vtkNew<Checks::Messages> unheard;
    unheard->Observe(field);
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
    remesh->SetKeepSoftFeatures(!options.Bit(0, 3));
    remesh->SetNumberOfFaces(1 + static_cast<int>(options[1] / (options.AreFew ? 4 : 1)));
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
}

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
