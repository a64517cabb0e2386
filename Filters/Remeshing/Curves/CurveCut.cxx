// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Curves/CurveCut.h"

#include "Curves/CoarseFirst.h"
#include "Curves/CurvePoints.h"
#include "Curves/CurveSentences.h"
#include "Curves/PartRefinement.h"
#include "Curves/SplittableMesh.h"
#include "Distance/ClosestPoints.h"
#include "Mesh/MergePoints.h"
#include "Preparation/SurfaceUnit.h"
#include "Support/MortonCurve.h"
#include "Support/SortedEnds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace DirectionFields::Internal
{
namespace
{
/// A curve takes a point, or an edge, that is closer than this part of an edge there.
constexpr double Close = 0.05;
/// And closer than this part of the way to the curve's points before and after: lines through many
/// points in one triangle would run in zigzags.
constexpr double CloseOnWay = 0.25;
/// Between two of its points it is straight: it takes points only at an offset of up to this part
/// of the step there, which turns it by 6 degrees at most, or of this part of an edge, where cuts
/// would leave needles.
constexpr double CloseOnStep = 0.1;
constexpr double SamePlace = 1e-3;
/// Points of a curve that are closer, in parts of the surface's diagonal, are one.
constexpr double SamePoint = 1e-5;
/// A given point takes what is closer than this part of an edge: vertices of the mesh get their own
/// places in the end.
constexpr double CloseToPoint = 0.01;
/// Of up to this number of parts of a triangle the closest one is found by looking at all.
constexpr std::size_t FewParts = 16;
/// How many steps are made before it is asked whether to go on.
constexpr int StepsBetweenAsking = 256;
/// Farther from the surface, in parts of its diagonal, curves do not belong to it.
constexpr double MostDistance = 0.01;

using Ends = std::array<Index, 2>;

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
  Cutter(const Surface& surface, const Progress& progress)
    : Mesh(surface)
    , Asked(progress)
    , Places(WithoutCollapsed(surface))
    , Limit(MostDistance * Extent(surface))
  {
  }

  /// The point of the surface for a place, and its own place there; None where it is too far.
  Index AddPoint(const Vector3& wanted, Vector3& place)
  {
    return this->Insert(wanted, CloseToPoint, std::numeric_limits<double>::infinity(), &place);
  }

  /// Returns whether all of the curve is on the surface.
  bool Add(Index number, const std::vector<Vector3>& given)
  {
    const double least = SamePoint / MostDistance * this->Limit;
    const std::vector<Vector3> curve = Apart(given, least);
    this->Curve = number;
    std::vector<Index> points(curve.size(), None);
    for (const std::size_t i : CoarseFirst(curve.size()))
    {
      points[i] = this->Insert(curve[i], Close, std::max(CloseOnWay * RoomAt(curve, i), least));
    }
    bool isWhole = points.empty() || points[0] != None;
    for (std::size_t i = 1; i < points.size(); ++i)
    {
      isWhole = points[i - 1] != None && points[i] != None &&
        this->Join(points[i - 1], points[i]) && isWhole;
    }
    return isWhole;
  }

  void Refine()
  {
    RefineParts(this->Mesh,
      { [this](Index a, Index b) { return this->Hard.count(SortedEnds(a, b)) > 0; },
        [this](Index a, Index b, const Vector3& place)
        {
          this->Ask();
          return this->SplitEdge(a, b, place);
        } });
  }

  SplittableMesh Mesh;
  /// The curve of each edge on curves.
  std::map<Ends, Index> Hard;

private:
  void Ask()
  {
    if (++this->Steps % StepsBetweenAsking == 0)
    {
      this->Asked.RequireToGoOn();
    }
  }

  const Vector3& PlaceOf(Index p) const { return this->Mesh.GetPoints()[p]; }

  Index SplitEdge(Index p, Index q, const Vector3& place)
  {
    const Index middle = this->Mesh.SplitEdge(p, q, place);
    const auto hard = this->Hard.find(SortedEnds(p, q));
    if (hard != this->Hard.end())
    {
      this->Hard.emplace(SortedEnds(p, middle), hard->second);
      this->Hard.emplace(SortedEnds(middle, q), hard->second);
      this->Hard.erase(SortedEnds(p, q));
    }
    return this->WithoutSlivers(middle);
  }

  /// A point that was put in, after the edges around have been turned; those along curves stay.
  Index WithoutSlivers(Index p)
  {
    this->Mesh.TurnEdges(
      p, [this](Index a, Index b) { return this->Hard.count(SortedEnds(a, b)) > 0; });
    return p;
  }

  /// The corner of a triangle across from which a place lies outside, the farthest if there are
  /// several; 3 if it is inside, None for a triangle without area.
  Index OutsideOf(Index t, const Vector3& place) const
  {
    constexpr double rounding = 1e-12;
    const Triangle& c = this->Mesh.GetTriangles()[t];
    const Vector3& a = this->PlaceOf(c[0]);
    const Vector3 normal = (this->PlaceOf(c[1]) - a).cross(this->PlaceOf(c[2]) - a);
    const double whole = normal.squaredNorm();
    double least = -rounding * whole;
    Index outside = whole > 0.0 ? 3 : None;
    for (Index k = 0; k < 3 && outside != None; ++k)
    {
      const Vector3& from = this->PlaceOf(c[(k + 1) % 3]);
      const Vector3 edge = this->PlaceOf(c[(k + 2) % 3]) - from;
      const double part = normal.dot(edge.cross(place - from));
      outside = part < least ? k : outside;
      least = std::min(least, part);
    }
    return outside;
  }

  /// The part of a triangle that a place is in, by a walk from the part where the last one was;
  /// None where it comes to no end.
  Index WalkTo(Index parent, const Vector3& place)
  {
    Index t = this->LastPart.emplace(parent, parent).first->second;
    for (std::size_t k = this->Mesh.Parts(parent).size(); k > 0; --k)
    {
      this->Ask();
      const Index outside = this->OutsideOf(t, place);
      if (outside == 3 || outside == None)
      {
        return outside == 3 ? t : None;
      }
      const Triangle& c = this->Mesh.GetTriangles()[t];
      const std::vector<Index> there =
        this->Mesh.Between(c[(outside + 1) % 3], c[(outside + 2) % 3]);
      const auto next = std::find_if(there.begin(), there.end(),
        [&](Index other) { return other != t && this->Mesh.Parent(other) == parent; });
      if (next == there.end())
      {
        return None;
      }
      t = *next;
    }
    return None;
  }

  /// The part of a triangle of the surface that a place is in; None where distances overflow.
  Index PartAt(Index parent, const Vector3& place)
  {
    Index part = None;
    if (this->Mesh.Parts(parent).size() > FewParts)
    {
      part = this->WalkTo(parent, place);
    }
    if (part == None)
    {
      part = this->ClosestPart(parent, place);
    }
    if (part != None)
    {
      this->LastPart[parent] = part;
    }
    return part;
  }
  Index ClosestPart(Index parent, const Vector3& place) const
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
      }
    }
    return best;
  }

  /// The point of the surface at a place of a curve; None where it is too far.
  /// @param close points and edges closer than this part of an edge are taken
  /// @param room  and closer than this
  /// @param place gets the place on the surface
  Index Insert(const Vector3& wanted, double close, double room, Vector3* place = nullptr)
  {
    this->Ask();
    const ClosestPoints::Answer answer = this->Places.Find(wanted, Vector3::Zero(), this->Limit);
    if (answer.Triangle == None)
    {
      return None;
    }
    const Index t = this->PartAt(answer.Triangle, answer.Position);
    if (t == None)
    {
      return None;
    }
    if (place)
    {
      *place = answer.Position;
    }
    const Triangle corners = this->Mesh.GetTriangles()[t];
    double shortest = std::numeric_limits<double>::infinity();
    for (int c = 0; c < 3; ++c)
    {
      shortest = std::min(
        shortest, (this->PlaceOf(corners[c]) - this->PlaceOf(corners[(c + 1) % 3])).norm());
    }
    const double within = std::min(close * shortest, room);
    for (const Index p : corners)
    {
      if ((this->PlaceOf(p) - answer.Position).norm() <= within)
      {
        return p;
      }
    }
    // The closest edge: points along an edge of the surface are to be on that one, and not on those
    // of its parts beside it, from where others would go on.
    double least = within;
    std::size_t closest = 3;
    std::array<Vector3, 3> onEdge;
    for (std::size_t c = 0; c < 3; ++c)
    {
      const Vector3& from = this->PlaceOf(corners[(c + 1) % 3]);
      const Vector3 edge = this->PlaceOf(corners[(c + 2) % 3]) - from;
      const double along =
        std::clamp(edge.dot(answer.Position - from) / edge.squaredNorm(), 0.0, 1.0);
      onEdge[c] = from + along * edge;
      const double distance = (onEdge[c] - answer.Position).norm();
      if (distance <= least)
      {
        least = distance;
        closest = c;
      }
    }
    if (closest < 3)
    {
      return this->SplitEdge(
        corners[(closest + 1) % 3], corners[(closest + 2) % 3], onEdge[closest]);
    }
    const Index p = this->WithoutSlivers(this->Mesh.SplitInside(t, answer.Position));
    this->LastPart[answer.Triangle] = this->Mesh.FirstAt(p);
    return p;
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
    Vector3 strayed = Vector3::Zero();
    for (std::size_t k = 0; k < most && from != to; ++k)
    {
      this->Ask();
      Index next = to;
      if (!this->Mesh.AreJoined(from, to))
      {
        next = this->Step(from, this->PlaceOf(to), strayed);
        if (next == None)
        {
          return false;
        }
      }
      this->Hard.emplace(SortedEnds(from, next), this->Curve);
      from = next;
    }
    return from == to;
  }

  /// The next point on the way to a place; None where it comes no closer.
  /// @param strayed how far the points that the way has taken are from the straight one
  Index Step(Index from, const Vector3& to, Vector3& strayed)
  {
    const Vector3 way = to - this->PlaceOf(from);
    const Exit exit = this->ExitFrom(from, way);
    if (exit.Edge[0] == None)
    {
      return None;
    }
    const auto isCloser = [&](const Vector3& place) { return (to - place).norm() < way.norm(); };
    const Vector3 edge = this->PlaceOf(exit.Edge[1]) - this->PlaceOf(exit.Edge[0]);
    const Vector3 place = this->PlaceOf(exit.Edge[0]) + exit.Part * edge;
    const Index nearer = exit.Edge[exit.Part < 0.5 ? 0 : 1];
    const Vector3 offset = this->PlaceOf(nearer) - place;
    // From a point off the straight way the rest leads back to it.
    const Vector3 rest = std::min((to - place).norm() / way.norm(), 1.0) * strayed;
    const bool isStraight =
      (rest + offset).norm() < std::max(strayed.norm(), Close * edge.norm()) &&
      offset.norm() < CloseOnStep * (place - this->PlaceOf(from)).norm();
    if ((isStraight || offset.norm() < SamePlace * edge.norm()) && isCloser(this->PlaceOf(nearer)))
    {
      strayed = rest + offset;
      return nearer;
    }
    strayed = rest;
    return isCloser(place) ? this->SplitEdge(exit.Edge[0], exit.Edge[1], place) : None;
  }

  const Progress& Asked;
  int Steps = 0;
  Index Curve = None;
  ClosestPoints Places;
  double Limit;
  /// Where the last place in each triangle was.
  std::map<Index, Index> LastPart;
};

