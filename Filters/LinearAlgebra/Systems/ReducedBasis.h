// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ReducedBasis_h
#define DirectionFields_ReducedBasis_h

#include "Matrices/OperatorProducts.h"

#include <optional>
#include <vector>

namespace DirectionFields::Internal
{
/// Solutions of systems (a A + m M) u = b for some a and m, which span good first guesses for
/// others: solutions depend smoothly on the factors (the reduced basis method, see A. Quarteroni,
/// A. Manzoni, F. Negri, Reduced Basis Methods for Partial Differential Equations, 2016).
class ReducedBasis
{
public:
  /// When there are more, the oldest is forgotten.
  static constexpr int MostVectors = 6;

  struct Guess
  {
    ComplexVector Vector;
    /// Whether this very system has been solved before, then with the residual that Add was told.
    bool IsSolution = false;
    double Residual = 0.0;
  };
  /// Returns the combination of the basis that is closest to the solution of (a A + m M) u = b in
  /// the norm of that matrix, which is to be positive definite; zero where the basis is empty.
  Guess Closest(double a, double m, const ComplexVector& b) const;

  /// Adds the solution u of (a A + m M) u = b.
  void Add(const SectionProducts& u, double a, double m, const ComplexVector& b, double residual);
  /// Adds a vector that solves no system.
  void Add(const SectionProducts& u);

  int Size() const { return static_cast<int>(this->Vectors.size()); }

private:
  /// The numbers by which a system differs from others.
  struct System
  {
    double Energy;
    double Mass;
    /// u^* b
    Complex Product;
    double Residual;
  };

  std::vector<ComplexVector> Vectors;
  /// The system that each vector solves, if it solves one.
  std::vector<std::optional<System>> Systems;
  /// v^* A w and v^* M w of the vectors v and w, in their order.
  Eigen::MatrixXcd Energy;
  Eigen::MatrixXcd Mass;
};
}

#endif
