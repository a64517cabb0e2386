// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ComponentSetup_h
#define DirectionFields_ComponentSetup_h

#include "Computation/ComponentStage.h"
#include "Geometry/SurfaceGeometry.h"
#include "Options.h"
#include "Progress.h"

#include <cstddef>

namespace DirectionFields::Internal
{
/// The order of magnitude of the smallest eigenvalue of a component, in 1 / unit^2.
double SmallestScale(const SurfaceGeometry& geometry, std::size_t component, int degree);

/// Assembles the matrices of a component and finds its smallest eigenpair, in the phase that
/// follows from its shape alone. Throws Stopped.
/// @param triangulation of the same vertices, which the matrices are assembled on
ComponentStage SetUpComponent(const SurfaceGeometry& geometry, std::size_t component,
  const IntrinsicGeometry& triangulation, const Options& options, const Progress& progress);
}

#endif
