// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Functions.h"

#include <DirectionFields/Computation/SurfaceFigures.h>
#include <DirectionFields/DirectionField.h>
#include <DirectionFields/Exchange/FieldExport.h>
#include <DirectionFields/Exchange/FieldImport.h>
#include <DirectionFields/Guidance/SurfaceTensors.h>
#include <DirectionFields/OptionTable.h>
#include <DirectionFields/PrescribedSingularities/EditedResult.h>
#include <DirectionFields/PrescribedSingularities/SurfaceRefinement.h>
#include <DirectionFields/Reports/FieldSummary.h>
#include <DirectionFields/Reports/FieldWarnings.h>
#include <DirectionFields/Soup/PolygonEars.h>

#include <cmath>

using namespace DirectionFields;

namespace
{
using Names = Keywords::Names;

/// The names of the values of each choice, from 0.
const Names AlignmentNames{ "none", "curvature", "vectors", "tensor" };
/// "tensor" is none of Options: DirectionField::FollowTensors takes tensors.
constexpr int AlignmentToTensors = 3;
const Names CurvatureDirectionNames{ "maximum", "minimum", "least_bent", "most_bent" };
const Names ConstraintSolverNames{ "least_squares", "energy" };
const Names SolverNames{ "automatic", "multigrid", "direct" };
const Names MergePointsNames{ "off", "on", "automatic" };

/// "EnergyBias" becomes "energy_bias".
std::string Keyword(const std::string& name)
{
  std::string keyword;
  for (const char letter : name)
  {
    const bool isCapital = letter >= 'A' && letter <= 'Z';
    keyword += isCapital && !keyword.empty() ? "_" : "";
    keyword += static_cast<char>(isCapital ? letter - 'A' + 'a' : letter);
  }
  return keyword;
}

/// The options of a field, and of the tensors that it follows.
struct FieldChoices
{
  DirectionFields::Options Options;
  TensorGuidanceOptions Tensors;
  double TensorStrength = 1.0;
  bool FollowsTensors = false;
  bool AreAtTriangles = false;
};

FieldChoices ReadOptions(Keywords& keywords)
{
  FieldChoices choices;
  Options& options = choices.Options;
#define FLAG(name, stage) keywords(Keyword(#name), options.name);
#define CHOICE(name, stage, last) keywords.Choice(Keyword(#name), options.name, name##Names);
#define RANGE(name, stage, least, most, unit)                                                      \
  keywords(Keyword(#name), options.name, static_cast<double>(least), static_cast<double>(most),    \
    static_cast<const char*>(unit));
  DIRECTIONFIELDS_OPTIONS(FLAG, CHOICE, RANGE)
#undef FLAG
#undef CHOICE
#undef RANGE
  keywords.Choice("tensors_at", choices.AreAtTriangles, { "points", "triangles" });
  keywords.Choice("tensor_direction", choices.Tensors.Direction, TensorDirectionNames());
  keywords("tensor_strength", choices.TensorStrength, 0.0, 1.0);
  keywords("tensor_scale", choices.Tensors.Scale, 0.0, 32.0);
  keywords.RequireNoMore();
  choices.FollowsTensors = static_cast<int>(options.Alignment) == AlignmentToTensors;
  if (choices.FollowsTensors)
  {
    options.Alignment = Alignment::None;
    // The check of the options calls it by another name.
    if (!(choices.TensorStrength >= 0.0 && choices.TensorStrength <= 1.0))
    {
      throw py::value_error("tensor_strength must be 0 to 1.");
    }
    options.AlignmentStrength = choices.TensorStrength;
  }
  return choices;
}

struct EditChoices
{
  EditOptions Options;
  DirectionFields::Options Guidance;
  bool Refines = false;
  bool KeepsConstraints = true;
  int Threads = 0;
};

EditChoices ReadEditOptions(Keywords& keywords)
{
  EditChoices choices;
  keywords("add", choices.Options.AddsToBase);
  keywords.Choice("objective", choices.Options.Objective, { "smoothest", "least_change" });
  keywords("balance", choices.Options.Balances);
  keywords("refine", choices.Refines);
  keywords("keep_constraints", choices.KeepsConstraints);
  keywords.Choice(
    "alignment", choices.Guidance.Alignment, { AlignmentNames.begin(), AlignmentNames.end() - 1 });
  keywords("alignment_strength", choices.Guidance.AlignmentStrength, 0.0, 1.0);
  keywords("number_of_threads", choices.Threads, 0.0, 1024.0);
  keywords.RequireNoMore();
  if (choices.Guidance.Alignment != Alignment::None)
  {
    choices.Options.AlignmentStrength = choices.Guidance.AlignmentStrength;
  }
  return choices;
}

ExportOptions ReadExportOptions(Keywords& keywords)
{
  ExportOptions options;
  bool atTriangles = true;
  keywords.Choice("at", atTriangles, { "points", "triangles" });
  options.On = atTriangles ? FieldOn::Cells : FieldOn::Points;
  keywords("feature_angle", options.FeatureAngle, 0.0, 180.0, " degrees");
  keywords("minimum_feature_length", options.MinimumFeatureLength, 0.0, NoLimit);
  keywords.RequireNoMore();
  return options;
}

FieldOn ReadImportOptions(Keywords& keywords)
{
  FieldOn on = FieldOn::Automatic;
  keywords.Choice("at", on, { "automatic", "triangles", "points" });
  keywords.RequireNoMore();
  return on;
}

/// A field on its way to Python.
struct FieldOutput
{
  SharedSurface Mesh;
  Result Field;
  std::vector<std::string> Warnings;
  std::string Summary;
  std::shared_ptr<const TensorGuidance> Tensors;
  std::vector<Vector3> Directions;
  std::vector<double> Magnitudes;

  /// Takes what needs no lock, so that others can go on.
  void Prepare()
  {
    if (!this->Field.SplitTriangles.empty())
    {
      auto split = std::make_shared<Surface>();
      for (const Index point : this->Field.OriginalPoint)
      {
        split->Points.push_back(this->Mesh->Points[point]);
      }
      split->Triangles = std::move(this->Field.SplitTriangles);
      this->Mesh = std::move(split);
    }
    const std::size_t count = this->Field.Representation.size();
    this->Directions.resize(count * this->Field.Degree);
    this->Field.Directions(0, static_cast<Index>(count), this->Directions.data());
    for (std::size_t i = 0; i < count; ++i)
    {
      // As the filter for VTK does; at points of no triangle without zeros of negative sign.
      this->Magnitudes.push_back(std::sqrt(std::norm(this->Field.Representation[i])));
      for (int k = 0; k < this->Field.Degree && this->Magnitudes[i] == 0.0; ++k)
      {
        this->Directions[i * this->Field.Degree + k] += Vector3::Zero();
      }
    }
  }
};

py::object ToPython(FieldOutput& output)
{
  Result& field = output.Field;
  std::vector<double> eigenvalues;
  bool converged = true;
  for (const ComponentReport& component : field.Components)
  {
    eigenvalues.push_back(component.Eigenvalue);
    converged = converged && component.Converged;
  }
  py::dict all;
  all["_surface"] = output.Mesh;
  all["degree"] = field.Degree;
  all["converged"] = converged;
  all["warnings"] = output.Warnings;
  all["summary"] = output.Summary;
  all["directions"] = Own<double>(std::move(output.Directions), { field.Degree, 3 });
  all["magnitudes"] = Own<double>(std::move(output.Magnitudes));
  all["representation"] = Own<Complex>(std::move(field.Representation));
  all["energy_density"] = Own<double>(std::move(field.EnergyDensity));
  all["normals"] = Own<double>(std::move(field.Normal), { 3 });
  all["x_axes"] = Own<double>(std::move(field.XAxis), { 3 });
  all["constraints"] = Own<signed char>(std::move(field.Constraint));
  all["constraint_directions"] = Own<double>(std::move(field.ConstraintDirection), { 3 });
  all["original_points"] = Own<Index>(std::move(field.OriginalPoint));
  all["indices"] = Own<int>(std::move(field.SingularityIndex));
  all["components"] = Own<Index>(std::move(field.Component));
  all["eigenvalue"] = Own<double>(std::move(eigenvalues));
  if (field.Curvature)
  {
    const CurvatureReport& curvature = *field.Curvature;
    all["principal_directions"] = py::make_tuple(Own<double>(curvature.PrincipalDirection0, { 3 }),
      Own<double>(curvature.PrincipalDirection1, { 3 }));
    all["mean_curvature"] = Own<double>(curvature.Mean);
    all["gaussian_curvature"] = Own<double>(curvature.Gaussian);
  }
  if (output.Tensors)
  {
    const TensorGuidance& tensors = *output.Tensors;
    all["major_values"] = Own<double>(tensors.MajorValue);
    all["minor_values"] = Own<double>(tensors.MinorValue);
    all["anisotropy"] = Own<double>(tensors.Anisotropy);
    all["surface_tensors"] = Own<double>(tensors.Tangential, { 6 });
    all["isotropic_share"] = tensors.IsotropicShare;
  }
  return all;
}

Finish Finished(const std::shared_ptr<FieldOutput>& output)
{
  output->Prepare();
  return [output] { return ToPython(*output); };
}

py::object ComputeField(const SharedSurface& surface, const py::object& vectors,
  const py::object& weights, const py::object& strengths, const py::object& given,
  const py::object& progress, const py::dict& chosen)
{
  Keywords keywords("field", chosen);
  const FieldChoices choices = ReadOptions(keywords);
  if (choices.FollowsTensors == given.is_none())
  {
    throw py::value_error(choices.FollowsTensors ? "Give tensors: alignment='tensor' needs them."
                                                 : "Set alignment='tensor' to follow tensors.");
  }
  const Guidance guidance{ VectorsOrNone(vectors), NumbersOrNone(weights),
    NumbersOrNone(strengths) };
  SurfaceTensors tensors;
  if (choices.FollowsTensors)
  {
    const auto values = given.cast<py::array>();
    tensors = { Numbers(values), static_cast<int>(values.shape(1)), choices.AreAtTriangles };
  }
  return Run(progress, choices.Options.NumberOfThreads,
    [=](const ProgressFunction& report)
    {
      const Options& options = choices.Options;
      auto output = std::make_shared<FieldOutput>();
      output->Mesh = surface;
      const auto solver = std::make_unique<DirectionField>(surface);
      if (choices.FollowsTensors)
      {
        solver->FollowTensors(tensors, choices.Tensors);
      }
      output->Field = std::move(*solver).Compute(options, guidance, report);
      output->Warnings = Warnings(output->Field, options);
      const SurfaceFigures figures = FiguresOf(*surface, output->Field.SingularityIndex);
      output->Summary = Summary(figures, output->Field, options);
      output->Tensors = solver->GetTensorGuidance();
      if (output->Tensors)
      {
        output->Summary += DescribeTensors(*output->Tensors, "tensors", figures, options.Degree);
      }
      return Finished(output);
    });
}

/// The given field, the constraints and the guidance on a mesh that is refined where the edit needs
/// it.
struct Edit
{
  SharedGiven Base;
  std::vector<Vector3> Constraints;
  DirectionFields::Guidance Guidance;

  void Refine(const GivenField& base, const EditedField& edited)
  {
    SurfaceRefinement refinement(base.GetSurface(), TrianglesToSplit(base, edited));
    std::vector<Vector3> directions = this->Base->Directions;
    const std::vector<Vector3> middles = DirectionsAtMiddles(base, refinement);
    directions.insert(directions.end(), middles.begin(), middles.end());
    const std::size_t count = refinement.Refined.Points.size();
    if (!this->Constraints.empty())
    {
      this->Constraints.resize(count, Vector3::Zero());
    }
    for (const std::array<Index, 2>& ends : refinement.Ends)
    {
      if (!this->Guidance.Vectors.empty())
      {
        this->Guidance.Vectors.push_back(
          0.5 * (this->Guidance.Vectors[ends[0]] + this->Guidance.Vectors[ends[1]]));
      }
      if (!this->Guidance.Weights.empty())
      {
        this->Guidance.Weights.push_back(
          0.5 * (this->Guidance.Weights[ends[0]] + this->Guidance.Weights[ends[1]]));
      }
    }
    this->Base = std::make_shared<Given>(std::make_shared<Surface>(std::move(refinement.Refined)),
      this->Base->Degree, std::move(directions));
  }
};

py::object EditField(const SharedGiven& field, const py::object& constraints,
  const std::vector<Index>& triangles, const std::vector<int>& indices, const py::object& vectors,
  const py::object& weights, const py::object& progress, const py::dict& given)
{
  constexpr int mostRefinements = 4;
  Keywords keywords("edit", given);
  EditChoices choices = ReadEditOptions(keywords);
  choices.Guidance.Degree = field->Degree;
  std::vector<WantedSingularity> wanted;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    const std::vector<Vector3>& points = field->Mesh->Points;
    const auto& [a, b, c] = field->Mesh->Triangles.at(static_cast<std::size_t>(triangles[i]));
    wanted.push_back({ (points[a] + points[b] + points[c]) / 3.0, indices.at(i) });
  }
  Edit edit{ field, choices.KeepsConstraints ? VectorsOrNone(constraints) : std::vector<Vector3>(),
    { VectorsOrNone(vectors), NumbersOrNone(weights) } };
  return Run(progress, choices.Threads,
    [=](const ProgressFunction& report) mutable
    {
      auto output = std::make_shared<FieldOutput>();
      for (int k = 0;; ++k)
      {
        const SharedGiven base = edit.Base;
        SingularityEditor editor(*base->Mesh, base->Get(), edit.Constraints);
        output->Warnings.clear();
        editor.SetGuidance(GuidanceFor(editor, choices.Guidance, edit.Guidance, output->Warnings));
        const EditedField edited = editor.Edit(wanted, choices.Options, Progress(report));
        if (!choices.Refines || edited.WrongTriangles.empty() || k == mostRefinements)
        {
          output->Mesh = base->Mesh;
          output->Field = ToResult(editor, edited);
          output->Warnings.insert(output->Warnings.end(), edited.Notes.begin(), edited.Notes.end());
          output->Summary = SummaryOfEdit(output->Field, edited, choices.Options.Objective);
          return Finished(output);
        }
        edit.Refine(editor.GetBase(), edited);
      }
    });
}

py::object ReadFrom(const SharedSurface& surface, const std::string& name, const py::dict& given)
{
  Keywords keywords("read", given);
  const FieldOn on = ReadImportOptions(keywords);
  return Run(py::none(), 0,
    [=](const ProgressFunction& report)
    {
      ImportedField imported =
        ImportField(ReadFieldFile(name), *surface, on, true, Progress(report));
      auto output = std::make_shared<FieldOutput>();
      output->Mesh = surface;
      output->Summary = SummaryOfFile(imported.Field, name);
      output->Warnings = std::move(imported.Warnings);
      output->Field = std::move(imported.Field);
      return Finished(output);
    });
}

void WriteTo(const SharedGiven& field, const std::string& name, const py::dict& given)
{
  Keywords keywords("write", given);
  ExportOptions options = ReadExportOptions(keywords);
  options.Format = FormatOf(name);
  Run(py::none(), 0,
    [=](const ProgressFunction&)
    {
      WriteFiles(name, ExportField(GivenField(*field->Mesh, field->Get()), nullptr, options));
      return [] { return py::none(); };
    });
}

/// Index of each triangle of a given field, and its directions at the triangles' centroids.
py::object Indices(const SharedGiven& field)
{
  const GivenField given(*field->Mesh, field->Get());
  const std::vector<int> ofMesh = given.Indices();
  std::vector<int> indices;
  for (const Index triangle : given.GetMeshTriangles())
  {
    indices.push_back(triangle == None ? 0 : ofMesh[triangle]);
  }
  return Own<int>(std::move(indices));
}

py::object AtTriangles(const SharedGiven& field)
{
  const GivenField given(*field->Mesh, field->Get());
  const FaceField faces = AtCentroids(given);
  const auto degree = static_cast<std::size_t>(field->Degree);
  std::vector<Vector3> all(field->Mesh->Triangles.size() * degree);
  for (std::size_t k = 0; k < degree; ++k)
  {
    const std::vector<Vector3> directions = DirectionsInSpace(given, faces, static_cast<int>(k));
    for (std::size_t t = 0; t < directions.size(); ++t)
    {
      all[t * degree + k] = directions[t];
    }
  }
  return Own<double>(std::move(all), { field->Degree, 3 });
}

/// Triangles of polygons, and the polygon of each: by ears, or as a fan where that is not possible.
py::tuple Cut(const SharedSurface& surface, const std::vector<std::int64_t>& offsets,
  const std::vector<Index>& corners)
{
  std::vector<Triangle> triangles;
  std::vector<std::int64_t> polygons;
  for (std::size_t i = 0; i + 1 < offsets.size(); ++i)
  {
    const Index* const ids = corners.data() + offsets[i];
    const auto size = static_cast<Index>(offsets[i + 1] - offsets[i]);
    std::vector<Index> ears;
    if (size > 3)
    {
      std::vector<Vector3> places;
      for (Index c = 0; c < size; ++c)
      {
        places.push_back(surface->Points[ids[c]]);
      }
      ears = CutEars(places, false);
    }
    for (Index c = 1; ears.empty() && c + 1 < size; ++c)
    {
      triangles.push_back({ ids[0], ids[c], ids[c + 1] });
    }
    for (std::size_t e = 0; e + 2 < ears.size(); e += 3)
    {
      triangles.push_back({ ids[ears[e]], ids[ears[e + 1]], ids[ears[e + 2]] });
    }
    polygons.resize(triangles.size(), static_cast<std::int64_t>(i));
  }
  return py::make_tuple(
    Own<Index>(std::move(triangles), { 3 }), Own<std::int64_t>(std::move(polygons)));
}
}

