// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Support/SingularityEditorCache.h"

#include "Conversion/Input/FieldArrays.h"
#include "Conversion/Input/PolyDataToField.h"
#include "Support/SameSurface.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <stdexcept>
#include <string>

namespace DirectionFields
{
namespace
{
/// The vector that each point is constrained to, zero where it is not; empty for none.
std::vector<Vector3> ConstraintsOf(vtkPolyData* input)
{
  vtkDataArray* const kind = input->GetPointData()->GetArray(ArrayNames::ConstraintKind);
  vtkDataArray* const direction = input->GetPointData()->GetArray(ArrayNames::ConstraintDirection);
  if (!kind || !direction)
  {
    return {};
  }
  if (kind->GetNumberOfComponents() != 1 || direction->GetNumberOfComponents() != 3)
  {
    throw std::invalid_argument(
      "The point arrays \"ConstraintKind\" and \"ConstraintDirection\" must have 1 and 3 components, as Direction "
      "Field makes them. Rename them, or turn Keep Constraints off.");
  }
  std::vector<Vector3> constraints(
    static_cast<std::size_t>(input->GetNumberOfPoints()), Vector3::Zero());
  bool any = false;
  for (std::size_t i = 0; i < constraints.size(); ++i)
  {
    if (kind->GetComponent(static_cast<vtkIdType>(i), 0) != 0.0)
    {
      direction->GetTuple(static_cast<vtkIdType>(i), constraints[i].data());
      any = true;
    }
  }
  return any ? constraints : std::vector<Vector3>();
}
}

std::vector<SingularityEditorCache::State> SingularityEditorCache::FieldOf(vtkPolyData* input)
{
  std::vector<State> states;
  const auto add = [&](const std::string& name)
  {
    vtkObject* const array = input->GetPointData()->GetAbstractArray(name.c_str());
    states.emplace_back(array, array ? array->GetMTime() : 0);
    return array != nullptr;
  };
  for (int k = 0; add(ArrayNames::Direction(k)); ++k)
  {
  }
  add(ArrayNames::RepresentationMagnitude);
  add(ArrayNames::ConstraintKind);
  add(ArrayNames::ConstraintDirection);
  return states;
}

SingularityEditorCache::Block SingularityEditorCache::Make(
  vtkPolyData* input, std::shared_ptr<TriangulatedPolyData> surface, bool keepsConstraints)
{
  Block block;
  block.Surface = std::move(surface);
  if (input->GetNumberOfPoints() > 0 && !block.Surface->Mesh.Triangles.empty())
  {
    block.Editor = std::make_unique<SingularityEditor>(block.Surface->Mesh,
      RequireDirections(input), keepsConstraints ? ConstraintsOf(input) : std::vector<Vector3>());
  }
  return block;
}

SingularityEditorCache::Block& SingularityEditorCache::Next(
  vtkPolyData* input, bool keepsConstraints, const Progress& progress)
{
  if (this->Position == this->Blocks.size())
  {
    this->Blocks.emplace_back();
  }
  Entry& entry = this->Blocks[this->Position];
  ++this->Position;
  std::vector<State> field = FieldOf(input);
  const bool isSame = entry.Kept.Editor && entry.Field == field &&
    entry.KeepsConstraints == keepsConstraints && IsSurfaceOf(input, *entry.Kept.Surface);
  if (isSame)
  {
    return entry.Kept;
  }
  auto surface =
    std::make_shared<TriangulatedPolyData>(PolyDataToSurface(input, progress.Part(0.0, 0.5)));
  if (entry.Kept.Editor && entry.Field == field && entry.KeepsConstraints == keepsConstraints &&
    IsSameSurface(surface->Mesh, entry.Kept.Surface->Mesh))
  {
    return entry.Kept;
  }
  // The old surface's data are released before the new one needs memory.
  entry = {};
  entry.Kept = Make(input, std::move(surface), keepsConstraints);
  entry.Field = std::move(field);
  entry.KeepsConstraints = keepsConstraints;
  progress.Report(1.0);
  return entry.Kept;
}
}
