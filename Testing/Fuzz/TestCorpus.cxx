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
/// Applies a function that says which statement does not hold to the files of a folder.
template <typename Body>
void ExpectNoFlaws(const std::filesystem::path& folder, std::size_t least, const Body& body)
{
  std::vector<std::filesystem::path> files;
  for (const auto& file : std::filesystem::directory_iterator(folder))
  {
    if (file.is_regular_file())
    {
      files.push_back(file.path());
    }
  }
  EXPECT_GE(files.size(), least);
  std::sort(files.begin(), files.end());
  for (const std::filesystem::path& file : files)
  {
    std::ifstream stream(file, std::ios::binary);
    const std::vector<char> bytes((std::istreambuf_iterator<char>(stream)), {});
    EXPECT_EQ(body(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()), "") << file;
  }
}
}

TEST(Fuzz, CorpusHasNoFlaws)
{
  ExpectNoFlaws(DIRECTIONFIELDS_FUZZ_CORPUS, 10, FuzzedField);
}

TEST(Fuzz, FilesHaveNoFlaws)
{
  ExpectNoFlaws(DIRECTIONFIELDS_FILE_CORPUS, 10, FuzzedFile);
}

TEST(Fuzz, MeshesHaveNoFlaws)
{
  ExpectNoFlaws(DIRECTIONFIELDS_REMESH_CORPUS, 10, FuzzedRemesh);
}

// Apart from the others, since they take ten times as long, under a sanitizer minutes.
TEST(Fuzz, LargeMeshesHaveNoFlaws)
{
  ExpectNoFlaws(std::filesystem::path(DIRECTIONFIELDS_REMESH_CORPUS) / "Large", 2, FuzzedRemesh);
}
