// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_DrawingReports_h
#define DirectionFields_DrawingReports_h

#include "Glyphs.h"
#include "Streamlines.h"
#include "Stripes.h"

#include <string>
#include <vector>

namespace DirectionFields
{
/// One line in ASCII that describes what was drawn. Lengths are in the surface's unit, with three
/// digits.
std::string Summary(const Streamlines& lines, SeedType seeds);
std::string Summary(const StripePattern& pattern);
std::string Summary(const Glyphs& glyphs);

/// Sentences for the user, which name the remedy: on lines that were left out; on an offset that a
/// line field cannot have, and a mesh that is too coarse for the stripes.
std::vector<std::string> Warnings(const Streamlines& lines, const StreamlineOptions& options);
std::vector<std::string> Warnings(const StripePattern& pattern, const StripeOptions& options);
}

#endif
