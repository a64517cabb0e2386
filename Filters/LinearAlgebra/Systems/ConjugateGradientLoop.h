// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ConjugateGradientLoop_h
#define DirectionFields_ConjugateGradientLoop_h

#include <cmath>

namespace DirectionFields::Internal
{
/// The loop of conjugate gradients (M. Hestenes, E. Stiefel 1952) for a positive definite matrix K
/// and a preconditioner B. The iteration holds the solution u, the residual r, the direction p and
/// the product q = K p in the precision that suits it, and supplies the operations on them:
///   bool GoesOn()                    whether another step is wanted; it may throw Stopped
///   double Precondition()            finds z = B r and returns Re r^* z
///   void SetDirection(double keep)   p = z + keep p; keep is 0 in the first step
///   double FindCurvature()           finds q = K p and returns p^* q
///   void Advance(double step)        u += step p and r -= step q
/// For least squares (CGLS, Å. Björck 1996) with the matrix K_f^* K_f, r and z belong to the
/// gradient K_f^* (b - K_f u), and the curvature is ‖K_f p‖^2. The loop also ends where a step is
/// no positive number: then K is not positive definite along p, or r has vanished.
template <typename Iteration>
void TakeConjugateGradientSteps(Iteration& iteration)
{
  double previous = 0.0;
  while (iteration.GoesOn())
  {
    const double product = iteration.Precondition();
    iteration.SetDirection(previous == 0.0 ? 0.0 : product / previous);
    previous = product;
    const double step = product / iteration.FindCurvature();
    if (!(step > 0.0) || !std::isfinite(step))
    {
      return;
    }
    iteration.Advance(step);
  }
}
}

#endif
