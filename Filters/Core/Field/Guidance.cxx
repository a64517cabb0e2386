// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Field/Guidance.h"

#include "Solvers/Matrices/VectorOperations.h"
#include "Support/Threads.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
std::vector<Complex> GuidanceSection(
  const SurfaceGeometry& geometry, const Guidance& guidance, int degree)
{
  const TriangleMesh& mesh = geometry.Mesh;
  std::vector<Complex> section(mesh.GetNumberOfVertices(), 0.0);
  // Only ratios of lengths and weights count. They are scaled so that their squares and products neither
  // overflow nor underflow.
  double longest = 0.0;
  for (const Vector3& v : guidance.Vectors)
  {
    longest = v.allFinite() ? std::max(longest, v.lpNorm<Eigen::Infinity>()) : longest;
  }
  double heaviest = guidance.Weights.empty() ? 1.0 : 0.0;
  for (const double weight : guidance.Weights)
  {
    heaviest = std::isfinite(weight) ? std::max(heaviest, weight) : heaviest;
  }
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

std::vector<Complex> CurvatureSection(
  const std::vector<Complex>& hopf, int degree, CurvatureDirection direction)
{
  std::vector<Complex> section(hopf.size());
  ParallelFor(static_cast<Index>(hopf.size()), VectorPiece,
    [&](Index begin, Index end)
    {
      std::transform(hopf.begin() + begin, hopf.begin() + end, section.begin() + begin,
        [&](const Complex& q) {
          return degree == 4 ? q * q : direction == CurvatureDirection::Minimum ? -q : q;
        });
    });
  return section;
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
