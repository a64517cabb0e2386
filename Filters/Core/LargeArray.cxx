// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LargeArray.h"

#include <cstdlib>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace DirectionFields
{
namespace
{
/// Of large pages; no storage is worth one that is not several times as large.
constexpr std::size_t PageBytes = std::size_t(1) << 21;
constexpr std::size_t FewestPages = 2;
}

void* AllocateLarge(std::size_t bytes)
{
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  if (bytes >= FewestPages * PageBytes)
  {
    void* storage = nullptr;
    if (posix_memalign(&storage, PageBytes, bytes) != 0)
    {
      throw std::bad_alloc();
    }
    // No more than advice: where it is not taken, pages are small. The rest, less than a page, stays
    // out, or it would take the memory of one.
    madvise(storage, bytes / PageBytes * PageBytes, MADV_HUGEPAGE);
    return storage;
  }
#endif
  void* const storage = std::malloc(bytes > 0 ? bytes : 1);
  if (!storage)
  {
    throw std::bad_alloc();
  }
  return storage;
}

void ReleaseLarge(void* storage) noexcept
{
  std::free(storage);
}
}
