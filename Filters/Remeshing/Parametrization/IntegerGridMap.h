// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_IntegerGridMap_h
#define DirectionFields_IntegerGridMap_h

#include "Charts/CutMesh.h"
#include "Charts/IntegerGrid.h"
#include "Progress.h"

#include <vector>

namespace DirectionFields::Internal
{
class ParametrizationEnergy;
class ParametrizationVariables;
struct FeatureIsoline;

/// The integer-grid map of a component: coordinates for every corner of every triangle whose gradients follow
/// the field, such that charts differ by maps of the lattice onto itself, cones and corners are lattice
/// points, and features are lines of the lattice (D. Bommes et al.: Integer-Grid Maps for Reliable Quad Meshing, 2013).
/// Of all such maps it nearly has the least energy: the sum over the triangles of the squared distance of
/// the edges' coordinates from their targets, with cotangent weights.
class IntegerGridMap
{
public:
  struct Settings
  {
    /// 1 / h of each vertex of the charted mesh, h the wanted length of an edge of the lattice.
    std::vector<double> PerLength;
    /// The targets are scaled such that the map has the lattice area that they ask for.
    bool KeepsArea = true;
  };

  /// Throws Stopped.
  IntegerGridMap(const CutMesh& mesh, const Settings& settings, const Progress& progress = {});
  /// The same, with equations that were made before: those of the charted mesh for these lengths of edges.
  IntegerGridMap(
    ParametrizationEnergy& equations, const Settings& settings, const Progress& progress = {});

  /// Why there is no map, or null.
  const char* GetFailure() const { return this->Failure; }
  /// The coordinates of each corner in the chart of its triangle; exact.
  const std::vector<GridPoint>& GetCorners() const { return this->Corners; }
  /// From the chart of the triangle on the other side of each half-edge to that of its own; the identity on
  /// the boundary.
  const std::vector<Transition>& GetAcross() const { return this->Across; }
  /// Integers that were rounded.
  Index GetNumberOfIntegers() const { return this->NumberOfIntegers; }
  /// The edges of the surface that are features of which no good line of a mesh can become: the ends came to
  /// the same place or to the wrong order, or the feature is short and the map folded beside it.
  const std::vector<Index>& GetCollapsedFeatures() const { return this->CollapsedFeatures; }
  /// Triangles that the map turns over, or flattens.
  Index CountFlipped() const;

private:
  void Solve(ParametrizationEnergy& equations, const Settings& settings, const Progress& progress);
  bool IsFlipped(Index t) const;
  /// The area of the images of the triangles, in parallelograms of the lattice. Those that are turned over count as
  /// nothing with folds, else as negative.
  double AreaCovered(bool withFolds) const;
  void FindFoldedFeatures(const CutMesh& mesh, const std::vector<FeatureIsoline>& stretches);
  void Evaluate(ParametrizationVariables& unknowns, const Eigen::VectorXd& free);

  IntegerGrid Plane;
  const char* Failure = nullptr;
  std::vector<GridPoint> Corners;
  std::vector<Transition> Across;
  std::vector<Index> CollapsedFeatures;
  Index NumberOfIntegers = 0;
};
}

#endif
