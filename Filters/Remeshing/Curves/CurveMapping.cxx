// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Curves/CurveMapping.h"

#include "Distance/ClosestPoints.h"

#include <algorithm>
#include <cstddef>

namespace DirectionFields::Internal
{
CurveMapping::CurveMapping(const Surface& given, const CurveCut& cut)
  : Given(given)
  , Cut(cut)
  , TrianglesOfNew(cut.Cut.Points.size() - given.Points.size(), None)
{
  const auto first = static_cast<Index>(given.Points.size());
  for (std::size_t t = 0; t < cut.Cut.Triangles.size(); ++t)
  {
    for (const Index p : cut.Cut.Triangles[t])
    {
      if (p >= first)
      {
        this->TrianglesOfNew[p - first] = cut.Parents[t];
      }
    }
  }
}

CurveMapping::Weights CurveMapping::WeightsIn(Index triangle, const Vector3& place) const
{
  const Triangle& c = this->Given.Triangles[triangle];
  return ClosestPoints::ClosestWeights(
    place, { this->Given.Points[c[0]], this->Given.Points[c[1]], this->Given.Points[c[2]] });
}

std::vector<Index> CurveMapping::RegionsOfParts(const std::vector<Index>& regions) const
{
  std::vector<Index> ofParts;
  for (std::size_t t = 0; !regions.empty() && t < this->Cut.Parents.size(); ++t)
  {
    ofParts.push_back(regions[this->Cut.Parents[t]]);
  }
  return ofParts;
}

void CurveMapping::ContinueSizes(std::vector<double>& sizes) const
{
  for (std::size_t k = 0; !sizes.empty() && k < this->TrianglesOfNew.size(); ++k)
  {
    const Index t = this->TrianglesOfNew[k];
    const Weights w = this->WeightsIn(t, this->Cut.Cut.Points[this->Given.Points.size() + k]);
    const Triangle& c = this->Given.Triangles[t];
    const double size = w[0] * sizes[c[0]] + w[1] * sizes[c[1]] + w[2] * sizes[c[2]];
    sizes.push_back(size);
  }
}

void CurveMapping::ContinueDirections(std::vector<Vector3>& directions) const
{
  for (std::size_t k = 0; !directions.empty() && k < this->TrianglesOfNew.size(); ++k)
  {
    const Index t = this->TrianglesOfNew[k];
    const Weights w = this->WeightsIn(t, this->Cut.Cut.Points[this->Given.Points.size() + k]);
    const auto nearest = std::max_element(w.begin(), w.end()) - w.begin();
    const Vector3 direction = directions[this->Given.Triangles[t][nearest]];
    directions.push_back(direction);
  }
}

void CurveMapping::ReferToGiven(
  std::vector<Index>& triangle, std::vector<Weights>& weights, std::vector<Index>& faceSource) const
{
  for (std::size_t v = 0; v < triangle.size(); ++v)
  {
    const Triangle& corners = this->Cut.Cut.Triangles[triangle[v]];
    Vector3 place = Vector3::Zero();
    for (int c = 0; c < 3; ++c)
    {
      place += weights[v][c] * this->Cut.Cut.Points[corners[c]];
    }
    triangle[v] = this->Cut.Parents[triangle[v]];
    weights[v] = this->WeightsIn(triangle[v], place);
  }
  for (Index& source : faceSource)
  {
    source = this->Cut.Parents[source];
  }
}
}
