// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SurfaceSampling_h
#define DirectionFields_SurfaceSampling_h

#include "Paths/SurfaceIncidence.h"
#include "Progress.h"
#include "Types.h"

#include <vector>

namespace DirectionFields::Internal
{
struct SamplingOptions
{
  /// Least distance between two samples, in the unit of the surface. 0: as small as MaximumNumber
  /// allows. Enlarged where it would give more samples than that; no more than the diagonal of the
  /// box around the surface, beyond which there is nothing to keep a distance from.
  double Spacing = 0.0;
  /// Most samples.
  Index MaximumNumber = 2000;
};

/// Points spread evenly over a surface.
struct SurfaceSamples
{
  std::vector<SurfacePoint> Points;
  /// The distance that was kept; 0 without samples.
  double Spacing = 0.0;
};

/// Samples with a Poisson-disk distribution: no two on the same side of the surface (DiskGrid.h)
/// are nearer to each other than the spacing, and no room is left for another.
///
/// Candidates that cover the surface densely and evenly (by area, with the additive recurrence of
/// the plastic number) are taken in a scrambled order if nothing is too near, then moved along the
/// surface towards the middle of the candidates nearest to them where the distance allows it
/// (Lloyd's iteration), and the room that this opens is filled. A hash grid with cells of the
/// spacing finds the samples nearby, so that the time is linear in triangles and samples. There is
/// no randomness: the same surface gives the same samples.
///
/// Throws Stopped.
/// @param excluded not 0 for triangles without samples; empty for none
SurfaceSamples SampleSurface(const SurfaceIncidence& surface, const std::vector<char>& excluded,
  const SamplingOptions& options, const Progress& progress = {});

/// All points that a sound triangle uses, in their order; where these are more than the maximum
/// number, an evenly spread part of them. Spacing is the distance kept between the latter, else 0.
///
/// Throws Stopped.
/// @param excluded not 0 for points not to be taken; empty for none
SurfaceSamples SamplePoints(const SurfaceIncidence& surface, const std::vector<char>& excluded,
  Index maximumNumber, const Progress& progress = {});
}

#endif
