// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/PieceWithSurroundings.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <unordered_map>
#include <unordered_set>

namespace DirectionFields::Parallel
{
namespace
{
/// A triangle on its way.
struct SentTriangle
{
  vtkIdType Id;
  std::array<vtkIdType, 3> Corners;
  std::array<double, 9> Places;

  bool operator<(const SentTriangle& other) const { return this->Id < other.Id; }
};

using SentTriangles = std::vector<SentTriangle>;

class Surroundings
{
public:
  Surroundings(
    const Messages& messages, const SurfacePiece& piece, const SharedPoints& shared, Index points)
    : Exchange(messages)
    , Piece(piece)
    , Shared(shared)
    , OwnOf(static_cast<std::size_t>(points), -1)
  {
    for (std::size_t k = 0; k < piece.Own.Points.size(); ++k)
    {
      this->OwnOf[piece.Own.Points[k]] = static_cast<Index>(k);
    }
  }

  /// Takes over the triangles that belong to this process.
  void ReadOwn(const Surface& input, PieceWithSurroundings& own) const
  {
    own.InputPoints = static_cast<Index>(input.Points.size());
    own.Surface.Points = input.Points;
    own.Number.assign(input.Points.size(), -1);
    for (std::size_t k = 0; k < this->Piece.Own.Points.size(); ++k)
    {
      const vtkIdType point = this->Piece.Own.Points[k];
      own.Surface.Points[point] = Vector3(this->Shared.Coordinates.data() + 3 * k);
      own.Number[point] = this->Shared.Number[k];
    }
    for (std::size_t t = 0; t < input.Triangles.size(); ++t)
    {
      if (input.Ghost.empty() || input.Ghost[t] == 0)
      {
        own.Surface.Triangles.push_back(input.Triangles[t]);
        own.InputTriangle.push_back(static_cast<Index>(t));
      }
    }
  }

  /// The own triangles at shared points, for each process that has one of these points.
  std::vector<SentTriangles> FirstRing(const PieceWithSurroundings& own) const
  {
    std::vector<SentTriangles> sent(static_cast<std::size_t>(this->Exchange.Count()));
    std::set<int> to;
    for (std::size_t t = 0; t < own.Surface.Triangles.size(); ++t)
    {
      to.clear();
      for (const Index corner : own.Surface.Triangles[t])
      {
        const auto others = this->Shared.Others.find(this->OwnOf[corner]);
        if (others != this->Shared.Others.end())
        {
          to.insert(others->second.begin(), others->second.end());
        }
      }
      for (const int process : to)
      {
        sent[process].push_back(this->Sent(own, t));
      }
    }
    return sent;
  }

  /// The points of others' triangles that the piece does not have, by owner.
  std::vector<std::vector<vtkIdType>> WantedPoints(
    const PieceWithSurroundings& own, const SentTriangles& ring) const
  {
    const std::unordered_set<vtkIdType> known(own.Number.begin(), own.Number.end());
    std::set<vtkIdType> wanted;
    for (const SentTriangle& triangle : ring)
    {
      for (const vtkIdType corner : triangle.Corners)
      {
        if (known.count(corner) == 0)
        {
          wanted.insert(corner);
        }
      }
    }
    std::vector<std::vector<vtkIdType>> from(static_cast<std::size_t>(this->Exchange.Count()));
    for (const vtkIdType number : wanted)
    {
      from[this->Shared.OwnerOf(number)].push_back(number);
    }
    return from;
  }

  /// All triangles at the points that each process wants. Whoever owns a point knows them by now.
  std::vector<SentTriangles> SecondRing(const PieceWithSurroundings& own, const SentTriangles& ring,
    const std::vector<std::vector<vtkIdType>>& wanted) const
  {
    std::unordered_map<vtkIdType, std::vector<int>> askers;
    for (std::size_t p = 0; p < wanted.size(); ++p)
    {
      for (const vtkIdType number : wanted[p])
      {
        askers[number].push_back(static_cast<int>(p));
      }
    }
    std::vector<SentTriangles> sent(wanted.size());
    std::set<int> to;
    const auto add = [&](const std::array<vtkIdType, 3>& corners)
    {
      to.clear();
      for (const vtkIdType corner : corners)
      {
        const auto there = askers.find(corner);
        if (there != askers.end())
        {
          to.insert(there->second.begin(), there->second.end());
        }
      }
    };
    for (std::size_t t = 0; t < own.Surface.Triangles.size() && !askers.empty(); ++t)
    {
      const Triangle& triangle = own.Surface.Triangles[t];
      add({ own.Number[triangle[0]], own.Number[triangle[1]], own.Number[triangle[2]] });
      for (const int process : to)
      {
        sent[process].push_back(this->Sent(own, t));
      }
    }
    for (const SentTriangle& triangle : ring)
    {
      add(triangle.Corners);
      for (const int process : to)
      {
        sent[process].push_back(triangle);
      }
    }
    return sent;
  }

