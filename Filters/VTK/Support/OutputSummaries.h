// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef OutputSummaries_h
#define OutputSummaries_h

#include <DirectionFields/Comparison/FieldDifference.h>
#include <DirectionFields/Glyphs.h>
#include <DirectionFields/Guidance/CurveGuidance.h>
#include <DirectionFields/PrescribedSingularities/SingularityEditor.h>
#include <DirectionFields/Remesh.h>
#include <DirectionFields/Result.h>
#include <DirectionFields/Streamlines.h>
#include <DirectionFields/Stripes.h>

#include <cstddef>
#include <string>
#include <vector>

namespace DirectionFields
{
/// One line in ASCII that describes what a filter has made. Lengths are in the surface's unit,
/// with three digits.
std::string Summary(const Streamlines& lines, SeedType seeds);
std::string Summary(const StripePattern& pattern);
std::string Summary(const RemeshResult& mesh, double leastScaledJacobian);
std::string Summary(const Glyphs& glyphs);
/// @param curves number of the curves
std::string Summary(const CurveGuidance& guidance, std::size_t curves);
/// @param singularities of both fields; null where they were not matched
std::string Summary(
  const FieldDifference& difference, const std::vector<ComparedSingularity>* singularities);
/// Of a field from a file.
/// @param name of the file
std::string SummaryOfFile(const Result& field, const std::string& name);
std::string SummaryOfEdit(
  const Result& field, const EditedField& edited, RotationObjective objective);
}

#endif
