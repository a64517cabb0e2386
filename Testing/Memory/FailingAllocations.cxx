// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FailingAllocations.h"

#include <cstdlib>

#ifdef __GLIBC__

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <new>

#include <dlfcn.h>
#include <execinfo.h>
#include <malloc.h>

namespace
{
enum class Mode
{
  Off,
  One,
  Limit
};

constexpr std::size_t Small = 1024;

// Without initialization at run time, since memory is needed before.
std::atomic<Mode> Now{ Mode::Off };
/// The number of the allocation that fails, or the bytes that there is room for.
std::atomic<long long> Least{ -1 };
std::atomic<std::size_t> Smallest{ 0 };
std::atomic<long long> Counted{ 0 };
std::atomic<long long> Taken{ 0 };
std::atomic<long long> MostTaken{ 0 };
thread_local bool IsAsking = false;

/// Whether the code at a place is in one of the libraries whose allocations count.
bool IsOwn(const void* place)
{
  Dl_info library{};
  const bool isKnown = dladdr(place, &library) != 0 && library.dli_fname;
  return isKnown && std::strstr(library.dli_fname, "libvtkDirectionFields");
}

/// Whether memory is asked for by such code. Functions of the standard library's templates are
/// taken from any library that has them: who calls such a function has to be there, too.
/// @param place that the memory is asked for from
bool IsAskedByOwn(const void* place)
{
  if (!IsOwn(place))
  {
    return false;
  }
  constexpr int most = 8;
  void* frames[most];
  // This may need memory itself.
  IsAsking = true;
  const int count = backtrace(frames, most);
  IsAsking = false;
  int k = 0;
  while (k < count && frames[k] != place)
  {
    ++k;
  }
  return k + 1 < count && IsOwn(frames[k + 1]);
}

/// @param place that the memory is asked for from
bool Fails(std::size_t bytes, const void* place)
{
  const Mode mode = Now.load();
  if (mode == Mode::Off || IsAsking)
  {
    return false;
  }
  const long long least = Least.load();
  bool fails = false;
  if (mode == Mode::Limit)
  {
    fails = least >= 0 && bytes >= Small && Taken.load() + static_cast<long long>(bytes) > least;
  }
  else if (bytes >= Smallest.load() && IsAskedByOwn(place))
  {
    fails = Counted.fetch_add(1) == least;
  }
  if (fails)
  {
    errno = ENOMEM;
  }
  return fails;
}

void* Took(void* memory)
{
  if (Now.load() == Mode::Limit && memory)
  {
    const long long taken = Taken += static_cast<long long>(malloc_usable_size(memory));
    long long most = MostTaken.load();
    while (taken > most && !MostTaken.compare_exchange_weak(most, taken))
    {
    }
  }
  return memory;
}

void Gives(void* memory)
{
  if (Now.load() == Mode::Limit && memory)
  {
    Taken -= static_cast<long long>(malloc_usable_size(memory));
  }
}
}

// glibc's own functions by their other names. It takes those below for all programs and libraries
// that are loaded after them.
extern "C"
{
  void* __libc_malloc(std::size_t bytes);
  void* __libc_calloc(std::size_t number, std::size_t bytes);
  void* __libc_realloc(void* old, std::size_t bytes);
  void* __libc_memalign(std::size_t alignment, std::size_t bytes);
  void __libc_free(void* memory);

  void* malloc(std::size_t bytes)
  {
    return Fails(bytes, __builtin_return_address(0)) ? nullptr : Took(__libc_malloc(bytes));
  }

  void* calloc(std::size_t number, std::size_t bytes)
  {
    return Fails(number * bytes, __builtin_return_address(0)) ? nullptr
                                                              : Took(__libc_calloc(number, bytes));
  }

  void* realloc(void* old, std::size_t bytes)
  {
    if (bytes > 0 && Fails(bytes, __builtin_return_address(0)))
    {
      return nullptr;
    }
    Gives(old);
    return Took(__libc_realloc(old, bytes));
  }

  void* memalign(std::size_t alignment, std::size_t bytes)
  {
    return Fails(bytes, __builtin_return_address(0)) ? nullptr
                                                     : Took(__libc_memalign(alignment, bytes));
  }

  void* aligned_alloc(std::size_t alignment, std::size_t bytes)
  {
    return Fails(bytes, __builtin_return_address(0)) ? nullptr
                                                     : Took(__libc_memalign(alignment, bytes));
  }

  int posix_memalign(void** memory, std::size_t alignment, std::size_t bytes)
  {
    const bool fails = Fails(bytes, __builtin_return_address(0));
    void* const found = fails ? nullptr : Took(__libc_memalign(alignment, bytes));
    if (found)
    {
      *memory = found;
    }
    return found ? 0 : ENOMEM;
  }

  void free(void* memory)
  {
    Gives(memory);
    __libc_free(memory);
  }

  int HasFailingAllocations()
  {
    return 1;
  }

  void FailAllocation(long long number, long long bytes)
  {
    Least = number;
    Smallest = static_cast<std::size_t>(bytes);
    Counted = 0;
    Now = Mode::One;
  }

  void LimitAllocations(long long bytes)
  {
    Least = bytes;
    Taken = 0;
    MostTaken = 0;
    Now = Mode::Limit;
  }

  long long StopFailingAllocations()
  {
    return Now.exchange(Mode::Off) == Mode::Limit ? MostTaken : Counted;
  }
}

// C++ asks for memory from here, so that it is known who does.
void* operator new(std::size_t bytes)
{
  const bool fails = Fails(bytes, __builtin_return_address(0));
  void* const memory = fails ? nullptr : Took(__libc_malloc(bytes > 0 ? bytes : 1));
  if (!memory)
  {
    throw std::bad_alloc();
  }
  return memory;
}

void* operator new[](std::size_t bytes)
{
  const bool fails = Fails(bytes, __builtin_return_address(0));
  void* const memory = fails ? nullptr : Took(__libc_malloc(bytes > 0 ? bytes : 1));
  if (!memory)
  {
    throw std::bad_alloc();
  }
  return memory;
}

void operator delete(void* memory) noexcept
{
  free(memory);
}

void operator delete[](void* memory) noexcept
{
  free(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
  free(memory);
}

void operator delete[](void* memory, std::size_t) noexcept
{
  free(memory);
}

#else

extern "C"
{
  int HasFailingAllocations()
  {
    return 0;
  }
  void FailAllocation(long long, long long) {}
  void LimitAllocations(long long) {}
  long long StopFailingAllocations()
  {
    return 0;
  }
}

#endif
