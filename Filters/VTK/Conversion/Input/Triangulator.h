// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef Triangulator_h
#define Triangulator_h

#include "Conversion/Input/TriangulatedPolyData.h"

#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolygon.h"
#include "vtkType.h"

#include <vector>

namespace DirectionFields
{
/// Cuts cells into triangles, and appends these to a surface. The cells have no points that are not
/// there.
class Triangulator
{
public:
  /// @param points and result must outlive the object
  Triangulator(vtkPoints* points, TriangulatedPolyData& result);

  /// Unrolls a triangle strip; all its triangles are wound as the first one is.
  void AddStrip(vtkIdType cell, vtkIdType size, const vtkIdType* points);
  /// Cuts a polygon by its ears; one that cannot be cut so becomes a fan, or any other set of
  /// triangles if it has many corners.
  void AddPolygon(vtkIdType cell, vtkIdType size, const vtkIdType* points);
  /// Cuts a polygon as one that was added before, which has the same corners.
  /// @param isReversed the polygons run in opposite directions
  void AddCopy(vtkIdType cell, vtkIdType earlierCell, bool isReversed);

private:
  void AddTriangle(vtkIdType cell, vtkIdType i, vtkIdType j, vtkIdType k);
  /// The corners without consecutive repetitions, which would disturb the cutting of ears.
  void SetCorners(vtkIdType size, const vtkIdType* points);
  /// Cuts the polygon as it is best for that. False if it cannot be cut; else Ears holds the
  /// triangles as positions in Corners.
  bool Cut();
  /// Cuts it with VTK's vtkPolygon.
  bool CutWithVTK();
  /// Cuts it with CutEars of Surfaces.
  bool CutWithCore(bool force);

  vtkPoints* Points;
  TriangulatedPolyData& Result;
  std::vector<vtkIdType> Corners;
  vtkNew<vtkPolygon> Polygon;
  std::vector<Vector3> Places;
  std::vector<vtkIdType> Ears;
  vtkNew<vtkIdList> EarIds;
  vtkNew<vtkPoints> EarPoints;
};
}

#endif
