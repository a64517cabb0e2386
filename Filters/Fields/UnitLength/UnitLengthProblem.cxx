// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "UnitLength/UnitLengthProblem.h"

#include "Matrices/OperatorProducts.h"
#include "Matrices/VectorOperations.h"
#include "Support/VectorMath.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// Fills in the columns of the energy of differences along edges, each from the fan of its vertex.
class DifferenceColumns
{
public:
  DifferenceColumns(const IntrinsicGeometry& geometry, const TriangleMesh::Component& component,
    int degree, double energyBias)
    : Geometry(geometry)
    , Component(component)
    , Degree(degree)
    , EnergyBias(energyBias)
  {
  }

  /// Adds the column, times a factor, to its values.
  void Add(Index v, double factor, const Index* rows, Index count, Complex* values)
  {
    const TriangleMesh& mesh = this->Geometry.Mesh;
    const Index vertex = this->Component.FirstVertex + v;
    mesh.GetFan(vertex, this->Fan);
    this->Angles.clear();
    for (const Index h : this->Fan)
    {
      this->Angles.push_back(this->Degree * this->Geometry.Transport.RotationAlong(mesh, h));
    }
    // The last edge of a boundary vertex has no half-edge but the one that comes in.
    const Index last = TriangleMesh::Previous(this->Fan.back());
    const bool boundary = mesh.IsBoundary(vertex);
    if (boundary)
    {
      this->Angles.push_back(-this->Degree * this->Geometry.Transport.RotationAlong(mesh, last));
    }
    const auto edges = static_cast<Index>(this->Angles.size());
    this->Cosines.resize(edges);
    this->Sines.resize(edges);
    CosinesAndSines(this->Angles.data(), edges, this->Cosines.data(), this->Sines.data());
    const auto entry = [&](Index row) -> Complex&
    { return values[std::lower_bound(rows, rows + count, row) - rows]; };
    for (Index k = 0; k < edges; ++k)
    {
      const bool comesIn = boundary && k == edges - 1;
      const Index h = comesIn ? last : this->Fan[k];
      const Index other = comesIn ? mesh.Tail(h) : mesh.Head(h);
      if (other == vertex)
      {
        continue;
      }
      const double weight = factor * this->Weight(h);
      double bias = 0.0;
      if (boundary && (comesIn || k == 0))
      {
        bias = factor * (comesIn ? 0.5 : -0.5) * this->EnergyBias;
      }
      entry(other - this->Component.FirstVertex) +=
        Complex(this->Cosines[k], this->Sines[k]) * Complex(-weight, bias);
      entry(v) += weight;
    }
  }

private:
  /// Half of the cotangents of the corners opposite of an edge.
  double Weight(Index h) const
  {
    return std::max(0.0, this->Geometry.Lengths.EdgeWeight(this->Geometry.Mesh, h));
  }

  const IntrinsicGeometry& Geometry;
  const TriangleMesh::Component& Component;
  int Degree;
  double EnergyBias;
  std::vector<Index> Fan;
  std::vector<double> Angles;
  std::vector<double> Cosines;
  std::vector<double> Sines;
};
}

SparseMatrix UnitEnergyMatrix(const IntrinsicGeometry& geometry,
  const TriangleMesh::Component& component, int degree, double energyBias,
  const SparseMatrix& energy)
{
  constexpr double part = 0.5;
  SparseMatrix matrix = energy;
  ParallelFor(component.Vertices(), HeavyPiece,
    [&](Index begin, Index end)
    {
      DifferenceColumns columns(geometry, component, degree, energyBias);
      for (Index v = begin; v < end; ++v)
      {
        const Index first = matrix.outerIndexPtr()[v];
        const Index count = matrix.outerIndexPtr()[v + 1] - first;
        Complex* const values = matrix.valuePtr() + first;
        for (Index k = 0; k < count; ++k)
        {
          values[k] *= 1.0 - part;
        }
        columns.Add(v, part, matrix.innerIndexPtr() + first, count, values);
      }
    });
  return matrix;
}

ComplexVector UnitLengthProblem::Gradient(const ComplexVector& u) const
{
  ComplexVector gradient = Product(this->Matrix, u);
  if (this->Pull.size() > 0)
  {
    ForRows(gradient,
      [&](Index begin, Index end)
      { gradient.segment(begin, end - begin) -= this->Pull.segment(begin, end - begin); });
  }
  return gradient;
}

double UnitLengthProblem::Energy(const ComplexVector& u, const ComplexVector& gradient) const
{
  const bool pulled = this->Pull.size() > 0;
  return ParallelSum<double>(this->Rows(), VectorPiece, 0.0,
    [&](Index begin, Index end)
    {
      double sum = 0.0;
      for (Index v = begin; v < end; ++v)
      {
        sum += (std::conj(u[v]) * gradient[v]).real();
        if (pulled)
        {
          sum += 2.0 * std::abs(this->Pull[v]) - (std::conj(u[v]) * this->Pull[v]).real();
        }
      }
      return sum;
    });
}

void MakeUnit(ComplexVector& u, const ComplexVector* other)
{
  ForRows(u,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        // Squares of tiny values would underflow.
        const double larger = std::max(std::abs(u[v].real()), std::abs(u[v].imag()));
        if (larger > 0.0 && std::isfinite(larger))
        {
          const Complex scaled(u[v].real() / larger, u[v].imag() / larger);
          u[v] = scaled / std::sqrt(std::norm(scaled));
        }
        else
        {
          u[v] = other && std::norm((*other)[v]) > 0.0 ? (*other)[v] : Complex(1.0);
        }
      }
    });
}
}
