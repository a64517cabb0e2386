// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The seeds and past findings of the fuzzers of polydata, and of filters on fields. Those of filters
// are named after their target.

#include "Checks.h"

#include "Fuzz/FuzzedFilters.h"
#include "Fuzz/FuzzedPolyData.h"

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <vector>

namespace
{
/// Calls a function, which says what does not hold, with the bytes of each file of a folder.
void TestCorpus(const std::filesystem::path& folder, int least,
  const std::function<std::string(
    const std::string& name, const std::uint8_t* data, std::size_t size)>& body)
{
  int count = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder))
  {
    std::ifstream stream(file.path(), std::ios::binary);
    const std::vector<char> bytes((std::istreambuf_iterator<char>(stream)), {});
    const std::string flaw = body(file.path().filename().string(),
      reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    if (!flaw.empty())
    {
      std::cerr << file.path() << ": " << flaw << std::endl;
    }
    CHECK(flaw.empty());
    ++count;
  }
  CHECK(count >= least);
}
}

int TestDirectionFieldCorpus(int, char*[])
{
  TestCorpus(DIRECTIONFIELDS_POLYDATA_CORPUS, 10,
    [](const std::string&, const std::uint8_t* data, std::size_t size)
    { return FuzzedPolyData(data, size); });
  const std::map<std::string, FilterGroup> groups = { { "streamlines", FilterGroup::Streamlines },
    { "edits", FilterGroup::Edits }, { "comparison", FilterGroup::Comparison },
    { "pairs", FilterGroup::Pairs } };
  TestCorpus(DIRECTIONFIELDS_FILTER_CORPUS, 40,
    [&groups](const std::string& name, const std::uint8_t* data, std::size_t size)
    { return FuzzedFilters(groups.at(name.substr(0, name.find('-'))), data, size, true); });
  return Checks::Result();
}
