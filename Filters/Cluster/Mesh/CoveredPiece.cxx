// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/CoveredPiece.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <unordered_map>
#include <utility>

namespace DirectionFields::Parallel
{
namespace
{
/// A triangle at a point.
struct AtPoint
{
  /// Counted over all processes.
  vtkIdType Number;
  Index Triangle;
};

bool IsCollapsed(const Triangle& t)
{
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// Which side of the surface each corner of the piece's triangles is on: 0 where the triangle is
/// wound as the first one at the corner's point, else 1.
class Sides
{
public:
  Sides(const PieceWithSurroundings& piece, const std::vector<char>& isOneSided)
    : Piece(piece)
    , Side(piece.Surface.Triangles.size(), { 0, 0, 0 })
  {
    std::vector<char> isCovered(static_cast<std::size_t>(piece.InputPoints), 0);
    for (std::size_t t = 0; t < isOneSided.size(); ++t)
    {
      for (const Index corner : piece.Surface.Triangles[t])
      {
        isCovered[corner] |= isOneSided[t];
      }
    }
    const std::vector<Triangle>& triangles = piece.Surface.Triangles;
    std::unordered_map<Index, std::vector<AtPoint>> fans;
    for (std::size_t t = 0; t < triangles.size(); ++t)
    {
      for (const Index corner : triangles[t])
      {
        if (corner < piece.InputPoints && isCovered[corner] && !IsCollapsed(triangles[t]))
        {
          fans[corner].push_back({ this->NumberOf(t), static_cast<Index>(t) });
        }
      }
    }
    for (auto& [point, fan] : fans)
    {
      this->IsManifold = this->Spread(point, fan) && this->IsManifold;
    }
  }

  /// Whether the triangles at each point are one fan.
  bool AreKnown() const { return this->IsManifold; }
  const std::array<char, 3>& Of(std::size_t triangle) const { return this->Side[triangle]; }

private:
  vtkIdType NumberOf(std::size_t t) const
  {
    const std::size_t own = this->Piece.InputTriangle.size();
    return t < own ? this->Piece.FirstTriangle + static_cast<vtkIdType>(t)
                   : this->Piece.OthersTriangles[t - own];
  }

  std::size_t CornerAt(Index triangle, Index point) const
  {
    const Triangle& corners = this->Piece.Surface.Triangles[triangle];
    return static_cast<std::size_t>(
      std::find(corners.begin(), corners.end(), point) - corners.begin());
  }

  /// Goes around a point from its first triangle on.
  /// @return false where its triangles are no fan
  bool Spread(Index point, std::vector<AtPoint>& fan)
  {
    std::sort(fan.begin(), fan.end(),
      [](const AtPoint& a, const AtPoint& b) { return a.Number < b.Number; });
    // The triangles at each neighbour, and whether they run towards it first.
    std::unordered_map<Index, std::vector<std::pair<std::size_t, bool>>> at;
    for (std::size_t k = 0; k < fan.size(); ++k)
    {
      const Triangle& corners = this->Piece.Surface.Triangles[fan[k].Triangle];
      const std::size_t c = this->CornerAt(fan[k].Triangle, point);
      at[corners[(c + 1) % 3]].emplace_back(k, true);
      at[corners[(c + 2) % 3]].emplace_back(k, false);
    }
    std::vector<int> side(fan.size(), -1);
    std::vector<std::size_t> members{ 0 };
    side[0] = 0;
    for (std::size_t m = 0; m < members.size(); ++m)
    {
      const Triangle& corners = this->Piece.Surface.Triangles[fan[members[m]].Triangle];
      const std::size_t c = this->CornerAt(fan[members[m]].Triangle, point);
      this->Side[fan[members[m]].Triangle][c] = static_cast<char>(side[members[m]]);
      for (const bool isNext : { true, false })
      {
        const auto& there = at[corners[(c + (isNext ? 1 : 2)) % 3]];
        if (there.size() > 2)
        {
          return false;
        }
        for (const auto& [k, isOtherNext] : there)
        {
          const int wanted = side[members[m]] ^ (isNext == isOtherNext ? 1 : 0);
          if (k != members[m] && side[k] < 0)
          {
            side[k] = wanted;
            members.push_back(k);
          }
          else if (k != members[m] && side[k] != wanted)
          {
            return false;
          }
        }
      }
    }
    return members.size() == fan.size();
  }

  const PieceWithSurroundings& Piece;
  std::vector<std::array<char, 3>> Side;
  bool IsManifold = true;
};

/// The own triangles and, behind those of one-sided components, their backs.
Surface BothSides(
  const PieceWithSurroundings& piece, const std::vector<char>& isOneSided, const Sides& sides)
{
  Surface both;
  const auto front = piece.Surface.Points.begin();
  both.Points.assign(front, front + piece.InputPoints);
  both.Points.insert(both.Points.end(), front, front + piece.InputPoints);
  const auto behind = [&](std::size_t t, std::size_t c, int side)
  {
    return piece.Surface.Triangles[t][c] +
      ((sides.Of(t)[c] != 0) != (side != 0) ? piece.InputPoints : 0);
  };
  for (std::size_t t = 0; t < isOneSided.size(); ++t)
  {
    both.Triangles.push_back(isOneSided[t]
        ? Triangle{ behind(t, 0, 0), behind(t, 1, 0), behind(t, 2, 0) }
        : piece.Surface.Triangles[t]);
  }
  for (std::size_t t = 0; t < isOneSided.size(); ++t)
  {
    if (isOneSided[t])
    {
      both.Triangles.push_back({ behind(t, 0, 1), behind(t, 2, 1), behind(t, 1, 1) });
    }
  }
  return both;
}

/// Points are numbered in pairs, front and back.
SharedPoints BothSides(const SharedPoints& shared, const PiecePoints& own, Index points)
{
  SharedPoints both = shared;
  for (vtkIdType& number : both.FirstNumber)
  {
    number *= 2;
  }
  for (vtkIdType& number : both.Number)
  {
    number *= 2;
  }
  const auto count = static_cast<vtkIdType>(own.Points.size());
  for (const vtkIdType number : shared.Number)
  {
    both.Number.push_back(2 * number + 1);
  }
  both.Coordinates.insert(
    both.Coordinates.end(), shared.Coordinates.begin(), shared.Coordinates.end());
  for (const auto& [point, others] : shared.Others)
  {
    both.Others[point + count] = others;
  }
  both.BorderProcess.clear();
  both.BorderNumber.clear();
  for (std::size_t k = 0; k < shared.BorderNumber.size(); ++k)
  {
    both.BorderProcess.insert(both.BorderProcess.end(), 2, shared.BorderProcess[k]);
    both.BorderNumber.push_back(2 * shared.BorderNumber[k]);
    both.BorderNumber.push_back(2 * shared.BorderNumber[k] + 1);
  }
  both.OwnBorder.clear();
  for (const vtkIdType point : shared.OwnBorder)
  {
    both.OwnBorder.push_back(point);
    both.OwnBorder.push_back(point + points);
  }
  return both;
}
}

Covering CoverOneSided(Processes& processes, const Messages& messages, const SurfacePiece& own,
  const SharedPoints& shared, const PieceWithSurroundings& piece,
  const std::vector<char>& isOneSided)
{
  Covering covering;
  SurfacePiece bothOwn;
  Surface both;
  bool isKnown = true;
  processes.Together(
    [&]
    {
      const Sides sides(piece, isOneSided);
      isKnown = sides.AreKnown();
      both = BothSides(piece, isOneSided, sides);
      covering.Shared = BothSides(shared, own.Own, piece.InputPoints);
      bothOwn.Own.Points = own.Own.Points;
      for (const vtkIdType point : own.Own.Points)
      {
        bothOwn.Own.Points.push_back(point + piece.InputPoints);
      }
    });
  if (messages.Any(!isKnown))
  {
    covering.Reason = "it has only one side, and sheets of it meet";
    return covering;
  }
  covering.Piece = AddSurroundings(processes, messages, both, bothOwn, covering.Shared);
  covering.Piece.FrontPoints = piece.InputPoints;
  covering.Piece.FrontTriangles = static_cast<Index>(isOneSided.size());
  for (std::size_t t = 0; t < isOneSided.size(); ++t)
  {
    covering.Piece.InputTriangle[t] = piece.InputTriangle[t];
  }
  return covering;
}

std::vector<Index> VerticesBehind(const TriangleMesh& mesh, const PieceWithSurroundings& piece)
{
  std::unordered_map<vtkIdType, Index> vertexOf;
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    vertexOf.emplace(piece.Number[mesh.Point(v)], v);
  }
  std::vector<Index> behind(static_cast<std::size_t>(mesh.GetNumberOfVertices()), None);
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    // The numbers of front and back differ in their last bit.
    const auto other = vertexOf.find(piece.Number[mesh.Point(v)] ^ 1);
    behind[v] = other == vertexOf.end() ? None : other->second;
  }
  return behind;
}
}
