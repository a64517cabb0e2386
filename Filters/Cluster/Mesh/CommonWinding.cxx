// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/CommonWinding.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace DirectionFields::Parallel
{
namespace
{
/// A triangle of the piece, as it is in the mesh.
struct Winding
{
  /// Its part, counted over all processes; None where the mesh does not have it.
  int Part = None;
  /// Whether the mesh has turned it.
  int IsTurned = 0;
};

/// The own triangles of a part.
struct PartWinding
{
  vtkIdType Triangles = 0;
  vtkIdType Turned = 0;
  /// The first of them, and whether it was turned.
  vtkIdType First = -1;
  vtkIdType IsFirstTurned = 0;
  /// Whether it cannot be wound alike by itself.
  vtkIdType IsOneSided = 0;
};

/// Two parts with a triangle in common, and whether one has turned it and the other one has not.
struct Meeting
{
  int First;
  int Second;
  int IsOpposite;

  bool operator<(const Meeting& other) const
  {
    return std::tie(this->First, this->Second, this->IsOpposite) <
      std::tie(other.First, other.Second, other.IsOpposite);
  }
};

bool IsTurned(const TriangleMesh& mesh, Index t, const Triangle& input)
{
  const auto first = std::find(input.begin(), input.end(), mesh.Point(mesh.Tail(3 * t)));
  return input[(first - input.begin() + 1) % 3] != mesh.Point(mesh.Tail(3 * t + 1));
}

std::vector<Winding> ReadWindings(
  const TriangleMesh& mesh, const PieceWithSurroundings& piece, int firstPart)
{
  std::vector<Winding> windings(piece.Surface.Triangles.size());
  for (std::size_t c = 0; c < mesh.GetComponents().size(); ++c)
  {
    const TriangleMesh::Component& part = mesh.GetComponents()[c];
    for (Index t = part.FirstTriangle; t < part.EndTriangle; ++t)
    {
      const Index input = mesh.InputTriangle(t);
      windings[input] = { firstPart + static_cast<int>(c),
        IsTurned(mesh, t, piece.Surface.Triangles[input]) ? 1 : 0 };
    }
  }
  return windings;
}

/// Compares the windings of the surroundings with the windings on their own processes.
std::vector<Meeting> FindMeetings(Processes& processes, const Messages& messages,
  const PieceWithSurroundings& piece, const std::vector<Winding>& windings)
{
  const std::size_t own = piece.InputTriangle.size();
  const auto processCount = static_cast<std::size_t>(messages.Count());
  std::vector<std::vector<Index>> wanted;
  std::vector<std::vector<std::size_t>> askedFor;
  processes.Together(
    [&]
    {
      wanted.resize(processCount);
      askedFor.resize(processCount);
      for (std::size_t k = 0; k < piece.OthersTriangles.size(); ++k)
      {
        const std::vector<vtkIdType>& first = piece.FirstTriangles;
        const auto process = static_cast<std::size_t>(
          std::upper_bound(first.begin(), first.end(), piece.OthersTriangles[k]) - first.begin() -
          1);
        wanted[process].push_back(static_cast<Index>(piece.OthersTriangles[k] - first[process]));
        askedFor[process].push_back(own + k);
      }
    });
  const std::vector<std::vector<Index>> asked = messages.Exchange(wanted);
  std::vector<std::vector<Winding>> answers;
  processes.Together(
    [&]
    {
      answers.resize(processCount);
      for (std::size_t p = 0; p < asked.size(); ++p)
      {
        for (const Index triangle : asked[p])
        {
          answers[p].push_back(windings[triangle]);
        }
      }
    });
  const std::vector<std::vector<Winding>> received = messages.Exchange(answers);
  std::set<Meeting> meetings;
  for (std::size_t p = 0; p < received.size(); ++p)
  {
    for (std::size_t k = 0; k < received[p].size(); ++k)
    {
      const Winding& here = windings[askedFor[p][k]];
      const Winding& there = received[p][k];
      if (here.Part != None && there.Part != None)
      {
        meetings.insert({ here.Part, there.Part, here.IsTurned ^ there.IsTurned });
      }
    }
  }
  return { meetings.begin(), meetings.end() };
}

/// Parts that are joined, each wound as the first of them or opposite to it.
class JoinedParts
{
public:
  explicit JoinedParts(std::size_t count)
    : Parents(count)
    , IsOpposite(count, 0)
  {
    std::iota(this->Parents.begin(), this->Parents.end(), 0);
  }

  /// The first part, and whether a part is wound opposite to it.
  std::pair<int, int> Find(int part) const
  {
    int opposite = 0;
    while (this->Parents[part] != part)
    {
      opposite ^= this->IsOpposite[part];
      part = this->Parents[part];
    }
    return { part, opposite };
  }

  /// False where the parts are joined already, in the other way.
  bool Join(const Meeting& meeting)
  {
    const auto [first, firstOpposite] = this->Find(meeting.First);
    const auto [second, secondOpposite] = this->Find(meeting.Second);
    const int opposite = firstOpposite ^ secondOpposite ^ meeting.IsOpposite;
    if (first == second)
    {
      return opposite == 0;
    }
    this->Parents[std::max(first, second)] = std::min(first, second);
    this->IsOpposite[std::max(first, second)] = opposite;
    return true;
  }

private:
  std::vector<int> Parents;
  std::vector<int> IsOpposite;
};

std::vector<PartWinding> OwnParts(const TriangleMesh& mesh, const std::vector<Winding>& windings,
  const PieceWithSurroundings& piece, int firstPart)
{
  std::vector<PartWinding> own(mesh.GetComponents().size());
  for (std::size_t c = 0; c < own.size(); ++c)
  {
    own[c].IsOneSided = mesh.GetComponents()[c].IsCover;
  }
  for (std::size_t t = 0; t < piece.InputTriangle.size(); ++t)
  {
    if (windings[t].Part != None)
    {
      PartWinding& part = own[windings[t].Part - firstPart];
      if (part.First < 0)
      {
        part.First = piece.FirstTriangle + static_cast<vtkIdType>(t);
        part.IsFirstTurned = windings[t].IsTurned;
      }
      ++part.Triangles;
      part.Turned += windings[t].IsTurned;
    }
  }
  return own;
}

/// For each part whether its triangles have to be reversed once more: those of components with two
/// sides.
/// @param isOneSided of each joined part, by its first part
std::vector<char> Decide(const JoinedParts& joined, const std::vector<PartWinding>& parts,
  const std::vector<char>& isOneSided, CommonWinding& found)
{
  std::vector<PartWinding> whole(parts.size());
  for (std::size_t k = 0; k < parts.size(); ++k)
  {
    const auto [first, opposite] = joined.Find(static_cast<int>(k));
    PartWinding& all = whole[first];
    all.Triangles += parts[k].Triangles;
    all.Turned += opposite ? parts[k].Triangles - parts[k].Turned : parts[k].Turned;
    if (parts[k].First >= 0 && (all.First < 0 || parts[k].First < all.First))
    {
      all.First = parts[k].First;
      all.IsFirstTurned = parts[k].IsFirstTurned ^ opposite;
    }
  }
  std::vector<char> turnWhole(parts.size(), 0);
  for (std::size_t k = 0; k < parts.size(); ++k)
  {
    if (isOneSided[k])
    {
      found.OneSided += whole[k].Triangles > 0 ? 1 : 0;
      continue;
    }
    const vtkIdType twice = 2 * whole[k].Turned;
    turnWhole[k] =
      twice > whole[k].Triangles || (twice == whole[k].Triangles && whole[k].IsFirstTurned != 0);
    found.Reversed +=
      static_cast<Index>(turnWhole[k] ? whole[k].Triangles - whole[k].Turned : whole[k].Turned);
  }
  std::vector<char> turn(parts.size());
  for (std::size_t k = 0; k < parts.size(); ++k)
  {
    const auto [first, opposite] = joined.Find(static_cast<int>(k));
    turn[k] = static_cast<char>(turnWhole[first] ^ opposite);
  }
  return turn;
}
}

CommonWinding WindAlike(Processes& processes, const Messages& messages, const TriangleMesh& mesh,
  PieceWithSurroundings& piece)
{
  const std::vector<vtkIdType> first = Processes::FirstOf(
    processes.AllGather({ static_cast<vtkIdType>(mesh.GetComponents().size()) }));
  const auto firstPart = static_cast<int>(first[messages.Own()]);
  std::vector<Winding> windings;
  std::vector<PartWinding> own;
  processes.Together(
    [&]
    {
      windings = ReadWindings(mesh, piece, firstPart);
      own = OwnParts(mesh, windings, piece, firstPart);
    });
  const std::vector<Meeting> meetings =
    messages.AllGather(FindMeetings(processes, messages, piece, windings)).Values;
  const std::vector<PartWinding> all = messages.AllGather(own).Values;
  JoinedParts joined(all.size());
  std::vector<int> contradictory;
  for (const Meeting& meeting : meetings)
  {
    if (!joined.Join(meeting))
    {
      contradictory.push_back(meeting.First);
    }
  }
  std::vector<char> isOneSided(all.size(), 0);
  for (const int part : contradictory)
  {
    isOneSided[joined.Find(part).first] = 1;
  }
  for (std::size_t k = 0; k < all.size(); ++k)
  {
    isOneSided[joined.Find(static_cast<int>(k)).first] |= all[k].IsOneSided != 0 ? 1 : 0;
  }
  CommonWinding found;
  const std::vector<char> turn = Decide(joined, all, isOneSided, found);
  processes.Together([&] { found.IsOneSided.assign(piece.InputTriangle.size(), 0); });
  for (std::size_t t = 0; t < windings.size(); ++t)
  {
    if (windings[t].Part == None)
    {
      continue;
    }
    if (isOneSided[joined.Find(windings[t].Part).first])
    {
      if (t < found.IsOneSided.size())
      {
        found.IsOneSided[t] = 1;
      }
    }
    else if (windings[t].IsTurned ^ turn[windings[t].Part])
    {
      std::swap(piece.Surface.Triangles[t][1], piece.Surface.Triangles[t][2]);
    }
  }
  return found;
}
}
