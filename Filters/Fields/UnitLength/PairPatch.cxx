// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "UnitLength/PairPatch.h"

#include "Matrices/SparseColumns.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// Steps of the phases towards the least energy, after the one that cancels the pair, are longer by
/// this.
constexpr double OverRelaxation = 1.3;
/// Added to the diagonal, relative to its mean, where nothing is held.
constexpr double Regularization = 1e-9;
/// The matrices of patches with no more rings than this are factored as they stand, others in an
/// order of their own; so are those with a vertex of more neighbours than this, which would fill
/// the band.
constexpr Index MostBandedRings = 4;
constexpr Index MostBandedNeighbours = 32;
}

PatchNumbers::Loan::Loan(PatchNumbers& owner)
  : Owner(owner)
{
  {
    const std::lock_guard<std::mutex> guard(owner.Lock);
    if (!owner.Free.empty())
    {
      this->Numbers = std::move(owner.Free.back());
      owner.Free.pop_back();
    }
  }
  if (!this->Numbers)
  {
    this->Numbers = std::make_unique<std::vector<Index>>(owner.Vertices, None);
  }
}

PatchNumbers::Loan::~Loan()
{
  for (const Index v : this->Used)
  {
    (*this->Numbers)[v] = None;
  }
  const std::lock_guard<std::mutex> guard(this->Owner.Lock);
  this->Owner.Free.push_back(std::move(this->Numbers));
}

void PatchNumbers::Loan::Set(Index v, Index number)
{
  (*this->Numbers)[v] = number;
  this->Used.push_back(v);
}

PairPatch::PairPatch(
  const UnitLengthProblem& problem, const SingularityPair& pair, Index rings, PatchNumbers& numbers)
  : Problem(problem)
  , Pair(pair)
  , Numbers(numbers)
  , Rings(rings)
  , EnergyChange(std::numeric_limits<double>::infinity())
{
  const TriangleMesh& mesh = problem.Geometry.Mesh;
  PatchNumbers::Loan number(numbers);
  // Each vertex has the place along the path from which it was reached.
  std::vector<Index> places;
  const auto add = [&](Index v, Index place)
  {
    if (number[v] == None && problem.IsFree(v))
    {
      number.Set(v, place);
      this->Vertices.push_back(v);
      places.push_back(place);
    }
  };
  for (std::size_t k = 0; k < pair.Crossed.size(); ++k)
  {
    add(mesh.Tail(pair.Crossed[k]) - problem.Component.FirstVertex, static_cast<Index>(k));
    add(mesh.Head(pair.Crossed[k]) - problem.Component.FirstVertex, static_cast<Index>(k));
  }
  const SparseColumns columns(problem.Matrix);
  std::size_t begin = 0;
  for (Index ring = 0; ring < rings; ++ring)
  {
    const std::size_t end = this->Vertices.size();
    for (std::size_t k = begin; k < end; ++k)
    {
      const Index v = this->Vertices[k];
      const Index place = places[k];
      std::for_each(columns.Row + columns.Begin[v], columns.Row + columns.Begin[v + 1],
        [&](Index other) { add(other, place); });
    }
    begin = end;
  }
  this->SortAlong(places, static_cast<Index>(pair.Crossed.size()));
  // Given vertices next to an inner ring may be neighbours, too.
  for (const Index v : this->Vertices)
  {
    for (Index e = columns.Begin[v]; e < columns.Begin[v + 1]; ++e)
    {
      const Index other = columns.Row[e];
      if (number[other] == None)
      {
        number.Set(other, std::numeric_limits<Index>::max());
        this->Neighbours.push_back(other);
      }
    }
  }
}

/// Brings the vertices in the order of their places along the path, which makes the matrices of
/// narrow patches banded.
void PairPatch::SortAlong(const std::vector<Index>& places, Index count)
{
  std::vector<Index> next(count + 1, 0);
  for (const Index place : places)
  {
    ++next[place + 1];
  }
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<Index> sorted(places.size());
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    sorted[next[places[k]]++] = this->Vertices[k];
  }
  this->Vertices = std::move(sorted);
}

