// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Solvers/Matrices/Factorization.h"

#include <Eigen/SparseCholesky>
#ifdef DIRECTIONFIELDS_HAVE_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

#include <algorithm>
#include <chrono>
#include <future>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace DirectionFields
{
namespace
{
/// Smaller matrices are factored before anybody would ask.
constexpr Eigen::Index WatchedRows = 5000;
constexpr std::chrono::milliseconds TimeBetweenQuestions(50);

/// Threads whose results nobody wants any more. They run to their ends, which are waited for before
/// their code may go.
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
      const bool done =
        entry.Result.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
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

/// A computation on a thread of its own, given up unless its result is taken.
class Watch
{
public:
  explicit Watch(std::function<bool()> compute)
  {
    std::packaged_task<bool()> task(std::move(compute));
    this->Result = task.get_future();
    this->Thread = std::thread(std::move(task));
  }
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;
  ~Watch()
  {
    if (this->Thread.joinable())
    {
      GivenUp::Instance().Add(std::move(this->Thread), std::move(this->Result));
    }
  }
  bool IsDone() const
  {
    return this->Result.wait_for(TimeBetweenQuestions) == std::future_status::ready;
  }
  bool Take()
  {
    this->Thread.join();
    return this->Result.get();
  }

private:
  std::thread Thread;
  std::future<bool> Result;
};
}

class Factorization::Backend
{
public:
  virtual ~Backend() = default;
  virtual bool Compute(const SparseMatrix& matrix) = 0;
  virtual ComplexVector Solve(const ComplexVector& rightHandSide) const = 0;
};

class Factorization::EigenBackend : public Factorization::Backend
{
public:
  bool Compute(const SparseMatrix& matrix) override
  {
    this->Solver.compute(matrix);
    return this->Solver.info() == Eigen::Success &&
      (this->Solver.vectorD().real().array() > 0.0).all();
  }
  ComplexVector Solve(const ComplexVector& rightHandSide) const override
  {
    return this->Solver.solve(rightHandSide);
  }

private:
  Eigen::SimplicialLDLT<SparseMatrix> Solver;
};

#ifdef DIRECTIONFIELDS_HAVE_CHOLMOD
namespace
{
/// Rows from which the supernodal factorization is the faster one.
constexpr Eigen::Index CholmodRows = 50000;
}

class Factorization::CholmodBackend : public Factorization::Backend
{
public:
  CholmodBackend()
  {
    // A failure is reported by Compute; nothing is printed.
    this->Solver.cholmod().print = 0;
  }
  bool Compute(const SparseMatrix& matrix) override
  {
    this->Solver.compute(matrix);
    return this->Solver.info() == Eigen::Success;
  }
  ComplexVector Solve(const ComplexVector& rightHandSide) const override
  {
    return this->Solver.solve(rightHandSide);
  }

private:
  mutable Eigen::CholmodSupernodalLLT<SparseMatrix> Solver;
};
#endif

Factorization::Factorization() = default;
Factorization::~Factorization() = default;

bool Factorization::Compute(const SparseMatrix& matrix, const GoOnFunction& goOn)
{
#ifdef DIRECTIONFIELDS_HAVE_CHOLMOD
  if (matrix.rows() >= CholmodRows)
  {
    this->Factor = std::make_shared<CholmodBackend>();
    if (Watched(this->Factor, matrix, goOn))
    {
      return true;
    }
  }
#endif
  this->Factor = std::make_shared<EigenBackend>();
  return Watched(this->Factor, matrix, goOn);
}

/// backend->Compute(matrix), asking meanwhile.
bool Factorization::Watched(const std::shared_ptr<Backend>& backend, const SparseMatrix& matrix,
  const GoOnFunction& goOn)
{
  RequireToGoOn(goOn);
  if (!goOn || matrix.rows() < WatchedRows)
  {
    return backend->Compute(matrix);
  }
  // The thread has its own copy of everything: nobody waits for it if it is given up.
  Watch watch(
    [backend, copy = std::make_shared<SparseMatrix>(matrix)] { return backend->Compute(*copy); });
  while (!watch.IsDone())
  {
    RequireToGoOn(goOn);
  }
  return watch.Take();
}

ComplexVector Factorization::Solve(const ComplexVector& rightHandSide) const
{
  return this->Factor->Solve(rightHandSide);
}
}
