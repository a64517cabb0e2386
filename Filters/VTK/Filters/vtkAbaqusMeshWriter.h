// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkAbaqusMeshWriter
 * @brief writes a mesh of quads and triangles to a file that Abaqus and CalculiX read
 *
 * vtkAbaqusMeshWriter writes the nodes, shell elements and sets of a surface, of the mesh that
 * vtkFieldAlignedRemesh makes, for instance, to an input file (.inp). Materials, supports and loads
 * are not in it: a file that has those takes the mesh in by `*INCLUDE, INPUT=mesh.inp`.
 * - Node and element i + 1 are point and polygon i. Points of no polygon are left out.
 * - Elements are S4 for quads and S3 for triangles, or S8R and S6 for SecondOrder.
 * - Sets: NALL and EALL, all nodes and elements; NBOUNDARY, the nodes of the boundary; an *ELSET
 *   for each value of RegionArray; and an *NSET for each line of the mesh, its boundary, features
 *   and borders of regions, as vtkFieldAlignedRemesh keeps them in the field data. Letters of their
 *   names are capitals, and `_` stands for all but letters and digits; a comment gives the name as
 *   it was.
 * - With a DirectionArray, the axes of a material that is not the same in all directions.
 * - With a Thickness, the sections of the shells.
 *
 * Numbers have up to 17 digits and 20 characters, which is all that CalculiX reads, and a decimal
 * point in any locale. Where the file cannot be written to its end, one that was there is as it
 * was.
 *
 * @section Input Input
 * A vtkPolyData of triangles and quads. Vertices and lines are ignored. Polygons of more corners,
 * strips, and polygons without area are an error.
 *
 * @sa
 * vtkFieldAlignedRemesh vtkDirectionField
 */

#ifndef vtkAbaqusMeshWriter_h
#define vtkAbaqusMeshWriter_h

#include "vtkDirectionFieldsFiltersModule.h" // For export macro
#include "vtkWriter.h"

class vtkPolyData;

class VTKDIRECTIONFIELDSFILTERS_EXPORT vtkAbaqusMeshWriter : public vtkWriter
{
public:
  static vtkAbaqusMeshWriter* New();
  vtkTypeMacro(vtkAbaqusMeshWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to write. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * Name of a cell array of 1 component, integers, strings, or numbers that are whole: there is an
   * *ELSET for each of its values, which is named by the string, or by the array and the number, as
   * REGION_7. An error if there is none. "Automatic", the default, is the array whose regions
   * vtkFieldAlignedRemesh has made the mesh for, if it is there. Null, an empty name and "None" are
   * no array.
   */
  vtkSetStringMacro(RegionArray);
  vtkGetStringMacro(RegionArray);
  ///@}

  ///@{
  /**
   * Name of a cell array of 3 components, such as `Direction0` of vtkDirectionField with
   * CellDirections: the first axis of the material of each element, whose second one is 90 degrees
   * counter-clockwise of that in the element's plane. Without a Thickness they are in a
   * *DISTRIBUTION, and sections take them as ORIENTATION=DIRECTIONS; that is how Abaqus knows them,
   * while CalculiX ignores a distribution of shells without a word. With a Thickness each element
   * has an *ORIENTATION and a section of its own, which CalculiX takes. Null, the default, an empty
   * name and "None" are no array.
   */
  vtkSetStringMacro(DirectionArray);
  vtkGetStringMacro(DirectionArray);
  ///@}

  ///@{
  /**
   * Write elements of second order, S8R and S6, with nodes in the middle of edges. These are bent
   * as the faces and lines there, but not across edges where faces meet at more than 40 degrees.
   * S6 is a name of CalculiX: for Abaqus it has to be STRI65, as a comment in the file says.
   * Default off: S4 and S3.
   */
  vtkSetMacro(SecondOrder, bool);
  vtkGetMacro(SecondOrder, bool);
  vtkBooleanMacro(SecondOrder, bool);
  ///@}

  ///@{
  /**
   * Thickness of the shells, in the unit of length of the mesh, for which there are sections, of a
   * material of the name of each region's *ELSET, and of the name MATERIAL without a RegionArray.
   * Range 0 to VTK_DOUBLE_MAX, default 0: no sections.
   */
  vtkSetClampMacro(Thickness, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Thickness, double);
  ///@}

  ///@{
  /**
   * The mesh to write.
   */
  vtkPolyData* GetInput();
  vtkPolyData* GetInput(int port);
  ///@}

protected:
  vtkAbaqusMeshWriter();
  ~vtkAbaqusMeshWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

private:
  vtkAbaqusMeshWriter(const vtkAbaqusMeshWriter&) = delete;
  void operator=(const vtkAbaqusMeshWriter&) = delete;

  /// Everything but the handling of errors.
  void WriteMesh(vtkPolyData* mesh);

  char* FileName;
  char* RegionArray;
  char* DirectionArray;
  bool SecondOrder;
  double Thickness;
};

#endif
