// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The costs of lines, as ratios within one run:
//
//   BenchmarkLines [TRIANGLES]
//
// Prints the time of evenly spaced lines at the default spacing beside that of the field; what a point
// of a line takes; how the time of reading the field back grows with the triangles; and as many points by
// vtkStreamTracer on the same surface.

#include "BenchmarkMeshes.h"

#include "vtkDirectionField.h"
#include "vtkDirectionFieldStreamlines.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamTracer.h"

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <string>

namespace
{
double Now()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double TimeOf(vtkAlgorithm* filter)
{
  filter->Modified();
  const double start = Now();
  filter->Update();
  return Now() - start;
}

/// The time of the processors that this program has taken: on a machine that does other things too, only this
/// can be compared.
double ProcessorTime()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// The time of a filter that has nothing to trace: reading the surface and the field.
double SetupTime(vtkPolyData* field)
{
  vtkNew<vtkDirectionFieldStreamlines> lines;
  vtkNew<vtkPolyData> nothing;
  lines->SetInputData(0, field);
  lines->SetInputData(1, nothing);
  lines->SetSeedType(vtkDirectionFieldStreamlines::POINTS);
  TimeOf(lines);
  return TimeOf(lines);
}

vtkSmartPointer<vtkPolyData> FieldOf(int triangles, double& time, double& processorTime)
{
  vtkNew<vtkDirectionField> filter;
  filter->SetInputData(BenchmarkMeshes::Potato(triangles));
  filter->SetDegree(4);
  const double before = ProcessorTime();
  time = TimeOf(filter);
  processorTime = ProcessorTime() - before;
  vtkNew<vtkPolyData> field;
  field->ShallowCopy(filter->GetOutput());
  return field.GetPointer();
}

/// Lines from the same points, of the same length, by VTK's own tracer and by ours.
void CompareStreamTracer(vtkPolyData* field, vtkPolyData* lines, double setup)
{
  vtkNew<vtkPoints> begins;
  double length = 0.0;
  vtkDataArray* lengths = lines->GetCellData()->GetArray("Length");
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < lines->GetNumberOfCells(); ++i)
  {
    lines->GetCellPoints(i, ids);
    begins->InsertNextPoint(lines->GetPoint(ids->GetId(ids->GetNumberOfIds() / 2)));
    length += lengths->GetTuple1(i);
  }
  const double mean = length / static_cast<double>(lines->GetNumberOfCells());
  vtkNew<vtkPolyData> seeds;
  seeds->SetPoints(begins);
  vtkNew<vtkDirectionFieldStreamlines> ours;
  ours->SetInputData(0, field);
  ours->SetInputData(1, seeds);
  ours->SetSeedType(vtkDirectionFieldStreamlines::POINTS);
  ours->SetMaximumStreamlineLength(mean);
  const double ourTime = TimeOf(ours) - setup;
  const double ourPoint = ourTime / static_cast<double>(ours->GetOutput(0)->GetNumberOfPoints());
  vtkNew<vtkPolyData> vectors;
  vectors->ShallowCopy(field);
  vectors->GetPointData()->SetActiveVectors("Direction0");
  vtkNew<vtkStreamTracer> tracer;
  tracer->SetInputData(vectors);
  tracer->SetSourceData(seeds);
  tracer->SetSurfaceStreamlines(true);
  tracer->SetIntegrationDirectionToBoth();
  tracer->SetIntegratorTypeToRungeKutta4();
  tracer->SetIntegrationStepUnit(vtkStreamTracer::LENGTH_UNIT);
  tracer->SetInitialIntegrationStep(length / static_cast<double>(lines->GetNumberOfPoints()));
  tracer->SetMaximumPropagation(0.5 * mean);
  tracer->SetMaximumNumberOfSteps(1000000);
  const double theirTime = TimeOf(tracer);
  const double theirPoint =
    theirTime / static_cast<double>(tracer->GetOutput()->GetNumberOfPoints());
  std::cout << "vtkStreamTracer from the same points: " << 1e6 * theirPoint << " us a point, ours "
            << 1e6 * ourPoint << " us: " << theirPoint / ourPoint << " times faster\n";
}
}

int main(int argc, char* argv[])
{
  const int triangles = argc > 1 ? std::atoi(argv[1]) : 1600000;
  double fieldTime = 0.0;
  double fieldProcessor = 0.0;
  const auto field = FieldOf(triangles, fieldTime, fieldProcessor);
  vtkNew<vtkDirectionFieldStreamlines> lines;
  lines->SetInputData(field);
  const double before = ProcessorTime();
  const double evenly = TimeOf(lines);
  const double evenlyProcessor = ProcessorTime() - before;
  const double points = lines->GetOutput(0)->GetNumberOfPoints();
  std::cout << field->GetNumberOfPolys() << " triangles: field " << fieldTime
            << " s, evenly spaced lines " << evenly << " s, " << evenly / fieldTime
            << " of the field; " << lines->GetOutput(0)->GetNumberOfCells() << " lines, " << points
            << " points\n"
            << "processor time: field " << fieldProcessor << " s, evenly spaced lines "
            << evenlyProcessor << " s, " << evenlyProcessor / fieldProcessor << " of the field\n";
  double smallTime = 0.0;
  double smallProcessor = 0.0;
  const auto small = FieldOf(triangles / 4, smallTime, smallProcessor);
  const double beforeSetup = ProcessorTime();
  const double setup = SetupTime(field);
  // It is run twice.
  const double setupProcessor = 0.5 * (ProcessorTime() - beforeSetup);
  const double smallSetup = SetupTime(small);
  std::cout << "reading the field back: " << setup << " s, of a quarter of the triangles "
            << smallSetup << " s: " << setup / smallSetup << " times as long\n";
  vtkNew<vtkDirectionFieldStreamlines> separatrices;
  separatrices->SetInputData(field);
  separatrices->SetSeedType(vtkDirectionFieldStreamlines::SINGULARITIES);
  const double traced = TimeOf(separatrices) - setup;
  const double perPoint =
    traced / static_cast<double>(separatrices->GetOutput(0)->GetNumberOfPoints());
  std::cout << "lines out of the singularities: " << separatrices->GetOutput(0)->GetNumberOfPoints()
            << " points, " << 1e6 * perPoint << " us each, on all threads\n"
            << "evenly spaced lines: " << 1e6 * (evenly - setup) / points << " us a point, "
            << 1e6 * (evenlyProcessor - setupProcessor) / points << " us of processor time\n";
  CompareStreamTracer(field, lines->GetOutput(0), setup);
  return EXIT_SUCCESS;
}
