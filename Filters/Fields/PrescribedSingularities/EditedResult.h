// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_EditedResult_h
#define DirectionFields_EditedResult_h

#include "PrescribedSingularities/SingularityEditor.h"
#include "Result.h"

namespace DirectionFields::Internal
{
/// An edited field over the points and triangles of its surface, as the computation of a field gives one.
Result ToResult(const SingularityEditor& editor, const EditedField& edited);

/// What a field may be drawn to, as a section over the vertices of the mesh; empty where it is zero everywhere, with a
/// note. Throws std::invalid_argument for curvature and a degree that has none.
/// @param guidance of the surface's points, for Alignment::PointVectors
std::vector<Complex> GuidanceFor(const SingularityEditor& editor, const Options& options,
  const Guidance& guidance, std::vector<std::string>& notes);
}

#endif
