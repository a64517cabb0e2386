// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_HermitianSpectrum_h
#define DirectionFields_HermitianSpectrum_h

#include <Eigen/Core>

namespace DirectionFields::Internal
{
/// All eigenpairs of a small dense Hermitian matrix, or of a pencil of two. Eigen's decompositions
/// are compiled in this room alone, since each takes the compiler as long as ten other rooms.
struct HermitianSpectrum
{
  /// The eigenpairs of a; its lower triangle is used.
  explicit HermitianSpectrum(const Eigen::MatrixXcd& a);
  /// The eigenpairs of a u = x m u, m being positive definite; their lower triangles are used.
  HermitianSpectrum(const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& m);

  /// Increasing.
  Eigen::VectorXd Values;
  /// One eigenvector a column, orthonormal, in m if there is one.
  Eigen::MatrixXcd Vectors;
  /// False if the iteration has not converged, as with numbers that are not finite, or if m is not
  /// positive definite.
  bool IsFound = false;
};
}

#endif
