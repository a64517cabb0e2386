// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Measures one thing on one mesh, in a process of its own, and prints the figures as JSON.
//
//   MeasureField TASK MESH [PROPERTY=VALUE...]
//
// TASK is one of
//   field        vtkDirectionField from a new filter to its outputs, conversion and arrays included
//   glyphs       the same and vtkDirectionFieldGlyphs behind it
//   strength     an aligned field, then other strengths of the alignment on the same filter
//   constraints  a smoothest field, then constrained ones on the same filter
//   stages       the libraries alone, stage by stage
//   baseline     ThesisAlgorithm
//   bandwidth    of the memory; MESH is of no account
// MESH is a number of triangles or a file (see BenchmarkMeshes.h), PROPERTY one of the filter.
// Seconds are the least of several runs, "first_seconds" those of the first; those of strength are
// single ones, the first those of the first field. The exit status is 2 where there is no such
// property, and 1, without figures, where the filter reports an error.

#include "BenchmarkMeshes.h"
#include "DirectionField.h"
#include "Geometry/IntrinsicTriangulation.h"
#include "Geometry/SurfaceGeometry.h"
#include "MemoryBandwidth.h"
#include "Meshes/PolyData.h"
#include "OptionTable.h"
#include "Sections/Assembly.h"
#include "Support/Threads.h"
#include "ThesisAlgorithm.h"

#include "vtkDirectionField.h"
#include "vtkDirectionFieldGlyphs.h"

#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace
{
/// By the names of the filter's properties.
using Setter = void (*)(vtkDirectionField*, double);
const std::map<std::string, Setter> Properties = {
#define SETTER(name, ...)                                                                          \
  { #name, [](vtkDirectionField* filter, double value) {                                           \
     filter->Set##name(static_cast<decltype(filter->Get##name())>(value));                         \
   } },
  DIRECTIONFIELDS_OPTIONS(SETTER, SETTER, SETTER)
#undef SETTER
};
/// Those asked for.
std::vector<std::pair<Setter, double>> Chosen;
int Degree = 4;

/// Runs are repeated until they are as many, or have taken so long; but for the baseline, twice at
/// least, since the first one touches memory that the system has to clear.
constexpr int FewestRuns = 2;
constexpr int MostRuns = 15;
/// Each changes an angle of a few degrees.
constexpr int MostConstrainedRuns = 10;
constexpr double LongEnough = 5.0;

double Seconds(const std::function<void()>& run)
{
  const auto begin = std::chrono::steady_clock::now();
  run();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Seconds of all processors that this process has had.
struct ProcessorSeconds
{
  double Program;
  /// The time of the system in it: to clear memory, above all.
  double System;

  ProcessorSeconds()
  {
    rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& time) { return time.tv_sec + 1e-6 * time.tv_usec; };
    this->Program = seconds(usage.ru_utime);
    this->System = seconds(usage.ru_stime);
  }
};

/// Most bytes that this process has had in memory. Not getrusage, whose figure includes what the
/// parent had when it made the process.
double PeakBytes()
{
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
  {
    if (word == "VmHWM:")
    {
      double kilobytes = 0.0;
      status >> kilobytes;
      return 1024.0 * kilobytes;
    }
  }
  return 0.0;
}

/// PeakBytes after the first run, which are those that one needs. Later ones may not find it in one piece.
double PeakOfOne = 0.0;

std::vector<double> Repeated(
  const std::function<void()>& run, int fewest = FewestRuns, int most = MostRuns)
{
  std::vector<double> times;
  double sum = 0.0;
  const auto isShort = [&](int runs) { return static_cast<int>(times.size()) < runs; };
  while (isShort(fewest) || (isShort(most) && sum < LongEnough))
  {
    times.push_back(Seconds(run));
    PeakOfOne = PeakOfOne > 0.0 ? PeakOfOne : PeakBytes();
    sum += times.back();
  }
  return times;
}

double Least(const std::vector<double>& times)
{
  return *std::min_element(times.begin(), times.end());
}

