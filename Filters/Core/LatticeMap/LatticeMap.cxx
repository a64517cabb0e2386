// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LatticeMap/LatticeMap.h"

#include "LatticeMap/IntegerRounding.h"
#include "LatticeMap/IsolineFolds.h"
#include "LatticeMap/LatticeSystem.h"
#include "LatticeMap/MapUnknowns.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

namespace DirectionFields::Internal
{
/// The energy as a quadratic function of the free variables, those that are real before the integers.
struct LatticeMap::Energy
{
  Energy(const Lattice& plane, MapUnknowns& unknowns, const std::vector<double>& perLength)
    : Plane(plane)
    , All(unknowns)
    , Slot(unknowns.Solved.GetNumberOfVariables(), None)
  {
    for (const bool areIntegers : { false, true })
    {
      for (Index v = 0; v < unknowns.Solved.GetNumberOfVariables(); ++v)
      {
        if (unknowns.Solved.IsFree(v) && unknowns.Solved.IsInteger(v) == areIntegers)
        {
          this->Slot[v] = this->Count++;
        }
      }
      this->Reals = areIntegers ? this->Reals : this->Count;
    }
    const ChartedMesh& mesh = unknowns.Mesh;
    for (Index t = 0; t < static_cast<Index>(mesh.Triangles.size()); ++t)
    {
      for (int c = 0; c < 3; ++c)
      {
        const ChartedMesh::MapTriangle& triangle = mesh.Triangles[t];
        const Index twin = triangle.Twin[c];
        if (twin != None && twin < 3 * t + c)
        {
          continue;
        }
        const double beyond = twin != None ? mesh.Triangles[twin / 3].Weight[twin % 3] : 0.0;
        const double size =
          0.5 * (perLength[triangle.Vertex[c]] + perLength[triangle.Vertex[(c + 1) % 3]]);
        this->Edges.push_back({ 3 * t + c, size * triangle.Target[c],
          std::max(LeastWeight, triangle.Weight[c] + beyond) });
        this->AddEdge(this->Edges.back());
      }
    }
  }

  /// An edge, the half-edge of it that its target is in the chart of.
  struct Edge
  {
    Index HalfEdge;
    Complex Target;
    double Weight;
  };

  void AddEdge(const Edge& edge)
  {
    const Index t = edge.HalfEdge / 3;
    const int c = edge.HalfEdge % 3;
    LatticeSum difference = this->All.Corner(t, (c + 1) % 3);
    difference.Add(this->All.Corner(t, c), -1);
    const std::array<IntegerSum, 2> sums = { this->All.Solved.Resolve(difference.A),
      this->All.Solved.Resolve(difference.B) };
    // |a + b zeta|^2 = a^2 + b^2 + 2 Re(zeta) a b
    const double mixed = this->Mixed();
    for (int i = 0; i < 2; ++i)
    {
      for (const auto& [v, p] : sums[i])
      {
        const Index row = this->Slot[v];
        this->Terms.emplace_back(row, static_cast<double>(p));
        for (int j = 0; j < 2; ++j)
        {
          const double factor = edge.Weight * static_cast<double>(p) * (i == j ? 1.0 : mixed);
          for (const auto& [w, q] : sums[j])
          {
            const Index column = this->Slot[w];
            if (factor != 0.0 && column <= row)
            {
              this->Entries.emplace_back(row, column, factor * static_cast<double>(q));
            }
          }
        }
      }
      this->TermsEnd.push_back(this->Terms.size());
    }
  }
  double Mixed() const { return this->All.Degree == 4 ? 0.0 : 0.5; }

  /// The linear part of the energy.
  Eigen::VectorXd RightHandSide() const
  {
    Eigen::VectorXd side = Eigen::VectorXd::Zero(this->Count);
    std::size_t k = 0;
    for (std::size_t e = 0; e < this->Edges.size(); ++e)
    {
      const std::array<double, 2> target = this->Plane.Coordinates(this->Edges[e].Target);
      for (int i = 0; i < 2; ++i)
      {
        const double value = this->Edges[e].Weight * (target[i] + this->Mixed() * target[1 - i]);
        for (; k < this->TermsEnd[2 * e + i]; ++k)
        {
          side[this->Terms[k].first] += this->Terms[k].second * value;
        }
      }
    }
    return side;
  }

  /// The least value of each integer.
  Eigen::VectorXd Least() const
  {
    Eigen::VectorXd least = Eigen::VectorXd::Constant(
      this->Count - this->Reals, -std::numeric_limits<double>::infinity());
    for (const Index v : this->All.Bounded)
    {
      least[this->Slot[v] - this->Reals] = 1.0;
    }
    return least;
  }

