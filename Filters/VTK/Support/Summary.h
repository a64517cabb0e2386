// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef Summary_h
#define Summary_h

#include <DirectionFields/Computation/SurfaceFigures.h>
#include <DirectionFields/Options.h>
#include <DirectionFields/Result.h>

#include <string>

namespace DirectionFields
{
/// One line in ASCII that describes a field: the number of its singularities, their sum, the solver
/// where it failed to converge, and the options that shaped it. For instance
///
///     32 singularities (20 +, 12 -), index sum 8, 24 points constrained
///
/// The documentation of vtkDirectionField lists the other parts.
/// @param figures of the whole surface
std::string Summary(const SurfaceFigures& figures, const Result& field, const Options& options);
}

#endif
