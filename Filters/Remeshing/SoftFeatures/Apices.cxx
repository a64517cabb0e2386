// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SoftFeatures/Apices.h"

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
/// Where the neighbourhoods of all candidates have more points than this times those of the
/// surface, they are those of noise.
constexpr std::size_t MostVisits = 4;

double AngleAt(const Vector3& p, const Vector3& q, const Vector3& r)
{
  const Vector3 u = q - p;
  const Vector3 v = r - p;
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

/// The triangles at each point; those at point p start at First[p].
struct TrianglesAt
{
  std::vector<Index> First;
  std::vector<Index> All;

  explicit TrianglesAt(const Surface& surface)
    : First(surface.Points.size() + 1, 0)
    , All(3 * surface.Triangles.size())
  {
    for (const Triangle& t : surface.Triangles)
    {
      for (const Index p : t)
      {
        ++this->First[p + 1];
      }
    }
    for (std::size_t p = 1; p < this->First.size(); ++p)
    {
      this->First[p] += this->First[p - 1];
    }
    std::vector<Index> next(this->First.begin(), this->First.end() - 1);
    for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
    {
      for (const Index p : surface.Triangles[t])
      {
        this->All[next[p]++] = static_cast<Index>(t);
      }
    }
  }
};

/// A walk around the candidates, one after another.
class Neighbourhood
{
public:
  Neighbourhood(const Surface& surface, const std::vector<double>& defects)
    : Given(surface)
    , Defects(defects)
    , At(surface)
  {
  }

  std::size_t GetVisits() const { return this->Visits; }

  /// Whether a tip stands by itself within a distance.
  bool IsAlone(Index tip, double distance)
  {
    double beside = 0.0;
    std::vector<Index> found = { tip };
    std::unordered_set<Index> isFound = { tip };
    for (std::size_t k = 0; k < found.size(); ++k)
    {
      const Index p = found[k];
      ++this->Visits;
      beside += p == tip ? 0.0 : std::abs(this->Defects[p]);
      if (beside > MostBeside * this->Defects[tip] || !this->IsInside(p))
      {
        return false;
      }
      for (const Index q : this->Around)
      {
        if ((this->Given.Points[q] - this->Given.Points[tip]).norm() < distance &&
          isFound.insert(q).second)
        {
          found.push_back(q);
        }
      }
    }
    return true;
  }

private:
  /// Whether all edges at a point are those of two triangles. Finds its neighbours.
  bool IsInside(Index p)
  {
    this->Around.clear();
    for (Index k = this->At.First[p]; k < this->At.First[p + 1]; ++k)
    {
      for (const Index q : this->Given.Triangles[this->At.All[k]])
      {
        if (q != p)
        {
          this->Around.push_back(q);
        }
      }
    }
    std::sort(this->Around.begin(), this->Around.end());
    const std::size_t count = this->Around.size();
    bool isInside = count % 2 == 0;
    for (std::size_t k = 0; isInside && k < count; k += 2)
    {
      isInside = this->Around[k] == this->Around[k + 1] &&
        (k + 2 == count || this->Around[k + 2] != this->Around[k]);
    }
    return isInside;
  }

  const Surface& Given;
  const std::vector<double>& Defects;
  const TrianglesAt At;
  std::vector<Index> Around;
  std::size_t Visits = 0;
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
  if (!this->Candidates.empty())
  {
    this->Defects = std::move(angles);
  }
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
    if (neighbourhood.GetVisits() > MostVisits * this->Given->Points.size())
    {
      return {};
    }
    if (neighbourhood.IsAlone(p, edgeLength * sizes[p]))
    {
      tips.push_back(p);
    }
  }
  return tips;
}
}
