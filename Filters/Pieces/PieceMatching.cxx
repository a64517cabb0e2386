// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "PieceMatching.h"

#include "PointGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace DirectionFields::Parallel
{
namespace
{
constexpr vtkIdType Nothing = -1;

/// Sets of numbers that are joined, each named by its least member.
class Joined
{
public:
  explicit Joined(std::size_t count)
    : Parent(count)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), vtkIdType(0));
  }

  vtkIdType Find(vtkIdType k)
  {
    while (this->Parent[k] != k)
    {
      this->Parent[k] = this->Parent[this->Parent[k]];
      k = this->Parent[k];
    }
    return k;
  }

  void Join(vtkIdType a, vtkIdType b)
  {
    a = this->Find(a);
    b = this->Find(b);
    this->Parent[std::max(a, b)] = std::min(a, b);
  }

private:
  std::vector<vtkIdType> Parent;
};

/// The points on the borders of pieces, by their places. Points of a place are the same one, but
/// that a piece may have several there.
struct BorderPlaces
{
  /// The points, place after place, ascending at each.
  std::vector<vtkIdType> Points;
  /// The points of place k are First[k] ... First[k + 1] - 1.
  std::vector<vtkIdType> First;

  vtkIdType Count() const { return static_cast<vtkIdType>(this->First.size()) - 1; }
};

const double* PlaceOf(const Pieces& pieces, vtkIdType point)
{
  return pieces.Coordinates.data() + 3 * point;
}

/// Points of equal ids or, without, of equal coordinates are at one place.
BorderPlaces FindPlaces(const Pieces& pieces)
{
  BorderPlaces border;
  std::vector<vtkIdType>& points = border.Points;
  points = pieces.BorderEdges;
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const auto key = [&](vtkIdType i)
  {
    const double* const x = PlaceOf(pieces, i);
    return pieces.GlobalIds.empty() ? std::make_tuple(vtkIdType(0), x[0], x[1], x[2])
                                    : std::make_tuple(pieces.GlobalIds[i], 0.0, 0.0, 0.0);
  };
  std::stable_sort(
    points.begin(), points.end(), [&](vtkIdType a, vtkIdType b) { return key(a) < key(b); });
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    if (k == 0 || key(points[k - 1]) != key(points[k]))
    {
      border.First.push_back(static_cast<vtkIdType>(k));
    }
  }
  border.First.push_back(static_cast<vtkIdType>(points.size()));
  return border;
}

/// Joins places within the tolerance, the nearest first, as long as no piece has a point at both:
/// rounding does not give one process two points for one.
/// @return the pairs of places that stay apart
std::vector<std::pair<vtkIdType, vtkIdType>> JoinNearPlaces(
  const Pieces& pieces, const BorderPlaces& border, double tolerance, Joined& places)
{
  std::vector<double> coordinates;
  std::vector<std::vector<std::size_t>> owners;
  for (vtkIdType k = 0; k < border.Count(); ++k)
  {
    const double* const x = PlaceOf(pieces, border.Points[border.First[k]]);
    coordinates.insert(coordinates.end(), x, x + 3);
  }
  const PointGrid grid(coordinates, tolerance);
  std::vector<std::tuple<double, vtkIdType, vtkIdType>> pairs;
  for (vtkIdType k = 0; k < border.Count(); ++k)
  {
    grid.ForEachNear(coordinates.data() + 3 * k,
      [&](vtkIdType other, double squared)
      {
        if (other > k)
        {
          pairs.emplace_back(squared, k, other);
        }
      });
  }
  if (pairs.empty())
  {
    return {};
  }
  std::sort(pairs.begin(), pairs.end());
  owners.resize(static_cast<std::size_t>(border.Count()));
  for (vtkIdType k = 0; k < border.Count(); ++k)
  {
    for (vtkIdType m = border.First[k]; m < border.First[k + 1]; ++m)
    {
      owners[k].push_back(pieces.PieceOf(border.Points[m]));
    }
    // The points ascend, hence their pieces.
  }
  std::vector<std::pair<vtkIdType, vtkIdType>> apart;
  for (const auto& [squared, a, b] : pairs)
  {
    const std::vector<std::size_t>& first = owners[places.Find(a)];
    const std::vector<std::size_t>& second = owners[places.Find(b)];
    std::vector<std::size_t> both;
    std::set_intersection(
      first.begin(), first.end(), second.begin(), second.end(), std::back_inserter(both));
    if (places.Find(a) == places.Find(b))
    {
      continue;
    }
    if (!both.empty())
    {
      apart.emplace_back(a, b);
      continue;
    }
    std::vector<std::size_t> all;
    std::merge(first.begin(), first.end(), second.begin(), second.end(), std::back_inserter(all));
    places.Join(a, b);
    owners[places.Find(a)] = std::move(all);
  }
  return apart;
}

