// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Stripes/StripeBands.h"

#include "Support/Threads.h"

#include <algorithm>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// Polygons that one thread has cut.
struct PolygonList
{
  std::vector<std::int64_t> Corners;
  std::vector<Index> Sizes;
  std::vector<char> Stripe;
  std::vector<Index> Triangle;
  std::vector<float> Phases;

  void Add(const StripeLevels& levels, const std::vector<StripePiece::Place>& places,
    std::int64_t floor, Index triangle, bool withPhases)
  {
    for (const StripePiece::Place& place : places)
    {
      this->Corners.push_back(place.Point);
      if (withPhases)
      {
        this->Phases.push_back(static_cast<float>(levels.Phase(place.Value)));
      }
    }
    this->Sizes.push_back(static_cast<Index>(places.size()));
    this->Stripe.push_back(floor % 2 == 0 ? 1 : 0);
    this->Triangle.push_back(triangle);
  }
};
}

StripeBands::StripeBands(
  const StripePieces& pieces, const std::vector<char>& isGhost, bool withPhases)
{
  const StripeLevels& levels = pieces.GetLevels();
  const TriangleMesh& mesh = levels.GetWanted().GetMesh();
  constexpr Index size = HeavyPiece;
  std::vector<PolygonList> lists(NumberOfPieces(mesh.GetNumberOfTriangles(), size) + 1);
  const auto cut = [&](Index triangle, const StripePiece& piece,
                     std::vector<StripePiece::Place>& places, PolygonList& list)
  {
    const Index input = mesh.InputTriangle(triangle);
    if (isGhost.empty() || !isGhost[input])
    {
      piece.ForRegions(places,
        [&](const std::vector<StripePiece::Place>& polygon, std::int64_t floor)
        { list.Add(levels, polygon, floor, input, withPhases); });
    }
  };
  ParallelFor(mesh.GetNumberOfTriangles(), size,
    [&](Index begin, Index end)
    {
      std::vector<StripePiece::Place> places;
      pieces.ForStraight(begin, end,
        [&](Index triangle, const StripePiece& piece)
        { cut(triangle, piece, places, lists[begin / size]); });
    });
  std::vector<StripePiece::Place> places;
  for (std::size_t k = 0; k < pieces.GetPiecesAtCenters().size(); ++k)
  {
    cut(pieces.GetCenters()[pieces.GetPieceCenters()[k]].Triangle, pieces.GetPiecesAtCenters()[k],
      places, lists.back());
  }
  // Points get numbers in the order in which polygons use them.
  const Index nodes = levels.GetWanted().GetNumberOfNodes();
  LargeArray<std::int64_t> number(nodes + levels.GetNumberOfCrossings() +
    static_cast<std::int64_t>(pieces.GetInnerPoints().size()));
  std::fill(number.begin(), number.end(), -1);
  for (PolygonList& list : lists)
  {
    for (const std::int64_t point : list.Corners)
    {
      std::int64_t& at = number[point < 0 ? -1 - point : nodes + point];
      if (at < 0)
      {
        at = static_cast<std::int64_t>(this->Points.size());
        this->Points.push_back(point);
      }
      this->Corners.push_back(at);
    }
    for (const Index corners : list.Sizes)
    {
      this->Offsets.push_back(this->Offsets.back() + corners);
    }
    this->Stripe.insert(this->Stripe.end(), list.Stripe.begin(), list.Stripe.end());
    this->Triangle.insert(this->Triangle.end(), list.Triangle.begin(), list.Triangle.end());
    this->Phases.insert(this->Phases.end(), list.Phases.begin(), list.Phases.end());
    list = PolygonList();
  }
}
}
