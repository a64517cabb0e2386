// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DuplicatePolygons_h
#define DuplicatePolygons_h

#include "vtkType.h"

#include <functional>
#include <unordered_map>

class vtkCellArray;

namespace DirectionFields
{
/// Which polygons of more than three corners go around the same points as an earlier one, whichever
/// corner they start at, in the same or in the opposite direction. Corners that are repeated one
/// after the other count once. Takes time linear in the corners.
class DuplicatePolygons
{
public:
  struct Earlier
  {
    /// The number of the first polygon around these points; -1 if it is this one.
    vtkIdType Polygon = -1;
    bool IsReversed = false;
  };

  /// @param isHidden whether a polygon is not to be looked at
  DuplicatePolygons(vtkCellArray* polygons, const std::function<bool(vtkIdType)>& isHidden);

  Earlier Of(vtkIdType polygon) const
  {
    if (this->Duplicates.empty())
    {
      return {};
    }
    const auto found = this->Duplicates.find(polygon);
    return found == this->Duplicates.end() ? Earlier() : found->second;
  }

private:
  std::unordered_map<vtkIdType, Earlier> Duplicates;
};
}

#endif
