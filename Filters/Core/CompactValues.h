// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_CompactValues_h
#define DirectionFields_CompactValues_h

#include "LargeArray.h"
#include "Types.h"

#include <cmath>
#include <complex>
#include <cstring>
#include <vector>

namespace DirectionFields
{
/// What preconditioners compute with: half the memory traffic of Complex, and enough digits for a
/// correction.
using CompactComplex = std::complex<float>;

/// The modulus, for numbers whose squares neither overflow nor matter if they vanish.
inline float Modulus(const CompactComplex& z)
{
  return std::sqrt(z.real() * z.real() + z.imag() * z.imag());
}

/// B sections side by side: for each vertex B real parts, then B imaginary parts. One section is an
/// array of CompactComplex.
using CompactSections = LargeArray<float>;

/// The B values of a vertex.
template <int B>
struct CompactValues
{
  /// Four fit a register.
  using Numbers = Eigen::Array<float, B, 1>;
  Numbers Real = Numbers::Zero();
  Numbers Imaginary = Numbers::Zero();

  CompactValues() = default;
  CompactValues(const float* sections, Index v)
    : Real(Eigen::Map<const Numbers>(At(sections, v)))
    , Imaginary(Eigen::Map<const Numbers>(At(sections, v) + B))
  {
  }
  void Store(float* sections, Index v) const
  {
    float* const to = sections + static_cast<std::size_t>(2 * B) * v;
    Eigen::Map<Numbers> real(to);
    Eigen::Map<Numbers> imaginary(to + B);
    real = this->Real;
    imaginary = this->Imaginary;
  }
  /// Adds a multiple.
  void Add(const CompactComplex& factor, const CompactValues& other)
  {
    this->Real += factor.real() * other.Real - factor.imag() * other.Imaginary;
    this->Imaginary += factor.real() * other.Imaginary + factor.imag() * other.Real;
  }
  /// Adds a multiple of the values of another vertex.
  void Add(const CompactComplex& factor, const float* sections, Index v)
  {
    this->Add(factor, CompactValues(sections, v));
  }
  void AddReal(float factor, const float* sections, Index v)
  {
    const CompactValues other(sections, v);
    this->Real += factor * other.Real;
    this->Imaginary += factor * other.Imaginary;
  }
  void Scale(float factor)
  {
    this->Real *= factor;
    this->Imaginary *= factor;
  }

private:
  static const float* At(const float* sections, Index v)
  {
    return sections + static_cast<std::size_t>(2 * B) * v;
  }
};

/// Adds factors[k] times the values of vertex vertices[k], k = begin ... end - 1, to a sum.
template <int B>
inline void AddProducts(const CompactComplex* factors, const Index* vertices, Index begin, Index end,
  const float* sections, CompactValues<B>& sum)
{
  for (Index k = begin; k < end; ++k)
  {
    sum.Add(factors[k], sections, vertices[k]);
  }
}

/// The same for more than a few: two products at once, if it is one section.
template <int B>
inline void AddManyProducts(const CompactComplex* factors, const Index* vertices, Index begin,
  Index end, const float* sections, CompactValues<B>& sum)
{
  AddProducts<B>(factors, vertices, begin, end, sections, sum);
}

#if defined(__GNUC__)
template <>
inline void AddManyProducts<1>(const CompactComplex* factors, const Index* vertices, Index begin,
  Index end, const float* sections, CompactValues<1>& sum)
{
  typedef float Numbers __attribute__((vector_size(4 * sizeof(float))));
  typedef double Pairs __attribute__((vector_size(2 * sizeof(double))));
  // A pair of floats is moved as one double, which is never computed with.
  const auto pair = [](const void* at)
  {
    double both;
    std::memcpy(&both, at, sizeof(both));
    return both;
  };
  const auto section = [&](Index k)
  { return pair(sections + 2 * static_cast<std::size_t>(vertices[k])); };
  Numbers byReal{ sum.Real[0], sum.Imaginary[0], 0.0f, 0.0f };
  Numbers byImaginary{};
  const auto add = [&](const Numbers& a, const Numbers& x)
  {
    byReal += Numbers{ a[0], a[0], a[2], a[2] } * x;
    byImaginary += Numbers{ a[1], a[1], a[3], a[3] } * x;
  };
  Index k = begin;
  for (; k + 1 < end; k += 2)
  {
    Numbers a;
    std::memcpy(&a, factors + k, sizeof(a));
    add(a, (Numbers)Pairs{ section(k), section(k + 1) });
  }
  if (k < end)
  {
    add((Numbers)Pairs{ pair(factors + k), 0.0 }, (Numbers)Pairs{ section(k), 0.0 });
  }
  sum.Real[0] = (byReal[0] + byReal[2]) - (byImaginary[1] + byImaginary[3]);
  sum.Imaginary[0] = (byReal[1] + byReal[3]) + (byImaginary[0] + byImaginary[2]);
}
#endif
}

#endif
