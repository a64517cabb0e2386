// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Parametrization/IntegerGridMap.h"

#include "Integers/IntegerRounding.h"
#include "Integers/IntegerSearch.h"
#include "Parametrization/IsolineFolds.h"
#include "Parametrization/ParametrizationEnergy.h"
#include "Unfolding/MapFolds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// Features of up to this many edges are given up where the map is folded along this part of them.
constexpr double LongestFolded = 8.0;
constexpr double FoldedPart = 0.2;
/// Rounding few integers may change the area a lot. Where triangles are so thin that no map of them
/// is good, the targets may ask for, and the map may cover, many times the area of the surface.
/// Beyond this difference, as a logarithm, the map is computed again for another length of edges:
/// the number of faces should be the one asked for, and later work grows with the area covered.
constexpr double MostOff = 0.1;
constexpr int MostScalings = 4;
/// The area of components with fewer cells than this is off by chance. It matters only beyond this
/// many times their area plus a cell for each triangle.
constexpr double FewCells = 16.0;
constexpr double MostArea = 4.0;
/// Features that are closer than an edge need more cells at any length of edges. Maps are used up
/// to this many times more.
constexpr double MostBeyond = 16.0;
/// More could not be numbered.
constexpr double MostCells = 1e8;
/// Below this part of the wanted area a map is folded everywhere, and its area says nothing.
constexpr double LeastCovered = 0.25;

double MeanPerLength(const IntegerGridMap::Settings& settings, const CutMesh::MapTriangle& triangle)
{
  return (settings.PerLength[triangle.Vertex[0]] + settings.PerLength[triangle.Vertex[1]] +
           settings.PerLength[triangle.Vertex[2]]) /
    3.0;
}

/// The area that the targets ask for, in parallelograms of the grid.
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

/// The area of the triangles in space, in parallelograms of the grid.
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

/// The minimum of the energy with integers, for targets that are scaled. With few enough integers
/// these are rounded with regard to each other, from the minimum over the reals; else in rounds.
class RoundedMinimum
{
public:
  RoundedMinimum(ParametrizationEnergy& energy, const std::vector<double>& perLength)
    : Energy(energy)
    , Side(energy.RightHandSide(perLength))
    , System(energy.IsFactored() ? &energy.GetSystem() : nullptr)
  {
    if (this->System != nullptr && this->System->IsDefinite())
    {
      this->Relaxed = this->System->Solve(this->Side);
    }
  }

  /// The factor for the targets with which the minimum over the reals covers this area; 1 if
  /// unknown.
  double ScaleForArea(double wanted)
  {
    const bool isKnown = this->Relaxed.size() > 0 && wanted > 0.0;
    const double reached = isKnown ? this->Energy.AreaAt(this->Relaxed) : 0.0;
    return isKnown && reached > LeastCovered * wanted ? std::sqrt(wanted / reached) : 1.0;
  }

  /// The values of the free variables for the targets times a factor, or nothing.
  std::optional<Eigen::VectorXd> At(double factor) const
  {
    Eigen::VectorXd x;
    if (this->System == nullptr)
    {
      x = this->Energy.SolveInRounds(factor * this->Side);
    }
    else if (this->System->IsDefinite())
    {
      const Eigen::VectorXd relaxed =
        factor * this->Relaxed.tail(this->Energy.GetNumberOfIntegers());
      Eigen::VectorXd integers = relaxed;
      const Eigen::VectorXd least = this->Energy.Least(relaxed);
      RoundGreedily(this->System->TrailingFactor(), integers, least);
      ImproveIntegers(this->System->TrailingFactor(), relaxed, integers, least);
      x = this->System->SolveWith(factor * this->Relaxed, integers);
    }
    return x.size() == this->Side.size() ? std::optional(std::move(x)) : std::nullopt;
  }

private:
  ParametrizationEnergy& Energy;
  Eigen::VectorXd Side;
  const SchurSystem* System;
  Eigen::VectorXd Relaxed;
};

/// Of maps for targets of different scales, finds the one whose area is nearest to the surface's.
class AreaSearch
{
public:
  AreaSearch(const IntegerGridMap::Settings& settings, double actual, std::size_t triangles)
    : KeepsArea(settings.KeepsArea)
    , Actual(actual)
    , Most(MostArea * actual + static_cast<double>(triangles))
  {
  }

