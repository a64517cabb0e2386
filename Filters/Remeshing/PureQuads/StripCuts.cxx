// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "PureQuads/StripCuts.h"

#include <algorithm>
#include <array>

namespace DirectionFields::Internal
{
namespace
{
constexpr Faces::Face Nothing = { None, None, None, None };
}

/// By how much the irregularity grows.
int StripCuts::Growth(const FaceStrip& strip, const std::vector<FaceStrip::Chord>& chords) const
{
  std::vector<Index> more(strip.GetPolygon().size(), 0);
  for (const FaceStrip::Chord& edge : strip.GetEdges())
  {
    --more[edge[0]];
    --more[edge[1]];
  }
  for (const FaceStrip::Chord& chord : chords)
  {
    ++more[chord[0]];
    ++more[chord[1]];
  }
  int grown = 0;
  for (std::size_t k = 0; k < more.size(); ++k)
  {
    const Index v = strip.GetPolygon()[k];
    grown += this->Edits.Irregularity(v, more[k]) - this->Edits.Irregularity(v);
  }
  return grown;
}

std::vector<StripCuts::Cut> StripCuts::Find(const FaceStrip& strip) const
{
  std::vector<Cut> cuts;
  for (const std::vector<FaceStrip::Chord>& chords :
    { strip.Cheapest(this->Places.GetPoints()), strip.Shifted(true), strip.Shifted(false) })
  {
    const bool isNew = std::none_of(
      cuts.begin(), cuts.end(), [&](const Cut& other) { return other.Chords == chords; });
    if (isNew && chords.size() + 1 == strip.GetEdges().size())
    {
      cuts.push_back({ chords, this->Growth(strip, chords) });
    }
  }
  if (strip.GetEdges().size() == 1)
  {
    const Index right = strip.GetPolygon()[strip.GetEdges()[0][0]];
    const Index left = strip.GetPolygon()[strip.GetEdges()[0][1]];
    for (const FaceEdits::Edit& edit :
      { FaceEdits::Edit{ left, right, None }, FaceEdits::Edit{ right, left, None } })
    {
      const int grown = this->Edits.GrowthBy(edit) + 2 * FaceEdits::PerTriangle;
      cuts.push_back({ {}, grown, edit.First, edit.Second });
    }
  }
  std::stable_sort(
    cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) { return a.Grown < b.Grown; });
  return cuts;
}

bool StripCuts::Do(const std::vector<Index>& path, const FaceStrip& strip, const Cut& cut)
{
  if (cut.Goes != None)
  {
    return this->Edits.Do({ cut.Goes, cut.Stays, None }) && this->TakeOutDoublets(strip);
  }
  for (const Index f : path)
  {
    this->Cells.Set(f, Nothing);
  }
  const std::vector<Index>& polygon = strip.GetPolygon();
  FaceStrip::Chord before = strip.Whole();
  for (std::size_t k = 0; k < cut.Chords.size(); ++k)
  {
    const FaceStrip::Chord& chord = cut.Chords[k];
    if (this->Cells.AreJoined(polygon[chord[0]], polygon[chord[1]]))
    {
      return false;
    }
    this->Cells.Set(path[k], strip.Between(before, chord));
    before = chord;
  }
  this->Cells.Set(path[cut.Chords.size()], strip.Beyond(before));
  return this->TakeOutDoublets(strip);
}

/// Merges two quads that share two edges into one; returns false if a vertex has too few faces
/// nevertheless.
bool StripCuts::TakeOutDoublets(const FaceStrip& strip)
{
  std::vector<Index> vertices = strip.GetPolygon();
  for (std::size_t k = 0; k < vertices.size(); ++k)
  {
    const Index v = vertices[k];
    const std::vector<Index> star = this->Cells.At(v);
    if (star.empty() || this->Edits.HasEnoughFaces(v))
    {
      continue;
    }
    if (star.size() != 2 || !this->Places.IsOnSurface(v) ||
      Faces::Size(this->Cells.Face(star[0])) + Faces::Size(this->Cells.Face(star[1])) < 8)
    {
      return false;
    }
    // From v on.
    std::array<Faces::Face, 2> faces{};
    for (int i = 0; i < 2; ++i)
    {
      faces[i] = this->Cells.Face(star[i]);
      std::rotate(faces[i].begin(), std::find(faces[i].begin(), faces[i].end(), v), faces[i].end());
    }
    if (faces[0][1] != faces[1][3] || faces[0][3] != faces[1][1] || faces[0][2] == faces[1][2])
    {
      return false;
    }
    this->Cells.Set(star[0], { faces[1][2], faces[0][1], faces[0][2], faces[0][3] });
    this->Cells.Set(star[1], Nothing);
    vertices.insert(vertices.end(), { faces[0][1], faces[0][3] });
  }
  return true;
}
}
