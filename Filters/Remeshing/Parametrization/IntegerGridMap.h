// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_IntegerGridMap_h
#define DirectionFields_IntegerGridMap_h

#include "Charts/CutMesh.h"
#include "Charts/IntegerGrid.h"
#include "Progress.h"

#include <optional>
#include <vector>

namespace DirectionFields::Internal
{
class ParametrizationEnergy;
class ParametrizationVariables;
struct FeatureIsoline;

/// Why a component has no integer-grid map.
enum class MapFailure
{
  /// The area of the surface asks for more cells than can be numbered.
  TooManyCells,
  /// The linear system is singular, or the rounding found no solution.
  NoSolution,
  /// Coordinates are outside of IntegerGrid::Range.
  OutOfRange,
  /// The map covers many times the area of the surface.
  ExcessiveArea
};

/// The failure as the end of a sentence for the user, after "since".
const char* Sentence(MapFailure failure);

/// The integer-grid map of a component: coordinates for every corner of every triangle whose
/// gradients follow the field, such that charts differ by symmetries of the integer grid, cones and
/// corners are grid points, and features are lines of the grid (D. Bommes et al.: Integer-Grid Maps
/// for Reliable Quad Meshing, 2013). Its energy is close to the least of all such maps: the sum
/// over the triangles of the squared differences between the edges' coordinates and their targets,
/// with cotangent weights.
class IntegerGridMap
{
public:
  struct Settings
  {
    /// 1 / h of each vertex of the cut mesh, h the wanted length of an edge of the grid.
    std::vector<double> PerLength;
    /// The targets are scaled such that the map covers the area that they ask for.
    bool KeepsArea = true;
    /// Flipped triangles are unfolded as far as that can be.
    bool IsUnfolded = true;
  };

  /// Throws Stopped.
  IntegerGridMap(const CutMesh& mesh, const Settings& settings, const Progress& progress = {});
  /// The same with an energy that was set up before for the cut mesh and these lengths of edges.
  IntegerGridMap(
    ParametrizationEnergy& energy, const Settings& settings, const Progress& progress = {});

  /// Why there is no map, or nothing if there is one.
  const std::optional<MapFailure>& GetFailure() const { return this->Failure; }
  /// The exact coordinates of each corner in the chart of its triangle.
  const std::vector<GridPoint>& GetCorners() const { return this->Corners; }
  /// From the chart of the triangle on the other side of each half-edge to the chart of its own
  /// triangle; the identity on the boundary.
  const std::vector<Transition>& GetAcross() const { return this->Across; }
  /// The number of variables that were rounded to integers.
  Index GetNumberOfIntegers() const { return this->NumberOfIntegers; }
  /// The feature edges of the surface that the map spoils as lines of a mesh: their ends came to
  /// the same place or to the wrong order, or the feature is short and the map is folded beside it.
  const std::vector<Index>& GetCollapsedFeatures() const { return this->CollapsedFeatures; }
  /// The number of triangles that the map flips or flattens.
  Index CountFlipped() const;

private:
  void Solve(ParametrizationEnergy& energy, const Settings& settings, const Progress& progress);
  bool IsFlipped(Index t) const;
  /// The area of the images of the triangles, in parallelograms of the grid. Flipped triangles
  /// count as 0 with folds, else as negative.
  double AreaCovered(bool withFolds) const;
  /// Sets the map to these values of the free variables.
  /// @param perLength those of the settings where flipped triangles are to be unfolded, or null
  void Evaluate(ParametrizationVariables& variables, const Eigen::VectorXd& free,
    const std::vector<double>* perLength = nullptr, const Progress& progress = {});
  void FindTransitions(const CutMesh& mesh, const std::vector<Transition>& own);
  void FindFoldedFeatures(const CutMesh& mesh, const std::vector<FeatureIsoline>& isolines);
  void Collapse(const CutMesh& mesh, const FeatureIsoline& isoline);

  IntegerGrid Plane;
  std::optional<MapFailure> Failure;
  std::vector<GridPoint> Corners;
  std::vector<Transition> Across;
  std::vector<Index> CollapsedFeatures;
  Index NumberOfIntegers = 0;
};
}

#endif
