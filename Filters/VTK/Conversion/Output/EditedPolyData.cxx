// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Conversion/Output/EditedPolyData.h"

#include "Conversion/Input/FieldArrays.h"
#include "Conversion/Output/FieldToPolyData.h"
#include "Conversion/Output/SingularityPoints.h"

#include <DirectionFields/Distance/ClosestPoints.h>

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

namespace DirectionFields
{
namespace
{
/// Indices beyond this are a mistake.
constexpr double MostIndex = 1e6;

void AddWanted(vtkPointSet* points, std::vector<WantedSingularity>& wanted)
{
  if (!points || points->GetNumberOfPoints() == 0)
  {
    return;
  }
  vtkDataArray* const indices = points->GetPointData()->GetArray(ArrayNames::SingularityIndex);
  if (indices && indices->GetNumberOfComponents() != 1)
  {
    throw std::invalid_argument(
      "The array \"SingularityIndex\" of the singularities must have 1 component.");
  }
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    WantedSingularity singularity;
    points->GetPoint(i, singularity.Position.data());
    const double index = indices ? indices->GetComponent(i, 0) : 1.0;
    if (!(std::abs(index) <= MostIndex) || index != std::round(index))
    {
      throw std::invalid_argument(
        "The array \"SingularityIndex\" of the singularities must have whole numbers, in units "
        "of 1/n; point " +
        std::to_string(i) + " has " + std::to_string(index) + ".");
    }
    singularity.Index = static_cast<int>(index);
    wanted.push_back(singularity);
  }
}

std::vector<vtkDataObject*> ObjectsOf(vtkCompositeDataSet* composite)
{
  std::vector<vtkDataObject*> objects;
  vtkSmartPointer<vtkCompositeDataIterator> at;
  at.TakeReference(composite->NewIterator());
  for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
  {
    objects.push_back(at->GetCurrentDataObject());
  }
  return objects;
}

/// Reports of the input about its points that hold for the edited field, too.
void KeepArrays(vtkPolyData* input, vtkPolyData* output)
{
  if (input->GetNumberOfPoints() != output->GetNumberOfPoints())
  {
    return;
  }
  for (const char* name : { ArrayNames::ConstraintKind, ArrayNames::ConstraintDirection,
         ArrayNames::PrincipalDirection0, ArrayNames::PrincipalDirection1,
         ArrayNames::MeanCurvature, ArrayNames::GaussianCurvature, ArrayNames::OriginalPointIds })
  {
    if (vtkAbstractArray* const array = input->GetPointData()->GetAbstractArray(name))
    {
      output->GetPointData()->AddArray(array);
    }
  }
}

/// Whether each output point belongs to a component whose field is another one.
std::vector<char> ChangedPoints(
  const TriangulatedPolyData& surface, const Result& field, const EditedField& edited)
{
  std::vector<char> isChanged(field.Representation.size(), 0);
  const std::vector<Triangle>& triangles =
    field.SplitTriangles.empty() ? surface.Mesh.Triangles : field.SplitTriangles;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    if (field.Component[t] != None && edited.Components[field.Component[t]].IsChanged)
    {
      for (const Index i : triangles[t])
      {
        isChanged[i] = 1;
      }
    }
  }
  return isChanged;
}

/// Gives the points of components that keep their field the very numbers of the input: numbers
/// computed from the representation vectors differ by rounding.
void KeepDirections(const TriangulatedPolyData& surface, const Result& field,
  const EditedField& edited, vtkPolyData* input, vtkPolyData* output)
{
  const std::vector<char> isChanged = ChangedPoints(surface, field, edited);
  std::vector<std::string> names = { ArrayNames::RepresentationMagnitude };
  for (int k = 0; k < field.Degree; ++k)
  {
    names.push_back(ArrayNames::Direction(k));
  }
  for (const std::string& name : names)
  {
    vtkDataArray* const from = input->GetPointData()->GetArray(name.c_str());
    vtkDataArray* const to = output->GetPointData()->GetArray(name.c_str());
    if (!from || !to || from->GetDataType() != to->GetDataType())
    {
      continue;
    }
    for (std::size_t i = 0; i < isChanged.size(); ++i)
    {
      if (!isChanged[i])
      {
        to->SetTuple(static_cast<vtkIdType>(i), field.OriginalPoint[i], from);
      }
    }
  }
}

