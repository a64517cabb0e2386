// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Watch_h
#define DirectionFields_Watch_h

#include <functional>
#include <future>
#include <thread>

namespace DirectionFields::Internal
{
/// A computation that cannot be interrupted, on a thread of its own. Its result is waited for a
/// little at a time, so that one may ask meanwhile whether it is still wanted. Where the object
/// goes before Take, the computation is given up: its thread runs to its end, which comes at the
/// latest when the program or the library is unloaded.
class Watch
{
public:
  /// @param compute must own everything that it uses
  explicit Watch(std::function<bool()> compute);
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;
  ~Watch();

  /// Waits 50 ms at most. Whether the result is there.
  bool IsDone() const;
  /// The result, which is waited for. May be called once; throws the exception of the computation
  /// again.
  bool Take();

private:
  std::thread Thread;
  std::future<bool> Result;
};
}

#endif
