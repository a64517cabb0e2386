// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Sections/Assembly.h"

#include "Sections/SectionIntegrals.h"
#include "Support/SortFew.h"
#include "Support/Threads.h"
#include "Support/VectorMath.h"

#include <algorithm>
#include <array>

namespace DirectionFields
{
namespace
{
struct Problem
{
  const IntrinsicGeometry& Geometry;
  const TriangleMesh::Component& Component;
  int Degree;
  double EnergyBias;
  /// r of each edge of the component in its direction.
  std::vector<Complex> Transport;
};

/// Computes columns of both matrices, each from the fan of its vertex.
class ColumnAssembler
{
public:
  explicit ColumnAssembler(const Problem& problem)
    : Given(problem)
  {
  }

  /// The number of entries of a vertex' column.
  Index Count(Index vertex)
  {
    const TriangleMesh& mesh = this->Given.Geometry.Mesh;
    mesh.GetFan(vertex, this->Fan);
    if (!mesh.MayRepeatNeighbours())
    {
      return static_cast<Index>(this->Fan.size()) + mesh.IsBoundary(vertex) + 1;
    }
    this->AddRows(vertex);
    SortFew(this->Order);
    Index count = 0;
    for (std::size_t k = 0; k < this->Order.size(); ++k)
    {
      count += k == 0 || this->Order[k].Row != this->Order[k - 1].Row;
    }
    return count;
  }

  void Fill(Index vertex, Index* rows, Complex* energy, Complex* mass)
  {
    this->Given.Geometry.Mesh.GetFan(vertex, this->Fan);
    this->AddRows(vertex);
    this->Integrate();
    SortFew(this->Order);
    Index at = -1;
    for (const Place& place : this->Order)
    {
      const Entry& entry = this->Column[place.Number];
      if (at >= 0 && rows[at] == place.Row)
      {
        // Two edges join the same vertices, as along a slit, where the surface was split, or one
        // edge joins a vertex to itself.
        energy[at] += entry.Transport * entry.Energy;
        mass[at] += entry.Transport * entry.Mass;
      }
      else
      {
        rows[++at] = place.Row;
        energy[at] = entry.Transport * entry.Energy;
        mass[at] = entry.Transport * entry.Mass;
      }
      if (place.Row == vertex - this->Given.Component.FirstVertex)
      {
        // The two ends of an edge that joins a vertex to itself add up to a real number, up to
        // rounding.
        energy[at] = energy[at].real();
        mass[at] = mass[at].real();
      }
    }
  }

private:
  struct Entry
  {
    Complex Transport;
    Complex Energy;
    Complex Mass;
  };
  struct Place
  {
    Index Row;
    Index Number;
    bool operator<(const Place& other) const { return this->Row < other.Row; }
  };

  void AddRow(Index vertex, const Complex& transport)
  {
    const auto number = static_cast<Index>(this->Column.size());
    this->Column.push_back({ transport, 0.0, 0.0 });
    this->Order.push_back({ vertex - this->Given.Component.FirstVertex, number });
  }

  /// The neighbours counter-clockwise, then the vertex itself.
  void AddRows(Index vertex)
  {
    const TriangleMesh& mesh = this->Given.Geometry.Mesh;
    const auto along = [&](Index h) -> const Complex&
    { return this->Given.Transport[mesh.Edge(h) - this->Given.Component.FirstEdge]; };
    this->Column.clear();
    this->Order.clear();
    for (const Index h : this->Fan)
    {
      this->AddRow(mesh.Head(h), mesh.GivesDirection(h) ? along(h) : std::conj(along(h)));
    }
    if (mesh.IsBoundary(vertex))
    {
      // The last edge has no half-edge but the one that comes in.
      const Index last = TriangleMesh::Previous(this->Fan.back());
      this->AddRow(mesh.Tail(last), std::conj(along(last)));
    }
    this->Neighbours = this->Column.size();
    this->AddRow(vertex, 1.0);
  }

