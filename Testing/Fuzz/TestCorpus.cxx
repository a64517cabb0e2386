// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The fuzzer's seeds and past findings.

#include "FuzzedField.h"
#include "FuzzedFile.h"
#include "FuzzedRemesh.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

namespace
{
/// Applies a function that says what does not hold to the files of a folder.
template <typename Body>
void ExpectNoFlaws(const char* folder, const Body& body)
{
  int count = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder))
  {
    std::ifstream stream(file.path(), std::ios::binary);
    const std::vector<char> bytes((std::istreambuf_iterator<char>(stream)), {});
    EXPECT_EQ(body(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()), "")
      << file.path();
    ++count;
  }
  EXPECT_GT(count, 10);
}
}

TEST(Fuzz, CorpusHasNoFlaws)
{
  ExpectNoFlaws(DIRECTIONFIELDS_FUZZ_CORPUS, FuzzedField);
}

TEST(Fuzz, FilesHaveNoFlaws)
{
  ExpectNoFlaws(DIRECTIONFIELDS_FILE_CORPUS, FuzzedFile);
}

TEST(Fuzz, MeshesHaveNoFlaws)
{
  ExpectNoFlaws(DIRECTIONFIELDS_REMESH_CORPUS, FuzzedRemesh);
}
