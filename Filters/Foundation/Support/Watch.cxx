// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Support/Watch.h"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <utility>
#include <vector>

namespace DirectionFields::Internal
{
namespace
{
constexpr std::chrono::milliseconds TimeBetweenQuestions(50);

/// Threads whose results nobody wants. They run to their ends, which are waited for before their
/// code is unloaded.
class GivenUp
{
public:
  static GivenUp& Instance()
  {
    static GivenUp instance;
    return instance;
  }
  void Add(std::thread thread, std::future<bool> result)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    const auto isDone = [](Entry& entry)
    {
      const bool done = entry.Result.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
      if (done)
      {
        entry.Thread.join();
      }
      return done;
    };
    this->Entries.erase(
      std::remove_if(this->Entries.begin(), this->Entries.end(), isDone), this->Entries.end());
    this->Entries.push_back({ std::move(thread), std::move(result) });
  }
  ~GivenUp()
  {
    for (Entry& entry : this->Entries)
    {
      entry.Thread.join();
    }
  }

private:
  struct Entry
  {
    std::thread Thread;
    std::future<bool> Result;
  };
  std::mutex Mutex;
  std::vector<Entry> Entries;
};
}

Watch::Watch(std::function<bool()> compute)
{
  std::packaged_task<bool()> task(std::move(compute));
  this->Result = task.get_future();
  this->Thread = std::thread(std::move(task));
}

Watch::~Watch()
{
  if (this->Thread.joinable())
  {
    GivenUp::Instance().Add(std::move(this->Thread), std::move(this->Result));
  }
}

bool Watch::IsDone() const
{
  return this->Result.wait_for(TimeBetweenQuestions) == std::future_status::ready;
}

bool Watch::Take()
{
  this->Thread.join();
  return this->Result.get();
}
}
