// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef MemoryBandwidth_h
#define MemoryBandwidth_h

/// Bytes a second that a = b + s c moves, over arrays far larger than any cache: 24 a value, as
/// STREAM counts (J. McCalpin, 1995). The best of several passes.
/// @param threads 0 for the default number of DirectionFields::Threads
double MemoryBandwidth(int threads);

#endif
