// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The costs of stripes, as ratios within one run:
//
//   BenchmarkStripes [TRIANGLES]
//
// Prints the time of stripes at the default spacing beside that of the smoothest field, for vector and line fields, and
// the most memory that the process has held after each; and beside the misfit of the pattern that of the published one,
// the smallest eigenvector, on a small mesh.

#include "BenchmarkMeshes.h"
#include "Computation/SmoothestField.h"
#include "Meshes/Fields.h"
#include "Meshes/Surfaces.h"
#include "Stripes/PhaseDiffusion.h"

#include "vtkDirectionField.h"
#include "vtkStripePattern.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <utility>
#include <vector>

namespace
{
double Now()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// The time of an update, on the clock and of all processors, which other programs disturb less.
struct Times
{
  explicit Times(vtkAlgorithm* filter)
  {
    const double start = Now();
    const std::clock_t processors = std::clock();
    filter->Update();
    this->Clock = Now() - start;
    this->Processors = static_cast<double>(std::clock() - processors) / CLOCKS_PER_SEC;
  }
  double Clock;
  double Processors;
};

/// The most memory that the process has held so far, in MB.
double PeakMemory()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

void CompareWithField(vtkPolyData* surface, int degree)
{
  vtkNew<vtkDirectionField> filter;
  filter->SetInputData(surface);
  filter->SetDegree(degree);
  const Times ofField(filter);
  vtkNew<vtkPolyData> field;
  field->ShallowCopy(filter->GetOutput());
  const double fieldMemory = PeakMemory();
  vtkNew<vtkStripePattern> stripes;
  stripes->SetInputData(field);
  const Times ofStripes(stripes);
  const double memory = PeakMemory();
  const auto figure = [&](const char* name)
  { return stripes->GetOutput()->GetFieldData()->GetArray(name)->GetTuple1(0); };
  std::cout << surface->GetNumberOfPolys() << " triangles, degree " << degree << ": field "
            << ofField.Clock << " s and " << fieldMemory << " MB; stripes " << ofStripes.Clock
            << " s and " << memory << " MB: " << ofStripes.Clock / ofField.Clock
            << " times the time, " << ofStripes.Processors / ofField.Processors
            << " times that of the processors, " << memory / fieldMemory << " times the memory; "
            << stripes->GetOutput(0)->GetNumberOfCells() << " lines, "
            << stripes->GetOutput(1)->GetNumberOfCells() << " polygons, misfit " << figure("Misfit")
            << ", " << figure("BranchPoints") << " branch points\n";
}

/// The misfit of the smallest eigenvector, and its time, against the relaxed phases.
void CompareWithEigenvector(double spacing)
{
  using namespace DirectionFields;
  const Surface surface = Meshes::Potato(5);
  const Result result = Fields::Compute(surface, 1);
  const GivenField field(surface, Fields::Of(result));
  const WantedPhases wanted(
    field, StripeDirection::Along, [spacing](Index) { return 1.0 / spacing; });
  const PhaseDiffusion relaxation(wanted, wanted.GetComponents()[0]);
  double start = Now();
  ComplexVector psi = relaxation.Start();
  relaxation.Relax({}, psi);
  const double relaxed = Now() - start;
  start = Now();
  EigenpairSettings settings;
  settings.Scale = relaxation.GetDensity();
  const SmallestPairs pairs = FindSmallestPairs(
    relaxation.GetMatrices(), [&] { return relaxation.Start(); }, Solver::Multigrid, settings, {});
  const double eigenvector = Now() - start;
  const double largest = pairs.First.Vector.cwiseAbs().maxCoeff();
  std::cout << surface.Triangles.size() << " triangles, spacing " << spacing << ": misfit "
            << Misfit(wanted, relaxation.Phases(psi)) << " in " << relaxed
            << " s, of the smallest eigenvector "
            << Misfit(wanted, relaxation.Phases(pairs.First.Vector)) << " in " << eigenvector
            << " s, whose modulus falls to " << pairs.First.Vector.cwiseAbs().minCoeff() / largest
            << " of its largest\n";
}
}

int main(int argc, char* argv[])
{
  const int triangles = argc > 1 ? std::atoi(argv[1]) : 400000;
  for (const double spacing : { 0.3, 0.1 })
  {
    CompareWithEigenvector(spacing);
  }
  const auto surface = BenchmarkMeshes::Potato(triangles);
  for (const int degree : { 1, 2 })
  {
    CompareWithField(surface, degree);
  }
  return EXIT_SUCCESS;
}