void AddPoints(const std::vector<Vector3>& points, Cutter& cutter, CurveCut& result)
{
  // Along a curve through all of them the next one is close to the last one.
  std::vector<Index> finite;
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    if (points[k].allFinite())
    {
      finite.push_back(static_cast<Index>(k));
    }
  }
  LargeArray<Index> members(finite.size());
  std::copy(finite.begin(), finite.end(), members.begin());
  result.Places = points;
  result.Points.assign(points.size(), None);
  const LargeArray<Index> sorted = MortonCurve::Sorted(points, members);
  for (const std::size_t i : CoarseFirst(sorted.size()))
  {
    const Index k = sorted[i];
    result.Points[k] = cutter.AddPoint(points[k], result.Places[k]);
  }
  std::vector<Index> left;
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    if (result.Points[k] == None)
    {
      left.push_back(static_cast<Index>(k));
    }
  }
  if (!left.empty())
  {
    result.Notes.push_back(AboutFarPoints(left));
  }
}
}

CurveCut CutAlong(const Surface& surface, const GivenLines& given, const Progress& progress)
{
  const MergedMesh merged = MergedMesh::AcrossSeams(surface);
  const std::vector<Index>& first = merged.FirstPoint;
  Cutter cutter(first.empty() ? surface : Merged(surface, first), progress);
  CurveCut result;
  AddPoints(given.Points, cutter, result);
  std::vector<Index> left;
  std::vector<Index> dots;
  for (std::size_t k = 0; k < given.Curves.size(); ++k)
  {
    if (IsDot(given.Curves[k]))
    {
      dots.push_back(static_cast<Index>(k));
    }
    else if (!cutter.Add(static_cast<Index>(k), given.Curves[k]))
    {
      left.push_back(static_cast<Index>(k));
    }
  }
  if (!left.empty())
  {
    result.Notes.push_back(AboutFarCurves(left));
  }
  if (!dots.empty())
  {
    result.Notes.push_back(AboutDots(dots));
  }
  cutter.Refine();
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
  for (const auto& [ends, curve] : cutter.Hard)
  {
    result.Edges.push_back(ends);
    result.CurveOf.push_back(curve);
  }
  return result;
}
}
