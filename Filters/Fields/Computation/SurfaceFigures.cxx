// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Computation/SurfaceFigures.h"

#include "Support/Threads.h"

#include <algorithm>

namespace DirectionFields
{
double SurfaceFigures::Diagonal() const
{
  return this->Lower[0] > this->Upper[0]
    ? 0.0
    : std::min((this->Upper - this->Lower).stableNorm(), std::numeric_limits<double>::max());
}

SurfaceFigures& SurfaceFigures::operator+=(const SurfaceFigures& other)
{
  const double own = this->Diagonal();
  const double others = other.Diagonal();
  this->Lower = this->Lower.cwiseMin(other.Lower);
  this->Upper = this->Upper.cwiseMax(other.Upper);
  const double diagonal = this->Diagonal();
  if (diagonal > 0.0)
  {
    this->Area = this->Area * (own / diagonal) * (own / diagonal) +
      other.Area * (others / diagonal) * (others / diagonal);
  }
  this->Positive += other.Positive;
  this->Negative += other.Negative;
  return *this;
}

SurfaceFigures FiguresOf(const Surface& surface, const std::vector<int>& indices)
{
  const auto triangles = static_cast<Index>(surface.Triangles.size());
  const auto isOwn = [&](Index t) { return surface.Ghost.empty() || surface.Ghost[t] == 0; };
  const auto indexed = static_cast<Index>(indices.size());
  SurfaceFigures figures = ParallelSum(triangles, MediumPiece, SurfaceFigures{},
    [&](Index begin, Index end)
    {
      SurfaceFigures part;
      for (Index t = begin; t < end; ++t)
      {
        if (!isOwn(t))
        {
          continue;
        }
        for (const Index corner : surface.Triangles[t])
        {
          part.Lower = part.Lower.cwiseMin(surface.Points[corner]);
          part.Upper = part.Upper.cwiseMax(surface.Points[corner]);
        }
        part.Positive += t < indexed && indices[t] > 0;
        part.Negative += t < indexed && indices[t] < 0;
      }
      return part;
    });
  const double diagonal = figures.Diagonal();
  if (diagonal == 0.0)
  {
    return figures;
  }
  figures.Area = ParallelSum(triangles, MediumPiece, 0.0,
    [&](Index begin, Index end)
    {
      double sum = 0.0;
      for (Index t = begin; t < end; ++t)
      {
        if (isOwn(t))
        {
          const Triangle& triangle = surface.Triangles[t];
          const Vector3 origin = surface.Points[triangle[0]];
          const Vector3 a = (surface.Points[triangle[1]] - origin) / diagonal;
          const Vector3 b = (surface.Points[triangle[2]] - origin) / diagonal;
          sum += 0.5 * a.cross(b).norm();
        }
      }
      return sum;
    });
  return figures;
}
}
