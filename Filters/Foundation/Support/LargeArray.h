// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_LargeArray_h
#define DirectionFields_LargeArray_h

#include <cstddef>
#include <limits>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace DirectionFields
{
/// Storage that is not initialized. That of several megabytes asks for large pages where the system
/// has them (transparent huge pages of Linux): the first touch of each page takes time.
/// @throw std::bad_alloc
void* AllocateLarge(std::size_t bytes);
void ReleaseLarge(void* storage) noexcept;
/// Asks for large pages for storage of another kind, which is best not written to yet.
void PreferLargePages(void* storage, std::size_t bytes) noexcept;
/// Gives the memory of many released small blocks back to the system: the C library may keep it,
/// and large arrays do not fit into it. Takes milliseconds.
void ReturnReleased() noexcept;

/// Leaves values that are not given uninitialized: the loop that fills an array in is to touch its
/// pages first, on all threads.
template <typename T>
struct LargeArrayAllocator
{
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);
  using value_type = T;
  using is_always_equal = std::true_type;

  LargeArrayAllocator() = default;
  // Containers convert allocators of one type to those of another by themselves.
  template <typename Other>
  LargeArrayAllocator(const LargeArrayAllocator<Other>&) // NOLINT(google-explicit-constructor)
  {
  }
  T* allocate(std::size_t count)
  {
    if (count > std::numeric_limits<std::size_t>::max() / sizeof(T))
    {
      throw std::bad_array_new_length();
    }
    return static_cast<T*>(AllocateLarge(count * sizeof(T)));
  }
  void deallocate(T* storage, std::size_t) noexcept { ReleaseLarge(storage); }
  template <typename Other>
  void construct(Other*) noexcept
  {
  }
  template <typename Other, typename... Values>
  void construct(Other* at, Values&&... values)
  {
    ::new (static_cast<void*>(at)) Other(std::forward<Values>(values)...);
  }
  friend bool operator==(const LargeArrayAllocator&, const LargeArrayAllocator&) { return true; }
  friend bool operator!=(const LargeArrayAllocator&, const LargeArrayAllocator&) { return false; }
};

/// An array with as many values as the mesh has vertices, edges or triangles, or the like. Unlike a
/// std::vector it does not set values to zero of its own accord: LargeArray(n) and resize(n) leave
/// them undefined.
template <typename T>
using LargeArray = std::vector<T, LargeArrayAllocator<T>>;
}

#endif
