// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef Messages_h
#define Messages_h

#include "Processes.h"

#include <mpi.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <new>
#include <type_traits>
#include <vector>

namespace DirectionFields::Parallel
{
/// There is too little memory on this process, which all that it works with know.
class TooLittleMemory : public std::bad_alloc
{
};

/// Does work of each process's own between messages, which must not communicate. Where there is too
/// little memory on any process of the communicator, that one throws TooLittleMemory and the others
/// a ProcessesError without words, which Processes::Together makes one error of.
template <typename Work>
void DoOnAll(MPI_Comm communicator, const Work& work)
{
  int isShort = 0;
  try
  {
    work();
  }
  catch (const std::bad_alloc&)
  {
    isShort = 1;
  }
  int isAnyShort = 0;
  MPI_Allreduce(&isShort, &isAnyShort, 1, MPI_INT, MPI_MAX, communicator);
  if (isShort)
  {
    throw TooLittleMemory();
  }
  if (isAnyShort)
  {
    throw ProcessesError("");
  }
}

/// Throws std::bad_alloc where there is no room for some bytes: before work in which a process that
/// finds none cannot tell the others, who wait for it.
inline void RequireMemory(std::size_t bytes)
{
  // The compiler may leave out allocations of no use, unless their address is.
  void* volatile room = std::malloc(bytes);
  const bool isThere = room != nullptr;
  std::free(room);
  if (!isThere)
  {
    throw std::bad_alloc();
  }
}

/// Does work with messages. Where it ends as DoOnAll does, all processes throw the same
/// ProcessesError, with words.
template <typename Work>
void ShareErrors(Processes& processes, const Work& work)
{
  std::exception_ptr failure;
  try
  {
    work();
    return;
  }
  catch (const TooLittleMemory&)
  {
    failure = std::current_exception();
  }
  catch (const ProcessesError&)
  {
    failure = std::current_exception();
  }
  processes.Together([&] { std::rethrow_exception(failure); });
}

/// Messages between all processes, for values of fixed size. All processes call each function in
/// the same order. A message to one process, and all messages that a process receives together,
/// have less than 2^31 values. Where there is no room for them on any process, all throw as DoOnAll
/// does.
class Messages
{
public:
  explicit Messages(MPI_Comm communicator)
    : Communicator(communicator)
  {
    MPI_Comm_rank(communicator, &this->Rank);
    MPI_Comm_size(communicator, &this->Size);
  }

  MPI_Comm GetCommunicator() const { return this->Communicator; }
  int Own() const { return this->Rank; }
  int Count() const { return this->Size; }

  /// Does work of each process's own, as DoOnAll does.
  template <typename Work>
  void Together(const Work& work) const
  {
    DoOnAll(this->Communicator, work);
  }

  /// The values of all processes, in their order.
  template <typename T>
  struct Collected
  {
    std::vector<T> Values;
    /// The first value of each process, and the number of all.
    std::vector<int> First;
  };
  template <typename T>
  Collected<T> AllGather(const std::vector<T>& own) const
  {
    const auto length = static_cast<int>(own.size());
    std::vector<int> lengths;
    this->Together([&] { lengths.resize(static_cast<std::size_t>(this->Size)); });
    MPI_Allgather(&length, 1, MPI_INT, lengths.data(), 1, MPI_INT, this->Communicator);
    Collected<T> all;
    this->Together(
      [&]
      {
        all.First = FirstOf(lengths);
        all.Values.resize(static_cast<std::size_t>(all.First.back()));
      });
    const TypeOf<T> type;
    MPI_Allgatherv(own.data(), length, type.Handle, all.Values.data(), lengths.data(),
      all.First.data(), type.Handle, this->Communicator);
    return all;
  }

  /// Sends values to each process.
  /// @return the values of each process for this one
  template <typename T>
  std::vector<std::vector<T>> Exchange(const std::vector<std::vector<T>>& to) const
  {
    std::vector<int> lengths;
    std::vector<int> firstSent;
    std::vector<T> sent;
    std::vector<int> coming;
    this->Together(
      [&]
      {
        for (const std::vector<T>& values : to)
        {
          lengths.push_back(static_cast<int>(values.size()));
          sent.insert(sent.end(), values.begin(), values.end());
        }
        firstSent = FirstOf(lengths);
        coming.resize(lengths.size());
      });
    MPI_Alltoall(lengths.data(), 1, MPI_INT, coming.data(), 1, MPI_INT, this->Communicator);
    std::vector<int> firstComing;
    std::vector<T> received;
    std::vector<std::vector<T>> from;
    this->Together(
      [&]
      {
        firstComing = FirstOf(coming);
        received.resize(static_cast<std::size_t>(firstComing.back()));
        for (const int length : coming)
        {
          from.emplace_back(static_cast<std::size_t>(length));
        }
      });
    const TypeOf<T> type;
    MPI_Alltoallv(sent.data(), lengths.data(), firstSent.data(), type.Handle, received.data(),
      coming.data(), firstComing.data(), type.Handle, this->Communicator);
    for (std::size_t p = 0; p < coming.size(); ++p)
    {
      std::copy_n(received.begin() + firstComing[p], coming[p], from[p].begin());
    }
    return from;
  }

  /// Adds up the values of all processes, entry by entry.
  void Sum(double* values, int count) const
  {
    MPI_Allreduce(MPI_IN_PLACE, values, count, MPI_DOUBLE, MPI_SUM, this->Communicator);
  }
  double Sum(double value) const
  {
    this->Sum(&value, 1);
    return value;
  }
  /// Finds the largest value of all processes, entry by entry.
  void Largest(double* values, int count) const
  {
    MPI_Allreduce(MPI_IN_PLACE, values, count, MPI_DOUBLE, MPI_MAX, this->Communicator);
  }
  double Largest(double value) const
  {
    this->Largest(&value, 1);
    return value;
  }
  bool Any(bool value) const
  {
    int any = value ? 1 : 0;
    MPI_Allreduce(MPI_IN_PLACE, &any, 1, MPI_INT, MPI_MAX, this->Communicator);
    return any != 0;
  }

  static std::vector<int> FirstOf(const std::vector<int>& lengths)
  {
    std::vector<int> first(1, 0);
    for (const int length : lengths)
    {
      first.push_back(first.back() + length);
    }
    return first;
  }

private:
  /// Values travel as bytes, counted by the value.
  template <typename T>
  struct TypeOf
  {
    static_assert(std::is_trivially_copyable_v<T>);
    TypeOf()
    {
      MPI_Type_contiguous(static_cast<int>(sizeof(T)), MPI_BYTE, &this->Handle);
      MPI_Type_commit(&this->Handle);
    }
    ~TypeOf() { MPI_Type_free(&this->Handle); }
    TypeOf(const TypeOf&) = delete;
    TypeOf& operator=(const TypeOf&) = delete;

    MPI_Datatype Handle = MPI_DATATYPE_NULL;
  };

  MPI_Comm Communicator;
  int Rank = 0;
  int Size = 1;
};
}

#endif
