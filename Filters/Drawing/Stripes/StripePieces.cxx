// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Stripes/StripePieces.h"

#include "Support/Threads.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// How large the triangle around a point that the phase turns around is, as a part of the whole
/// one.
constexpr double InnerSize = 0.3;
/// Values inside of triangles keep this distance from whole numbers.
constexpr double Clearance = 1e-5;
constexpr std::array<double, 3> Middle = { 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0 };

std::array<double, 3> CornerWeights(int c)
{
  std::array<double, 3> weights{};
  weights[c % 3] = 1.0;
  return weights;
}

std::array<double, 3> Between(
  const std::array<double, 3>& from, const std::array<double, 3>& to, double part)
{
  std::array<double, 3> weights{};
  for (int c = 0; c < 3; ++c)
  {
    weights[c] = (1.0 - part) * from[c] + part * to[c];
  }
  return weights;
}

double Cleared(double value)
{
  const double nearest = std::round(value);
  return std::abs(value - nearest) < Clearance ? nearest + Clearance : value;
}
}

StripePieces::StripePieces(const StripeLevels& levels)
  : Levels(levels)
{
  const WantedPhases& wanted = levels.GetWanted();
  const TriangleMesh& mesh = wanted.GetMesh();
  constexpr Index size = HeavyPiece;
  std::vector<std::vector<Index>> found(NumberOfPieces(mesh.GetNumberOfTriangles(), size));
  ParallelFor(mesh.GetNumberOfTriangles(), size,
    [&](Index begin, Index end)
    {
      for (Index t = begin; t < end; ++t)
      {
        if (mesh.IsFront(t) && !IsStraight(levels.At(t)))
        {
          found[begin / size].push_back(t);
        }
      }
    });
  for (const std::vector<Index>& triangles : found)
  {
    for (const Index t : triangles)
    {
      const StripeLevels::Corners corners = levels.At(t);
      this->Centers.push_back(
        { t, corners.Flips ? 0 : corners.Gain(), corners.Flips, this->AddPoint(t, Middle) });
      if (corners.Flips)
      {
        this->CutFlipping(t, corners);
      }
      else
      {
        this->CutTurning(t, corners);
      }
    }
  }
}

std::int64_t StripePieces::AddPoint(Index triangle, const Weights& weights)
{
  this->Points.push_back({ triangle, weights });
  return this->Levels.GetNumberOfCrossings() + static_cast<std::int64_t>(this->Points.size()) - 1;
}

StripePieces::Side StripePieces::AddSide(Index triangle, const End& from, const End& to)
{
  Side side;
  side.First = this->Levels.GetNumberOfCrossings() + static_cast<std::int64_t>(this->Points.size());
  side.Signed = to.Floor - from.Floor;
  const std::int64_t up = side.Signed > 0 ? 1 : -1;
  for (std::int64_t k = 0; k < side.Count(); ++k)
  {
    const double level = static_cast<double>(from.Floor + (up > 0 ? 1 + k : -k));
    this->AddPoint(
      triangle, Between(from.At, to.At, (level - from.Value) / (to.Value - from.Value)));
  }
  return side;
}

void StripePieces::AddPiece(const StripePiece& piece)
{
  this->Pieces.push_back(piece);
  this->PieceCenters.push_back(static_cast<Index>(this->Centers.size()) - 1);
}

StripePiece StripePieces::Whole(Index triangle, const StripeLevels::Corners& corners) const
{
  const WantedPhases& wanted = this->Levels.GetWanted();
  StripePiece piece;
  for (int c = 0; c < 3; ++c)
  {
    piece.Corners[c] = -1 - wanted.Node(wanted.GetMesh().Tail(3 * triangle + c));
    piece.Value[c] = corners.Value[c];
    piece.Floor[c] = corners.Floor[c];
    piece.Sides[c] = corners.Sides[c];
  }
  return piece;
}

