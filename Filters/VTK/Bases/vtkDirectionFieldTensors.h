// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkDirectionFieldTensors
 * @brief base of the filter whose fields follow tensors: which ones, and how
 *
 * vtkDirectionFieldTensors has the properties of vtkDirectionField that say which tensors a field
 * follows where its Alignment is ALIGN_TENSOR: a stress, strain, diffusion or permeability. Each
 * tensor has two principal directions in the surface, at right angles. A field of degree 2 follows
 * one of them, a field of degree 4 both; other degrees are an error. Nothing is sorted: where the
 * two principal values are equal the field has its singularities, those of a line field being
 * wedges (index 1) and trisectors (index -1). Only the part of a tensor along the surface counts,
 * and of that only what is symmetric; a multiple of the identity changes nothing.
 *
 * Tensors are averaged over as much of the surface as their noise makes necessary. Where they are
 * isotropic within noise and rounding, the field is the smoothest one that fits to what is around.
 *
 * Tensors of cells are carried to the corners within the surface; the triangles of polygons and
 * strips have the tensor of their cell.
 */

#ifndef vtkDirectionFieldTensors_h
#define vtkDirectionFieldTensors_h

#include "vtkDirectionFieldAlgorithm.h"
#include "vtkDirectionFieldsFiltersModule.h" // For export macro

#include <string> // For std::string

class vtkPolyData;

namespace DirectionFields
{
struct SurfaceTensors;
struct TensorGuidanceOptions;
struct TriangulatedPolyData;
}

class VTKDIRECTIONFIELDSFILTERS_EXPORT vtkDirectionFieldTensors : public vtkDirectionFieldAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkDirectionFieldTensors, vtkDirectionFieldAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The array of tensors in the axes of space, of 6 components in VTK's order XX, YY, ZZ, XY, YZ,
   * XZ, or of 9, row by row. Shear is the tensor's, half of the engineering shear. The same as
   * SetInputArrayToProcess(0, 0, 0, association, name), which is what ParaView calls.
   * @param association vtkDataObject::FIELD_ASSOCIATION_POINTS (0) or FIELD_ASSOCIATION_CELLS (1)
   * @param name        of the array; there is none by default, which is an error where it is needed
   */
  void SetTensorArray(int association, const char* name);

  enum TensorDirectionType
  {
    MAJOR = 0,
    MINOR = 1,
    LARGER_MAGNITUDE = 2
  };

  ///@{
  /**
   * Which principal direction a field of degree 2 follows: that of the larger principal value (0,
   * default), with its sign, so that tension comes before compression; that of the smaller one (1);
   * or that of the larger modulus (2), which jumps by 90 degrees where the two values are opposite:
   * no field can follow it there. Fields of degree 4 follow both. Clamped to 0 ... 2.
   */
  vtkSetClampMacro(TensorDirection, int, MAJOR, LARGER_MAGNITUDE);
  vtkGetMacro(TensorDirection, int);
  ///@}

  ///@{
  /**
   * How strongly the field is drawn to the principal directions, as AlignmentStrength. 1, the
   * default, gives the directions themselves, freed of noise; below that lie smoother fields, which
   * know less and less of what is small: 0.5 is far from a stress that concentrates at a hole. 0
   * gives the smoothest field. UseShift goes before it. Range 0 to 1.
   */
  vtkSetClampMacro(TensorStrength, double, 0.0, 1.0);
  vtkGetMacro(TensorStrength, double);
  ///@}

  ///@{
  /**
   * Radius of the surroundings of a point that its tensor is averaged over, in edges of the mesh: 0
   * to 32. 0, the default, finds it for each point by how much of the tensor is noise.
   */
  vtkSetClampMacro(TensorScale, double, 0.0, 32.0);
  vtkGetMacro(TensorScale, double);
  ///@}

protected:
  vtkDirectionFieldTensors();
  ~vtkDirectionFieldTensors() override = default;

  ///@{
  /**
   * The name of the array, empty for none, and whether it is one of cells.
   */
  std::string GetTensorArrayName();
  bool AreTensorsOfCells();
  ///@}

  /**
   * Reads the tensors. Throws std::invalid_argument where there is no such array, or with the cell
   * whose tensor is not finite.
   */
  DirectionFields::SurfaceTensors ReadTensors(
    vtkPolyData* input, const DirectionFields::TriangulatedPolyData& surface);
  DirectionFields::TensorGuidanceOptions MakeTensorOptions() const;

  int TensorDirection;
  double TensorStrength;
  double TensorScale;

private:
  vtkDirectionFieldTensors(const vtkDirectionFieldTensors&) = delete;
  void operator=(const vtkDirectionFieldTensors&) = delete;
};

#endif
