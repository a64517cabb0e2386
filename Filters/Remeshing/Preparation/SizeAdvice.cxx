// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Preparation/SizeAdvice.h"

#include "Support/Sentences.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// A component of fewer faces cannot show its shape: a cube has six.
constexpr double FewestFaces = 8.0;
/// A small part of vertices that are no grid points is normal; more than this part of all vertices
/// is not.
constexpr double MostKept = 0.01;
/// Edges shorter than this part of the wanted length were shortened by smoothing, and say nothing
/// about the surface.
constexpr double LeastEdge = 0.1;
}

void SizeAdvice::AddComponent(const SurfaceGeometry& geometry,
  const TriangleMesh::Component& component, const std::vector<double>& perLength)
{
  const TriangleMesh& mesh = geometry.Mesh;
  double squares = 0.0;
  for (Index t = component.FirstTriangle; t < component.EndTriangle; ++t)
  {
    const std::array<Index, 3> v = { mesh.Tail(3 * t), mesh.Tail(3 * t + 1), mesh.Tail(3 * t + 2) };
    const Vector3 a = geometry.Positions[v[1]] - geometry.Positions[v[0]];
    const Vector3 b = geometry.Positions[v[2]] - geometry.Positions[v[0]];
    const double factor = (perLength[v[0]] + perLength[v[1]] + perLength[v[2]]) / 3.0;
    squares += 0.5 * (factor * a).cross(factor * b).norm();
  }
  // A triangle of the same edge length is smaller; a cover is there twice.
  const double faces = (component.IsCover ? 0.5 : 1.0) *
    (this->Degree == 4 ? squares : 4.0 / std::sqrt(3.0) * squares);
  if (faces < FewestFaces && faces > 0.0)
  {
    this->LeastFaces = this->SmallComponents == 0 ? faces : std::min(this->LeastFaces, faces);
    ++this->SmallComponents;
  }
}

void SizeAdvice::AddMesh(const std::vector<Vector3>& points, const Faces& faces, Index kept)
{
  if (static_cast<double>(kept) <= MostKept * static_cast<double>(points.size()))
  {
    return;
  }
  this->Kept = kept;
  this->ShortestEdge = this->EdgeLength;
  for (std::size_t f = 0; f < faces.Corners.size(); ++f)
  {
    const Faces::Face& face = faces.Corners[f];
    for (int c = 0; faces.IsRegular[f] == 0 && c < Faces::Size(face); ++c)
    {
      const double length = (points[face[(c + 1) % Faces::Size(face)]] - points[face[c]]).norm();
      this->ShortestEdge = length > LeastEdge * this->EdgeLength
        ? std::min(this->ShortestEdge, length)
        : this->ShortestEdge;
    }
  }
}

std::vector<std::string> SizeAdvice::GetSentences(double unit) const
{
  std::vector<std::string> sentences;
  if (this->LengthOfArea > 0.0)
  {
    sentences.push_back(
      "Where the surface is thinner than a face, the length of its boundary decides how many faces there are: for the number "
      "asked for edges are " +
      Figure(unit * this->EdgeLength) + " long, where its area would give " +
      Figure(unit * this->LengthOfArea) + ".");
  }
  if (this->SmallComponents > 0)
  {
    sentences.push_back(std::to_string(this->SmallComponents) +
      (this->SmallComponents == 1 ? " component is" : " components are") +
      " too small for faces of the size asked for: triangles of the surface are left there. An edge "
      "length of " +
      Figure(unit * this->EdgeLength * std::sqrt(this->LeastFaces / FewestFaces)) +
      " would do for all.");
  }
  // Vertices of components that keep their triangles are told of above.
  const bool isOfSmall = this->SmallComponents > 0 && this->ShortestEdge >= this->EdgeLength;
  if (this->Kept > 0 && !isOfSmall)
  {
    sentences.push_back(std::to_string(this->Kept) +
      (this->Kept == 1 ? " vertex is no point" : " vertices are no points") +
      " of a grid: the surface is thinner there than three edges, or has features "
      "that are closer than one. An edge length of " +
      Figure(unit * this->ShortestEdge) + " would do, but in corners that are narrower still.");
  }
  return sentences;
}
}
