// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/SharedPoints.h"

#include "PieceMatching.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

namespace DirectionFields::Parallel
{
namespace
{
/// Most points on borders, in parts of all points: a surface of which more is border is best
/// gathered.
constexpr double MostBorder = 0.5;
/// Fewer points than this may all lie on borders.
constexpr double FewPoints = 100000.0;

/// The borders of all pieces, known to every process.
struct Borders
{
  Pieces All;
  /// For each point of All its number among the own points of its process.
  std::vector<vtkIdType> OwnPoint;
  double Tolerance = 0.0;
};

std::vector<vtkIdType> BorderPoints(const SurfacePiece& piece)
{
  std::vector<vtkIdType> points = piece.BorderEdges;
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

double LargestCoordinate(const SurfacePiece& piece)
{
  double largest = 0.0;
  for (const std::vector<double>* const values :
    { &piece.Own.Coordinates, &piece.GhostPoints.Coordinates })
  {
    for (const double value : *values)
    {
      largest = std::max(largest, std::abs(value));
    }
  }
  return largest;
}

/// Brings the borders of all pieces to all processes.
Borders GatherBorders(Processes& processes, const Messages& messages, const SurfacePiece& piece,
  const std::vector<vtkIdType>& own)
{
  std::vector<double> places;
  std::vector<vtkIdType> ids;
  std::vector<vtkIdType> edges;
  processes.Together(
    [&]
    {
      for (const vtkIdType point : own)
      {
        const double* const x = piece.Own.Coordinates.data() + 3 * point;
        places.insert(places.end(), x, x + 3);
        if (!piece.Own.GlobalIds.empty())
        {
          ids.push_back(piece.Own.GlobalIds[point]);
        }
      }
      for (const vtkIdType point : piece.BorderEdges)
      {
        edges.push_back(std::lower_bound(own.begin(), own.end(), point) - own.begin());
      }
    });
  Borders borders;
  borders.Tolerance = MatchingTolerance * messages.Largest(LargestCoordinate(piece));
  const bool lacksIds = messages.Any(piece.HasPoints && !piece.HasGlobalIds);
  auto allPlaces = messages.AllGather(places);
  auto allPoints = messages.AllGather(own);
  auto allEdges = messages.AllGather(edges);
  processes.Together(
    [&]
    {
      borders.All.FirstPoint.assign(allPoints.First.begin(), allPoints.First.end());
      borders.All.Coordinates = std::move(allPlaces.Values);
      borders.OwnPoint = std::move(allPoints.Values);
      for (std::size_t p = 0; p + 1 < allEdges.First.size(); ++p)
      {
        for (int k = allEdges.First[p]; k < allEdges.First[p + 1]; ++k)
        {
          borders.All.BorderEdges.push_back(
            allEdges.Values[static_cast<std::size_t>(k)] + borders.All.FirstPoint[p]);
        }
      }
    });
  if (!lacksIds)
  {
    borders.All.GlobalIds = messages.AllGather(ids).Values;
    processes.Together(
      [&]
      {
        if (!AreGlobalIdsRight(borders.All, borders.Tolerance))
        {
          borders.All.GlobalIds.clear();
        }
      });
  }
  return borders;
}

/// Whether a point on another piece's border lies on a point inside of this one.
bool HasPointsInside(const Borders& borders, const std::vector<char>& isJoined,
  const SurfacePiece& piece, const std::vector<vtkIdType>& own, int process)
{
  Pieces inside;
  vtkIdType count = 0;
  std::size_t next = 0;
  for (std::size_t i = 0; i < piece.Own.Points.size(); ++i)
  {
    if (next < own.size() && own[next] == static_cast<vtkIdType>(i))
    {
      ++next;
      continue;
    }
    const double* const x = piece.Own.Coordinates.data() + 3 * i;
    inside.Coordinates.insert(inside.Coordinates.end(), x, x + 3);
    if (!borders.All.GlobalIds.empty())
    {
      inside.GlobalIds.push_back(piece.Own.GlobalIds[i]);
    }
    ++count;
  }
  inside.FirstPoint = { 0, count };
  WantedPoints wanted;
  for (std::size_t k = 0; k < borders.OwnPoint.size(); ++k)
  {
    if (!isJoined[k] && static_cast<int>(borders.All.PieceOf(static_cast<vtkIdType>(k))) != process)
    {
      const double* const x = borders.All.Coordinates.data() + 3 * k;
      wanted.Coordinates.insert(wanted.Coordinates.end(), x, x + 3);
      if (!borders.All.GlobalIds.empty())
      {
        wanted.GlobalIds.push_back(borders.All.GlobalIds[k]);
      }
    }
  }
  const std::vector<vtkIdType> found = FindPoints(inside, wanted, borders.Tolerance);
  return std::any_of(found.begin(), found.end(), [](vtkIdType point) { return point >= 0; });
}

/// Whether different points on the boundary of the whole surface have equal places: a seam may run
/// there.
bool HasCoincidentBoundary(const Borders& borders, const JoinedPoints& joined)
{
  std::map<std::pair<vtkIdType, vtkIdType>, int> uses;
  const std::vector<vtkIdType>& edges = borders.All.BorderEdges;
  for (std::size_t e = 0; e + 1 < edges.size(); e += 2)
  {
    ++uses[std::minmax({ joined.Number[edges[e]], joined.Number[edges[e + 1]] })];
  }
  std::set<vtkIdType> boundary;
  for (const auto& [edge, count] : uses)
  {
    if (count == 1)
    {
      boundary.insert({ edge.first, edge.second });
    }
  }
  std::map<std::array<double, 3>, vtkIdType> at;
  for (std::size_t k = 0; k < joined.Number.size(); ++k)
  {
    if (boundary.count(joined.Number[k]) > 0)
    {
      const double* const x = borders.All.Coordinates.data() + 3 * k;
      const auto [entry, isNew] =
        at.try_emplace(std::array<double, 3>{ x[0], x[1], x[2] }, joined.Number[k]);
      if (!isNew && entry->second != joined.Number[k])
      {
        return true;
      }
    }
  }
  return false;
}

/// Fills in the numbers, the places and who else has a point.
void Number(const Borders& borders, const JoinedPoints& joined, const SurfacePiece& piece,
  const std::vector<vtkIdType>& own, int process, SharedPoints& shared)
{
  shared.Coordinates = piece.Own.Coordinates;
  shared.Number.resize(piece.Own.Points.size());
  for (std::size_t i = 0; i < shared.Number.size(); ++i)
  {
    shared.Number[i] = shared.FirstNumber[process] + static_cast<vtkIdType>(i);
  }
  // Points of the borders by their joined numbers, in the order of the processes.
  std::vector<std::vector<vtkIdType>> members(static_cast<std::size_t>(joined.Count));
  for (std::size_t k = 0; k < joined.Number.size(); ++k)
  {
    members[joined.Number[k]].push_back(static_cast<vtkIdType>(k));
  }
  for (std::size_t k = 0; k < joined.Number.size(); ++k)
  {
    const vtkIdType first = members[joined.Number[k]].front();
    const auto owner = static_cast<int>(borders.All.PieceOf(first));
    shared.BorderProcess.push_back(
      static_cast<int>(borders.All.PieceOf(static_cast<vtkIdType>(k))));
    shared.BorderNumber.push_back(shared.FirstNumber[owner] + borders.OwnPoint[first]);
  }
  const vtkIdType begin = borders.All.FirstPoint[process];
  for (std::size_t k = 0; k < own.size(); ++k)
  {
    const vtkIdType at = begin + static_cast<vtkIdType>(k);
    const std::vector<vtkIdType>& same = members[joined.Number[at]];
    if (same.size() < 2)
    {
      continue;
    }
    shared.Number[own[k]] = shared.BorderNumber[at];
    std::copy_n(
      borders.All.Coordinates.data() + 3 * same.front(), 3, shared.Coordinates.data() + 3 * own[k]);
    for (const vtkIdType other : same)
    {
      if (shared.BorderProcess[other] != process)
      {
        shared.Others[own[k]].push_back(shared.BorderProcess[other]);
      }
    }
  }
  for (const std::vector<vtkIdType>& same : members)
  {
    shared.Shared += same.size() > 1;
  }
}
}

int SharedPoints::OwnerOf(vtkIdType number) const
{
  return static_cast<int>(
           std::upper_bound(this->FirstNumber.begin(), this->FirstNumber.end(), number) -
           this->FirstNumber.begin()) -
    1;
}

SharedPoints MatchBorders(Processes& processes, const Messages& messages, const SurfacePiece& piece)
{
  SharedPoints shared;
  std::vector<vtkIdType> own;
  processes.Together([&] { own = BorderPoints(piece); });
  const std::vector<vtkIdType> counts =
    processes.AllGather({ static_cast<vtkIdType>(piece.Own.Points.size()) });
  shared.FirstNumber = Processes::FirstOf(counts);
  const double border = messages.Sum(static_cast<double>(own.size()));
  const auto points = static_cast<double>(shared.FirstNumber.back());
  if (points > FewPoints && border > MostBorder * points)
  {
    shared.Reason = "most of its points lie on borders of the pieces";
    return shared;
  }
  Borders borders = GatherBorders(processes, messages, piece, own);
  shared.UseIds = !borders.All.GlobalIds.empty();
  shared.Tolerance = borders.Tolerance;
  JoinedPoints joined;
  bool isInside = false;
  bool isCoincident = false;
  const int process = messages.Own();
  processes.Together(
    [&]
    {
      joined = JoinPieces(borders.All, borders.Tolerance);
      std::vector<int> uses(static_cast<std::size_t>(joined.Count), 0);
      for (const vtkIdType number : joined.Number)
      {
        ++uses[number];
      }
      std::vector<char> isJoined;
      for (const vtkIdType number : joined.Number)
      {
        isJoined.push_back(uses[number] > 1 ? 1 : 0);
      }
      isInside = HasPointsInside(borders, isJoined, piece, own, process);
      isCoincident = HasCoincidentBoundary(borders, joined);
      Number(borders, joined, piece, own, process, shared);
      for (const vtkIdType point : own)
      {
        shared.OwnBorder.push_back(piece.Own.Points[point]);
      }
    });
  if (messages.Any(isInside))
  {
    shared.Reason = "pieces of it end inside of others";
  }
  else if (!joined.Moved.empty())
  {
    shared.Reason = "points of one piece are as near to each other as the same point of two";
  }
  else if (isCoincident)
  {
    shared.Reason = "points on its boundary have equal places";
  }
  return shared;
}
}
