// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Faces/FaceStars.h"

#include <algorithm>

namespace DirectionFields::Internal
{
FaceStars::FaceStars(const Faces& faces, Index vertices)
  : Cells(faces)
  , Stars(vertices)
{
  for (Index f = 0; f < this->GetNumberOfFaces(); ++f)
  {
    for (int c = 0; c < Faces::Size(faces.Corners[f]); ++c)
    {
      this->Stars[faces.Corners[f][c]].push_back(f);
    }
  }
}

std::vector<Index> FaceStars::Neighbours(Index v) const
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

bool FaceStars::AreJoined(Index v, Index w) const
{
  return this->Across(None, v, w) != None;
}

Index FaceStars::Across(Index f, Index v, Index w) const
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

void FaceStars::Put(Index f, const Faces::Face& corners)
{
  for (const Index v : this->Cells.Corners[f])
  {
    if (v != None)
    {
      std::vector<Index>& star = this->Stars[v];
      star.erase(std::lower_bound(star.begin(), star.end(), f));
    }
  }
  this->Cells.Corners[f] = corners;
  for (const Index v : corners)
  {
    if (v != None)
    {
      std::vector<Index>& star = this->Stars[v];
      star.insert(std::lower_bound(star.begin(), star.end(), f), f);
    }
  }
}

void FaceStars::Set(Index f, const Faces::Face& corners)
{
  this->Changes.push_back({ f, this->Cells.Corners[f], this->Cells.IsRegular[f] });
  this->Put(f, corners);
  this->Cells.IsRegular[f] = 0;
}

void FaceStars::UndoTo(std::size_t changes)
{
  while (this->Changes.size() > changes)
  {
    const Change change = this->Changes.back();
    this->Changes.pop_back();
    this->Put(change.Face, change.Corners);
    this->Cells.IsRegular[change.Face] = change.IsRegular;
  }
}

Faces FaceStars::Compressed() const
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
