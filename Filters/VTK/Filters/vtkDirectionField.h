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
 * With Alignment the field is drawn to the principal curvature directions (the Hopf differential
 * of the surface), to given vectors or to tensors q: it solves (A - lambda_t M) u = M q, where
 * lambda_t below the smallest eigenvalue follows from AlignmentStrength. Constraints fix the
 * directions of some vertices: on the boundary, on sharp edges, where the surface is curved, or
 * where the user gives them. They follow
 *
 * B. Pellenard, G. Orbay, J. Chen, S. Sohan, W. Kwok, J. R. Tristano: QMCF: QMorph Cross
 * Field-driven Quad-dominant Meshing Algorithm. Procedia Engineering 82, 338-350, 2014.
 * https://doi.org/10.1016/j.proeng.2014.10.394
 *
 * @section Input Input
 * Any vtkPolyData. Triangles enter the computation as they are; polygons and triangle strips are
 * cut into triangles internally, and the results come back on the input's own points and cells.
 * Vertices, lines and cells that vtkGhostType marks as hidden are passed through but take no part.
 * Cells that it marks as duplicates of another piece's carry the field on, but count neither in the
 * sums of the field data nor on port 1. Each piece is solved for itself; vtkPDirectionField
 * solves the pieces of several processes as one surface.
 * An input without polygons and strips has the zero field; an empty input gives an empty output.
 *
 * @section Output Output port 0: the field
 * The input with its data, and in addition (arrays of the same names are replaced):
 * - point data `Direction0` ... `Direction{n-1}`: 3 components, double if the points are double,
 *   else float. Unit tangent vectors, counter-clockwise about the outward normal, each 2 pi / n
 *   after the one before. The first is the one closest to the x axis, so that neighbours mostly
 *   agree on it. (0, 0, 0) at points that no triangle uses. `Direction0` is the active vectors; the
 *   active scalars stay the same. Arrays `Direction{n}` ... `Direction15` that an earlier
 *   filter left are removed.
 * - point data `RepresentationMagnitude`: 1 component, type as above. |u|, the length of the
 *   section that was solved for: 1 in the mean square over each connected component, and everywhere
 *   with UnitLength; 0 at unused points. It says how far the solution faded, as it does near
 *   singularities and far from constraints, not how certain the directions are.
 * - point data `EnergyDensity`: 1 component, type as above, in 1 / length^2. How much the
 *   directions turn around the point, whatever the length of u: the square of the gradient of the
 *   n-th power of the unit direction. Large near singularities, 0 where the field is parallel.
 * - cell data `SingularityIndex`: int, in units of 1/n. The index of the field inside the cell: 0
 *   where it is regular, 1 for n = 4 means a quarter turn in the direction of a walk around the
 *   cell, negative values a turn against it. For a polygon or a strip the sum over its triangles.
 *   0 on vertices, lines and cells that take no part. Over a closed surface the values sum up to n
 *   times the Euler characteristic, exactly.
 * - cell data `Direction0`, `Direction1`, ...: 3 components, double or float as the points. With
 *   CellDirections: the directions at the cell's centroid, unit vectors in the plane of the cell,
 *   or of that of its triangles which the centroid is in, counter-clockwise. Zero on vertices,
 *   lines and cells that take no part.
 * - point data `FaceSingularityIndex`: int, in units of 1/n. With CellDirections: the index of the
 *   point that programs find which know the directions of the triangles only, by the least rotation
 *   from one to the next. 0 on the boundary; of points that became one, at the first. Over a closed
 *   surface the values sum up to n times the Euler characteristic.
 * - field data, one tuple per connected component, ordered by their first cells:
 *   - `Eigenvalue`: double. lambda, the smoothness energy of the smoothest field, in 1 / length^2.
 *   - `Residual`: double. |A u - lambda M u| / |A u| reached by the solver.
 *   - `Iterations`: int. Solves or V-cycles that it took; 0 for components of few points.
 *   - `SolverUsed`: int. 1 for multigrid, 2 for a factorization.
 *   - `EulerCharacteristic`: int. Vertices - edges + triangles. Of a surface in pieces with a layer
 *     of ghosts each, the values of the pieces add up to that of the surface.
 *   - `IndexSum`: int. Sum of the singularity indices, in units of 1/n.
 *   - `Lambda`: double. lambda_t of the system that gave the field, in 1 / length^2: `Eigenvalue`
 *     for the smoothest field, less for an aligned one, the lowest double where AlignmentStrength
 *     is 1, 0 for constraints without alignment.
 *   - `SmoothnessEnergy`: double. u^* A u / u^* M u of the field, in 1 / length^2: `Eigenvalue` for
 *     the smoothest field, more for any other.
 *   - `SystemResidual`: double. Relative residual of the linear system that gave an aligned or
 *     constrained field; for least squares that of the normal equations. 0 for the smoothest.
 *   - with UnitLength only, `UnitEnergy`: double, components Before and After. The energy of the
 *     unit directions of the smoothest, aligned or constrained field, and that of the output; no
 *     unit, the same at any scale.
 *   - with UnitLength only, `CancelledPairs` and `UnitSteps`: int. The pairs of singularities that
 *     were cancelled, and the steps of diffusion and descent.
 * - field data `Repairs`: int, one tuple. How much had to be mended, by named components:
 *   CollapsedTriangles, DuplicateTriangles, ReversedTriangles, DegenerateTriangles,
 *   NonManifoldEdges, NonManifoldPoints, NonOrientableComponents, MergedPoints. 0 for a clean
 *   surface.
 * - field data `Summary`: string, one tuple; on port 1, too. One line in ASCII that describes the
 *   field: "32 singularities (20 +, 12 -), index sum 8, 24 points constrained". The singularities
 *   are the points of port 1 and how many of them have a positive and a negative index; the sum is
 *   that of all components, in units of 1/n, followed by "over 3 components" where there are
 *   several. Where the solver did not reach its tolerance it says "not converged (residual 2e-05)"
 *   or "1 of 3 components not converged (residual 2e-05)", with the largest residual. There follow,
 *   where they apply, "aligned", "120 points constrained", "unit length with 31 % less energy",
 *   from the sums of `UnitEnergy`, and that an array GuidanceVectors is there which is not used. A
 *   field that follows tensors has "along Stress: 2 wedges, 2 trisectors, 3 % isotropic", with the
 *   part of the area where they have no direction. An input without triangles has "no field, for
 *   there are no triangles".
 *
 * Where there are any, also
 * - field data `Warnings`: string. The warnings of this run, one a tuple.
 * - point data `ConstraintKind`: int. 0 not constrained, 1 boundary, 2 sharp edge, 3 curvature,
 *   4 edge of more than two triangles, 5 given by GuidanceVectors.
 * - point data `ConstraintDirection`: 3 components, type as above. The unit tangent vector that the
 *   point is constrained to; (0, 0, 0) where it is not.
 * - point data `PrincipalDirection0`, `PrincipalDirection1`: 3 components, type as above. Unit
 *   tangent vectors of the larger and the smaller signed curvature; (0, 0, 0) where the two are
 *   equal.
 * - point data `MeanCurvature`, `GaussianCurvature`: type as above, in 1 / length and 1 / length^2.
 *   The mean curvature is positive where the surface is convex. On sharp edges, where the surface
 *   is bent and not curved, they follow the size of the triangles.
 * - point data `MajorValue`, `MinorValue`, `TensorAnisotropy`: type as above, in the unit of the
 *   tensors. With ALIGN_TENSOR: the larger and the smaller principal value in the surface, with
 *   their signs, and half of their difference, of the averaged tensors.
 * - point data `SurfaceTensor`: 6 components XX, YY, ZZ, XY, YZ, XZ, type and unit as above. These
 *   tensors themselves, without what is not along the surface.
 * - point data `OriginalPointIds`: vtkIdType, only where the surface was split because it is no
 *   manifold. The input's point of each point; the points that were split off come last, with the
 *   point data of their originals, and the polygons and strips use them.
 *
 * Where they are not, arrays of these names that an earlier filter left are removed.
 *
 * @section Singularities Output port 1: the singularities
 * A vertex at the centroid of every triangle with an index other than 0 that no other piece owns,
 * with point data
 * - `SingularityIndex`: int, in units of 1/n.
 * - `Index`: double. The same in full turns, SingularityIndex / n.
 * - `CellId`: vtkIdType. The cell of the input with the triangle.
 * - `Size`: float, in the input's unit of length. The diameter of a ball that shows the
 *   singularity: |SingularityIndex| times 0.022 of the diagonal of the box around the surface, or
 *   times 0.4 of the mean distance of the singularities (the square root of area / number) where
 *   that is less, so that many of them do not cover the surface. Other pieces' cells do not count;
 *   each block of a composite input has a box of its own.
 * - `Normals`: 3-component float, active normals. Unit outward normal of the triangle.
 *
 * @warning
 * Coordinates that are not finite are an error that names the first offending point, and both
 * outputs are empty.
 *
 * @warning
 * A component that cannot be oriented (a Möbius strip, a Klein bottle) has its field computed on
 * both sides at once, with a warning. The directions are smooth everywhere, and on a closed
 * component the indices sum up to n times the Euler characteristic. Only arrays that depend on a
 * side have a seam, as few edges as may be: the normal about which the directions follow each
 * other, and the sign of the mean curvature. Larger and smaller curvature change places there,
 * hence they guide fields of degree 4 but none of degree 2, with a warning.
 *
 * @warning
 * A surface that is no manifold is split into sheets, with a warning: at an edge of more than two
 * triangles, and where several fans of triangles meet in a point, each gets points of its own. The
 * vertices of such edges are always constrained to them. Vertices and lines stay on the input's
 * points. A polygon or a strip that is cut into triangles along such an edge cannot be torn: it
 * takes the points of its first triangle on that edge.
 *
 * @warning
 * Triangles wound against the majority of their component, duplicate triangles, triangles with a
 * repeated corner and triangles without area are mended for the computation, with one warning that
 * counts them. The output's geometry is the input's all the same.
 *
 * @warning
 * Polygons that are not convex or not planar are cut by their ears; a hole that is joined to the
 * outline by a bridge stays open. The field on the cut polygons
 * is that of the triangles, and a singularity may sit in any one of them.
 *
 * @warning
 * Without alignment and constraints the field is determined up to one rotation per connected
 * component, which makes it closest to the x axis on average. In a time series whose points move
 * and whose cells stay it is closest to the field of the step that this filter computed before,
 * lest it jump; on another visit of a step it may differ by that rotation. On symmetric shapes (a
 * sphere, say) one of several optimal fields is chosen; the same input always gives the same field.
 *
 * @warning
 * Every connected component of the mesh counts. Polygons that share places but no points, as along
 * texture seams or after reading an STL file, are connected by MergePoints. Where it is off, a
 * warning says so if at least half of the points on the boundary lie exactly on another one.
 */