/// The figures, in the order of their printing.
class Figures
{
public:
  void Add(const char* name, double value)
  {
    char text[64];
    std::snprintf(
      text, sizeof(text), "%s\"%s\": %.9g", this->Text.empty() ? "" : ", ", name, value);
    this->Text += text;
  }
  void Print() const { std::cout << "{" << this->Text << "}" << std::endl; }

private:
  std::string Text;
};

/// The time of a filter that failed tells nothing.
[[noreturn]] void Fail(vtkObject*, unsigned long, void*, void* message)
{
  std::cerr << static_cast<const char*>(message);
  std::exit(1);
}

vtkSmartPointer<vtkDirectionField> NewFilter(vtkPolyData* mesh)
{
  auto filter = vtkSmartPointer<vtkDirectionField>::New();
  vtkNew<vtkCallbackCommand> fail;
  fail->SetCallback(Fail);
  filter->AddObserver(vtkCommand::ErrorEvent, fail);
  filter->SetInputData(mesh);
  for (const auto& [set, value] : Chosen)
  {
    set(filter, value);
  }
  return filter;
}

void AddResult(vtkDirectionField* filter, Figures& figures)
{
  vtkFieldData* data = filter->GetOutput()->GetFieldData();
  const auto range = [data](const char* name) { return data->GetArray(name)->GetRange(); };
  figures.Add("lambda", data->GetArray("Eigenvalue")->GetTuple1(0));
  figures.Add("residual", range("Residual")[1]);
  figures.Add("iterations", range("Iterations")[1]);
  figures.Add("euler", data->GetArray("EulerCharacteristic")->GetTuple1(0));
  figures.Add("index_sum", data->GetArray("IndexSum")->GetTuple1(0));
  figures.Add("singularities", static_cast<double>(filter->GetOutput(1)->GetNumberOfPoints()));
}

void MeasureField(vtkPolyData* mesh, bool glyphs, Figures& figures)
{
  vtkSmartPointer<vtkDirectionField> filter;
  vtkNew<vtkDirectionFieldGlyphs> drawn;
  std::vector<double> program;
  std::vector<double> system;
  const std::vector<double> times = Repeated(
    [&]
    {
      const ProcessorSeconds begin;
      filter = NewFilter(mesh);
      filter->Update();
      if (glyphs)
      {
        drawn->SetInputData(filter->GetOutput());
        drawn->Update();
      }
      const ProcessorSeconds end;
      program.push_back(end.Program - begin.Program);
      system.push_back(end.System - begin.System);
    });
  figures.Add("seconds", Least(times));
  figures.Add("first_seconds", times.front());
  figures.Add("program_processor_seconds", Least(program));
  figures.Add("system_processor_seconds", Least(system));
  AddResult(filter, figures);
}

void MeasureStrength(vtkPolyData* mesh, Figures& figures)
{
  const auto filter = NewFilter(mesh);
  filter->SetAlignment(vtkDirectionField::ALIGN_PRINCIPAL_CURVATURE);
  // As in use: the first field of a process, then a slider that is dragged, where each move profits
  // from those before.
  constexpr int moves = 6;
  std::vector<double> times;
  for (int move = 0; move <= moves; ++move)
  {
    filter->SetAlignmentStrength(0.5 + 0.05 * move);
    times.push_back(Seconds([&] { filter->Update(); }));
  }
  figures.Add("first_seconds", times.front());
  figures.Add("first_move_seconds", times[1]);
  figures.Add("seconds", times.back());
  AddResult(filter, figures);
}

void MeasureConstraints(vtkPolyData* mesh, Figures& figures)
{
  const auto filter = NewFilter(mesh);
  figures.Add("smoothest_seconds", Seconds([&] { filter->Update(); }));
  filter->ConstrainCurvatureOn();
  filter->Update();
  double angle = filter->GetConsistencyAngle();
  figures.Add("seconds",
    Least(Repeated(
      [&]
      {
        filter->SetConsistencyAngle(angle -= 0.5);
        filter->Update();
      },
      FewestRuns, MostConstrainedRuns)));
  AddResult(filter, figures);
}

