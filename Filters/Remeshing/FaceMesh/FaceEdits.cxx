// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaceMesh/FaceEdits.h"

#include <algorithm>
#include <cstdlib>

namespace DirectionFields::Internal
{
namespace
{
/// Penalty for one face too many or too few at a vertex, and for the second and each further one:
/// two vertices with one cost more than one vertex with two, but less than one with three.
constexpr int Once = 10;
constexpr int Second = 9;
constexpr int Further = 3;
/// The parts that must not change.
constexpr int Forbidden = 10000;

constexpr Faces::Face Nothing = { None, None, None, None };

int PlaceOf(const Faces::Face& face, Index v)
{
  const auto found = std::find(face.begin(), face.end(), v);
  return found == face.end() ? -1 : static_cast<int>(found - face.begin());
}
}

FaceEdits::FaceEdits(
  VertexStars& faces, std::vector<Rule> rules, const MovableFaces* places, int degree)
  : Cells(faces)
  , Rules(std::move(rules))
  , Places(places)
  , AreTriangles(degree == 6)
{
}

int FaceEdits::Irregularity(Index v, Index more) const
{
  const auto faces = static_cast<Index>(this->Cells.At(v).size()) + more;
  const Rule& rule = this->Rules[v];
  if (faces == rule.Target || (faces == 0 && !rule.IsLocked))
  {
    return 0;
  }
  if (rule.IsLocked)
  {
    return Forbidden;
  }
  const auto off = static_cast<int>(std::abs(faces - rule.Target));
  return Once + (off - 1) * (Second + (off - 2) * Further);
}

bool FaceEdits::HasEnoughFaces(Index v) const
{
  // A vertex inside with two faces would leave them with two common edges.
  return this->Cells.At(v).size() >= (this->Rules[v].IsBoundary ? 1u : 3u);
}

int FaceEdits::Growth(Index v, Index more) const
{
  return this->Irregularity(v, more) - this->Irregularity(v, 0);
}

int FaceEdits::GrowthBy(const Edit& edit) const
{
  int grown = 0;
  if (edit.Diagonal != None && edit.Second == None)
  {
    const Faces::Face& face = this->Cells.Face(edit.First);
    return this->Growth(face[edit.Diagonal], 1) + this->Growth(face[edit.Diagonal + 2], 1) +
      2 * PerTriangle;
  }
  if (edit.Diagonal != None)
  {
    const std::vector<Index> polygon = this->PolygonOf(edit.First, edit.Second);
    const std::size_t size = polygon.size();
    if (size == 0)
    {
      return Forbidden;
    }
    // The ends of the common edge are the first corner and the last one of the first face.
    const std::size_t tail = Faces::Size(this->Cells.Face(edit.First)) - 1;
    const std::size_t first = edit.Diagonal;
    const std::size_t second = (first + (size == 6 ? 3 : 2)) % size;
    const bool isJoined = size == 4 && edit.Diagonal == 0;
    for (std::size_t k = 0; k < size; ++k)
    {
      const Index more =
        (!isJoined && (k == first || k == second) ? 1 : 0) - (k == 0 || k == tail ? 1 : 0);
      grown += this->Growth(polygon[k], more);
    }
    return grown - (isJoined ? 2 * PerTriangle : 0);
  }
  const Index goes = edit.First;
  const Index stays = edit.Second;
  auto more = static_cast<Index>(this->Cells.At(goes).size());
  for (const Index f : this->Cells.At(goes))
  {
    const Faces::Face& face = this->Cells.Face(f);
    const int own = PlaceOf(face, goes);
    const int other = PlaceOf(face, stays);
    if (other < 0)
    {
      continue;
    }
    const bool isTriangle = Faces::Size(face) == 3;
    const bool becomesTriangle = !isTriangle && (own + 2) % 4 != other;
    more -= becomesTriangle ? 1 : 2;
    grown += becomesTriangle ? PerTriangle : isTriangle && !this->AreTriangles ? -PerTriangle : 0;
    for (const Index w : face)
    {
      grown += w != None && w != goes && w != stays && !becomesTriangle ? this->Growth(w, -1) : 0;
    }
  }
  return grown + this->Growth(stays, more) - this->Irregularity(goes, 0);
}

std::vector<FaceEdits::Edit> FaceEdits::Find(Index v) const
{
  std::vector<Edit> edits;
  for (const Index f : this->Cells.At(v))
  {
    const Faces::Face& face = this->Cells.Face(f);
    const int size = Faces::Size(face);
    for (int c = 0; c < size; ++c)
    {
      const Index a = face[c];
      const Index b = face[(c + 1) % size];
      const Index g = this->Cells.Across(f, a, b);
      // An edge at the vertex is found from both of its faces.
      const bool isFirst = (a != v && b != v) || f < g;
      if (g != None && isFirst && !this->Cells.IsLineEdge(a, b))
      {
        const int other = Faces::Size(this->Cells.Face(g));
        const int diagonals = size + other == 6 ? 2 : size + other == 7 ? 5 : 3;
        // The first one of two triangles makes a quad of them.
        for (int diagonal = this->AreTriangles ? 1 : 0; diagonal < diagonals; ++diagonal)
        {
          edits.push_back({ f, g, diagonal });
        }
        if (size == 3 || other == 3)
        {
          edits.push_back({ a, b, None });
          edits.push_back({ b, a, None });
        }
      }
    }
    for (int c = 0; size == 4 && c < 4; ++c)
    {
      edits.push_back({ face[c], face[(c + 2) % 4], None });
    }
  }
  return edits;
}

std::vector<FaceEdits::Edit> FaceEdits::FindForBadFaces(Index v) const
{
  std::vector<Edit> edits;
  for (const Index w : this->Cells.LineEnds(v))
  {
    edits.push_back({ v, w, None });
    edits.push_back({ w, v, None });
  }
  for (const Index f : this->Cells.At(v))
  {
    const Faces::Face& face = this->Cells.Face(f);
    for (int c = 0; Faces::Size(face) == 4 && c < 4; ++c)
    {
      if (c < 2)
      {
        edits.push_back({ f, None, c });
      }
      const Index a = face[c];
      const Index b = face[(c + 1) % 4];
      const Index g = this->Cells.Across(f, a, b);
      // Find looks at the edges of triangles.
      if (g != None && (f < g || (a != v && b != v)) && Faces::Size(this->Cells.Face(g)) == 4 &&
        !this->Cells.IsLineEdge(a, b))
      {
        edits.push_back({ a, b, None });
        edits.push_back({ b, a, None });
      }
    }
  }
  return edits;
}

bool FaceEdits::IsAlongLine(Index goes, Index stays) const
{
  const std::vector<Index>& ends = this->Cells.LineEnds(goes);
  return this->Rules[goes].MayLeaveLine && ends.size() == 2 &&
    (ends[0] == stays || ends[1] == stays) && !this->Cells.IsLineEdge(ends[0], ends[1]) &&
    !this->Cells.AreJoined(ends[0], ends[1]) &&
    (!this->Places || this->Places->MayLeaveLine(goes, ends[0], ends[1]));
}

bool FaceEdits::Cut(Index f, Index diagonal)
{
  const Faces::Face face = this->Cells.Face(f);
  const Index a = face[diagonal];
  const Index b = face[diagonal + 2];
  if (this->Cells.AreJoined(a, b))
  {
    return false;
  }
  this->Cells.Set(f, { a, face[diagonal + 1], b, None });
  this->Cells.Add({ a, b, face[(diagonal + 3) % 4], None });
  return true;
}

std::vector<Index> FaceEdits::PolygonOf(Index f, Index g) const
{
  const Faces::Face& face = this->Cells.Face(f);
  const Faces::Face& other = this->Cells.Face(g);
  const int size = Faces::Size(face);
  const int otherSize = Faces::Size(other);
  for (int c = 0; c < size; ++c)
  {
    const Index tail = face[c];
    const Index head = face[(c + 1) % size];
    const int at = PlaceOf(other, tail);
    if (at < 0 || other[(at + otherSize - 1) % otherSize] != head)
    {
      continue;
    }
    // From the head through the first face to the tail, and back through the second one.
    std::vector<Index> polygon;
    polygon.reserve(size + otherSize - 2);
    for (int k = 0; k < size; ++k)
    {
      polygon.push_back(face[(c + 1 + k) % size]);
    }
    for (int k = 1; k + 1 < otherSize; ++k)
    {
      polygon.push_back(other[(at + k) % otherSize]);
    }
    for (auto corner = polygon.begin(); corner != polygon.end(); ++corner)
    {
      if (std::find(corner + 1, polygon.end(), *corner) != polygon.end())
      {
        return {};
      }
    }
    return polygon;
  }
  return {};
}

bool FaceEdits::Exchange(const Edit& edit, const std::vector<Index>& polygon)
{
  const std::size_t size = polygon.size();
  const auto at = [&](std::size_t k) { return polygon[k % size]; };
  const auto diagonal = static_cast<std::size_t>(edit.Diagonal);
  if (size == 4 && diagonal == 0)
  {
    this->Cells.Set(edit.First, { at(0), at(1), at(2), at(3) });
    this->Cells.Set(edit.Second, Nothing);
    return true;
  }
  // A diagonal that cuts off a triangle, of six corners a quad.
  const std::size_t across = size == 6 ? 3 : 2;
  if (this->Cells.AreJoined(at(diagonal), at(diagonal + across)))
  {
    return false;
  }
  this->Cells.Set(edit.First,
    { at(diagonal), at(diagonal + 1), at(diagonal + 2), size == 6 ? at(diagonal + 3) : None });
  this->Cells.Set(edit.Second,
    { at(diagonal + across), at(diagonal + across + 1),
      size == 4 ? at(diagonal) : at(diagonal + across + 2), size == 4 ? None : at(diagonal) });
  return true;
}

bool FaceEdits::Merge(Index goes, Index stays, const std::vector<Index>& around)
{
  // The vertices between the two, besides which they may have no common neighbours.
  std::vector<Index> between;
  const std::vector<Index> faces = this->Cells.At(goes);
  int common = 0;
  int beside = 0;
  for (const Index f : faces)
  {
    const Faces::Face& face = this->Cells.Face(f);
    const int size = Faces::Size(face);
    const int own = PlaceOf(face, goes);
    const int other = PlaceOf(face, stays);
    if (other < 0)
    {
      continue;
    }
    ++common;
    beside += size == 3 || (own + 2) % 4 != other ? 1 : 0;
    if (size == 3 || (own + 2) % 4 == other)
    {
      for (const Index w : face)
      {
        if (w != None && w != goes && w != stays)
        {
          between.push_back(w);
        }
      }
    }
  }
  const bool areJoined = beside > 0;
  const bool isOutside = this->Rules[goes].IsBoundary && this->Rules[stays].IsBoundary &&
    this->Cells.IsLineEdge(goes, stays) && beside == 1;
  if (common != (areJoined && !isOutside ? 2 : 1) || (areJoined && beside != common))
  {
    return false;
  }
  std::sort(between.begin(), between.end());
  const std::vector<Index> others = this->Cells.Neighbours(stays);
  std::vector<Index> both;
  std::set_intersection(
    around.begin(), around.end(), others.begin(), others.end(), std::back_inserter(both));
  if (both != between)
  {
    return false;
  }
  for (const Index f : faces)
  {
    const Faces::Face face = this->Cells.Face(f);
    Faces::Face left = Nothing;
    int size = 0;
    const bool hasBoth = PlaceOf(face, stays) >= 0;
    for (const Index w : face)
    {
      if (w != None && !(hasBoth && w == goes))
      {
        left[size++] = w == goes ? stays : w;
      }
    }
    const bool isFlat = size < 3 || (hasBoth && size == 3 && !areJoined);
    this->Cells.Set(f, isFlat ? Nothing : left);
  }
  if (this->Rules[goes].IsOnLine)
  {
    this->Cells.ShortenLine(goes, stays);
  }
  return true;
}

bool FaceEdits::Do(const Edit& edit)
{
  const std::size_t before = this->Cells.GetChanges().size();
  std::vector<Index> touched;
  bool isDone = false;
  if (edit.Diagonal != None)
  {
    if (!this->Cells.IsFace(edit.First) ||
      (edit.Second != None && !this->Cells.IsFace(edit.Second)))
    {
      return false;
    }
    if (edit.Second == None)
    {
      return Faces::Size(this->Cells.Face(edit.First)) == 4 && this->Cut(edit.First, edit.Diagonal);
    }
    touched = this->PolygonOf(edit.First, edit.Second);
    isDone = !touched.empty() && this->Exchange(edit, touched);
  }
  else
  {
    const bool mayGo = this->Rules[edit.First].IsFree || this->IsAlongLine(edit.First, edit.Second);
    if (!mayGo || this->Cells.At(edit.First).empty() || this->Cells.At(edit.Second).empty())
    {
      return false;
    }
    const std::vector<Index> around = this->Cells.Neighbours(edit.First);
    touched = around;
    touched.push_back(edit.First);
    if (!std::binary_search(around.begin(), around.end(), edit.Second))
    {
      touched.push_back(edit.Second);
    }
    isDone = this->Merge(edit.First, edit.Second, around);
  }
  const bool isGood = isDone &&
    std::all_of(touched.begin(), touched.end(),
      [&](Index v)
      {
        return this->HasEnoughFaces(v) ||
          (edit.Diagonal == None && v == edit.First && this->Cells.At(v).empty());
      });
  if (!isGood)
  {
    this->Cells.UndoTo(before);
  }
  return isGood;
}
}
