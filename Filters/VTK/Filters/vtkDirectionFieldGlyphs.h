// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkDirectionFieldGlyphs
 * @brief draws all n directions of a direction field as one glyph at each place
 *
 * vtkDirectionFieldGlyphs draws the field that vtkDirectionField computes: an arrow for n = 1, a
 * rod for n = 2, a cross for n = 4, a star of n arms for any other n. The glyphs lie on the
 * surface, a little above it, spread evenly over it or on its points.
 *
 * Evenly spread glyphs stand between the points, and there the field is interpolated the way
 * directions that are defined up to turns by 2 pi / n demand: the n-th powers of the directions,
 * taken as complex numbers, are carried from the corners of the triangle to the place by the least
 * rotations between the tangent planes, and their mean, weighted by the place's barycentric
 * coordinates and RepresentationMagnitude, is the n-th power of the directions there. At the points
 * these are the given directions, in between they change continuously, and it does not matter which
 * of the n directions is called Direction0.
 *
 * The places are samples with a Poisson-disk distribution, relaxed: no two on the same side of the
 * surface are nearer to each other than the spacing, and no room is left for another. Both sides of
 * a thin part have glyphs of their own. The time is linear in cells and glyphs, and the same input
 * gives the same bytes.
 *
 * @section Input Input
 * A vtkPolyData like output port 0 of vtkDirectionField: triangles, polygons or triangle strips
 * with the point arrays `Direction0`, `Direction1`, ... of 3 components, unit tangent vectors at
 * equal angles. n is the number of these arrays, counted up to the first that is missing. The point
 * array `RepresentationMagnitude`, where there is one, weights the directions of neighbouring
 * points. Points with directions or a weight that are zero or not finite do not contribute. Cells
 * and points that vtkGhostType marks as hidden or as duplicates have no glyphs. An input without
 * polygons and strips gives an empty output. For composite inputs the glyphs of every block are
 * spread by themselves, each with the maximum number.
 *
 * @section Output Output
 * Polygons, or lines for the glyph type Lines, with points that are double if the input's are, else
 * float, and
 * - point data `Normals`: 3-component float, active normals. Unit normals of the surface on the
 *   side that the glyph is on; for Tubes those of the tubes.
 * - cell data `Location`: vtkIdType. Number of the glyph that the cell belongs to, from 0; arms on
 *   both sides of a place are one glyph.
 * - cell data `PointId`: vtkIdType. The point of the input that the glyph is on, or for glyphs that
 *   are spread evenly the nearest corner of the triangle that it is on.
 * - cell data `Branch`: int. Which direction the cell shows: k on a point means Direction{k}, in
 *   between the direction nearest to Direction{k} of the point PointId.
 * - cell data `RepresentationMagnitude`: float. |u| of the interpolated field: small near
 *   singularities, where directions are the less certain.
 * - cell data `Direction`: 3-component float. The unit tangent vector that the cell shows.
 * - cell data `PrincipalValue`: float, where the input has `SurfaceTensor` (vtkDirectionField along
 *   tensors). The tensor's value in this direction at the point PointId, above 0 for tension.
 *
 * None of the arrays is the active scalars or vectors, so that viewers draw the glyphs in one color
 * until they are told to color by one. Beside them there are
 * - field data `NumberOfGlyphs`: vtkIdType, one tuple.
 * - field data `Spacing`: double, one tuple. The least distance between evenly spread glyphs that
 *   was kept, in the input's unit of length. For glyphs on all points the mean of the lengths that
 *   their sizes go by. 0 without glyphs.
 *
 * The places depend on the points and cells of the input only: another field on the same surface
 * has its glyphs at the same places, and in less time, because they are kept (ReleaseSurfaces).
 *
 * @warning
 * At a place where the interpolated field vanishes, the middle of a singularity, there is no glyph.
 *
 * @sa
 * vtkDirectionField
 */

#ifndef vtkDirectionFieldGlyphs_h
#define vtkDirectionFieldGlyphs_h

#include "vtkDirectionFieldAlgorithm.h"
#include "vtkDirectionFieldsFiltersModule.h" // For export macro

#include <memory> // For std::unique_ptr
#include <string> // For std::string

namespace DirectionFields
{
class GlyphSurfaceCache;
struct GlyphOptions;
}

