// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The fuzzer's seeds and past findings.

#include "FuzzedField.h"
#include "FuzzedFile.h"
#include "FuzzedRemesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

namespace
{
/// Applies a function that says which statement does not hold to one of parts equal shares of the
/// files of a folder.
template <typename Body>
void ExpectNoFlaws(
  const char* folder, const Body& body, std::size_t part = 0, std::size_t parts = 1)
{
  std::vector<std::filesystem::path> files;
  for (const auto& file : std::filesystem::directory_iterator(folder))
  {
    files.push_back(file.path());
  }
  EXPECT_GT(files.size(), 10u);
  std::sort(files.begin(), files.end());
  for (std::size_t k = part; k < files.size(); k += parts)
  {
    std::ifstream stream(files[k], std::ios::binary);
    const std::vector<char> bytes((std::istreambuf_iterator<char>(stream)), {});
    EXPECT_EQ(body(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()), "")
      << files[k];
  }
}

/// Meshes take longest: these parts of them run beside each other.
constexpr std::size_t MeshParts = 4;
}

TEST(Fuzz, CorpusHasNoFlaws)
{
  ExpectNoFlaws(DIRECTIONFIELDS_FUZZ_CORPUS, FuzzedField);
}

TEST(Fuzz, FilesHaveNoFlaws)
{
  ExpectNoFlaws(DIRECTIONFIELDS_FILE_CORPUS, FuzzedFile);
}

TEST(Fuzz, MeshesOfTheFirstPartHaveNoFlaws)
{
  ExpectNoFlaws(DIRECTIONFIELDS_REMESH_CORPUS, FuzzedRemesh, 0, MeshParts);
}

TEST(Fuzz, MeshesOfTheSecondPartHaveNoFlaws)
{
  ExpectNoFlaws(DIRECTIONFIELDS_REMESH_CORPUS, FuzzedRemesh, 1, MeshParts);
}

TEST(Fuzz, MeshesOfTheThirdPartHaveNoFlaws)
{
  ExpectNoFlaws(DIRECTIONFIELDS_REMESH_CORPUS, FuzzedRemesh, 2, MeshParts);
}

TEST(Fuzz, MeshesOfTheLastPartHaveNoFlaws)
{
  ExpectNoFlaws(DIRECTIONFIELDS_REMESH_CORPUS, FuzzedRemesh, 3, MeshParts);
}