  /// Takes the next map into account.
  /// @param covered its area without the flipped triangles
  /// @param signedArea its area with them
  void Add(Eigen::VectorXd&& x, double covered, double signedArea)
  {
    const double area = covered > this->Most ? covered : signedArea;
    const double off = std::abs(std::log(area / this->Actual));
    const bool isFolded = !(area > LeastCovered * this->Actual);
    this->Found = !this->KeepsArea || isFolded || off <= MostOff ||
      (this->Actual < FewCells && covered <= this->Most);
    this->LastIsBest = off < this->Least || this->Found;
    if (this->LastIsBest)
    {
      this->Least = off;
      this->BestArea = area;
      this->Best = std::move(x);
    }
    this->Correction = std::sqrt(std::max(this->Actual, 1.0) / area);
  }

  /// The last map will do.
  bool IsFound() const { return this->Found; }
  /// The factor that would bring the area of the last map to the one of the surface.
  double GetCorrection() const { return this->Correction; }
  bool IsLastBest() const { return this->LastIsBest; }
  const Eigen::VectorXd& GetBest() const { return this->Best; }
  bool IsExcessive() const { return this->KeepsArea && this->BestArea > MostBeyond * this->Most; }

private:
  bool KeepsArea;
  double Actual;
  double Most;
  double Least = std::numeric_limits<double>::infinity();
  double BestArea = 0.0;
  double Correction = 1.0;
  bool LastIsBest = false;
  bool Found = false;
  Eigen::VectorXd Best;
};
}

const char* Sentence(MapFailure failure)
{
  switch (failure)
  {
    case MapFailure::TooManyCells:
      return "its grid would have more than 100 million cells, for which edges are to be longer";
    case MapFailure::NoSolution:
      return "the equations of its grid could not be solved";
    case MapFailure::OutOfRange:
      return "its grid has too many lines, or its equations are not well posed";
    case MapFailure::ExcessiveArea:
      return "its grid would have far more cells than it is to have faces";
  }
  return "";
}

IntegerGridMap::IntegerGridMap(
  const CutMesh& mesh, const Settings& settings, const Progress& progress)
  : Plane(mesh.Degree)
{
  ParametrizationEnergy energy(mesh, settings.PerLength);
  this->Solve(energy, settings, progress);
}

IntegerGridMap::IntegerGridMap(
  ParametrizationEnergy& energy, const Settings& settings, const Progress& progress)
  : Plane(energy.GetMesh().Degree)
{
  this->Solve(energy, settings, progress);
}

void IntegerGridMap::Solve(
  ParametrizationEnergy& energy, const Settings& settings, const Progress& progress)
{
  const CutMesh& mesh = energy.GetMesh();
  this->NumberOfIntegers = energy.GetNumberOfIntegers();
  progress.Report(0.2);
  const double actual = AreaInSpace(mesh, settings, this->Plane);
  if (actual > MostCells)
  {
    this->Failure = MapFailure::TooManyCells;
    return;
  }
  RoundedMinimum minimum(energy, settings.PerLength);
  progress.Report(0.7);
  double scale =
    minimum.ScaleForArea(settings.KeepsArea ? WantedArea(mesh, settings, this->Plane) : 0.0);
  AreaSearch search(settings, actual, mesh.Triangles.size());
  for (int k = 0; k <= MostScalings && !search.IsFound(); ++k)
  {
    std::optional<Eigen::VectorXd> free = minimum.At(scale);
    if (!free)
    {
      this->Failure = MapFailure::NoSolution;
      return;
    }
    progress.Report(0.9);
    this->Evaluate(energy.GetVariables(), *free);
    if (this->Failure)
    {
      return;
    }
    search.Add(std::move(*free), this->AreaCovered(true), this->AreaCovered(false));
    scale *= search.GetCorrection();
  }
  if (search.IsExcessive())
  {
    this->Failure = MapFailure::ExcessiveArea;
    return;
  }
  const bool isFolded = this->CountFlipped() > 0 && settings.IsUnfolded;
  if (!search.IsLastBest() || isFolded)
  {
    this->Evaluate(energy.GetVariables(), search.GetBest(),
      settings.IsUnfolded ? &settings.PerLength : nullptr, progress);
  }
}