#ifndef vtkDirectionField_h
#define vtkDirectionField_h

#include "vtkDirectionFieldGuidance.h"
#include "vtkDirectionFieldsFiltersModule.h" // For export macro

#include <functional> // For std::function
#include <memory>     // For std::unique_ptr
#include <string>     // For std::string

namespace DirectionFields
{
class DirectionFieldCache;
struct Guidance;
struct Options;
struct Result;
struct Surface;
struct SurfaceFigures;
}

class VTKDIRECTIONFIELDSFILTERS_EXPORT vtkDirectionField : public vtkDirectionFieldGuidance
{
public:
  static vtkDirectionField* New();
  vtkTypeMacro(vtkDirectionField, vtkDirectionFieldGuidance);
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
   * Relative residual |A u - lambda M u| / |A u| at which the solver stops, and that of aligned and
   * constrained systems, but not less than 1e-8 for them. Range 1e-12 to 0.1, default 1e-6.
   */
  vtkSetClampMacro(Tolerance, double, 1e-12, 0.1);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * Most solver iterations that a connected component may take. A component that has not reached
   * the Tolerance by then keeps the field that was reached, with a warning. Range 1 to 10000,
   * default 200.
   */
  vtkSetClampMacro(MaximumIterations, int, 1, 10000);
  vtkGetMacro(MaximumIterations, int);
  ///@}

