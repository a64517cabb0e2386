// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Meshes/Soundness.h"

#include <cmath>
#include <sstream>

using namespace DirectionFields;

namespace
{
constexpr double Rounding = 1e-9;

template <typename... Parts>
std::string Text(const Parts&... parts)
{
  std::ostringstream text;
  text.precision(17);
  (text << ... << parts);
  return text.str();
}

/// Whether each point of the output has a triangle, or an empty vector and the flaw.
std::vector<char> UsedPoints(const Surface& surface, const Result& result, std::string& flaw)
{
  std::vector<char> used(result.OriginalPoint.size(), 0);
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    if (result.Component[t] == None)
    {
      if (result.SingularityIndex[t] != 0)
      {
        flaw = Text("ignored triangle ", t, " has index ", result.SingularityIndex[t]);
        return {};
      }
      continue;
    }
    const Triangle& corners =
      result.SplitTriangles.empty() ? surface.Triangles[t] : result.SplitTriangles[t];
    for (int c = 0; c < 3; ++c)
    {
      if (result.OriginalPoint[corners[c]] != surface.Triangles[t][c])
      {
        flaw = Text("corner ", c, " of triangle ", t, " is not that of the input");
        return {};
      }
      used[corners[c]] = 1;
    }
  }
  return used;
}

/// @param unit the length of normals and directions there
std::string PointFlaw(const Result& result, Index i, double unit)
{
  const Complex u = result.Representation[i];
  if (!std::isfinite(u.real()) || !std::isfinite(u.imag()) || (unit == 0.0 && u != 0.0))
  {
    return Text("representation ", u);
  }
  if (!(std::abs(result.Normal[i].norm() - unit) <= Rounding))
  {
    return Text("normal of length ", result.Normal[i].norm());
  }
  for (int k = 0; k < result.Degree; ++k)
  {
    const Vector3 d = result.Direction(i, k);
    if (!(std::abs(d.norm() - unit) <= Rounding && std::abs(d.dot(result.Normal[i])) <= Rounding))
    {
      return Text("direction ", k, " of length ", d.norm(), ", ", d.dot(result.Normal[i]),
        " along the normal");
    }
  }
  if (!result.Constraint.empty())
  {
    const double length = result.ConstraintDirection[i].norm();
    const double wanted = result.Constraint[i] == ConstraintKind::None ? 0.0 : 1.0;
    if (!(std::abs(length - wanted) <= Rounding))
    {
      return Text("constraint direction of length ", length);
    }
  }
  const CurvatureReport* const curvature = result.Curvature.get();
  if (curvature &&
    !(std::isfinite(curvature->Mean[i]) && std::isfinite(curvature->Gaussian[i]) &&
      curvature->PrincipalDirection0[i].allFinite() &&
      curvature->PrincipalDirection1[i].allFinite()))
  {
    return "curvature that is not finite";
  }
  return {};
}

std::string ComponentFlaw(const ComponentReport& component, int degree, int sumOfIndices)
{
  for (const double figure : { component.Eigenvalue, component.Residual, component.Lambda,
         component.SmoothnessEnergy, component.SystemResidual })
  {
    if (!std::isfinite(figure))
    {
      return Text("eigenvalue ", component.Eigenvalue, ", residual ", component.Residual,
        ", lambda ", component.Lambda, ", energy ", component.SmoothnessEnergy,
        ", system residual ", component.SystemResidual);
    }
  }
  if (component.IndexSum != sumOfIndices)
  {
    return Text("index sum ", component.IndexSum, ", but the triangles' are ", sumOfIndices);
  }
  if (component.Closed && component.IndexSum != degree * component.EulerCharacteristic)
  {
    return Text("index sum ", component.IndexSum, " is not ", degree, " times ",
      component.EulerCharacteristic);
  }
  return {};
}
}

namespace Meshes
{
std::string Flaw(const Surface& surface, const Options& options, const Result& result)
{
  if (result.Aborted)
  {
    const bool empty = result.Representation.empty() && result.SingularityIndex.empty();
    return empty ? "" : "aborted, but not empty";
  }
  const std::size_t points = result.OriginalPoint.size();
  const std::size_t triangles = surface.Triangles.size();
  if (result.Degree != options.Degree || points < surface.Points.size() ||
    result.Representation.size() != points || result.Normal.size() != points ||
    result.XAxis.size() != points || result.SingularityIndex.size() != triangles ||
    result.Component.size() != triangles)
  {
    return "arrays of the wrong size";
  }
  std::string flaw;
  const std::vector<char> used = UsedPoints(surface, result, flaw);
  for (Index i = 0; flaw.empty() && i < static_cast<Index>(points); ++i)
  {
    // A point may have the directions of one that it was merged with.
    const bool merged =
      options.MergePoints != MergePoints::Off && result.Normal[i] != Vector3::Zero();
    flaw = PointFlaw(result, i, used[i] != 0 || merged ? 1.0 : 0.0);
    flaw = flaw.empty() ? flaw : Text("point ", i, ": ", flaw);
  }
  std::vector<int> sums(result.Components.size(), 0);
  for (std::size_t t = 0; flaw.empty() && t < triangles; ++t)
  {
    const bool counts = surface.Ghost.empty() || surface.Ghost[t] == 0;
    if (result.Component[t] != None && counts)
    {
      sums[result.Component[t]] += result.SingularityIndex[t];
    }
  }
  for (std::size_t c = 0; flaw.empty() && c < sums.size(); ++c)
  {
    flaw = ComponentFlaw(result.Components[c], options.Degree, sums[c]);
    flaw = flaw.empty() ? flaw : Text("component ", c, ": ", flaw);
  }
  return flaw;
}
}
