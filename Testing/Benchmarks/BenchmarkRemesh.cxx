// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The costs of a mesh of quads, as ratios to the smoothest field of the same surface within one run:
//
//   BenchmarkRemesh [MOST_TRIANGLES]
//
// For surfaces of 20 000 triangles and more, up to a number (1 600 000), and several numbers of faces: the time of
// the mesh, that of the field, their ratio, the memory that the mesh takes for each triangle and face, and the part
// of the time that it takes once more for other lengths of edges. Above 20 000 also for surfaces that are hard to
// remesh: of noise, of many handles, and of long triangles.

#include "BenchmarkMeshes.h"

#include "vtkDirectionField.h"
#include "vtkFieldAlignedRemesh.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <string>

namespace
{
double TimeOf(vtkAlgorithm* filter)
{
  const auto start = std::chrono::steady_clock::now();
  filter->Update();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// A value of /proc/self/status in bytes; 0 where there is no such thing.
double MemoryStatus(const std::string& key)
{
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word)
  {
    double kilobytes = 0.0;
    if (word == key + ":" && status >> kilobytes)
    {
      return 1024.0 * kilobytes;
    }
  }
  return 0.0;
}

/// Lets the peak of memory begin anew (Linux).
void ForgetPeak()
{
  std::ofstream("/proc/self/clear_refs") << 5;
}

void Measure(const std::string& name, int wanted)
{
  const auto surface = BenchmarkMeshes::Make(name);
  double fieldTime = 0.0;
  {
    vtkNew<vtkDirectionField> field;
    field->SetInputData(surface);
    field->SetDegree(4);
    fieldTime = TimeOf(field);
  }
  vtkNew<vtkFieldAlignedRemesh> remesh;
  remesh->SetInputData(surface);
  remesh->SetNumberOfFaces(wanted);
  ForgetPeak();
  const double before = MemoryStatus("VmRSS");
  const double time = TimeOf(remesh);
  const vtkIdType faces = remesh->GetOutput(0)->GetNumberOfPolys();
  const auto cells = static_cast<double>(surface->GetNumberOfPolys() + faces);
  const double memory = (MemoryStatus("VmHWM") - before) / cells;
  remesh->SetNumberOfFaces(wanted * 4 / 5);
  const double again = TimeOf(remesh);
  std::cout << std::setw(9) << surface->GetNumberOfPolys() << std::setw(9) << faces << std::fixed
            << std::setprecision(2) << std::setw(9) << time << std::setw(9) << fieldTime
            << std::setw(8) << time / fieldTime << std::setw(8) << memory / 1000.0 << std::setw(8)
            << again / time << "  " << name << "\n"
            << std::flush;
}
}

int main(int argc, char* argv[])
{
  const int most = argc > 1 ? std::atoi(argv[1]) : 1600000;
  std::cout << "triangles    faces   mesh/s  field/s   ratio kB/cell   again  surface\n";
  struct Row
  {
    int Triangles;
    int Faces;
  };
  for (const Row& row : { Row{ 20000, 5000 }, { 100000, 5000 }, { 100000, 100000 },
         { 400000, 5000 }, { 1600000, 5000 } })
  {
    if (row.Triangles <= most)
    {
      Measure(std::to_string(row.Triangles), row.Faces);
    }
  }
  for (const char* name : { "noisy:20000:0.5", "noisy:20000:1", "gyroid:40000:4", "holes:2000:30" })
  {
    if (most > 20000)
    {
      Measure(name, 5000);
    }
  }
  return EXIT_SUCCESS;
}
