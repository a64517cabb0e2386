// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef Messages_h
#define Messages_h

#include <mpi.h>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace DirectionFields::Parallel
{
/// Messages between all processes, for values of fixed size. All processes call each function in
/// the same order. A message to one process, and all messages that a process receives together,
/// have less than 2^31 values.
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
    std::vector<int> lengths(static_cast<std::size_t>(this->Size));
    MPI_Allgather(&length, 1, MPI_INT, lengths.data(), 1, MPI_INT, this->Communicator);
    Collected<T> all;
    all.First = FirstOf(lengths);
    all.Values.resize(static_cast<std::size_t>(all.First.back()));
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
    std::vector<T> sent;
    for (const std::vector<T>& values : to)
    {
      lengths.push_back(static_cast<int>(values.size()));
      sent.insert(sent.end(), values.begin(), values.end());
    }
    std::vector<int> coming(lengths.size());
    MPI_Alltoall(lengths.data(), 1, MPI_INT, coming.data(), 1, MPI_INT, this->Communicator);
    const std::vector<int> firstSent = FirstOf(lengths);
    const std::vector<int> firstComing = FirstOf(coming);
    std::vector<T> received(static_cast<std::size_t>(firstComing.back()));
    const TypeOf<T> type;
    MPI_Alltoallv(sent.data(), lengths.data(), firstSent.data(), type.Handle, received.data(),
      coming.data(), firstComing.data(), type.Handle, this->Communicator);
    std::vector<std::vector<T>> from;
    for (std::size_t p = 0; p < coming.size(); ++p)
    {
      from.emplace_back(received.begin() + firstComing[p], received.begin() + firstComing[p + 1]);
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
