// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_MeshError_h
#define DirectionFields_MeshError_h

#include "Types.h"

#include <stdexcept>
#include <string>

namespace DirectionFields
{
/// A surface that cannot be processed. what() names the cause and the remedy in sentences for the
/// user; ids in it are point ids of the surface given.
class MeshError : public std::runtime_error
{
public:
  enum class Kind
  {
    /// A triangle refers to a point that does not exist.
    InvalidPointId,
    /// A coordinate of a used point is NaN, infinite or too large to be computed with. Id: the
    /// first such point.
    NonFinitePoint
  };

  MeshError(Kind kind, Index id, const std::string& what)
    : std::runtime_error(what)
    , Cause(kind)
    , Point(id)
  {
  }

  Kind GetKind() const { return this->Cause; }
  /// The first offending point.
  Index GetId() const { return this->Point; }

private:
  Kind Cause;
  Index Point;
};
}

#endif
