// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The costs of a mesh of quads, as ratios to the smoothest field of the same surface within one run:
//
//   BenchmarkRemesh [MOST_TRIANGLES]
//
// For surfaces of 20 000 triangles and more, up to a number (1 600 000), and several numbers of faces: the time of
// the mesh, that of the field, their ratio, the memory that the mesh takes for each triangle, and the part of the
// time that it takes once more for other lengths of edges.

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

struct Size
{
  int Triangles;
  int Faces;
};

void Measure(const Size& size)
{
  const auto surface = BenchmarkMeshes::Make(std::to_string(size.Triangles));
  double fieldTime = 0.0;
  {
    vtkNew<vtkDirectionField> field;
    field->SetInputData(surface);
    field->SetDegree(4);
    fieldTime = TimeOf(field);
  }
  vtkNew<vtkFieldAlignedRemesh> remesh;
  remesh->SetInputData(surface);
  remesh->SetNumberOfFaces(size.Faces);
  ForgetPeak();
  const double before = MemoryStatus("VmRSS");
  const double time = TimeOf(remesh);
  const auto triangles = static_cast<double>(surface->GetNumberOfPolys());
  const double memory = (MemoryStatus("VmHWM") - before) / triangles;
  const vtkIdType faces = remesh->GetOutput(0)->GetNumberOfPolys();
  remesh->SetNumberOfFaces(size.Faces * 4 / 5);
  const double again = TimeOf(remesh);
  std::cout << std::setw(9) << surface->GetNumberOfPolys() << std::setw(9) << faces << std::fixed
            << std::setprecision(2) << std::setw(9) << time << std::setw(9) << fieldTime
            << std::setw(8) << time / fieldTime << std::setw(8) << memory / 1000.0 << std::setw(8)
            << again / time << "\n"
            << std::flush;
}
}

int main(int argc, char* argv[])
{
  const int most = argc > 1 ? std::atoi(argv[1]) : 1600000;
  std::cout << "triangles    faces   mesh/s  field/s   ratio    kB/t   again\n";
  for (const Size& size : { Size{ 20000, 5000 }, { 100000, 5000 }, { 100000, 100000 },
         { 400000, 5000 }, { 1600000, 5000 } })
  {
    if (size.Triangles <= most)
    {
      Measure(size);
    }
  }
  return EXIT_SUCCESS;
}
