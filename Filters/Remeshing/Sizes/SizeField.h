// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SizeField_h
#define DirectionFields_SizeField_h

#include "Surface.h"

#include <functional>
#include <string>
#include <vector>

namespace DirectionFields::Internal
{
/// Wanted lengths of edges at the points of a surface as sizes times a length: that of faces of
/// even size, or the nearest one with which sizes are in their range.
struct RelativeSizes
{
  double EdgeLength = 0.0;
  std::vector<double> Sizes;
  /// For the user, where lengths are out of the range of one mesh.
  std::vector<std::string> Notes;
};

/// Throws std::invalid_argument, its text a sentence for the user, where a length is no positive
/// number.
/// @param lengths at the points, in the user's unit
/// @param unit    of the surface, in the user's
/// @param name    of the lengths for the user, at the beginning of a sentence
RelativeSizes SizesFor(const Surface& surface, const std::vector<double>& lengths, double unit,
  const std::string& name = "Lengths of the Sizing Array");

/// Makes sizes smaller so that edges beside each other differ by no more than a factor.
/// @param sizes         at the points, above 0
/// @param gradation     the factor, above 1
/// @param edgeLengthFor the length of edges where the size is 1, for the surface's RelativeArea
void LimitGradation(const Surface& surface, double gradation,
  const std::function<double(double)>& edgeLengthFor, std::vector<double>& sizes);

/// Makes sizes smaller so that they grow by no more than a slope over the distance along edges of
/// the surface. Points at one place have one size. Takes n log n time.
/// @param sizes at the points, above 0
/// @param slope of the size, per unit of length
void LimitGrowth(const Surface& surface, double slope, std::vector<double>& sizes);
}

#endif
