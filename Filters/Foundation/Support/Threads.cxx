// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Support/Threads.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>

namespace DirectionFields
{
namespace
{
/// Looks for new work, or for the end of the others' work, before a thread goes to sleep: some
/// microseconds, about the cost of falling asleep and waking up. Few, so that threads that share a
/// core with other programs lose little.
constexpr int Looks = 2000;

thread_local Threads* Current = nullptr;

inline void Pause()
{
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#endif
}

template <typename Condition>
bool HappensSoon(const Condition& condition)
{
  for (int look = 0; look < Looks; ++look)
  {
    if (condition())
    {
      return true;
    }
    Pause();
  }
  return false;
}
}

class Threads::Pool
{
public:
  explicit Pool(int workers)
  {
    try
    {
      for (int k = 0; k < workers; ++k)
      {
        this->Workers.emplace_back([this] { this->Work(); });
      }
    }
    catch (const std::exception&)
    {
      // Without room or leave for one more, fewer threads do as well. An exception would find those
      // at work that have begun already, and end the program.
    }
  }

  ~Pool()
  {
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      this->Ends = true;
      ++this->Round;
    }
    this->Begin.notify_all();
    for (std::thread& worker : this->Workers)
    {
      worker.join();
    }
  }

  int GetNumber() const { return static_cast<int>(this->Workers.size()) + 1; }

  void Run(Index pieces, const std::function<void(Index)>& body)
  {
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      this->Body = &body;
      this->Pieces = pieces;
      this->Next.store(0);
      this->Failure = nullptr;
      this->Open = true;
      this->Round.fetch_add(1, std::memory_order_release);
    }
    this->Begin.notify_all();
    this->TakePieces();
    {
      // Whoever has not woken up by now is not waited for.
      const std::lock_guard<std::mutex> lock(this->Mutex);
      this->Open = false;
    }
    const auto done = [this] { return this->Busy.load(std::memory_order_acquire) == 0; };
    if (!HappensSoon(done))
    {
      std::unique_lock<std::mutex> lock(this->Mutex);
      this->End.wait(lock, done);
    }
    if (this->Failure)
    {
      std::rethrow_exception(this->Failure);
    }
  }

private:
  void TakePieces()
  {
    for (;;)
    {
      const Index piece = this->Next.fetch_add(1);
      if (piece >= this->Pieces)
      {
        return;
      }
      try
      {
        (*this->Body)(piece);
      }
      catch (...)
      {
        const std::lock_guard<std::mutex> lock(this->Mutex);
        if (!this->Failure)
        {
          this->Failure = std::current_exception();
        }
        this->Next.store(this->Pieces);
      }
    }
  }

  void Work()
  {
    for (unsigned seen = 0;;)
    {
      const auto begins = [&] { return this->Round.load(std::memory_order_acquire) != seen; };
      if (!HappensSoon(begins))
      {
        std::unique_lock<std::mutex> lock(this->Mutex);
        this->Begin.wait(lock, begins);
      }
      {
        const std::lock_guard<std::mutex> lock(this->Mutex);
        seen = this->Round.load();
        if (this->Ends)
        {
          return;
        }
        if (!this->Open)
        {
          continue;
        }
        this->Busy.fetch_add(1);
      }
      this->TakePieces();
      {
        const std::lock_guard<std::mutex> lock(this->Mutex);
        this->Busy.fetch_sub(1, std::memory_order_release);
      }
      this->End.notify_one();
    }
  }

  std::vector<std::thread> Workers;
  std::mutex Mutex;
  std::condition_variable Begin;
  std::condition_variable End;
  std::atomic<unsigned> Round{ 0 };
  std::atomic<int> Busy{ 0 };
  std::atomic<Index> Next{ 0 };
  const std::function<void(Index)>* Body = nullptr;
  Index Pieces = 0;
  std::exception_ptr Failure;
  /// The loop still takes threads in.
  bool Open = false;
  bool Ends = false;
};

Threads::Threads(int number)
{
  const int wanted = number > 0 ? number : GetDefaultNumber();
  this->Workers = std::make_unique<Pool>(wanted - 1);
}

Threads::~Threads() = default;

int Threads::GetNumber() const
{
  return this->Workers->GetNumber();
}

int Threads::GetDefaultNumber()
{
  // The system says on how many processors the process may run.
  int number = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  if (const char* openMP = std::getenv("OMP_NUM_THREADS"))
  {
    const int most = std::atoi(openMP);
    number = most > 0 ? std::min(number, most) : number;
  }
  return number;
}

Threads::Scope::Scope(Threads& threads)
  : Outer(Current)
{
  Current = &threads;
}

Threads::Scope::~Scope()
{
  Current = this->Outer;
}

void Threads::Run(Index pieces, const std::function<void(Index)>& body)
{
  Threads* const threads = Current;
  if (threads == nullptr || threads->GetNumber() == 1 || pieces < 2)
  {
    for (Index piece = 0; piece < pieces; ++piece)
    {
      body(piece);
    }
    return;
  }
  // A loop inside of a piece runs where it is.
  Current = nullptr;
  try
  {
    threads->Workers->Run(pieces, body);
  }
  catch (...)
  {
    Current = threads;
    throw;
  }
  Current = threads;
}
}
