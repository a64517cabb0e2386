// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaceMesh/VertexStars.h"

#include <algorithm>
#include <iterator>

namespace DirectionFields::Internal
{
VertexStars::VertexStars(
  const Faces& faces, Index vertices, const std::vector<FaceMesh::LineEdge>& lines)
  : Cells(faces)
  , Stars(vertices)
  , Lines(vertices)
{
  for (Index f = 0; f < this->GetNumberOfFaces(); ++f)
  {
    for (int c = 0; c < Faces::Size(faces.Corners[f]); ++c)
    {
      this->Stars[faces.Corners[f][c]].push_back(f);
    }
  }
  for (const FaceMesh::LineEdge& edge : lines)
  {
    // Where sheets meet, an edge is one of each of them.
    if (!this->IsLineEdge(edge.Ends[0], edge.Ends[1]))
    {
      Insert(this->Lines[edge.Ends[0]], edge.Ends[1]);
      Insert(this->Lines[edge.Ends[1]], edge.Ends[0]);
    }
  }
}

void VertexStars::Insert(std::vector<Index>& sorted, Index item)
{
  sorted.insert(std::lower_bound(sorted.begin(), sorted.end(), item), item);
}

void VertexStars::Erase(std::vector<Index>& sorted, Index item)
{
  sorted.erase(std::lower_bound(sorted.begin(), sorted.end(), item));
}

bool VertexStars::IsLineEdge(Index v, Index w) const
{
  return std::binary_search(this->Lines[v].begin(), this->Lines[v].end(), w);
}

std::vector<Index> VertexStars::Neighbours(Index v) const
{
  std::vector<Index> all;
  for (const Index f : this->Stars[v])
  {
    const Faces::Face& face = this->Cells.Corners[f];
    const int size = Faces::Size(face);
    const auto at = static_cast<int>(std::find(face.begin(), face.end(), v) - face.begin());
    all.push_back(face[(at + 1) % size]);
    all.push_back(face[(at + size - 1) % size]);
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

bool VertexStars::AreJoined(Index v, Index w) const
{
  return this->Across(None, v, w) != None;
}

Index VertexStars::Across(Index f, Index v, Index w) const
{
  for (const Index g : this->Stars[v])
  {
    const Faces::Face& face = this->Cells.Corners[g];
    const int size = Faces::Size(face);
    for (int c = 0; g != f && c < size; ++c)
    {
      const Index a = face[c];
      const Index b = face[(c + 1) % size];
      if ((a == v && b == w) || (a == w && b == v))
      {
        return g;
      }
    }
  }
  return None;
}

void VertexStars::Put(Index f, const Faces::Face& corners)
{
  for (const Index v : this->Cells.Corners[f])
  {
    if (v != None)
    {
      Erase(this->Stars[v], f);
    }
  }
  this->Cells.Corners[f] = corners;
  for (const Index v : corners)
  {
    if (v != None)
    {
      Insert(this->Stars[v], f);
    }
  }
}

std::vector<Index> VertexStars::TouchedSince(std::size_t changes) const
{
  std::vector<Index> touched;
  const auto add = [&](const Faces::Face& face)
  {
    std::copy_if(
      face.begin(), face.end(), std::back_inserter(touched), [](Index v) { return v != None; });
  };
  for (std::size_t k = changes; k < this->Changes.size(); ++k)
  {
    add(this->Changes[k].Corners);
    if (this->Changes[k].Face != None)
    {
      add(this->Cells.Corners[this->Changes[k].Face]);
    }
  }
  std::sort(touched.begin(), touched.end());
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  return touched;
}

void VertexStars::Set(Index f, const Faces::Face& corners)
{
  this->Changes.push_back({ f, this->Cells.Corners[f], this->Cells.IsRegular[f] });
  this->Put(f, corners);
  this->Cells.IsRegular[f] = 0;
}

void VertexStars::Add(const Faces::Face& corners)
{
  this->Cells.Corners.push_back({ None, None, None, None });
  this->Cells.IsRegular.push_back(0);
  this->Set(this->GetNumberOfFaces() - 1, corners);
}

void VertexStars::ShortenLine(Index goes, Index stays)
{
  const std::vector<Index> ends = this->Lines[goes];
  const Index other = ends[ends[0] == stays ? 1 : 0];
  this->Changes.push_back({ None, { goes, stays, other, None }, 0 });
  this->Lines[goes].clear();
  Erase(this->Lines[stays], goes);
  Erase(this->Lines[other], goes);
  Insert(this->Lines[stays], other);
  Insert(this->Lines[other], stays);
}

void VertexStars::UndoTo(std::size_t changes)
{
  while (this->Changes.size() > changes)
  {
    const Change change = this->Changes.back();
    this->Changes.pop_back();
    if (change.Face == None)
    {
      const auto [goes, stays, other, none] = change.Corners;
      this->Lines[goes] = { std::min(stays, other), std::max(stays, other) };
      Erase(this->Lines[stays], other);
      Erase(this->Lines[other], stays);
      Insert(this->Lines[stays], goes);
      Insert(this->Lines[other], goes);
      continue;
    }
    this->Put(change.Face, change.Corners);
    this->Cells.IsRegular[change.Face] = change.IsRegular;
  }
}

Faces VertexStars::Compressed() const
{
  Faces left;
  for (Index f = 0; f < this->GetNumberOfFaces(); ++f)
  {
    if (this->IsFace(f))
    {
      left.Corners.push_back(this->Cells.Corners[f]);
      left.IsRegular.push_back(this->Cells.IsRegular[f]);
    }
  }
  return left;
}
}
