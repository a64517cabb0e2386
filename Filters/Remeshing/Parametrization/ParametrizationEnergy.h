// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ParametrizationEnergy_h
#define DirectionFields_ParametrizationEnergy_h

#include "Parametrization/EdgeSums.h"
#include "Parametrization/ParametrizationVariables.h"
#include "SparseCholesky/SchurSystem.h"

#include <optional>
#include <vector>

namespace DirectionFields::Internal
{
/// The energy of a map as a quadratic function of its free variables, the real ones before the
/// integers. Only its linear part, and which integers have a least value, depend on the wanted
/// lengths of edges: the factor of its matrix serves other lengths, too.
class ParametrizationEnergy
{
public:
  /// The mesh must live as long as this.
  /// @param perLength 1 / h of each vertex, h the wanted length of an edge of the grid
  ParametrizationEnergy(const CutMesh& mesh, const std::vector<double>& perLength);
  ParametrizationEnergy(const ParametrizationEnergy&) = delete;
  ParametrizationEnergy& operator=(const ParametrizationEnergy&) = delete;

  /// Whether the same feature isolines and distances of cones and lines have a bound for these
  /// lengths.
  bool IsFor(const std::vector<double>& perLength) const
  {
    return this->IsShort == this->Variables.ShortIsolines(perLength) &&
      this->Distances == FindRowDistances(this->GetMesh(), perLength);
  }
  const CutMesh& GetMesh() const { return this->Variables.Mesh; }
  ParametrizationVariables& GetVariables() { return this->Variables; }
  Index GetNumberOfIntegers() const { return this->Count - this->Reals; }

  /// The linear part of the energy.
  Eigen::VectorXd RightHandSide(const std::vector<double>& perLength) const;
  /// The least value of each integer. Distances that are far from it have none.
  /// @param relaxed where the energy is least over the reals
  Eigen::VectorXd Least(const Eigen::VectorXd& relaxed) const;
  /// The area of the triangles' images, in parallelograms of the grid.
  double AreaAt(const Eigen::VectorXd& x);

  /// False where there are too many integers to be rounded with regard to each other: there is no
  /// system then.
  bool IsFactored() const;
  /// Factored when it is asked for.
  const SchurSystem& GetSystem();
  /// As that of the system.
  void Shrink(std::size_t mostValues);
  /// As SolveInRounds of IntegerRounding, for an energy without a system.
  Eigen::VectorXd SolveInRounds(const Eigen::VectorXd& rightHandSide) const;

private:
  void AddEdge(Index halfEdge, double weight);
  double Mixed() const { return this->Plane.GetDegree() == 4 ? 0.0 : 0.5; }

  IntegerGrid Plane;
  ParametrizationVariables Variables;
  std::vector<char> IsShort;
  std::vector<RowDistance> Distances;
  /// The place of each free variable in the system.
  std::vector<Index> Slot;
  Index Count = 0;
  Index Reals = 0;
  std::optional<SchurSystem> System;
  /// The half-edge of each edge, in whose triangle's chart its target is.
  std::vector<Index> Edges;
  EdgeSums Sums;
};
}

#endif
