// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_OptionTable_h
#define DirectionFields_OptionTable_h

#include <limits>

namespace DirectionFields
{
/// Ranges of options that have no upper limit: infinity is allowed for the first, and not for the
/// second.
constexpr double NoLimit = std::numeric_limits<double>::infinity();
constexpr double AnyFinite = std::numeric_limits<double>::max();
}

/// Every member of Options (Options.h), once: whatever is done to all of them (ranges, the key of
/// kept stages, defaults, printing and handing on in the filter for VTK, tests) is generated from
/// these rows. New options are appended, since the fuzzer's corpus stores one byte per row in this
/// order.
///
///   FLAG(name, stage)                      a bool
///   CHOICE(name, stage, last)              an enumeration from 0 to last
///   RANGE(name, stage, least, most, unit)  a number in a closed range; the unit is a text,
///                                          " degrees" or empty
#define DIRECTIONFIELDS_OPTIONS(FLAG, CHOICE, RANGE)                                               \
  RANGE(Degree, Energy, 1, 16, "")                                                                 \
  RANGE(EnergyBias, Energy, -1, 1, "")                                                             \
  RANGE(Tolerance, Energy, 1e-12, 0.1, "")                                                         \
  RANGE(MaximumIterations, Energy, 1, 10000, "")                                                   \
  RANGE(NumberOfThreads, None, 0, 1024, "")                                                        \
  CHOICE(Alignment, Field, 2)                                                                      \
  CHOICE(CurvatureDirection, Field, 3)                                                             \
  RANGE(AlignmentStrength, Field, 0, 1, "")                                                        \
  FLAG(UseShift, Field)                                                                            \
  RANGE(Shift, Field, 0, DirectionFields::AnyFinite, "")                                           \
  FLAG(ConstrainBoundary, Field)                                                                   \
  FLAG(ConstrainSharpEdges, Field)                                                                 \
  RANGE(FeatureAngle, Field, 0, 180, " degrees")                                                   \
  FLAG(ConstrainCurvature, Field)                                                                  \
  RANGE(CurvatureTolerance, Field, 0, DirectionFields::NoLimit, "")                                \
  RANGE(ConsistencyAngle, Field, 0, 180, " degrees")                                               \
  FLAG(DropConstraintsAtSingularities, Field)                                                      \
  FLAG(ConstrainGuidance, Field)                                                                   \
  CHOICE(ConstraintSolver, Field, 1)                                                               \
  CHOICE(Solver, Energy, 2)                                                                        \
  CHOICE(MergePoints, Mesh, 2)                                                                     \
  FLAG(IntrinsicDelaunay, Energy)                                                                  \
  RANGE(MinimumFeatureLength, Field, 0, DirectionFields::NoLimit, "")                              \
  FLAG(UnitLength, Field)                                                                          \
  RANGE(SingularityCost, Field, 0, 4, "")                                                          \
  RANGE(CurvatureScale, Field, 0, 32, "")                                                          \
  RANGE(NumberOfStarts, Field, 0, 1000, "")                                                        \
  FLAG(Preview, Field)

#endif
