// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkDirectionField
 * @brief globally optimal n-direction field of a surface
 *
 * vtkDirectionField computes, at every point of a surface, n unit tangent vectors that stand at
 * angles of 2 pi / n to each other and turn as little as possible from point to point: a vector
 * field (n = 1), a line field (n = 2), a cross field (n = 4), a hex field (n = 6) and so on.
 * Number, place and index of the singularities, where a smooth field has to break up, are not
 * prescribed but come out of the optimization.
 *
 * The n directions at a vertex are the n-th roots of one complex number u, measured in the tangent
 * plane of the vertex. On each triangle u is interpolated by sections of the line bundle whose
 * curvature is n times the Gaussian curvature, spread evenly over the triangle. The smoothness
 * energy of these sections is a Hermitian form A, their square norm a Hermitian form M, and the
 * field is the eigenvector to the smallest eigenvalue of A u = lambda M u: the global optimum, with
 * no initial guess. Every connected component has its own eigenvector. EnergyBias chooses between
 * the energies whose minimizers are as holomorphic or as antiholomorphic as possible. The method is
 *
 * F. Knöppel, K. Crane, U. Pinkall, P. Schröder: Globally Optimal Direction Fields.
 * ACM Transactions on Graphics 32(4), Article 59, 2013. https://doi.org/10.1145/2461912.2462005
 *
 * @section Input Input
 * Any vtkPolyData. Triangles enter the computation as they are; polygons and triangle strips are
 * cut into triangles internally, and the results come back on the input's own points and cells.
 * Vertices and lines are passed through. Cells that vtkGhostType marks as hidden are passed through
 * but take no part. An input without polygons and strips has the zero field; an empty input gives
 * an empty output.
 *
 * @section Output Output port 0: the field
 * The input with its data, and in addition (arrays of the same names are replaced):
 * - point data `Direction0` ... `Direction{n-1}`: 3 components, double if the points are double,
 *   else float. Unit tangent vectors, counter-clockwise about the outward normal, each 2 pi / n
 *   after the one before. Which of the n comes first is arbitrary and may change from point to
 *   point. (0, 0, 0) at points that no triangle uses. `Direction0` is the active vectors; the
 *   active scalars stay what they were. Arrays `Direction{n}` ... `Direction15` that an earlier
 *   filter left are removed.
 * - point data `RepresentationMagnitude`: 1 component, type as above. |u|, small near
 *   singularities; scaled so that the square norm is 1 on each connected component. 0 at points
 *   that no triangle uses.
 * - cell data `SingularityIndex`: int, in units of 1/n. The index of the field inside the cell: 0
 *   where it is regular, 1 for n = 4 means a quarter turn in the direction of a walk around the
 *   cell, negative values a turn against it. For a polygon or a strip the sum over its triangles.
 *   0 on vertices, lines and cells that take no part. Over a closed surface the values sum up to n
 *   times the Euler characteristic, exactly.
 * - field data, one tuple per connected component, ordered by their first cells:
 *   - `Eigenvalue`: double. lambda, the smoothness energy of the field, in 1 / length^2.
 *   - `Residual`: double. |A u - lambda M u| / |A u| reached by the solver.
 *   - `Iterations`: int. Solves that it took; 0 for small components solved directly.
 *   - `EulerCharacteristic`: int. Vertices - edges + triangles.
 *   - `IndexSum`: int. Sum of the singularity indices, in units of 1/n.
 *
 * @section Singularities Output port 1: the singularities
 * A vertex at the centroid of every triangle with an index other than 0, with point data
 * - `SingularityIndex`: int, in units of 1/n.
 * - `Index`: double. The same in full turns, SingularityIndex / n.
 * - `CellId`: vtkIdType. The cell of the input with the triangle.
 * - `Normals`: 3-component float, active normals. Unit outward normal of the triangle.
 *
 * @warning
 * The surface must be a manifold that can be oriented: at most two triangles at each edge, one fan
 * of triangles at each vertex. Other input is an error that names the first offending point, and
 * both outputs are empty.
 *
 * @warning
 * Triangles wound against the majority of their component, duplicate triangles, triangles with a
 * repeated corner and triangles without area are mended for the computation, with one warning that
 * counts them. The output's geometry is the input's all the same.
 *
 * @warning
 * Polygons that are not convex or not planar are cut by their ears. The field on the cut polygons
 * is that of the triangles, and a singularity may sit in any one of them.
 *
 * @warning
 * The field is determined up to one rotation per connected component, and on symmetric shapes (a
 * sphere, say) one of several optimal fields is chosen; the same input always gives the same field.
 *
 * @warning
 * Every connected component of the mesh counts: where points are not shared between polygons, as
 * along texture seams or after reading an STL file, merge them first with vtkCleanPolyData.
 */

#ifndef vtkDirectionField_h
#define vtkDirectionField_h

#include "vtkDirectionFieldsFiltersModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

namespace DirectionFields
{
struct Result;
}

class VTKDIRECTIONFIELDSFILTERS_EXPORT vtkDirectionField : public vtkPolyDataAlgorithm
{
public:
  static vtkDirectionField* New();
  vtkTypeMacro(vtkDirectionField, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Degree n of the rotational symmetry, the number of directions at each point: 1 for a vector
   * field, 2 for a line field, 4 for a cross field, 6 for a hex field. Range 1 to 16, default 4.
   */
  vtkSetClampMacro(Degree, int, 1, 16);
  vtkGetMacro(Degree, int);
  ///@}

  ///@{
  /**
   * s in the energy (1 + s) E_holomorphic + (1 - s) E_antiholomorphic: it trades the straightness
   * of the field lines against the number of singularities. 0 is the Dirichlet energy, 1 the
   * holomorphic and -1 the antiholomorphic energy. Range -1 to 1, default 0.
   */
  vtkSetClampMacro(EnergyBias, double, -1.0, 1.0);
  vtkGetMacro(EnergyBias, double);
  ///@}

  ///@{
  /**
   * Relative residual |A u - lambda M u| / |A u| at which the solver stops. Range 1e-12 to 0.1,
   * default 1e-6.
   */
  vtkSetClampMacro(Tolerance, double, 1e-12, 0.1);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * Most solver iterations that a connected component may take. A component that has not reached
   * the Tolerance by then keeps what was reached, with a warning. Range 1 to 10000, default 200.
   */
  vtkSetClampMacro(MaximumIterations, int, 1, 10000);
  vtkGetMacro(MaximumIterations, int);
  ///@}

protected:
  vtkDirectionField();
  ~vtkDirectionField() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkDirectionField(const vtkDirectionField&) = delete;
  void operator=(const vtkDirectionField&) = delete;

  /// Whether someone asked this filter, or one before it in the pipeline, to stop.
  bool IsAborted();

  /// One warning if the surface had to be mended, one if the solver did not converge.
  void Warn(const DirectionFields::Result& field);

  int Degree;
  double EnergyBias;
  double Tolerance;
  int MaximumIterations;
};

#endif
