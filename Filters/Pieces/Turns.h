// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef Turns_h
#define Turns_h

#include <vector>

namespace DirectionFields::Parallel
{
/// Says when each of several tasks, which some processes do together, has its turn, so that those
/// without common processes are done at once. Each process does its tasks by their turns and waits
/// for nobody else, hence none waits for ever. Where each task has processes that follow each
/// other, as where a surface is cut into slabs, there are as few turns as the busiest process has
/// tasks.
/// @param members the processes of each task, in ascending order
/// @return the turn of each task, from 0 on: tasks of one turn have no process in common
std::vector<int> TurnsOf(const std::vector<std::vector<int>>& members);
}

#endif
