// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGuidanceCurves
 * @brief makes guidance vectors and weights for direction fields of curves on a surface
 *
 * vtkGuidanceCurves turns strokes into the guidance of vtkDirectionField: poly lines and splines
 * that were placed on the surface, feature edges, contours, curves of a design. The tangents of the
 * curves are laid into the nearest triangles and carried to their corners; there they are added up
 * as n-th powers, so that
 * - curves that are drawn in opposite senses agree for even n;
 * - curves that cross at right angles agree for cross fields (n = 4), and cancel for line fields (n
 *   = 2), which get no guidance there.
 *
 * With a Radius, vertices farther away are guided, too, with weights that fall with the distance
 * along the surface as a Gaussian does.
 *
 * Lines with the cell array `Strength`, 0 to 1, are held as strongly as that: those of strength 1,
 * and of data without the array, exactly, the others by a term of the energy; see
 * vtkDirectionField's GuidanceStrengths, which takes the array of that name.
 *
 * For hard constraints take Radius 0 and vtkDirectionField's ConstrainGuidance with both arrays; to
 * draw the field only, its Alignment ALIGN_POINT_VECTORS with GuidanceVectors, whose lengths are
 * the weights.
 *
 * @section Input Input
 * Port 0: a surface of polygons or strips, or a composite dataset of such. Port 1: a vtkPolyData
 * with lines, or a composite dataset of such. Its polygons and vertices do not count. Without any
 * connection to port 1 the output is the surface as it is, with a warning.
 *
 * Of several surfaces each is guided only by the pieces of the curves that are nearest to it. Where
 * others are as near, within a tenth of the least mean length of edges, as beside a seam, a piece
 * goes to the one that most of its curve is as near to. On several processes that is not so: each
 * block follows all curves at its points that are nearest to them.
 *
 * @section Output Output
 * The surface with the point data
 * - `GuidanceVectors`: 3 components, double if the points are, else float. One of the n directions,
 *   of the length of the weight; zero where there is no guidance.
 * - `GuidanceWeights`: 1 component of the same type, 0 to 1. 1 on a curve, less with the distance
 *   from it and where curves do not agree.
 * - `GuidanceStrengths`, where any curves have a `Strength`: 1 component of the same type. 1
 *   at the points of curves of strength 1, else that of the softer ones' mean stiffness, tau / (1 -
 *   tau); 0 where there is no guidance.
 *
 * and, at blocks that no curve guides while others are guided, the field data `GuidedElsewhere`
 * (int, 1): vtkDirectionField then follows no guidance there, and does not complain that there is
 * none.
 *
 * Port 1, to be looked at: the curves, and through each guided point a line along its vector, one
 * mean edge long times the weight, with the cell data `Kind` (unsigned char): 0 for curves, 1 for
 * these lines.
 *
 * @section Kept What is kept
 * The surface and the tree in which the nearest triangles are found are kept for the next
 * execution, which takes a fraction of the time if only the curves have changed, about 500 bytes a
 * triangle. Blocks are compared in their order. The results are the same to the byte.
 *
 * @sa
 * vtkDirectionField
 */

#ifndef vtkGuidanceCurves_h
#define vtkGuidanceCurves_h

#include "vtkDirectionFieldAlgorithm.h"
#include "vtkDirectionFieldsFiltersModule.h" // For export macro

#include <cstddef> // For std::size_t
#include <memory>  // For std::unique_ptr
#include <vector>

class vtkPolyData;

namespace DirectionFields
{
struct CurveGuidanceOptions;
}

class VTKDIRECTIONFIELDSFILTERS_EXPORT vtkGuidanceCurves : public vtkDirectionFieldAlgorithm
{
public:
  static vtkGuidanceCurves* New();
  vtkTypeMacro(vtkGuidanceCurves, vtkDirectionFieldAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The curves, which become the input of port 1.
   */
  void SetCurvesConnection(vtkAlgorithmOutput* output);
  void SetCurvesData(vtkDataObject* curves);
  ///@}

  ///@{
  /**
   * The degree n of the field that is to be guided. Range 1 to 16, default 4.
   */
  vtkSetClampMacro(Degree, int, 1, 16);
  vtkGetMacro(Degree, int);
  ///@}

  ///@{
  /**
   * How far from the curves points are guided, along the surface, in its unit of length. 0: only
   * the corners of the triangles that the curves run through. Range 0 to VTK_DOUBLE_MAX, default 0.
   */
  vtkSetClampMacro(Radius, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * The standard deviation of the Gaussian by which weights fall with the distance, relative to
   * Radius. Range 0.01 to 100, default 0.5.
   */
  vtkSetClampMacro(Falloff, double, 0.01, 100.0);
  vtkGetMacro(Falloff, double);
  ///@}

  ///@{
  /**
   * Parts of the curves that are farther from the surface are left out, in its unit of length. 0:
   * none. Range 0 to VTK_DOUBLE_MAX, default 0.
   */
  vtkSetClampMacro(MaximumDistance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumDistance, double);
  ///@}

protected:
  vtkGuidanceCurves();
  ~vtkGuidanceCurves() override;

  bool TakesBlocks() const override { return true; }
  int FillInputPortInformation(int port, vtkInformation* info) override;
  void Execute(
    const Ports& inputs, const Ports& outputs, const DirectionFields::Progress& progress) override;

private:
  vtkGuidanceCurves(const vtkGuidanceCurves&) = delete;
  void operator=(const vtkGuidanceCurves&) = delete;

  struct Kept;
  /// A surface of the input, and its outputs.
  struct Block
  {
    std::size_t Number;
    vtkPolyData* Input;
    vtkPolyData* Output;
    vtkPolyData* Strokes;
  };
  /// Gives composite outputs the structure of the input, and empty blocks for its surfaces.
  std::vector<Block> BlocksOf(const Ports& inputs, const Ports& outputs);
  /// Reads the surface of a block, unless it is that of the last one.
  Kept& Read(vtkPolyData* input, std::size_t block, const DirectionFields::Progress& progress);
  DirectionFields::CurveGuidanceOptions MakeOptions() const;

  /// For each block of the last input.
  std::vector<std::unique_ptr<Kept>> Last;
  int Degree;
  double Radius;
  double Falloff;
  double MaximumDistance;
};

#endif
