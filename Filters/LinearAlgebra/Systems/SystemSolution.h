// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SystemSolution_h
#define DirectionFields_SystemSolution_h

#include "Types.h"

#include <stdexcept>

namespace DirectionFields::Internal
{
/// A section that satisfies a linear system, and how well it does.
struct SystemSolution
{
  ComplexVector Vector;
  /// ‖K u - b‖ / ‖b‖ of the equations that were solved, which for least squares are the normal
  /// equations. Where rounding allows no better it is taken over 1e-6 ‖|K| |u|‖ instead of ‖b‖. It
  /// is 0 where nothing was left to solve.
  double Residual = 0.0;
  /// A u and M u where the solver computes them anyway, else empty.
  ComplexVector Energy;
  ComplexVector Mass;
};

/// K cannot be factored: it is not positive definite, or rounding makes it so.
class NotPositiveDefinite : public std::runtime_error
{
public:
  NotPositiveDefinite()
    : std::runtime_error("The linear system could not be factored: the mesh has triangles of too "
                         "different sizes or shapes. Remesh it more evenly.")
  {
  }
};
}

#endif
