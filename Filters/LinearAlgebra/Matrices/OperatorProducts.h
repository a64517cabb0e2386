// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_OperatorProducts_h
#define DirectionFields_OperatorProducts_h

#include "Matrices/Operators.h"
#include "Support/LargeArray.h"

namespace DirectionFields::Internal
{
/// K x of a Hermitian matrix, on several threads.
ComplexVector Product(const SparseMatrix& matrix, const ComplexVector& x);

/// (a A + m M) x
ComplexVector Product(const Operators& operators, double a, double m, const ComplexVector& x);

/// a A + m M
SparseMatrix LinearCombination(const Operators& operators, double a, double m);

/// ‖|K| |u|‖: the sum of the terms of K u if none cancel. The rounding of K u is a small part of
/// it.
double SumOfMagnitudes(const SparseMatrix& matrix, const ComplexVector& u);

/// A section and its products with energy and mass matrix.
struct SectionProducts
{
  ComplexVector Vector;
  ComplexVector Energy;
  ComplexVector Mass;

  SectionProducts() = default;
  SectionProducts(const Operators& operators, ComplexVector vector);
  /// Replaces the section in the storage of the one before.
  void Set(const Operators& operators, ComplexVector vector);
};
}

#endif
