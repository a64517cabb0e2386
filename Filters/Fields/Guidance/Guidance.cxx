// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Guidance/Guidance.h"

#include "Support/Threads.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
GuidanceScale ScaleOf(const Guidance& guidance)
{
  GuidanceScale scale;
  for (const Vector3& v : guidance.Vectors)
  {
    scale.Longest =
      v.allFinite() ? std::max(scale.Longest, v.lpNorm<Eigen::Infinity>()) : scale.Longest;
  }
  scale.Heaviest = guidance.Weights.empty() ? 1.0 : 0.0;
  for (const double weight : guidance.Weights)
  {
    scale.Heaviest = std::isfinite(weight) ? std::max(scale.Heaviest, weight) : scale.Heaviest;
  }
  return scale;
}

std::vector<Complex> GuidanceSection(
  const SurfaceGeometry& geometry, const Guidance& guidance, int degree)
{
  return GuidanceSection(geometry, guidance, degree, ScaleOf(guidance));
}

std::vector<Complex> GuidanceSection(
  const SurfaceGeometry& geometry, const Guidance& guidance, int degree, const GuidanceScale& scale)
{
  const TriangleMesh& mesh = geometry.Mesh;
  std::vector<Complex> section(mesh.GetNumberOfVertices(), 0.0);
  const double longest = scale.Longest;
  const double heaviest = scale.Heaviest;
  if (longest == 0.0 || heaviest == 0.0)
  {
    return section;
  }
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    const Index point = mesh.Point(v);
    const double given = guidance.Weights.empty() ? 1.0 : guidance.Weights[point];
    const double weight = std::isfinite(given) ? std::max(0.0, given) / heaviest : 0.0;
    const Vector3 vector = guidance.Vectors[point] / longest;
    if (weight > 0.0 && vector.allFinite())
    {
      const Complex z = geometry.Frames.Tangential(v, vector);
      // The tangential part of a normal vector is nothing but rounding.
      if (std::abs(z) > 1e-9 * vector.norm())
      {
        section[v] = std::polar(weight * std::abs(z), degree * std::arg(z));
      }
    }
  }
  return section;
}

Complex CurvatureValue(
  const Curvature& curvature, Index vertex, int degree, CurvatureDirection direction)
{
  const Complex& q = curvature.Hopf[vertex];
  if (degree == 4)
  {
    const double size = std::abs(q);
    return size > 0.0 ? q * (q / size) : Complex(0.0);
  }
  if (direction == CurvatureDirection::Maximum || direction == CurvatureDirection::Minimum)
  {
    return direction == CurvatureDirection::Maximum ? q : -q;
  }
  // With k = H +- |q|, half of |k_max| - |k_min| is H, but no more than |q| and no less than -|q|.
  const double size = std::abs(q);
  const double mean = curvature.Mean[vertex];
  const Complex most = std::abs(mean) < size ? q * (mean / size) : std::copysign(1.0, mean) * q;
  return direction == CurvatureDirection::MostBent ? most : -most;
}

bool DependsOnSide(int degree, CurvatureDirection direction)
{
  return degree == 2 &&
    (direction == CurvatureDirection::Maximum || direction == CurvatureDirection::Minimum);
}

std::vector<Complex> CurvatureSection(
  const Curvature& curvature, int degree, CurvatureDirection direction)
{
  std::vector<Complex> section(curvature.Hopf.size());
  ParallelFor(static_cast<Index>(section.size()), LightPiece,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        section[v] = CurvatureValue(curvature, v, degree, direction);
      }
    });
  return section;
}

void Continue(const SurfaceGeometry& geometry, int degree, std::vector<Complex>& section)
{
  constexpr double decay = 0.1;
  // Weights below this are not reduced further, lest they be rounded to zero.
  constexpr double least = 1e-100;
  const TriangleMesh& mesh = geometry.Mesh;
  std::vector<char> isKnown(section.size());
  std::vector<Index> fan;
  std::vector<Index> front;
  const auto forEachNeighbour = [&](Index v, const auto& body)
  {
    mesh.GetFan(v, fan);
    for (const Index h : fan)
    {
      body(mesh.Head(h), -geometry.Transport.RotationAlong(mesh, h));
    }
    if (mesh.IsBoundary(v))
    {
      const Index incoming = TriangleMesh::Previous(fan.back());
      body(mesh.Tail(incoming), geometry.Transport.RotationAlong(mesh, incoming));
    }
  };
  for (Index v = 0; v < static_cast<Index>(section.size()); ++v)
  {
    isKnown[v] = section[v] != 0.0 ? 1 : 0;
  }
  for (Index v = 0; v < static_cast<Index>(section.size()); ++v)
  {
    if (isKnown[v] == 0)
    {
      bool isNext = false;
      forEachNeighbour(v, [&](Index j, double) { isNext = isNext || isKnown[j] != 0; });
      if (isNext)
      {
        front.push_back(v);
      }
    }
  }
  std::vector<Complex> values;
  while (!front.empty())
  {
    values.assign(front.size(), 0.0);
    for (std::size_t k = 0; k < front.size(); ++k)
    {
      double known = 0.0;
      forEachNeighbour(front[k],
        [&](Index j, double rotation)
        {
          if (isKnown[j] == 1)
          {
            values[k] += section[j] * std::polar(1.0, degree * rotation);
            known += 1.0;
          }
        });
      values[k] *= (std::abs(values[k]) > least ? decay : 1.0) / known;
    }
    std::vector<Index> next;
    for (std::size_t k = 0; k < front.size(); ++k)
    {
      section[front[k]] = values[k];
      isKnown[front[k]] = 1;
    }
    for (const Index v : front)
    {
      forEachNeighbour(v,
        [&](Index j, double)
        {
          if (isKnown[j] == 0)
          {
            isKnown[j] = 2;
            next.push_back(j);
          }
        });
    }
    front.swap(next);
  }
}

void ClearCovers(const TriangleMesh& mesh, std::vector<Complex>& section)
{
  for (const TriangleMesh::Component& component : mesh.GetComponents())
  {
    if (component.IsCover)
    {
      std::fill(
        section.begin() + component.FirstVertex, section.begin() + component.EndVertex, 0.0);
    }
  }
}

Guidance Merged(Guidance guidance, const std::vector<Index>& first)
{
  const auto counts = [&guidance](std::size_t i)
  {
    return guidance.Vectors[i].allFinite() && !guidance.Vectors[i].isZero() &&
      (guidance.Weights.empty() || guidance.Weights[i] > 0.0);
  };
  for (std::size_t i = 0; i < guidance.Vectors.size() && i < first.size(); ++i)
  {
    const auto target = static_cast<std::size_t>(first[i]);
    if (target != i && counts(i) && !counts(target))
    {
      guidance.Vectors[target] = guidance.Vectors[i];
      if (!guidance.Weights.empty())
      {
        guidance.Weights[target] = guidance.Weights[i];
      }
    }
  }
  return guidance;
}
}
