// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_DirectionField_h
#define DirectionFields_DirectionField_h

#include "MeshError.h"
#include "Types.h"

#include <functional>
#include <memory>
#include <vector>

namespace DirectionFields
{
/// What the user asks for. The one place of the defaults.
struct Options
{
  /// Degree n of the rotational symmetry: the field has n directions at each point, 2 pi / n
  /// apart (1 vector, 2 line, 4 cross, 6 hex field). Range 1 to 16.
  int Degree = 4;
  /// s in the energy (1+s) E_holomorphic + (1-s) E_antiholomorphic. Range -1 to 1; 0 is the
  /// Dirichlet energy.
  double EnergyBias = 0.0;
  /// Largest relative residual |A u - lambda M u| / |A u| of a solution that counts as converged.
  /// Range 1e-12 to 0.1.
  double Tolerance = 1e-6;
  /// Most solves with the factored matrix that a connected component may take. Range 1 to 10000.
  int MaximumIterations = 200;
};

/// A triangle mesh as it comes in: anything may be wrong with it.
struct Surface
{
  std::vector<Vector3> Points;
  /// Corners counter-clockwise as seen from outside.
  std::vector<Triangle> Triangles;
};

/// What had to be mended in the input; zero everywhere for a clean mesh.
struct Repairs
{
  /// Triangles with a corner used twice; ignored, their index is 0.
  Index CollapsedTriangles = 0;
  /// Triangles with the same three corners as an earlier one; ignored, their index is 0.
  Index DuplicateTriangles = 0;
  /// Triangles wound against the majority of their component; turned for the computation.
  Index ReversedTriangles = 0;
  /// Triangles (nearly) without area; their shortest edge was lengthened by about a millionth of
  /// their longest edge (mollification, Sharp and Crane 2020).
  Index DegenerateTriangles = 0;
};

/// Figures of one connected component.
struct ComponentReport
{
  /// lambda of A u = lambda M u, in 1 / length^2 of the input.
  double Eigenvalue = 0.0;
  /// Relative residual reached, |A u - lambda M u| / |A u|; where lambda vanishes up to
  /// rounding, relative to 1e-8 ||A||u||.
  double Residual = 0.0;
  /// Solves with the factored matrix; 0 where the component was small enough for a dense solver.
  int Iterations = 0;
  /// Vertices - edges + triangles.
  int EulerCharacteristic = 0;
  /// Sum of the singularity indices, in units of 1/n; n times EulerCharacteristic if Closed.
  int IndexSum = 0;
  Index Vertices = 0;
  Index Triangles = 0;
  /// The component has no boundary.
  bool Closed = false;
  /// Residual <= Options::Tolerance.
  bool Converged = false;
};

/// The field and its diagnostics. Arrays over points and triangles follow the input's numbering.
struct Result
{
  /// Degree n of the field.
  int Degree = 0;
  /// Representation vector u of each point: with u = |u| exp(i phi) the n directions stand at the
  /// angles (phi + 2 pi k) / n, counter-clockwise from XAxis about Normal. Zero at points that no
  /// triangle uses.
  std::vector<Complex> Representation;
  /// Unit normal of each point, weighted by angle; zero at points that no triangle uses.
  std::vector<Vector3> Normal;
  /// Unit tangent vector of each point from which angles are measured; zero likewise.
  std::vector<Vector3> XAxis;
  /// Singularity index of each triangle, in units of 1/n.
  std::vector<int> SingularityIndex;
  /// Connected component of each triangle, ordered by their first triangles; None if ignored.
  std::vector<Index> Component;
  std::vector<ComponentReport> Components;
  Repairs Repaired;
  /// The computation was stopped by its progress callback; all arrays but Repaired are empty.
  bool Aborted = false;

  /// The k-th unit direction at a point, k = 0 ... Degree-1, counter-clockwise about the normal.
  /// Direction 0 is the one closest to the x axis of space (the y axis where the normal is x), so
  /// that neighbours mostly agree on it. Zero at points that no triangle uses.
  Vector3 Direction(Index point, int k) const;
};

/// Called with the fraction done, 0 to 1; false stops the computation.
using ProgressFunction = std::function<bool(double)>;

/// The globally optimal direction field of a triangle mesh: for every connected component the
/// eigenvector to the smallest eigenvalue of the smoothness energy of
///
/// F. Knöppel, K. Crane, U. Pinkall, P. Schröder: Globally Optimal Direction Fields.
/// ACM Transactions on Graphics 32(4), 2013.
///
/// Whatever depends on the surface only is computed once, when the object is made.
class DirectionField
{
public:
  /// Throws MeshError for a surface that cannot be processed.
  explicit DirectionField(const Surface& surface);
  ~DirectionField();
  DirectionField(DirectionField&&) noexcept;
  DirectionField& operator=(DirectionField&&) noexcept;

  /// Throws std::invalid_argument for options out of range.
  Result Compute(const Options& options, const ProgressFunction& progress = {}) const;

private:
  struct Stages;
  std::unique_ptr<Stages> Surface_;
};
}

#endif