  enum SolverType
  {
    SOLVER_AUTOMATIC = 0,
    SOLVER_MULTIGRID = 1,
    SOLVER_DIRECT = 2
  };

  ///@{
  /**
   * How matrices are inverted: automatically (0, default), by multigrid (1), in time and memory
   * proportional to the triangles, or by a sparse factorization (2). Automatic takes multigrid for
   * large connected components, and the factorization for small ones and where multigrid does not
   * converge; SolverUsed in the output's field data tells which. The results agree within the
   * Tolerance. Clamped to 0 ... 2.
   */
  vtkSetClampMacro(Solver, int, SOLVER_AUTOMATIC, SOLVER_DIRECT);
  vtkGetMacro(Solver, int);
  ///@}

  ///@{
  /**
   * Threads to compute with. 0, the default: as many as VTK's SMP backend has, or, with the backend
   * Sequential, as the process may run at once, but no more than the environment variables
   * VTK_SMP_MAX_THREADS and OMP_NUM_THREADS say. Results have the same bytes for any number.
   * Clamped to 0 ... 1024.
   */
  vtkSetClampMacro(NumberOfThreads, int, 0, 1024);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /**
   * Keep mesh, matrices, eigenvectors and curvature of the last surface as long as the filter, so
   * that executions with changed properties redo only the dependent stages; for changes of the
   * AlignmentStrength the first aligned field prepares, in a twentieth of its time. Off frees that
   * memory after each execution. Default on.
   */
  vtkSetMacro(KeepStages, bool);
  vtkGetMacro(KeepStages, bool);
  vtkBooleanMacro(KeepStages, bool);
  ///@}

