// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Eigenpairs/RayleighRitz.h"

#include "Eigenpairs/HermitianSpectrum.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <limits>

namespace DirectionFields::Internal
{
namespace
{
/// Basis vectors of unit length count as independent where each is further than this from the space
/// of those before it.
constexpr double IndependentDistance = 1e-3;
}

RitzPairs RayleighRitz(const SmallMatrix& energy, const SmallMatrix& mass, int wanted)
{
  const Eigen::Index n = mass.rows();
  if (!energy.allFinite() || !mass.allFinite())
  {
    return {};
  }
  // A vector that is zero does not count.
  const Eigen::VectorXd lengths = mass.diagonal().real().cwiseMax(0.0).cwiseSqrt();
  const Eigen::VectorXd perLength =
    (lengths.array() > std::numeric_limits<double>::min()).select(lengths.cwiseInverse(), 0.0);
  const SmallMatrix scaled =
    perLength.asDiagonal() * (0.5 * (mass + mass.adjoint())) * perLength.asDiagonal();
  const Eigen::LLT<SmallMatrix> factor(scaled);
  SmallMatrix basis = perLength.asDiagonal();
  if (factor.info() == Eigen::Success &&
    factor.matrixLLT().diagonal().real().minCoeff() > IndependentDistance)
  {
    basis = basis *
      SmallMatrix(factor.matrixU())
        .triangularView<Eigen::Upper>()
        .solve(SmallMatrix::Identity(n, n));
  }
  else
  {
    const HermitianSpectrum spectrum(scaled);
    const Eigen::Index kept =
      (spectrum.Values.array() > IndependentDistance * IndependentDistance).count();
    basis = basis * spectrum.Vectors.rightCols(kept) *
      spectrum.Values.tail(kept).cwiseSqrt().cwiseInverse().asDiagonal();
  }
  if (basis.cols() == 0)
  {
    return {};
  }
  const SmallMatrix projected = basis.adjoint() * (0.5 * (energy + energy.adjoint())) * basis;
  const HermitianSpectrum spectrum(projected);
  const Eigen::Index count = std::min<Eigen::Index>(wanted, basis.cols());
  return { spectrum.Values.head(count), basis * spectrum.Vectors.leftCols(count) };
}
}
