// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SolverFiles/ShellEdges.h"

#include "SolverFiles/ShellChecks.h"

#include <algorithm>
#include <cstddef>
#include <tuple>

namespace DirectionFields::Internal
{
namespace
{
/// An edge of a face.
struct Side
{
  std::array<Index, 2> Ends;
  std::size_t Face;
  int Corner;

  friend bool operator<(const Side& a, const Side& b)
  {
    return std::tie(a.Ends, a.Face, a.Corner) < std::tie(b.Ends, b.Face, b.Corner);
  }
};
}

ShellEdges::ShellEdges(const ShellMesh& mesh)
  : OfFace(mesh.Faces.size())
{
  std::vector<Side> sides;
  for (std::size_t f = 0; f < mesh.Faces.size(); ++f)
  {
    const int corners = CornersOf(mesh.Faces[f]);
    for (int k = 0; k < corners; ++k)
    {
      const auto ends = std::minmax(mesh.Faces[f][k], mesh.Faces[f][(k + 1) % corners]);
      sides.push_back({ { ends.first, ends.second }, f, k });
    }
  }
  std::sort(sides.begin(), sides.end());
  for (const Side& side : sides)
  {
    if (this->Ends.empty() || this->Ends.back() != side.Ends)
    {
      this->Ends.push_back(side.Ends);
      this->IsBoundary.push_back(1);
    }
    else
    {
      this->IsBoundary.back() = 0;
    }
    this->OfFace[side.Face][side.Corner] = static_cast<std::int64_t>(this->Ends.size()) - 1;
  }
}

std::array<std::int64_t, 2> ShellEdges::From(Index point) const
{
  const auto isBefore = [](const std::array<Index, 2>& ends, Index p) { return ends[0] < p; };
  const auto begin = this->Ends.begin();
  const auto first = std::lower_bound(begin, this->Ends.end(), point, isBefore);
  const auto last = std::lower_bound(first, this->Ends.end(), point + 1, isBefore);
  return { first - begin, last - begin };
}
}
