// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_VectorOperations_h
#define DirectionFields_VectorOperations_h

#include "Support/LargeArray.h"
#include "Support/Threads.h"

#include <cmath>

/// Operations on long vectors, on several threads, with the same bytes for any number of them.
namespace DirectionFields::Internal
{
constexpr Index VectorPiece = 4096;

/// Makes the vector that long, with undefined values, which are to be written on all threads.
inline void Resize(ComplexVector& vector, Eigen::Index size)
{
  if (vector.size() != size)
  {
    vector.resize(size);
    PreferLargePages(vector.data(), static_cast<std::size_t>(size) * sizeof(Complex));
  }
}

inline ComplexVector Uninitialized(Eigen::Index size)
{
  ComplexVector vector;
  Resize(vector, size);
  return vector;
}

/// body(begin, end) for pieces of the rows.
template <typename Vector, typename Body>
void ForRows(const Vector& vector, const Body& body)
{
  ParallelFor(static_cast<Index>(vector.size()), VectorPiece, body);
}

inline ComplexVector Zeros(Eigen::Index size)
{
  ComplexVector vector = Uninitialized(size);
  ForRows(vector, [&](Index begin, Index end) { vector.segment(begin, end - begin).setZero(); });
  return vector;
}

inline void Copy(const ComplexVector& from, ComplexVector& to)
{
  Resize(to, from.size());
  ForRows(to,
    [&](Index begin, Index end)
    { to.segment(begin, end - begin) = from.segment(begin, end - begin); });
}

inline ComplexVector Copied(const ComplexVector& a)
{
  ComplexVector copy;
  Copy(a, copy);
  return copy;
}

/// Re a^* b
inline double RealDot(const ComplexVector& a, const ComplexVector& b)
{
  return ParallelSum<double>(static_cast<Index>(a.size()), VectorPiece, 0.0,
    [&](Index begin, Index end)
    { return a.segment(begin, end - begin).dot(b.segment(begin, end - begin)).real(); });
}

inline double Norm(const ComplexVector& a)
{
  return std::sqrt(RealDot(a, a));
}

/// Vectors of one length.
inline bool Equal(const ComplexVector& a, const ComplexVector& b)
{
  return ParallelSum<int>(static_cast<Index>(a.size()), VectorPiece, 0,
           [&](Index begin, Index end)
           { return a.segment(begin, end - begin) == b.segment(begin, end - begin) ? 0 : 1; }) == 0;
}

/// y = alpha x + beta y
inline void Combine(double alpha, const ComplexVector& x, double beta, ComplexVector& y)
{
  ForRows(y,
    [&](Index begin, Index end)
    {
      auto part = y.segment(begin, end - begin);
      part = alpha * x.segment(begin, end - begin) + beta * part;
    });
}
}

#endif
