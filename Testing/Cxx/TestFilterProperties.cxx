// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Statements that hold for every filter, on pseudo-random surfaces, fields and options: a filter
// that was used before gives the bytes of a new one, two threads those of one, inputs stay as they
// were, numbers are finite, indices sum up, and an error leaves nothing.
//
// DIRECTIONFIELDS_PROPERTY_CASES in the environment says how many to take of each group of filters,
// and DIRECTIONFIELDS_PROPERTY_FIRST the number of the first. From the very first on, those that once
// failed are taken, too. DIRECTIONFIELDS_PROPERTY_SMALL=1 takes small surfaces for large ones: ten
// times as many cases in the same time.

#include "Checks.h"

#include "Fuzz/FuzzedFilters.h"

#include <cstdint>
#include <cstdlib>
#include <random>

namespace
{
/// Few enough for every run of the tests.
constexpr int FewCases = 30;

/// Cases that once failed: places at the end of single and double precision, lines farther apart
/// than there are numbers, magnitudes that only double precision has, surfaces without an area in
/// single precision, components that are kept among pure quads, directions that differ a little
/// where points are one, and a place that is very far from 0.
struct Finding
{
  FilterGroup Group;
  int Number;
};
constexpr Finding Findings[] = { { FilterGroup::Streamlines, 344 },
  { FilterGroup::Streamlines, 359 }, { FilterGroup::Streamlines, 1036 },
  { FilterGroup::Edits, 1855 }, { FilterGroup::Edits, 5496 }, { FilterGroup::Comparison, 103403 },
  { FilterGroup::Pairs, 628 }, { FilterGroup::Pairs, 2629 }, { FilterGroup::Pairs, 3767 },
  { FilterGroup::Pairs, 3769 }, { FilterGroup::Pairs, 6828 }, { FilterGroup::Streamlines, 300341 },
  { FilterGroup::Edits, 300341 }, { FilterGroup::Comparison, 300341 },
  { FilterGroup::Pairs, 300341 }, { FilterGroup::Pairs, 300397 } };

int FromEnvironment(const char* name, int standard)
{
  const char* text = std::getenv(name);
  return text ? std::atoi(text) : standard;
}

std::vector<std::uint8_t> BytesOf(unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<std::uint8_t> bytes(40 + random() % 60);
  for (std::uint8_t& byte : bytes)
  {
    // Zeros stand for defaults.
    byte = static_cast<std::uint8_t>(random() % 4 == 0 ? 0 : random() % 256);
  }
  return bytes;
}

void TestCase(FilterGroup group, int number, bool isSmall)
{
  const std::vector<std::uint8_t> bytes =
    BytesOf(4U * static_cast<unsigned>(number) + static_cast<unsigned>(group));
  const std::string flaw = FuzzedFilters(group, bytes.data(), bytes.size(), isSmall);
  if (!flaw.empty())
  {
    std::cerr << "group " << static_cast<int>(group) << ", case " << number << ": " << flaw
              << std::endl;
  }
  CHECK(flaw.empty());
}
}

int TestFilterProperties(int, char*[])
{
  const int first = FromEnvironment("DIRECTIONFIELDS_PROPERTY_FIRST", 0);
  for (const Finding& finding : Findings)
  {
    if (first == 0)
    {
      TestCase(finding.Group, finding.Number, false);
    }
  }
  const bool isSmall = FromEnvironment("DIRECTIONFIELDS_PROPERTY_SMALL", 0) != 0;
  const int cases = FromEnvironment("DIRECTIONFIELDS_PROPERTY_CASES", FewCases);
  for (const FilterGroup group :
    { FilterGroup::Streamlines, FilterGroup::Edits, FilterGroup::Comparison, FilterGroup::Pairs })
  {
    for (int number = first; number < first + cases; ++number)
    {
      TestCase(group, number, isSmall);
    }
  }
  return Checks::Result();
}