  /// Adds up the integrals over the triangles.
  void Integrate()
  {
    const Problem& given = this->Given;
    const IntrinsicGeometry& geometry = given.Geometry;
    Entry& diagonal = this->Column.back();
    for (std::size_t k = 0; k < this->Fan.size(); ++k)
    {
      const Index h = this->Fan[k];
      const auto squaredLength = [&geometry](Index side)
      { return geometry.Lengths.SquaredLength[geometry.Mesh.Edge(side)]; };
      const LocalIntegrals local({ squaredLength(h), squaredLength(TriangleMesh::Next(h)),
                                   squaredLength(TriangleMesh::Previous(h)) },
        geometry.Lengths.Area[h / 3], given.Degree * geometry.Transport.Curvature[h / 3],
        given.EnergyBias);
      diagonal.Energy += local.EnergyDiagonal(0);
      diagonal.Mass += local.MassDiagonal();
      // The first side runs out of the vertex, the last one into it.
      Entry& first = this->Column[k];
      first.Energy += std::conj(local.Energy(0));
      first.Mass += std::conj(local.Mass());
      Entry& last = this->Column[k + 1 < this->Neighbours ? k + 1 : 0];
      last.Energy += local.Energy(2);
      last.Mass += local.Mass();
    }
  }

  const Problem& Given;
  std::vector<Index> Fan;
  std::vector<Entry> Column;
  std::vector<Place> Order;
  std::size_t Neighbours = 0;
};

std::vector<Complex> EdgeTransport(
  const Connection& connection, const TriangleMesh::Component& component, int degree)
{
  std::vector<Complex> transport(component.Edges());
  ParallelFor(component.Edges(), HeavyPiece,
    [&](Index begin, Index end)
    {
      ForCosinesAndSines(
        begin, end, [&](Index e) { return degree * connection.Rotation[component.FirstEdge + e]; },
        [&](Index e, double cosine, double sine) { transport[e] = Complex(cosine, sine); });
    });
  return transport;
}
}

Operators AssembleOperators(const IntrinsicGeometry& geometry,
  const TriangleMesh::Component& component, int degree, double energyBias)
{
  const Problem problem{ geometry, component, degree, energyBias,
    EdgeTransport(geometry.Transport, component, degree) };
  const Index n = component.Vertices();
  std::vector<Index> begin(n + 1, 0);
  ParallelFor(n, HeavyPiece,
    [&](Index first, Index end)
    {
      ColumnAssembler columns(problem);
      for (Index v = first; v < end; ++v)
      {
        begin[v + 1] = columns.Count(component.FirstVertex + v);
      }
    });
  for (Index v = 0; v < n; ++v)
  {
    begin[v + 1] += begin[v];
  }
  Operators operators;
  SparseMatrix* const matrices[2] = { &operators.Energy, &operators.Mass };
  // Eigen fills new memory with zeros. That takes long in a large matrix, so both matrices are
  // allocated at once.
  ParallelFor(2, n > HeavyPiece ? 1 : 2,
    [&](Index first, Index end)
    {
      for (Index k = first; k < end; ++k)
      {
        matrices[k]->resize(n, n);
        matrices[k]->resizeNonZeros(begin.back());
        std::copy(begin.begin(), begin.end(), matrices[k]->outerIndexPtr());
      }
    });
  ParallelFor(n, HeavyPiece,
    [&](Index first, Index end)
    {
      ColumnAssembler columns(problem);
      Index* const rows = operators.Energy.innerIndexPtr();
      for (Index v = first; v < end; ++v)
      {
        columns.Fill(component.FirstVertex + v, rows + begin[v],
          operators.Energy.valuePtr() + begin[v], operators.Mass.valuePtr() + begin[v]);
      }
      std::copy(
        rows + begin[first], rows + begin[end], operators.Mass.innerIndexPtr() + begin[first]);
    });
  return operators;
}
}
