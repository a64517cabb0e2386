// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distributable.h"

namespace DirectionFields::Parallel
{
std::string WhyNotDistributed(const Options& options)
{
  if (options.ConstrainCurvature)
  {
    return "Constrain Curvature needs the whole surface";
  }
  if (options.ConstrainSharpEdges)
  {
    return "Constrain Sharp Edges needs the whole surface";
  }
  if ((options.ConstrainBoundary || options.ConstrainGuidance) &&
    options.ConstraintSolver == ConstraintSolver::LeastSquares)
  {
    return "least squares need the whole surface";
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