  /**
   * Frees everything that is kept between executions, now.
   */
  void ReleaseStages();

  enum MergePointsType
  {
    MERGE_POINTS_OFF = 0,
    MERGE_POINTS_ON = 1,
    MERGE_POINTS_AUTOMATIC = 2
  };

  ///@{
  /**
   * Which points of exactly the same coordinates are one in the computation. Surfaces whose
   * triangles share places but no points (STL files, texture seams) fall into pieces where none are
   * (0). All are (1), or those at the ends of boundary edges that coincide with exactly one other
   * boundary edge (2, default): surfaces that merely touch, at a point or along an edge of several
   * ones, stay apart then. The output keeps the input's points; those that are one have the
   * same directions. Points that are only close to each other stay apart: vtkCleanPolyData merges
   * these. Repairs counts the points.
   */
  vtkSetClampMacro(MergePoints, int, MERGE_POINTS_OFF, MERGE_POINTS_AUTOMATIC);
  vtkGetMacro(MergePoints, int);
  vtkBooleanMacro(MergePoints, int);
  ///@}

  ///@{
  /**
   * Whether the energy is taken on the intrinsic Delaunay triangulation of the surface's points:
   * the same surface, as if its triangles had been chosen better. Slivers spoil the field less
   * then, and Eigenvalue, SmoothnessEnergy and the like are those of this triangulation. All the
   * rest (curvature, constraints, singularities) stays with the surface's own triangles. Default
   * off.
   */
  vtkSetMacro(IntrinsicDelaunay, bool);
  vtkGetMacro(IntrinsicDelaunay, bool);
  vtkBooleanMacro(IntrinsicDelaunay, bool);
  ///@}

  ///@{
  /**
   * Give the directions at the cells' centroids, too, as cell data, and the singularities that
   * programs find which know these only, as the point data FaceSingularityIndex. Default off.
   */
  vtkSetMacro(CellDirections, bool);
  vtkGetMacro(CellDirections, bool);
  vtkBooleanMacro(CellDirections, bool);
  ///@}

  ///@{
  /**
   * Go on from the smoothest, aligned or constrained field to one whose directions have less
   * energy. The eigenvector and the linear systems minimize the energy of a section whose length is
   * free: where it fades, its directions bend and make singularities in pairs. With this the
   * representation vectors all have the length 1: diffusion and projection, descent in the phases,
   * cancellation of pairs of singularities and moves of single ones lower the energy of the
   * directions themselves. The result is a local minimum, no global one; it starts from the global
   * optimum above, and is never worse than that one's directions. For any degree, alignment and
   * constraint. Default off.
   */
  vtkSetMacro(UnitLength, bool);
  vtkGetMacro(UnitLength, bool);
  vtkBooleanMacro(UnitLength, bool);
  ///@}

