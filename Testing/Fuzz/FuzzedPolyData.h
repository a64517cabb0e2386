// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef FuzzedPolyData_h
#define FuzzedPolyData_h

#include <cstddef>
#include <cstdint>
#include <string>

/// Makes polydata, which may contradict itself, and options of any bytes, and applies both filters to
/// it. Says what does not hold of their outputs; empty if all does.
std::string FuzzedPolyData(const std::uint8_t* data, std::size_t size);

#endif
