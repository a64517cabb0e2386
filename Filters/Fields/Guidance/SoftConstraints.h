// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SoftConstraints_h
#define DirectionFields_SoftConstraints_h

#include "Matrices/Operators.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Directions that the energy of one component draws free vertices to, counted from its first one.
struct SoftConstraints
{
  std::vector<Index> Vertices;
  /// One for each of Vertices: its phase is the direction's, its modulus the stiffness
  /// s = w tau / (1 - tau) of Guidance::Strengths, greater than 0 and at most MostStiffness.
  ComplexVector Values;

  /// Stiffer ones only make the numbers larger, not the field another one.
  static constexpr double MostStiffness = 1e6;

  bool IsEmpty() const { return this->Vertices.empty(); }
};
/// s of a weight and a strength.
double Stiffness(double weight, double strength);

/// The terms sum over i of W_i |u_i - g_i|^2 of the energy of one component, where g_i has the
/// modulus 1 and W_i = s_i sqrt(sigma A_i), which has no unit, with a third A_i of the area at the
/// vertex. Along a curve the A_i are as long as the square of an edge: the sum is an integral over
/// the curve, on coarse and on fine meshes.
class SoftTerms
{
public:
  /// @param sigma in 1 / unit^2, as in ComponentStage
  SoftTerms(const Operators& operators, const SoftConstraints& soft, double sigma);

  /// Whether these terms are those of the constraints.
  bool Fit(const SoftConstraints& soft) const;

  /// The energy with W on its diagonal, and the mass matrix.
  const Operators& GetMatrices() const { return this->Matrices; }
  /// W g, at all vertices of the component.
  const ComplexVector& GetPull() const { return this->Pull; }

private:
  SoftConstraints Soft;
  Operators Matrices;
  ComplexVector Pull;
};
}

#endif
