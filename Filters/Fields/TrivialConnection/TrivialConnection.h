// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_TrivialConnection_h
#define DirectionFields_TrivialConnection_h

#include "Distance/SurfaceDistance.h"
#include "Progress.h"
#include "TrivialConnection/ConstrainedSets.h"
#include "TrivialConnection/DiscreteForms.h"
#include "TrivialConnection/PoissonSolver.h"
#include "TrivialConnection/RotationRepair.h"
#include "TrivialConnection/TreeCotree.h"

#include <optional>
#include <vector>

namespace DirectionFields::Internal
{
/// A field of a component whose singularities are prescribed.
struct TurnedField
{
  /// By how much the base is turned back at each vertex, n times the angle of the directions,
  /// radians.
  Eigen::VectorXd Turn;
  /// How much the field turns along each edge, not wrapped: its sum around each triangle is 2 pi
  /// k - Omega.
  EdgeForm Rotation;
  /// How often the directions turn against each loop of the component (see TreeCotree), in units of
  /// 1/n.
  std::vector<int> TurningNumbers;
  /// The sum over the edges of weight times the square of the rotation.
  double Energy = 0.0;
  /// Relative residual of the linear system.
  double Residual = 0.0;
  /// The component has too many loops for the best turning numbers to be looked for.
  bool KeepsTurningNumbers = false;
  /// How the rotations in each triangle were set; empty where all are as prescribed.
  std::vector<RotationSetting> Settings;
};

/// The fields of one component whose singularities are prescribed: trivial connections (K. Crane,
/// M. Desbrun, P. Schröder, Trivial Connections on Discrete Surfaces, 2010) in terms of the
/// vertices. The rotation w of a field along the edges, over the parallel transport, has the sum 2
/// pi k - Omega around each triangle, and is the one of least energy. It differs from that of a
/// base field by integers times 2 pi along edges and by the rise of a function, by which the base's
/// directions are turned. So directions are consistent however exactly the function is known, and
/// the indices are the prescribed ones wherever the rotation stays below pi.
///
/// Everything that depends on the base and the component only is kept: each field takes one linear
/// system, whose hierarchy exists already.
class TrivialConnection
{
public:
  /// All but base and isGiven must outlive this.
  /// @param base    representation vector of each vertex of the mesh; 0 counts as 1
  /// @param isGiven whether the base's directions are to stay, of each vertex of the mesh; empty
  ///                for nowhere
  TrivialConnection(const IntrinsicGeometry& geometry, const TriangleMesh::Component& component,
    int degree, const std::vector<Complex>& base, const std::vector<char>& isGiven);

  /// Throws Stopped.
  TurnedField Turn(const RotationTarget& target, const Progress& progress);
  const std::vector<int>& GetBaseIndices() const { return this->BaseIndices; }
  const TreeCotree& GetTrees() const { return this->Trees; }
  const ConstrainedSets& GetConstrained() const { return this->Constrained; }
  const DiscreteForms& GetForms() const { return this->Forms; }
  /// Made when it is first asked for.
  const PoissonSolver& GetSolver();

  /// The section of a field, of modulus 1.
  ComplexVector SectionOf(const TurnedField& field) const;
  /// The triangles of the component, counted from its first one, whose index is not that of the
  /// target.
  std::vector<Index> WrongTriangles(const RotationTarget& target, const TurnedField& field) const;

  /// The corners of singular triangles, joined by the rotations along their edges.
  /// @param form        the rotation along the edges before the base is turned
  /// @param edges       other edges whose ends are joined, too
  /// @param settings    of the triangles; empty where all are as prescribed
  /// @param givenValues the values of the sets of given vertices, which are joined at the whole
  ///                    turns nearest to these; null for none
  MergedUnknowns MergeSingular(const RotationTarget& target, const EdgeForm& form,
    const std::vector<RotationSetting>& settings, const std::vector<SetEdge>& edges,
    const Eigen::VectorXd* givenValues) const;

  /// More loops than this keep the turning numbers of the base.
  static constexpr std::size_t MostLoops = 64;

private:
  /// Forms of the generators with no divergence, up to 2 pi, and their products.
  struct Harmonic
  {
    std::vector<std::vector<TreeCotree::Term>> Forms;
    /// The function of each form whose rise, subtracted, leaves a harmonic form.
    std::vector<Eigen::VectorXd> Potentials;
    Eigen::MatrixXd Products;
  };

  const Harmonic& GetHarmonic(const Progress& progress);
  Eigen::VectorXd SolveFor(const EdgeForm& form, Eigen::VectorXd guess,
    const MergedUnknowns* merged, const Progress& progress, double& residual);
  double Holonomy(Index localTriangle) const;
  std::optional<std::array<double, 3>> RotationsAt(
    const RotationTarget& target, Index localTriangle, const MeshPlace* place) const;
  void JoinAsBase(Index localTriangle, const EdgeForm& form, MergedUnknowns& sets) const;
  EdgeForm FormToMinimize(const RotationTarget& target) const;
  void SetTurn(const Eigen::VectorXd& potential, const EdgeForm& whole, TurnedField& field);
  void ChooseTurning(EdgeForm& form, Eigen::VectorXd& potential, const Progress& progress);

  const IntrinsicGeometry& Geometry;
  const TriangleMesh::Component& Component;
  int Degree;
  /// The base on this component.
  std::vector<Complex> Base;
  DiscreteForms Forms;
  ConstrainedSets Constrained;
  EdgeForm BaseRotation;
  std::vector<int> BaseIndices;
  TreeCotree Trees;
  std::optional<PoissonSolver> Solver;
  std::optional<Harmonic> Cache;
};
}

#endif
