// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Free_h
#define DirectionFields_Free_h

#include <vector>

namespace DirectionFields::Internal
{
/// Empties a vector and frees its memory, which neither clear nor the assignment of {} does.
template <typename T, typename Allocator>
void Free(std::vector<T, Allocator>& vector)
{
  std::vector<T, Allocator>().swap(vector);
}
}

#endif
