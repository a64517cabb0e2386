// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Stripes/StripeMatrices.h"

#include "Sections/SectionIntegrals.h"
#include "Support/SortFew.h"
#include "Support/Threads.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace DirectionFields::Internal
{
namespace
{
/// The share of a triangle without integrals in the masses along its edges, as a part of its area:
/// half of the share of other triangles, so that the matrix is positive definite for any steps.
constexpr double EdgeMass = 1.0 / 24.0;

/// The rows, energies and masses of a column, each row once.
struct Entry
{
  Index Row;
  Complex Energy;
  Complex Mass;
  bool operator<(const Entry& other) const { return this->Row < other.Row; }
};

/// Computes the columns of the first sheet, each from the fan of its node's vertex.
class StripeColumns
{
public:
  StripeColumns(
    const WantedPhases& wanted, const WantedPhases::Component& component, bool withSteps)
    : Wanted(wanted)
    , Geometry(wanted.GetField().GetGeometry())
    , Component(component)
    , WithSteps(withSteps)
  {
  }

  /// The number of entries of a node's column.
  Index Count(Index node)
  {
    const TriangleMesh& mesh = this->Geometry.Mesh;
    if (mesh.MayRepeatNeighbours() || mesh.GetComponents()[this->Component.Number].IsCover)
    {
      return static_cast<Index>(this->Of(node).size());
    }
    const Index vertex = this->Wanted.Vertex(node);
    mesh.GetFan(vertex, this->Fan);
    return static_cast<Index>(this->Fan.size()) + mesh.IsBoundary(vertex) + 1;
  }

  /// The column of a node in ascending order of the rows.
  const std::vector<Entry>& Of(Index node)
  {
    const TriangleMesh& mesh = this->Geometry.Mesh;
    const Index vertex = this->Wanted.Vertex(node);
    mesh.GetFan(vertex, this->Fan);
    this->Column.assign(1, { this->RowOf(vertex, false), 0.0, 0.0 });
    for (const Index h : this->Fan)
    {
      this->AddTriangle(h);
    }
    SortFew(this->Column);
    std::size_t last = 0;
    for (std::size_t k = 1; k < this->Column.size(); ++k)
    {
      const Entry& next = this->Column[k];
      if (next.Row == this->Column[last].Row)
      {
        this->Column[last].Energy += next.Energy;
        this->Column[last].Mass += next.Mass;
      }
      else
      {
        this->Column[++last] = next;
      }
    }
    this->Column.resize(last + 1);
    const Index diagonal = this->RowOf(vertex, false);
    for (Entry& entry : this->Column)
    {
      if (entry.Row == diagonal)
      {
        entry.Energy = entry.Energy.real();
        entry.Mass = entry.Mass.real();
      }
    }
    return this->Column;
  }

private:
  Index RowOf(Index vertex, bool onSecond) const
  {
    const Index v = this->Wanted.Node(vertex) - this->Component.FirstNode;
    return this->Component.HasTwoSheets ? 2 * v + (onSecond ? 1 : 0) : v;
  }

  WantedPhases::Step StepAlong(Index h) const
  {
    const WantedPhases::Step step = this->Wanted.Along(h);
    return { this->WithSteps ? step.Increment : 0.0, step.Flips };
  }

  /// Adds the share of the triangle to the left of an outgoing half-edge.
  void AddTriangle(Index h)
  {
    const TriangleMesh& mesh = this->Geometry.Mesh;
    const Index across = TriangleMesh::Next(h);
    const Index last = TriangleMesh::Previous(h);
    const auto squaredLength = [&](Index side)
    { return this->Geometry.Lengths.SquaredLength[mesh.Edge(side)]; };
    const WantedPhases::Step out = this->StepAlong(h);
    const WantedPhases::Step opposite = this->StepAlong(across);
    // The step back begins on the other sheet where the step flips.
    const WantedPhases::Step in = this->StepAlong(last);
    const double back = in.Flips ? -in.Increment : in.Increment;
    const Complex toHead = std::polar(1.0, 2.0 * Pi * out.Increment);
    const Complex toOther = std::polar(1.0, -2.0 * Pi * back);
    const double area = this->Geometry.Lengths.Area[h / 3];
    Entry head{ this->RowOf(mesh.Head(h), out.Flips), 0.0, 0.0 };
    Entry other{ this->RowOf(mesh.Tail(last), in.Flips), 0.0, 0.0 };
    Entry own{ this->Column.front().Row, 0.0, 0.0 };
    if ((out.Flips != opposite.Flips) == in.Flips)
    {
      const double flux =
        2.0 * Pi * (out.Increment + (out.Flips ? -opposite.Increment : opposite.Increment) + back);
      const LocalIntegrals local(
        { squaredLength(h), squaredLength(across), squaredLength(last) }, area, flux, 0.0);
      own.Energy = local.EnergyDiagonal(0);
      own.Mass = local.MassDiagonal();
      head.Energy = toHead * std::conj(local.Energy(0));
      head.Mass = toHead * std::conj(local.Mass());
      other.Energy = toOther * local.Energy(2);
      other.Mass = toOther * local.Mass();
    }
    else
    {
      // Half of the cotangent of the corner at the other end of an edge, if that is positive.
      const auto weight = [&](double squared, double a, double b)
      { return std::max(0.0, (a + b - squared) / (8.0 * area)); };
      const double atHead = weight(squaredLength(h), squaredLength(across), squaredLength(last));
      const double atOther = weight(squaredLength(last), squaredLength(across), squaredLength(h));
      own.Energy = atHead + atOther;
      own.Mass = area / 6.0;
      head.Energy = -atHead * toHead;
      head.Mass = EdgeMass * area * toHead;
      other.Energy = -atOther * toOther;
      other.Mass = EdgeMass * area * toOther;
    }
    this->Column.push_back(own);
    this->Column.push_back(head);
    this->Column.push_back(other);
  }

  const WantedPhases& Wanted;
  const SurfaceGeometry& Geometry;
  const WantedPhases::Component& Component;
  bool WithSteps;
  std::vector<Index> Fan;
  std::vector<Entry> Column;
};

/// Writes the column of a node's second sheet: rows of the other sheet, conjugate values.
void WriteSecond(const std::vector<Entry>& column, Index* rows, Complex* energy, Complex* mass)
{
  // The two rows of a node change their places, so that of two neighbours the order turns.
  std::vector<Entry> second = column;
  for (Entry& entry : second)
  {
    entry = { entry.Row ^ 1, std::conj(entry.Energy), std::conj(entry.Mass) };
  }
  SortFew(second);
  for (std::size_t k = 0; k < second.size(); ++k)
  {
    rows[k] = second[k].Row;
    energy[k] = second[k].Energy;
    mass[k] = second[k].Mass;
  }
}
}

Operators AssembleStripeMatrices(
  const WantedPhases& wanted, const WantedPhases::Component& component, bool withSteps)
{
  const Index sheets = component.HasTwoSheets ? 2 : 1;
  const Index n = sheets * component.Nodes();
  std::vector<Index> begin(n + 1, 0);
  ParallelFor(component.Nodes(), HeavyPiece,
    [&](Index first, Index end)
    {
      StripeColumns columns(wanted, component, withSteps);
      for (Index v = first; v < end; ++v)
      {
        std::fill_n(begin.begin() + sheets * v + 1, sheets, columns.Count(component.FirstNode + v));
      }
    });
  for (Index v = 0; v < n; ++v)
  {
    begin[v + 1] += begin[v];
  }
  Operators operators;
  for (SparseMatrix* matrix : { &operators.Energy, &operators.Mass })
  {
    matrix->resize(n, n);
    matrix->resizeNonZeros(begin.back());
    std::copy(begin.begin(), begin.end(), matrix->outerIndexPtr());
  }
  ParallelFor(component.Nodes(), HeavyPiece,
    [&](Index first, Index end)
    {
      StripeColumns columns(wanted, component, withSteps);
      Index* const rows = operators.Energy.innerIndexPtr();
      Complex* const energy = operators.Energy.valuePtr();
      Complex* const mass = operators.Mass.valuePtr();
      for (Index v = first; v < end; ++v)
      {
        const std::vector<Entry>& column = columns.Of(component.FirstNode + v);
        Index at = begin[sheets * v];
        for (const Entry& entry : column)
        {
          rows[at] = entry.Row;
          energy[at] = entry.Energy;
          mass[at++] = entry.Mass;
        }
        if (sheets == 2)
        {
          WriteSecond(column, rows + at, energy + at, mass + at);
        }
      }
      std::copy(rows + begin[sheets * first], rows + begin[sheets * end],
        operators.Mass.innerIndexPtr() + begin[sheets * first]);
    });
  return operators;
}

double TotalFlux(const WantedPhases& wanted, const WantedPhases::Component& component)
{
  const TriangleMesh& mesh = wanted.GetMesh();
  const TriangleMesh::Component& part = mesh.GetComponents()[component.Number];
  return 2.0 * Pi *
    ParallelSum(part.Triangles(), MediumPiece, 0.0,
      [&](Index begin, Index end)
      {
        double sum = 0.0;
        for (Index t = part.FirstTriangle + begin; t < part.FirstTriangle + end; ++t)
        {
          if (mesh.IsFront(t))
          {
            const WantedPhases::Turn turn = wanted.Around(t);
            sum += turn.Flips ? 0.0 : std::abs(turn.Sum);
          }
        }
        return sum;
      });
}
}
