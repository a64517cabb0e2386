// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Options_h
#define DirectionFields_Options_h

#include "Types.h"

#include <algorithm>
#include <vector>

namespace DirectionFields
{
/// The guidance that a field is drawn to.
enum class Alignment
{
  /// Nothing, which gives the smoothest field.
  None = 0,
  /// The principal curvature directions; degrees 2 and 4 only.
  PrincipalCurvature = 1,
  /// The vectors of Guidance.
  PointVectors = 2
};

/// Which principal direction a field of degree 2 is drawn to.
enum class CurvatureDirection
{
  /// The direction of the larger signed curvature, which is positive where the surface is convex.
  Maximum = 0,
  Minimum = 1,
  /// The direction in which the surface is bent least: of the curvature of smaller modulus.
  /// Guidance fades where the two have the same modulus.
  LeastBent = 2,
  /// That of larger modulus.
  MostBent = 3
};

/// The angle from which an edge is sharp by default, for fields, meshes and files. It is
/// more than edges of coarse round surfaces and of the noise of scans mostly have, and less than
/// those of an icosahedron, 41.8 degrees.
inline constexpr double DefaultFeatureAngle = 40.0;
inline constexpr double DefaultMinimumFeatureLength = 0.5;

/// How constraints enter.
enum class ConstraintSolver
{
  /// The residual of the whole system A u = b is minimized over the free vertices (POC14). It needs
  /// a sparse factor: components of more than MostLeastSquaresVertices are refused.
  LeastSquares = 0,
  /// The smoothness energy is minimized over the free vertices, in time linear in them.
  Energy = 1
};

/// Most vertices of a connected component that least squares solve for: at 165 000 they take up to
/// 5 s and 750 MB, and both grow faster than the component; by energy it takes half a second.
constexpr Index MostLeastSquaresVertices = 250000;

/// Which points of exactly the same coordinates are one for the computation.
enum class MergePoints
{
  /// None.
  Off = 0,
  /// All.
  On = 1,
  /// The ends of boundary edges that coincide with exactly one other boundary edge: seams of
  /// textures, facets of STL files, patches side by side. Surfaces that only touch stay apart.
  Automatic = 2
};

/// How matrices are inverted.
enum class Solver
{
  /// Multigrid for large components, Direct for small ones and where multigrid does not converge.
  Automatic = 0,
  /// Multigrid wherever a component has enough vertices for a hierarchy; time and memory grow in
  /// proportion to the triangles.
  Multigrid = 1,
  /// A sparse Cholesky factor.
  Direct = 2
};

/// The user's options. The defaults stand here and nowhere else.
struct Options
{
  /// Degree n of the rotational symmetry: the field has n directions at each point, 2 pi / n
  /// apart (1 vector, 2 line, 4 cross, 6 hex field). Range 1 to 16.
  int Degree = 4;
  /// s in the energy (1+s) E_holomorphic + (1-s) E_antiholomorphic. Range -1 to 1; 0 is the
  /// Dirichlet energy.
  double EnergyBias = 0.0;
  /// A solution of the eigenvalue problem counts as converged up to this relative residual |A
  /// u - lambda M u| / |A u|, one of an aligned or constrained system up to this or 1e-8, whichever
  /// is larger. Range 1e-12 to 0.1.
  double Tolerance = 1e-6;
  /// Most solves with the factored matrix, or V-cycles, that a connected component may take for its
  /// smallest eigenpair. Range 1 to 10000.
  int MaximumIterations = 200;
  DirectionFields::Solver Solver = DirectionFields::Solver::Automatic;
  /// Take the energy on the intrinsic Delaunay triangulation of the surface's vertices, which is
  /// the same surface with better triangles. The eigenvalue problem and the linear systems use it;
  /// the curvature, the constraints and the singularity indices stay with the surface's own
  /// triangles.
  bool IntrinsicDelaunay = false;
  /// Go on from the smoothest, aligned or constrained field to one whose representation vectors all
  /// have the length 1, and whose energy is less than that of the first field's directions: by
  /// diffusion, descent in the phases, and singularities that cancel each other. It is a local
  /// minimum, no global one.
  bool UnitLength = false;
  /// The cost of a singularity of index 1/n to a field of unit length, in units of 2 pi ln 2, the
  /// energy that one gains each time the mesh is subdivided: the more, the fewer remain. Those in
  /// triangles with a given value cost nothing, since corners ask for them. Range 0 to 4.
  double SingularityCost = 0.0;
  /// A field of unit length is a local minimum of the energy. It is sought from this many starts,
  /// the first of which is the smoothest, aligned or constrained field, all others random, and the
  /// one of least energy, with the cost of its singularities, is kept: more never makes it worse,
  /// but for one part in a thousand, and takes as many times as long. 0 for one start on surfaces
  /// of 1000 points and more, and up to 16 on smaller ones. Range 0 to 1000.
  int NumberOfStarts = 0;
  /// With UnitLength: only scale the smoothest, aligned or constrained field to length 1. While
  /// something is changed by hand that takes a fraction of the time, and the directions are those
  /// that the descent begins at.
  bool Preview = false;
  /// Threads to compute with; 0 for as many as the process may run at once, but no more than
  /// OMP_NUM_THREADS says. The number changes no byte of the result. Range 0 to 1024.
  int NumberOfThreads = 0;