/// Adds the figures of the edit, one tuple per component.
void AddFigures(const EditedField& edited, vtkFieldData* data)
{
  const std::size_t count = edited.Components.size();
  auto energy = MakeArray<vtkDoubleArray>("RotationEnergy", 1, count);
  auto maximum = MakeArray<vtkDoubleArray>("MaximumRotation", 1, count);
  auto wrong = MakeArray<vtkIntArray>("WrongTriangles", 1, count);
  auto turning = MakeArray<vtkIntArray>("TurningNumbers", 2, 0);
  turning->SetComponentName(0, "Component");
  turning->SetComponentName(1, "TurningNumber");
  for (std::size_t c = 0; c < count; ++c)
  {
    const EditedComponent& component = edited.Components[c];
    const auto tuple = static_cast<vtkIdType>(c);
    energy->SetValue(tuple, component.Energy);
    maximum->SetValue(tuple, component.MaximumRotation);
    wrong->SetValue(tuple, component.WrongTriangles);
    for (const int number : component.TurningNumbers)
    {
      turning->InsertNextTuple2(static_cast<double>(c), number);
    }
  }
  data->AddArray(energy);
  data->AddArray(maximum);
  data->AddArray(wrong);
  data->AddArray(turning);
}
}

std::vector<WantedSingularity> WantedSingularities(vtkDataObject* points)
{
  std::vector<WantedSingularity> wanted;
  if (auto* const composite = vtkCompositeDataSet::SafeDownCast(points))
  {
    for (vtkDataObject* const object : ObjectsOf(composite))
    {
      AddWanted(vtkPointSet::SafeDownCast(object), wanted);
    }
  }
  else
  {
    AddWanted(vtkPointSet::SafeDownCast(points), wanted);
  }
  return wanted;
}

std::vector<std::vector<WantedSingularity>> WantedOfBlocks(
  const std::vector<vtkPolyData*>& blocks, vtkCompositeDataSet* input, vtkDataObject* points)
{
  std::vector<std::vector<WantedSingularity>> wanted(blocks.size());
  auto* const composite = vtkCompositeDataSet::SafeDownCast(points);
  if (composite && ObjectsOf(composite).size() == blocks.size())
  {
    vtkSmartPointer<vtkCompositeDataIterator> at;
    at.TakeReference(input->NewIterator());
    std::size_t k = 0;
    for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem(), ++k)
    {
      AddWanted(vtkPointSet::SafeDownCast(composite->GetDataSet(at)), wanted[k]);
    }
    return wanted;
  }
  const std::vector<WantedSingularity> all = WantedSingularities(points);
  std::vector<TriangulatedPolyData> surfaces(blocks.size());
  std::vector<std::unique_ptr<ClosestPoints>> nearest;
  for (std::size_t k = 0; k < blocks.size(); ++k)
  {
    if (blocks[k])
    {
      surfaces[k] = PolyDataToSurface(blocks[k]);
    }
    nearest.push_back(std::make_unique<ClosestPoints>(surfaces[k].Mesh));
  }
  for (const WantedSingularity& singularity : all)
  {
    double least = std::numeric_limits<double>::infinity();
    std::size_t block = blocks.size();
    for (std::size_t k = 0; k < blocks.size(); ++k)
    {
      const ClosestPoints::Answer found = nearest[k]->Find(singularity.Position);
      if (found.Triangle != None && found.SquaredDistance < least)
      {
        least = found.SquaredDistance;
        block = k;
      }
    }
    if (block < blocks.size())
    {
      wanted[block].push_back(singularity);
    }
  }
  return wanted;
}

void AddEditedField(const TriangulatedPolyData& surface, const EditedField& edited,
  const Result& field, const std::vector<std::string>& warnings, vtkPolyData* input,
  vtkPolyData* output, vtkPolyData* singularities, const Progress& progress)
{
  AddGivenField(surface, field, output, progress);
  KeepArrays(input, output);
  KeepDirections(surface, field, edited, input, output);
  AddFigures(edited, output->GetFieldData());
  AddReport(field.Repaired, warnings, output->GetFieldData());
  MakeSingularPoints(surface, field, FiguresOf(surface.Mesh, field.SingularityIndex),
    input->GetPoints() ? input->GetPoints()->GetDataType() : VTK_FLOAT, singularities);
}
}
