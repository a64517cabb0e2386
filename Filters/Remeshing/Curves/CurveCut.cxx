// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Curves/CurveCut.h"

#include "Curves/SplittableMesh.h"
#include "Distance/ClosestPoints.h"
#include "Mesh/MergePoints.h"
#include "Preparation/SurfaceUnit.h"
#include "Support/Sentences.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace DirectionFields::Internal
{
namespace
{
/// A curve takes a point, or an edge, that is closer than this part of an edge there.
constexpr double Close = 0.05;
/// Farther from the surface, in parts of its diagonal, curves do not belong to it.
constexpr double MostDistance = 0.01;

using Ends = std::array<Index, 2>;

Ends Sorted(Index p, Index q)
{
  return { std::min(p, q), std::max(p, q) };
}

double DiagonalOf(const Surface& surface)
{
  Vector3 least = Vector3::Constant(std::numeric_limits<double>::infinity());
  Vector3 most = -least;
  for (const Triangle& triangle : surface.Triangles)
  {
    for (const Index p : triangle)
    {
      if (p >= 0 && p < static_cast<Index>(surface.Points.size()) && surface.Points[p].allFinite())
      {
        least = least.cwiseMin(surface.Points[p]);
        most = most.cwiseMax(surface.Points[p]);
      }
    }
  }
  return least.x() <= most.x() ? (most - least).norm() : 0.0;
}

/// The surface without triangles that have a corner twice, which can be no part of a cut: their
/// corners become ids of no point, so that the others keep their numbers.
Surface WithoutCollapsed(const Surface& surface)
{
  Surface result = surface;
  for (Triangle& t : result.Triangles)
  {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
    {
      t = { None, None, None };
    }
  }
  return result;
}

class Cutter
{
public:
  explicit Cutter(const Surface& surface)
    : Mesh(surface)
    , Places(WithoutCollapsed(surface))
    , Limit(MostDistance * DiagonalOf(surface))
  {
  }

  /// Returns whether all of the curve is on the surface.
  bool Add(const std::vector<Vector3>& curve)
  {
    bool isWhole = true;
    Index last = None;
    for (std::size_t i = 0; i < curve.size(); ++i)
    {
      const Index next = this->Insert(curve[i]);
      const bool isStart = i == 0;
      if (!isStart)
      {
        isWhole = last != None && next != None && this->Join(last, next) && isWhole;
      }
      last = next;
    }
    return isWhole;
  }

  SplittableMesh Mesh;
  std::set<Ends> Hard;

private:
  const Vector3& PlaceOf(Index p) const { return this->Mesh.GetPoints()[p]; }

  Index SplitEdge(Index p, Index q, const Vector3& place)
  {
    const Index middle = this->Mesh.SplitEdge(p, q, place);
    if (this->Hard.erase(Sorted(p, q)) > 0)
    {
      this->Hard.insert(Sorted(p, middle));
      this->Hard.insert(Sorted(middle, q));
    }
    return middle;
  }

  /// The part of a triangle of the surface that a place is in; None where distances overflow.
  Index PartAt(Index parent, const Vector3& place, std::array<double, 3>& weights) const
  {
    Index best = None;
    double least = std::numeric_limits<double>::infinity();
    for (const Index t : this->Mesh.Parts(parent))
    {
      const Triangle& c = this->Mesh.GetTriangles()[t];
      const std::array<double, 3> own = ClosestPoints::ClosestWeights(
        place, { this->PlaceOf(c[0]), this->PlaceOf(c[1]), this->PlaceOf(c[2]) });
      const Vector3 at =
        own[0] * this->PlaceOf(c[0]) + own[1] * this->PlaceOf(c[1]) + own[2] * this->PlaceOf(c[2]);
      const double distance = (at - place).squaredNorm();
      if (distance < least)
      {
        least = distance;
        best = t;
        weights = own;
      }
    }
    return best;
  }

  /// The point of the surface at a place of a curve; None where it is too far.
  Index Insert(const Vector3& wanted)
  {
    const ClosestPoints::Answer answer = this->Places.Find(wanted, Vector3::Zero(), this->Limit);
    if (answer.Triangle == None)
    {
      return None;
    }
    std::array<double, 3> weights{};
    const Index t = this->PartAt(answer.Triangle, answer.Position, weights);
    if (t == None)
    {
      return None;
    }
    const Triangle corners = this->Mesh.GetTriangles()[t];
    double shortest = std::numeric_limits<double>::infinity();
    for (int c = 0; c < 3; ++c)
    {
      shortest = std::min(
        shortest, (this->PlaceOf(corners[c]) - this->PlaceOf(corners[(c + 1) % 3])).norm());
    }
    for (const Index p : corners)
    {
      if ((this->PlaceOf(p) - answer.Position).norm() <= Close * shortest)
      {
        return p;
      }
    }
    for (int c = 0; c < 3; ++c)
    {
      const Index p = corners[(c + 1) % 3];
      const Index q = corners[(c + 2) % 3];
      const Vector3 edge = this->PlaceOf(q) - this->PlaceOf(p);
      const double along =
        std::clamp(edge.dot(answer.Position - this->PlaceOf(p)) / edge.squaredNorm(), 0.0, 1.0);
      const Vector3 onEdge = this->PlaceOf(p) + along * edge;
      if ((onEdge - answer.Position).norm() <= Close * shortest)
      {
        return this->SplitEdge(p, q, onEdge);
      }
    }
    return this->Mesh.SplitInside(t, answer.Position);
  }

  /// Where a direction from a point leaves the triangles there.
  struct Exit
  {
    /// The ends of the edge across, and the part of it from the first to the second.
    Ends Edge{ None, None };
    double Part = 0.0;
  };
  Exit ExitFrom(Index point, const Vector3& direction) const
  {
    Exit exit;
    double most = 0.0;
    for (const Index t : this->Mesh.At(point))
    {
      const Triangle& corners = this->Mesh.GetTriangles()[t];
      const auto c = std::find(corners.begin(), corners.end(), point) - corners.begin();
      const Index u = corners[(c + 1) % 3];
      const Index v = corners[(c + 2) % 3];
      const Vector3 toU = this->PlaceOf(u) - this->PlaceOf(point);
      const Vector3 toV = this->PlaceOf(v) - this->PlaceOf(point);
      const Vector3 normal = toU.cross(toV).stableNormalized();
      const Vector3 ahead = direction - direction.dot(normal) * normal;
      const double fromU = normal.dot(toU.cross(ahead));
      const double fromV = normal.dot(ahead.cross(toV));
      // Both within a little: a direction along an edge is in one of its triangles at least.
      const double least = -1e-12 * (toU.norm() + toV.norm()) * ahead.norm();
      if (fromU >= least && fromV >= least && fromU + fromV > 0.0 && ahead.norm() > most &&
        ahead.dot(toU.stableNormalized() + toV.stableNormalized()) > 0.0)
      {
        most = ahead.norm();
        exit = { { u, v }, std::clamp(fromU / (fromU + fromV), 0.0, 1.0) };
      }
    }
    return exit;
  }

  /// Makes edges from one point to another. Returns whether it came there.
  bool Join(Index from, Index to)
  {
    const std::size_t most = 2 * this->Mesh.GetTriangles().size() + 16;
    for (std::size_t k = 0; k < most && from != to; ++k)
    {
      Index next = to;
      if (!this->Mesh.AreJoined(from, to))
      {
        next = this->Step(from, this->PlaceOf(to));
        if (next == None)
        {
          return false;
        }
      }
      this->Hard.insert(Sorted(from, next));
      from = next;
    }
    return from == to;
  }

  /// The next point on the way to a place; None where it comes no closer.
  Index Step(Index from, const Vector3& to)
  {
    const Vector3 way = to - this->PlaceOf(from);
    const Exit exit = this->ExitFrom(from, way);
    if (exit.Edge[0] == None)
    {
      return None;
    }
    const auto isCloser = [&](const Vector3& place) { return (to - place).norm() < way.norm(); };
    const Index nearer = exit.Edge[exit.Part < 0.5 ? 0 : 1];
    if (std::min(exit.Part, 1.0 - exit.Part) < Close && isCloser(this->PlaceOf(nearer)))
    {
      return nearer;
    }
    const Vector3 place =
      (1.0 - exit.Part) * this->PlaceOf(exit.Edge[0]) + exit.Part * this->PlaceOf(exit.Edge[1]);
    if (!isCloser(place))
    {
      return None;
    }
    return this->SplitEdge(exit.Edge[0], exit.Edge[1], place);
  }

  ClosestPoints Places;
  double Limit;
};
}

CurveCut CutAlong(const Surface& surface, const std::vector<std::vector<Vector3>>& curves)
{
  const MergedMesh merged = MergedMesh::AcrossSeams(surface);
  const std::vector<Index>& first = merged.FirstPoint;
  Cutter cutter(first.empty() ? surface : Merged(surface, first));
  CurveCut result;
  std::vector<std::size_t> left;
  for (std::size_t k = 0; k < curves.size(); ++k)
  {
    if (!cutter.Add(curves[k]))
    {
      left.push_back(k);
    }
  }
  if (!left.empty())
  {
    result.Notes.push_back("Parts of curve " + std::to_string(left.front()) +
      (left.size() > 1 ? " and of " + std::to_string(left.size() - 1) + " more" : "") +
      " are no lines of the mesh: they are farther from the surface than a hundredth of its "
      "diagonal, or the surface ends between two of their points. Curves have to lie on it.");
  }
  result.Cut.Points = cutter.Mesh.GetPoints();
  result.Cut.Triangles = cutter.Mesh.GetTriangles();
  for (std::size_t t = 0; t < result.Cut.Triangles.size(); ++t)
  {
    result.Parents.push_back(cutter.Mesh.Parent(static_cast<Index>(t)));
    if (!surface.Ghost.empty())
    {
      result.Cut.Ghost.push_back(surface.Ghost[result.Parents.back()]);
    }
  }
  result.Edges.assign(cutter.Hard.begin(), cutter.Hard.end());
  return result;
}
}
