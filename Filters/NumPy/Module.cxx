// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include <DirectionFields/DirectionField.h>
#include <DirectionFields/OptionTable.h>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <exception>
#include <memory>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace py = pybind11;
using namespace DirectionFields;

namespace
{
using Names = std::vector<std::string>;

/// The names of the values of each choice, from 0.
const Names AlignmentNames{ "none", "curvature", "vectors" };
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
    if (letter >= 'A' && letter <= 'Z')
    {
      keyword += keyword.empty() ? "" : "_";
      keyword += static_cast<char>(letter - 'A' + 'a');
    }
    else
    {
      keyword += letter;
    }
  }
  return keyword;
}

template <class T>
void Take(T& value, const std::string& keyword, py::handle given)
{
  // Python's numbers convert to bool silently, and a bool to a number.
  if (std::is_same_v<T, bool> != py::isinstance<py::bool_>(given))
  {
    throw py::type_error(keyword +
      (std::is_same_v<T, bool> ? " must be True or False." : " must be a number, not a bool."));
  }
  try
  {
    value = given.cast<T>();
  }
  catch (const py::cast_error&)
  {
    throw py::type_error(
      keyword + (std::is_integral_v<T> ? " must be a whole number." : " must be a number."));
  }
}

template <class T>
void TakeChoice(T& value, const std::string& keyword, const Names& names, py::handle given)
{
  std::string all;
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    if (py::isinstance<py::str>(given) && given.cast<std::string>() == names[i])
    {
      value = static_cast<T>(i);
      return;
    }
    all += (i == 0 ? "'" : ", '") + names[i] + "'";
  }
  throw py::value_error(keyword + " must be one of " + all + ".");
}

