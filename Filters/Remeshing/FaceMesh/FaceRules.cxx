// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaceMesh/FaceRules.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// The angle of a face at one of its corners.
double AngleAt(const std::vector<Vector3>& points, const Faces::Face& face, Index v)
{
  const int size = Faces::Size(face);
  const auto at = static_cast<int>(std::find(face.begin(), face.end(), v) - face.begin());
  const Vector3 a = points[face[(at + 1) % size]] - points[v];
  const Vector3 b = points[face[(at + size - 1) % size]] - points[v];
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// The wanted number of faces at a vertex on lines: the number for which there is room in each
/// sector between them.
Index FacesBetweenLines(
  const VertexStars& faces, const std::vector<Vector3>& points, Index v, int degree)
{
  const std::vector<Index>& star = faces.At(v);
  std::vector<char> isSeen(star.size(), 0);
  Index sum = 0;
  for (std::size_t i = 0; i < star.size(); ++i)
  {
    if (isSeen[i] != 0)
    {
      continue;
    }
    double angle = 0.0;
    std::vector<std::size_t> sector = { i };
    isSeen[i] = 1;
    for (std::size_t k = 0; k < sector.size(); ++k)
    {
      const Index f = star[sector[k]];
      angle += AngleAt(points, faces.Face(f), v);
      const Faces::Face& face = faces.Face(f);
      const int size = Faces::Size(face);
      const auto at = static_cast<int>(std::find(face.begin(), face.end(), v) - face.begin());
      for (const Index w : { face[(at + 1) % size], face[(at + size - 1) % size] })
      {
        const Index g = faces.IsLineEdge(v, w) ? None : faces.Across(f, v, w);
        const auto next = std::lower_bound(star.begin(), star.end(), g);
        if (g != None && isSeen[next - star.begin()] == 0)
        {
          isSeen[next - star.begin()] = 1;
          sector.push_back(next - star.begin());
        }
      }
    }
    sum += std::max<Index>(1, static_cast<Index>(std::lround(angle * degree / (2.0 * Pi))));
  }
  return sum;
}
}

std::vector<FaceEdits::Rule> RulesFor(const VertexStars& faces, const MovableFaces& places,
  const std::vector<FaceMesh::Vertex>& vertices, int degree)
{
  std::vector<FaceEdits::Rule> rules(faces.GetNumberOfVertices());
  for (Index v = 0; v < faces.GetNumberOfVertices(); ++v)
  {
    FaceEdits::Rule& rule = rules[v];
    const int index = vertices[v].SingularityIndex;
    rule.IsBoundary = vertices[v].IsBoundary;
    rule.IsOnLine = rule.IsBoundary || !places.IsOnSurface(v);
    rule.IsLocked =
      !rule.IsOnLine && index != 0 && static_cast<Index>(faces.At(v).size()) == degree - index;
    rule.IsFree = !rule.IsOnLine && !rule.IsLocked;
    rule.MayLeaveLine = !places.IsOnSurface(v) && places.IsFree(v);
    rule.Target = rule.IsLocked ? degree - index : degree;
  }
  for (Index v = 0; v < faces.GetNumberOfVertices(); ++v)
  {
    if (rules[v].IsOnLine && !faces.At(v).empty())
    {
      rules[v].Target = FacesBetweenLines(faces, places.GetPoints(), v, degree);
    }
  }
  return rules;
}

std::vector<FaceEdits::Rule> WithoutLocks(std::vector<FaceEdits::Rule> rules)
{
  for (FaceEdits::Rule& rule : rules)
  {
    rule.IsFree = rule.IsFree || rule.IsLocked;
    rule.IsLocked = false;
  }
  return rules;
}

std::vector<char> FindVerticesNearHubs(const VertexStars& faces, const MovableFaces& places)
{
  std::vector<char> isNear(faces.GetNumberOfVertices(), 0);
  std::vector<Index> hubs;
  for (Index v = 0; v < faces.GetNumberOfVertices(); ++v)
  {
    if (places.IsHub(v))
    {
      hubs.push_back(v);
    }
  }
  // An edit at a vertex changes faces that are two faces away.
  constexpr int rings = 3;
  for (int k = 0; k < rings && !hubs.empty(); ++k)
  {
    std::vector<Index> next;
    for (const Index v : hubs)
    {
      for (const Index f : faces.At(v))
      {
        for (const Index w : faces.Face(f))
        {
          if (w != None && isNear[w] == 0)
          {
            isNear[w] = 1;
            next.push_back(w);
          }
        }
      }
    }
    hubs = std::move(next);
  }
  return isNear;
}
}
