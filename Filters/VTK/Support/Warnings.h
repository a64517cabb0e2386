// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef Warnings_h
#define Warnings_h

#include <DirectionFields/Options.h>
#include <DirectionFields/Result.h>

#include <string>
#include <vector>

namespace DirectionFields
{
/// The warnings about a field: one text each if the surface had to be repaired, if an option
/// changed nothing, if a linear system was not solved, and if an eigenvalue problem was not. Each
/// names the remedy.
std::vector<std::string> Warnings(const Result& field, const Options& options);
}

#endif
