// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Parametrization/RowDistances.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// Rounding puts no line onto a cone that is farther than this many edges, and none onto a line
/// that is farther than that many.
constexpr double NearCone = 2.0;
constexpr double NearLine = 0.75;
/// Triangles that are looked at around each cone or edge, nearest first: many more are within reach
/// where faces are to be far larger than triangles.
constexpr std::size_t MostTriangles = 400;
/// The cosine of the angle between triangles of one plane.
const double InPlane = std::cos(1.0 * Pi / 180.0);

/// The doubled area times the normal.
Vector3 AreaVector(const CutMesh& mesh, Index t)
{
  const Triangle& corners = mesh.Triangles[t].Vertex;
  const Vector3& origin = mesh.Positions[corners[0]];
  return (mesh.Positions[corners[1]] - origin).cross(mesh.Positions[corners[2]] - origin);
}

/// Whether most of the area is in planes, as that of parts and plates. On round bodies there is
/// room for few cones between lines, and rows that are kept apart there spoil what is around.
bool IsMostlyFlat(const CutMesh& mesh)
{
  double all = 0.0;
  double flat = 0.0;
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const Vector3 vector = AreaVector(mesh, static_cast<Index>(t));
    const double area = vector.norm();
    const auto& twins = mesh.Triangles[t].Twin;
    const bool hasNeighbour = std::any_of(twins.begin(), twins.end(),
      [&](Index twin)
      {
        const Vector3 other = twin != None ? AreaVector(mesh, twin / 3) : Vector3::Zero();
        return other.dot(vector) > InPlane * area * other.norm();
      });
    all += area;
    flat += hasNeighbour ? area : 0.0;
  }
  return flat > 0.5 * all;
}

/// Lays the triangles around a cone, or on one side of an edge of a line, flat, by the coordinates
/// that their edges should have: in the chart of the triangle where that begins, with the cone or
/// the middle of the edge in the origin.
class Surroundings
{
public:
  Surroundings(const CutMesh& mesh, const std::vector<double>& perLength)
    : Mesh(mesh)
    , PerLength(perLength)
    , FirstAt(mesh.Positions.size(), None)
    , IsFrameless(mesh.Positions.size(), 0)
    , IsSeen(mesh.Triangles.size(), 0)
    , IsolineAt(3 * mesh.Triangles.size(), None)
  {
    for (const CutMesh::Cone& cone : mesh.Cones)
    {
      this->IsFrameless[cone.Vertex] = 1;
    }
    for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
    {
      for (int c = 0; c < 3; ++c)
      {
        Index& first = this->FirstAt[mesh.Triangles[t].Vertex[c]];
        first = first == None ? 3 * static_cast<Index>(t) + c : first;
      }
    }
    for (std::size_t k = 0; k < mesh.Isolines.size(); ++k)
    {
      const CutMesh::IsolineEdge& edge = mesh.Isolines[k];
      this->IsolineAt[3 * edge.Triangle + edge.Corner] = static_cast<Index>(k);
    }
  }

  void SearchAround(Index cone)
  {
    this->Reach = NearCone;
    this->FromAxis = None;
    this->Search(this->FirstAt[cone], 0.0);
  }

  /// Finds lines that run along an edge, if that is one of a line.
  void SearchBeside(Index halfEdge)
  {
    const Index t = halfEdge / 3;
    const int c = halfEdge % 3;
    const Index twin = this->Mesh.Triangles[t].Twin[c];
    const Index isoline = this->LineAt(halfEdge, twin);
    if (isoline != None)
    {
      this->Reach = NearLine;
      this->FromAxis = this->AxisOf(isoline, t, c, twin) % this->Mesh.Degree;
      this->Search(halfEdge, 0.5 * this->Target(t, c));
    }
  }

  std::vector<RowDistance> TakeFound() { return std::move(this->Found); }

private:
  /// A triangle laid flat.
  struct Patch
  {
    Index Triangle;
    SymbolicTransition ToFirst;
    std::array<Complex, 3> Corner;
  };
  /// The distance of a patch, and its number.
  using Entry = std::tuple<double, Index>;

