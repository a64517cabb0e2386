// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Quality/FaceQuality.h"

#include "FaceMesh/Faces.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace DirectionFields
{
namespace
{
/// The ratio of a face without area.
constexpr double NoAspectRatio = 1e30;

/// A face by itself: from its first corner, in a unit that is a power of two near to its size, so
/// that products of lengths are numbers however small or large the face is.
struct LoneFace
{
  LoneFace(const std::vector<Vector3>& points, const std::array<Index, 4>& face)
    : Size(Internal::Faces::Size(face))
  {
    this->Corners[3] = Size == 4 ? 3 : None;
    double extent = 0.0;
    for (int c = 0; c < this->Size; ++c)
    {
      extent = std::max(extent, (points[face[c]] - points[face[0]]).cwiseAbs().maxCoeff());
    }
    // Half of the exponent at a time: that of a tiny face is out of range as a number.
    const int exponent = extent > 0.0 ? -std::ilogb(extent) : 0;
    const double half = std::ldexp(1.0, exponent / 2);
    const double rest = std::ldexp(1.0, exponent - exponent / 2);
    for (int c = 0; c < this->Size; ++c)
    {
      this->Points[c] = (points[face[c]] - points[face[0]]) * half * rest;
    }
    for (int c = 0; c < this->Size; ++c)
    {
      this->Edges[c] = this->Points[(c + 1) % this->Size] - this->Points[c];
    }
  }

  double AspectRatio() const
  {
    double longest = 0.0;
    double sum = 0.0;
    for (int c = 0; c < this->Size; ++c)
    {
      longest = std::max(longest, this->Edges[c].norm());
      sum += this->Edges[c].norm();
    }
    // Of a plane quad that is not folded the two triangles have the area of the quad.
    const double twiceArea = this->Edges[0].cross(this->Edges[1]).norm() +
      (this->Size == 4 ? this->Edges[2].cross(this->Edges[3]).norm() : 0.0);
    const double even = this->Size == 4 ? 0.5 : 0.5 / std::sqrt(3.0);
    const double ratio = even * longest * sum / twiceArea;
    return ratio < NoAspectRatio ? ratio : NoAspectRatio;
  }

  double Warpage() const
  {
    if (this->Size == 3)
    {
      return 0.0;
    }
    std::array<Vector3, 4> normals;
    for (int c = 0; c < 4; ++c)
    {
      // Stays 0 where an angle is straight: no plane is known there.
      normals[c] = this->Edges[(c + 3) % 4].cross(this->Edges[c]).stableNormalized();
    }
    const double cosine = std::min(normals[0].dot(normals[2]), normals[1].dot(normals[3]));
    return std::clamp(1.0 - cosine * cosine * cosine, 0.0, 2.0);
  }

  int Size;
  std::array<Index, 4> Corners{ 0, 1, 2, 3 };
  std::vector<Vector3> Points = std::vector<Vector3>(4, Vector3::Zero());
  std::array<Vector3, 4> Edges;
};
}

FaceQuality QualityOf(
  const std::vector<Vector3>& points, const std::vector<std::array<Index, 4>>& faces)
{
  FaceQuality quality;
  quality.ScaledJacobian.reserve(faces.size());
  quality.AspectRatio.reserve(faces.size());
  quality.Warpage.reserve(faces.size());
  for (const std::array<Index, 4>& corners : faces)
  {
    const LoneFace face(points, corners);
    quality.ScaledJacobian.push_back(Internal::ScaledJacobian(face.Points, face.Corners));
    quality.AspectRatio.push_back(face.AspectRatio());
    quality.Warpage.push_back(face.Warpage());
  }
  return quality;
}
}
