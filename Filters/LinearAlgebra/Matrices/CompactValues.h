// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_CompactValues_h
#define DirectionFields_CompactValues_h

#include "Support/LargeArray.h"
#include "Types.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstring>
#include <vector>

namespace DirectionFields::Internal
{
/// Preconditioners compute with these numbers: they take half the memory traffic of Complex, and
/// have digits enough for a correction.
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
  /// Adds a multiple of other values.
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
  /// The value of the first section.
  CompactComplex Value() const { return { this->Real[0], this->Imaginary[0] }; }

private:
  static const float* At(const float* sections, Index v)
  {
    return sections + static_cast<std::size_t>(2 * B) * v;
  }
};

#if defined(__GNUC__)
/// One section in a register: its real and its imaginary part, then two numbers that do not matter.
template <>
struct CompactValues<1>
{
  using Numbers __attribute__((vector_size(4 * sizeof(float)))) = float;
  /// Two floats are moved as one double, which is never computed with.
  using Pair __attribute__((vector_size(2 * sizeof(double)))) = double;
  Numbers Lanes{};

  CompactValues() = default;
  CompactValues(const float* sections, Index v)
    : Lanes((Numbers)Pair{ Both(sections + 2 * static_cast<std::size_t>(v)), 0.0 })
  {
  }
  void Store(float* sections, Index v) const
  {
    using Two __attribute__((vector_size(2 * sizeof(float)), aligned(alignof(float)))) = float;
    *reinterpret_cast<Two*>(sections + 2 * static_cast<std::size_t>(v)) =
      Two{ this->Lanes[0], this->Lanes[1] };
  }
  CompactComplex Value() const { return { this->Lanes[0], this->Lanes[1] }; }
  void Add(const CompactComplex& factor, const CompactValues& other)
  {
    const Numbers& x = other.Lanes;
    this->Lanes += factor.real() * x + factor.imag() * Numbers{ -x[1], x[0], 0.0f, 0.0f };
  }
  void Add(const CompactComplex& factor, const float* sections, Index v)
  {
    this->Add(factor, CompactValues(sections, v));
  }
  void AddReal(float factor, const float* sections, Index v)
  {
    this->Lanes += factor * CompactValues(sections, v).Lanes;
  }
  void Scale(float factor) { this->Lanes *= factor; }

  static double Both(const float* at)
  {
    using Double __attribute__((may_alias, aligned(alignof(float)))) = double;
    return *reinterpret_cast<const Double*>(at);
  }
};
#endif

/// Products are added up in groups, which may reach past the end of a row. Arrays of factors and
/// vertices have this many zeros after the last row's elements, so that they may be read.
constexpr Index Padding = 6;

template <typename T>
void ResizePadded(LargeArray<T>& array, Index count)
{
  array.resize(static_cast<std::size_t>(count) + Padding);
  std::fill(array.end() - Padding, array.end(), T(0));
}

/// Adds factors[k] times the values of vertex vertices[k], k = begin ... end - 1, to a sum.
template <int B, typename Vertex>
inline void AddProducts(const CompactComplex* factors, const Vertex* vertices, Index begin,
  Index end, const float* sections, CompactValues<B>& sum)
{
  for (Index k = begin; k < end; ++k)
  {
    sum.Add(factors[k], sections, vertices[k]);
  }
}

/// Does the same, and takes six products at once if there is one section: up to six entries after
/// the end are read, too, and multiplied by zero. Factors and vertices must be padded, and the
/// sections finite.
template <int B, typename Vertex>
inline void AddManyProducts(const CompactComplex* factors, const Vertex* vertices, Index begin,
  Index end, const float* sections, CompactValues<B>& sum)
{
  AddProducts<B>(factors, vertices, begin, end, sections, sum);
}

