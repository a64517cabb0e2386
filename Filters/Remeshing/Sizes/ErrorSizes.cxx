// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Sizes/ErrorSizes.h"

#include "Computation/Stages.h"
#include "Curvature/Curvature.h"
#include "Features/Creases.h"
#include "Preparation/SurfaceUnit.h"
#include "Preparation/WantedSizes.h"
#include "Sizes/SizeField.h"
#include "Support/Sentences.h"
#include "Support/Threads.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace DirectionFields::Internal
{
namespace
{
/// Derivatives below this part of their mean count as that: flat places get no endless faces.
constexpr double LeastPart = 0.01;
/// Lengths relative to those of as many even faces.
constexpr double Longest = 4.0;
constexpr double Shortest = 0.125;
constexpr double MostFaces = 1e7;
constexpr double NotKnown = -1.0;

/// The vertices around a vertex, in ascending order without it.
std::vector<Index> NeighboursOf(const TriangleMesh& mesh, Index v, std::vector<Index>& fan)
{
  mesh.GetFan(v, fan);
  std::vector<Index> found;
  for (const Index h : fan)
  {
    found.push_back(mesh.Head(h));
    found.push_back(mesh.Tail(TriangleMesh::Previous(h)));
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

/// Gives vertices without a value the mean of their neighbours', from those with one outwards, and
/// 0 where there is none.
void FillIn(const TriangleMesh& mesh, std::vector<double>& values)
{
  std::vector<Index> open;
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    if (values[v] < 0.0)
    {
      open.push_back(v);
    }
  }
  std::vector<Index> fan;
  while (!open.empty())
  {
    std::vector<std::pair<Index, double>> filled;
    std::vector<Index> left;
    for (const Index v : open)
    {
      double sum = 0.0;
      int count = 0;
      for (const Index w : NeighboursOf(mesh, v, fan))
      {
        sum += values[w] < 0.0 ? 0.0 : values[w];
        count += values[w] < 0.0 ? 0 : 1;
      }
      if (count > 0)
      {
        filled.emplace_back(v, sum / count);
      }
      else
      {
        left.push_back(v);
      }
    }
    for (const auto& [v, value] : filled)
    {
      values[v] = value;
    }
    if (filled.empty())
    {
      break;
    }
    open = std::move(left);
  }
  for (double& value : values)
  {
    value = std::max(value, 0.0);
  }
}

/// Values of vertices at the points that they stand for, and at the points that are one with these.
std::vector<double> AtPoints(const Stages& stages, const std::vector<double>& ofVertices)
{
  std::vector<double> atPoints(stages.GetInput().Points.size(), 0.0);
  const TriangleMesh& mesh = stages.GetMesh();
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    double& value = atPoints[mesh.Point(v)];
    value = std::max(value, ofVertices[v]);
  }
  const std::vector<Index>& first = stages.GetFirstPoints();
  for (std::size_t p = 0; p < first.size(); ++p)
  {
    atPoints[p] = atPoints[first[p]];
  }
  return atPoints;
}

/// The sum of the moduli of the principal second derivatives at a vertex, or NotKnown where its
/// surroundings do not determine a quadratic function.
double FittedSum(const SurfaceGeometry& geometry, const std::vector<char>& isCrease,
  const std::vector<double>& values, Index v)
{
  constexpr int unknowns = 5;
  const TriangleMesh& mesh = geometry.Mesh;
  std::vector<Index> fan;
  const std::vector<Index> near = NeighboursOf(mesh, v, fan);
  std::vector<Index> around = near;
  for (const Index w : near)
  {
    if (isCrease[w] == 0)
    {
      const std::vector<Index> further = NeighboursOf(mesh, w, fan);
      around.insert(around.end(), further.begin(), further.end());
    }
  }
  std::sort(around.begin(), around.end());
  around.erase(std::unique(around.begin(), around.end()), around.end());
  around.erase(std::remove(around.begin(), around.end(), v), around.end());
  double reach = 0.0;
  for (const Index w : around)
  {
    reach = std::max(reach, (geometry.Positions[w] - geometry.Positions[v]).norm());
  }
  const auto count = static_cast<Eigen::Index>(around.size());
  if (isCrease[v] != 0 || count < unknowns || !(reach > 0.0))
  {
    return NotKnown;
  }
  Eigen::MatrixXd rows(count, unknowns);
  Eigen::VectorXd rises(count);
  for (Eigen::Index k = 0; k < count; ++k)
  {
    const Vector3 step = (geometry.Positions[around[k]] - geometry.Positions[v]) / reach;
    Complex z = geometry.Frames.Tangential(v, step);
    const double length = step.norm();
    z *= std::abs(z) > 0.0 ? length / std::abs(z) : 0.0;
    const double x = z.real();
    const double y = z.imag();
    const double weight = 1.0 / std::max(length, 0.01);
    rows.row(k) << x, y, 0.5 * x * x, x * y, 0.5 * y * y;
    rows.row(k) *= weight;
    rises[k] = weight * (values[around[k]] - values[v]);
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(rows);
  if (solver.rank() < unknowns)
  {
    return NotKnown;
  }
  const Eigen::VectorXd fit = solver.solve(rises);
  const double half = 0.5 * (fit[2] + fit[4]);
  const double off = std::hypot(0.5 * (fit[2] - fit[4]), fit[3]);
  const double sum = (std::abs(half + off) + std::abs(half - off)) / (reach * reach);
  return std::isfinite(sum) ? sum : NotKnown;
}

double LengthFor(double derivative, double error, bool isChord)
{
  if (!isChord)
  {
    return std::sqrt(8.0 * error / derivative);
  }
  const double radius = 1.0 / derivative;
  const double height = std::min(error, radius);
  return 2.0 * std::sqrt(height * (2.0 * radius - height));
}
}

std::vector<double> CurvatureSums(const Surface& surface)
{
  Stages stages(
    std::shared_ptr<const Surface>(std::shared_ptr<void>(), &surface), MergePoints::Automatic);
  const SurfaceGeometry& geometry = stages.GetGeometry();
  const Curvature& curvature = stages.GetCurvature();
  const Creases creases(geometry, stages.GetDihedralAngles());
  std::vector<double> sums(curvature.Mean.size());
  const std::vector<TriangleMesh::Component>& components = geometry.Mesh.GetComponents();
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    const Index end = components[c].FirstVertex + components[c].Vertices();
    for (Index v = components[c].FirstVertex; v < end; ++v)
    {
      // |H + |q|| + |H - |q|| of the shape operator.
      const double sum = 2.0 * std::max(std::abs(curvature.Mean[v]), std::abs(curvature.Hopf[v])) /
        geometry.Lengths.Unit[c];
      sums[v] = creases.Vertex[v] == 0 && std::isfinite(sum) ? sum : NotKnown;
    }
  }
  FillIn(geometry.Mesh, sums);
  return AtPoints(stages, sums);
}

std::vector<double> DerivativeSums(const Surface& surface, const std::vector<double>& values)
{
  Stages stages(
    std::shared_ptr<const Surface>(std::shared_ptr<void>(), &surface), MergePoints::Automatic);
  const SurfaceGeometry& geometry = stages.GetGeometry();
  const TriangleMesh& mesh = geometry.Mesh;
  const Creases creases(geometry, stages.GetDihedralAngles());
  const Index vertices = mesh.GetNumberOfVertices();
  std::vector<double> own(vertices);
  for (Index v = 0; v < vertices; ++v)
  {
    own[v] = values[mesh.Point(v)];
  }
  std::vector<double> sums(vertices);
  ParallelFor(vertices, MediumPiece,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        sums[v] = FittedSum(geometry, creases.Vertex, own, v);
      }
    });
  FillIn(mesh, sums);
  std::vector<double> smooth(sums.size());
  std::vector<Index> fan;
  for (Index v = 0; v < vertices; ++v)
  {
    const std::vector<Index> near = NeighboursOf(mesh, v, fan);
    double sum = 0.0;
    for (const Index w : near)
    {
      sum += sums[w] / static_cast<double>(near.size());
    }
    smooth[v] = 0.5 * (sums[v] + sum);
  }
  return AtPoints(stages, smooth);
}