namespace
{
/// The values of all variables in fixed-point numbers: the free ones rounded to these, the others
/// exact sums of the free ones.
std::vector<std::int64_t> ValuesOf(IntegerElimination& elimination, const Eigen::VectorXd& free)
{
  const Index count = elimination.GetNumberOfVariables();
  std::vector<std::int64_t> value(count, 0);
  Index next = 0;
  for (const bool areIntegers : { false, true })
  {
    for (Index v = 0; v < count; ++v)
    {
      if (elimination.IsFree(v) && elimination.IsInteger(v) == areIntegers)
      {
        value[v] = areIntegers ? std::llround(free[next]) * IntegerGrid::Unit
                               : std::llround(free[next] * static_cast<double>(IntegerGrid::Unit));
        ++next;
      }
    }
  }
  for (Index v = 0; v < count; ++v)
  {
    if (!elimination.IsFree(v))
    {
      for (const auto& [w, p] : elimination.Resolve(v))
      {
        value[v] += p * value[w];
      }
    }
  }
  return value;
}

/// From the chart of each corner's vertex to the chart of its triangle.
std::vector<Transition> OwnTransitions(const ParametrizationVariables& variables,
  const IntegerGrid& plane, const std::vector<std::int64_t>& value)
{
  const CutMesh& mesh = variables.Mesh;
  std::vector<Transition> own(3 * mesh.Triangles.size());
  for (std::size_t h = 0; h < own.size(); ++h)
  {
    const SymbolicTransition& symbolic = mesh.Triangles[h / 3].Corner[h % 3];
    own[h].Turn = symbolic.Turn;
    for (const Jump& jump : symbolic.Jumps)
    {
      const Index v = 2 * (variables.Vertices + jump.Variable);
      own[h].Shift = own[h].Shift + plane.Turned({ value[v], value[v + 1] }, jump.Turn);
    }
  }
  return own;
}
}

void IntegerGridMap::Evaluate(ParametrizationVariables& variables, const Eigen::VectorXd& free,
  const std::vector<double>* perLength, const Progress& progress)
{
  if (!(free.array().abs() < IntegerGrid::Range).all())
  {
    this->Failure = MapFailure::OutOfRange;
    return;
  }
  const CutMesh& mesh = variables.Mesh;
  const std::vector<std::int64_t> value = ValuesOf(variables.Solved, free);
  const std::vector<Transition> own = OwnTransitions(variables, this->Plane, value);
  std::vector<GridPoint> places(variables.Vertices);
  for (Index v = 0; v < variables.Vertices; ++v)
  {
    places[v] = { value[2 * v], value[2 * v + 1] };
  }
  this->CollapsedFeatures.clear();
  for (const FeatureIsoline& isoline : UnfoldIsolines(mesh, own, variables.Isolines, places))
  {
    this->Collapse(mesh, isoline);
  }
  if (perLength != nullptr)
  {
    MovablePlaces movable(mesh, own, variables.IsPoint, *perLength, places);
    UnfoldTriangles(movable, progress);
  }
  this->Corners.resize(own.size());
  for (std::size_t h = 0; h < own.size(); ++h)
  {
    this->Corners[h] = this->Plane.Apply(own[h], places[mesh.Triangles[h / 3].Vertex[h % 3]]);
  }
  this->FindFoldedFeatures(mesh, variables.Isolines);
  this->FindTransitions(mesh, own);
}

void IntegerGridMap::FindTransitions(const CutMesh& mesh, const std::vector<Transition>& own)
{
  std::vector<char> isCone(mesh.Positions.size(), 0);
  for (const CutMesh::Cone& cone : mesh.Cones)
  {
    isCone[cone.Vertex] = 1;
  }
  this->Across.resize(own.size());
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

void IntegerGridMap::Collapse(const CutMesh& mesh, const FeatureIsoline& isoline)
{
  for (const FeatureIsoline::Step& step : isoline.Steps)
  {
    this->CollapsedFeatures.push_back(mesh.Isolines[step.Isoline].Edge);
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
  const CutMesh& mesh, const std::vector<FeatureIsoline>& isolines)
{
  for (const FeatureIsoline& isoline : isolines)
  {
    double length = 0.0;
    std::size_t flipped = 0;
    for (const FeatureIsoline::Step& step : isoline.Steps)
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
      2 * FoldedPart * static_cast<double>(isoline.Steps.size()) < static_cast<double>(flipped))
    {
      this->Collapse(mesh, isoline);
    }
  }
}
}
