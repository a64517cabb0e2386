// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkDirectionFieldWriter
 * @brief writes a direction field to files that other programs read
 *
 * vtkDirectionFieldWriter writes the field of the first output of vtkDirectionField, or any other
 * surface with such arrays, in the format that the end of FileName says:
 * - .rosy: one direction for each triangle, and the degree (QuadWild and others that use vcglib,
 *   which take degree 4 only; Palacios and Zhang's has rows for points);
 * - .ffield: two directions for each triangle (vcglib, QuadWild); degree 4 only;
 * - .rawfield: all n directions for each triangle, counter-clockwise (Directional), and beside it
 *   NAME.sing;
 * - .sing: the singularities alone.
 *
 * Beside the file it writes the mesh that the rows belong to, NAME.obj, and for .rosy NAME.sharp,
 * the sharp edges that QuadWild does not look for where a mesh comes with a field. Numbers have up
 * to 17 digits, by which they are read back to the last bit, and a decimal point in any locale.
 *
 * All of the files are written or, where that fails, none: until then files of these names are as
 * they were. NAME.obj and the files beside it are only replaced if an earlier run wrote them and
 * nobody changed them since, which comments in NAME.obj tell; else the writer reports an error.
 *
 * @section Input Input
 * A vtkPolyData of triangles with the point arrays `Direction0`, ..., or with cell arrays of these
 * names (vtkDirectionField::SetCellDirections). For FieldOn CELLS the directions of the cells are
 * written; where there are none, those of the points, interpolated to the centroids. Vertices and
 * lines are ignored. Polygons of more corners and strips are an error, for the other programs would
 * number triangles in their own way.
 *
 * @sa
 * vtkDirectionFieldReader vtkDirectionField
 */

#ifndef vtkDirectionFieldWriter_h
#define vtkDirectionFieldWriter_h

#include "vtkDirectionFieldsFiltersModule.h" // For export macro
#include "vtkWriter.h"

#include <string>

class vtkPolyData;

class VTKDIRECTIONFIELDSFILTERS_EXPORT vtkDirectionFieldWriter : public vtkWriter
{
public:
  static vtkDirectionFieldWriter* New();
  vtkTypeMacro(vtkDirectionFieldWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to write. It ends with .rosy, .ffield, .rawfield or .sing. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  enum FieldPlaces
  {
    CELLS = 0,
    POINTS = 1
  };

  ///@{
  /**
   * The elements that the rows of the file are for: the triangles (0, default), or the points (1),
   * as Palacios and Zhang's .rosy files have them, and Directional for its vertex bundles.
   * Singularities are points for CELLS, triangles for POINTS.
   */
  vtkSetClampMacro(FieldOn, int, CELLS, POINTS);
  vtkGetMacro(FieldOn, int);
  ///@}

  ///@{
  /**
   * Angle between the normals of two triangles, in degrees, above which their edge is sharp, for
   * the .sharp file. The same as vtkDirectionField::SetFeatureAngle. Range 0 to 180, default 40.
   */
  vtkSetClampMacro(FeatureAngle, double, 0.0, 180.0);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  ///@{
  /**
   * Chains of sharp edges that are shorter count as noise, unless they stand out, in parts of the
   * square root of the area. The same as vtkDirectionField::SetMinimumFeatureLength. Range 0 to
   * VTK_DOUBLE_MAX, default 0.5.
   */
  vtkSetClampMacro(MinimumFeatureLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MinimumFeatureLength, double);
  ///@}

  ///@{
  /**
   * The surface whose field is written.
   */
  vtkPolyData* GetInput();
  vtkPolyData* GetInput(int port);
  ///@}

protected:
  vtkDirectionFieldWriter();
  ~vtkDirectionFieldWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

  /// Writes the files of a surface, for writers of several processes.
  /// @return why it could not; empty where it has
  std::string WriteSurface(vtkPolyData* surface);

private:
  vtkDirectionFieldWriter(const vtkDirectionFieldWriter&) = delete;
  void operator=(const vtkDirectionFieldWriter&) = delete;

  /// Everything but the handling of errors.
  void WriteFiles(vtkPolyData* surface);

  char* FileName;
  int FieldOn;
  double FeatureAngle;
  double MinimumFeatureLength;
};

#endif
