// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Matrices/CompactValues.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <random>

using namespace DirectionFields;

namespace
{
constexpr Index Vertices = 50;

/// Rows of 0, 1, 2, ... entries one after the other, and sections.
template <int B, typename Vertex>
struct Rows
{
  static constexpr Index Count = 20;

  Rows()
    : Sections(2 * B * Vertices)
  {
    std::mt19937 engine(7);
    const auto random = [&] { return engine() / 4294967296.0f - 0.5f; };
    Index entries = 0;
    for (Index row = 0; row < Count; ++row)
    {
      this->Begin.push_back(entries);
      entries += row;
    }
    this->Begin.push_back(entries);
    ResizePadded(this->Factor, entries);
    ResizePadded(this->Column, entries);
    for (Index k = 0; k < entries; ++k)
    {
      this->Factor[k] = CompactComplex(random(), random());
      this->Column[k] = static_cast<Vertex>(engine() % Vertices);
    }
    for (float& value : this->Sections)
    {
      value = random();
    }
  }
  Complex Section(Index v, int b) const
  {
    return { this->Sections[2 * B * v + b], this->Sections[2 * B * v + B + b] };
  }
  Complex Sum(Index row, int b) const
  {
    Complex sum = 0.0;
    for (Index k = this->Begin[row]; k < this->Begin[row + 1]; ++k)
    {
      sum += Complex(this->Factor[k]) * this->Section(this->Column[k], b);
    }
    return sum;
  }

  std::vector<Index> Begin;
  LargeArray<CompactComplex> Factor;
  LargeArray<Vertex> Column;
  CompactSections Sections;
};

/// The known value of a vertex and each row's products.
template <int B, typename Vertex>
void ExpectSums()
{
  const Rows<B, Vertex> rows;
  const Index known = 3;
  for (Index row = 0; row < rows.Count; ++row)
  {
    const CompactComplex* factors = rows.Factor.data();
    const Vertex* columns = rows.Column.data();
    const float* x = rows.Sections.data();
    const Index begin = rows.Begin[row];
    const Index end = rows.Begin[row + 1];
    std::array<CompactValues<B>, 3> sums;
    sums.fill(CompactValues<B>(x, known));
    AddProducts(factors, columns, begin, end, x, sums[0]);
    AddManyProducts(factors, columns, begin, end, x, sums[1]);
    AddFewProducts(factors, columns, begin, end, x, sums[2]);
    for (std::size_t kind = 0; kind < sums.size(); ++kind)
    {
      std::array<float, 2 * B> stored;
      sums[kind].Store(stored.data(), 0);
      for (int b = 0; b < B; ++b)
      {
        const Complex expected = rows.Section(known, b) + rows.Sum(row, b);
        EXPECT_NEAR(stored[b], expected.real(), 2e-6) << row << " entries, sum " << kind;
        EXPECT_NEAR(stored[B + b], expected.imag(), 2e-6) << row << " entries, sum " << kind;
      }
    }
  }
}
}

TEST(CompactValues, SumsOfAnyNumberOfProducts)
{
  ExpectSums<1, Index>();
  ExpectSums<1, std::uint16_t>();
  ExpectSums<4, Index>();
}

TEST(CompactValues, OfOneSectionAreThoseOfFour)
{
  const CompactSections one{ 1.5f, -0.25f, -2.0f, 3.0f };
  CompactSections four(16, 0.0f);
  for (int v = 0; v < 2; ++v)
  {
    four[8 * v] = one[2 * v];
    four[8 * v + 4] = one[2 * v + 1];
  }
  const auto compute = [](auto sum, const CompactSections& sections)
  {
    sum.Add(CompactComplex(0.5f, 2.0f), sections.data(), 0);
    sum.AddReal(-3.0f, sections.data(), 1);
    sum.Scale(0.5f);
    return sum.Value();
  };
  const CompactComplex expected = 0.5f *
    (CompactComplex(0.5f, 2.0f) * CompactComplex(1.5f, -0.25f) -
      3.0f * CompactComplex(-2.0f, 3.0f));
  EXPECT_EQ(compute(CompactValues<1>(), one), expected);
  EXPECT_EQ(compute(CompactValues<4>(), four), expected);
}
