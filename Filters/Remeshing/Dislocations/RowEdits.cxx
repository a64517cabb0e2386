// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Dislocations/RowEdits.h"

#include <algorithm>
#include <array>

namespace DirectionFields::Internal
{
namespace
{
/// The part of the way to the vertex beside at which a new vertex is.
constexpr double FirstPart = 1.0 / 3.0;

class Editor
{
public:
  Editor(const EdgeLoops& chains, FaceMesh& mesh)
    : Chains(chains)
    , Mesh(mesh)
    , Copies(mesh.Points.size(), { None, None })
    , Sides(mesh.Points.size(), { None, None })
    , Merged(mesh.Points.size(), None)
    , Goes(mesh.Cells.Corners.size(), 0)
  {
  }

  void Insert(const RowEdit& edit)
  {
    this->ForInner(edit,
      [&](Index h, Index v)
      {
        this->Sides[v] = this->Chains.Beside(h, v);
        for (int side = 0; side < 2; ++side)
        {
          this->Copies[v][side] = this->Copy(v, this->Sides[v][side]);
        }
      });
    for (const Index h : edit.HalfEdges)
    {
      const std::array<Index, 2> faces = { h / 4, this->Chains.Twin(h) / 4 };
      const std::array<Index, 2> ends = { this->Chains.Tail(h), this->Chains.Head(h) };
      for (int side = 0; side < 2; ++side)
      {
        this->Redirected.push_back({ faces[side], side, ends });
      }
      const auto [tail, head] = ends;
      const auto [tailLeft, tailRight] = this->Copies[tail];
      const auto [headLeft, headRight] = this->Copies[head];
      if (tailLeft == None)
      {
        this->Added.push_back({ tail, headRight, head, headLeft });
      }
      else if (headLeft == None)
      {
        this->Added.push_back({ tail, tailRight, head, tailLeft });
      }
      else
      {
        this->Added.push_back({ tail, head, headLeft, tailLeft });
        this->Added.push_back({ tailRight, headRight, head, tail });
      }
    }
  }

  void Remove(const RowEdit& edit)
  {
    this->ForInner(edit,
      [&](Index h, Index v)
      {
        for (const Index w : this->Chains.Beside(h, v))
        {
          this->Merged[w] = v;
        }
      });
    for (const Index h : edit.HalfEdges)
    {
      const Index twin = this->Chains.Twin(h);
      this->Goes[h / 4] = this->Goes[twin / 4] = 1;
      const bool begins = !edit.BeginsAtBoundary && h == edit.HalfEdges.front();
      const bool ends = !edit.EndsAtBoundary && h == edit.HalfEdges.back();
      if (begins)
      {
        // The corners before the tail in the face on the left, and after it on the right.
        this->Added.push_back({ this->Chains.Tail(h), this->Chains.Head(this->Chains.Next(twin)),
          this->Chains.Head(h), this->Chains.Tail(this->Chains.Previous(h)) });
      }
      else if (ends)
      {
        this->Added.push_back(
          { this->Chains.Tail(h), this->Chains.Tail(this->Chains.Previous(twin)),
            this->Chains.Head(h), this->Chains.Head(this->Chains.Next(h)) });
      }
    }
  }

  void Finish()
  {
    for (const auto& [face, side, ends] : this->Redirected)
    {
      for (Index& v : this->Mesh.Cells.Corners[face])
      {
        const bool isEnd = v != None && (v == ends[0] || v == ends[1]);
        v = isEnd && this->CopyOf(v, side) != None ? this->CopyOf(v, side) : v;
      }
      this->Mesh.Cells.IsRegular[face] = 0;
    }
    this->Redirect();
    std::vector<Index> number(this->Mesh.Points.size(), None);
    Index left = 0;
    for (std::size_t v = 0; v < number.size(); ++v)
    {
      if (v >= this->Merged.size() || this->Merged[v] == None)
      {
        number[v] = left;
        this->Mesh.Points[left] = this->Mesh.Points[v];
        this->Mesh.Vertices[left] = this->Mesh.Vertices[v];
        ++left;
      }
    }
    this->Mesh.Points.resize(left);
    this->Mesh.Vertices.resize(left);
    const auto after = [&](Index v)
    {
      const bool isMerged = v < static_cast<Index>(this->Merged.size()) && this->Merged[v] != None;
      return number[isMerged ? this->Merged[v] : v];
    };
    this->Renumber(after);
  }

private:
  struct RedirectedFace
  {
    Index Face;
    int Side;
    std::array<Index, 2> Ends;
  };