/// Does the same, and takes four products at once: for rows that have four entries or fewer, as a
/// rule.
template <int B, typename Vertex>
inline void AddFewProducts(const CompactComplex* factors, const Vertex* vertices, Index begin,
  Index end, const float* sections, CompactValues<B>& sum)
{
  AddProducts<B>(factors, vertices, begin, end, sections, sum);
}

#if defined(__GNUC__)
/// Adds up products, two at once.
template <typename Vertex>
class PairSum
{
  using Values = CompactValues<1>;
  using Numbers = Values::Numbers;
  using Bits __attribute__((vector_size(4 * sizeof(int)))) = int;

public:
  PairSum(const CompactComplex* factors, const Vertex* vertices, const float* sections)
    : Factors(factors)
    , Vertices(vertices)
    , Sections(sections)
  {
  }
  /// Adds the products begin to end - 1.
  /// @tparam Pairs this many pairs of products are computed without a branch, where there are no
  ///         more
  template <int Pairs>
  void Add(Index begin, Index end)
  {
    // Many at once: the number of rounds is easier to predict.
    for (; end - begin > 2 * Pairs + 2; begin += 2 * Pairs)
    {
      for (int pair = 0; pair < Pairs; ++pair)
      {
        this->AddPair(begin + 2 * pair);
      }
    }
    for (; end - begin > 2 * Pairs; begin += 2)
    {
      this->AddPair(begin);
    }
    // A window on these hides the factors after the end: their number is hard to predict, a branch
    // that goes wrong takes longer than products with zeros.
    static constexpr long long shown[] = { -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0 };
    static_assert(2 * Pairs <= Padding && Padding == 6, "the window's size");
    const long long* const window = shown + Padding - (end - begin);
    for (int pair = 0; pair < Pairs; ++pair)
    {
      Bits a;
      Bits mask;
      std::memcpy(&a, this->Factors + begin + 2 * pair, sizeof(a));
      std::memcpy(&mask, window + 2 * pair, sizeof(mask));
      this->AddPair((Numbers)(a & mask), begin + 2 * pair);
    }
  }
  /// The sum in the first two numbers.
  Numbers Total() const
  {
    // i times (x, y) is (-y, x).
    const Numbers& i = this->ByImaginary;
    const Numbers products =
      this->ByReal + Numbers{ i[1], i[0], i[3], i[2] } * Numbers{ -1.0f, 1.0f, -1.0f, 1.0f };
    return products + Numbers{ products[2], products[3], products[2], products[3] };
  }

private:
  double Section(Index k) const
  {
    return Values::Both(this->Sections + 2 * static_cast<std::size_t>(this->Vertices[k]));
  }
  void AddPair(Index k)
  {
    Numbers a;
    std::memcpy(&a, this->Factors + k, sizeof(a));
    this->AddPair(a, k);
  }
  void AddPair(const Numbers& a, Index k)
  {
    const auto x = (Numbers)Values::Pair{ this->Section(k), this->Section(k + 1) };
    this->ByReal += Numbers{ a[0], a[0], a[2], a[2] } * x;
    this->ByImaginary += Numbers{ a[1], a[1], a[3], a[3] } * x;
  }
  const CompactComplex* Factors;
  const Vertex* Vertices;
  const float* Sections;
  Numbers ByReal{};
  Numbers ByImaginary{};
};

template <typename Vertex>
inline void AddManyProducts(const CompactComplex* factors, const Vertex* vertices, Index begin,
  Index end, const float* sections, CompactValues<1>& sum)
{
  PairSum<Vertex> products(factors, vertices, sections);
  products.template Add<3>(begin, end);
  sum.Lanes += products.Total();
}

template <typename Vertex>
inline void AddFewProducts(const CompactComplex* factors, const Vertex* vertices, Index begin,
  Index end, const float* sections, CompactValues<1>& sum)
{
  PairSum<Vertex> products(factors, vertices, sections);
  products.template Add<2>(begin, end);
  sum.Lanes += products.Total();
}
#endif
}

#endif
