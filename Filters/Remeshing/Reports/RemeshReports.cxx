// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Reports/RemeshReports.h"

#include "Support/Sentences.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
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
        edges.push_back({ std::min(a, b), std::max(a, b) });
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

/// The least sine of an angle of a face, with the sign of its side: 1 for a square, and, as by
/// Verdict, for an even triangle, too.
double ScaledJacobian(const RemeshResult& mesh, const std::array<Index, 4>& face)
{
  const int size = SizeOf(face);
  const double even = size == 4 ? 1.0 : 2.0 / std::sqrt(3.0);
  // A power of two, so that digits stay: areas of large and small faces have no numbers.
  const double perLength =
    mesh.EdgeLength > 0.0 ? std::ldexp(1.0, std::min(-std::ilogb(mesh.EdgeLength), 1000)) : 1.0;
  std::array<Vector3, 4> normals;
  std::array<double, 4> lengths;
  Vector3 sum = Vector3::Zero();
  for (int c = 0; c < size; ++c)
  {
    const Vector3& at = mesh.Points[face[c]];
    const Vector3 next = perLength * (mesh.Points[face[(c + 1) % size]] - at);
    const Vector3 last = perLength * (mesh.Points[face[(c + size - 1) % size]] - at);
    normals[c] = next.cross(last);
    lengths[c] = next.norm() * last.norm();
    sum += normals[c];
  }
  const Vector3 normal = sum.stableNormalized();
  double least = 1.0;
  for (int c = 0; c < size; ++c)
  {
    least = std::min(least, lengths[c] > 0.0 ? even * normals[c].dot(normal) / lengths[c] : 0.0);
  }
  return least;
}
}

std::vector<double> ScaledJacobians(const RemeshResult& mesh)
{
  std::vector<double> quality;
  quality.reserve(mesh.Faces.size());
  for (const std::array<Index, 4>& face : mesh.Faces)
  {
    quality.push_back(ScaledJacobian(mesh, face));
  }
  return quality;
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
}

std::string Summary(const RemeshResult& mesh, double leastScaledJacobian)
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
    AboutRegions(mesh) + ", edge length " + Figure(mesh.EdgeLength) + ", scaled Jacobian " +
    Figure(leastScaledJacobian) + " or more, " + Figure(mesh.MaximumDistance) +
    " or less from the surface, which is " + Figure(mesh.MaximumDistanceToMesh) +
    " or less from the mesh";
}
}
