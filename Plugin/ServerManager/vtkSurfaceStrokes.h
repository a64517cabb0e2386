// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSurfaceStrokes
 * @brief curves that were drawn on a surface
 *
 * A source of poly lines for vtkGuidanceCurves, one for each stroke, with the cell array `Stroke`:
 * vtkIdType, the number of the stroke. A stroke of one point has no line. Under several processes
 * all lines are on the first one.
 */

#ifndef vtkSurfaceStrokes_h
#define vtkSurfaceStrokes_h

#include "vtkDirectionFieldsServerManagerModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <array>
#include <vector>

class VTKDIRECTIONFIELDSSERVERMANAGER_EXPORT vtkSurfaceStrokes : public vtkPolyDataAlgorithm
{
public:
  static vtkSurfaceStrokes* New();
  vtkTypeMacro(vtkSurfaceStrokes, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Appends a point to the stroke of a number. Where the number is another one than that of the
   * point before, a new line begins. Default: none.
   */
  void AddPoint(double stroke, double x, double y, double z);
  void RemoveAllPoints();
  ///@}

protected:
  vtkSurfaceStrokes();
  ~vtkSurfaceStrokes() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  std::vector<std::array<double, 4>> Points;

  vtkSurfaceStrokes(const vtkSurfaceStrokes&) = delete;
  void operator=(const vtkSurfaceStrokes&) = delete;
};

#endif
