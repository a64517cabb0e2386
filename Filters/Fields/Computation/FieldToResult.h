// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FieldToResult_h
#define DirectionFields_FieldToResult_h

#include "Computation/ComponentFields.h"
#include "Mesh/OutputPoints.h"

#include <string>
#include <vector>

namespace DirectionFields::Internal
{
/// A vector has faded where it is shorter than this part of its component's longest: the residual
/// that counts as solved lets it turn anywhere.
constexpr double FadedPart = 1e-5;
/// Says that most directions are arbitrary, and how to get others, where most are.
/// @param share of the vertices whose vectors have faded
void NoteFading(double share, std::vector<std::string>& notes);

/// The field and its figures as the caller gets them: over the points and triangles of the input.
/// @param notes the sentences for the user
Result ToResult(Stages& stages, const Options& options, const Guide& guide, ComponentFields fields,
  std::vector<std::string> notes);

/// Fills in everything that follows from a section alone, wherever it comes from: the arrays over
/// points and triangles, and in each component's report the counts and the sum of the indices.
/// Makes the reports if there are none.
/// @param result whose Degree is set
void AddSection(const SurfaceGeometry& geometry, const Surface& surface, const OutputPoints& points,
  const std::vector<Complex>& section, Result& result);
}

#endif
