// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Reports/RemeshReports.h"

#include "Support/Sentences.h"
#include "Support/SortedEnds.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace DirectionFields
{
namespace
{
int SizeOf(const std::array<Index, 4>& face)
{
  return face[3] == None ? 3 : 4;
}

/// The number of edges at each point, and whether it is on the boundary.
struct Valences
{
  explicit Valences(const RemeshResult& mesh)
    : Edges(mesh.Points.size(), 0)
    , IsBoundary(mesh.Points.size(), 0)
  {
    // An edge of one face only has its ends on the boundary.
    std::vector<std::array<Index, 2>> edges;
    for (const std::array<Index, 4>& face : mesh.Faces)
    {
      for (int c = 0; c < SizeOf(face); ++c)
      {
        const Index a = face[c];
        const Index b = face[(c + 1) % SizeOf(face)];
        edges.push_back(SortedEnds(a, b));
      }
    }
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 0; i < edges.size();)
    {
      std::size_t end = i;
      while (end < edges.size() && edges[end] == edges[i])
      {
        ++end;
      }
      for (const Index v : edges[i])
      {
        ++this->Edges[v];
        this->IsBoundary[v] = this->IsBoundary[v] != 0 || end - i == 1 ? 1 : 0;
      }
      i = end;
    }
  }

  std::vector<int> Edges;
  std::vector<char> IsBoundary;
};

}

std::vector<IrregularVertex> IrregularVertices(const RemeshResult& mesh, int degree)
{
  const Valences valences(mesh);
  std::vector<IrregularVertex> irregular;
  for (std::size_t v = 0; v < mesh.Points.size(); ++v)
  {
    if (valences.IsBoundary[v] == 0 && valences.Edges[v] != degree)
    {
      irregular.push_back({ static_cast<Index>(v), valences.Edges[v] });
    }
  }
  return irregular;
}

namespace
{
std::string AboutRegions(const RemeshResult& mesh)
{
  const RegionFigures& shown = mesh.RegionsShown;
  return shown.Regions < 2 ? std::string()
                           : ", " + std::to_string(shown.Regions) + " regions with " +
      Figure(100.0 * shown.BordersKept) + " % of their borders on edges";
}

std::string AboutSizes(const RemeshResult& mesh)
{
  return !mesh.IsSized
    ? std::string()
    : (mesh.ErrorOfSizes > 0.0 ? ", sizes for an error of " + Figure(mesh.ErrorOfSizes)
                               : std::string()) +
      ", " + Figure(100.0 * mesh.EdgesAsWanted) + " % of edges within 25 % of their wanted length";
}

std::string AboutBoundary(const RemeshResult& mesh)
{
  const BoundaryFigures& boundary = mesh.Boundary;
  const auto points = static_cast<std::size_t>(boundary.Points);
  // Less is the rounding of coordinates.
  const double unevenness = boundary.Unevenness < 1e-6 ? 0.0 : boundary.Unevenness;
  return boundary.Kept + boundary.Others > 0 ? ", " + std::to_string(boundary.Kept) + " of " +
      Count(points, "point") + " of the boundary kept"
    : points > 0 ? ", edges of the boundary even to " + Figure(100.0 * unevenness) + " %"
                 : std::string();
}

/// How far mesh and surface are from each other. Distances that are the rounding of coordinates in
/// single precision say nothing about faces.
std::string AboutDistances(const RemeshResult& mesh)
{
  constexpr double rounding = 1e-7;
  double largest = 0.0;
  for (const Vector3& point : mesh.Points)
  {
    largest = std::max(largest, point.lpNorm<Eigen::Infinity>());
  }
  const auto from = [&](double distance)
  { return distance > rounding * largest ? Figure(distance) + " or less from" : "on"; };
  const std::string there = from(mesh.MaximumDistance);
  const std::string back = from(mesh.MaximumDistanceToMesh);
  return there == "on" && back == "on"
    ? ", exactly on the surface"
    : ", " + there + " the surface, which is " + back + " the mesh";
}

std::string AboutLimits(const QualityReport& quality)
{
  return !quality.IsLimited ? std::string()
    : quality.FailedFaces == 0
    ? ", all faces within the limits"
    : ", " + Count(static_cast<std::size_t>(quality.FailedFaces), "face") +
      (quality.FailedFaces == 1 ? " fails" : " fail") + " the limits";
}
}

std::string Summary(const RemeshResult& mesh, const QualityReport& quality)
{
  if (mesh.Faces.empty())
  {
    return "no faces, for there are no triangles";
  }
  std::string text;
  if (mesh.Quads > 0)
  {
    text = Count(static_cast<std::size_t>(mesh.Quads), "quad") + ", ";
  }
  if (mesh.Triangles > 0)
  {
    text += Count(static_cast<std::size_t>(mesh.Triangles), "triangle") + ", ";
  }
  return text +
    Count(
      static_cast<std::size_t>(mesh.IrregularVertices), "irregular vertex", "irregular vertices") +
    AboutRegions(mesh) + ", edge length " + Figure(mesh.EdgeLength) + AboutSizes(mesh) +
    AboutBoundary(mesh) + ", scaled Jacobian " + Figure(quality.LeastScaledJacobian) + " or more" +
    AboutDistances(mesh) + AboutLimits(quality);
}
}
