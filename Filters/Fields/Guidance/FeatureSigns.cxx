// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Guidance/FeatureSigns.h"

#include "Sections/DoubleCover.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// Agreements that differ by less than this are ties, which the numbers of points decide: rounding
/// in another coordinate frame must not.
constexpr double Tie = 1e-6;
/// Neighbours agree or disagree clearly from here on: corners, where a chain turns, are decided by
/// the surface between the chains.
constexpr double Clear = 0.5;

/// Vertices whose signs are known relative to each other.
class SignedSets
{
public:
  explicit SignedSets(std::size_t vertices)
    : Parent(vertices, None)
    , Turned(vertices, 0)
  {
  }

  /// The vertex that stands for a set, and whether the sign of v is opposite to its.
  std::pair<Index, bool> Find(Index v)
  {
    bool turned = false;
    while (this->Parent[v] != None)
    {
      const Index next = this->Parent[v];
      if (this->Parent[next] != None)
      {
        // Halves the path for the next call.
        this->Turned[v] ^= this->Turned[next];
        this->Parent[v] = this->Parent[next];
      }
      turned = turned != (this->Turned[v] != 0);
      v = this->Parent[v];
    }
    return { v, turned };
  }

  /// Makes one set of two, unless they are.
  void Unite(Index a, Index b, bool opposite)
  {
    const auto [first, turnFirst] = this->Find(a);
    const auto [second, turnSecond] = this->Find(b);
    if (first != second)
    {
      this->Parent[second] = first;
      this->Turned[second] = opposite != (turnFirst != turnSecond) ? 1 : 0;
    }
  }

private:
  std::vector<Index> Parent;
  std::vector<char> Turned;
};

/// Two vertices, and how well their values agree: negative where they are rather opposite.
struct Link
{
  double Agreement;
  Index A, B;
};

class FeatureSigns
{
public:
  FeatureSigns(const SurfaceGeometry& geometry, int degree, const std::vector<ConstraintKind>& kind,
    std::vector<Complex>& value)
    : Geometry(geometry)
    , Mesh(geometry.Mesh)
    , Degree(degree)
    , Kind(kind)
    , Value(value)
    , Sets(kind.size())
  {
  }

  void Choose()
  {
    for (const TriangleMesh::Component& component : this->Mesh.GetComponents())
    {
      this->UniteKnown(component);
      this->UniteNeighbours(component);
      this->UniteApart(component);
    }
    this->Turn();
  }

private:
  bool IsSharp(Index v) const { return this->Kind[v] == ConstraintKind::SharpEdge; }
  bool IsConstrained(Index v) const { return this->Kind[v] != ConstraintKind::None; }

  /// A value brought along a half-edge, or against it where sense is -1.
  Complex Arriving(const Complex& z, Index h, double sense) const
  {
    const double rho = this->Geometry.Transport.RotationAlong(this->Mesh, h);
    return z * std::polar(1.0, this->Degree * (sense * rho));
  }

  /// Calls body(w, z) for each neighbour w of a vertex with the value at w brought to the vertex.
  template <typename Body>
  void ForNeighbours(Index v, const std::vector<Complex>& values, const Body& body) const
  {
    std::vector<Index> fan;
    this->Mesh.GetFan(v, fan);
    for (const Index h : fan)
    {
      body(this->Mesh.Head(h), this->Arriving(values[this->Mesh.Head(h)], h, -1.0));
    }
    if (this->Mesh.IsBoundary(v))
    {
      const Index last = TriangleMesh::Previous(fan.back());
      body(this->Mesh.Tail(last), this->Arriving(values[this->Mesh.Tail(last)], last, 1.0));
    }
  }

  /// Sorts by falling strength; ties by the points.
  void Sort(std::vector<Link>& links) const
  {
    const auto key = [this](const Link& link)
    {
      const auto [low, high] = std::minmax({ this->Mesh.Point(link.A), this->Mesh.Point(link.B) });
      return std::tuple(-std::round(std::abs(link.Agreement) / Tie), low, high, link.A, link.B);
    };
    std::sort(links.begin(), links.end(),
      [&key](const Link& one, const Link& other) { return key(one) < key(other); });
  }

  /// Carries signs along the strongest links first: a spanning forest.
  void Unite(std::vector<Link>&& links)
  {
    this->Sort(links);
    for (const Link& link : links)
    {
      this->Sets.Unite(link.A, link.B, link.Agreement < 0.0);
    }
  }

  /// Signs that are given, and those on the other side of a cover.
  void UniteKnown(const TriangleMesh::Component& component)
  {
    const DoubleCover cover(this->Geometry, component, this->Degree);
    Index given = None;
    for (Index v = component.FirstVertex; v < component.EndVertex; ++v)
    {
      if (this->IsConstrained(v) && !this->IsSharp(v))
      {
        given = given == None ? v : given;
        this->Sets.Unite(given, v, false);
      }
      const Index mirror =
        component.IsCover && this->IsSharp(v) ? this->Mesh.MirrorVertex(v) : None;
      if (mirror != None && this->IsSharp(mirror))
      {
        const Complex seen = cover.Mirrored(v, this->Value[v]);
        this->Sets.Unite(v, mirror, (std::conj(seen) * this->Value[mirror]).real() < 0.0);
      }
    }
  }

  void UniteNeighbours(const TriangleMesh::Component& component)
  {
    std::vector<Link> links;
    for (Index e = component.FirstEdge; e < component.EndEdge; ++e)
    {
      const Index i = this->Mesh.Tail(this->Mesh.HalfEdge(e));
      const Index j = this->Mesh.Head(this->Mesh.HalfEdge(e));
      if (this->IsConstrained(i) && this->IsConstrained(j))
      {
        const Complex arrived = this->Arriving(this->Value[i], this->Mesh.HalfEdge(e), 1.0);
        const double agreement = (std::conj(arrived) * this->Value[j]).real();
        if (std::abs(agreement) >= Clear)
        {
          links.push_back({ agreement, i, j });
        }
      }
    }
    this->Unite(std::move(links));
  }

