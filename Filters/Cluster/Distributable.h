// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef Distributable_h
#define Distributable_h

#include <DirectionFields/Options.h>

#include <string>

namespace DirectionFields::Parallel
{
/// Why options can only be had of a gathered surface, as a part of a sentence; empty where they can
/// be had of its pieces.
std::string WhyNotDistributed(const Options& options);
}

#endif
