// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lines along the stress of a shell: a sphere of thickness 0.01 under an inner pressure of 1, with some more tension
// along the meridians. The lines follow them; at the poles the stress is the same in all directions.

#include "Surfaces.h"

#include <DirectionFields/DirectionField.h>
#include <DirectionFields/Guidance/TensorGuidance.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

using namespace DirectionFields;

int main()
{
  const Surface sphere = Sphere(32);
  SurfaceTensors stress;
  for (const Vector3& p : sphere.Points)
  {
    // The tension along the meridians is 20 at the equator, and falls to none at the poles.
    const Vector3 north = Vector3::UnitZ() - p.z() * p;
    const Eigen::Matrix3d t =
      50.0 * (Eigen::Matrix3d::Identity() - p * p.transpose()) + 20.0 * north * north.transpose();
    stress.Values.insert(
      stress.Values.end(), { t(0, 0), t(1, 1), t(2, 2), t(0, 1), t(1, 2), t(0, 2) });
  }
  DirectionField field(sphere);
  field.FollowTensors(stress, {});
  Options options;
  options.Degree = 2;
  options.AlignmentStrength = 1.0;
  const Result lines = field.Compute(options);

  double off = 0.0;
  for (Index i = 0; i < static_cast<Index>(sphere.Points.size()); ++i)
  {
    const Vector3& p = sphere.Points[i];
    const Vector3 north = (Vector3::UnitZ() - p.z() * p).normalized();
    const double cosine = std::min(1.0, std::abs(lines.Direction(i, 0).dot(north)));
    off = std::max(off, std::abs(p.z()) < 0.8 ? std::acos(cosine) * 180.0 / Pi : 0.0);
  }
  int sum = 0;
  for (const int index : lines.SingularityIndex)
  {
    sum += index;
  }
  const std::vector<double>& major = field.GetTensorGuidance()->MajorValue;
  const double most = *std::max_element(major.begin(), major.end());
  std::printf(
    "stress up to %.1f, lines at most %.2f degrees off, sum of indices %d\n", most, off, sum);
  return off < 1.0 && sum == 4 && std::abs(most - 70.0) < 0.5 ? EXIT_SUCCESS : EXIT_FAILURE;
}
