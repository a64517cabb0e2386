// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_WantedPhases_h
#define DirectionFields_WantedPhases_h

#include "Interpolation/GivenField.h"
#include "Stripes.h"
#include "Support/LargeArray.h"

#include <functional>
#include <vector>

namespace DirectionFields::Internal
{
/// How the phase alpha of a stripe pattern is to change along each edge of a surface (F. Knöppel,
/// K. Crane, U. Pinkall, P. Schröder: Stripe Patterns on Surfaces, ACM TOG 34(4), 2015): by the
/// component along the edge of a vector field of the length of the stripes' frequency, which points
/// across the stripes.
///
/// A node is a point of the surface as it lies in space: a vertex of the mesh, or the two of a
/// double cover that are the two sides of one point. At each node one of the two opposite vectors
/// across the stripes is chosen, and with it the sign of alpha there; where an edge flips, the
/// chosen vectors at its ends are opposite, and alpha goes on as -alpha. All phases are in cycles.
/// Signs are chosen so that no edge of a component flips where that can be.
class WantedPhases
{
public:
  /// A field of degree 1 or 2; throws std::invalid_argument for another one.
  /// @param frequency cycles per length at each point of the surface, finite and at least 0; 0 also
  ///                  holds where the field has no direction
  WantedPhases(const GivenField& field, StripeDirection direction,
    const std::function<double(Index point)>& frequency);

  struct Component
  {
    Index FirstNode, EndNode;
    /// The number of the mesh's component.
    Index Number;
    /// Signs cannot be chosen so that no edge flips: the phases live on two sheets.
    bool HasTwoSheets;
    Index Nodes() const { return this->EndNode - this->FirstNode; }
  };

  /// How alpha is to change along an edge, and whether it is taken for -alpha at its end.
  struct Step
  {
    double Increment;
    bool Flips;
  };

  const GivenField& GetField() const { return this->Field; }
  const TriangleMesh& GetMesh() const { return this->Field.GetMesh(); }
  const std::vector<Component>& GetComponents() const { return this->Components; }
  Index GetNumberOfNodes() const { return static_cast<Index>(this->Vertices.size()); }
  /// The node at a vertex, and the vertex on the front that a node is at.
  Index Node(Index vertex) const { return this->Nodes.empty() ? vertex : this->Nodes[vertex]; }
  Index Vertex(Index node) const { return this->Vertices[node]; }

  /// The half-edge that edges of the surface are counted by, which may run the other way or on the
  /// other side of a cover, and whether it runs the same way in space.
  struct EdgeUse
  {
    Index HalfEdge;
    bool Along;
  };
  EdgeUse Use(Index h) const;
  /// The step along a half-edge from the node at its tail to the node at its head.
  Step Along(Index h) const
  {
    const EdgeUse use = this->Use(h);
    const Index edge = this->GetMesh().Edge(use.HalfEdge);
    const bool flips = this->Flips[edge] != 0;
    const double increment = this->Increments[edge];
    return { use.Along || flips ? increment : -increment, flips };
  }

  /// The sum of the steps around a triangle of the mesh, the flux, and whether an odd number of
  /// them flips.
  struct Turn
  {
    double Sum;
    bool Flips;
  };
  Turn Around(Index triangle) const;

  /// The chosen vector across the stripes at a node as a unit vector in space.
  Vector3 Gradient(Index node) const;

private:
  void SetAngles(StripeDirection direction);
  void JoinSides();
  void SetSteps(const std::function<double(Index point)>& frequency);
  void ChooseSigns(Component& component);

  const GivenField& Field;
  std::vector<Component> Components;
  /// Empty where the mesh has no covers.
  LargeArray<Index> Nodes;
  LargeArray<Index> Vertices;
  /// Of each vertex the angle of a vector across the stripes, and the sign that makes it the chosen
  /// one.
  LargeArray<double> Angle;
  std::vector<signed char> Sign;
  /// Of each edge that Use may name, in the direction of its half-edge.
  LargeArray<double> Increments;
  std::vector<char> Flips;
};
}

#endif
