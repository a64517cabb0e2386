// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkStripePattern
 * @brief covers a surface with evenly spaced stripes along or across a direction field
 *
 * vtkStripePattern covers a surface with stripes of the same width that follow a vector field or a
 * line field, one of degree 1 or 2, and that branch or end where there is too much or too little
 * room: hatching, the paths of fibres and tools, rows of a knitted fabric, and, from two patterns
 * on one line field, along it and across it, warp and weft.
 *
 * The phase of the pattern changes along each edge nearly as the directions and the spacing say (F.
 * Knoeppel, K. Crane, U. Pinkall, P. Schroeder: Stripe Patterns on Surfaces, ACM TOG 34(4), 2015).
 * Unlike there it is no eigenvector, which vanishes where stripes have to branch, but a section of
 * unit length that is relaxed. Stripes may be as narrow as they like against the triangles; several
 * of them may run through one edge.
 *
 * @section Input Input
 * A vtkPolyData like output port 0 of vtkDirectionField, triangles, polygons or triangle strips
 * with the point array `Direction0` (degree 1), or `Direction0` and `Direction1` (degree 2), of 3
 * components. Points at the same place with the same directions are one. An
 * input without polygons and strips gives empty outputs. Cells that vtkGhostType marks as
 * duplicates count for the phases, but have no stripes; hidden cells are as if they were not there.
 * On surfaces that cannot be oriented stripes go on over both sides.
 *
 * @section Output Output
 * Port 0, "Lines": the middles of the stripes as poly lines, each as long as can be. Points are
 * double if the input's are, else float. For degree 1 lines along the field run with it.
 * - point data `Normals`: 3-component float, active normals: of the surface, interpolated.
 *   `ArcLength`: double, the length of the line from its begin.
 * - cell data `LineId`: vtkIdType. `Length`: double. `Closed`: unsigned char, 1 for lines that come
 *   back to their begin.
 * - cell data `ReasonForTermination`: 2-component int, begin and end: 1 boundary, 6 branch point or
 *   singularity, 7 closed. `StartNode`, `EndNode`: vtkIdType, points of output port 2; -1 for none.
 *
 * Port 1, "Bands": the surface cut exactly along the borders of the stripes, into convex polygons
 * that share their points, with the input's point data interpolated, but for the field, and its
 * cell data copied, and
 * - cell data `Stripe`: signed char, active scalars: 1 within a quarter of the spacing from a line,
 *   else 0. `CellId`: vtkIdType, the cell of the input.
 * - point data `Normals`: 3-component float, active normals.
 * - with TextureCoordinates point data `StripePhase`: 2-component float, active texture
 *   coordinates: the phase in cycles, 0 on lines, and 0. Polygons share no points then.
 *
 * A field of more directions has no stripes, which a warning and `Summary` say: then this is the
 * input as it is. The other ports are empty.
 *
 * Port 2, "Branch Points": points (vertex cells) in the middles of the triangles that stripes do
 * not run straight through: `StripeIndex`, int, the number of lines that end there, of degree 1
 * with a sign: those that begin there count positive; `FieldIndex`, int, the field's index in units
 * of 1/n; `CellId`, vtkIdType. Around odd singularities of line fields, where stripes turn around,
 * StripeIndex is 0.
 *
 * All have the field data `Spacing` (0 with a SpacingArray), `LineOffset` and `Misfit`: double, and
 * `BranchPoints`: int, those with a StripeIndex. Misfit is the root mean square of the differences
 * between the phase's steps along the edges and the wanted steps, over the root mean square of the
 * wanted steps: 0 for a perfect pattern.
 *
 * The same input gives the same bytes, whatever the number of threads.
 *
 * @warning
 * Where more than four stripes run through an edge of the mesh, branch points may share triangles;
 * the filter warns. Subdivide the surface before Direction Field.
 *
 * @sa
 * vtkDirectionField vtkDirectionFieldStreamlines vtkFieldAlignedRemesh
 */

#ifndef vtkStripePattern_h
#define vtkStripePattern_h

#include "vtkDirectionFieldAlgorithm.h"
#include "vtkDirectionFieldsFiltersModule.h" // For export macro

class VTKDIRECTIONFIELDSFILTERS_EXPORT vtkStripePattern : public vtkDirectionFieldAlgorithm
{
public:
  static vtkStripePattern* New();
  vtkTypeMacro(vtkStripePattern, vtkDirectionFieldAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum StripeDirections
  {
    ALONG_FIELD = 0,
    ACROSS_FIELD = 1
  };

  ///@{
  /**
   * Whether stripes run along the field (0, default) or at right angles to it (1).
   */
  vtkSetClampMacro(StripeDirection, int, ALONG_FIELD, ACROSS_FIELD);
  vtkGetMacro(StripeDirection, int);
  ///@}

  ///@{
  /**
   * Distance from the middle of one stripe to that of the next, in the input's unit of length. 0:
   * the root of the surface's area / 40. An error where lines would have more than a hundred
   * million points. Range 0 to VTK_DOUBLE_MAX, default 0.
   */
  vtkSetClampMacro(Spacing, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /**
   * Name of a point array of 1 component with the spacing at each point, in place of Spacing; where
   * it is not positive there are no stripes. An error if there is none. Null, the default, an empty
   * name and "None" are no array.
   */
  vtkSetStringMacro(SpacingArray);
  vtkGetStringMacro(SpacingArray);
  ///@}

  ///@{
  /**
   * Moves lines and bands to their sides by this part of the spacing: to the left of the field, for
   * ACROSS_FIELD forward along it. A line field has no sense: for degree 2, and on surfaces that
   * cannot be oriented, the nearest multiple of 0.5 is taken, with a warning. Range -1 to 1,
   * default 0.
   */
  vtkSetClampMacro(LineOffset, double, -1.0, 1.0);
  vtkGetMacro(LineOffset, double);
  ///@}

  ///@{
  /**
   * Whether output port 1 is computed, which takes most of the memory. Default on.
   */
  vtkSetMacro(Bands, bool);
  vtkGetMacro(Bands, bool);
  vtkBooleanMacro(Bands, bool);
  ///@}

  ///@{
  /**
   * Whether each polygon of output port 1 has points of its own, with the phase as texture
   * coordinates. Default off.
   */
  vtkSetMacro(TextureCoordinates, bool);
  vtkGetMacro(TextureCoordinates, bool);
  vtkBooleanMacro(TextureCoordinates, bool);
  ///@}

protected:
  vtkStripePattern();
  ~vtkStripePattern() override;

  void Execute(
    const Ports& inputs, const Ports& outputs, const DirectionFields::Progress& progress) override;
  const char* MemoryAdvice() const override;

private:
  vtkStripePattern(const vtkStripePattern&) = delete;
  void operator=(const vtkStripePattern&) = delete;

  int StripeDirection;
  double Spacing;
  char* SpacingArray;
  double LineOffset;
  bool Bands;
  bool TextureCoordinates;
};

#endif