  template <typename Visit>
  void ForInner(const RowEdit& edit, const Visit& visit) const
  {
    for (std::size_t k = 0; k < edit.HalfEdges.size(); ++k)
    {
      const Index h = edit.HalfEdges[k];
      if (k == 0 && edit.BeginsAtBoundary)
      {
        visit(h, this->Chains.Tail(h));
      }
      if (k + 1 < edit.HalfEdges.size() || edit.EndsAtBoundary)
      {
        visit(h, this->Chains.Head(h));
      }
    }
  }

  Index CopyOf(Index v, int side) const
  {
    return v < static_cast<Index>(this->Copies.size()) ? this->Copies[v][side] : None;
  }

  Index Copy(Index v, Index beside)
  {
    const Vector3 place =
      (1.0 - FirstPart) * this->Mesh.Points[v] + FirstPart * this->Mesh.Points[beside];
    FaceMesh::Vertex vertex;
    vertex.Line = this->Mesh.Vertices[v].Line;
    vertex.IsBoundary = this->Mesh.Vertices[v].IsBoundary;
    this->Mesh.Points.push_back(place);
    this->Mesh.Vertices.push_back(vertex);
    return static_cast<Index>(this->Mesh.Points.size()) - 1;
  }

  /// Edges of lines at divided vertices go to their copies.
  void Redirect()
  {
    const std::size_t count = this->Mesh.LineEdges.size();
    for (std::size_t k = 0; k < count; ++k)
    {
      for (int end = 0; end < 2; ++end)
      {
        const FaceMesh::LineEdge edge = this->Mesh.LineEdges[k];
        const Index v = edge.Ends[end];
        for (int side = 0; side < 2; ++side)
        {
          if (this->CopyOf(v, side) != None && this->Sides[v][side] == edge.Ends[1 - end])
          {
            this->Mesh.LineEdges[k].Ends[end] = this->Copies[v][side];
            this->Mesh.LineEdges.push_back({ { v, this->Copies[v][side] }, edge.Line });
          }
        }
      }
    }
  }

  template <typename After>
  void Renumber(const After& after)
  {
    Faces cells;
    const auto take = [&](const Faces::Face& face, char isRegular)
    {
      cells.Corners.push_back(face);
      for (Index& v : cells.Corners.back())
      {
        v = v == None ? None : after(v);
      }
      cells.IsRegular.push_back(isRegular);
    };
    for (std::size_t f = 0; f < this->Mesh.Cells.Corners.size(); ++f)
    {
      if (this->Goes[f] == 0)
      {
        take(this->Mesh.Cells.Corners[f], this->Mesh.Cells.IsRegular[f]);
      }
    }
    for (const Faces::Face& face : this->Added)
    {
      take(face, 0);
    }
    this->Mesh.Cells = std::move(cells);
    std::vector<FaceMesh::LineEdge> lines;
    for (const FaceMesh::LineEdge& edge : this->Mesh.LineEdges)
    {
      const std::array<Index, 2> ends = { after(edge.Ends[0]), after(edge.Ends[1]) };
      if (ends[0] != ends[1])
      {
        lines.push_back({ ends, edge.Line });
      }
    }
    this->Mesh.LineEdges = std::move(lines);
  }

  const EdgeLoops& Chains;
  FaceMesh& Mesh;
  /// Of each divided vertex those on its left and right, and what was there before.
  std::vector<std::array<Index, 2>> Copies;
  std::vector<std::array<Index, 2>> Sides;
  /// The vertex that a vertex becomes.
  std::vector<Index> Merged;
  std::vector<char> Goes;
  std::vector<RedirectedFace> Redirected;
  std::vector<Faces::Face> Added;
};
}

bool MayMerge(const EdgeLoops& chains, const FaceMesh& mesh, Index h, Index v)
{
  const std::array<Index, 2> beside = chains.Beside(h, v);
  return std::all_of(beside.begin(), beside.end(),
    [&](Index w)
    {
      return mesh.Vertices[w].Line == mesh.Vertices[v].Line &&
        (chains.IsMouth(v) ? chains.IsMouth(w) : chains.IsRegular(w));
    });
}

void Apply(const std::vector<RowEdit>& edits, const EdgeLoops& chains, FaceMesh& mesh)
{
  Editor editor(chains, mesh);
  for (const RowEdit& edit : edits)
  {
    if (edit.Inserts)
    {
      editor.Insert(edit);
    }
    else
    {
      editor.Remove(edit);
    }
  }
  editor.Finish();
}
}
