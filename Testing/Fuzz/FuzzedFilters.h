// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FuzzedFilters_h
#define DirectionFields_FuzzedFilters_h

#include <cstddef>
#include <cstdint>
#include <string>

/// Which filters are executed.
enum class FilterGroup
{
  Streamlines,
  Edits,
  Comparison,
  /// Any filter, and another one that takes the output of the first.
  Pairs
};

/// Executes filters on the mesh, the field and with the options that any bytes stand for.
/// @param isSmall whether surfaces and meshes of few triangles and faces are to stand for large
///                ones: what takes a hundred times as long hardly ever goes other ways
/// @return the first statement that does not hold; empty if all do
std::string FuzzedFilters(
  FilterGroup group, const std::uint8_t* data, std::size_t size, bool isSmall = false);

#endif
