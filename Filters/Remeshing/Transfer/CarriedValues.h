// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_CarriedValues_h
#define DirectionFields_CarriedValues_h

#include "Transfer/FaceOverlaps.h"

#include <vector>

namespace DirectionFields
{
/// Values of the triangles of a surface on the faces of a mesh of it. Values of several components
/// are one after the other.
class CarriedValues
{
public:
  /// Refers to all of its arguments.
  /// @param regions of the triangles, as the mesh was made with; empty for none
  CarriedValues(const Surface& surface, const RemeshResult& mesh, const std::vector<Index>& regions,
    const FaceOverlaps& overlaps);

  /// The mean over what each face covers, weighted by area: between the least and the largest value
  /// there. Values that are no numbers are left out; a face of which they have more than half, or
  /// that covers nothing, has the value of its closest triangle.
  std::vector<double> Means(const std::vector<double>& values, int components) const;

  /// Means that are changed so that the sum of value times area over the faces is that over the
  /// triangles, of each component, and in each region that has faces: by a multiple of their
  /// magnitude, so that zero stays zero, or, where all are zero, by a constant.
  /// @param change the largest multiple, if it is not null
  std::vector<double> Conserved(
    const std::vector<double>& values, int components, double* change = nullptr) const;

  /// The triangle that each face has its value from, where values must not be mixed: of the value
  /// that covers most of it, the closest triangle or the first one. Of values that cover the same,
  /// that of the closest triangle.
  /// @param classes numbers of the values of the triangles: the same ones for the same value
  std::vector<Index> LargestOverlaps(const std::vector<Index>& classes) const;

  /// The areas of the faces, of quads those of the triangles beside the diagonal from the first to
  /// the third corner, as VTK's integrals have them.
  static std::vector<double> AreasOf(const RemeshResult& mesh);

private:
  const Surface& Given;
  const RemeshResult& Mesh;
  const std::vector<Index>& Regions;
  const FaceOverlaps& Overlaps;
};
}

#endif
