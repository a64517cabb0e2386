// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FeaturePaths_h
#define DirectionFields_FeaturePaths_h

#include "Decimation/Decimation.h"
#include "Mesh/TriangleMesh.h"

#include <array>
#include <vector>

namespace DirectionFields::Internal
{
/// Which points of a surface each feature edge of a decimated mesh stands for.
class FeaturePaths
{
public:
  FeaturePaths() = default;
  /// @param isFeature not 0 for edges that are features; boundary edges always count
  /// @param isHard    not 0 for features that are kept whatever their shape; empty for none
  /// @param isSoft    not 0 for those that are bent less than others; empty for none
  FeaturePaths(const TriangleMesh& mesh, const std::vector<char>& isFeature,
    const Decimation& decimation, const std::vector<char>& isHard,
    const std::vector<char>& isSoft = {});
  /// The features of a mesh that is not decimated: each a path by itself.
  FeaturePaths(const TriangleMesh& mesh, const std::vector<char>& isFeature,
    const std::vector<char>& isHard, const std::vector<char>& isSoft = {});

  struct Path
  {
    /// Two points, the lower one first.
    std::array<Index, 2> Ends{ None, None };
    /// The points from the first one to the second, both included.
    std::vector<Index> Points;
    /// It is kept whatever its shape.
    bool IsHard = false;
    /// It is bent less than other features.
    bool IsSoft = false;
  };
  /// The path between two points, or null.
  const Path* Find(Index p, Index q) const;
  /// Not 0 for each inner edge of a mesh that is a hard path.
  std::vector<char> FindHard(const TriangleMesh& mesh) const;
  /// The same for paths that are hard or soft.
  std::vector<char> FindHardAndSoft(const TriangleMesh& mesh) const;
  /// An edge that gets a point in its middle.
  struct Split
  {
    std::array<Index, 2> Ends;
    Index Middle;
  };
  /// The inner point of a path that is to be where an edge is split, or None.
  Index MiddleOf(Index p, Index q) const;
  /// Divides the path of each edge that is split into two. The points in the middle replace the
  /// points of the path that they come from.
  void Halve(const std::vector<Split>& splits);

private:
  template <typename Condition>
  std::vector<char> FindEdges(const TriangleMesh& mesh, const Condition& condition) const;
  void Sort();
  std::vector<Path> Paths;
};
}

#endif
