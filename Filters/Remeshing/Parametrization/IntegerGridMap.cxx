// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Parametrization/IntegerGridMap.h"

#include "Integers/IntegerRounding.h"
#include "Parametrization/IsolineFolds.h"
#include "Parametrization/ParametrizationEnergy.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace DirectionFields::Internal
{
namespace
{
/// Features of up to this many edges are given up where the map is folded along this part of them.
constexpr double LongestFolded = 8.0;
constexpr double FoldedPart = 0.2;
/// Rounding few integers may change the area a lot. Where triangles are so thin that no map of them is any good, the
/// targets may ask for, and the map may cover, many times the area of the surface. Beyond this difference, as a
/// logarithm, the map is made anew for edges of another length: the faces should be as many as were asked for, and the
/// work to come grows with the area covered.
constexpr double MostOff = 0.1;
constexpr int MostScalings = 4;
/// Parts of so few cells are off by chance; only beyond this many times their area, and a cell for each triangle,
/// that matters.
constexpr double FewCells = 16.0;
constexpr double MostArea = 4.0;
/// Features that are closer than an edge need more cells at any length of edges. Maps are used up to so many times
/// more.
constexpr double MostBeyond = 16.0;
/// More could not be numbered.
constexpr double MostCells = 1e8;

double MeanPerLength(const IntegerGridMap::Settings& settings, const CutMesh::MapTriangle& triangle)
{
  return (settings.PerLength[triangle.Vertex[0]] + settings.PerLength[triangle.Vertex[1]] +
           settings.PerLength[triangle.Vertex[2]]) /
    3.0;
}

/// The area that the targets ask for, in parallelograms of the lattice.
double WantedArea(
  const CutMesh& mesh, const IntegerGridMap::Settings& settings, const IntegerGrid& plane)
{
  double wanted = 0.0;
  for (const CutMesh::MapTriangle& t : mesh.Triangles)
  {
    const double size = MeanPerLength(settings, t);
    const double area = 0.5 * (std::conj(t.Target[0]) * -t.Target[2]).imag();
    wanted += size * size * std::max(0.0, area);
  }
  return wanted / plane.Combined(0.0, 1.0).imag();
}

/// The area that the triangles have in space, in parallelograms of the lattice.
double AreaInSpace(
  const CutMesh& mesh, const IntegerGridMap::Settings& settings, const IntegerGrid& plane)
{
  double area = 0.0;
  for (const CutMesh::MapTriangle& t : mesh.Triangles)
  {
    const double size = MeanPerLength(settings, t);
    const Vector3 a = size * (mesh.Positions[t.Vertex[1]] - mesh.Positions[t.Vertex[0]]);
    const Vector3 b = size * (mesh.Positions[t.Vertex[2]] - mesh.Positions[t.Vertex[0]]);
    area += 0.5 * a.cross(b).norm();
  }
  return area / plane.Combined(0.0, 1.0).imag();
}
}

IntegerGridMap::IntegerGridMap(
  const CutMesh& mesh, const Settings& settings, const Progress& progress)
  : Plane(mesh.Degree)
{
  ParametrizationEnergy equations(mesh, settings.PerLength);
  this->Solve(equations, settings, progress);
}

IntegerGridMap::IntegerGridMap(
  ParametrizationEnergy& equations, const Settings& settings, const Progress& progress)
  : Plane(equations.GetMesh().Degree)
{
  this->Solve(equations, settings, progress);
}

void IntegerGridMap::Solve(
  ParametrizationEnergy& equations, const Settings& settings, const Progress& progress)
{
  const CutMesh& mesh = equations.GetMesh();
  this->NumberOfIntegers = equations.GetNumberOfIntegers();
  progress.Report(0.2);
  const double wanted = settings.KeepsArea ? WantedArea(mesh, settings, this->Plane) : 0.0;
  const auto scaleOf = [&](const Eigen::VectorXd& relaxed)
  {
    const double reached = wanted > 0.0 ? equations.AreaAt(relaxed) : 0.0;
    return reached > 0.25 * wanted && wanted > 0.0 ? std::sqrt(wanted / reached) : 1.0;
  };
  const Eigen::VectorXd side = equations.RightHandSide(settings.PerLength);
  const double actual = AreaInSpace(mesh, settings, this->Plane);
  const double most = MostArea * actual + static_cast<double>(mesh.Triangles.size());
  if (actual > MostCells)
  {
    this->Failure = "its grid would have more than 100 million cells";
    return;
  }
  // A map of the targets times a factor, or nothing.
  std::function<Eigen::VectorXd(double)> solve;
  double scale = 1.0;
  Eigen::VectorXd relaxed;
  if (!equations.AreFactored())
  {
    solve = [&](double factor) { return equations.SolveInRounds(factor * side); };
  }
  else
  {
    const SchurSystem& system = equations.GetSystem();
    progress.Report(0.7);
    if (system.IsDefinite())
    {
      relaxed = system.Solve(side);
      scale = scaleOf(relaxed);
    }
    solve = [&](double factor) -> Eigen::VectorXd
    {
      if (!system.IsDefinite())
      {
        return {};
      }
      Eigen::VectorXd integers = factor * relaxed.tail(this->NumberOfIntegers);
      RoundGreedily(system.TrailingFactor(), integers, equations.Least());
      return system.SolveWith(factor * relaxed, integers);
    };
  }
  // The one whose area is nearest, and how far it is off, as a logarithm.
  Eigen::VectorXd best;
  double bestArea = 0.0;
  double least = std::numeric_limits<double>::infinity();
  bool isBest = false;
  for (int k = 0; k <= MostScalings; ++k)
  {
    Eigen::VectorXd x = solve(scale);
    if (x.size() == 0 && side.size() > 0)
    {
      this->Failure = "the equations of its grid could not be solved";
      return;
    }
    progress.Report(0.9);
    this->Evaluate(equations.GetUnknowns(), x);
    if (this->Failure != nullptr)
    {
      return;
    }
    const double covered = this->AreaCovered(true);
    const double area = covered > most ? covered : this->AreaCovered(false);
    const double off = std::abs(std::log(area / actual));
    // Where the map is folded through and through, its area says nothing.
    const bool isFolded = !(area > 0.25 * actual);
    const bool isRight =
      !settings.KeepsArea || isFolded || off <= MostOff || (actual < FewCells && covered <= most);
    isBest = off < least || isRight;
    if (isBest)
    {
      least = off;
      bestArea = area;
      best = std::move(x);
    }
    if (isRight)
    {
      break;
    }
    scale *= std::sqrt(std::max(actual, 1.0) / area);
  }
  if (!isBest)
  {
    this->Evaluate(equations.GetUnknowns(), best);
  }
  if (settings.KeepsArea && bestArea > MostBeyond * most)
  {
    this->Failure = "its grid would have far more cells than it is to have faces";
  }
}

void IntegerGridMap::Evaluate(ParametrizationVariables& unknowns, const Eigen::VectorXd& free)
{
  const CutMesh& mesh = unknowns.Mesh;
  if (!(free.array().abs() < IntegerGrid::Range).all())
  {
    this->Failure = "its grid has too many lines, or its equations are not well posed";
    return;
  }
  this->CollapsedFeatures.clear();
  const Index count = unknowns.Solved.GetNumberOfVariables();
  std::vector<std::int64_t> value(count, 0);
  Index next = 0;
  for (const bool areIntegers : { false, true })
  {
    for (Index v = 0; v < count; ++v)
    {
      if (unknowns.Solved.IsFree(v) && unknowns.Solved.IsInteger(v) == areIntegers)
      {
        value[v] = areIntegers ? std::llround(free[next]) * IntegerGrid::Unit
                               : std::llround(free[next] * static_cast<double>(IntegerGrid::Unit));
        ++next;
      }
    }
  }
  for (Index v = 0; v < count; ++v)
  {
    if (!unknowns.Solved.IsFree(v))
    {
      std::int64_t sum = 0;
      for (const auto& [w, p] : unknowns.Solved.Resolve(v))
      {
        sum += p * value[w];
      }
      value[v] = sum;
    }
  }
  const auto transition = [&](const SymbolicTransition& symbolic)
  {
    Transition t{ symbolic.Turn, {} };
    for (const Jump& jump : symbolic.Jumps)
    {
      const Index v = 2 * (unknowns.Vertices + jump.Variable);
      t.Shift = t.Shift + this->Plane.Turned({ value[v], value[v + 1] }, jump.Turn);
    }
    return t;
  };
  std::vector<Transition> own(3 * mesh.Triangles.size());
  this->Corners.resize(own.size());
  this->Across.resize(own.size());
  std::vector<char> isCone(unknowns.Vertices, 0);
  for (const CutMesh::Cone& cone : mesh.Cones)
  {
    isCone[cone.Vertex] = 1;
  }
  std::vector<GridPoint> places(unknowns.Vertices);
  for (Index v = 0; v < unknowns.Vertices; ++v)
  {
    places[v] = { value[2 * v], value[2 * v + 1] };
  }
  for (std::size_t h = 0; h < own.size(); ++h)
  {
    own[h] = transition(mesh.Triangles[h / 3].Corner[h % 3]);
  }
  for (const FeatureIsoline& stretch : UnfoldIsolines(mesh, own, unknowns.Stretches, places))
  {
    for (const FeatureIsoline::Step& step : stretch.Steps)
    {
      this->CollapsedFeatures.push_back(mesh.Isolines[step.Isoline].Edge);
    }
  }
  for (std::size_t h = 0; h < own.size(); ++h)
  {
    this->Corners[h] = this->Plane.Apply(own[h], places[mesh.Triangles[h / 3].Vertex[h % 3]]);
  }
  this->FindFoldedFeatures(mesh, unknowns.Stretches);
  for (std::size_t h = 0; h < own.size(); ++h)
  {
    const Index twin = mesh.Triangles[h / 3].Twin[h % 3];
    if (twin == None)
    {
      continue;
    }
    // By way of the chart of an end that has one.
    const auto nextOf = [](std::size_t k) { return k % 3 == 2 ? k - 2 : k + 1; };
    const auto other = static_cast<std::size_t>(twin);
    const bool tailHas = isCone[mesh.Triangles[h / 3].Vertex[h % 3]] == 0;
    const Transition& here = tailHas ? own[h] : own[nextOf(h)];
    const Transition& there = tailHas ? own[nextOf(other)] : own[other];
    this->Across[h] = this->Plane.Composed(here, this->Plane.Inverse(there));
  }
}

bool IntegerGridMap::IsFlipped(Index t) const
{
  const GridPoint* corner = &this->Corners[3 * static_cast<std::size_t>(t)];
  return IntegerGrid::Orientation(corner[0], corner[1], corner[2]) <= 0;
}

Index IntegerGridMap::CountFlipped() const
{
  Index flipped = 0;
  for (Index t = 0; t < static_cast<Index>(this->Corners.size() / 3); ++t)
  {
    flipped += this->IsFlipped(t) ? 1 : 0;
  }
  return flipped;
}

double IntegerGridMap::AreaCovered(bool withFolds) const
{
  double area = 0.0;
  for (std::size_t h = 0; h < this->Corners.size(); h += 3)
  {
    const GridPoint u = this->Corners[h + 1] - this->Corners[h];
    const GridPoint v = this->Corners[h + 2] - this->Corners[h];
    const double twice = static_cast<double>(u.A) * static_cast<double>(v.B) -
      static_cast<double>(u.B) * static_cast<double>(v.A);
    area += withFolds ? std::max(0.0, 0.5 * twice) : 0.5 * twice;
  }
  return area / (static_cast<double>(IntegerGrid::Unit) * static_cast<double>(IntegerGrid::Unit));
}

void IntegerGridMap::FindFoldedFeatures(
  const CutMesh& mesh, const std::vector<FeatureIsoline>& stretches)
{
  for (const FeatureIsoline& stretch : stretches)
  {
    double length = 0.0;
    std::size_t flipped = 0;
    for (const FeatureIsoline::Step& step : stretch.Steps)
    {
      const CutMesh::IsolineEdge& edge = mesh.Isolines[step.Isoline];
      const Index h = 3 * edge.Triangle + edge.Corner;
      const Index twin = mesh.Triangles[edge.Triangle].Twin[edge.Corner];
      flipped += this->IsFlipped(edge.Triangle) ? 1 : 0;
      flipped += twin != None && this->IsFlipped(twin / 3) ? 1 : 0;
      length += std::abs(
        this->Plane.Place(this->Corners[edge.Corner == 2 ? h - 2 : h + 1] - this->Corners[h]));
    }
    if (length < LongestFolded &&
      2 * FoldedPart * static_cast<double>(stretch.Steps.size()) < static_cast<double>(flipped))
    {
      for (const FeatureIsoline::Step& step : stretch.Steps)
      {
        this->CollapsedFeatures.push_back(mesh.Isolines[step.Isoline].Edge);
      }
    }
  }
}
}
