// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Quads/FaceSmoothing.h"

#include "Support/Threads.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
constexpr Index PieceSize = 256;
constexpr int CarefulSweeps = 4;
/// How often vertices with bad faces have another try after that.
constexpr int Rescues = 16;
/// Faces better than this may become worse.
constexpr double GoodEnough = 0.5;
/// Around vertices with worse faces more places are tried.
constexpr double Bad = 0.3;

class Smoother
{
public:
  Smoother(const Faces& faces, const SmoothingDomain& domain, std::vector<Vector3>& points)
    : Cells(faces)
    , Domain(domain)
    , Points(points)
    , First(points.size() + 1, 0)
  {
    for (const Faces::Face& face : faces.Corners)
    {
      for (int c = 0; c < Faces::Size(face); ++c)
      {
        ++this->First[face[c] + 1];
      }
    }
    for (std::size_t v = 0; v < points.size(); ++v)
    {
      this->First[v + 1] += this->First[v];
    }
    this->FacesAt.resize(this->First.back());
    std::vector<Index> next(this->First.begin(), this->First.end() - 1);
    for (Index f = 0; f < static_cast<Index>(faces.Corners.size()); ++f)
    {
      for (int c = 0; c < Faces::Size(faces.Corners[f]); ++c)
      {
        this->FacesAt[next[faces.Corners[f][c]]++] = f;
      }
    }
  }

  void Step()
  {
    const std::vector<Vector3> old = this->Points;
    ParallelFor(static_cast<Index>(this->Points.size()), PieceSize,
      [&](Index begin, Index end)
      {
        for (Index v = begin; v < end; ++v)
        {
          if (this->Domain.Line[v] >= 0 && this->First[v + 1] > this->First[v])
          {
            this->Points[v] = this->Projected(v, 0.5 * (old[v] + this->Ideal(v, old)), old);
          }
        }
      });
  }

  void CarefulSweep()
  {
    for (Index v = 0; v < static_cast<Index>(this->Points.size()); ++v)
    {
      if (this->Domain.Line[v] < 0 || this->First[v + 1] == this->First[v])
      {
        continue;
      }
      const double before = this->LeastQuality(v);
      const Vector3 start = this->Points[v];
      this->Points[v] =
        this->Projected(v, 0.5 * (start + this->Ideal(v, this->Points)), this->Points);
      double now = this->LeastQuality(v);
      if (now < before && now < GoodEnough)
      {
        this->Points[v] = start;
        now = before;
      }
      if (now < Bad)
      {
        this->TryAround(v, now, 1.0);
      }
    }
  }

  /// Moves the vertices of bad faces, and returns whether that helped any of them.
  bool Rescue(int round)
  {
    bool hasHelped = false;
    for (Index v = 0; v < static_cast<Index>(this->Points.size()); ++v)
    {
      if (this->Domain.Line[v] >= 0 && this->First[v + 1] > this->First[v])
      {
        const double before = this->LeastQuality(v);
        if (before < Bad)
        {
          this->TryAround(v, before, std::pow(0.8, round));
          hasHelped = hasHelped || this->LeastQuality(v) > before;
        }
      }
    }
    return hasHelped;
  }

private:
  Vector3 NormalAt(Index v, const std::vector<Vector3>& points) const
  {
    Vector3 sum = Vector3::Zero();
    for (Index k = this->First[v]; k < this->First[v + 1]; ++k)
    {
      sum += this->AreaVector(this->Cells.Corners[this->FacesAt[k]], points);
    }
    return sum;
  }
  static Vector3 AreaVector(const Faces::Face& face, const std::vector<Vector3>& points)
  {
    const Vector3 u = points[face[2]] - points[face[0]];
    const Vector3 v =
      face[3] == None ? points[face[2]] - points[face[1]] : points[face[3]] - points[face[1]];
    return 0.5 * u.cross(face[3] == None ? Vector3(-(points[face[1]] - points[face[0]])) : v);
  }

