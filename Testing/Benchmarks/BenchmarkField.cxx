// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The time of each stage of a field, of other settings on kept stages, and of the whole filter.
//
//   BenchmarkField [MESH...] [Google Benchmark's options]
//
// MESH is a number of triangles or a file (see BenchmarkMeshes.h); without any, 10^4 to 6.4 10^6.

#include "BenchmarkMeshes.h"
#include "DirectionField.h"
#include "Eigenpairs/JacobiDavidson.h"
#include "Geometry/IntrinsicTriangulation.h"
#include "Geometry/SurfaceGeometry.h"
#include "Guidance/SurfaceTensors.h"
#include "Meshes/PolyData.h"
#include "Sections/Assembly.h"
#include "Support/Threads.h"

#include "vtkDirectionField.h"
#include "vtkDirectionFieldGlyphs.h"

#include "vtkNew.h"

#include <benchmark/benchmark.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

using namespace DirectionFields;

namespace
{
/// Meshes are made when they are first needed; one at a time is kept.
vtkPolyData* MeshOf(const std::string& name)
{
  static std::string last;
  static vtkSmartPointer<vtkPolyData> mesh;
  if (last != name || !mesh)
  {
    mesh = BenchmarkMeshes::Make(name);
    last = name;
  }
  return mesh;
}

const Surface& SurfaceOf(const std::string& name)
{
  static std::string last;
  static Surface surface;
  if (last != name)
  {
    surface = Meshes::ToSurface(MeshOf(name));
    last = name;
  }
  return surface;
}

void Count(benchmark::State& state, const std::string& mesh)
{
  const vtkIdType triangles = MeshOf(mesh)->GetNumberOfPolys();
  state.counters["triangles"] = static_cast<double>(triangles);
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * triangles);
}

void Setup(benchmark::State& state, const std::string& mesh)
{
  const Surface& surface = SurfaceOf(mesh);
  Threads threads;
  const Threads::Scope scope(threads);
  for (auto _ : state)
  {
    const SurfaceGeometry g(surface);
    benchmark::DoNotOptimize(g.Frames.X.data());
  }
  Count(state, mesh);
}

void Flips(benchmark::State& state, const std::string& mesh)
{
  Threads threads;
  const Threads::Scope scope(threads);
  const SurfaceGeometry g(SurfaceOf(mesh));
  for (auto _ : state)
  {
    const IntrinsicTriangulation flipped(g);
    state.counters["flips"] = flipped.NumberOfFlips;
  }
  Count(state, mesh);
}

/// The matrices of all components.
std::vector<Operators> Assembled(const SurfaceGeometry& g)
{
  std::vector<Operators> operators;
  for (const TriangleMesh::Component& component : g.Mesh.GetComponents())
  {
    operators.push_back(AssembleOperators(g, component, 4, 0.0));
  }
  return operators;
}

void Assembly(benchmark::State& state, const std::string& mesh)
{
  Threads threads;
  const Threads::Scope scope(threads);
  const SurfaceGeometry g(SurfaceOf(mesh));
  for (auto _ : state)
  {
    const std::vector<Operators> operators = Assembled(g);
    benchmark::DoNotOptimize(operators.data());
  }
  Count(state, mesh);
}

/// The order of magnitude of a component's smallest eigenvalue.
double ScaleOf(const SurfaceGeometry& g, std::size_t component)
{
  return 8.0 * Pi / g.Lengths.ComponentArea[component];
}

void BuildHierarchy(benchmark::State& state, const std::string& mesh)
{
  Threads threads;
  const Threads::Scope scope(threads);
  const SurfaceGeometry g(SurfaceOf(mesh));
  const std::vector<Operators> operators = Assembled(g);
  for (auto _ : state)
  {
    for (std::size_t c = 0; c < operators.size(); ++c)
    {
      const Hierarchy hierarchy(operators[c], ScaleOf(g, c));
      state.counters["complexity"] = hierarchy.OperatorComplexity();
    }
  }
  Count(state, mesh);
}

void Eigensolve(benchmark::State& state, const std::string& mesh)
{
  Threads threads;
  const Threads::Scope scope(threads);
  const SurfaceGeometry g(SurfaceOf(mesh));
  const std::vector<Operators> operators = Assembled(g);
  std::vector<std::unique_ptr<Hierarchy>> hierarchies;
  for (std::size_t c = 0; c < operators.size(); ++c)
  {
    hierarchies.push_back(std::make_unique<Hierarchy>(operators[c], ScaleOf(g, c)));
  }
  for (auto _ : state)
  {
    for (std::size_t c = 0; c < operators.size(); ++c)
    {
      EigenpairSettings settings;
      settings.Scale = ScaleOf(g, c);
      LowestSections lowest;
      const Eigenpair pair =
        SolveByJacobiDavidson(operators[c], *hierarchies[c], settings, {}, lowest);
      state.counters["iterations"] = pair.Iterations;
    }
  }
  Count(state, mesh);
}

/// Assembly and eigenvalue problem, and the stages after them, on a cached setup.
void Smoothest(benchmark::State& state, const std::string& mesh)
{
  DirectionField field(SurfaceOf(mesh));
  Options options;
  field.Compute(options);
  for (auto _ : state)
  {
    // Another tolerance, or the eigenpair computed before would be taken.
    options.Tolerance *= 1.0 - 1e-9;
    const Result result = field.Compute(options);
    state.counters["iterations"] = result.Components.at(0).Iterations;
  }
  Count(state, mesh);
}

