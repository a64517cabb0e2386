// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSurfaceStrokes
 * @brief curves that were drawn on a surface
 *
 * A source of poly lines for vtkGuidanceCurves, one for each stroke. A stroke of one point has no
 * line. Under several processes all lines are on the first one. It has the arrays
 * - `Stroke`, of the cells, vtkIdType: the number of the stroke;
 * - `Strength`, of the cells, double: 1 for hard strokes, less for soft ones;
 * - `Color`, of the points, three unsigned char: orange, and white in the gaps of soft strokes, which
 *   are dashed. These have further points where dashes begin and end.
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

  ///@{
  /**
   * The strength of the stroke of a number, 0 to 1, which is where numbers outside of that go; the
   * last one counts. Default: 1 for all.
   */
  void AddStrength(double stroke, double strength);
  void RemoveAllStrengths();
  ///@}

protected:
  vtkSurfaceStrokes();
  ~vtkSurfaceStrokes() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  double StrengthOf(double stroke) const;
  /// The length of a dash: a small part of the box around all strokes.
  double Dash() const;

  std::vector<std::array<double, 4>> Points;
  std::vector<std::array<double, 2>> Strengths;

  vtkSurfaceStrokes(const vtkSurfaceStrokes&) = delete;
  void operator=(const vtkSurfaceStrokes&) = delete;
};

#endif
