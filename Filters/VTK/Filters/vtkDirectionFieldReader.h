// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkDirectionFieldReader
 * @brief lays a direction field from a file on its surface
 *
 * vtkDirectionFieldReader reads a direction field that another program, or vtkDirectionFieldWriter,
 * has written for a surface, and adds it to that surface, as vtkDirectionField would: everything
 * that takes its output takes this, too. It reads
 * - .rosy: one direction for each triangle or point;
 * - .ffield: crosses for each triangle or point (vcglib);
 * - .rawfield: all n directions for each triangle or point (Directional);
 * - .obj with the comments `#degree n` and `#field i x y z` that fieldgen writes.
 *
 * Directions of triangles are carried to the points: the mean of the n-th powers of those around a
 * point, weighted by their angles. Directions that do not stand at equal angles become those that
 * are nearest and do, with a warning. Points without direction get that of their neighbours, with a
 * warning.
 *
 * These files have no mesh, or one that is not read: the input is the very mesh, its points and
 * triangles in the same order. The points of an .obj file are found by their places, too, where a
 * reader of meshes has split points at seams of textures.
 *
 * @section Output Output
 * Port 0: the surface with the point data `Direction0`, ..., `RepresentationMagnitude` (1 for
 * directions of points; how much the directions around a point agree, 0 to 1, for those of
 * triangles) and `EnergyDensity`, the cell data `SingularityIndex` and the field data
 * `EulerCharacteristic`, `IndexSum`, `Repairs` and `Warnings`, all as vtkDirectionField's. Where
 * the surface is no manifold it is split as that one's. Singularity indices are those of the
 * directions at the points, computed anew.
 *
 * Port 1: a point for each singular triangle, as vtkDirectionField's.
 *
 * @warning
 * A change of the file is not noticed: call Modified().
 *
 * @sa
 * vtkDirectionFieldWriter vtkDirectionField
 */

#ifndef vtkDirectionFieldReader_h
#define vtkDirectionFieldReader_h

#include "vtkDirectionFieldAlgorithm.h"
#include "vtkDirectionFieldsFiltersModule.h" // For export macro

class VTKDIRECTIONFIELDSFILTERS_EXPORT vtkDirectionFieldReader : public vtkDirectionFieldAlgorithm
{
public:
  static vtkDirectionFieldReader* New();
  vtkTypeMacro(vtkDirectionFieldReader, vtkDirectionFieldAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to read. It ends with .rosy, .ffield, .rawfield or .obj. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  enum FieldPlaces
  {
    AUTOMATIC = 0,
    CELLS = 1,
    POINTS = 2
  };

  ///@{
  /**
   * The elements that the rows of the file are for: AUTOMATIC (0, default), the triangles if there
   * are as many, else the points; CELLS (1); POINTS (2). Those of .obj files are for points.
   */
  vtkSetClampMacro(FieldOn, int, AUTOMATIC, POINTS);
  vtkGetMacro(FieldOn, int);
  ///@}

protected:
  vtkDirectionFieldReader();
  ~vtkDirectionFieldReader() override;

  void Execute(
    const Ports& inputs, const Ports& outputs, const DirectionFields::Progress& progress) override;

private:
  vtkDirectionFieldReader(const vtkDirectionFieldReader&) = delete;
  void operator=(const vtkDirectionFieldReader&) = delete;

  char* FileName;
  int FieldOn;
};

#endif
