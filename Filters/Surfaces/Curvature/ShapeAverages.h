// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ShapeAverages_h
#define DirectionFields_ShapeAverages_h

#include "Curvature/ShapeFit.h"
#include "Geometry/SurfaceGeometry.h"

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

  /// The mean around a vertex.
  WeightedShape Of(Index v, const std::vector<WeightedShape>& values) const
  {
    const Index begin = this->Start[v];
    const Index end = this->Start[v + 1];
    const double own = this->Own(begin, end);
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

private:
  struct Coupling
  {
    Index Vertex;
    float Weight;
    /// The weight times the transport from that vertex.
    float Real;
    float Imaginary;
  };

  double Own(Index begin, Index end) const
  {
    double sum = 1.0;
    for (Index k = begin; k < end; ++k)
    {
      sum -= this->Couplings[k].Weight;
    }
    return sum;
  }

  void Fill(
    const SurfaceGeometry& geometry, const std::vector<Shape>& shapes, Index begin, Index end);

  std::vector<Index> Start;
  std::vector<Coupling> Couplings;
};
}

#endif
