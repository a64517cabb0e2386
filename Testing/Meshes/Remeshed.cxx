// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshed.h"

#include "Quality/FaceQuality.h"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

namespace Meshes
{
using namespace DirectionFields;

namespace
{
using Face = std::array<Index, 4>;

int SizeOf(const Face& face)
{
  return face[3] == None ? 3 : 4;
}

int LoopsOf(const std::vector<Face>& faces)
{
  std::set<std::array<Index, 2>> halfEdges;
  for (const Face& face : faces)
  {
    for (int c = 0; c < SizeOf(face); ++c)
    {
      halfEdges.insert({ face[c], face[(c + 1) % SizeOf(face)] });
    }
  }
  std::map<Index, Index> next;
  for (const std::array<Index, 2>& edge : halfEdges)
  {
    if (halfEdges.count({ edge[1], edge[0] }) == 0)
    {
      next[edge[1]] = edge[0];
    }
  }
  int loops = 0;
  while (!next.empty())
  {
    ++loops;
    for (auto at = next.begin(); at != next.end();)
    {
      const Index v = at->second;
      next.erase(at);
      at = next.find(v);
    }
  }
  return loops;
}

/// Whether the faces at each vertex are one fan: as many as can be reached from the first one.
bool HasFans(const std::vector<Face>& faces, std::size_t points)
{
  // Counter-clockwise around a vertex: from the neighbour before to that after.
  std::vector<std::map<Index, Index>> turn(points);
  for (const Face& face : faces)
  {
    const int size = SizeOf(face);
    for (int c = 0; c < size; ++c)
    {
      turn[face[c]][face[(c + 1) % size]] = face[(c + size - 1) % size];
    }
  }
  for (const std::map<Index, Index>& around : turn)
  {
    std::set<Index> targets;
    for (const auto& [from, to] : around)
    {
      targets.insert(to);
    }
    Index start = around.empty() ? None : around.begin()->first;
    for (const auto& [from, to] : around)
    {
      start = targets.count(from) == 0 ? from : start;
    }
    std::size_t count = 0;
    auto at = around.find(start);
    while (at != around.end() && count <= around.size())
    {
      ++count;
      at = at->second == start ? around.end() : around.find(at->second);
    }
    if (count != around.size())
    {
      return false;
    }
  }
  return true;
}
}

std::string FlawOf(const RemeshResult& mesh)
{
  const std::size_t points = mesh.Points.size();
  if (mesh.Kind.size() != points || mesh.FieldIndex.size() != points ||
    mesh.SourceTriangle.size() != points || mesh.SourceWeights.size() != points ||
    mesh.Regular.size() != mesh.Faces.size() || mesh.FaceSource.size() != mesh.Faces.size())
  {
    return "sizes of the arrays";
  }
  std::set<std::array<Index, 2>> halfEdges;
  std::vector<int> facesAt(points, 0);
  for (const Face& face : mesh.Faces)
  {
    for (int c = 0; c < SizeOf(face); ++c)
    {
      if (face[c] < 0 || face[c] >= static_cast<Index>(points))
      {
        return "ids of points";
      }
      ++facesAt[face[c]];
      if (face[c] == face[(c + 1) % SizeOf(face)] ||
        !halfEdges.insert({ face[c], face[(c + 1) % SizeOf(face)] }).second)
      {
        return "an edge runs twice in one direction";
      }
    }
  }
  std::vector<char> isBoundary(points, 0);
  int edges = 0;
  for (const std::array<Index, 2>& edge : halfEdges)
  {
    const bool isInside = halfEdges.count({ edge[1], edge[0] }) != 0;
    edges += !isInside || edge[0] < edge[1] ? 1 : 0;
    if (!isInside)
    {
      isBoundary[edge[0]] = isBoundary[edge[1]] = 1;
    }
  }
  int sum = 0;
  for (std::size_t v = 0; v < points; ++v)
  {
    if (!mesh.Points[v].allFinite())
    {
      return "points that are not finite";
    }
    if (facesAt[v] == 0)
    {
      return "points without faces";
    }
    sum += isBoundary[v] != 0 ? 2 - facesAt[v] : 4 - facesAt[v];
  }
  for (const Face& face : mesh.Faces)
  {
    sum += 4 - SizeOf(face);
  }
  if (!HasFans(mesh.Faces, points))
  {
    return "vertices between several fans";
  }
  const int chi = static_cast<int>(points) - edges + static_cast<int>(mesh.Faces.size());
  if (chi != mesh.EulerCharacteristicBefore || chi != mesh.EulerCharacteristicAfter)
  {
    return "Euler characteristic";
  }
  if (sum != 4 * chi)
  {
    return "sum of the valences";
  }
  return "";
}

double LeastQuality(const RemeshResult& mesh)
{
  double least = 1.0;
  for (const double quality : QualityOf(mesh.Points, mesh.Faces).ScaledJacobian)
  {
    least = std::min(least, quality);
  }
  return least;
}

int CountBoundaryLoops(const RemeshResult& mesh)
{
  return LoopsOf(mesh.Faces);
}

int CountBoundaryLoops(const Surface& surface)
{
  std::vector<Face> faces;
  for (const Triangle& t : surface.Triangles)
  {
    faces.push_back({ t[0], t[1], t[2], None });
  }
  return LoopsOf(faces);
}
}
