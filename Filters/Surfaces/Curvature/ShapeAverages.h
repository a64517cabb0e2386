// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ShapeAverages_h
#define DirectionFields_ShapeAverages_h

#include "Curvature/ShapeFit.h"
#include "Geometry/SurfaceGeometry.h"

#include <algorithm>
#include <vector>

namespace DirectionFields::Internal
{
/// A shape times the weight that its fit deserves, and the weight.
struct WeightedShape
{
  Complex Hopf = 0.0;
  double Mean = 0.0;
  double Weight = 0.0;

  Complex GetHopf() const { return this->Hopf * (1.0 / this->Weight); }
  double GetMean() const { return this->Mean * (1.0 / this->Weight); }
};

/// Means with the neighbours, for sections of degree 2 and for numbers.
class ShapeAverages
{
public:
  /// The part of a mean that the neighbours have.
  static constexpr double Share = 0.75;

  ShapeAverages(const SurfaceGeometry& geometry, const std::vector<Shape>& shapes);

  /// Lets means end at vertices without a shape and at those that are told: these count no longer
  /// for their neighbours, and no other vertex counts for more instead. So the weights that several
  /// steps give to the vertices fade towards them.
  void EndAt(const SurfaceGeometry& geometry, const std::vector<char>& ends);

  /// The sum of the weights of the edges around a vertex, after EndAt. After many steps the weight
  /// of a vertex in the mean around another one is a smooth function of it times this sum.
  double SumOfWeights(Index v) const { return this->WeightSum[v]; }

  /// The mean around a vertex.
  WeightedShape Of(Index v, const std::vector<WeightedShape>& values) const
  {
    const Index begin = this->Start[v];
    const Index end = this->Start[v + 1];
    const double own = this->Own[v];
    WeightedShape sum = values[v];
    sum.Hopf *= own;
    sum.Mean *= own;
    sum.Weight *= own;
    for (Index k = begin; k < end; ++k)
    {
      const Coupling& coupling = this->Couplings[k];
      const WeightedShape& other = values[coupling.Vertex];
      sum.Hopf +=
        Complex(coupling.Real * other.Hopf.real() - coupling.Imaginary * other.Hopf.imag(),
          coupling.Real * other.Hopf.imag() + coupling.Imaginary * other.Hopf.real());
      sum.Mean += coupling.Weight * other.Mean;
      sum.Weight += coupling.Weight * other.Weight;
    }
    return sum;
  }

  /// The mean of the numbers at the vertex and at its neighbours that take part.
  float Of(Index v, const std::vector<float>& values, const std::vector<char>& takesPart) const
  {
    const float own = values[v];
    float sum = own;
    for (Index k = this->Start[v]; k < this->Start[v + 1]; ++k)
    {
      const Coupling& coupling = this->Couplings[k];
      sum +=
        takesPart[coupling.Vertex] != 0 ? coupling.Weight * (values[coupling.Vertex] - own) : 0;
    }
    return sum;
  }

  /// Whether a statement holds for any neighbour with a shape.
  template <typename Statement>
  bool HasNeighbour(Index v, const Statement& statement) const
  {
    return std::any_of(this->Couplings.begin() + this->Start[v],
      this->Couplings.begin() + this->Start[v + 1],
      [&](const Coupling& coupling) { return statement(coupling.Vertex); });
  }

private:
  struct Coupling
  {
    Index Vertex;
    float Weight;
    /// The weight times the transport from that vertex.
    float Real;
    float Imaginary;
  };

  void Fill(
    const SurfaceGeometry& geometry, const std::vector<Shape>& shapes, Index begin, Index end);

  std::vector<Index> Start;
  /// The part that each vertex has in its own mean.
  std::vector<double> Own;
  /// The weights of the edges around each vertex that couple it to others.
  std::vector<double> WeightSum;
  std::vector<Coupling> Couplings;
};
}

#endif