  /// Sets that are apart grow until they meet.
  void UniteApart(const TriangleMesh::Component& component)
  {
    std::vector<Index> front;
    bool apart = false;
    for (Index v = component.FirstVertex; v < component.EndVertex; ++v)
    {
      if (this->IsConstrained(v))
      {
        front.push_back(v);
        apart = apart || this->Sets.Find(v).first != this->Sets.Find(front.front()).first;
      }
    }
    if (!apart)
    {
      return;
    }
    this->Layer.resize(this->Kind.size(), None);
    this->Source.resize(this->Kind.size(), None);
    this->Grown.resize(this->Kind.size(), 0.0);
    for (const Index v : front)
    {
      const auto [root, turned] = this->Sets.Find(v);
      this->Layer[v] = 0;
      this->Source[v] = root;
      this->Grown[v] = turned ? -this->Value[v] : this->Value[v];
    }
    this->Grow(std::move(front));
    this->Unite(this->Meetings(component));
  }

  /// Each vertex of the next layer belongs to the set from which most arrives.
  void Grow(std::vector<Index>&& front)
  {
    for (Index layer = 1; !front.empty(); ++layer)
    {
      std::vector<Index> next;
      for (const Index v : front)
      {
        this->ForNeighbours(v, this->Grown,
          [&](Index w, const Complex&)
          {
            if (this->Layer[w] == None)
            {
              this->Layer[w] = layer;
              next.push_back(w);
            }
          });
      }
      for (const Index v : next)
      {
        this->Reach(v, layer);
      }
      front = std::move(next);
    }
  }

  void Reach(Index v, Index layer)
  {
    // Few sets meet at a vertex.
    std::vector<std::pair<Index, Complex>> sums;
    this->ForNeighbours(v, this->Grown,
      [&](Index w, const Complex& arrived)
      {
        if (this->Layer[w] != layer - 1)
        {
          return;
        }
        const auto at = std::find_if(
          sums.begin(), sums.end(), [&](const auto& sum) { return sum.first == this->Source[w]; });
        if (at == sums.end())
        {
          sums.emplace_back(this->Source[w], arrived);
        }
        else
        {
          at->second += arrived;
        }
      });
    const auto key = [this](const std::pair<Index, Complex>& sum)
    { return std::pair(-std::round(std::abs(sum.second) / Tie), this->Mesh.Point(sum.first)); };
    const auto best = *std::min_element(sums.begin(), sums.end(),
      [&key](const auto& one, const auto& other) { return key(one) < key(other); });
    const double size = std::abs(best.second);
    this->Source[v] = best.first;
    this->Grown[v] = size > Tie ? best.second / size : Complex(0.0);
  }

  /// How well sets agree where they meet; places far from both count less.
  std::vector<Link> Meetings(const TriangleMesh::Component& component) const
  {
    std::map<std::pair<Index, Index>, double> meetings;
    for (Index e = component.FirstEdge; e < component.EndEdge; ++e)
    {
      const Index i = this->Mesh.Tail(this->Mesh.HalfEdge(e));
      const Index j = this->Mesh.Head(this->Mesh.HalfEdge(e));
      if (this->Source[i] != this->Source[j])
      {
        const Complex arrived = this->Arriving(this->Grown[i], this->Mesh.HalfEdge(e), 1.0);
        meetings[std::minmax({ this->Source[i], this->Source[j] })] +=
          (std::conj(arrived) * this->Grown[j]).real() / (1 + this->Layer[i] + this->Layer[j]);
      }
    }
    std::vector<Link> links;
    for (const auto& [sets, agreement] : meetings)
    {
      links.push_back({ agreement, sets.first, sets.second });
    }
    return links;
  }

  void Turn()
  {
    // The sign that each set has in the end.
    std::vector<char> sign(this->Kind.size(), 0);
    std::vector<Index> lowest(this->Kind.size(), None);
    const auto count = static_cast<Index>(this->Kind.size());
    for (Index v = 0; v < count; ++v)
    {
      if (!this->IsConstrained(v))
      {
        continue;
      }
      const auto [root, turned] = this->Sets.Find(v);
      // Given directions come before those that may be turned.
      const auto rank = [this](Index w)
      { return std::pair(this->IsSharp(w), this->Mesh.Point(w)); };
      if (lowest[root] == None || rank(v) < rank(lowest[root]))
      {
        lowest[root] = v;
        sign[root] = turned;
      }
    }
    for (Index v = 0; v < count; ++v)
    {
      if (this->IsSharp(v))
      {
        const auto [root, turned] = this->Sets.Find(v);
        this->Value[v] = turned != (sign[root] != 0) ? -this->Value[v] : this->Value[v];
      }
    }
  }

  const SurfaceGeometry& Geometry;
  const TriangleMesh& Mesh;
  int Degree;
  const std::vector<ConstraintKind>& Kind;
  std::vector<Complex>& Value;
  SignedSets Sets;
  /// Of the vertices that sets have grown to: how far away these are, the vertex that stands for
  /// the set, and the value that it has here, of modulus 1, or 0 where it cancels.
  std::vector<Index> Layer;
  std::vector<Index> Source;
  std::vector<Complex> Grown;
};
}

void ChooseFeatureSigns(const SurfaceGeometry& geometry, int degree,
  const std::vector<ConstraintKind>& kind, std::vector<Complex>& value)
{
  FeatureSigns(geometry, degree, kind, value).Choose();
}
}
