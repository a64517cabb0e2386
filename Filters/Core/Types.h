// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Types_h
#define DirectionFields_Types_h

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <complex>
#include <cstdint>
#include <limits>
#include <vector>

/// Direction fields on triangle meshes, free of any visualization library.
namespace DirectionFields
{
using Complex = std::complex<double>;
using Vector3 = Eigen::Vector3d;
using ComplexVector = Eigen::VectorXcd;

/// Hermitian matrix over the vertices; row j, column k multiplies u_k, so that u^* A u is the energy.
using SparseMatrix = Eigen::SparseMatrix<Complex, Eigen::ColMajor, std::int32_t>;

/// Number of a vertex, edge, half-edge or triangle. 32 bits: at most 715 million triangles.
using Index = std::int32_t;

/// What is not there: the twin of a boundary half-edge, the triangle of an ignored input triangle.
constexpr Index None = -1;

using Triangle = std::array<Index, 3>;

constexpr double Pi = 3.14159265358979323846;

/// A quotient that stays within the range of double: the largest value stands for what exceeds it.
inline double Divided(double value, double unit)
{
  constexpr double largest = std::numeric_limits<double>::max();
  return value == 0.0 ? 0.0 : std::clamp(value / unit, -largest, largest);
}

/// A value in 1 / unit^2, likewise.
inline double PerSquare(double value, double unit)
{
  return Divided(Divided(value, unit), unit);
}

/// Empties a vector and frees its memory, which neither clear nor the assignment of {} does.
template <typename T, typename Allocator>
void Free(std::vector<T, Allocator>& vector)
{
  std::vector<T, Allocator>().swap(vector);
}

/// The order of points that stands for numbers where results must not depend on numbering.
inline bool LexicographicallyLess(const Vector3& a, const Vector3& b)
{
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}
}

#endif
