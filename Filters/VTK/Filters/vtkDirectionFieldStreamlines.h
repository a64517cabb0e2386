// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkDirectionFieldStreamlines
 * @brief traces lines that follow all n directions of a direction field
 *
 * vtkDirectionFieldStreamlines follows the field that vtkDirectionField computes, or that a file
 * has. Lines cover the surface evenly, like hatching (default); or they are those that end in the
 * singularities, which divide the surface into patches; or they start at points of a second input.
 *
 * Within each triangle the n-th power of the directions is interpolated such that lines go on
 * across edges without a bend and wind around a triangle as its singularity index says; lines are
 * solutions of a Runge-Kutta method in the triangles laid flat and never leave the surface. A line
 * of a field of odd degree keeps its sense: it runs with the field or against it from end to end.
 *
 * @section Input Input
 * Port 0: a vtkPolyData like output port 0 of vtkDirectionField, triangles, polygons or triangle
 * strips with the point arrays `Direction0`, `Direction1`, ... of 3 components, unit tangent
 * vectors at equal angles. n is the number of these arrays, counted up to the first that is
 * missing. The point array `RepresentationMagnitude`, where there is one, weights the directions of
 * neighbouring points. Points at the same place with the same directions are one. An input without
 * polygons and strips gives empty outputs. Edges of more than two triangles end lines. On a surface
 * that cannot be oriented lines run on over both of its sides. Lines run into cells that
 * vtkGhostType marks as duplicates, but do not start there; hidden cells are as if they were not
 * there.
 *
 * Port 1 (optional): points at which lines start, for SeedType POINTS; of any vtkPointSet. Each is
 * moved to the nearest place of the surface.
 *
 * @section Output Output
 * Port 0, "Streamlines": poly lines with points that are double if the input's are, else float;
 * - point data `Normals`: 3-component float, active normals: of the surface, interpolated, outwards
 *   on closed surfaces.
 * - point data `Direction`: 3-component float, active vectors: unit vectors along the line.
 * - point data `ArcLength`: double, the length of the line from its begin.
 * - point data `PrincipalValue`: float, where the input has `SurfaceTensor` (vtkDirectionField
 *   along tensors): the tensor's value along the line, interpolated, above 0 for tension.
 * - point data `RepresentationMagnitude`: float, |u| of the interpolated field.
 * - point data `PointId`: vtkIdType, the corner of the triangle that is nearest.
 * - point data `Branch`: int, k where Direction{k} of that point is the one that the line follows.
 * - cell data `SeedIds`: vtkIdType. For POINTS the number of the point, for SINGULARITIES that of
 *   the node, else that of the line.
 * - cell data `Family`: int. Which of the families of lines that cross each other the line starts
 *   in: 0 to n/2 - 1, for odd n to n - 1. Far away from there another one may continue it: families
 *   of a field with singularities cannot be told apart everywhere.
 * - cell data `Length`: double. `Closed`: unsigned char, 1 for lines that come back to their begin.
 * - cell data `ReasonForTermination`: 2-component int, begin and end, the numbers of
 *   vtkStreamTracer: 1 boundary, 4 longest length, 5 no progress, 6 singularity; 7 closed, 8 too
 *   close to another line, 9 crossing.
 * - cell data `StartNode`, `EndNode`: vtkIdType, points of output port 1; -1 for none.
 *
 * Port 1, "Nodes": points (vertex cells) with the point data `NodeType`, unsigned char, 0 for
 * singularities, 1 for crossings, 2 for ends at the boundary; `SingularityIndex`, int, in units of
 * 1/n; `Index`, float, SingularityIndex/n; `CellId`, vtkIdType, the cell of the input.
 * Singularities are where the interpolated field vanishes.
 *
 * Both have the field data `SeparatingDistance`: double, the distance between lines that was used.
 *
 * @section Singularities Lines and singularities
 * In a singularity of index k/n there end |n - k| lines, 2 |n - k| for odd n (on half of them the
 * field points inwards), and none for k = n. With StopAtCrossings lines from all singularities set
 * out at the same speed and end where they come to the trail of another: the field's graph. For n =
 * 4 on a closed surface it cuts the surface into chi + N - S quads, with N lines and S
 * singularities.
 *
 * @sa
 * vtkDirectionField vtkDirectionFieldGlyphs
 */

#ifndef vtkDirectionFieldStreamlines_h
#define vtkDirectionFieldStreamlines_h

#include "vtkDirectionFieldAlgorithm.h"
#include "vtkDirectionFieldsFiltersModule.h" // For export macro

class vtkPointSet;

namespace DirectionFields
{
struct StreamlineOptions;
}

