// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FieldToResult_h
#define DirectionFields_FieldToResult_h

#include "Field/ComponentFields.h"

#include <string>
#include <vector>

namespace DirectionFields::Internal
{
/// The field and its figures as the caller gets them: over the points and triangles of the input.
/// @param notes the sentences for the user
Result ToResult(Stages& stages, const Options& options, const Guide& guide, ComponentFields fields,
  std::vector<std::string> notes);
}

#endif
