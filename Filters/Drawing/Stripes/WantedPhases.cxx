// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Stripes/WantedPhases.h"

#include "Sections/DoubleCover.h"
#include "Support/Threads.h"
#include "Support/VectorMath.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace DirectionFields::Internal
{
namespace
{
/// Sets of nodes whose signs depend on each other.
class SignedSets
{
public:
  explicit SignedSets(Index count)
    : Parent(count)
    , Opposite(count, 0)
  {
    for (Index k = 0; k < count; ++k)
    {
      this->Parent[k] = k;
    }
  }

  /// The least member of the set of a number, and whether it has the opposite sign.
  std::pair<Index, bool> Find(Index k)
  {
    bool opposite = false;
    while (this->Parent[k] != k)
    {
      const Index parent = this->Parent[k];
      // The way is halved, so that it stays short.
      this->Opposite[k] ^= this->Opposite[parent];
      this->Parent[k] = this->Parent[parent];
      opposite ^= this->Opposite[k] != 0;
      k = this->Parent[k];
    }
    return { k, opposite };
  }

  /// False where that contradicts the signs so far.
  bool Join(Index a, Index b, bool opposite)
  {
    const auto [rootA, oppositeA] = this->Find(a);
    const auto [rootB, oppositeB] = this->Find(b);
    const bool between = opposite != (oppositeA != oppositeB);
    if (rootA == rootB)
    {
      return !between;
    }
    const Index child = std::max(rootA, rootB);
    this->Parent[child] = std::min(rootA, rootB);
    this->Opposite[child] = between ? 1 : 0;
    return true;
  }

private:
  LargeArray<Index> Parent;
  std::vector<char> Opposite;
};
}

WantedPhases::WantedPhases(const GivenField& field, StripeDirection direction,
  const std::function<double(Index point)>& frequency)
  : Field(field)
{
  if (field.GetDegree() != 1 && field.GetDegree() != 2)
  {
    throw std::invalid_argument(
      "Stripes run along vector fields and line fields, of degree 1 and 2; this "
      "field has degree " +
      std::to_string(field.GetDegree()) +
      ". Set Directions Per Point (Degree) of Direction Field to 2; for a grid of lines along "
      "both directions of a cross field use "
      "Field Aligned Remesh.");
  }
  this->SetAngles(direction);
  this->JoinSides();
  this->SetSteps(frequency);
  for (Component& component : this->Components)
  {
    this->ChooseSigns(component);
  }
}

void WantedPhases::SetAngles(StripeDirection direction)
{
  const std::vector<Complex>& section = this->Field.GetSection();
  const auto vertices = static_cast<Index>(section.size());
  this->Angle.resize(vertices);
  const double turn = direction == StripeDirection::Along ? 0.5 * Pi : 0.0;
  ParallelFor(vertices, MediumPiece,
    [&](Index begin, Index end)
    {
      Arguments(section.data() + begin, end - begin, this->Angle.data() + begin);
      for (Index v = begin; v < end; ++v)
      {
        this->Angle[v] = this->Angle[v] / this->Field.GetDegree() + turn;
      }
    });
  this->Sign.assign(vertices, 1);
}

void WantedPhases::JoinSides()
{
  const TriangleMesh& mesh = this->GetMesh();
  const std::vector<TriangleMesh::Component>& components = mesh.GetComponents();
  const bool hasCovers =
    std::any_of(components.begin(), components.end(), [](const auto& c) { return c.IsCover; });
  this->Nodes.resize(hasCovers ? mesh.GetNumberOfVertices() : 0);
  this->Vertices.resize(mesh.GetNumberOfVertices());
  Index node = 0;
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    const TriangleMesh::Component& component = components[c];
    this->Components.push_back({ node, node, static_cast<Index>(c), false });
    for (Index v = component.FirstVertex; v < component.EndVertex; ++v)
    {
      if (mesh.IsFrontVertex(v))
      {
        if (hasCovers)
        {
          this->Nodes[v] = node;
        }
        this->Vertices[node++] = v;
      }
    }
    this->Components.back().EndNode = node;
    if (!component.IsCover)
    {
      continue;
    }
    // The other side of a point sees the same vector or the opposite one.
    const DoubleCover cover(this->Field.GetGeometry(), component, 1);
    for (Index v = component.FirstVertex; v < component.EndVertex; ++v)
    {
      if (!mesh.IsFrontVertex(v))
      {
        const Index front = mesh.MirrorVertex(v);
        this->Nodes[v] = this->Nodes[front];
        const Complex seen = cover.Mirrored(front, std::polar(1.0, this->Angle[front]));
        this->Sign[v] = (std::conj(seen) * std::polar(1.0, this->Angle[v])).real() < 0.0 ? -1 : 1;
      }
    }
  }
  this->Vertices.resize(node);
}

