// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef Arrays_h
#define Arrays_h

#include <DirectionFields/Coordinates.h>
#include <DirectionFields/Interpolation/GivenField.h>
#include <DirectionFields/MeshError.h>
#include <DirectionFields/Surface.h>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace DirectionFields
{
/// Nobody changes it once it is made: computations share it.
using SharedSurface = std::shared_ptr<Surface>;

/// An array of NumPy's that owns the vector from now on: nothing is copied. Its shape is the
/// number of rows, then the inner one.
template <class Scalar, class T>
py::array Own(std::vector<T> values, std::vector<py::ssize_t> inner = {})
{
  std::size_t row = 1;
  for (const py::ssize_t size : inner)
  {
    row *= static_cast<std::size_t>(size);
  }
  inner.insert(inner.begin(),
    static_cast<py::ssize_t>(values.size() * sizeof(T) / sizeof(Scalar) / (row == 0 ? 1 : row)));
  auto* owner = new std::vector<T>(std::move(values));
  const py::capsule capsule(owner, [](void* data) { delete static_cast<std::vector<T>*>(data); });
  return py::array_t<Scalar>(
    std::move(inner), reinterpret_cast<const Scalar*>(owner->data()), capsule);
}

/// Calls take(row, column, value) for the numbers of an array of two dimensions, where they are:
/// floats, doubles and ids of any strides are not copied first, other types are.
template <class First, class Second, class Body>
void ForEachNumber(const py::array& array, const Body& take)
{
  const auto read = [&take](const auto& view)
  {
    for (py::ssize_t i = 0; i < view.shape(0); ++i)
    {
      for (py::ssize_t k = 0; k < view.shape(1); ++k)
      {
        take(static_cast<std::size_t>(i), static_cast<std::size_t>(k), view(i, k));
      }
    }
  };
  if (py::isinstance<py::array_t<Second>>(array))
  {
    read(array.unchecked<Second, 2>());
  }
  else
  {
    read(py::array_t<First, py::array::forcecast>(array).template unchecked<2>());
  }
}

/// The rows of an array of numbers; three a row for vectors.
inline std::vector<Vector3> Vectors(const py::array& array)
{
  std::vector<Vector3> vectors(static_cast<std::size_t>(array.shape(0)));
  ForEachNumber<double, float>(array,
    [&vectors](std::size_t i, std::size_t k, double value)
    { vectors[i][static_cast<Eigen::Index>(k)] = value; });
  return vectors;
}

/// The same, but nothing where there is None.
inline std::vector<Vector3> VectorsOrNone(const py::object& array)
{
  return array.is_none() ? std::vector<Vector3>() : Vectors(array.cast<py::array>());
}

/// The numbers of an array of two dimensions, row by row.
inline std::vector<double> Numbers(const py::array& array)
{
  std::vector<double> numbers;
  numbers.reserve(static_cast<std::size_t>(array.size()));
  ForEachNumber<double, float>(
    array, [&numbers](std::size_t, std::size_t, double value) { numbers.push_back(value); });
  return numbers;
}

inline std::vector<double> NumbersOrNone(const py::object& numbers)
{
  return numbers.is_none() ? std::vector<double>() : numbers.cast<std::vector<double>>();
}

/// Throws MeshError where a point of a triangle is so far that sums of its coordinates have no
/// number; what is not finite is refused with the mesh.
inline void RequirePlaces(const Surface& surface)
{
  std::vector<char> isUsed(surface.Points.size(), 0);
  for (const Triangle& triangle : surface.Triangles)
  {
    for (const Index point : triangle)
    {
      isUsed[point] = 1;
    }
  }
  CoordinateCheck check(false);
  for (std::size_t i = 0; i < isUsed.size(); ++i)
  {
    if (isUsed[i] != 0 && surface.Points[i].allFinite() && !check.MayBe(surface.Points[i].data()))
    {
      check.Refuse(i, surface.Points[i].data());
    }
  }
  if (!check.GetError().empty())
  {
    throw MeshError(
      MeshError::Kind::NonFinitePoint, static_cast<Index>(check.GetFirst()), check.GetError());
  }
}

/// A surface that other functions take, of ids that there are.
inline SharedSurface MakeSurface(const py::array& points, const py::array& triangles)
{
  auto surface = std::make_shared<Surface>();
  surface->Points = Vectors(points);
  surface->Triangles.resize(static_cast<std::size_t>(triangles.shape(0)));
  ForEachNumber<std::int64_t, std::int32_t>(triangles,
    [&surface](std::size_t i, std::size_t k, std::int64_t id)
    { surface->Triangles[i][k] = static_cast<Index>(id); });
  RequirePlaces(*surface);
  return surface;
}

/// A part of a surface as an array that keeps the surface alive and cannot be written to.
template <class Scalar, class T>
py::array View(const SharedSurface& surface, const std::vector<T>& part)
{
  const py::capsule capsule(
    new SharedSurface(surface), [](void* owner) { delete static_cast<SharedSurface*>(owner); });
  py::array view = py::array_t<Scalar>({ static_cast<py::ssize_t>(part.size()), py::ssize_t(3) },
    reinterpret_cast<const Scalar*>(part.data()), capsule);
  view.attr("setflags")(py::arg("write") = false);
  return view;
}

/// A field that was given as arrays: what all functions on fields take.
struct Given
{
  /// @param directions shape (points, degree, 3)
  /// @param magnitudes one a point, or None for 1
  Given(SharedSurface surface, const py::array& directions, const py::object& magnitudes)
    : Mesh(std::move(surface))
    , Degree(static_cast<int>(directions.shape(1)))
    , Directions(Vectors(directions.attr("reshape")(-1, 3)))
    , Magnitudes(NumbersOrNone(magnitudes))
  {
  }
  Given(SharedSurface surface, int degree, std::vector<Vector3> directions)
    : Mesh(std::move(surface))
    , Degree(degree)
    , Directions(std::move(directions))
  {
  }
  /// This must outlive them.
  PointDirections Get() const
  {
    PointDirections directions = DirectionsOf(this->Degree, this->Directions);
    if (!this->Magnitudes.empty())
    {
      directions.Magnitude = [this](Index point) { return this->Magnitudes[point]; };
    }
    return directions;
  }

  SharedSurface Mesh;
  int Degree;
  std::vector<Vector3> Directions;
  std::vector<double> Magnitudes;
};
using SharedGiven = std::shared_ptr<Given>;
}

#endif