  Complex Target(Index t, int c) const
  {
    const CutMesh::MapTriangle& triangle = this->Mesh.Triangles[t];
    const double size =
      0.5 * (this->PerLength[triangle.Vertex[c]] + this->PerLength[triangle.Vertex[(c + 1) % 3]]);
    return size * triangle.Target[c];
  }
  Complex Root(int turn) const { return std::polar(1.0, 2.0 * Pi * turn / this->Mesh.Degree); }

  void Search(Index corner, const Complex& origin)
  {
    this->From = corner;
    const Index t = corner / 3;
    const int c = corner % 3;
    Patch patch{ t, {}, {} };
    patch.Corner[c] = -origin;
    patch.Corner[(c + 1) % 3] = this->Target(t, c) - origin;
    patch.Corner[(c + 2) % 3] = -this->Target(t, (c + 2) % 3) - origin;
    this->Add(std::move(patch), 0.0);
    while (!this->Queue.empty() && this->Visited.size() < MostTriangles)
    {
      const Entry entry = this->Queue.top();
      this->Queue.pop();
      this->Visit(this->Patches[static_cast<std::size_t>(std::get<1>(entry))]);
    }
    for (const Index visited : this->Visited)
    {
      this->IsSeen[visited] = 0;
    }
    this->Visited.clear();
    this->Queue = {};
    this->Patches.clear();
  }

  void Add(Patch&& patch, double distance)
  {
    this->Queue.emplace(distance, static_cast<Index>(this->Patches.size()));
    this->Patches.push_back(std::move(patch));
  }

  void Visit(const Patch patch)
  {
    if (this->IsSeen[patch.Triangle] != 0)
    {
      return;
    }
    this->IsSeen[patch.Triangle] = 1;
    this->Visited.push_back(patch.Triangle);
    for (int c = 0; c < 3; ++c)
    {
      const Complex& p = patch.Corner[c];
      const Complex& q = patch.Corner[(c + 1) % 3];
      const double distance = DistanceOf(p, q);
      const Index twin = this->Mesh.Triangles[patch.Triangle].Twin[c];
      const Index isoline = this->LineAt(3 * patch.Triangle + c, twin);
      if (isoline != None)
      {
        this->TakeLine(patch, c, isoline, twin);
      }
      else if (twin != None && distance < this->Reach && this->IsSeen[twin / 3] == 0)
      {
        this->Cross(patch, c, twin, distance);
      }
    }
  }

  static double DistanceOf(const Complex& p, const Complex& q)
  {
    const Complex edge = q - p;
    const double squared = std::norm(edge);
    const double part =
      squared > 0.0 ? std::clamp(-(std::conj(edge) * p).real() / squared, 0.0, 1.0) : 0.0;
    return std::abs(p + part * edge);
  }

  Index LineAt(Index halfEdge, Index twin) const
  {
    const Index own = this->IsolineAt[halfEdge];
    return own != None || twin == None ? own : this->IsolineAt[twin];
  }

  /// To the chart of a triangle from that of the one beyond an edge, by way of an end of the edge
  /// that has a chart.
  SymbolicTransition Across(Index t, int c, Index twin) const
  {
    const bool tailHas = this->IsFrameless[this->Mesh.Triangles[t].Vertex[c]] == 0;
    const int here = tailHas ? c : (c + 1) % 3;
    const auto there = static_cast<int>(tailHas ? (twin % 3 + 1) % 3 : twin % 3);
    return SymbolicTransition::Composed(this->Mesh.Triangles[t].Corner[here],
      this->Mesh.Triangles[twin / 3].Corner[there].Inverse(this->Mesh.Degree), this->Mesh.Degree);
  }