  /// Appends the others' triangles.
  static void Append(SentTriangles& others, PieceWithSurroundings& own)
  {
    const auto end = own.FirstTriangle + static_cast<vtkIdType>(own.Surface.Triangles.size());
    std::sort(others.begin(), others.end());
    others.erase(std::unique(others.begin(), others.end(),
                   [](const SentTriangle& a, const SentTriangle& b) { return a.Id == b.Id; }),
      others.end());
    std::unordered_map<vtkIdType, Index> pointOf;
    for (std::size_t i = 0; i < own.Number.size(); ++i)
    {
      if (own.Number[i] >= 0)
      {
        pointOf.emplace(own.Number[i], static_cast<Index>(i));
      }
    }
    own.Surface.Ghost.assign(own.Surface.Triangles.size(), 0);
    for (const SentTriangle& triangle : others)
    {
      if (triangle.Id >= own.FirstTriangle && triangle.Id < end)
      {
        continue;
      }
      Triangle corners;
      for (int c = 0; c < 3; ++c)
      {
        const auto [entry, isNew] =
          pointOf.try_emplace(triangle.Corners[c], static_cast<Index>(own.Surface.Points.size()));
        if (isNew)
        {
          own.Surface.Points.emplace_back(triangle.Places.data() + 3 * c);
          own.Number.push_back(triangle.Corners[c]);
        }
        corners[c] = entry->second;
      }
      own.Surface.Triangles.push_back(corners);
      own.Surface.Ghost.push_back(1);
      own.OthersTriangles.push_back(triangle.Id);
    }
  }

private:
  SentTriangle Sent(const PieceWithSurroundings& own, std::size_t t) const
  {
    SentTriangle triangle;
    triangle.Id = own.FirstTriangle + static_cast<vtkIdType>(t);
    for (int c = 0; c < 3; ++c)
    {
      const Index point = own.Surface.Triangles[t][c];
      triangle.Corners[c] = own.Number[point];
      std::copy_n(own.Surface.Points[point].data(), 3, triangle.Places.data() + 3 * c);
    }
    return triangle;
  }

  const Messages& Exchange;
  const SurfacePiece& Piece;
  const SharedPoints& Shared;
  /// For each point of the input its number among the own points.
  std::vector<Index> OwnOf;
};

SentTriangles Flattened(const std::vector<SentTriangles>& received)
{
  SentTriangles all;
  for (const SentTriangles& part : received)
  {
    all.insert(all.end(), part.begin(), part.end());
  }
  std::sort(all.begin(), all.end());
  return all;
}
}

PieceWithSurroundings AddSurroundings(Processes& processes, const Messages& messages,
  const Surface& input, const SurfacePiece& piece, const SharedPoints& shared)
{
  PieceWithSurroundings own;
  std::optional<const Surroundings> around;
  processes.Together(
    [&]
    {
      around.emplace(messages, piece, shared, static_cast<Index>(input.Points.size()));
      around->ReadOwn(input, own);
    });
  const std::vector<vtkIdType> first = Processes::FirstOf(
    processes.AllGather({ static_cast<vtkIdType>(own.Surface.Triangles.size()) }));
  own.FirstTriangle = first[messages.Own()];
  own.FirstTriangles = first;

  std::vector<SentTriangles> triangles;
  processes.Together([&] { triangles = around->FirstRing(own); });
  triangles = messages.Exchange(triangles);
  SentTriangles ring;
  std::vector<std::vector<vtkIdType>> wanted;
  processes.Together(
    [&]
    {
      ring = Flattened(triangles);
      wanted = around->WantedPoints(own, ring);
    });
  const std::vector<std::vector<vtkIdType>> asked = messages.Exchange(wanted);
  processes.Together([&] { triangles = around->SecondRing(own, ring, asked); });
  triangles = messages.Exchange(triangles);
  processes.Together(
    [&]
    {
      SentTriangles others = Flattened(triangles);
      others.insert(others.end(), ring.begin(), ring.end());
      Surroundings::Append(others, own);
    });
  return own;
}
}