/// The energy within a patch as a function of the phases of its vertices.
struct PairPatch::System
{
  System(const PairPatch& patch, const ComplexVector& u, const PatchNumbers::Loan& number)
    : Rows(static_cast<Index>(patch.Vertices.size()))
    , Begin(1, 0)
    , Held(Rows)
    , Before(Rows)
  {
    const SparseColumns columns(patch.Problem.Matrix);
    const Complex* const mass = patch.Problem.Mass.valuePtr();
    const bool pulled = patch.Problem.Pull.size() > 0;
    Eigen::VectorXd diagonal(this->Rows);
    std::vector<Index> lower(1, 0);
    std::vector<Index> lowerRows;
    std::vector<double> lowerValues;
    this->IsBanded = patch.Rings <= MostBandedRings;
    for (Index k = 0; k < this->Rows; ++k)
    {
      const Index v = patch.Vertices[k];
      this->Before[k] = u[v];
      this->Held[k] = pulled ? -patch.Problem.Pull[v] : Complex(0.0);
      diagonal[k] = pulled ? std::abs(patch.Problem.Pull[v]) : 0.0;
      lowerRows.push_back(k);
      lowerValues.push_back(0.0);
      this->IsBanded =
        this->IsBanded && columns.Begin[v + 1] - columns.Begin[v] <= MostBandedNeighbours;
      for (Index e = columns.Begin[v]; e < columns.Begin[v + 1]; ++e)
      {
        const Index other = columns.Row[e];
        const Index place = number[other];
        if (place == None)
        {
          this->Held[k] += std::conj(columns.Value[e]) * u[other];
        }
        else
        {
          this->Column.push_back(place);
          this->Value.push_back(std::conj(columns.Value[e]));
        }
        const double weight = other == v ? 0.0 : Weight(columns.Value[e], mass[e]);
        diagonal[k] += weight;
        if (place != None && place > k && weight > 0.0)
        {
          lowerRows.push_back(place);
          lowerValues.push_back(-weight);
        }
      }
      this->Begin.push_back(static_cast<Index>(this->Column.size()));
      lower.push_back(static_cast<Index>(lowerRows.size()));
    }
    const double least = Regularization * diagonal.mean();
    for (Index k = 0; k < this->Rows; ++k)
    {
      lowerValues[lower[k]] = diagonal[k] + least;
    }
    // Eigen asks for rows that ascend; the transpose of any matrix has them.
    const Matrix upper = Eigen::Map<const Matrix>(this->Rows, this->Rows,
      static_cast<Index>(lowerRows.size()), lower.data(), lowerRows.data(), lowerValues.data())
                           .transpose();
    const Matrix matrix = upper.transpose();
    if (this->IsBanded)
    {
      this->Banded.compute(matrix);
      this->IsFactored = this->Banded.info() == Eigen::Success;
    }
    else
    {
      this->Factor.compute(matrix);
      this->IsFactored = this->Factor.info() == Eigen::Success;
    }
  }

  Eigen::VectorXd Solve(const Eigen::VectorXd& right) const
  {
    if (this->IsBanded)
    {
      return this->Banded.solve(right);
    }
    return this->Factor.solve(right);
  }

  /// How strongly an entry of the energy draws the values of its two vertices together.
  static double Weight(const Complex& energy, const Complex& mass)
  {
    const double squared = std::norm(mass);
    return squared > 0.0 ? std::max(0.0, -(energy * std::conj(mass)).real() / std::sqrt(squared))
                         : 0.0;
  }

  /// A u - p in row k.
  Complex Gradient(Index k, const std::vector<Complex>& values) const
  {
    Complex sum = this->Held[k];
    for (Index e = this->Begin[k]; e < this->Begin[k + 1]; ++e)
    {
      sum += this->Value[e] * values[this->Column[e]];
    }
    return sum;
  }

  /// Half of the derivative of the energy by each phase.
  Eigen::VectorXd Slope(const std::vector<Complex>& values) const
  {
    Eigen::VectorXd slope(this->Rows);
    for (Index k = 0; k < this->Rows; ++k)
    {
      slope[k] = (std::conj(values[k]) * this->Gradient(k, values)).imag();
    }
    return slope;
  }

  using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, Index>;
  Index Rows;
  std::vector<Index> Begin;
  std::vector<Index> Column;
  std::vector<Complex> Value;
  /// The held values' contribution to each row.
  std::vector<Complex> Held;
  std::vector<Complex> Before;
  bool IsBanded;
  bool IsFactored;
  Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Eigen::NaturalOrdering<Index>> Banded;
  Eigen::SimplicialLDLT<Matrix, Eigen::Lower> Factor;
};