  void Cross(const Patch& patch, int c, Index twin, double distance)
  {
    Patch next{ twin / 3,
      SymbolicTransition::Composed(
        patch.ToFirst, this->Across(patch.Triangle, c, twin), this->Mesh.Degree),
      {} };
    const auto k = static_cast<int>(twin % 3);
    const Complex turn = this->Root(next.ToFirst.Turn);
    const Complex& tail = patch.Corner[(c + 1) % 3];
    const Complex& head = patch.Corner[c];
    next.Corner[k] = tail;
    next.Corner[(k + 1) % 3] = head;
    next.Corner[(k + 2) % 3] = 0.5 *
      (head + turn * this->Target(next.Triangle, (k + 1) % 3) + tail -
        turn * this->Target(next.Triangle, (k + 2) % 3));
    this->Add(std::move(next), distance);
  }

  /// The axis of a line in the chart of a triangle with an edge of it.
  int AxisOf(Index isoline, Index t, int c, Index twin) const
  {
    const CutMesh::IsolineEdge& edge = this->Mesh.Isolines[isoline];
    return edge.Axis + (edge.Triangle != t ? this->Across(t, c, twin).Turn : 0);
  }

  /// Where the foot of the perpendicular is on the line, and the line is none that crosses the one
  /// that is begun from.
  void TakeLine(const Patch& patch, int c, Index isoline, Index twin)
  {
    const int degree = this->Mesh.Degree;
    int axis = (this->AxisOf(isoline, patch.Triangle, c, twin) + patch.ToFirst.Turn) % degree;
    const bool isOwn = 3 * patch.Triangle + c == this->From;
    if (this->FromAxis != None && (isOwn || (axis - this->FromAxis) % (degree / 2) != 0))
    {
      return;
    }
    const Complex back = std::conj(this->Root(axis));
    const Complex p = back * patch.Corner[c];
    const Complex q = back * patch.Corner[(c + 1) % 3];
    const bool hasFoot = std::min(p.real(), q.real()) <= 0.0 && std::max(p.real(), q.real()) >= 0.0;
    if (!hasFoot)
    {
      return;
    }
    const double along = q.real() - p.real();
    const double part = along != 0.0 ? -p.real() / along : 0.5;
    const double row = (1.0 - part) * p.imag() + part * q.imag();
    if (std::abs(row) < this->Reach)
    {
      axis = (row > 0.0 ? axis : axis + degree / 2) % degree;
      this->Found.push_back({ this->From, patch.Triangle, c, axis, patch.ToFirst });
    }
  }

  const CutMesh& Mesh;
  const std::vector<double>& PerLength;
  /// A corner at each vertex, the first.
  std::vector<Index> FirstAt;
  std::vector<char> IsFrameless;
  std::vector<char> IsSeen;
  /// The isoline of each half-edge, or None.
  std::vector<Index> IsolineAt;
  /// The corner at the cone, or where the edge begins; how far is looked from there, and the axis
  /// of the line that is begun from, or None.
  Index From = None;
  double Reach = NearCone;
  int FromAxis = None;
  std::vector<Patch> Patches;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> Queue;
  std::vector<Index> Visited;
  std::vector<RowDistance> Found;
};
}

bool operator==(const RowDistance& a, const RowDistance& b)
{
  // The transition is that of the way there, which these determine.
  return a.From == b.From && a.Triangle == b.Triangle && a.Corner == b.Corner && a.Axis == b.Axis;
}

std::vector<RowDistance> FindRowDistances(const CutMesh& mesh, const std::vector<double>& perLength)
{
  if (!IsMostlyFlat(mesh))
  {
    return {};
  }
  Surroundings surroundings(mesh, perLength);
  for (const CutMesh::Cone& cone : mesh.Cones)
  {
    if (mesh.IsCorner[cone.Vertex] == 0 && mesh.ConeIndex[cone.Vertex] != 0)
    {
      surroundings.SearchAround(cone.Vertex);
    }
  }
  for (Index h = 0; h < 3 * static_cast<Index>(mesh.Triangles.size()); ++h)
  {
    surroundings.SearchBeside(h);
  }
  return surroundings.TakeFound();
}
}
