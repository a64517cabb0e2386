// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_EditedResult_h
#define DirectionFields_EditedResult_h

#include "PrescribedSingularities/SingularityEditor.h"
#include "Result.h"

#include <string>
#include <vector>

namespace DirectionFields
{
/// An edited field over the points and triangles of the editor's surface, as
/// DirectionField::Compute gives one: with directions at each point and the singularity index of
/// each triangle. Result::Notes are those of the edit, and Result::Components has the counts and
/// indices of each component, but no eigenvalue.
/// @param edited of an edit by this editor
Result ToResult(const SingularityEditor& editor, const EditedField& edited);

/// The guidance that Options::Alignment names, for SingularityEditor::SetGuidance: a section over
/// the vertices of the editor's mesh; empty where it is zero everywhere. Throws
/// std::invalid_argument for options out of range, and for curvature with a degree other than 2 and
/// 4.
/// @param options  Degree (that of the editor's field), Alignment and CurvatureDirection count
/// @param guidance one vector a point of the surface, for Alignment::PointVectors
/// @param notes    gets a sentence for the user where an alignment is zero everywhere
std::vector<Complex> GuidanceFor(const SingularityEditor& editor, const Options& options,
  const Guidance& guidance, std::vector<std::string>& notes);
}

#endif