  /// The area of the triangles' images, in unit cells' parallelograms.
  double AreaAt(const Eigen::VectorXd& x)
  {
    double area = 0.0;
    for (Index t = 0; t < static_cast<Index>(this->All.Mesh.Triangles.size()); ++t)
    {
      std::array<std::array<double, 2>, 2> edges{};
      for (int c = 0; c < 2; ++c)
      {
        LatticeSum edge = this->All.Corner(t, c + 1);
        edge.Add(this->All.Corner(t, 0), -1);
        edges[c] = { this->ValueOf(edge.A, x), this->ValueOf(edge.B, x) };
      }
      area += 0.5 * (edges[0][0] * edges[1][1] - edges[0][1] * edges[1][0]);
    }
    return area;
  }
  double ValueOf(const IntegerSum& sum, const Eigen::VectorXd& x)
  {
    double value = 0.0;
    for (const auto& [v, p] : this->All.Solved.Resolve(sum))
    {
      value += static_cast<double>(p) * x[this->Slot[v]];
    }
    return value;
  }

  static constexpr double LeastWeight = 0.05;
  const Lattice& Plane;
  MapUnknowns& All;
  /// The place of each free variable in the system.
  std::vector<Index> Slot;
  Index Count = 0;
  Index Reals = 0;
  std::vector<Eigen::Triplet<double, std::int32_t>> Entries;
  std::vector<Edge> Edges;
  /// The variables that the two coordinates of each edge are sums of, and where those of each coordinate end.
  std::vector<std::pair<Index, double>> Terms;
  std::vector<std::size_t> TermsEnd;
};

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

double MeanPerLength(const LatticeMap::Settings& settings, const ChartedMesh::MapTriangle& triangle)
{
  return (settings.PerLength[triangle.Vertex[0]] + settings.PerLength[triangle.Vertex[1]] +
           settings.PerLength[triangle.Vertex[2]]) /
    3.0;
}

/// The area that the targets ask for, in parallelograms of the lattice.
double WantedArea(
  const ChartedMesh& mesh, const LatticeMap::Settings& settings, const Lattice& plane)
{
  double wanted = 0.0;
  for (const ChartedMesh::MapTriangle& t : mesh.Triangles)
  {
    const double size = MeanPerLength(settings, t);
    const double area = 0.5 * (std::conj(t.Target[0]) * -t.Target[2]).imag();
    wanted += size * size * std::max(0.0, area);
  }
  return wanted / plane.Combined(0.0, 1.0).imag();
}

/// The area that the triangles have in space, in parallelograms of the lattice.
double AreaInSpace(
  const ChartedMesh& mesh, const LatticeMap::Settings& settings, const Lattice& plane)
{
  double area = 0.0;
  for (const ChartedMesh::MapTriangle& t : mesh.Triangles)
  {
    const double size = MeanPerLength(settings, t);
    const Vector3 a = size * (mesh.Positions[t.Vertex[1]] - mesh.Positions[t.Vertex[0]]);
    const Vector3 b = size * (mesh.Positions[t.Vertex[2]] - mesh.Positions[t.Vertex[0]]);
    area += 0.5 * a.cross(b).norm();
  }
  return area / plane.Combined(0.0, 1.0).imag();
}
}