Options TakeOptions(const py::dict& given)
{
  Options options;
  std::set<std::string> known;
#define TAKE(name, ...)                                                                            \
  if (known.insert(Keyword(#name)); given.contains(Keyword(#name)))                                \
  {                                                                                                \
    Take(options.name, Keyword(#name), given[py::str(Keyword(#name))]);                            \
  }
#define TAKE_CHOICE(name, ...)                                                                     \
  if (known.insert(Keyword(#name)); given.contains(Keyword(#name)))                                \
  {                                                                                                \
    TakeChoice(options.name, Keyword(#name), name##Names, given[py::str(Keyword(#name))]);         \
  }
  DIRECTIONFIELDS_OPTIONS(TAKE, TAKE_CHOICE, TAKE)
#undef TAKE
#undef TAKE_CHOICE
  for (const auto& item : given)
  {
    const auto keyword = item.first.cast<std::string>();
    if (known.count(keyword) == 0)
    {
      throw py::type_error("field() has no option '" + keyword +
        "'; direction_fields.options() lists those that there are.");
    }
  }
  return options;
}

/// Default and range of each option, by its keyword: (default, least, most, unit), (default,) for
/// flags and (default, names) for choices.
py::dict DescribeOptions()
{
  const Options options;
  py::dict all;
#define FLAG(name, ...) all[py::str(Keyword(#name))] = py::make_tuple(options.name);
#define CHOICE(name, stage, last)                                                                  \
  all[py::str(Keyword(#name))] =                                                                   \
    py::make_tuple(name##Names.at(static_cast<std::size_t>(options.name)), name##Names);
#define RANGE(name, stage, least, most, unit)                                                      \
  all[py::str(Keyword(#name))] =                                                                   \
    py::make_tuple(options.name, static_cast<double>(least), static_cast<double>(most), unit);
  DIRECTIONFIELDS_OPTIONS(FLAG, CHOICE, RANGE)
#undef FLAG
#undef CHOICE
#undef RANGE
  return all;
}

/// An array of NumPy's that owns the vector from now on: nothing is copied.
template <class Scalar, class T>
py::array Own(std::vector<T> values, std::vector<py::ssize_t> shape)
{
  auto* owner = new std::vector<T>(std::move(values));
  const py::capsule capsule(owner, [](void* data) { delete static_cast<std::vector<T>*>(data); });
  return py::array_t<Scalar>(
    std::move(shape), reinterpret_cast<const Scalar*>(owner->data()), capsule);
}

std::vector<Vector3> Vectors(const py::array_t<double, py::array::c_style>& array)
{
  const auto view = array.unchecked<2>();
  std::vector<Vector3> vectors(static_cast<std::size_t>(view.shape(0)));
  for (py::ssize_t i = 0; i < view.shape(0); ++i)
  {
    vectors[static_cast<std::size_t>(i)] = Vector3(view(i, 0), view(i, 1), view(i, 2));
  }
  return vectors;
}

std::vector<Triangle> Triangles(const py::array_t<Index, py::array::c_style>& array)
{
  const auto view = array.unchecked<2>();
  std::vector<Triangle> triangles(static_cast<std::size_t>(view.shape(0)));
  for (py::ssize_t i = 0; i < view.shape(0); ++i)
  {
    triangles[static_cast<std::size_t>(i)] = { view(i, 0), view(i, 1), view(i, 2) };
  }
  return triangles;
}

/// Calls Python's function, if there is any, and looks for Ctrl-C. What Python raises stops the
/// computation and waits here for its end: exceptions must not cross the libraries' threads.
struct Listener
{
  py::object Function;
  std::exception_ptr Raised;

  bool operator()(double fraction)
  {
    const py::gil_scoped_acquire lock;
    if (this->Raised)
    {
      return false;
    }
    try
    {
      if (PyErr_CheckSignals() != 0)
      {
        throw py::error_already_set();
      }
      if (!this->Function.is_none())
      {
        this->Function(fraction);
      }
      return true;
    }
    catch (...)
    {
      this->Raised = std::current_exception();
      return false;
    }
  }
};

py::dict ToPython(Result result, std::size_t points)
{
  const auto count = static_cast<py::ssize_t>(result.OriginalPoint.size());
  const auto degree = static_cast<py::ssize_t>(result.Degree);
  std::vector<Vector3> directions(result.OriginalPoint.size() * result.Degree);
  result.Directions(0, static_cast<Index>(count), directions.data());
  std::vector<double> eigenvalues;
  bool converged = true;
  for (const ComponentReport& component : result.Components)
  {
    eigenvalues.push_back(component.Eigenvalue);
    converged = converged && component.Converged;
  }
  const auto triangles = static_cast<py::ssize_t>(result.SingularityIndex.size());
  const auto split = static_cast<py::ssize_t>(result.SplitTriangles.size());
  const auto components = static_cast<py::ssize_t>(eigenvalues.size());
  py::dict all;
  all["degree"] = result.Degree;
  all["converged"] = converged;
  all["warnings"] = result.Notes;
  all["directions"] = Own<double>(std::move(directions), { count, degree, 3 });
  all["representation"] = Own<Complex>(std::move(result.Representation), { count });
  all["energy_density"] = Own<double>(std::move(result.EnergyDensity), { count });
  all["normals"] = Own<double>(std::move(result.Normal), { count, 3 });
  all["x_axes"] = Own<double>(std::move(result.XAxis), { count, 3 });
  all["original_points"] = Own<Index>(std::move(result.OriginalPoint), { count });
  all["split_triangles"] = static_cast<std::size_t>(count) == points
    ? py::object(py::none())
    : py::object(Own<Index>(std::move(result.SplitTriangles), { split, 3 }));
  all["indices"] = Own<int>(std::move(result.SingularityIndex), { triangles });
  all["components"] = Own<Index>(std::move(result.Component), { triangles });
  all["eigenvalue"] = Own<double>(std::move(eigenvalues), { components });
  if (result.Curvature)
  {
    const CurvatureReport& curvature = *result.Curvature;
    all["principal_directions"] =
      py::make_tuple(Own<double>(curvature.PrincipalDirection0, { count, 3 }),
        Own<double>(curvature.PrincipalDirection1, { count, 3 }));
    all["mean_curvature"] = Own<double>(curvature.Mean, { count });
    all["gaussian_curvature"] = Own<double>(curvature.Gaussian, { count });
  }
  return all;
}

py::dict ComputeField(const py::array_t<double, py::array::c_style>& points,
  const py::array_t<Index, py::array::c_style>& triangles, const py::object& vectors,
  const py::object& weights, const py::object& progress, const py::dict& given)
{
  const Options options = TakeOptions(given);
  Surface surface;
  surface.Points = Vectors(points);
  surface.Triangles = Triangles(triangles);
  Guidance guidance;
  if (!vectors.is_none())
  {
    guidance.Vectors = Vectors(vectors.cast<py::array_t<double, py::array::c_style>>());
  }
  if (!weights.is_none())
  {
    guidance.Weights = weights.cast<std::vector<double>>();
  }
  Listener listener;
  listener.Function = progress;
  Result result;
  const std::size_t count = surface.Points.size();
  {
    const py::gil_scoped_release unlocked;
    result = DirectionField(std::make_shared<const Surface>(std::move(surface)))
               .Compute(options, guidance, [&listener](double done) { return listener(done); });
  }
  if (listener.Raised)
  {
    std::rethrow_exception(listener.Raised);
  }
  return ToPython(std::move(result), count);
}
}

PYBIND11_MODULE(_core, module)
{
  py::register_exception<MeshError>(module, "MeshError", PyExc_ValueError);
  module.def("options", &DescribeOptions);
  module.def("field", &ComputeField);
}
