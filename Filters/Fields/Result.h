// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Result_h
#define DirectionFields_Result_h

#include "Options.h"
#include "Surface.h"

#include <memory>
#include <string>
#include <vector>

namespace DirectionFields
{
/// Figures of one connected component. Where there are ghosts of other pieces (Surface::Ghost),
/// counts and sums are those of the part that belongs to this piece; eigenvalue and field are those
/// of the whole component.
struct ComponentReport
{
  /// The smallest lambda of A u = lambda M u, in 1 / length^2 of the input.
  double Eigenvalue = 0.0;
  /// Relative residual reached, |A u - lambda M u| / |A u|; where lambda vanishes up to
  /// rounding, relative to 1e-7 ||A||u||, or 0 if it is no more than rounding.
  double Residual = 0.0;
  /// The bound on Residual: Options::Tolerance, or less where that would not tell the smallest
  /// eigenvalue from the next ones: at most 1e-5 by multigrid, by the direct solver where it has
  /// found another one first.
  double RequiredResidual = 0.0;
  /// Solves with the factored matrix, or V-cycles after the nested iteration; 0 where that was
  /// enough or the component small enough for a dense solver.
  int Iterations = 0;
  /// Direct where the eigenvalue or the linear system needed a factor, else Multigrid.
  Solver SolverUsed = Solver::Direct;
  /// Vertices - edges + triangles.
  int EulerCharacteristic = 0;
  /// Sum of the singularity indices, in units of 1/n; n times EulerCharacteristic if Closed.
  int IndexSum = 0;
  /// lambda_t of the system that gave the field, in 1 / length^2: below Eigenvalue where the field
  /// is aligned (the lowest double for the guidance itself), equal to it for the smoothest field, 0
  /// for constraints without alignment.
  double Lambda = 0.0;
  /// u^* A u of the field scaled to u^* M u = 1, in 1 / length^2: Eigenvalue for the smoothest
  /// field, larger for all others. Fields that fade away from their constraints have more of it,
  /// though their unscaled energy may be less.
  double SmoothnessEnergy = 0.0;
  /// Relative residual of the linear system that gave the aligned or constrained field, 0 for the
  /// smoothest field. For least squares it is the residual of the normal equations.
  double SystemResidual = 0.0;
  /// With Options::UnitLength: the energy of the directions before and after, which has no unit
  /// (see UnitEnergyMatrix; with an alignment the cost of the deviation from it is added); the
  /// pairs of singularities that were cancelled; and the steps taken.
  double UnitEnergyBefore = 0.0;
  double UnitEnergyAfter = 0.0;
  int CancelledPairs = 0;
  int UnitSteps = 0;
  Index Vertices = 0;
  Index Triangles = 0;
  /// Vertices that are constrained.
  Index Constraints = 0;
  /// The component has no boundary and no ghosts.
  bool Closed = false;
  /// Residual <= RequiredResidual, and SystemResidual <= Options::Tolerance or 1e-8.
  bool Converged = false;
};

/// Why the direction of a point is given. Given has priority over Boundary and NonManifold, these
/// over SharpEdge, and that over Curvature.
enum class ConstraintKind : signed char
{
  None = 0,
  /// The point is on the boundary and follows it.
  Boundary = 1,
  /// The point is on a sharp edge and follows it.
  SharpEdge = 2,
  /// The curvature is high: the point follows a principal direction.
  Curvature = 3,
  /// The point is on an edge of more than two triangles and follows it.
  NonManifold = 4,
  /// The point follows the user's guidance vector.
  Given = 5
};

/// Curvature of the surface, over the output points. It depends on the surface,
/// Options::MergePoints and Options::CurvatureScale only. Closed surfaces that are wound inside out
/// are seen from outside.
struct CurvatureReport
{
  /// Unit tangent vectors of the larger and of the smaller signed curvature; zero where the two
  /// are equal.
  std::vector<Vector3> PrincipalDirection0;
  std::vector<Vector3> PrincipalDirection1;
  /// H, positive where the surface is convex, and K; in 1 / length and 1 / length^2. At vertices on
  /// creases, where the surface is bent and not curved, they follow the size of the triangles.
  std::vector<double> Mean;
  std::vector<double> Gaussian;
};

/// The field and its diagnostics. Arrays over points follow the input's points, then the points
/// that were split off where the surface is no manifold; arrays over triangles follow the input's.
struct Result
{
  /// Degree n of the field.
  int Degree = 0;
  /// Whether it is of unit length (Options::UnitLength).
  bool UnitLength = false;
  /// Input point of each output point: itself up to the number of input points.
  std::vector<Index> OriginalPoint;
  /// Corners of the input's triangles as output points; empty where nothing was split.
  std::vector<Triangle> SplitTriangles;
  /// Representation vector u of each point: with u = |u| exp(i phi) the n directions stand at the
  /// angles (phi + 2 pi k) / n, counter-clockwise from XAxis about Normal. Its modulus is 1 in the
  /// mean square over each component, and 1 everywhere with Options::UnitLength. Zero at points
  /// that no triangle uses.
  std::vector<Complex> Representation;
  /// How much the directions turn around each point, however long Representation is: the square of
  /// the gradient of the n-th power of the unit direction, in 1 / length^2. Large near
  /// singularities; zero at points that no triangle uses.
  std::vector<double> EnergyDensity;
  /// Unit normal of each point, weighted by angle; zero at points that no triangle uses.
  std::vector<Vector3> Normal;
  /// Unit tangent vector of each point from which angles are measured; zero where Normal is.
  std::vector<Vector3> XAxis;
  /// Kind of each point's constraint, and its unit vector, zero where there is none. Empty where no
  /// point is constrained.
  std::vector<ConstraintKind> Constraint;
  std::vector<Vector3> ConstraintDirection;
  /// Curvature of the surface; null where neither alignment nor constraints use it. All results of
  /// one DirectionField share it as long as Options::MergePoints and Options::CurvatureScale stay
  /// the same.
  std::shared_ptr<const CurvatureReport> Curvature;
  /// Singularity index of each triangle, in units of 1/n.
  std::vector<int> SingularityIndex;
  /// Connected component of each triangle, ordered by their first triangles; None if ignored.
  std::vector<Index> Component;
  std::vector<ComponentReport> Components;
  Repairs Repaired;
  /// Sentences for the user: options that changed nothing, and why; and likely mistakes.
  std::vector<std::string> Notes;
  /// The computation was stopped by its progress callback; all arrays are empty.
  bool Aborted = false;

  /// The k-th unit direction at a point, k = 0 ... Degree-1, counter-clockwise about the normal.
  /// Direction 0 is the one closest to the x axis of space (the y axis where the normal is x), so
  /// that neighbours mostly agree on it. Zero at points that no triangle uses.
  Vector3 Direction(Index point, int k) const;
  /// All directions at points begin ... end - 1, Degree of them for each, in less time.
  void Directions(Index begin, Index end, Vector3* directions) const;

private:
  static constexpr Index FewPoints = 64;
  /// The angles of direction 0 from XAxis at no more than a few points.
  void FirstAngles(Index begin, Index end, double* angles) const;
};
}

#endif