LatticeMap::LatticeMap(const ChartedMesh& mesh, const Settings& settings, const Progress& progress)
  : Plane(mesh.Degree)
{
  MapUnknowns unknowns(mesh);
  unknowns.BoundStretches(settings.PerLength);
  Energy energy(this->Plane, unknowns, settings.PerLength);
  this->NumberOfIntegers = energy.Count - energy.Reals;
  progress.Report(0.2);
  const double wanted = settings.KeepsArea ? WantedArea(mesh, settings, this->Plane) : 0.0;
  const auto scaleOf = [&](const Eigen::VectorXd& relaxed)
  {
    const double reached = wanted > 0.0 ? energy.AreaAt(relaxed) : 0.0;
    return reached > 0.25 * wanted && wanted > 0.0 ? std::sqrt(wanted / reached) : 1.0;
  };
  const Eigen::VectorXd side = energy.RightHandSide();
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
  std::optional<LatticeSystem> system;
  Eigen::VectorXd relaxed;
  if (this->NumberOfIntegers > MostRounded)
  {
    solve = [&](double factor)
    { return SolveInRounds(energy.Entries, factor * side, energy.Reals); };
  }
  else
  {
    system.emplace(energy.Entries, energy.Count, energy.Reals);
    progress.Report(0.7);
    if (system->IsDefinite())
    {
      relaxed = system->Solve(side);
      scale = scaleOf(relaxed);
    }
    solve = [&](double factor) -> Eigen::VectorXd
    {
      if (!system->IsDefinite())
      {
        return {};
      }
      Eigen::VectorXd integers = factor * relaxed.tail(this->NumberOfIntegers);
      RoundGreedily(system->TrailingFactor(), integers, energy.Least());
      return system->SolveWith(factor * side, integers);
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
    if (x.size() == 0 && energy.Count > 0)
    {
      this->Failure = "the equations of its grid could not be solved";
      return;
    }
    progress.Report(0.9);
    this->Evaluate(mesh, unknowns, x);
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
    this->Evaluate(mesh, unknowns, best);
  }
  if (settings.KeepsArea && bestArea > MostBeyond * most)
  {
    this->Failure = "its grid would have far more cells than it is to have faces";
  }
}

void LatticeMap::Evaluate(
  const ChartedMesh& mesh, MapUnknowns& unknowns, const Eigen::VectorXd& free)
{
  if (!(free.array().abs() < Lattice::Range).all())
  {
    this->Failure = "its grid has too many lines, or its equations are not well posed";
    return;
  }
  this->CollapsedFeatures.clear();
  const Index count = unknowns.Solved.GetNumberOfVariables();
  std::vector<std::int64_t> value(count, 0);
  std::vector<Index> slot(count, None);
  Index next = 0;
  for (const bool areIntegers : { false, true })
  {
    for (Index v = 0; v < count; ++v)
    {
      if (unknowns.Solved.IsFree(v) && unknowns.Solved.IsInteger(v) == areIntegers)
      {
        value[v] = areIntegers ? std::llround(free[next]) * Lattice::Unit
                               : std::llround(free[next] * static_cast<double>(Lattice::Unit));
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
  for (const ChartedMesh::Cone& cone : mesh.Cones)
  {
    isCone[cone.Vertex] = 1;
  }
  std::vector<LatticePoint> places(unknowns.Vertices);
  for (Index v = 0; v < unknowns.Vertices; ++v)
  {
    places[v] = { value[2 * v], value[2 * v + 1] };
  }
  for (std::size_t h = 0; h < own.size(); ++h)
  {
    own[h] = transition(mesh.Triangles[h / 3].Corner[h % 3]);
  }
  for (const IsolineStretch& stretch : UnfoldIsolines(mesh, own, unknowns.Stretches, places))
  {
    for (const IsolineStretch::Step& step : stretch.Steps)
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

bool LatticeMap::IsFlipped(Index t) const
{
  const LatticePoint* corner = &this->Corners[3 * static_cast<std::size_t>(t)];
  return Lattice::Orientation(corner[0], corner[1], corner[2]) <= 0;
}

Index LatticeMap::CountFlipped() const
{
  Index flipped = 0;
  for (Index t = 0; t < static_cast<Index>(this->Corners.size() / 3); ++t)
  {
    flipped += this->IsFlipped(t) ? 1 : 0;
  }
  return flipped;
}

double LatticeMap::AreaCovered(bool withFolds) const
{
  double area = 0.0;
  for (std::size_t h = 0; h < this->Corners.size(); h += 3)
  {
    const LatticePoint u = this->Corners[h + 1] - this->Corners[h];
    const LatticePoint v = this->Corners[h + 2] - this->Corners[h];
    const double twice = static_cast<double>(u.A) * static_cast<double>(v.B) -
      static_cast<double>(u.B) * static_cast<double>(v.A);
    area += withFolds ? std::max(0.0, 0.5 * twice) : 0.5 * twice;
  }
  return area / (static_cast<double>(Lattice::Unit) * static_cast<double>(Lattice::Unit));
}

void LatticeMap::FindFoldedFeatures(
  const ChartedMesh& mesh, const std::vector<IsolineStretch>& stretches)
{
  for (const IsolineStretch& stretch : stretches)
  {
    double length = 0.0;
    std::size_t flipped = 0;
    for (const IsolineStretch::Step& step : stretch.Steps)
    {
      const ChartedMesh::IsolineEdge& edge = mesh.Isolines[step.Isoline];
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
      for (const IsolineStretch::Step& step : stretch.Steps)
      {
        this->CollapsedFeatures.push_back(mesh.Isolines[step.Isoline].Edge);
      }
    }
  }
}
}