void PairPatch::Try(const ComplexVector& u)
{
  if (this->Vertices.empty())
  {
    return;
  }
  PatchNumbers::Loan number(this->Numbers);
  for (std::size_t k = 0; k < this->Vertices.size(); ++k)
  {
    number.Set(this->Vertices[k], static_cast<Index>(k));
  }
  const System system(*this, u, number);
  if (!system.IsFactored)
  {
    return;
  }
  Eigen::VectorXd right = -system.Slope(system.Before);
  // Along the path the difference of the two ends of an edge changes by a full turn.
  const SparseColumns columns(this->Problem.Matrix);
  const TriangleMesh& mesh = this->Problem.Geometry.Mesh;
  for (const Index h : this->Pair.Crossed)
  {
    const Index tail = mesh.Tail(h) - this->Problem.Component.FirstVertex;
    const Index head = mesh.Head(h) - this->Problem.Component.FirstVertex;
    for (Index e = columns.Begin[tail]; e < columns.Begin[tail + 1]; ++e)
    {
      if (columns.Row[e] == head)
      {
        const double jump = 2.0 * Pi * this->Pair.Change *
          System::Weight(columns.Value[e], this->Problem.Mass.valuePtr()[e]);
        right[std::max(0, number[tail])] += number[tail] != None ? jump : 0.0;
        right[std::max(0, number[head])] -= number[head] != None ? jump : 0.0;
      }
    }
  }
  Eigen::VectorXd x = system.Solve(right);
  this->Values.resize(this->Vertices.size());
  for (Index k = 0; k < system.Rows; ++k)
  {
    this->Values[k] = system.Before[k] * std::polar(1.0, x[k]);
  }
  x = system.Solve(system.Slope(this->Values));
  for (Index k = 0; k < system.Rows; ++k)
  {
    this->Values[k] *= std::polar(1.0, -OverRelaxation * x[k]);
    this->Values[k] /= std::sqrt(std::norm(this->Values[k]));
  }
  // E(v) - E(u) = Re (v - u)^* (grad(v) + grad(u)), since E is quadratic up to a constant.
  this->EnergyChange = 0.0;
  for (Index k = 0; k < system.Rows; ++k)
  {
    this->EnergyChange += (std::conj(this->Values[k] - system.Before[k]) *
      (system.Gradient(k, this->Values) + system.Gradient(k, system.Before)))
                            .real();
  }
}

int PairPatch::CountIndexChange(const ComplexVector& u) const
{
  PatchNumbers::Loan number(this->Numbers);
  for (std::size_t k = 0; k < this->Vertices.size(); ++k)
  {
    number.Set(this->Vertices[k], static_cast<Index>(k));
  }
  return this->CountIndices(u, number, true) - this->CountIndices(u, number, false);
}

int PairPatch::CountIndices(
  const ComplexVector& u, const PatchNumbers::Loan& number, bool changed) const
{
  const UnitLengthProblem& problem = this->Problem;
  const TriangleMesh& mesh = problem.Geometry.Mesh;
  const Index first = problem.Component.FirstVertex;
  const auto value = [&](Index v)
  {
    const Index place = changed ? number[v - first] : None;
    return place == None ? u[v - first] : this->Values[place];
  };
  std::vector<Index> triangles;
  for (const Index v : this->Vertices)
  {
    Index h = mesh.Outgoing(first + v);
    do
    {
      triangles.push_back(h / 3);
      h = mesh.NextOutgoing(h);
    } while (h != None && h != mesh.Outgoing(first + v));
  }
  std::sort(triangles.begin(), triangles.end());
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  int count = 0;
  for (const Index t : triangles)
  {
    if (problem.IsAtGiven(t))
    {
      continue;
    }
    double sum = problem.Degree * problem.Geometry.Transport.Curvature[t];
    for (Index h = 3 * t; h < 3 * t + 3; ++h)
    {
      // In the direction of the edge, so that both its triangles see the same.
      const Index along = mesh.HalfEdge(mesh.Edge(h));
      const double angle = std::arg(value(mesh.Head(along)) * std::conj(value(mesh.Tail(along))) *
        std::polar(1.0, -problem.Degree * problem.Geometry.Transport.Rotation[mesh.Edge(h)]));
      sum += along == h ? angle : -angle;
    }
    count += std::abs(static_cast<int>(std::lround(sum / (2.0 * Pi))));
  }
  return count;
}
}
