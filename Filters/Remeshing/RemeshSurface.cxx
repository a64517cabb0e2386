// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remesh.h"

#include "Curves/CurveCut.h"
#include "Preparation/PreparedField.h"
#include "Preparation/SurfaceUnit.h"

#include <utility>

namespace DirectionFields
{
Remesh::Remesh(
  std::shared_ptr<const Surface> surface, const std::vector<std::vector<Vector3>>& curves)
  : Origin(OriginFor(*surface))
  , Unit(UnitFor(*surface))
  , Given(InUnit(std::move(surface), this->Origin, this->Unit))
  , Input(this->Given)
{
  if (!curves.empty())
  {
    this->Cut =
      std::make_unique<CurveCut>(CutAlong(*this->Given, InUnit(curves, this->Origin, this->Unit)));
    this->Input = std::shared_ptr<const Surface>(this->Given, &this->Cut->Cut);
  }
}
Remesh::~Remesh() = default;
Remesh::Remesh(Remesh&&) noexcept = default;
Remesh& Remesh::operator=(Remesh&&) noexcept = default;
}
