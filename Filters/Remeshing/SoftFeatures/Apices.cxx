// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SoftFeatures/Apices.h"

#include "Paths/SurfaceIncidence.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_set>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// A tip is bent by more than the corner of a cube, whose edges keep it where they are kept.
constexpr double LeastDefect = 100.0 / 180.0 * Pi;
constexpr double MostBeside = 0.5;
/// Where more neighbours of points are looked at than this times those that there are, the
/// candidates are those of noise.
constexpr std::size_t MostLooks = 4;

double AngleAt(const Vector3& p, const Vector3& q, const Vector3& r)
{
  const Vector3 u = q - p;
  const Vector3 v = r - p;
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

/// A walk around the candidates, one after another.
class Neighbourhood
{
public:
  Neighbourhood(const Surface& surface, const std::vector<double>& defects)
    : At(surface)
    , Defects(defects)
    , Left(MostLooks * 6 * surface.Triangles.size())
  {
  }

  bool IsTooMuch() const { return this->Left == 0; }

  /// Whether all edges at a point are those of two triangles. Finds its neighbours.
  bool IsInside(Index p)
  {
    this->Around.clear();
    for (const Index* t = this->At.BeginTriangles(p); t != this->At.EndTriangles(p); ++t)
    {
      for (const Index q : this->At.GetSurface().Triangles[*t])
      {
        if (q != p)
        {
          this->Around.push_back(q);
        }
      }
    }
    std::sort(this->Around.begin(), this->Around.end());
    const std::size_t count = this->Around.size();
    this->Left -= std::min(this->Left, count);
    bool isInside = count % 2 == 0 && !this->IsTooMuch();
    for (std::size_t k = 0; isInside && k < count; k += 2)
    {
      isInside = this->Around[k] == this->Around[k + 1] &&
        (k + 2 == count || this->Around[k + 2] != this->Around[k]);
    }
    return isInside;
  }

  /// Whether a tip stands by itself within a distance.
  bool IsAlone(Index tip, double distance)
  {
    const std::vector<Vector3>& points = this->At.GetSurface().Points;
    double beside = 0.0;
    std::vector<Index> found = { tip };
    std::unordered_set<Index> isFound = { tip };
    for (std::size_t k = 0; k < found.size(); ++k)
    {
      const Index p = found[k];
      beside += p == tip ? 0.0 : std::abs(this->Defects[p]);
      if (beside > MostBeside * this->Defects[tip] || !this->IsInside(p))
      {
        return false;
      }
      for (const Index q : this->Around)
      {
        if ((points[q] - points[tip]).norm() < distance && isFound.insert(q).second)
        {
          found.push_back(q);
        }
      }
    }
    return true;
  }

private:
  const SurfaceIncidence At;
  const std::vector<double>& Defects;
  std::vector<Index> Around;
  std::size_t Left;
};
}

Apices::Apices(std::shared_ptr<const Surface> surface)
  : Given(std::move(surface))
{
  const std::vector<Vector3>& points = this->Given->Points;
  const auto isPoint = [&](Index p) { return p >= 0 && p < static_cast<Index>(points.size()); };
  std::vector<double> angles(points.size(), 0.0);
  for (const Triangle& t : this->Given->Triangles)
  {
    if (!std::all_of(t.begin(), t.end(), isPoint))
    {
      // Such a surface has no mesh, and an error that says so.
      return;
    }
    for (int c = 0; c < 3; ++c)
    {
      angles[t[c]] += AngleAt(points[t[c]], points[t[(c + 1) % 3]], points[t[(c + 2) % 3]]);
    }
  }
  for (std::size_t p = 0; p < angles.size(); ++p)
  {
    const double defect = 2.0 * Pi - angles[p];
    if (angles[p] > 0.0 && defect > LeastDefect)
    {
      this->Candidates.push_back(static_cast<Index>(p));
    }
    angles[p] = defect;
  }
  if (this->Candidates.empty())
  {
    return;
  }
  this->Defects = std::move(angles);
  // All points of straight boundaries are among them.
  Neighbourhood neighbourhood(*this->Given, this->Defects);
  this->Candidates.erase(std::remove_if(this->Candidates.begin(), this->Candidates.end(),
                           [&](Index p) { return !neighbourhood.IsInside(p); }),
    this->Candidates.end());
}

std::vector<Index> Apices::For(const std::vector<double>& sizes, double edgeLength) const
{
  std::vector<Index> tips;
  if (this->Candidates.empty())
  {
    return tips;
  }
  Neighbourhood neighbourhood(*this->Given, this->Defects);
  for (const Index p : this->Candidates)
  {
    if (neighbourhood.IsAlone(p, edgeLength * sizes[p]))
    {
      tips.push_back(p);
    }
  }
  return neighbourhood.IsTooMuch() ? std::vector<Index>() : tips;
}
}
