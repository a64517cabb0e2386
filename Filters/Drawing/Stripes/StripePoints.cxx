// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Stripes/StripePoints.h"

#include "Support/Threads.h"

namespace DirectionFields::Internal
{
StripePoints::StripePoints(const StripePieces& pieces)
  : Pieces(pieces)
  , Crossings(pieces.GetLevels().GetNumberOfCrossings())
{
  const StripeLevels& levels = pieces.GetLevels();
  ParallelFor(levels.GetWanted().GetMesh().GetNumberOfEdges(), MediumPiece,
    [&](Index begin, Index end)
    {
      for (Index e = begin; e < end; ++e)
      {
        levels.ForCrossings(e,
          [this](std::int64_t point, const StripeLevels::Place& place)
          { this->Crossings[point] = place; });
      }
    });
}

StripePoints::MeshPlace StripePoints::Locate(std::int64_t point) const
{
  const WantedPhases& wanted = this->Pieces.GetLevels().GetWanted();
  const TriangleMesh& mesh = wanted.GetMesh();
  if (point < 0)
  {
    const Index vertex = wanted.Vertex(static_cast<Index>(-1 - point));
    return { { vertex, vertex, vertex }, { 1.0, 0.0, 0.0 } };
  }
  const auto crossings = static_cast<std::int64_t>(this->Crossings.size());
  if (point < crossings)
  {
    const StripeLevels::Place& place = this->Crossings[point];
    const Index tail = mesh.Tail(place.HalfEdge);
    return { { tail, mesh.Head(place.HalfEdge), tail }, { 1.0 - place.Part, place.Part, 0.0 } };
  }
  const StripePieces::InnerPoint& inner = this->Pieces.GetInnerPoints()[point - crossings];
  const Index h = 3 * inner.Triangle;
  return { { mesh.Tail(h), mesh.Tail(h + 1), mesh.Tail(h + 2) }, inner.Weights };
}

StripePoint StripePoints::At(std::int64_t point) const
{
  const MeshPlace place = this->Locate(point);
  StripePoint result{ {}, place.Weights };
  for (int c = 0; c < 3; ++c)
  {
    result.Points[c] = this->Pieces.GetLevels().GetWanted().GetMesh().Point(place.Vertices[c]);
  }
  return result;
}

Vector3 StripePoints::Position(std::int64_t point) const
{
  const MeshPlace place = this->Locate(point);
  const std::vector<Vector3>& positions =
    this->Pieces.GetLevels().GetWanted().GetField().GetGeometry().Positions;
  Vector3 sum = Vector3::Zero();
  for (int c = 0; c < 3; ++c)
  {
    sum += place.Weights[c] * positions[place.Vertices[c]];
  }
  return sum;
}

Vector3 StripePoints::Normal(std::int64_t point) const
{
  const MeshPlace place = this->Locate(point);
  const std::vector<Vector3>& normals =
    this->Pieces.GetLevels().GetWanted().GetField().GetGeometry().Frames.Normal;
  Vector3 sum = Vector3::Zero();
  for (int c = 0; c < 3; ++c)
  {
    sum += place.Weights[c] * normals[place.Vertices[c]];
  }
  const double length = sum.norm();
  return length > 0.0 ? Vector3(sum / length) : normals[place.Vertices[0]];
}
}