class VTKDIRECTIONFIELDSFILTERS_EXPORT vtkDirectionFieldStreamlines
  : public vtkDirectionFieldAlgorithm
{
public:
  static vtkDirectionFieldStreamlines* New();
  vtkTypeMacro(vtkDirectionFieldStreamlines, vtkDirectionFieldAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum SeedTypes
  {
    EVENLY_SPACED = 0,
    SINGULARITIES = 1,
    POINTS = 2
  };

  ///@{
  /**
   * Where lines start: such that each family of lines covers the surface evenly (0, default), at
   * the singularities (1), or at the points of input port 1 (2), for even n one line along each of
   * n/2 directions, for odd n along each of n.
   */
  vtkSetClampMacro(SeedType, int, EVENLY_SPACED, POINTS);
  vtkGetMacro(SeedType, int);
  ///@}

  ///@{
  /**
   * Distance between evenly spaced lines of one family, in the input's unit of length. 0: the root
   * of the surface's area / 40. No less than the root of the area / 1000 is taken, no
   * more than this root and the diagonal of the surface's box together, and lines of many million
   * points are an error. Range 0 to VTK_DOUBLE_MAX, default 0.
   */
  vtkSetClampMacro(SeparatingDistance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SeparatingDistance, double);
  ///@}

  ///@{
  /**
   * Evenly spaced lines end where they would come nearer to another one of their family than this
   * part of SeparatingDistance. Range 0.1 to 0.9, default 0.5.
   */
  vtkSetClampMacro(SeparatingDistanceRatio, double, 0.1, 0.9);
  vtkGetMacro(SeparatingDistanceRatio, double);
  ///@}

  ///@{
  /**
   * Greatest length of a line in the input's unit of length. 0: 20 times the root of the area of
   * its component. Range 0 to VTK_DOUBLE_MAX, default 0.
   */
  vtkSetClampMacro(MaximumStreamlineLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumStreamlineLength, double);
  ///@}

  ///@{
  /**
   * Shorter lines are left out. 0: for evenly spaced lines 0.9 SeparatingDistance, less on
   * components that are hardly larger and where lines may not be that long; else none is. More than
   * a MaximumStreamlineLength is an error. Range 0 to VTK_DOUBLE_MAX, default 0.
   */
  vtkSetClampMacro(MinimumStreamlineLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MinimumStreamlineLength, double);
  ///@}

  ///@{
  /**
   * Lines from singularities end where they cross each other. Default off.
   */
  vtkSetMacro(StopAtCrossings, bool);
  vtkGetMacro(StopAtCrossings, bool);
  vtkBooleanMacro(StopAtCrossings, bool);
  ///@}

  enum IntegrationDirections
  {
    BOTH = 0,
    FORWARD = 1,
    BACKWARD = 2
  };

  ///@{
  /**
   * For n = 1 and lines from points: whether they run along the field, against it, or both (0,
   * default).
   */
  vtkSetClampMacro(IntegrationDirection, int, BOTH, BACKWARD);
  vtkGetMacro(IntegrationDirection, int);
  ///@}

  ///@{
  /**
   * Most lines; a warning says if there would be more. Range 1 to 10000000, default 100000.
   */
  vtkSetClampMacro(MaximumNumberOfLines, int, 1, 10000000);
  vtkGetMacro(MaximumNumberOfLines, int);
  ///@}

  ///@{
  /**
   * Height of the lines above the surface, relative to the separating distance: outwards on
   * surfaces that enclose a volume, whichever way these are wound, with holes or without; else
   * along the normals. Range -1 to 1, default 0.03.
   */
  vtkSetClampMacro(Offset, double, -1.0, 1.0);
  vtkGetMacro(Offset, double);
  ///@}

  /**
   * The points at which lines start.
   */
  void SetSeedSourceConnection(vtkAlgorithmOutput* output);

protected:
  vtkDirectionFieldStreamlines();
  ~vtkDirectionFieldStreamlines() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void Execute(
    const Ports& inputs, const Ports& outputs, const DirectionFields::Progress& progress) override;
  const char* MemoryAdvice() const override;

private:
  vtkDirectionFieldStreamlines(const vtkDirectionFieldStreamlines&) = delete;
  void operator=(const vtkDirectionFieldStreamlines&) = delete;

  /// The options of the tracing, from the properties.
  DirectionFields::StreamlineOptions MakeOptions() const;

  int SeedType;
  double SeparatingDistance;
  double SeparatingDistanceRatio;
  double MaximumStreamlineLength;
  double MinimumStreamlineLength;
  bool StopAtCrossings;
  int IntegrationDirection;
  int MaximumNumberOfLines;
  double Offset;
};

#endif
