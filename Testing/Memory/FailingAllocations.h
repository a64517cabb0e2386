// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FailingAllocations_h
#define DirectionFields_FailingAllocations_h

/// A library with malloc and all that goes with it, which fails when it is told to: for programs
/// that are linked with it, and for others by LD_PRELOAD. Functions of C, so that Python can call
/// them.
extern "C"
{
  /// Whether memory goes through this library, which glibc alone lets it.
  int HasFailingAllocations();

  /// One of the next allocations fails. Only those by the project's own code count, since VTK ends the
  /// program where some of its smallest ones fail, and so does an empty sparse matrix of Eigen that
  /// is moved.
  /// @param number how many are left before it; negative if none is to fail
  /// @param bytes  the least size of those that count
  void FailAllocation(long long number, long long bytes);

  /// From now on there is room for some bytes more, for blocks of 1 KiB or more: smaller ones still
  /// fit in where memory is full.
  /// @param bytes negative for no limit
  void LimitAllocations(long long bytes);

  /// No allocation fails any more.
  /// @return how many were counted; of a limit, the most bytes that were taken at a time
  long long StopFailingAllocations();
}

#endif