  ///@{
  /**
   * With UnitLength: the cost of a singularity of index 1/n when pairs are cancelled, in units of 2
   * pi ln 2. That much energy one more subdivision of the mesh would add for it, so that 1 makes
   * the choice of a mesh once more subdivided. The more it costs, the fewer singularities remain,
   * and the more the field bends. Range 0 to 4, default 0.
   */
  vtkSetClampMacro(SingularityCost, double, 0.0, 4.0);
  vtkGetMacro(SingularityCost, double);
  ///@}

  ///@{
  /**
   * With UnitLength: the number of starts. The field is a local minimum; the first start is the
   * field without UnitLength, all others are random, and the one of least energy, with the cost of
   * its singularities, is kept. Takes as many times as long. 0 for one start on surfaces of 1000
   * points and more, and up to 16 on smaller ones. Range 0 to 1000, default 0.
   */
  vtkSetClampMacro(NumberOfStarts, int, 0, 1000);
  vtkGetMacro(NumberOfStarts, int);
  ///@}

  ///@{
  /**
   * With UnitLength: the field before the descent, scaled to the length 1 and no more, in a
   * fraction of the time. The plugin shows it while a user draws, and computes the whole field once
   * the hand rests. Default off.
   */
  vtkSetMacro(Preview, bool);
  vtkGetMacro(Preview, bool);
  vtkBooleanMacro(Preview, bool);
  ///@}

protected:
  vtkDirectionField();
  ~vtkDirectionField() override;

  void Execute(
    const Ports& inputs, const Ports& outputs, const DirectionFields::Progress& progress) override;
  void Release(bool hasFailed) override;
  int ThreadsToUse() const override;

  /**
   * Takes away the arrays that an earlier filter left.
   */
  static void RemoveField(vtkPolyData* output);

  ///@{
  /**
   * The parts of Execute that filters of several processes replace, whose surface goes on on other
   * processes. ComputeField gives the field of the triangles of an input: surface has all its
   * points, so that ids stay the user's, and figures become those of the whole surface. It throws
   * DirectionFields::Stopped, or returns an aborted field. The options are those of the properties,
   * the guidance is read from the input's arrays, empty where no option uses it. IsSpeaker is false
   * where another process gives the warnings. ReadTogether does the reading of the input, which
   * comes before ComputeField. TypeOfArrays is VTK_DOUBLE where arrays and points of the field are
   * to be double, by default as the input's points are. IsNextStep tells whether the surface is
   * that of the next time step; PreviousField has the directions that the phase of the field
   * follows, as Vectors, where it is the next step for any process.
   */
  virtual DirectionFields::Result ComputeField(vtkPolyData* input,
    const DirectionFields::Surface& surface, const DirectionFields::Options& options,
    DirectionFields::SurfaceFigures& figures);
  virtual bool IsSpeaker() const { return true; }
  virtual void ReadTogether(const std::function<void()>& read);
  virtual int TypeOfArrays(vtkPolyData* input) const;
  DirectionFields::Options MakeOptions() const;
  DirectionFields::Guidance ReadGuidance(vtkPolyData* input);
  bool IsNextStep() const;
  DirectionFields::Guidance PreviousField(bool isNextStep, int degree);
  ///@}

private:
  vtkDirectionField(const vtkDirectionField&) = delete;
  void operator=(const vtkDirectionField&) = delete;

  int Degree;
  double EnergyBias;
  double Tolerance;
  int MaximumIterations;
  int Solver;
  int NumberOfThreads;
  bool KeepStages;
  int MergePoints;
  bool IntrinsicDelaunay;
  bool CellDirections;
  bool UnitLength;
  double SingularityCost;
  int NumberOfStarts;
  bool Preview;

  /// Data of the last input, so that another strength or constraint does not start from nothing.
  std::unique_ptr<DirectionFields::DirectionFieldCache> Last;
};

#endif
