// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadedSurface
 * @brief a surface with normals for smooth shading, which are kept while only its data change
 *
 * vtkShadedSurface gives what vtkPolyDataNormals gives with a FeatureAngle and without Consistency:
 * the surface with point normals, split along sharp edges. While a stroke, a singularity or a slider
 * changes the field on a surface, that stays the same: points, cells and normals are then those of
 * the last execution, the same objects, so that neither their ranges nor the buffers of a renderer
 * are made anew, and only the other arrays are passed on.
 *
 * @section Input Input
 * A vtkPolyData; of composite datasets each block.
 *
 * @section Output Output
 * The surface with the point data `Normals` (float, 3 components) beside all arrays of the input. On
 * several processes a layer of ghost cells is asked for and taken away again, so that normals agree
 * where pieces meet.
 */

#ifndef vtkShadedSurface_h
#define vtkShadedSurface_h

#include "vtkDirectionFieldsServerManagerModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory>
#include <vector>

class VTKDIRECTIONFIELDSSERVERMANAGER_EXPORT vtkShadedSurface : public vtkPolyDataAlgorithm
{
public:
  static vtkShadedSurface* New();
  vtkTypeMacro(vtkShadedSurface, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Edges whose faces turn by more are sharp, in degrees. Range 0 to 180, default 60.
   */
  vtkSetClampMacro(FeatureAngle, double, 0.0, 180.0);
  vtkGetMacro(FeatureAngle, double);
  ///@}

protected:
  vtkShadedSurface();
  ~vtkShadedSurface() override;

  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkShadedSurface(const vtkShadedSurface&) = delete;
  void operator=(const vtkShadedSurface&) = delete;

  class Shape;
  /// What is kept of an input with the same points and cells, or else made of it.
  Shape& ShapeOf(vtkPolyData* input, bool hasGhosts, double time);

  double FeatureAngle;
  /// One for each block of the last inputs.
  std::vector<std::unique_ptr<Shape>> Shapes;
  /// When the pipeline was changed that they are of, and their time.
  vtkMTimeType Pass;
  double PassTime;
};

#endif
