// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Guidance/CurveDivision.h"

#include "Distance/ClosestPoints.h"
#include "Guidance/CurveSamples.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace DirectionFields
{
namespace
{
using Curve = std::vector<Vector3>;

/// Surfaces that are farther than the nearest one by no more than this part of an edge are as near.
constexpr double Nearness = 0.1;

/// The least of the surfaces' mean lengths of edges; 0 where none has any.
double MeanEdgeOfFinest(const std::vector<SurfaceCurves*>& surfaces)
{
  double least = std::numeric_limits<double>::infinity();
  for (const SurfaceCurves* const surface : surfaces)
  {
    const Surface& mesh = surface->GetSurface();
    double mean = 0.0;
    const double share = 1.0 / std::max<double>(1.0, 3.0 * mesh.Triangles.size());
    for (const Triangle& triangle : mesh.Triangles)
    {
      for (int c = 0; c < 3; ++c)
      {
        const double length =
          (mesh.Points[triangle[(c + 1) % 3]] - mesh.Points[triangle[c]]).stableNorm();
        mean += share * (std::isfinite(length) ? length : 0.0);
      }
    }
    least = mean > 0.0 ? std::min(least, mean) : least;
  }
  return std::isfinite(least) ? least : 0.0;
}

/// The surfaces that a piece of a curve may go to.
class Candidates
{
public:
  Candidates(const std::vector<SurfaceCurves*>& surfaces, double tolerance)
    : Tolerance(tolerance)
  {
    for (SurfaceCurves* const surface : surfaces)
    {
      this->Trees.push_back(
        surface->GetSurface().Triangles.empty() ? nullptr : &surface->GetTriangles());
    }
  }

  /// Valid up to the next call; empty where no surface has triangles.
  const std::vector<std::size_t>& At(const Vector3& place)
  {
    double nearest = std::numeric_limits<double>::infinity();
    this->Found.clear();
    for (std::size_t s = 0; s < this->Trees.size(); ++s)
    {
      const ClosestPoints::Answer answer = this->Trees[s]
        ? this->Trees[s]->Find(place, Vector3::Zero(), nearest + this->Tolerance)
        : ClosestPoints::Answer();
      if (answer.Triangle != None)
      {
        this->Found.push_back({ (answer.Position - place).stableNorm(), s });
        nearest = std::min(nearest, this->Found.back().Distance);
      }
    }
    this->Near.clear();
    for (const Candidate& candidate : this->Found)
    {
      if (candidate.Distance <= nearest + this->Tolerance)
      {
        this->Near.push_back(candidate.Surface);
      }
    }
    return this->Near;
  }

private:
  struct Candidate
  {
    double Distance;
    std::size_t Surface;
  };
  double Tolerance;
  std::vector<const ClosestPoints*> Trees;
  std::vector<Candidate> Found;
  std::vector<std::size_t> Near;
};

/// One curve, whose pieces go to surfaces.
class Division
{
public:
  Division(const Curve& curve, const Internal::CurveSteps& steps, Candidates& candidates,
    std::size_t surfaces)
    : Votes(surfaces, 0.0)
  {
    Internal::ForEachSegment(curve,
      [&](const Vector3& start, const Vector3& end, double length)
      {
        const Index pieces = steps.PiecesOf(length);
        const Vector3 tangent = (end - start) / pieces;
        for (Index k = 0; k < pieces; ++k)
        {
          const std::vector<std::size_t>& near = candidates.At(start + (k + 0.5) * tangent);
          for (const std::size_t surface : near)
          {
            this->Votes[surface] += length / pieces;
          }
          this->Near.insert(this->Near.end(), near.begin(), near.end());
          this->Ends.push_back(this->Near.size());
        }
      });
  }

  /// The surface of a piece; None where there is no surface at all.
  Index Of(std::size_t piece) const
  {
    const std::size_t begin = piece == 0 ? 0 : this->Ends[piece - 1];
    Index best = None;
    for (std::size_t k = begin; k < this->Ends[piece]; ++k)
    {
      const auto surface = static_cast<Index>(this->Near[k]);
      if (best == None || this->Votes[surface] > this->Votes[best] ||
        (this->Votes[surface] == this->Votes[best] && surface < best))
      {
        best = surface;
      }
    }
    return best;
  }

private:
  /// The length of what is near to each surface.
  std::vector<double> Votes;
  /// For each piece the surfaces that are near, and where its own end.
  std::vector<std::size_t> Near;
  std::vector<std::size_t> Ends;
};

/// Appends a piece to a curve, whose last place is its start if they belong together.
void Append(const Vector3& start, const Vector3& end, bool goesOn, Curve& curve)
{
  if (!goesOn)
  {
    if (!curve.empty())
    {
      curve.push_back(Vector3::Constant(std::numeric_limits<double>::quiet_NaN()));
    }
    curve.push_back(start);
  }
  curve.push_back(end);
}
}

std::vector<std::vector<std::vector<Vector3>>> DivideCurves(
  const std::vector<SurfaceCurves*>& surfaces, const std::vector<std::vector<Vector3>>& curves,
  const Progress& progress)
{
  std::vector<std::vector<Curve>> divided(surfaces.size(), std::vector<Curve>(curves.size()));
  const double edge = MeanEdgeOfFinest(surfaces);
  std::size_t triangles = 0;
  for (const SurfaceCurves* const surface : surfaces)
  {
    triangles += surface->GetSurface().Triangles.size();
  }
  const Internal::CurveSteps steps(curves, 0.5 * edge, triangles);
  Candidates candidates(surfaces, Nearness * edge);
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    progress.Report(static_cast<double>(c) / static_cast<double>(curves.size()));
    const Division division(curves[c], steps, candidates, surfaces.size());
    std::size_t piece = 0;
    Index last = None;
    Vector3 lastEnd = Vector3::Zero();
    Internal::ForEachSegment(curves[c],
      [&](const Vector3& start, const Vector3& end, double length)
      {
        const Index pieces = steps.PiecesOf(length);
        const Vector3 tangent = (end - start) / pieces;
        for (Index k = 0; k < pieces; ++piece)
        {
          // The pieces of a segment that follow each other on one surface stay in one.
          const Index surface = division.Of(piece);
          const Index first = k;
          for (++k; k < pieces && division.Of(piece + 1) == surface; ++k)
          {
            ++piece;
          }
          const Vector3 from = first == 0 ? start : Vector3(start + first * tangent);
          const Vector3 to = k == pieces ? end : Vector3(start + k * tangent);
          if (surface != None)
          {
            Append(from, to, surface == last && from == lastEnd, divided[surface][c]);
          }
          last = surface;
          lastEnd = to;
        }
      });
  }
  progress.Report(1.0);
  return divided;
}
}
