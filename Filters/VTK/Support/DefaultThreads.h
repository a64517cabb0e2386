// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DefaultThreads_h
#define DefaultThreads_h

namespace DirectionFields
{
/// The number of threads where the user sets none: the number of VTK's SMP backend; 0, which leaves
/// the choice to Threads, where the backend has but one and no environment variable says otherwise.
int DefaultThreads();
}

#endif