void MeasureStages(const DirectionFields::Surface& surface, Figures& figures)
{
  using namespace DirectionFields;
  Options options;
  options.Degree = Degree;
  {
    DirectionField field(surface);
    field.Compute(options);
    figures.Add("smoothest_seconds",
      Least(Repeated(
        [&]
        {
          // Another tolerance, or the eigenpair computed before would be taken.
          options.Tolerance *= 1.0 - 1e-9;
          field.Compute(options);
        })));
  }
  Threads threads;
  const Threads::Scope scope(threads);
  std::optional<SurfaceGeometry> g;
  figures.Add("setup_seconds", Least(Repeated([&] { g.emplace(surface); })));
  figures.Add("flip_seconds", Least(Repeated([&] { const IntrinsicTriangulation flipped(*g); })));
  Operators operators;
  figures.Add("assembly_seconds",
    Least(Repeated(
      [&] { operators = AssembleOperators(*g, g->Mesh.GetComponents().at(0), Degree, 0.0); })));
  figures.Add("rows", static_cast<double>(operators.Energy.rows()));
  figures.Add("entries", static_cast<double>(operators.Energy.nonZeros()));
}

void MeasureBaseline(const DirectionFields::Surface& surface, Figures& figures)
{
  double setup = 0.0;
  double seconds = 0.0;
  double residual = 0.0;
  double lambda = 0.0;
  int singularities = 0;
  const std::vector<double> times = Repeated(
    [&]
    {
      const ThesisAlgorithm thesis(surface, Degree);
      if (seconds == 0.0 || thesis.Seconds < seconds)
      {
        setup = thesis.SetupSeconds;
        seconds = thesis.Seconds;
      }
      residual = thesis.Residual;
      lambda = thesis.Eigenvalue;
      singularities = thesis.Singularities;
    },
    1);
  figures.Add("seconds", seconds);
  figures.Add("first_seconds", times.front());
  figures.Add("setup_seconds", setup);
  figures.Add("lambda", lambda);
  figures.Add("residual", residual);
  figures.Add("iterations", ThesisAlgorithm::Iterations);
  figures.Add("singularities", singularities);
}

int Choose(const std::string& argument)
{
  const std::size_t equals = argument.find('=');
  const auto property = Properties.find(argument.substr(0, equals));
  if (equals == std::string::npos || property == Properties.end())
  {
    std::cerr << "There is no property for " << argument << ".\n";
    return 2;
  }
  const double value = std::stod(argument.substr(equals + 1));
  Chosen.emplace_back(property->second, value);
  if (property->first == "Degree")
  {
    Degree = static_cast<int>(value);
  }
  return 0;
}

int Measure(const std::string& task, const std::string& name)
{
  Figures figures;
  if (task == "bandwidth")
  {
    figures.Add("bytes_per_second", MemoryBandwidth(0));
    figures.Add("bytes_per_second_one_thread", MemoryBandwidth(1));
    figures.Print();
    return 0;
  }
  const vtkSmartPointer<vtkPolyData> mesh = BenchmarkMeshes::Make(name);
  figures.Add("triangles", static_cast<double>(mesh->GetNumberOfPolys()));
  figures.Add("vertices", static_cast<double>(mesh->GetNumberOfPoints()));
  const double before = PeakBytes();
  if (task == "field" || task == "glyphs")
  {
    MeasureField(mesh, task == "glyphs", figures);
  }
  else if (task == "strength")
  {
    MeasureStrength(mesh, figures);
  }
  else if (task == "constraints")
  {
    MeasureConstraints(mesh, figures);
  }
  else if (task == "stages")
  {
    MeasureStages(Meshes::ToSurface(mesh), figures);
  }
  else if (task == "baseline")
  {
    MeasureBaseline(Meshes::ToSurface(mesh), figures);
  }
  else
  {
    std::cerr << "There is no task " << task << ".\n";
    return 1;
  }
  figures.Add("peak_bytes_before", before);
  figures.Add("peak_bytes", task == "field" || task == "glyphs" ? PeakOfOne : PeakBytes());
  figures.Print();
  return 0;
}
}

int main(int argc, char* argv[])
{
  if (argc < 3)
  {
    std::cerr << "Usage: MeasureField TASK MESH [PROPERTY=VALUE...]\n";
    return 1;
  }
  try
  {
    for (int i = 3; i < argc; ++i)
    {
      if (const int status = Choose(argv[i]))
      {
        return status;
      }
    }
    return Measure(argv[1], argv[2]);
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
