// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LatticeMap/LatticeMap.h"

#include "LatticeMap/IntegerElimination.h"
#include "LatticeMap/IntegerRounding.h"
#include "LatticeMap/IsolineFolds.h"
#include "LatticeMap/LatticeSystem.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace DirectionFields::Internal
{
namespace
{
/// A point of the lattice's plane whose coordinates are sums of variables.
struct LatticeSum
{
  IntegerSum A;
  IntegerSum B;

  static void Append(IntegerSum& to, const IntegerSum& from, std::int64_t factor)
  {
    for (const auto& [variable, coefficient] : from)
    {
      to.emplace_back(variable, factor * coefficient);
    }
  }
  void Add(const LatticeSum& other, std::int64_t factor)
  {
    Append(this->A, other.A, factor);
    Append(this->B, other.B, factor);
  }
  /// zeta^turn times this.
  LatticeSum Turned(int turn, int degree) const
  {
    LatticeSum turned = *this;
    for (int k = 0; k < turn; ++k)
    {
      LatticeSum next;
      Append(next.A, turned.B, -1);
      next.B = turned.A;
      if (degree == 6)
      {
        Append(next.B, turned.B, 1);
      }
      turned = std::move(next);
    }
    return turned;
  }
};
}

/// The variables: two coordinates of each vertex in its own chart, of each jump, and one for each feature at
/// a vertex, that across it. Elimination leaves those that are free.
struct LatticeMap::Unknowns
{
  explicit Unknowns(const ChartedMesh& mesh)
    : Mesh(mesh)
    , Degree(mesh.Degree)
    , Vertices(static_cast<Index>(mesh.Positions.size()))
    , Solved(this->Flags())
  {
    this->FixOrigin();
    for (const ChartedMesh::Cone& cone : mesh.Cones)
    {
      LatticeSum image = this->Vertex(cone.Vertex).Turned(cone.Holonomy.Turn, this->Degree);
      image.Add(this->Jumps(cone.Holonomy), 1);
      image.Add(this->Vertex(cone.Vertex), -1);
      this->Solved.Require(image.A);
      this->Solved.Require(image.B);
    }
    for (const auto& [key, variable] : this->AcrossFeature)
    {
      IntegerSum definition = this->Vertex(key.first).Turned(key.second, this->Degree).B;
      definition.emplace_back(variable, -1);
      this->Solved.Require(definition);
    }
    for (const ChartedMesh::IsolineEdge& edge : mesh.Isolines)
    {
      LatticeSum along = this->Corner(edge.Triangle, (edge.Corner + 1) % 3);
      along.Add(this->Corner(edge.Triangle, edge.Corner), -1);
      this->Solved.Require(along.Turned((this->Degree - edge.Axis) % this->Degree, this->Degree).B);
    }
  }

  LatticeSum Vertex(Index v) const { return { { { 2 * v, 1 } }, { { 2 * v + 1, 1 } } }; }
  LatticeSum Jumps(const SymbolicTransition& t) const
  {
    LatticeSum sum;
    for (const Jump& jump : t.Jumps)
    {
      sum.Add(this->Vertex(this->Vertices + jump.Variable).Turned(jump.Turn, this->Degree), 1);
    }
    return sum;
  }
  /// The coordinates of a corner in the chart of its triangle.
  LatticeSum Corner(Index t, int c) const
  {
    const ChartedMesh::MapTriangle& triangle = this->Mesh.Triangles[t];
    LatticeSum sum = this->Vertex(triangle.Vertex[c]).Turned(triangle.Corner[c].Turn, this->Degree);
    sum.Add(this->Jumps(triangle.Corner[c]), 1);
    return sum;
  }

  /// Finds the features at each vertex, and returns which variables are to be integers.
  std::vector<char> Flags()
  {
    std::vector<char> isPoint(this->Vertices, 0);
    for (const ChartedMesh::Cone& cone : this->Mesh.Cones)
    {
      isPoint[cone.Vertex] = 1;
    }
    // Where a feature ends there is a lattice point, too.
    for (std::size_t v = 0; v < this->Mesh.IsChainEnd.size(); ++v)
    {
      isPoint[v] = isPoint[v] != 0 || this->Mesh.IsChainEnd[v] != 0 ? 1 : 0;
    }
    std::vector<char> flags(2 * (this->Vertices + this->Mesh.NumberOfJumps), 1);
    for (Index v = 0; v < this->Vertices; ++v)
    {
      flags[2 * v] = flags[2 * v + 1] = isPoint[v];
    }
    auto count = static_cast<Index>(flags.size());
    for (const ChartedMesh::IsolineEdge& edge : this->Mesh.Isolines)
    {
      const ChartedMesh::MapTriangle& triangle = this->Mesh.Triangles[edge.Triangle];
      for (const int c : { edge.Corner, (edge.Corner + 1) % 3 })
      {
        // zeta^-axis in the chart of the vertex, up to the sign.
        const int turn = (triangle.Corner[c].Turn + this->Degree - edge.Axis) % (this->Degree / 2);
        if (isPoint[triangle.Vertex[c]] == 0 &&
          this->AcrossFeature.emplace(std::pair(triangle.Vertex[c], turn), count).second)
        {
          ++count;
        }
      }
    }
    flags.resize(count, 1);
    return flags;
  }

  /// Of all maps that differ by a translation takes one that has a lattice point in 0.
  void FixOrigin()
  {
    Index origin = this->Mesh.Cones.empty() ? None : this->Mesh.Cones.front().Vertex;
    for (std::size_t v = 0; origin == None && v < this->Mesh.IsChainEnd.size(); ++v)
    {
      origin = this->Mesh.IsChainEnd[v] != 0 ? static_cast<Index>(v) : None;
    }
    if (origin == None && !this->AcrossFeature.empty())
    {
      origin = this->AcrossFeature.begin()->first.first;
    }
    if (origin != None)
    {
      this->Solved.Require({ { 2 * origin, 1 } });
      this->Solved.Require({ { 2 * origin + 1, 1 } });
    }
  }

  const ChartedMesh& Mesh;
  int Degree;
  Index Vertices;
  /// The variable of a vertex and the turn that makes it the second coordinate.
  std::map<std::pair<Index, int>, Index> AcrossFeature;
  IntegerElimination Solved;
};

/// The energy as a quadratic function of the free variables, those that are real before the integers.
struct LatticeMap::Energy
{
  Energy(const Lattice& plane, Unknowns& unknowns, const std::vector<double>& perLength)
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
  Unknowns& All;
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
/// The area that the targets ask for, in parallelograms of the lattice.
double WantedArea(
  const ChartedMesh& mesh, const LatticeMap::Settings& settings, const Lattice& plane)
{
  double wanted = 0.0;
  for (const ChartedMesh::MapTriangle& t : mesh.Triangles)
  {
    const double size = (settings.PerLength[t.Vertex[0]] + settings.PerLength[t.Vertex[1]] +
                          settings.PerLength[t.Vertex[2]]) /
      3.0;
    const double area = 0.5 * (std::conj(t.Target[0]) * -t.Target[2]).imag();
    wanted += size * size * std::max(0.0, area);
  }
  return wanted / plane.Combined(0.0, 1.0).imag();
}
}

LatticeMap::LatticeMap(const ChartedMesh& mesh, const Settings& settings, const Progress& progress)
  : Plane(mesh.Degree)
{
  Unknowns unknowns(mesh);
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
  Eigen::VectorXd x;
  if (this->NumberOfIntegers > MostRounded)
  {
    x = SolveInRounds(energy.Entries, side, energy.Reals);
  }
  else
  {
    const LatticeSystem system(energy.Entries, energy.Count, energy.Reals);
    progress.Report(0.7);
    if (system.IsDefinite())
    {
      x = system.Solve(side);
      const double scale = scaleOf(x);
      Eigen::VectorXd integers = scale * x.tail(this->NumberOfIntegers);
      RoundGreedily(system.TrailingFactor(), integers);
      x = system.SolveWith(scale * side, integers);
    }
  }
  if (x.size() == 0 && energy.Count > 0)
  {
    this->Failure = "the equations of its grid could not be solved";
    return;
  }
  progress.Report(0.9);
  this->Evaluate(mesh, unknowns, x);
}

void LatticeMap::Evaluate(const ChartedMesh& mesh, Unknowns& unknowns, const Eigen::VectorXd& free)
{
  if (!(free.array().abs() < Lattice::Range).all())
  {
    this->Failure = "its grid has too many lines, or its equations are not well posed";
    return;
  }
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
  std::vector<char> isFixed = isCone;
  for (std::size_t v = 0; v < mesh.IsChainEnd.size(); ++v)
  {
    isFixed[v] = isFixed[v] != 0 || mesh.IsChainEnd[v] != 0 ? 1 : 0;
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
  UnfoldIsolines(mesh, own, isFixed, places);
  for (std::size_t h = 0; h < own.size(); ++h)
  {
    this->Corners[h] = this->Plane.Apply(own[h], places[mesh.Triangles[h / 3].Vertex[h % 3]]);
  }
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

Index LatticeMap::CountFlipped() const
{
  Index flipped = 0;
  for (std::size_t h = 0; h < this->Corners.size(); h += 3)
  {
    flipped +=
      Lattice::Orientation(this->Corners[h], this->Corners[h + 1], this->Corners[h + 2]) > 0 ? 0
                                                                                             : 1;
  }
  return flipped;
}
}
