// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Components/ProcessGroups.h"

#include "Turns.h"

#include <algorithm>
#include <cstddef>

namespace DirectionFields::Parallel
{
ProcessGroups::ProcessGroups(
  const Messages& messages, const DistributedMesh& mesh, const std::vector<int>& components)
{
  std::vector<int> own;
  for (std::size_t k = 0; k < components.size(); ++k)
  {
    if (!mesh.PartsOf(components[k]).empty())
    {
      own.push_back(static_cast<int>(k));
    }
  }
  const Messages::Collected<int> all = messages.AllGather(own);
  std::vector<std::vector<int>> members(components.size());
  for (int p = 0; p < messages.Count(); ++p)
  {
    for (int k = all.First[p]; k < all.First[p + 1]; ++k)
    {
      members[all.Values[k]].push_back(p);
    }
  }
  const std::vector<int> turns = TurnsOf(members);
  const int last = turns.empty() ? -1 : *std::max_element(turns.begin(), turns.end());
  for (int turn = 0; turn <= last; ++turn)
  {
    const auto mine = std::find_if(own.begin(), own.end(), [&](int k) { return turns[k] == turn; });
    MPI_Comm communicator = MPI_COMM_NULL;
    MPI_Comm_split(messages.GetCommunicator(), mine == own.end() ? MPI_UNDEFINED : *mine,
      messages.Own(), &communicator);
    if (mine != own.end())
    {
      this->OwnGroups.push_back({ components[*mine], members[*mine], communicator });
    }
  }
}

ProcessGroups::~ProcessGroups()
{
  for (Group& group : this->OwnGroups)
  {
    MPI_Comm_free(&group.Communicator);
  }
}
}
