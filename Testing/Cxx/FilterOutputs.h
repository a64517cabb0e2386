// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef FilterOutputs_h
#define FilterOutputs_h

#include "Checks.h"
#include "PolyMeshes.h"

#include "vtkCompareDirectionFields.h"
#include "vtkDirectionField.h"
#include "vtkDirectionFieldGlyphs.h"
#include "vtkDirectionFieldSingularities.h"
#include "vtkDirectionFieldStreamlines.h"
#include "vtkFieldAlignedRemesh.h"
#include "vtkGuidanceCurves.h"
#include "vtkStripePattern.h"

#include <vector>

/// What the filters make of one surface.
namespace FilterOutputs
{
/// A bumpy closed surface, in double precision.
inline vtkSmartPointer<vtkPolyData> Sized(double size)
{
  auto mesh = PolyMeshes::Pebble(2, VTK_DOUBLE);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double point[3];
    mesh->GetPoint(i, point);
    vtkMath::MultiplyScalar(point, size);
    mesh->GetPoints()->SetPoint(i, point);
  }
  return mesh;
}

inline vtkSmartPointer<vtkPolyData> Field(vtkPolyData* mesh, int degree)
{
  vtkNew<vtkDirectionField> filter;
  filter->SetDegree(degree);
  filter->SetInputData(mesh);
  filter->Update();
  return filter->GetOutput();
}

/// All outputs of all filters on a surface of a size.
inline std::vector<vtkSmartPointer<vtkPolyData>> OutputsAt(double size)
{
  const auto cross = Field(Sized(size), 4);
  const auto lines = Field(Sized(size), 2);
  vtkNew<vtkDirectionFieldStreamlines> curves;
  curves->SetSeedType(vtkDirectionFieldStreamlines::SINGULARITIES);
  curves->SetMaximumStreamlineLength(size);
  std::vector<vtkSmartPointer<vtkPolyData>> outputs;
  vtkNew<Checks::Messages> messages;
  const auto add = [&](vtkPolyDataAlgorithm* filter, vtkPolyData* input, vtkPolyData* second)
  {
    messages->Observe(filter);
    filter->SetInputDataObject(0, input);
    if (second)
    {
      filter->SetInputDataObject(1, second);
    }
    filter->Update();
    for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
    {
      outputs.emplace_back(filter->GetOutput(port));
    }
  };
  add(curves, cross, nullptr);
  vtkNew<vtkDirectionField> aligned;
  aligned->SetAlignment(vtkDirectionField::ALIGN_PRINCIPAL_CURVATURE);
  add(aligned, cross, nullptr);
  add(vtkNew<vtkDirectionFieldGlyphs>(), cross, nullptr);
  add(vtkNew<vtkDirectionFieldStreamlines>(), cross, nullptr);
  vtkNew<vtkStripePattern> stripes;
  stripes->SetSpacing(0.3 * size);
  add(stripes, lines, nullptr);
  add(vtkNew<vtkDirectionFieldSingularities>(), cross, nullptr);
  add(vtkNew<vtkCompareDirectionFields>(), cross, aligned->GetOutput());
  vtkNew<vtkGuidanceCurves> guidance;
  guidance->SetRadius(0.2 * size);
  add(guidance, cross, curves->GetOutput());
  vtkNew<vtkFieldAlignedRemesh> remesh;
  remesh->SetNumberOfFaces(200);
  add(remesh, cross, nullptr);
  CHECK(messages->IsEmpty());
  return outputs;
}
}

#endif
