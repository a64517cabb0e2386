// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Types_h
#define DirectionFields_Types_h

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/SparseCore>

#include <array>
#include <complex>
#include <cstdint>
#include <vector>

/// Direction fields on triangle meshes, free of any visualization library.
namespace DirectionFields
{
using Complex = std::complex<double>;
using Vector3 = Eigen::Vector3d;
using ComplexVector = Eigen::VectorXcd;

/// Hermitian matrix over the vertices: row j, column k multiplies u_k, and u^* A u is the energy.
using SparseMatrix = Eigen::SparseMatrix<Complex, Eigen::ColMajor, std::int32_t>;

/// Number of a vertex, edge, half-edge or triangle. 32 bits: at most 715 million triangles.
using Index = std::int32_t;

/// A missing number: the twin of a boundary half-edge, the triangle of an ignored input triangle.
constexpr Index None = -1;

using Triangle = std::array<Index, 3>;

constexpr double Pi = 3.14159265358979323846;

/// The internals of the libraries. The namespace is nearly empty for users of an installation; the
/// libraries' own sources and tests see both namespaces as one.
namespace Internal
{
}
using namespace Internal; // NOLINT(google-build-using-namespace)
}

#endif
