// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The seeds and past findings of the fuzzer of polydata.

#include "Checks.h"

#include "Fuzz/FuzzedPolyData.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

int TestDirectionFieldCorpus(int, char*[])
{
  int count = 0;
  for (const auto& file : std::filesystem::directory_iterator(DIRECTIONFIELDS_POLYDATA_CORPUS))
  {
    std::ifstream stream(file.path(), std::ios::binary);
    const std::vector<char> bytes((std::istreambuf_iterator<char>(stream)), {});
    const std::string flaw =
      FuzzedPolyData(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    if (!flaw.empty())
    {
      std::cerr << file.path() << ": " << flaw << std::endl;
    }
    CHECK(flaw.empty());
    ++count;
  }
  CHECK(count >= 10);
  return Checks::Result();
}