/// For each point on the border its place.
std::unordered_map<vtkIdType, vtkIdType> PlacesOf(const BorderPlaces& border)
{
  std::unordered_map<vtkIdType, vtkIdType> placeOf;
  for (vtkIdType k = 0; k < border.Count(); ++k)
  {
    for (vtkIdType m = border.First[k]; m < border.First[k + 1]; ++m)
    {
      placeOf[border.Points[m]] = k;
    }
  }
  return placeOf;
}

/// Lets places that stay apart become equal, but for the two ends of an edge, which would vanish.
void MoveTogether(const Pieces& pieces, const BorderPlaces& border,
  const std::vector<std::pair<vtkIdType, vtkIdType>>& apart, JoinedPoints& joined)
{
  if (apart.empty())
  {
    return;
  }
  std::unordered_map<vtkIdType, vtkIdType> placeOf = PlacesOf(border);
  std::vector<std::pair<vtkIdType, vtkIdType>> edges;
  for (std::size_t e = 0; e + 1 < pieces.BorderEdges.size(); e += 2)
  {
    edges.emplace_back(
      std::minmax({ placeOf[pieces.BorderEdges[e]], placeOf[pieces.BorderEdges[e + 1]] }));
  }
  std::sort(edges.begin(), edges.end());
  Joined together(static_cast<std::size_t>(border.Count()));
  for (const auto& pair : apart)
  {
    if (!std::binary_search(edges.begin(), edges.end(), pair))
    {
      together.Join(pair.first, pair.second);
    }
  }
  for (vtkIdType k = 0; k < border.Count(); ++k)
  {
    const vtkIdType to = together.Find(k);
    for (vtkIdType m = border.First[k]; to != k && m < border.First[k + 1]; ++m)
    {
      joined.Moved.emplace_back(border.Points[m], border.Points[border.First[to]]);
    }
  }
}

/// The points of joined places.
BorderPlaces Merged(const BorderPlaces& border, Joined& places)
{
  std::vector<std::pair<vtkIdType, vtkIdType>> entries;
  for (vtkIdType k = 0; k < border.Count(); ++k)
  {
    for (vtkIdType m = border.First[k]; m < border.First[k + 1]; ++m)
    {
      entries.emplace_back(places.Find(k), border.Points[m]);
    }
  }
  std::sort(entries.begin(), entries.end());
  BorderPlaces merged;
  for (const auto& [place, point] : entries)
  {
    if (merged.Points.empty() || place != entries[merged.Points.size() - 1].first)
    {
      merged.First.push_back(static_cast<vtkIdType>(merged.Points.size()));
    }
    merged.Points.push_back(point);
  }
  merged.First.push_back(static_cast<vtkIdType>(merged.Points.size()));
  return merged;
}

/// Joins the points of each place where all belong to different pieces, and says at which places
/// they do not.
std::vector<char> JoinSinglePoints(const Pieces& pieces, const BorderPlaces& border, Joined& points)
{
  std::vector<char> isAmbiguous(static_cast<std::size_t>(border.Count()), 0);
  for (vtkIdType k = 0; k < border.Count(); ++k)
  {
    for (vtkIdType m = border.First[k]; m + 1 < border.First[k + 1]; ++m)
    {
      if (pieces.PieceOf(border.Points[m]) == pieces.PieceOf(border.Points[m + 1]))
      {
        isAmbiguous[k] = 1;
      }
    }
    for (vtkIdType m = border.First[k]; !isAmbiguous[k] && m + 1 < border.First[k + 1]; ++m)
    {
      points.Join(border.Points[m], border.Points[m + 1]);
    }
  }
  return isAmbiguous;
}