  /// Where the faces at a vertex would have it.
  Vector3 Ideal(Index v, const std::vector<Vector3>& points) const
  {
    Vector3 sum = Vector3::Zero();
    for (Index k = this->First[v]; k < this->First[v + 1]; ++k)
    {
      const Faces::Face& face = this->Cells.Corners[this->FacesAt[k]];
      const int size = Faces::Size(face);
      Vector3 center = Vector3::Zero();
      double length = 0.0;
      for (int c = 0; c < size; ++c)
      {
        center += points[face[c]] / size;
        length += this->Domain.EdgeLength[face[c]] / size;
      }
      const Vector3 normal = this->AreaVector(face, points).normalized();
      Vector3 x = points[face[0]] - center;
      x -= normal * normal.dot(x);
      x.normalize();
      const Vector3 y = normal.cross(x);
      Complex best = 0.0;
      int own = 0;
      for (int c = 0; c < size; ++c)
      {
        const Vector3 p = points[face[c]] - center;
        best += Complex(p.dot(x), p.dot(y)) * std::polar(1.0 / size, -2.0 * Pi * c / size);
        own = face[c] == v ? c : own;
      }
      const double radius = length / (2.0 * std::sin(Pi / size));
      const double modulus = std::abs(best);
      best *= modulus > 0.0 ? 0.9 + 0.1 * std::min(radius / modulus, 2.0) : 0.0;
      const Complex z = best * std::polar(1.0, 2.0 * Pi * own / size);
      const Vector3 place = center + z.real() * x + z.imag() * y;
      sum += place.allFinite() ? place : points[v];
    }
    return sum / (this->First[v + 1] - this->First[v]);
  }

  Vector3 Projected(Index v, const Vector3& place, const std::vector<Vector3>& points) const
  {
    const double reach = 4.0 * this->Domain.EdgeLength[v];
    const Index line = this->Domain.Line[v];
    const ClosestPoints::Answer answer = line > 0
      ? this->Domain.Lines[line - 1].Find(place, Vector3::Zero(), reach)
      : this->Domain.Surface.Find(place, this->NormalAt(v, points), reach);
    return answer.Triangle != None ? answer.Position : points[v];
  }

  double LeastQuality(Index v) const
  {
    double least = 1.0;
    const Vector3 normal =
      this->Domain.Line[v] == 0 ? this->NormalAt(v, this->Points) : Vector3::Zero();
    for (Index k = this->First[v]; k < this->First[v + 1]; ++k)
    {
      const Faces::Face& face = this->Cells.Corners[this->FacesAt[k]];
      double quality = ScaledJacobian(this->Points, face);
      // A triangle has no side of its own to be folded to.
      if (face[3] == None && this->AreaVector(face, this->Points).dot(normal) < 0.0)
      {
        quality = -quality;
      }
      least = std::min(least, quality);
    }
    return least;
  }

  /// Takes the best of places on two circles.
  void TryAround(Index v, double quality, double size)
  {
    const Vector3 start = this->Points[v];
    const Vector3 normal = this->NormalAt(v, this->Points).normalized();
    Vector3 x = normal.unitOrthogonal();
    const Vector3 y = normal.cross(x);
    Vector3 best = start;
    for (int k = 0; k < 24; ++k)
    {
      const double radius = size * this->Domain.EdgeLength[v] * (k < 12 ? 0.1 : 0.25);
      const double angle = 2.0 * Pi * k / 12.0;
      const Vector3 place = start + radius * (std::cos(angle) * x + std::sin(angle) * y);
      this->Points[v] = start;
      this->Points[v] = this->Projected(v, place, this->Points);
      const double now = this->LeastQuality(v);
      if (now > quality)
      {
        quality = now;
        best = this->Points[v];
      }
    }
    this->Points[v] = best;
  }

  const Faces& Cells;
  const SmoothingDomain& Domain;
  std::vector<Vector3>& Points;
  std::vector<Index> First;
  std::vector<Index> FacesAt;
};
}

void SmoothFaces(const Faces& faces, const SmoothingDomain& domain, int steps,
  std::vector<Vector3>& points, const Progress& progress)
{
  if (steps == 0)
  {
    return;
  }
  Smoother smoother(faces, domain, points);
  for (int k = 0; k < steps; ++k)
  {
    smoother.Step();
    progress.Report(0.8 * (k + 1) / steps);
  }
  for (int k = 0; k < CarefulSweeps; ++k)
  {
    smoother.CarefulSweep();
    progress.Report(0.8 + 0.2 * (k + 1) / CarefulSweeps);
  }
  for (int k = 0; k < Rescues && smoother.Rescue(k); ++k)
  {
    progress.RequireToGoOn();
  }
}
}
