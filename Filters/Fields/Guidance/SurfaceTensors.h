// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SurfaceTensors_h
#define DirectionFields_SurfaceTensors_h

#include "Options.h"

#include <array>
#include <vector>

namespace DirectionFields
{
/// Which principal direction of a tensor's tangential part lines follow. Cross fields follow both
/// and do not depend on it.
enum class TensorDirection
{
  /// That of the larger principal value, with its sign: tension before compression.
  Major = 0,
  Minor = 1,
  /// That of the larger modulus. It jumps by 90 degrees where the principal values are opposite,
  /// which no field can follow; there the weight is 0.
  LargerMagnitude = 2
};

struct TensorGuidanceOptions
{
  TensorDirection Direction = TensorDirection::Major;
  /// Radius of the surroundings of a vertex that its tensor is averaged over, in edges. 0 finds it
  /// for each vertex, by how much of the tensor is noise. Range 0 to 32.
  double Scale = 0.0;
};

/// Tensors in the axes of space: stress, strain, diffusion.
struct SurfaceTensors
{
  /// Components of each tensor, one tensor after the other. Shear is the tensor's, half of the
  /// engineering shear.
  std::vector<double> Values;
  /// 6: XX, YY, ZZ, XY, YZ, XZ, the order of VTK; 9: by rows, of which the symmetric part counts.
  int Components = 6;
  /// One for each triangle of the surface in place of one for each point.
  bool AtTriangles = false;
};

/// Directions that tensors ask for, over the points of the surface.
struct TensorGuidance
{
  /// A unit vector along the principal direction, and its weight: 1 where the principal values
  /// differ, less where they are nearly the same, and 0 where their difference is within the noise
  /// or rounding of the tensors. Lines and crosses, degrees 2 and 4, can follow it.
  DirectionFields::Guidance Guidance;
  /// The averaged principal values of the tangential part, in the unit of the tensors, and half of
  /// their difference. 0 at points that no triangle uses.
  std::vector<double> MajorValue;
  std::vector<double> MinorValue;
  std::vector<double> Anisotropy;
  /// The averaged tangential part itself, in the axes of space: XX, YY, ZZ, XY, YZ, XZ.
  std::vector<std::array<double, 6>> Tangential;
  /// The part of the area where the weight is 0, 0 to 1.
  double IsotropicShare = 0.0;
  /// The largest modulus of a component of the part that is not symmetric, and so does not count,
  /// over that of all components.
  double AsymmetricPart = 0.0;
  /// The median of the shear across the surface over the size of the tensor. That of a stress is 0
  /// where nothing rubs on the surface; tensors in the axes of elements have any.
  double AcrossPart = 0.0;
};
}

#endif
