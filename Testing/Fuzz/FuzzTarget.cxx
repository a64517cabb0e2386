// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What libFuzzer calls.

#include "FuzzedField.h"

#include <cstdlib>
#include <iostream>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string flaw = FuzzedField(data, size);
  if (!flaw.empty())
  {
    std::cerr << flaw << std::endl;
    std::abort();
  }
  return 0;
}