void StripePieces::CutTurning(Index triangle, const StripeLevels::Corners& corners)
{
  const StripePiece whole = this->Whole(triangle, corners);
  const std::int64_t gain = corners.Gain();
  const double perCorner = static_cast<double>(gain) / 3.0;
  const double mean = (corners.Value[0] + corners.Value[1] + corners.Value[2]) / 3.0 - perCorner;
  std::array<End, 4> outer;
  std::array<End, 4> inner;
  std::array<std::int64_t, 4> innerPoint{};
  std::array<Side, 4> spoke;
  for (int c = 0; c < 3; ++c)
  {
    const double value = Cleared(mean + c * perCorner);
    outer[c] = { CornerWeights(c), corners.Value[c], corners.Floor[c] };
    inner[c] = { Between(Middle, outer[c].At, InnerSize), value,
      static_cast<std::int64_t>(std::floor(value)) };
    innerPoint[c] = this->AddPoint(triangle, inner[c].At);
    spoke[c] = this->AddSide(triangle, outer[c], inner[c]);
  }
  // After a turn all has gained the same.
  outer[3] = { outer[0].At, corners.Value[3], corners.Floor[3] };
  inner[3] = { inner[0].At, inner[0].Value + static_cast<double>(gain), inner[0].Floor + gain };
  innerPoint[3] = innerPoint[0];
  spoke[3] = spoke[0];
  for (int c = 0; c < 3; ++c)
  {
    const int next = c + 1;
    const Side diagonal = this->AddSide(triangle, outer[next], inner[c]);
    const Side along = this->AddSide(triangle, inner[c], inner[next]);
    const std::int64_t nextCorner = whole.Corners[next % 3];
    this->AddPiece({ { whole.Corners[c], nextCorner, innerPoint[c] },
      { outer[c].Value, outer[next].Value, inner[c].Value },
      { outer[c].Floor, outer[next].Floor, inner[c].Floor },
      { corners.Sides[c], diagonal, spoke[c].Reversed() } });
    this->AddPiece({ { nextCorner, innerPoint[next], innerPoint[c] },
      { outer[next].Value, inner[next].Value, inner[c].Value },
      { outer[next].Floor, inner[next].Floor, inner[c].Floor },
      { spoke[next], along.Reversed(), diagonal.Reversed() } });
    this->AddPiece({ { innerPoint[c], innerPoint[next], this->Centers.back().Point },
      { inner[c].Value, inner[next].Value, 0.0 }, { inner[c].Floor, inner[next].Floor, 0 },
      { along, Side(), Side() }, true });
  }
}

void StripePieces::CutFlipping(Index triangle, const StripeLevels::Corners& corners)
{
  const StripePiece whole = this->Whole(triangle, corners);
  // Twice the value where y and its mirror image after a turn are the same.
  const std::int64_t twice = corners.Floor[0] + corners.Floor[3] + 1;
  const bool isLevel = twice % 2 == 0;
  const double value = 0.5 * static_cast<double>(twice);
  const auto floor = static_cast<std::int64_t>(std::floor(value));
  const auto isBelow = [&](int c) { return corners.Floor[c] < floor; };
  std::array<Side, 4> spoke;
  for (int c = 0; c < 3; ++c)
  {
    // A level that ends in the middle crosses no spoke.
    const std::int64_t last = isLevel && isBelow(c) ? floor - 1 : floor;
    spoke[c] = this->AddSide(
      triangle, { CornerWeights(c), corners.Value[c], corners.Floor[c] }, { Middle, value, last });
  }
  spoke[3] = { spoke[0].First, -spoke[0].Signed, false };
  for (int c = 0; c < 3; ++c)
  {
    this->AddPiece({ { whole.Corners[c], whole.Corners[(c + 1) % 3], this->Centers.back().Point },
      { corners.Value[c], corners.Value[c + 1], value },
      { corners.Floor[c], corners.Floor[c + 1], floor },
      { corners.Sides[c], spoke[c + 1], spoke[c].Reversed() }, false,
      isLevel && isBelow(c) != isBelow(c + 1) });
  }
}
}
