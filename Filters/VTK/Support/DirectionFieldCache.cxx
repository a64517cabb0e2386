// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Support/DirectionFieldCache.h"

#include "Support/SameSurface.h"

#include <utility>

namespace DirectionFields
{
void DirectionFieldCache::SetInput(
  vtkPolyData* input, const std::optional<double>& time, const Progress& progress)
{
  this->Follows = false;
  if (this->Solver && IsSurfaceOf(input, *this->Surface))
  {
    return;
  }
  auto surface = std::make_shared<TriangulatedPolyData>(PolyDataToSurface(input, progress));
  if (this->Solver && IsSameSurface(surface->Mesh, this->Surface->Mesh))
  {
    this->Surface->CellOfTriangle = std::move(surface->CellOfTriangle);
    this->Surface->FirstCell = surface->FirstCell;
    return;
  }
  // Polygons may be cut otherwise than before; that the points stay the same ones is enough.
  this->Follows = this->Solver && time && this->Time && *time != *this->Time &&
    surface->Mesh.Points.size() == this->Surface->Mesh.Points.size() &&
    surface->CellOfTriangle == this->Surface->CellOfTriangle &&
    surface->FirstCell == this->Surface->FirstCell;
  // The old surface's data are released before the solver of the new one needs memory.
  this->Solver.reset();
  this->Surface = std::move(surface);
  this->Solver.emplace(
    std::shared_ptr<const DirectionFields::Surface>(this->Surface, &this->Surface->Mesh));
  if (this->Follows)
  {
    this->Solver->SetPhaseReference(std::move(this->Directions), this->Degree);
  }
  this->Time = time;
  this->Directions.clear();
}

std::vector<Vector3> DirectionFieldCache::GetPrevious(bool isNextStep, int degree)
{
  if (isNextStep && !this->Follows && !this->Directions.empty())
  {
    this->Solver->SetPhaseReference(this->Directions, this->Degree);
  }
  return this->Solver->GetPhaseReference(degree);
}

void DirectionFieldCache::SetField(const Result& field)
{
  if (this->Time)
  {
    this->Degree = field.Degree;
    this->Directions.resize(this->Surface->Mesh.Points.size());
    for (size_t i = 0; i < this->Directions.size(); ++i)
    {
      this->Directions[i] =
        std::abs(field.Representation[i]) * field.Direction(static_cast<int>(i), 0);
    }
  }
}
}
