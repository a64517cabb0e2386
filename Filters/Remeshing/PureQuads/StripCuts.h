// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_StripCuts_h
#define DirectionFields_StripCuts_h

#include "FaceMesh/FaceEdits.h"
#include "FaceMesh/MovableFaces.h"
#include "PureQuads/FaceStrip.h"

#include <vector>

namespace DirectionFields::Internal
{
/// The ways to make quads of two triangles and the quads of the strip between them. All are shared.
class StripCuts
{
public:
  StripCuts(VertexStars& faces, const MovableFaces& places, FaceEdits& edits)
    : Cells(faces)
    , Places(places)
    , Edits(edits)
  {
  }

  /// Chords of a strip that cut it into quads. Or, where two triangles share an edge, the end of
  /// that edge that is merged with the other one.
  struct Cut
  {
    std::vector<FaceStrip::Chord> Chords;
    /// By how much the irregularity grows.
    int Grown = 0;
    Index Goes = None;
    Index Stays = None;
  };

  /// The cuts of a strip, those that make irregularity grow least first.
  std::vector<Cut> Find(const FaceStrip& strip) const;
  /// Replaces the faces of a strip by quads; returns false if the mesh would not stay manifold, and
  /// leaves it for UndoTo then.
  bool Do(const std::vector<Index>& path, const FaceStrip& strip, const Cut& cut);

private:
  int Growth(const FaceStrip& strip, const std::vector<FaceStrip::Chord>& chords) const;
  bool TakeOutDoublets(const FaceStrip& strip);

  VertexStars& Cells;
  const MovableFaces& Places;
  FaceEdits& Edits;
};
}

#endif
