// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Solver/DistributedCurvature.h"

#include "Computation/Guide.h"
#include "Curvature/Rounding.h"
#include "Geometry/DihedralAngles.h"
#include "Mesh/EnclosedVolume.h"
#include "Mesh/MeshPiece.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <utility>

namespace DirectionFields::Parallel
{
namespace
{
/// What is the largest one in the whole of a component: the coordinates, for a corner of its box,
/// and of the precision of the coordinates the magnitude and what they do not have.
using Largest = std::array<double, 7>;
/// Sums over a component: volume, area and number of boundary vertices.
using Sums = std::array<double, 3>;

std::vector<Largest> FindLargest(const Messages& messages, const DistributedMesh& mesh)
{
  Largest nothing;
  nothing.fill(-std::numeric_limits<double>::max());
  std::vector<Largest> largest(static_cast<std::size_t>(mesh.CountComponents()), nothing);
  const std::vector<Vector3>& positions = mesh.GetGeometry().Positions;
  for (int component = 0; component < mesh.CountComponents(); ++component)
  {
    Largest& most = largest[component];
    for (const std::size_t c : mesh.PartsOf(component))
    {
      const TriangleMesh::Component& part = mesh.GetMesh().GetComponents()[c];
      for (Index v = part.FirstVertex; v < part.EndVertex; ++v)
      {
        for (int k = 0; k < 3; ++k)
        {
          most[k] = std::max(most[k], positions[v][k]);
        }
      }
      const Precision precision = PrecisionOf(positions, part);
      const double lacks[4] = { precision.Largest, precision.IsSingle ? 0.0 : 1.0,
        precision.HasSixDigits ? 0.0 : 1.0, precision.HasSevenDigits ? 0.0 : 1.0 };
      for (int k = 0; k < 4; ++k)
      {
        most[3 + k] = std::max(most[3 + k], lacks[k]);
      }
    }
  }
  messages.Largest(largest.empty() ? nullptr : largest.front().data(),
    static_cast<int>(largest.size() * Largest().size()));
  return largest;
}

std::vector<Sums> AddUp(const Messages& messages, const DistributedMesh& mesh,
  const PieceWithSurroundings& piece, const std::vector<Largest>& largest)
{
  const TriangleMesh& triangles = mesh.GetMesh();
  const SurfaceGeometry& geometry = mesh.GetGeometry();
  std::vector<Sums> sums(largest.size(), Sums{});
  for (int component = 0; component < mesh.CountComponents(); ++component)
  {
    const Vector3 origin(largest[component].data());
    Sums& sum = sums[component];
    for (const std::size_t c : mesh.PartsOf(component))
    {
      const TriangleMesh::Component& part = triangles.GetComponents()[c];
      for (Index t = part.FirstTriangle; t < part.EndTriangle; ++t)
      {
        if (piece.Surface.Ghost[triangles.InputTriangle(t)] == 0)
        {
          const auto corner = [&](int k) -> Vector3 {
            return (geometry.Positions[triangles.Tail(3 * t + k)] - origin) /
              geometry.Lengths.Unit[c];
          };
          sum[0] += corner(0).dot(corner(1).cross(corner(2))) / 6.0;
          sum[1] += geometry.Lengths.Area[t];
        }
      }
      for (Index v = part.FirstVertex; v < part.EndVertex; ++v)
      {
        sum[2] += mesh.IsOwned(v) && triangles.IsBoundary(v) ? 1.0 : 0.0;
      }
    }
  }
  messages.Sum(
    sums.empty() ? nullptr : sums.front().data(), static_cast<int>(sums.size() * Sums().size()));
  return sums;
}

/// What of the whole components matters to their parts here.
std::vector<WholeComponent> WholesOf(
  const Messages& messages, const DistributedMesh& mesh, const PieceWithSurroundings& piece)
{
  const std::vector<Largest> largest = FindLargest(messages, mesh);
  const std::vector<Sums> sums = AddUp(messages, mesh, piece, largest);
  std::vector<WholeComponent> wholes(mesh.GetMesh().GetComponents().size());
  for (std::size_t c = 0; c < wholes.size(); ++c)
  {
    const int component = mesh.ComponentOf(c);
    if (component >= 0)
    {
      const Largest& most = largest[component];
      const Precision precision{ most[3], most[4] <= 0.0, most[5] <= 0.0, most[6] <= 0.0 };
      wholes[c].RoundingError = precision.RoundingError();
      wholes[c].IsInsideOut =
        sums[component][2] == 0.0 && IsWoundInsideOut(sums[component][0], sums[component][1]);
    }
  }
  return wholes;
}
}

Curvature CurvatureOf(const Messages& messages, const DistributedMesh& mesh,
  const PieceWithSurroundings& piece, double rings)
{
  Curvature curvature(mesh.GetGeometry(), DihedralAngles(mesh.GetGeometry()), rings,
    MeshPiece(messages, mesh), WholesOf(messages, mesh, piece));
  curvature.IsInsideOut = messages.Any(curvature.IsInsideOut);
  return curvature;
}

std::vector<double> CurvatureShares(
  const Messages& messages, const DistributedMesh& mesh, const Curvature& curvature)
{
  const TriangleMesh& triangles = mesh.GetMesh();
  std::vector<double> bends(static_cast<std::size_t>(mesh.CountComponents()), 0.0);
  for (int component = 0; component < mesh.CountComponents(); ++component)
  {
    for (const std::size_t c : mesh.PartsOf(component))
    {
      const TriangleMesh::Component& part = triangles.GetComponents()[c];
      for (Index h = 3 * part.FirstTriangle; h < 3 * part.EndTriangle; ++h)
      {
        const Index v = triangles.Tail(h);
        if (mesh.IsOwned(v))
        {
          bends[component] +=
            mesh.GetGeometry().Lengths.Area[h / 3] / 3.0 * std::norm(curvature.Hopf[v]);
        }
      }
    }
  }
  messages.Sum(bends.data(), static_cast<int>(bends.size()));
  for (double& bend : bends)
  {
    bend = std::sqrt(bend);
  }
  return SharesOfBends(std::move(bends));
}
}
