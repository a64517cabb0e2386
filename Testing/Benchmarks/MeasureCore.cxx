// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// MeasureCore POINTS TRIANGLES RUNS: the smoothest cross field by the libraries alone, of a surface in two
// files of doubles and of ids of 32 bits. Prints the least seconds of the runs, those of all processors added
// up, and the process's most memory in bytes.

#include <DirectionFields/DirectionField.h>

#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <limits>
#include <memory>
#include <vector>

namespace
{
template <typename Row>
std::vector<Row> Read(const char* name)
{
  std::ifstream file(name, std::ios::binary | std::ios::ate);
  std::vector<Row> rows(static_cast<std::size_t>(file.tellg()) / sizeof(Row));
  file.seekg(0);
  file.read(
    reinterpret_cast<char*>(rows.data()), static_cast<std::streamsize>(rows.size() * sizeof(Row)));
  return rows;
}
}

int main(int argc, char* argv[])
{
  if (argc != 4)
  {
    return EXIT_FAILURE;
  }
  auto surface = std::make_shared<DirectionFields::Surface>();
  surface->Points = Read<DirectionFields::Vector3>(argv[1]);
  surface->Triangles = Read<DirectionFields::Triangle>(argv[2]);
  double least = std::numeric_limits<double>::max();
  for (int run = 0; run < std::atoi(argv[3]); ++run)
  {
    const std::clock_t begin = std::clock();
    const DirectionFields::Result field =
      DirectionFields::DirectionField(surface).Compute(DirectionFields::Options());
    least = std::min(least, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::printf("%.6f %ld\n", least, usage.ru_maxrss * 1024);
  return EXIT_SUCCESS;
}
