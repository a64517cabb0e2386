// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remesh.h"

#include "Curves/CurveCut.h"
#include "Curves/LinesOnMesh.h"
#include "Preparation/PreparedField.h"
#include "Preparation/SurfaceUnit.h"
#include "SoftFeatures/Apices.h"

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

namespace DirectionFields
{
namespace
{
/// @param name of what has the point, for the user
void RequireFinite(const std::vector<Vector3>& points, const std::string& name)
{
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (!points[i].allFinite())
    {
      throw std::invalid_argument("Point " + std::to_string(i) + name +
        " has a coordinate that is NaN or infinite. Remove it.");
    }
  }
}
}

Remesh::Remesh(std::shared_ptr<const Surface> surface,
  const std::vector<std::vector<Vector3>>& curves, const std::vector<Vector3>& points)
  : Origin(OriginFor(*surface))
  , Unit(UnitFor(*surface))
  , Given(InUnit(std::move(surface), this->Origin, this->Unit))
  , Input(this->Given)
  , Points(std::make_unique<ChosenPoints>())
  , Tips(std::make_unique<Apices>(this->Given))
{
  for (std::size_t k = 0; k < curves.size(); ++k)
  {
    RequireFinite(curves[k], " of curve " + std::to_string(k));
  }
  RequireFinite(points, " of those given");
  if (!curves.empty() || !points.empty())
  {
    this->Lines = std::make_unique<GivenLines>();
    this->Lines->Curves = InUnit(curves, this->Origin, this->Unit);
    this->Lines->Points = InUnit({ points }, this->Origin, this->Unit).front();
  }
}

void Remesh::CutSurface(const Progress& progress)
{
  if (this->Lines && !this->Cut)
  {
    this->Cut = std::make_unique<CurveCut>(CutAlong(*this->Given, *this->Lines, progress));
    this->Input = std::shared_ptr<const Surface>(this->Given, &this->Cut->Cut);
  }
}

Remesh::~Remesh() = default;
Remesh::Remesh(Remesh&&) noexcept = default;
Remesh& Remesh::operator=(Remesh&&) noexcept = default;
}
