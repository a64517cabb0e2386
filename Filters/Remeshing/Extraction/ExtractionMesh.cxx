// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Extraction/ExtractionMesh.h"

#include <algorithm>

namespace DirectionFields::Internal
{
ExtractionMesh::ExtractionMesh(const CutMesh& mesh, const IntegerGridMap& map)
  : Plane(mesh.Degree)
  , Corners(3 * mesh.Triangles.size())
  , Twins(3 * mesh.Triangles.size())
  , Places(map.GetCorners())
  , Acrosses(map.GetAcross())
  , Features(3 * mesh.Triangles.size())
  , Outgoings(mesh.Positions.size(), None)
  , Positions(mesh.Positions)
  , Roles(mesh.Positions.size())
{
  for (Index h = 0; h < static_cast<Index>(this->Corners.size()); ++h)
  {
    const CutMesh::MapTriangle& t = mesh.Triangles[h / 3];
    this->Corners[h] = t.Vertex[h % 3];
    this->Twins[h] = t.Twin[h % 3];
    this->Features[h] = t.Feature[h % 3];
    this->Outgoings[t.Vertex[h % 3]] = h;
  }
  for (const CutMesh::Cone& cone : mesh.Cones)
  {
    Role& role = this->Roles[cone.Vertex];
    role.IsCorner = mesh.IsCorner[cone.Vertex] != 0;
    role.IsCone = cone.Holonomy.Turn != 0;
    role.IsKept = role.IsCone || role.IsCorner;
  }
  for (std::size_t v = 0; v < this->Roles.size(); ++v)
  {
    if (mesh.IsChainEnd[v] != 0)
    {
      this->Roles[v].IsCorner = this->Roles[v].IsKept = true;
    }
  }
}

bool ExtractionMesh::GetStar(Index v, std::vector<Index>& star) const
{
  star.clear();
  const Index any = this->Outgoings[v];
  Index first = any;
  while (this->Twins[first] != None)
  {
    first = Next(this->Twins[first]);
    if (first == any)
    {
      break;
    }
  }
  const bool isBoundary = this->Twins[first] == None;
  Index h = first;
  do
  {
    star.push_back(h);
    h = this->Twins[Previous(h)];
  } while (h != None && h != first);
  return isBoundary;
}

bool ExtractionMesh::IsBoundary(Index v) const
{
  const Index any = this->Outgoings[v];
  Index h = any;
  do
  {
    if (this->Twins[h] == None)
    {
      return true;
    }
    h = Next(this->Twins[h]);
  } while (h != any);
  return false;
}

bool ExtractionMesh::AreJoined(Index v, Index w) const
{
  std::vector<Index> star;
  this->GetStar(v, star);
  return std::any_of(star.begin(), star.end(),
    [&](Index h) { return this->Head(h) == w || this->Tail(Previous(h)) == w; });
}

void ExtractionMesh::LayOut(Index v, Layout& layout) const
{
  layout.IsOpen = this->GetStar(v, layout.Star);
  layout.Ring.clear();
  layout.Places.clear();
  layout.Charts.clear();
  layout.Positive = 0;
  Transition chart;
  for (std::size_t i = 0; i < layout.Star.size(); ++i)
  {
    const Index h = layout.Star[i];
    if (i > 0)
    {
      chart = this->Plane.Composed(chart, this->Acrosses[Previous(layout.Star[i - 1])]);
    }
    layout.Charts.push_back(chart);
    layout.Ring.push_back(this->Head(h));
    layout.Places.push_back(this->Plane.Apply(chart, this->Places[Next(h)]));
    layout.Positive += this->IsPositive(h / 3) ? 1 : 0;
  }
  const Index last = Previous(layout.Star.back());
  if (layout.IsOpen)
  {
    layout.Ring.push_back(this->Tail(last));
    layout.Places.push_back(this->Plane.Apply(chart, this->Places[last]));
    layout.IsFlat = true;
  }
  else
  {
    layout.IsFlat = this->Plane.Composed(chart, this->Acrosses[last]) == Transition{};
  }
}

void ExtractionMesh::Link(Index h, Index twin, const Transition& across)
{
  this->Twins[h] = twin;
  this->Acrosses[h] = across;
  if (twin != None)
  {
    this->Twins[twin] = h;
    this->Acrosses[twin] = this->Plane.Inverse(across);
  }
}

void ExtractionMesh::Flip(Index h)
{
  const Index g = this->Twins[h];
  const Transition across = this->Acrosses[h];
  const Index nh = Next(h);
  const Index ph = Previous(h);
  const Index ng = Next(g);
  const Index pg = Previous(g);
  // h: a -> b with c opposite, d beyond; everything in the chart of h.
  const Index a = this->Corners[h];
  const Index b = this->Corners[nh];
  const Index c = this->Corners[ph];
  const Index d = this->Corners[pg];
  const GridPoint placeA = this->Places[h];
  const GridPoint placeB = this->Places[nh];
  const GridPoint placeC = this->Places[ph];
  const GridPoint placeD = this->Plane.Apply(across, this->Places[pg]);
  struct Side
  {
    Index Twin;
    Transition Across;
    Index Feature;
  };
  const Side bc{ this->Twins[nh], this->Acrosses[nh], this->Features[nh] };
  const Side ca{ this->Twins[ph], this->Acrosses[ph], this->Features[ph] };
  const Side ad{ this->Twins[ng], this->Plane.Composed(across, this->Acrosses[ng]),
    this->Features[ng] };
  const Side db{ this->Twins[pg], this->Plane.Composed(across, this->Acrosses[pg]),
    this->Features[pg] };
  const auto set = [&](Index edge, Index vertex, const GridPoint& place)
  {
    this->Corners[edge] = vertex;
    this->Places[edge] = place;
    this->Outgoings[vertex] = edge;
  };
  // h: d -> c, then c -> a, a -> d; g: c -> d, then d -> b, b -> c.
  set(h, d, placeD);
  set(nh, c, placeC);
  set(ph, a, placeA);
  set(g, c, placeC);
  set(ng, d, placeD);
  set(pg, b, placeB);
  const auto link = [&](Index edge, const Side& side)
  {
    this->Link(edge, side.Twin, side.Across);
    this->Features[edge] = side.Feature;
  };
  link(nh, ca);
  link(ph, ad);
  link(ng, db);
  link(pg, bc);
  this->Link(h, g, {});
  this->Features[h] = this->Features[g] = 0;
}

Index ExtractionMesh::AddTriangle()
{
  const auto t = static_cast<Index>(this->Corners.size() / 3);
  this->Corners.resize(this->Corners.size() + 3, None);
  this->Twins.resize(this->Corners.size(), None);
  this->Places.resize(this->Corners.size());
  this->Acrosses.resize(this->Corners.size());
  this->Features.resize(this->Corners.size(), 0);
  return t;
}

Index ExtractionMesh::SplitTriangle(Index t, GridPoint place, const Vector3& position)
{
  const auto v = static_cast<Index>(this->Positions.size());
  this->Positions.push_back(position);
  this->Roles.emplace_back();
  this->Outgoings.push_back(None);
  const std::array<Index, 3> number = { t, this->AddTriangle(), this->AddTriangle() };
  const Triangle corners = { this->Corners[3 * t], this->Corners[3 * t + 1],
    this->Corners[3 * t + 2] };
  const std::array<GridPoint, 3> places = { this->Places[3 * t], this->Places[3 * t + 1],
    this->Places[3 * t + 2] };
  const std::array<Index, 3> twins = { this->Twins[3 * t], this->Twins[3 * t + 1],
    this->Twins[3 * t + 2] };
  const std::array<Transition, 3> across = { this->Acrosses[3 * t], this->Acrosses[3 * t + 1],
    this->Acrosses[3 * t + 2] };
  const std::array<Index, 3> features = { this->Features[3 * t], this->Features[3 * t + 1],
    this->Features[3 * t + 2] };
  for (int c = 0; c < 3; ++c)
  {
    const Index h = 3 * number[c];
    const int next = (c + 1) % 3;
    this->Corners[h] = corners[c];
    this->Corners[h + 1] = corners[next];
    this->Corners[h + 2] = v;
    this->Places[h] = places[c];
    this->Places[h + 1] = places[next];
    this->Places[h + 2] = place;
    this->Features[h] = features[c];
    this->Features[h + 1] = this->Features[h + 2] = 0;
    this->Outgoings[corners[c]] = h;
    this->Outgoings[v] = h + 2;
    this->Link(h, twins[c], across[c]);
  }
  for (int c = 0; c < 3; ++c)
  {
    this->Link(3 * number[c] + 1, 3 * number[(c + 1) % 3] + 2, {});
  }
  return v;
}

Index ExtractionMesh::SplitEdge(Index h, GridPoint place, const Vector3& position)
{
  const auto v = static_cast<Index>(this->Positions.size());
  this->Positions.push_back(position);
  this->Roles.emplace_back();
  this->Outgoings.push_back(None);
  const Index g = this->Twins[h];
  const Transition across = this->Acrosses[h];
  const Index feature = this->Features[h];
  // Of (a, b, c) with h: a -> b comes (a, v, c) and the new (v, b, c).
  const auto split = [&](Index edge, const GridPoint& at)
  {
    const Index t = this->AddTriangle();
    const Index next = Next(edge);
    const Index previous = Previous(edge);
    const std::array<Index, 3> fresh = { 3 * t, 3 * t + 1, 3 * t + 2 };
    this->Corners[fresh[0]] = v;
    this->Corners[fresh[1]] = this->Corners[next];
    this->Corners[fresh[2]] = this->Corners[previous];
    this->Places[fresh[0]] = at;
    this->Places[fresh[1]] = this->Places[next];
    this->Places[fresh[2]] = this->Places[previous];
    this->Features[fresh[0]] = this->Features[edge];
    this->Features[fresh[1]] = this->Features[next];
    this->Link(fresh[1], this->Twins[next], this->Acrosses[next]);
    this->Outgoings[this->Corners[fresh[1]]] = fresh[1];
    this->Outgoings[this->Corners[fresh[2]]] = fresh[2];
    this->Corners[next] = v;
    this->Places[next] = at;
    this->Features[next] = 0;
    this->Link(next, fresh[2], {});
    this->Outgoings[v] = next;
    return fresh[0];
  };
  const Index second = split(h, place);
  this->Outgoings[this->Corners[h]] = h;
  if (g == None)
  {
    this->Link(h, None, {});
    this->Link(second, None, {});
  }
  else
  {
    const Index beyond = split(g, this->Plane.Apply(this->Plane.Inverse(across), place));
    this->Outgoings[this->Corners[g]] = g;
    this->Link(h, beyond, across);
    this->Link(second, g, across);
  }
  this->Features[h] = this->Features[second] = feature;
  return v;
}

void ExtractionMesh::RemoveVertex(Index v, const Layout& layout,
  const std::vector<Triangle>& triangles, std::array<Index, 2> ends, Index feature,
  std::vector<Index>& changed)
{
  const auto count = static_cast<Index>(layout.Ring.size());
  const auto edges = static_cast<Index>(layout.Star.size());
  std::vector<RingSide> sides;
  for (Index i = 0; i < edges; ++i)
  {
    const Index outer = Next(layout.Star[i]);
    sides.push_back({ this->Twins[outer],
      this->Plane.Composed(layout.Charts[i], this->Acrosses[outer]), this->Features[outer] });
  }
  const auto isFeature = [&](Index a, Index b)
  { return (a == ends[0] && b == ends[1]) || (a == ends[1] && b == ends[0]); };
  for (const Index h : layout.Star)
  {
    const Index t = h / 3;
    this->Corners[3 * t] = this->Corners[3 * t + 1] = this->Corners[3 * t + 2] = None;
  }
  this->Outgoings[v] = None;
  std::vector<std::pair<std::array<Index, 2>, Index>> open;
  for (std::size_t k = 0; k < triangles.size(); ++k)
  {
    const Index t = layout.Star[k] / 3;
    for (int c = 0; c < 3; ++c)
    {
      const Index h = 3 * t + c;
      const Index i = triangles[k][c];
      const Index j = triangles[k][(c + 1) % 3];
      this->Corners[h] = layout.Ring[i];
      this->Places[h] = layout.Places[i];
      this->Outgoings[layout.Ring[i]] = h;
      this->Features[h] = isFeature(i, j) ? feature : 0;
      changed.push_back(h);
      if (j == (i + 1) % count && i < edges)
      {
        this->Link(h, sides[i].Twin, sides[i].Across);
        this->Features[h] = std::max(this->Features[h], sides[i].Feature);
        if (sides[i].Twin != None)
        {
          this->Features[sides[i].Twin] = this->Features[h];
        }
      }
      else if (layout.IsOpen && i == count - 1 && j == 0)
      {
        this->Link(h, None, {});
        this->Features[h] = feature;
      }
      else
      {
        const std::array<Index, 2> wanted = { j, i };
        const auto other = std::find_if(
          open.begin(), open.end(), [&](const auto& entry) { return entry.first == wanted; });
        if (other != open.end())
        {
          this->Link(h, other->second, {});
        }
        else
        {
          open.push_back({ { i, j }, h });
        }
      }
    }
  }
  if (triangles.empty())
  {
    // A single triangle at the boundary: the edge behind it is on the boundary now.
    const Index outer = sides.front().Twin;
    this->Link(outer, None, {});
    this->Features[outer] = feature;
    this->Outgoings[this->Tail(outer)] = outer;
    this->Outgoings[this->Head(outer)] = Next(outer);
  }
}

bool ExtractionMesh::MayCollapse(Index h) const
{
  const Index v = this->Tail(h);
  const Index w = this->Head(h);
  std::vector<Index> star;
  const bool isBoundary = this->GetStar(v, star);
  const Index g = this->Twins[h];
  if (isBoundary && g != None && this->IsBoundary(w))
  {
    return false;
  }
  // The only common neighbours are the two corners opposite of the edge, which keep a third
  // triangle.
  std::vector<Index> other;
  this->GetStar(w, other);
  std::vector<Index> neighbours;
  const auto collect = [&](const std::vector<Index>& fan)
  {
    for (const Index k : fan)
    {
      neighbours.push_back(this->Head(k));
      if (this->Twins[Previous(k)] == None)
      {
        neighbours.push_back(this->Tail(Previous(k)));
      }
    }
  };
  collect(star);
  collect(other);
  std::sort(neighbours.begin(), neighbours.end());
  int common = 0;
  for (std::size_t i = 1; i < neighbours.size(); ++i)
  {
    common += neighbours[i] == neighbours[i - 1] ? 1 : 0;
  }
  const auto keepsTriangle = [&](Index k)
  { return this->Twins[Next(k)] != None || this->Twins[Previous(k)] != None; };
  if (common != (g == None ? 1 : 2) || !keepsTriangle(h) || (g != None && !keepsTriangle(g)))
  {
    return false;
  }
  // A tetrahedron would be left as two triangles of the same corners.
  return star.size() + other.size() > 6 || isBoundary;
}

void ExtractionMesh::Collapse(Index h)
{
  const Index v = this->Tail(h);
  const Index w = this->Head(h);
  const Index g = this->Twins[h];
  std::vector<Index> star;
  this->GetStar(v, star);
  for (const Index k : star)
  {
    this->Corners[k] = w;
  }
  const auto close = [&](Index edge)
  {
    const Index next = Next(edge);
    const Index previous = Previous(edge);
    const Index p = this->Twins[previous];
    const Index n = this->Twins[next];
    const Index feature = std::max(this->Features[next], this->Features[previous]);
    // n's chart to this one, and from this one to p's.
    if (p != None)
    {
      this->Features[p] = feature;
      this->Link(p, n,
        n == None ? Transition{} : this->Plane.Composed(this->Acrosses[p], this->Acrosses[next]));
    }
    if (n != None)
    {
      this->Features[n] = feature;
      if (p == None)
      {
        this->Link(n, None, {});
      }
    }
    const Index t = edge / 3;
    this->Corners[3 * t] = this->Corners[3 * t + 1] = this->Corners[3 * t + 2] = None;
    // p runs from w to the apex, n from the apex to w, each along its own triangle.
    if (p != None)
    {
      this->Outgoings[this->Corners[p]] = p;
      this->Outgoings[this->Corners[Next(p)]] = Next(p);
    }
    if (n != None)
    {
      this->Outgoings[this->Corners[n]] = n;
      this->Outgoings[this->Corners[Next(n)]] = Next(n);
    }
  };
  this->Outgoings[v] = None;
  close(h);
  if (g != None)
  {
    close(g);
  }
}

Index ExtractionMesh::EulerCharacteristic() const
{
  Index sum = 0;
  for (Index v = 0; v < this->GetNumberOfVertices(); ++v)
  {
    sum += this->IsVertex(v) ? 1 : 0;
  }
  for (Index h = 0; h < static_cast<Index>(this->Corners.size()); ++h)
  {
    if (this->Corners[h] != None)
    {
      sum += h % 3 == 0 ? 1 : 0;
      sum -= this->Twins[h] == None || this->Twins[h] > h ? 1 : 0;
    }
  }
  return sum;
}
}
