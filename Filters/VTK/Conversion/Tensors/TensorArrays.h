// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef TensorArrays_h
#define TensorArrays_h

#include "Conversion/Input/TriangulatedPolyData.h"

#include <DirectionFields/Guidance/SurfaceTensors.h>
#include <DirectionFields/Types.h>

#include "vtkType.h"

#include <string>

class vtkDataArray;
class vtkPointData;
class vtkPolyData;

namespace DirectionFields
{
namespace ArrayNames
{
constexpr const char* MajorValue = "MajorValue";
constexpr const char* MinorValue = "MinorValue";
constexpr const char* TensorAnisotropy = "TensorAnisotropy";
constexpr const char* SurfaceTensor = "SurfaceTensor";
/// Of lines and glyphs: the value of SurfaceTensor along them.
constexpr const char* PrincipalValue = "PrincipalValue";
}

/// The tensors of an array at the points or the triangles of a surface. Throws
/// std::invalid_argument where there is no array of that name with 6 or 9 components, and where the
/// tensor of a cell in use is not finite.
SurfaceTensors PolyDataToTensors(vtkPolyData* polyData, const TriangulatedPolyData& surface,
  bool areOfCells, const std::string& name);

/// Adds the principal values, the anisotropy and the averaged tensors to the point data.
/// @param type VTK_DOUBLE for arrays of doubles, else they are of floats
void AddTensorArrays(const TensorGuidance& guidance, int type, vtkPolyData* output);
/// Removes them, where an earlier filter left them.
void RemoveTensorArrays(vtkPointData* data);

/// The averaged tensors that a field has in its point data.
class TensorsAlong
{
public:
  explicit TensorsAlong(vtkPolyData* field);

  bool AreThere() const { return this->Array != nullptr; }
  /// The value along a unit vector at a point.
  double At(vtkIdType point, const Vector3& direction) const;

private:
  vtkDataArray* Array;
};
}

#endif
