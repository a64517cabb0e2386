// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef ProcessGroups_h
#define ProcessGroups_h

#include "Mesh/DistributedMesh.h"
#include "Mesh/Messages.h"

#include <mpi.h>

#include <vector>

namespace DirectionFields::Parallel
{
/// The processes that have parts of each component that lies across processes. Only these solve for
/// it, so that components without common processes are solved for at once.
class ProcessGroups
{
public:
  struct Group
  {
    int Component = 0;
    /// In ascending order; their messages count them from 0 on.
    std::vector<int> Members;
    MPI_Comm Communicator = MPI_COMM_NULL;
  };

  /// All processes call it.
  /// @param components of the whole surface, which lie across processes
  ProcessGroups(
    const Messages& messages, const DistributedMesh& mesh, const std::vector<int>& components);
  ~ProcessGroups();
  ProcessGroups(const ProcessGroups&) = delete;
  ProcessGroups& operator=(const ProcessGroups&) = delete;

  /// The groups of this process: where each process works for its groups in this order, none waits
  /// for ever.
  const std::vector<Group>& Own() const { return this->OwnGroups; }

private:
  std::vector<Group> OwnGroups;
};
}

#endif