ErrorLengths LengthsForError(
  const Surface& surface, const std::vector<double>& derivatives, const ErrorWish& wish)
{
  constexpr int rounds = 16;
  constexpr double exactly = 0.005;
  const double area = RelativeArea(surface, std::vector<double>(derivatives.size(), 1.0));
  // Each point counts by the area around it.
  double sum = 0.0;
  double weights = 0.0;
  for (const Triangle& t : surface.Triangles)
  {
    const double own = (surface.Points[t[1]] - surface.Points[t[0]])
                         .cross(surface.Points[t[2]] - surface.Points[t[0]])
                         .norm();
    sum += own * (derivatives[t[0]] + derivatives[t[1]] + derivatives[t[2]]) / 3.0;
    weights += own;
  }
  const double mean = weights > 0.0 ? sum / weights : 0.0;
  ErrorLengths result;
  result.Error = wish.Error;
  double squares = wish.Error > 0.0 ? mean * area / (8.0 * wish.Error) : wish.Squares;
  if (!(mean > 0.0) || !std::isfinite(mean) || !(area > 0.0))
  {
    const double even = wish.Error > 0.0 ? Extent(surface) / 8.0 : std::sqrt(area / squares);
    result.Lengths.assign(derivatives.size(), even);
    return result;
  }
  double error = wish.Error > 0.0 ? wish.Error : mean * area / (8.0 * squares);
  for (int round = 0; round < rounds; ++round)
  {
    if (squares > MostFaces)
    {
      throw std::invalid_argument("An error of " + Figure(wish.Error) + " needs about " +
        Figure(squares) + " faces, more than ten million. Raise Maximum Error.");
    }
    const double even = std::sqrt(area / squares);
    result.Lengths.clear();
    for (const double derivative : derivatives)
    {
      const double length =
        LengthFor(std::max(derivative, LeastPart * mean), error, wish.AreChords);
      result.Lengths.push_back(std::clamp(length, Shortest * even, Longest * even));
    }
    LimitGrowth(surface, std::log(wish.Gradation), result.Lengths);
    const double made = RelativeArea(surface, result.Lengths);
    const double ratio = made / squares;
    if (std::abs(ratio - 1.0) < exactly)
    {
      break;
    }
    (wish.Error > 0.0 ? squares : error) *= ratio;
  }
  result.Error = error;
  return result;
}
}
