// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remesh.h"

#include "Curves/CurveCut.h"
#include "Preparation/PreparedField.h"
#include "Preparation/SurfaceUnit.h"

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

namespace DirectionFields
{
namespace
{
void RequireFinite(const std::vector<std::vector<Vector3>>& curves)
{
  for (std::size_t k = 0; k < curves.size(); ++k)
  {
    for (std::size_t i = 0; i < curves[k].size(); ++i)
    {
      if (!curves[k][i].allFinite())
      {
        throw std::invalid_argument("Point " + std::to_string(i) + " of curve " +
          std::to_string(k) + " has a coordinate that is NaN or infinite. Remove it.");
      }
    }
  }
}
}

Remesh::Remesh(
  std::shared_ptr<const Surface> surface, const std::vector<std::vector<Vector3>>& curves)
  : Origin(OriginFor(*surface))
  , Unit(UnitFor(*surface))
  , Given(InUnit(std::move(surface), this->Origin, this->Unit))
  , Input(this->Given)
{
  if (!curves.empty())
  {
    RequireFinite(curves);
    this->Cut =
      std::make_unique<CurveCut>(CutAlong(*this->Given, InUnit(curves, this->Origin, this->Unit)));
    this->Input = std::shared_ptr<const Surface>(this->Given, &this->Cut->Cut);
  }
}
Remesh::~Remesh() = default;
Remesh::Remesh(Remesh&&) noexcept = default;
Remesh& Remesh::operator=(Remesh&&) noexcept = default;
}