/// The strengths that a slider goes through: none comes again, or near to another soon.
double NextStrength(double strength)
{
  // Steps of the golden ratio through 0.2 ... 0.9.
  const double next = strength + 0.7 * 0.6180339887498949;
  return next < 0.9 ? next : next - 0.7;
}

/// Another field on cached stages, as the options say, with other settings each time.
void Changed(benchmark::State& state, const std::string& mesh, Options options)
{
  DirectionField field(SurfaceOf(mesh));
  field.Compute(options);
  for (auto _ : state)
  {
    options.AlignmentStrength = NextStrength(options.AlignmentStrength);
    options.ConsistencyAngle = 20.0 + 0.9 * (options.ConsistencyAngle - 20.0);
    field.Compute(options);
  }
  Count(state, mesh);
}

void AlignedChange(benchmark::State& state, const std::string& mesh)
{
  Options options;
  options.Alignment = Alignment::PrincipalCurvature;
  Changed(state, mesh, options);
}

void ConstrainedEnergyChange(benchmark::State& state, const std::string& mesh)
{
  Options options;
  options.ConstrainCurvature = true;
  options.ConstraintSolver = ConstraintSolver::Energy;
  Changed(state, mesh, options);
}

/// From the arrays of the mesh to the aligned field.
void Aligned(benchmark::State& state, const std::string& mesh)
{
  const Surface& surface = SurfaceOf(mesh);
  Options options;
  options.Alignment = Alignment::PrincipalCurvature;
  for (auto _ : state)
  {
    DirectionField(surface).Compute(options);
  }
  Count(state, mesh);
}

/// A tensor at each point that is the same in space.
SurfaceTensors TensorsOf(const Surface& surface)
{
  SurfaceTensors tensors;
  for (std::size_t i = 0; i < surface.Points.size(); ++i)
  {
    tensors.Values.insert(tensors.Values.end(), { 3.0, 1.0, -1.0, 0.5, 0.2, 0.0 });
  }
  return tensors;
}

Options AlongTensors()
{
  Options options;
  options.AlignmentStrength = 1.0;
  return options;
}

/// From the arrays of the mesh to the field along tensors.
void Tensors(benchmark::State& state, const std::string& mesh)
{
  const Surface& surface = SurfaceOf(mesh);
  const SurfaceTensors tensors = TensorsOf(surface);
  for (auto _ : state)
  {
    DirectionField field(surface);
    field.FollowTensors(tensors, {});
    field.Compute(AlongTensors());
  }
  Count(state, mesh);
}

/// The field along other tensors on cached stages, as of the next time step.
void TensorsChange(benchmark::State& state, const std::string& mesh)
{
  const Surface& surface = SurfaceOf(mesh);
  SurfaceTensors tensors = TensorsOf(surface);
  DirectionField field(surface);
  field.FollowTensors(tensors, {});
  field.Compute(AlongTensors());
  for (auto _ : state)
  {
    tensors.Values[0] += 0.01;
    field.FollowTensors(tensors, {});
    field.Compute(AlongTensors());
  }
  Count(state, mesh);
}

/// The whole filter, conversion and output arrays included.
void Filter(benchmark::State& state, const std::string& mesh)
{
  for (auto _ : state)
  {
    vtkNew<vtkDirectionField> filter;
    filter->SetInputData(MeshOf(mesh));
    filter->Update();
  }
  Count(state, mesh);
}

void FilterStrengthChange(benchmark::State& state, const std::string& mesh)
{
  vtkNew<vtkDirectionField> filter;
  filter->SetInputData(MeshOf(mesh));
  filter->SetAlignment(vtkDirectionField::ALIGN_PRINCIPAL_CURVATURE);
  filter->Update();
  double strength = 0.8;
  for (auto _ : state)
  {
    filter->SetAlignmentStrength(strength = NextStrength(strength));
    filter->Modified();
    filter->Update();
  }
  Count(state, mesh);
}

/// Until the glyphs are there.
void FilterAndGlyphs(benchmark::State& state, const std::string& mesh)
{
  for (auto _ : state)
  {
    vtkNew<vtkDirectionField> filter;
    filter->SetInputData(MeshOf(mesh));
    vtkNew<vtkDirectionFieldGlyphs> glyphs;
    glyphs->SetInputConnection(filter->GetOutputPort());
    glyphs->Update();
  }
  Count(state, mesh);
}
}

int main(int argc, char* argv[])
{
  benchmark::Initialize(&argc, argv);
  std::vector<std::string> meshes(argv + 1, argv + argc);
  if (meshes.empty())
  {
    meshes = { "10000", "100000", "400000", "1600000", "6400000" };
  }
  using Function = void (*)(benchmark::State&, const std::string&);
  // In the order in which a field is computed.
  const std::pair<const char*, Function> benchmarks[] = {
    { "Setup", Setup },
    { "Flips", Flips },
    { "Assembly", Assembly },
    { "Hierarchy", BuildHierarchy },
    { "Eigensolve", Eigensolve },
    { "Smoothest", Smoothest },
    { "Aligned", Aligned },
    { "AlignedChange", AlignedChange },
    { "Tensors", Tensors },
    { "TensorsChange", TensorsChange },
    { "ConstrainedEnergyChange", ConstrainedEnergyChange },
    { "Filter", Filter },
    { "FilterStrengthChange", FilterStrengthChange },
    { "FilterAndGlyphs", FilterAndGlyphs },
  };
  for (const std::string& mesh : meshes)
  {
    for (const auto& [name, function] : benchmarks)
    {
      benchmark::RegisterBenchmark((std::string(name) + "/" + mesh).c_str(), function, mesh)
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
    }
  }
  try
  {
    benchmark::RunSpecifiedBenchmarks();
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
