// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

// The entries of the library Cluster, for builds without it.
#include "Distributable.h"
#include "DistributedField.h"

#include <stdexcept>

namespace DirectionFields::Parallel
{
bool CanDistribute()
{
  return false;
}

std::string WhyNotDistributed(const Options&)
{
  return "this build has no PETSc";
}

DistributedField ComputeDistributed(Processes&, const Surface&, const SurfacePiece&, const Options&,
  const Guidance&, const std::vector<Vector3>&, const std::function<bool(double)>&)
{
  throw std::logic_error("This build has no PETSc.");
}

vtkIdType ExchangeValues(
  Processes&, const PointExchange&, const SurfacePiece&, vtkPolyData*, vtkPolyData*)
{
  return 0;
}
}