WantedPhases::EdgeUse WantedPhases::Use(Index h) const
{
  const TriangleMesh& mesh = this->GetMesh();
  const Index direct = mesh.HalfEdge(mesh.Edge(h));
  const Index mirror = mesh.Mirror(h);
  if (mirror != None && mesh.Edge(mirror) < mesh.Edge(h))
  {
    const Index other = mesh.HalfEdge(mesh.Edge(mirror));
    return { other, other != mirror };
  }
  return { direct, direct == h };
}

void WantedPhases::SetSteps(const std::function<double(Index point)>& frequency)
{
  const SurfaceGeometry& geometry = this->Field.GetGeometry();
  const TriangleMesh& mesh = geometry.Mesh;
  const bool isLineField = this->Field.GetDegree() == 2;
  this->Increments.resize(mesh.GetNumberOfEdges());
  this->Flips.assign(mesh.GetNumberOfEdges(), 0);
  const auto frequencyAt = [&](Index v)
  { return this->Field.GetSection()[v] == 0.0 ? 0.0 : frequency(mesh.Point(v)); };
  for (const Component& part : this->Components)
  {
    const TriangleMesh::Component& component = mesh.GetComponents()[part.Number];
    const double unit = geometry.Lengths.Unit[part.Number];
    ParallelFor(component.Edges(), MediumPiece,
      [&](Index begin, Index end)
      {
        for (Index e = component.FirstEdge + begin; e < component.FirstEdge + end; ++e)
        {
          const Index h = mesh.HalfEdge(e);
          const Index i = mesh.Tail(h);
          const Index j = mesh.Head(h);
          const double rotation = geometry.Transport.Rotation[e];
          const bool opposite =
            isLineField && std::cos(this->Angle[j] - this->Angle[i] - rotation) < 0.0;
          const double along = geometry.Transport.EdgeAngle[h];
          const double atTail = frequencyAt(i) * std::cos(this->Angle[i] - along);
          const double atHead = frequencyAt(j) * std::cos(this->Angle[j] - along - rotation);
          const double length = unit * std::sqrt(geometry.Lengths.SquaredLength[e]);
          this->Increments[e] =
            0.5 * length * this->Sign[i] * (opposite ? atTail - atHead : atTail + atHead);
          this->Flips[e] = opposite != (this->Sign[i] != this->Sign[j]) ? 1 : 0;
        }
      });
  }
}

void WantedPhases::ChooseSigns(Component& component)
{
  const TriangleMesh& mesh = this->GetMesh();
  const TriangleMesh::Component& part = mesh.GetComponents()[component.Number];
  const int flips = ParallelSum(part.Edges(), LightPiece, 0,
    [&](Index begin, Index end)
    {
      return static_cast<int>(std::count(this->Flips.begin() + part.FirstEdge + begin,
                                this->Flips.begin() + part.FirstEdge + end, 1) > 0);
    });
  if (flips == 0)
  {
    return;
  }
  SignedSets sets(component.Nodes());
  const auto nodeAt = [&](Index vertex) { return this->Node(vertex) - component.FirstNode; };
  for (Index e = part.FirstEdge; e < part.EndEdge && !component.HasTwoSheets; ++e)
  {
    const Index h = mesh.HalfEdge(e);
    if (this->Use(h).HalfEdge == h)
    {
      component.HasTwoSheets =
        !sets.Join(nodeAt(mesh.Tail(h)), nodeAt(mesh.Head(h)), this->Flips[e] != 0);
    }
  }
  if (component.HasTwoSheets)
  {
    return;
  }
  for (Index v = part.FirstVertex; v < part.EndVertex; ++v)
  {
    this->Sign[v] = sets.Find(nodeAt(v)).second ? -this->Sign[v] : this->Sign[v];
  }
  for (Index e = part.FirstEdge; e < part.EndEdge; ++e)
  {
    if (sets.Find(nodeAt(mesh.Tail(mesh.HalfEdge(e)))).second)
    {
      this->Increments[e] = -this->Increments[e];
    }
    this->Flips[e] = 0;
  }
}

WantedPhases::Turn WantedPhases::Around(Index triangle) const
{
  Turn turn{ 0.0, false };
  for (int c = 0; c < 3; ++c)
  {
    const Step step = this->Along(3 * triangle + c);
    turn.Sum += turn.Flips ? -step.Increment : step.Increment;
    turn.Flips = turn.Flips != step.Flips;
  }
  return turn;
}

Vector3 WantedPhases::Gradient(Index node) const
{
  const Index v = this->Vertices[node];
  const TangentFrames& frames = this->Field.GetGeometry().Frames;
  return this->Sign[v] *
    (std::cos(this->Angle[v]) * frames.X[v] + std::sin(this->Angle[v]) * frames.Y(v));
}
}
