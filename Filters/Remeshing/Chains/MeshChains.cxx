// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Chains/MeshChains.h"

#include "Support/SortedEnds.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// Middles of chains that are closer along an axis than this part of the mesh's extent have the
/// same place there: finer and coarser meshes move them by less.
constexpr double PerStep = 1.0 / 50.0;

/// The cosine of the least turn of a chain at a corner, 20 degrees.
constexpr double StraightOn = 0.9397;

/// What an edge is.
struct Mark
{
  ChainKind Kind;
  Index Curve;
  std::array<Index, 2> Regions;
  /// Whether the second region, or the face at the boundary, is left of the way from the higher
  /// vertex to the lower one.
  bool IsDown;

  friend bool operator==(const Mark& a, const Mark& b)
  {
    return a.Kind == b.Kind && a.Curve == b.Curve && a.Regions == b.Regions;
  }
};

using Ends = std::array<Index, 2>;

/// An edge of a face, which is left of the way to the higher vertex or to the lower one.
struct FaceEdge
{
  Ends Vertices;
  Index Face;
  bool IsDown;

  friend bool operator<(const FaceEdge& a, const FaceEdge& b)
  {
    return std::tie(a.Vertices, a.Face) < std::tie(b.Vertices, b.Face);
  }
};

/// The edges of all faces, those of the same vertices one after the other.
std::vector<FaceEdge> EdgesOfFaces(const Faces& faces)
{
  std::vector<FaceEdge> edges;
  for (std::size_t f = 0; f < faces.Corners.size(); ++f)
  {
    const Faces::Face& face = faces.Corners[f];
    const int size = Faces::Size(face);
    for (int c = 0; c < size; ++c)
    {
      const Index v = face[c];
      const Index w = face[(c + 1) % size];
      edges.push_back({ SortedEnds(v, w), static_cast<Index>(f), v > w });
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// The lines of a mesh that are no seams, and their curves.
std::map<Ends, Index> LinesOf(
  const FaceMesh& mesh, const std::vector<char>& isSeam, const std::vector<Index>& curves)
{
  std::map<Ends, Index> lines;
  for (std::size_t k = 0; k < mesh.LineEdges.size(); ++k)
  {
    const FaceMesh::LineEdge& edge = mesh.LineEdges[k];
    if (edge.Line > 0 && isSeam[edge.Line] == 0)
    {
      lines.emplace(SortedEnds(edge.Ends[0], edge.Ends[1]), curves.empty() ? None : curves[k]);
    }
  }
  return lines;
}

/// The mark of an edge from the faces at it.
std::optional<Mark> MarkOf(const FaceEdge* begin, const FaceEdge* end,
  const std::map<Ends, Index>& lines, const std::vector<Index>& regions)
{
  const auto regionOf = [&](const FaceEdge& edge)
  { return regions.empty() ? None : regions[edge.Face]; };
  std::set<Index> beside;
  for (const FaceEdge* edge = begin; edge != end; ++edge)
  {
    beside.insert(regionOf(*edge));
  }
  const auto line = lines.find(begin->Vertices);
  const Index curve = line == lines.end() ? None : line->second;
  const Index first = *beside.begin();
  if (end - begin == 1)
  {
    return Mark{ ChainKind::Boundary, curve, { None, first }, begin->IsDown };
  }
  if (beside.size() > 1)
  {
    const Index second = *std::next(beside.begin());
    const FaceEdge* left =
      std::find_if(begin, end, [&](const FaceEdge& edge) { return regionOf(edge) == second; });
    return Mark{ ChainKind::Border, curve, { first, second }, left->IsDown };
  }
  if (curve != None)
  {
    return Mark{ ChainKind::Curve, curve, { first, first }, false };
  }
  if (line != lines.end() || end - begin > 2)
  {
    return Mark{ ChainKind::Feature, curve, { first, first }, false };
  }
  return std::nullopt;
}

/// The edges that chains are made of.
struct MarkedEdges
{
  std::map<Ends, Mark> Marks;
  /// Where they lead to from each vertex, ascending.
  std::vector<std::vector<Index>> Next;

  MarkedEdges(const FaceMesh& mesh, const std::vector<char>& isSeam,
    const std::vector<Index>& curves, const std::vector<Index>& regions)
    : Next(mesh.Points.size())
  {
    const std::map<Ends, Index> lines = LinesOf(mesh, isSeam, curves);
    const std::vector<FaceEdge> edges = EdgesOfFaces(mesh.Cells);
    for (std::size_t i = 0, end = 0; i < edges.size(); i = end)
    {
      const Ends& ends = edges[i].Vertices;
      while (end < edges.size() && edges[end].Vertices == ends)
      {
        ++end;
      }
      const std::optional<Mark> mark = MarkOf(&edges[i], edges.data() + end, lines, regions);
      if (mark)
      {
        this->Next[ends[0]].push_back(ends[1]);
        this->Next[ends[1]].push_back(ends[0]);
        this->Marks.emplace(ends, *mark);
      }
    }
  }

  const Mark& At(Index v, Index w) const { return this->Marks.at(SortedEnds(v, w)); }

  /// Whether chains end at a vertex. Not all that do not move turn: of components that could not be
  /// remeshed none moves.
  bool IsEnd(const FaceMesh& mesh, Index v) const
  {
    const std::vector<Index>& next = this->Next[v];
    if (next.size() != 2 || !(this->At(v, next[0]) == this->At(v, next[1])))
    {
      return true;
    }
    const Vector3 in = (mesh.Points[v] - mesh.Points[next[0]]).stableNormalized();
    const Vector3 out = (mesh.Points[next[1]] - mesh.Points[v]).stableNormalized();
    return mesh.Vertices[v].Line < 0 && in.dot(out) < StraightOn;
  }
};

/// The chain that begins with an edge, all of whose edges are taken out of those left.
MeshChain Follow(
  const FaceMesh& mesh, const MarkedEdges& edges, Index from, Index to, std::set<Ends>& left)
{
  const Mark& mark = edges.At(from, to);
  MeshChain chain{ mark.Kind, { from, to }, mark.Regions, {}, mark.Curve };
  const bool isAgainst = mark.IsDown == (from < to);
  left.erase(SortedEnds(from, to));
  while (!edges.IsEnd(mesh, to) && to != chain.Points.front())
  {
    const std::vector<Index>& next = edges.Next[to];
    const Index beyond = next[0] == from ? next[1] : next[0];
    from = std::exchange(to, beyond);
    left.erase(SortedEnds(from, to));
    chain.Points.push_back(to);
  }
  if (isAgainst)
  {
    std::reverse(chain.Points.begin(), chain.Points.end());
  }
  return chain;
}

/// The middle of a chain's length.
Vector3 MiddleOf(const FaceMesh& mesh, const MeshChain& chain)
{
  Vector3 sum = Vector3::Zero();
  double length = 0.0;
  for (std::size_t i = 1; i < chain.Points.size(); ++i)
  {
    const Vector3& a = mesh.Points[chain.Points[i - 1]];
    const Vector3& b = mesh.Points[chain.Points[i]];
    const double own = (b - a).norm();
    sum += own * 0.5 * (a + b);
    length += own;
  }
  return length > 0.0 ? Vector3(sum / length) : mesh.Points[chain.Points[0]];
}

void Sort(const FaceMesh& mesh, std::vector<MeshChain>& chains)
{
  Vector3 least = mesh.Points.empty() ? Vector3(0.0, 0.0, 0.0) : mesh.Points[0];
  Vector3 most = least;
  for (const Vector3& point : mesh.Points)
  {
    least = least.cwiseMin(point);
    most = most.cwiseMax(point);
  }
  const double step = std::max((most - least).norm() * PerStep, std::numeric_limits<double>::min());
  using Key =
    std::tuple<ChainKind, Index, std::array<Index, 2>, std::array<double, 3>, std::size_t>;
  std::vector<Key> keys;
  for (const MeshChain& chain : chains)
  {
    const Vector3 middle = (MiddleOf(mesh, chain) - least) / step;
    const bool isCurve = chain.Kind == ChainKind::Curve;
    keys.emplace_back(chain.Kind, isCurve ? chain.Source : None, chain.Regions,
      std::array<double, 3>{
        std::round(middle.x()), std::round(middle.y()), std::round(middle.z()) },
      keys.size());
  }
  std::sort(keys.begin(), keys.end());
  std::vector<MeshChain> sorted;
  for (const Key& key : keys)
  {
    sorted.push_back(std::move(chains[std::get<4>(key)]));
  }
  chains = std::move(sorted);
}

std::string NameOfRegion(Index region, const std::vector<std::string>& names)
{
  std::string name = names.empty() ? std::to_string(region) : names[region];
  const bool isQuoted = name.size() > 1 && name.front() == '"' && name.back() == '"';
  return isQuoted ? name.substr(1, name.size() - 2) : name;
}

void Name(const std::vector<std::string>& names, std::vector<MeshChain>& chains)
{
  std::map<std::string, int> count;
  for (MeshChain& chain : chains)
  {
    chain.Name = chain.Kind == ChainKind::Boundary ? "Boundary"
      : chain.Kind == ChainKind::Border            ? "Border"
      : chain.Kind == ChainKind::Curve             ? "Curve " + std::to_string(chain.Source)
                                                   : "Feature";
    std::string between = " ";
    for (const Index region : std::set<Index>(chain.Regions.begin(), chain.Regions.end()))
    {
      if (region != None)
      {
        chain.Name += std::exchange(between, "/") + NameOfRegion(region, names);
      }
    }
    chain.Name += " " + std::to_string(++count[chain.Name]);
  }
}
}

std::vector<char> LinesOfBoundary(const TriangleMesh& mesh, const FeatureLines& features)
{
  std::vector<char> isBoundary = { 0 };
  for (const FeatureLines::Chain& chain : features.Chains)
  {
    isBoundary.push_back(mesh.Twin(chain.Steps.front().HalfEdge) == None ? 1 : 0);
  }
  return isBoundary;
}

std::vector<MeshChain> FindChains(const FaceMesh& mesh, const std::vector<char>& isSeam,
  const std::vector<Index>& curves, const std::vector<Index>& regions,
  const std::vector<std::string>& names)
{
  const MarkedEdges edges(mesh, isSeam, curves, regions);
  std::set<Ends> left;
  for (const auto& edge : edges.Marks)
  {
    left.insert(edge.first);
  }
  std::vector<MeshChain> chains;
  for (const bool atEnds : { true, false })
  {
    for (Index v = 0; v < static_cast<Index>(edges.Next.size()); ++v)
    {
      for (const Index w : edges.Next[v])
      {
        if (edges.IsEnd(mesh, v) == atEnds && left.count(SortedEnds(v, w)) > 0)
        {
          chains.push_back(Follow(mesh, edges, v, w, left));
        }
      }
    }
  }
  Sort(mesh, chains);
  Name(names, chains);
  return chains;
}
}
