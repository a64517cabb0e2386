// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "TrivialConnection/ConstrainedSets.h"

#include "Soup/JoinedSets.h"

#include <algorithm>

namespace DirectionFields::Internal
{
ConstrainedSets::ConstrainedSets(const TriangleMesh& mesh, const TriangleMesh::Component& component,
  const std::vector<char>& isGiven)
  : NumberOfUnknowns(component.Vertices())
{
  const auto first = isGiven.begin() + (isGiven.empty() ? 0 : component.FirstVertex);
  if (isGiven.empty() ||
    std::find(first, first + component.Vertices(), 1) == first + component.Vertices())
  {
    return;
  }
  JoinedSets sets(component.Vertices());
  this->FixedEdge.resize(component.Edges(), 0);
  for (Index e = 0; e < component.Edges(); ++e)
  {
    const Index h = mesh.HalfEdge(component.FirstEdge + e);
    if (isGiven[mesh.Tail(h)] && isGiven[mesh.Head(h)])
    {
      this->FixedEdge[e] = 1;
      sets.Join(mesh.Tail(h) - component.FirstVertex, mesh.Head(h) - component.FirstVertex);
    }
  }
  this->Unknown.resize(component.Vertices());
  this->NumberOfUnknowns = 0;
  for (Index v = 0; v < component.Vertices(); ++v)
  {
    // A set is named by its least member, which has its number already.
    const Index leader = sets.Find(v);
    this->Unknown[v] = leader == v ? this->NumberOfUnknowns++ : this->Unknown[leader];
    if (leader == v && isGiven[component.FirstVertex + v])
    {
      this->GivenUnknowns.push_back(this->Unknown[v]);
    }
  }
}
}
