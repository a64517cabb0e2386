// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FieldSummary_h
#define DirectionFields_FieldSummary_h

#include "Comparison/FieldDifference.h"
#include "Computation/SurfaceFigures.h"
#include "Guidance/CurveGuidance.h"
#include "Guidance/SurfaceTensors.h"
#include "Options.h"
#include "PrescribedSingularities/EditOptions.h"
#include "PrescribedSingularities/SingularityEditor.h"
#include "Result.h"

#include <cstddef>
#include <string>
#include <vector>

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

/// The part of that line about the tensors that a field follows, for instance
///
///     , along Stress: 2 wedges, 2 trisectors, 3 % isotropic
///
/// @param name of the array
std::string DescribeTensors(const TensorGuidance& tensors, const std::string& name,
  const SurfaceFigures& figures, int degree);

/// The same of guidance along curves and of comparisons. Angles are in degrees, with three digits.
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