PYBIND11_MODULE(_core, module)
{
  py::register_exception<MeshError>(module, "MeshError", PyExc_ValueError);
  py::register_exception<FileError>(module, "FileError", PyExc_OSError);
  py::class_<Surface, SharedSurface>(module, "Surface")
    .def(py::init(&MakeSurface))
    .def_property_readonly(
      "points", [](const SharedSurface& surface) { return View<double>(surface, surface->Points); })
    .def_property_readonly("triangles",
      [](const SharedSurface& surface) { return View<Index>(surface, surface->Triangles); });
  py::class_<Given, SharedGiven>(module, "Given")
    .def(py::init<SharedSurface, const py::array&, const py::object&>());
  py::dict described;
  Describe(described, "field", ReadOptions);
  Describe(described, "edit", ReadEditOptions);
  Describe(described, "read", ReadImportOptions);
  Describe(described, "write", ReadExportOptions);
  AddDrawing(module, described);
  module.attr("options") = described;
  module.def("field", &ComputeField);
  module.def("edit", &EditField);
  module.def("read", &ReadFrom);
  module.def("write", &WriteTo);
  module.def("indices", &Indices);
  module.def("at_triangles", &AtTriangles);
  module.def("cut", &Cut);
  module.def("stop_all", &StopAll);
}
