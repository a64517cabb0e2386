// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_TreeCotree_h
#define DirectionFields_TreeCotree_h

#include "TrivialConnection/ConstrainedSets.h"
#include "TrivialConnection/DiscreteForms.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Integers along edges.
using IntegerForm = std::vector<int>;

/// Trees of the triangles of a component, joined across edges that are not fixed: along which
/// indices move from one triangle to another. The regions that fixed edges part have a tree each. A
/// region that reaches a boundary that is not fixed is open: its trees begin outside, and indices
/// may come and go there.
///
/// Edges that are in no tree and close a loop with others outside of it are generators: one for
/// each class of loops in the region along which the field may turn more often without any other
/// singularities (tree and cotree, D. Eppstein, Dynamic generators of topologically embedded
/// graphs, 2003).
class TreeCotree
{
public:
  /// @param forms, constrained of the component
  TreeCotree(const DiscreteForms& forms, const ConstrainedSets& constrained);

  Index GetNumberOfRegions() const { return static_cast<Index>(this->Open.size()); }
  /// Of a triangle of the component, counted from its first one.
  Index GetRegion(Index localTriangle) const { return this->Region[localTriangle]; }
  bool IsOpen(Index region) const { return this->Open[region] != 0; }

  /// Integers of the edges whose sum around each triangle is the number given. Numbers of a region
  /// that is not open must add up to 0.
  IntegerForm Route(std::vector<int> around) const;

  /// Edges of the component.
  const std::vector<Index>& GetGenerators() const { return this->Generators; }
  /// The edges of a generator's form, whose sum around each triangle is 0, and their integers.
  struct Term
  {
    Index Edge;
    int Value;
  };
  std::vector<Term> FormOf(std::size_t generator) const;
  /// The edges of the loop of vertices that a generator's edge closes through edges that no tree
  /// crosses: that edge, from its tail to its head, and the path back.
  std::vector<Index> LoopOf(std::size_t generator) const;

private:
  void GrowTrees(const ConstrainedSets& constrained);
  void FindGenerators(const ConstrainedSets& constrained);
  void AddPath(Index localTriangle, int value, std::vector<Term>& terms) const;

  const DiscreteForms& Forms;
  /// The triangles from the roots on; the half-edge of each that leads towards its root, None for a
  /// root.
  std::vector<Index> Order;
  std::vector<Index> ToRoot;
  std::vector<Index> Region;
  std::vector<char> Open;
  std::vector<Index> Generators;
  /// The edge of each vertex that leads to the root of the tree of vertices, and how far that is;
  /// only where there are generators.
  std::vector<Index> Up;
  std::vector<Index> Depth;
};
}

#endif
