// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef CoverSymmetry_h
#define CoverSymmetry_h

#include "Mesh/DistributedMesh.h"
#include "Mesh/Messages.h"

#include <vector>

namespace DirectionFields::Parallel
{
/// The symmetric sections over a cover whose sides lie across processes (see DoubleCover of Fields,
/// which has the mathematics). A process that owns a vertex owns the one behind it.
class CoverSymmetry
{
public:
  CoverSymmetry(const DistributedMesh& mesh, int component, int degree);

  /// Turns a section by that phase, of at most a quarter turn, which makes it as symmetric as can
  /// be, and symmetrizes it. All processes call it.
  /// @param section over the vertices of the mesh; the owned ones of the component are read and
  ///                written
  void MakeSymmetric(const Messages& messages, std::vector<Complex>& section) const;

  /// The mean of a section and its mirror image, the same on both sides to the last bit.
  void Symmetrize(std::vector<Complex>& section) const;

private:
  /// An owned vertex, that behind it, and what turns the conjugate of a value at either into the
  /// value at the other one.
  struct Pair
  {
    Index Front;
    Index Back;
    Complex Turn;
  };
  std::vector<Pair> Pairs;
};
}

#endif
