// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

// What DistributedField.h declares, for builds without PETSc or MPI.
#include "Distributed/DistributedField.h"

#include <stdexcept>

namespace DirectionFields::Parallel
{
bool CanDistribute()
{
  return false;
}

DistributedField ComputeDistributed(Processes&, const Surface&, const SurfacePiece&, const Options&,
  const Guidance&, const std::function<bool(double)>&)
{
  throw std::logic_error("This build has no PETSc.");
}

vtkIdType ExchangeValues(
  Processes&, const PointExchange&, const SurfacePiece&, vtkPolyData*, vtkPolyData*)
{
  return 0;
}
}
