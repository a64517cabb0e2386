// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Support/LargeArray.h"

#include <cstdint>
#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif
#ifdef __linux__
#include <sys/mman.h>
#ifdef MADV_HUGEPAGE
#define DIRECTIONFIELDS_LARGE_PAGES
#endif
#endif

namespace DirectionFields
{
namespace
{
/// The size of a large page. Storage for few of them keeps small ones.
[[maybe_unused]] constexpr std::size_t PageBytes = std::size_t(1) << 21;
[[maybe_unused]] constexpr std::size_t FewestPages = 2;
}

void* AllocateLarge(std::size_t bytes)
{
#ifdef DIRECTIONFIELDS_LARGE_PAGES
  if (bytes >= FewestPages * PageBytes)
  {
    void* storage = nullptr;
    if (posix_memalign(&storage, PageBytes, bytes) != 0)
    {
      throw std::bad_alloc();
    }
    PreferLargePages(storage, bytes);
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

void PreferLargePages([[maybe_unused]] void* storage, [[maybe_unused]] std::size_t bytes) noexcept
{
#ifdef DIRECTIONFIELDS_LARGE_PAGES
  if (bytes < FewestPages * PageBytes)
  {
    return;
  }
  const std::size_t before = reinterpret_cast<std::uintptr_t>(storage) % PageBytes;
  const std::size_t skipped = before > 0 ? PageBytes - before : 0;
  // Whole pages only: the remainder would take the memory of one. It is advice only: where the
  // system does not take it, pages are small.
  madvise(static_cast<char*>(storage) + skipped, (bytes - skipped) / PageBytes * PageBytes,
    MADV_HUGEPAGE);
#endif
}

void ReturnReleased() noexcept
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

void ReleaseLarge(void* storage) noexcept
{
  std::free(storage);
}
}
