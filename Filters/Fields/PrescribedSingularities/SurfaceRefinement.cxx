// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "PrescribedSingularities/SurfaceRefinement.h"

#include "Support/VectorMath.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace DirectionFields
{
namespace
{
/// A pair of points in ascending order as one number.
std::uint64_t KeyOf(Index a, Index b)
{
  const auto [low, high] = std::minmax({ a, b });
  return static_cast<std::uint64_t>(static_cast<std::uint32_t>(low)) << 32 |
    static_cast<std::uint32_t>(high);
}

/// The middles of edges.
class Middles
{
public:
  Middles(const std::vector<Vector3>& points, SurfaceRefinement& refinement)
    : Points(points)
    , Refinement(refinement)
  {
  }

  /// None where the edge has no middle.
  Index Find(Index a, Index b) const
  {
    const auto found = this->Of.find(KeyOf(a, b));
    return found == this->Of.end() ? None : found->second;
  }

  void Add(Index a, Index b)
  {
    const auto number = static_cast<Index>(this->Points.size() + this->Refinement.Ends.size());
    if (a != b && this->Of.emplace(KeyOf(a, b), number).second)
    {
      this->Refinement.Ends.push_back({ std::min(a, b), std::max(a, b) });
      // Halved first: the sum of the largest coordinates would overflow.
      this->Refinement.Refined.Points.emplace_back(0.5 * this->Points[a] + 0.5 * this->Points[b]);
    }
  }

private:
  const std::vector<Vector3>& Points;
  SurfaceRefinement& Refinement;
  std::unordered_map<std::uint64_t, Index> Of;
};

/// Appends the parts of a triangle whose edges have middles or not.
void AppendParts(
  const Triangle& corners, const std::array<Index, 3>& middle, std::vector<Triangle>& parts)
{
  const auto count = 3 - std::count(middle.begin(), middle.end(), None);
  if (count == 0)
  {
    parts.push_back(corners);
    return;
  }
  if (count == 3)
  {
    for (int c = 0; c < 3; ++c)
    {
      parts.push_back({ corners[c], middle[c], middle[(c + 2) % 3] });
    }
    parts.push_back({ middle[0], middle[1], middle[2] });
    return;
  }
  // With one middle it is on the first edge; with two they are on the first and the second one.
  int first = 0;
  while (middle[first] == None || (count == 2 && middle[(first + 1) % 3] == None))
  {
    ++first;
  }
  const Index a = corners[first];
  const Index b = corners[(first + 1) % 3];
  const Index c = corners[(first + 2) % 3];
  const Index ab = middle[first];
  if (count == 1)
  {
    parts.push_back({ a, ab, c });
    parts.push_back({ ab, b, c });
    return;
  }
  const Index bc = middle[(first + 1) % 3];
  parts.push_back({ ab, b, bc });
  parts.push_back({ a, ab, bc });
  parts.push_back({ a, bc, c });
}
}

SurfaceRefinement::SurfaceRefinement(const Surface& surface, const std::vector<char>& isSplit)
{
  this->Refined.Points = surface.Points;
  Middles middles(surface.Points, *this);
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    for (int c = 0; c < 3 && isSplit[t]; ++c)
    {
      middles.Add(surface.Triangles[t][c], surface.Triangles[t][(c + 1) % 3]);
    }
  }
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    const Triangle& corners = surface.Triangles[t];
    AppendParts(corners,
      { middles.Find(corners[0], corners[1]), middles.Find(corners[1], corners[2]),
        middles.Find(corners[2], corners[0]) },
      this->Refined.Triangles);
    this->Parent.resize(this->Refined.Triangles.size(), static_cast<Index>(t));
  }
  for (std::size_t t = 0; t < this->Parent.size() && !surface.Ghost.empty(); ++t)
  {
    this->Refined.Ghost.push_back(surface.Ghost[this->Parent[t]]);
  }
}

std::vector<char> TrianglesToSplit(const GivenField& base, const EditedField& edited)
{
  const TriangleMesh& mesh = base.GetMesh();
  std::vector<char> isSplit(base.GetSurface().Triangles.size(), 0);
  std::vector<Index> fan;
  for (const Index t : edited.WrongTriangles)
  {
    for (int c = 0; c < 3; ++c)
    {
      mesh.GetFan(mesh.Tail(3 * t + c), fan);
      for (const Index h : fan)
      {
        isSplit[mesh.InputTriangle(h / 3)] = 1;
      }
    }
  }
  return isSplit;
}

std::vector<Vector3> DirectionsAtMiddles(
  const GivenField& base, const SurfaceRefinement& refinement)
{
  const SurfaceGeometry& geometry = base.GetGeometry();
  const TriangleMesh& mesh = geometry.Mesh;
  const int degree = base.GetDegree();
  std::unordered_map<std::uint64_t, std::size_t> numberOf;
  for (std::size_t k = 0; k < refinement.Ends.size(); ++k)
  {
    numberOf.emplace(KeyOf(refinement.Ends[k][0], refinement.Ends[k][1]), k);
  }
  std::vector<Vector3> directions(refinement.Ends.size() * degree, Vector3::Zero());
  for (Index h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    if (!mesh.IsFront(h / 3))
    {
      continue;
    }
    const auto found =
      numberOf.find(KeyOf(base.PointAt(h / 3, h % 3), base.PointAt(h / 3, (h % 3 + 1) % 3)));
    if (found == numberOf.end())
    {
      continue;
    }
    const Index tail = mesh.Tail(h);
    const Index head = mesh.Head(h);
    const double theta = geometry.Transport.EdgeAngle[h];
    const double arriving = theta + geometry.Transport.RotationAlong(mesh, h);
    const Complex mean = base.GetSection()[tail] * std::polar(1.0, -degree * theta) +
      base.GetSection()[head] * std::polar(1.0, -degree * arriving);
    const Vector3 along = (geometry.Positions[head] - geometry.Positions[tail]).stableNormalized();
    Vector3 normal = geometry.Frames.Normal[tail] + geometry.Frames.Normal[head];
    normal = (normal - normal.dot(along) * along).stableNormalized();
    const Vector3 left = normal.cross(along);
    for (int k = 0; k < degree; ++k)
    {
      const double angle = (std::arg(mean) + 2.0 * Pi * k) / degree;
      directions[found->second * degree + k] = std::cos(angle) * along + std::sin(angle) * left;
    }
  }
  return directions;
}
}