/// Where a piece has several points at a place, the edges tell which of another piece's is which:
/// the two that run between the same places are one edge.
void JoinByEdges(const Pieces& pieces, const BorderPlaces& border,
  const std::vector<char>& isAmbiguous, Joined& points)
{
  std::unordered_map<vtkIdType, vtkIdType> placeOf = PlacesOf(border);
  // The places of an edge, and the points there in the same order.
  std::vector<std::array<vtkIdType, 4>> edges;
  for (std::size_t e = 0; e + 1 < pieces.BorderEdges.size(); e += 2)
  {
    vtkIdType a = pieces.BorderEdges[e];
    vtkIdType b = pieces.BorderEdges[e + 1];
    if (placeOf[b] < placeOf[a])
    {
      std::swap(a, b);
    }
    if (placeOf[a] != placeOf[b] && (isAmbiguous[placeOf[a]] || isAmbiguous[placeOf[b]]))
    {
      edges.push_back({ placeOf[a], placeOf[b], a, b });
    }
  }
  std::sort(edges.begin(), edges.end());
  const auto sameEdge = [&](std::size_t e, std::size_t f)
  { return f < edges.size() && edges[e][0] == edges[f][0] && edges[e][1] == edges[f][1]; };
  for (std::size_t e = 0; e < edges.size();)
  {
    std::size_t end = e + 1;
    while (sameEdge(e, end))
    {
      ++end;
    }
    if (end - e == 2 && pieces.PieceOf(edges[e][2]) != pieces.PieceOf(edges[e + 1][2]))
    {
      points.Join(edges[e][2], edges[e + 1][2]);
      points.Join(edges[e][3], edges[e + 1][3]);
    }
    e = end;
  }
}

/// For each wanted point one of another piece's points with its id; several pieces may have it.
std::vector<vtkIdType> FindIds(
  const Pieces& pieces, const WantedPoints& wanted, const std::vector<vtkIdType>& notOf)
{
  std::unordered_map<vtkIdType, std::vector<std::size_t>> wantedBy;
  for (std::size_t k = 0; k < wanted.GlobalIds.size(); ++k)
  {
    wantedBy[wanted.GlobalIds[k]].push_back(k);
  }
  std::vector<vtkIdType> found(wanted.GlobalIds.size(), Nothing);
  std::size_t piece = 0;
  for (vtkIdType i = 0; !wantedBy.empty() && i < pieces.FirstPoint.back(); ++i)
  {
    while (i >= pieces.FirstPoint[piece + 1])
    {
      ++piece;
    }
    const auto there = wantedBy.find(pieces.GlobalIds[i]);
    if (there == wantedBy.end())
    {
      continue;
    }
    for (const std::size_t k : there->second)
    {
      if (found[k] == Nothing && (notOf.empty() || notOf[k] != static_cast<vtkIdType>(piece)))
      {
        found[k] = i;
      }
    }
  }
  return found;
}

/// The same by places, the nearest one.
std::vector<vtkIdType> FindPlaces(const Pieces& pieces, const WantedPoints& wanted,
  const std::vector<vtkIdType>& notOf, double tolerance)
{
  const std::size_t count = wanted.Coordinates.size() / 3;
  std::vector<vtkIdType> found(count, Nothing);
  if (count == 0)
  {
    return found;
  }
  std::vector<double> distance(count, std::numeric_limits<double>::max());
  const PointGrid grid(wanted.Coordinates, tolerance);
  std::size_t piece = 0;
  for (vtkIdType i = 0; i < pieces.FirstPoint.back(); ++i)
  {
    while (i >= pieces.FirstPoint[piece + 1])
    {
      ++piece;
    }
    grid.ForEachNear(PlaceOf(pieces, i),
      [&](vtkIdType k, double squared)
      {
        if (squared < distance[k] && (notOf.empty() || notOf[k] != static_cast<vtkIdType>(piece)))
        {
          distance[k] = squared;
          found[k] = i;
        }
      });
  }
  return found;
}

