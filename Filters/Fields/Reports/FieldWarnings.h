// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FieldWarnings_h
#define DirectionFields_FieldWarnings_h

#include "Options.h"
#include "Result.h"
#include "Surface.h"

#include <string>
#include <vector>

namespace DirectionFields
{
/// A sentence for the user on the faults that were mended in a mesh; empty where there were none.
std::string DescribeRepairs(const Repairs& repaired);

/// The warnings about a field: one text each if the surface had to be repaired, if an option
/// changed nothing, if a linear system was not solved, and if an eigenvalue problem was not. Each
/// names the remedy.
std::vector<std::string> Warnings(const Result& field, const Options& options);
}

#endif