class VTKDIRECTIONFIELDSFILTERS_EXPORT vtkDirectionFieldGlyphs : public vtkDirectionFieldAlgorithm
{
public:
  static vtkDirectionFieldGlyphs* New();
  vtkTypeMacro(vtkDirectionFieldGlyphs, vtkDirectionFieldAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum GlyphTypes
  {
    AUTOMATIC = 0,
    LINES = 1,
    ARROWS = 2,
    RIBBONS = 3,
    TUBES = 4
  };

  ///@{
  /**
   * The shape of glyphs: AUTOMATIC (0, default), which is ARROWS for n = 1 and RIBBONS else;
   * LINES (1); ARROWS (2), flat and facing the normal; RIBBONS (3), flat bands that face the normal
   * and taper towards the tip; TUBES (4), round bars with pointed tips.
   */
  vtkSetClampMacro(GlyphType, int, AUTOMATIC, TUBES);
  vtkGetMacro(GlyphType, int);
  ///@}

  enum GlyphModes
  {
    SPREAD_EVENLY = 0,
    ALL_POINTS = 1
  };

  ///@{
  /**
   * Where the glyphs are: spread evenly over the surface (0, default), or on all points that a
   * polygon or strip uses (1), of which an evenly spread part is taken if they are more than
   * MaximumNumberOfGlyphs.
   */
  vtkSetClampMacro(GlyphMode, int, SPREAD_EVENLY, ALL_POINTS);
  vtkGetMacro(GlyphMode, int);
  ///@}

  enum GlyphSides
  {
    SIDE_AUTOMATIC = 0,
    SIDE_FRONT = 1,
    SIDE_BACK = 2,
    SIDE_BOTH = 3
  };

  ///@{
  /**
   * Which side of the surface the glyphs are on: automatically (0, default), which is the outside
   * of connected components that are closed, whatever their winding, and both sides of those that
   * have a boundary or cannot be oriented, since either may face the camera; the front (1), where
   * the cells' winding says that the normals are, and the directions themselves for n > 2; the back
   * (2); both (3). Outside is where the signed volume of a component says so, by itself: the inner
   * wall of a hollow body has its glyphs in the material. Components are connected across seams,
   * where points share places. Clamped to 0 ... 3.
   */
  vtkSetClampMacro(Side, int, SIDE_AUTOMATIC, SIDE_BOTH);
  vtkGetMacro(Side, int);
  ///@}

  ///@{
  /**
   * Least distance between the centers of glyphs that are spread evenly, in the input's unit of
   * length. 0: as small as MaximumNumberOfGlyphs allows. A spacing that asks for more glyphs than
   * that is enlarged; one beyond the diagonal of the box around the surface is taken for that.
   * Range 0 to VTK_DOUBLE_MAX, default 0.
   */
  vtkSetClampMacro(Spacing, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /**
   * Most glyphs; those on both sides of a place count once. Range 0 to 1000000. 0, the default, is
   * automatic: 500 where Spacing is 0, too, and they are spread evenly, so that their arms are told
   * apart in a view of 530 pixels; else 2000.
   */
  vtkSetClampMacro(MaximumNumberOfGlyphs, int, 0, 1000000);
  vtkGetMacro(MaximumNumberOfGlyphs, int);
  ///@}

  ///@{
  /**
   * Diameter of a glyph relative to the spacing; on all points, to the shortest edge of the point
   * (but at least a quarter of the mean of its edges). Evenly spread glyphs do not overlap up to 1.
   * Range 0.01 to 10, default 1.
   */
  vtkSetClampMacro(Scale, double, 0.01, 10.0);
  vtkGetMacro(Scale, double);
  ///@}

  ///@{
  /**
   * Height of the glyphs above the surface, on the side that they are on, relative to the same;
   * negative heights are beyond the surface, on its other side. Range -1 to 1, default 0.04.
   */
  vtkSetClampMacro(Offset, double, -1.0, 1.0);
  vtkGetMacro(Offset, double);
  ///@}

  ///@{
  /**
   * Bend the arms along the surface, so that they neither drown in it nor stand off. Off: the arms
   * are straight and lie in the tangent plane, and a glyph is raised where the surface is hollow.
   * Default on.
   */
  vtkSetMacro(FollowSurface, bool);
  vtkGetMacro(FollowSurface, bool);
  vtkBooleanMacro(FollowSurface, bool);
  ///@}

  /**
   * Frees all data of the surface that is kept between executions, now: its triangles, the places
   * of the glyphs and which side is outside. As long as points and cells stay the same, whatever
   * becomes of the field, the next executions begin with that. It takes some 60 bytes a triangle.
   */
  void ReleaseSurfaces();

protected:
  vtkDirectionFieldGlyphs();
  ~vtkDirectionFieldGlyphs() override;

  void Execute(
    const Ports& inputs, const Ports& outputs, const DirectionFields::Progress& progress) override;
  const char* MemoryAdvice() const override;
  void Release(bool hasFailed) override;

private:
  vtkDirectionFieldGlyphs(const vtkDirectionFieldGlyphs&) = delete;
  void operator=(const vtkDirectionFieldGlyphs&) = delete;

  /// The options of the drawing, from the properties.
  DirectionFields::GlyphOptions MakeOptions() const;

  /// Called by the pipeline before and after an input, and before and after each of its blocks.
  void BeginBlocks();
  void EndBlocks();

  int GlyphType;
  int GlyphMode;
  int Side;
  double Spacing;
  int MaximumNumberOfGlyphs;
  double Scale;
  double Offset;
  bool FollowSurface;
  int BlockDepth = 0;
  std::unique_ptr<DirectionFields::GlyphSurfaceCache> Surfaces;
};

#endif
