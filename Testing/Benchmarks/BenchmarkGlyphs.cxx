// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The time of the glyph filter on a torus of a million points, beside a pass over all points and
// vtkGlyph3D with as many arrows in the same run.

#include "vtkDirectionFieldGlyphs.h"

#include "vtkArrowSource.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkGlyph3D.h"
#include "vtkIdTypeArray.h"
#include "vtkMaskPoints.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <string>

namespace
{
/// A torus of size^2 points with a cross field that winds around it.
vtkPolyData* Torus(int size)
{
  static vtkNew<vtkPolyData> torus;
  if (torus->GetNumberOfPoints() == static_cast<vtkIdType>(size) * size)
  {
    return torus;
  }
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkFloatArray> magnitude;
  magnitude->SetName("RepresentationMagnitude");
  vtkNew<vtkFloatArray> direction[4];
  for (int k = 0; k < 4; ++k)
  {
    direction[k]->SetName(("Direction" + std::to_string(k)).c_str());
    direction[k]->SetNumberOfComponents(3);
  }
  const double step = 2.0 * vtkMath::Pi() / size;
  for (int i = 0; i < size; ++i)
  {
    const double u = step * i;
    for (int j = 0; j < size; ++j)
    {
      const double v = step * j;
      const double radius = 1.0 + 0.4 * std::cos(v);
      points->InsertNextPoint(radius * std::cos(u), radius * std::sin(u), 0.4 * std::sin(v));
      magnitude->InsertNextValue(static_cast<float>(1.0 + 0.5 * std::sin(3.0 * u)));
      for (int k = 0; k < 4; ++k)
      {
        const double turn = 0.5 * std::sin(u) + 0.5 * vtkMath::Pi() * k;
        const double around = std::cos(turn), across = std::sin(turn);
        direction[k]->InsertNextTuple3(-around * std::sin(u) - across * std::sin(v) * std::cos(u),
          around * std::cos(u) - across * std::sin(v) * std::sin(u), across * std::cos(v));
      }
      const vtkIdType a = static_cast<vtkIdType>(i) * size + j;
      const vtkIdType b = static_cast<vtkIdType>((i + 1) % size) * size + j;
      const vtkIdType c = static_cast<vtkIdType>((i + 1) % size) * size + (j + 1) % size;
      const vtkIdType d = static_cast<vtkIdType>(i) * size + (j + 1) % size;
      triangles->InsertNextCell({ a, b, c });
      triangles->InsertNextCell({ a, c, d });
    }
  }
  torus->Initialize();
  torus->SetPoints(points);
  torus->SetPolys(triangles);
  torus->GetPointData()->AddArray(magnitude);
  for (auto& array : direction)
  {
    torus->GetPointData()->AddArray(array);
  }
  torus->GetPointData()->SetActiveVectors("Direction0");
  return torus;
}

void Glyphs(benchmark::State& state)
{
  vtkPolyData* torus = Torus(static_cast<int>(state.range(0)));
  vtkNew<vtkDirectionFieldGlyphs> filter;
  filter->SetInputData(torus);
  filter->SetMaximumNumberOfGlyphs(static_cast<int>(state.range(1)));
  filter->SetGlyphType(static_cast<int>(state.range(2)));
  filter->SetGlyphMode(static_cast<int>(state.range(3)));
  const bool keep = state.range(4) != 0;
  filter->Update();
  for (auto _ : state)
  {
    if (!keep)
    {
      filter->ReleaseSurfaces();
    }
    filter->Modified();
    filter->Update();
  }
  state.counters["glyphs"] =
    filter->GetOutput()->GetFieldData()->GetArray("NumberOfGlyphs")->GetTuple1(0);
}

/// One pass of common VTK filters over the same surface: point normals.
void PointNormals(benchmark::State& state)
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(Torus(static_cast<int>(state.range(0))));
  normals->SplittingOff();
  normals->ConsistencyOff();
  for (auto _ : state)
  {
    normals->Modified();
    normals->Update();
  }
}

/// vtkGlyph3D with one arrow at each of some points, not all directions and not evenly spread.
void Glyph3D(benchmark::State& state)
{
  vtkPolyData* torus = Torus(static_cast<int>(state.range(0)));
  vtkNew<vtkMaskPoints> mask;
  mask->SetInputData(torus);
  mask->SetOnRatio(static_cast<int>(torus->GetNumberOfPoints() / state.range(1)));
  mask->SetMaximumNumberOfPoints(state.range(1));
  vtkNew<vtkArrowSource> arrow;
  vtkNew<vtkGlyph3D> glyph;
  glyph->SetInputConnection(mask->GetOutputPort());
  glyph->SetSourceConnection(arrow->GetOutputPort());
  glyph->SetScaleFactor(0.01);
  for (auto _ : state)
  {
    mask->Modified();
    glyph->Update();
  }
}
}

// Points along each circle, most glyphs, type, mode, and whether the places of the run before are kept.
BENCHMARK(Glyphs)
  ->Args({ 1000, 20000, 0, 0, 0 })
  ->Args({ 1000, 20000, 0, 0, 1 })
  ->Args({ 1000, 20000, 4, 0, 0 })
  ->Args({ 1000, 2000, 0, 0, 0 })
  ->Args({ 1000, 2000, 0, 0, 1 })
  ->Args({ 1000, 20000, 0, 1, 0 })
  ->Args({ 500, 20000, 0, 0, 0 })
  ->Unit(benchmark::kMillisecond);
BENCHMARK(PointNormals)->Args({ 1000 })->Unit(benchmark::kMillisecond);
BENCHMARK(Glyph3D)->Args({ 1000, 20000 })->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
