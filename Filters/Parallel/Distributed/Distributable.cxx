// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distributed/DistributedField.h"

namespace DirectionFields::Parallel
{
std::string WhyNotDistributed(const Options& options)
{
  if (options.Alignment != Alignment::None)
  {
    return "Alignment needs the whole surface";
  }
  if (options.ConstrainBoundary || options.ConstrainSharpEdges || options.ConstrainCurvature ||
    options.ConstrainGuidance)
  {
    return "constraints need the whole surface";
  }
  if (options.UnitLength)
  {
    return "Unit Length needs the whole surface";
  }
  if (options.IntrinsicDelaunay)
  {
    return "Intrinsic Delaunay needs the whole surface";
  }
  if (options.MergePoints == MergePoints::On)
  {
    return "Merge Points joins points wherever they are; Automatic does not need the whole surface";
  }
  if (options.Solver == Solver::Direct)
  {
    return "Solver Direct needs the whole surface";
  }
  return {};
}
}
