// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The fuzzer's seeds and past findings.

#include "FuzzedField.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

TEST(Fuzz, CorpusHasNoFlaws)
{
  int count = 0;
  for (const auto& file : std::filesystem::directory_iterator(DIRECTIONFIELDS_FUZZ_CORPUS))
  {
    std::ifstream stream(file.path(), std::ios::binary);
    const std::vector<char> bytes((std::istreambuf_iterator<char>(stream)), {});
    EXPECT_EQ(FuzzedField(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()), "")
      << file.path();
    ++count;
  }
  EXPECT_GT(count, 10);
}
