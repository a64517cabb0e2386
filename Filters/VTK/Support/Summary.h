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
/// One line in ASCII that says what a field is like: how many singularities it has, their sum, how the
/// solver ended, and what the field was made with. For instance
///
///     32 singularities (20 +, 12 -), index sum 8, converged in 15 iterations
///
/// The documentation of vtkDirectionField tells what else it may say.
/// @param figures of the whole surface
std::string Summary(const SurfaceFigures& figures, const Result& field, const Options& options);
}

#endif
