// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSurfaceStrokes.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <cstddef>

vtkStandardNewMacro(vtkSurfaceStrokes);

//------------------------------------------------------------------------------
vtkSurfaceStrokes::vtkSurfaceStrokes()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkSurfaceStrokes::~vtkSurfaceStrokes() = default;

//------------------------------------------------------------------------------
void vtkSurfaceStrokes::AddPoint(double stroke, double x, double y, double z)
{
  this->Points.push_back({ stroke, x, y, z });
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSurfaceStrokes::RemoveAllPoints()
{
  if (!this->Points.empty())
  {
    this->Points.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkSurfaceStrokes::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkPolyData* const output = vtkPolyData::GetData(outputVector, 0);
  vtkInformation* const information = outputVector->GetInformationObject(0);
  if (information->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) > 0)
  {
    return 1;
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkIdTypeArray> strokes;
  strokes->SetName("Stroke");
  const std::size_t size = this->Points.size();
  for (std::size_t begin = 0, end = 0; begin < size; begin = end)
  {
    while (end < size && this->Points[end][0] == this->Points[begin][0])
    {
      ++end;
    }
    if (end - begin < 2)
    {
      continue;
    }
    lines->InsertNextCell(static_cast<int>(end - begin));
    for (std::size_t k = begin; k < end; ++k)
    {
      lines->InsertCellPoint(points->InsertNextPoint(&this->Points[k][1]));
    }
    strokes->InsertNextValue(static_cast<vtkIdType>(this->Points[begin][0]));
  }
  output->SetPoints(points);
  output->SetLines(lines);
  output->GetCellData()->AddArray(strokes);
  return 1;
}

//------------------------------------------------------------------------------
void vtkSurfaceStrokes::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Points: " << this->Points.size() << "\n";
}
