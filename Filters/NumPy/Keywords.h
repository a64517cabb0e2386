// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef Keywords_h
#define Keywords_h

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace DirectionFields
{
/// The options that a function of Python was given by keyword. Whoever reads them describes them:
/// a function without options given tells the defaults and ranges.
class Keywords
{
public:
  using Names = std::vector<std::string>;

  Keywords(std::string function, py::dict given)
    : Function(std::move(function))
    , Given(std::move(given))
  {
  }

  /// A number or a flag.
  /// @param range of numbers: the least, the most and the unit
  template <class T, class... Range>
  void operator()(const std::string& keyword, T& value, Range... range)
  {
    this->Described[py::str(keyword)] = py::make_tuple(value, range...);
    if (this->Given.contains(keyword))
    {
      Take(value, keyword, this->Given[py::str(keyword)]);
    }
  }

  /// An enumeration from 0, by its names.
  template <class T>
  void Choice(const std::string& keyword, T& value, const Names& names)
  {
    this->Described[py::str(keyword)] =
      py::make_tuple(names.at(static_cast<std::size_t>(value)), names);
    if (!this->Given.contains(keyword))
    {
      return;
    }
    const py::object given = this->Given[py::str(keyword)];
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

  /// Throws TypeError where others were given than were asked for.
  void RequireNoMore() const
  {
    for (const auto& item : this->Given)
    {
      if (!this->Described.contains(item.first))
      {
        throw py::type_error(this->Function + "() has no option '" +
          item.first.cast<std::string>() + "'; direction_fields.options('" + this->Function +
          "') lists those that there are.");
      }
    }
  }

  /// (default, least, most, unit) or (default,) of each, and (default, names) of choices.
  py::dict Described;

private:
  template <class T>
  static void Take(T& value, const std::string& keyword, const py::object& given)
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

  std::string Function;
  py::dict Given;
};
}

#endif
