// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The function that libFuzzer calls.

#if defined(DIRECTIONFIELDS_FUZZ_POLYDATA)
#include "FuzzedPolyData.h"
#elif defined(DIRECTIONFIELDS_FUZZ_FILTERS)
#include "FuzzedFilters.h"
#elif defined(DIRECTIONFIELDS_FUZZ_FILE)
#include "FuzzedFile.h"
#elif defined(DIRECTIONFIELDS_FUZZ_REMESH)
#include "FuzzedRemesh.h"
#else
#include "FuzzedField.h"
#endif

#include <cstdlib>
#include <iostream>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
#if defined(DIRECTIONFIELDS_FUZZ_POLYDATA)
  const std::string flaw = FuzzedPolyData(data, size);
#elif defined(DIRECTIONFIELDS_FUZZ_FILTERS)
  const std::string flaw =
    FuzzedFilters(FilterGroup::DIRECTIONFIELDS_FUZZ_FILTERS, data, size, true);
#elif defined(DIRECTIONFIELDS_FUZZ_FILE)
  const std::string flaw = FuzzedFile(data, size);
#elif defined(DIRECTIONFIELDS_FUZZ_REMESH)
  const std::string flaw = FuzzedRemesh(data, size);
#else
  const std::string flaw = FuzzedField(data, size);
#endif
  if (!flaw.empty())
  {
    std::cerr << flaw << std::endl;
    std::abort();
  }
  return 0;
}
