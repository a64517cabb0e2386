// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Parametrization/IsolineFolds.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// Edges shorter than this part of their target count as folds.
constexpr double ShortestStep = 0.1;

class Folds
{
public:
  Folds(const CutMesh& mesh, const std::vector<Transition>& own, std::vector<GridPoint>& places)
    : Mesh(mesh)
    , Plane(mesh.Degree)
    , Own(own)
    , Places(places)
  {
  }

  /// How far a map goes along an edge.
  std::int64_t LengthOf(const CutMesh::IsolineEdge& edge) const
  {
    const Index tail = 3 * edge.Triangle + edge.Corner;
    const Index head = 3 * edge.Triangle + (edge.Corner + 1) % 3;
    const GridPoint along =
      this->Plane.Apply(this->Own[head], this->Places[EndOf(this->Mesh, edge, true)]) -
      this->Plane.Apply(this->Own[tail], this->Places[EndOf(this->Mesh, edge, false)]);
    return this->Plane.Turned(along, -edge.Axis).A;
  }

  /// Returns whether the map goes forward along the isoline as a whole.
  bool Unfold(const FeatureIsoline& isoline)
  {
    const std::vector<FeatureIsoline::Step>& steps = isoline.Steps;
    std::vector<std::int64_t> length;
    std::vector<double> wanted;
    std::int64_t total = 0;
    double sum = 0.0;
    for (const FeatureIsoline::Step& step : steps)
    {
      const CutMesh::IsolineEdge& edge = this->Mesh.Isolines[step.Isoline];
      length.push_back(this->LengthOf(edge));
      wanted.push_back(std::abs(this->Mesh.Triangles[edge.Triangle].Target[edge.Corner]));
      total += length.back();
      sum += wanted.back();
    }
    bool hasFold = false;
    for (std::size_t i = 0; i < steps.size(); ++i)
    {
      hasFold = hasFold ||
        static_cast<double>(length[i]) * sum <
          ShortestStep * wanted[i] * static_cast<double>(total);
    }
    if (!hasFold || total <= 0 || !(sum > 0.0))
    {
      return total > 0;
    }
    std::int64_t before = 0;
    double reached = 0.0;
    for (std::size_t i = 0; i + 1 < steps.size(); ++i)
    {
      before += length[i];
      reached += wanted[i];
      const std::int64_t shift = std::llround(reached / sum * static_cast<double>(total)) - before;
      // The direction of the edge in the chart of the vertex that it leads to.
      const CutMesh::IsolineEdge& edge = this->Mesh.Isolines[steps[i].Isoline];
      const bool atHead = !steps[i].IsReversed;
      const Index corner = 3 * edge.Triangle + (edge.Corner + (atHead ? 1 : 0)) % 3;
      const int turn =
        edge.Axis - this->Own[corner].Turn + (steps[i].IsReversed ? this->Mesh.Degree / 2 : 0);
      GridPoint& place = this->Places[EndOf(this->Mesh, edge, atHead)];
      place = place + this->Plane.Turned({ shift, 0 }, turn);
    }
    return true;
  }

private:
  const CutMesh& Mesh;
  IntegerGrid Plane;
  const std::vector<Transition>& Own;
  std::vector<GridPoint>& Places;
};
}

std::vector<FeatureIsoline> UnfoldIsolines(const CutMesh& mesh, const std::vector<Transition>& own,
  const std::vector<FeatureIsoline>& isolines, std::vector<GridPoint>& places)
{
  Folds folds(mesh, own, places);
  std::vector<FeatureIsoline> collapsed;
  for (const FeatureIsoline& isoline : isolines)
  {
    if (!folds.Unfold(isoline))
    {
      collapsed.push_back(isoline);
    }
  }
  return collapsed;
}
}
