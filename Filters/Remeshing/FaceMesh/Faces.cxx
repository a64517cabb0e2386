// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaceMesh/Faces.h"

#include "Support/SortedEnds.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// The part of its wanted length that an edge may be off.
constexpr double MostOff = 0.25;
}

Vector3 MiddleOf(const std::vector<Vector3>& points, const Faces::Face& face)
{
  const int size = Faces::Size(face);
  Vector3 middle = Vector3::Zero();
  for (int c = 0; c < size; ++c)
  {
    middle += points[face[c]] / size;
  }
  return middle;
}

Vector3 AreaVector(const std::vector<Vector3>& points, const Faces::Face& face)
{
  const Vector3 u = points[face[2]] - points[face[0]];
  const Vector3 v =
    face[3] == None ? points[face[2]] - points[face[1]] : points[face[3]] - points[face[1]];
  return 0.5 * u.cross(face[3] == None ? Vector3(-(points[face[1]] - points[face[0]])) : v);
}

double AreaOf(const std::vector<Vector3>& points, const Faces::Face& face)
{
  const Vector3 a = points[face[2]] - points[face[0]];
  const Vector3& first = points[face[1]];
  const Vector3& last = Faces::Size(face) == 4 ? points[face[3]] : points[face[0]];
  return 0.5 * a.cross(last - first).norm();
}

double ScaledJacobian(const std::vector<Vector3>& points, const Faces::Face& face)
{
  const int size = Faces::Size(face);
  std::array<Vector3, 4> edge;
  std::array<double, 4> length{};
  for (int c = 0; c < size; ++c)
  {
    edge[c] = points[face[(c + 1) % size]] - points[face[c]];
    length[c] = edge[c].norm();
  }
  if (size == 3)
  {
    const double area = edge[0].cross(edge[1]).norm();
    const double longest =
      std::max({ length[0] * length[1], length[1] * length[2], length[2] * length[0] });
    return longest > 0.0 ? 2.0 / std::sqrt(3.0) * area / longest : 0.0;
  }
  // The normal at the center.
  const Vector3 normal = (edge[0] - edge[2]).cross(edge[1] - edge[3]).normalized();
  double least = 1.0;
  for (int c = 0; c < 4; ++c)
  {
    const double lengths = length[c] * length[(c + 3) % 4];
    const double jacobian = edge[(c + 3) % 4].cross(edge[c]).dot(normal);
    least = std::min(least, lengths > 0.0 ? jacobian / lengths : 0.0);
  }
  return least;
}

std::vector<std::array<Index, 2>> EdgesOf(const Faces& faces)
{
  std::vector<std::array<Index, 2>> edges;
  for (const Faces::Face& face : faces.Corners)
  {
    const int size = Faces::Size(face);
    for (int c = 0; c < size; ++c)
    {
      const Index a = face[c];
      const Index b = face[(c + 1) % size];
      edges.push_back(SortedEnds(a, b));
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

double EdgesAsWanted(
  const std::vector<Vector3>& points, const Faces& faces, const std::vector<double>& wanted)
{
  const std::vector<std::array<Index, 2>> edges = EdgesOf(faces);
  const auto isAsWanted = [&](const std::array<Index, 2>& edge)
  {
    const double wish = 0.5 * (wanted[edge[0]] + wanted[edge[1]]);
    return std::abs((points[edge[1]] - points[edge[0]]).norm() - wish) <= MostOff * wish;
  };
  return edges.empty() || wanted.empty()
    ? 1.0
    : static_cast<double>(std::count_if(edges.begin(), edges.end(), isAsWanted)) /
      static_cast<double>(edges.size());
}

int EulerCharacteristic(Index points, const Faces& faces)
{
  return static_cast<int>(points) - static_cast<int>(EdgesOf(faces).size()) +
    static_cast<int>(faces.Corners.size());
}
}