  /// Points of exactly the same coordinates become one for the computation, which connects
  /// triangles that share places but no points; the result is the same at each of them. Their
  /// guidance is that of the first of them that has any.
  DirectionFields::MergePoints MergePoints = DirectionFields::MergePoints::Automatic;

  DirectionFields::Alignment Alignment = DirectionFields::Alignment::None;
  DirectionFields::CurvatureDirection CurvatureDirection =
    DirectionFields::CurvatureDirection::Maximum;
  /// Radius of the surroundings of a vertex that its curvature is averaged over, in edges. 0 finds
  /// it for each vertex, by how much of the curvature is noise; the larger, the smoother the
  /// directions on scans. Range 0 to 32. Below about 2 nothing is averaged.
  double CurvatureScale = 0.0;
  /// tau, free of units, range 0 to 1: lambda_t = lambda_1 - sigma tau / (1 - tau) with
  /// sigma = max(lambda_1, 2 pi n / area of the component). 0 is the smoothest field, 1 the
  /// guidance itself; 0.5 is lambda_t = 0 where lambda_1 is the larger of the two, as on most
  /// closed curved surfaces: the start that KCPS13 recommends.
  double AlignmentStrength = 0.5;
  /// Take Shift instead of AlignmentStrength.
  bool UseShift = false;
  /// lambda_1 - lambda_t in 1 / length^2; at least 0.
  double Shift = 0.0;

  /// Constrain the vertices on the boundary to its direction.
  bool ConstrainBoundary = false;
  /// Constrain the vertices on edges sharper than FeatureAngle to the sharpest of them.
  bool ConstrainSharpEdges = false;
  /// Angle between the normals of the two triangles of an edge above which it is sharp, degrees.
  /// Range 0 to 180.
  double FeatureAngle = DefaultFeatureAngle;
  /// Chains of sharp edges are dropped as noise where they are shorter than this, in parts of the
  /// square root of the component's area, and stand out little from the edges around: less than
  /// four times as sharp, or eight times where they end freely. At least 0, which keeps all.
  double MinimumFeatureLength = DefaultMinimumFeatureLength;
  /// Constrain the vertices of high curvature to their principal directions; degrees 2 and 4 only.
  bool ConstrainCurvature = false;
  /// A vertex is constrained where |H| l or |K| l^2 exceeds this; l is the radius of a sphere with
  /// the area of the component. A sphere has 1 everywhere. At least 0.
  double CurvatureTolerance = 2.0;
  /// A curvature constraint is dropped where it differs by more than this from a neighbouring
  /// constraint, in degrees, after transport and modulo 2 pi / n, and where fewer than two
  /// neighbours are constrained. Range 0 to 180.
  double ConsistencyAngle = 30.0;
  /// Drop the curvature constraints of triangles around which the constraints wind (POC14).
  bool DropConstraintsAtSingularities = false;
  /// Constrain the vertices where Guidance has positive weight to its vectors, as strongly as
  /// Guidance::Strengths says.
  bool ConstrainGuidance = false;
  DirectionFields::ConstraintSolver ConstraintSolver = DirectionFields::ConstraintSolver::Energy;
};

/// Largest relative residual at which an aligned or constrained system counts as solved: Tolerance,
/// but not less than 1e-8. The eigenvalue problem may ask for less, as far as rounding allows.
inline double SystemTolerance(const Options& options)
{
  return std::max(1e-8, options.Tolerance);
}

/// The first stage of a computation that depends on an option. Results of earlier stages are kept
/// when it changes.
enum class OptionStage
{
  /// The vertices, edges and triangles of the surface.
  Mesh,
  /// Matrices and smallest eigenpairs.
  Energy,
  /// Guidance, constraints, the linear systems and all that follows.
  Field,
  /// None: the option changes how the result is computed and not one byte of it.
  None
};

/// Whether results of a stage, and of all before it, that were made for some options are right for
/// others, too.
bool AreSameUpTo(OptionStage stage, const Options& a, const Options& b);

/// Vectors that the user gives for the field to follow, one a point of the surface or none at all.
struct Guidance
{
  /// Each vector is projected to the tangent plane; the length that remains is a weight. Non-finite
  /// vectors count as zero.
  std::vector<Vector3> Vectors;
  /// Further weights, or empty for 1. Negative and non-finite ones count as 0.
  std::vector<double> Weights;
  /// How strongly Options::ConstrainGuidance holds each vector, or empty for 1. At 1 it is the
  /// direction there, exactly. With less, tau, the vertex is free, and the energy has a term that
  /// draws it there: w tau / (1 - tau) sqrt(sigma A) |u - g|^2, with the weight w relative to the
  /// largest one, a third A of the area around the vertex, sigma of AlignmentStrength and the
  /// direction's representation vector g of modulus 1. 0 draws nothing. Values outside of 0 to 1
  /// count as the nearer end, non-finite ones as 0.
  std::vector<double> Strengths = {};
};

/// Throw std::invalid_argument, its text a sentence for the user, for options out of range, for
/// curvature with a degree that has none, and for guidance that is asked for and not there.
void Check(const Options& options);
void Check(const Guidance& guidance, const Options& options, std::size_t points);
}

#endif
