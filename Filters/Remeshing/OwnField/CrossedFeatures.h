// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_CrossedFeatures_h
#define DirectionFields_CrossedFeatures_h

#include "Geometry/SurfaceGeometry.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Where a field does not run along the features and the boundary of a surface: faces along it
/// would cross edges that they are to follow.
class CrossedFeatures
{
public:
  /// @param isFeature not 0 for each edge that is a feature
  /// @param section   of this degree over the vertices, zero where there is no field
  CrossedFeatures(const SurfaceGeometry& geometry, int degree, const std::vector<char>& isFeature,
    const std::vector<Complex>& section);

  /// The part of the length of features and boundary, from 0 to 1, where the field is more than 15
  /// degrees off them.
  double GetPart() const { return this->Part; }
  /// The directions of features and boundary at their vertices, of length 1; zero elsewhere, and
  /// where they meet at angles that no field of the degree has.
  const std::vector<Vector3>& GetAlong() const { return this->Along; }
  /// Not 0 for the vertices that are nearer to a crossed feature than this along edges, or to one
  /// of these vertices.
  std::vector<char> FindNear(double distance, const std::vector<Index>& others) const;

private:
  const SurfaceGeometry& Geometry;
  std::vector<Vector3> Along;
  std::vector<char> IsCrossed;
  double Part = 0.0;
};
}

#endif