/// A sheet may end inside of another piece, where three sheets meet in an edge: there the other
/// piece's points are on no border.
void JoinPointsInside(
  const Pieces& pieces, const BorderPlaces& border, double tolerance, Joined& points)
{
  WantedPoints wanted;
  std::vector<vtkIdType> wantedPoints;
  std::vector<vtkIdType> owners;
  for (vtkIdType k = 0; k < border.Count(); ++k)
  {
    if (border.First[k + 1] - border.First[k] == 1)
    {
      const vtkIdType point = border.Points[border.First[k]];
      const double* const x = PlaceOf(pieces, point);
      wanted.Coordinates.insert(wanted.Coordinates.end(), x, x + 3);
      if (!pieces.GlobalIds.empty())
      {
        wanted.GlobalIds.push_back(pieces.GlobalIds[point]);
      }
      wantedPoints.push_back(point);
      owners.push_back(static_cast<vtkIdType>(pieces.PieceOf(point)));
    }
  }
  const std::vector<vtkIdType> found = pieces.GlobalIds.empty()
    ? FindPlaces(pieces, wanted, owners, tolerance)
    : FindIds(pieces, wanted, owners);
  for (std::size_t k = 0; k < found.size(); ++k)
  {
    if (found[k] != Nothing)
    {
      points.Join(wantedPoints[k], found[k]);
    }
  }
}
}

std::size_t Pieces::PieceOf(vtkIdType point) const
{
  return static_cast<std::size_t>(
           std::upper_bound(this->FirstPoint.begin(), this->FirstPoint.end(), point) -
           this->FirstPoint.begin()) -
    1;
}

bool AreGlobalIdsRight(const Pieces& pieces, double tolerance)
{
  if (pieces.GlobalIds.empty())
  {
    return false;
  }
  const BorderPlaces border = FindPlaces(pieces);
  for (vtkIdType k = 0; k < border.Count(); ++k)
  {
    const double* const x = PlaceOf(pieces, border.Points[border.First[k]]);
    for (vtkIdType m = border.First[k] + 1; m < border.First[k + 1]; ++m)
    {
      const double* const y = PlaceOf(pieces, border.Points[m]);
      for (int c = 0; c < 3; ++c)
      {
        if (std::abs(x[c] - y[c]) > tolerance)
        {
          return false;
        }
      }
    }
  }
  return true;
}

JoinedPoints JoinPieces(const Pieces& pieces, double tolerance)
{
  JoinedPoints joined;
  BorderPlaces border = FindPlaces(pieces);
  if (pieces.GlobalIds.empty())
  {
    Joined places(static_cast<std::size_t>(border.Count()));
    MoveTogether(pieces, border, JoinNearPlaces(pieces, border, tolerance, places), joined);
    border = Merged(border, places);
  }
  Joined points(static_cast<std::size_t>(pieces.FirstPoint.back()));
  const std::vector<char> isAmbiguous = JoinSinglePoints(pieces, border, points);
  if (std::find(isAmbiguous.begin(), isAmbiguous.end(), 1) != isAmbiguous.end())
  {
    JoinByEdges(pieces, border, isAmbiguous, points);
  }
  JoinPointsInside(pieces, border, tolerance, points);

  joined.Number.resize(static_cast<std::size_t>(pieces.FirstPoint.back()));
  std::vector<char> isShared(joined.Number.size(), 0);
  for (vtkIdType i = 0; i < pieces.FirstPoint.back(); ++i)
  {
    const vtkIdType first = points.Find(i);
    joined.Number[i] = first == i ? joined.Count++ : joined.Number[first];
    joined.Shared += first != i && isShared[first] == 0;
    isShared[first] = first != i ? 1 : isShared[first];
  }
  return joined;
}

std::vector<vtkIdType> FindPoints(
  const Pieces& pieces, const WantedPoints& wanted, double tolerance)
{
  return pieces.GlobalIds.empty() || wanted.GlobalIds.empty()
    ? FindPlaces(pieces, wanted, {}, tolerance)
    : FindIds(pieces, wanted, {});
}
}
