// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "TrivialConnection/RotationRepair.h"

#include "TrivialConnection/RotationAtPlace.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace DirectionFields::Internal
{
namespace
{
/// A set rotation may be exceeded by this much.
constexpr double Rounding = 1e-6;
/// Weights of a place that differ by no more are the same.
constexpr double SameWeight = 1e-3;
}

bool RotationRepair::IsMiddle(const MeshPlace& place)
{
  return std::all_of(place.Weights.begin(), place.Weights.end(),
    [](double weight) { return std::abs(weight - 1.0 / 3.0) < SameWeight; });
}

std::vector<char> RotationRepair::OwnTriangles() const
{
  std::vector<char> isOwn(this->Target.Indices.size());
  std::transform(this->Target.Indices.begin(), this->Target.Indices.end(),
    this->BaseIndices.begin(), isOwn.begin(), std::equal_to<>());
  for (const MeshPlace& place : this->Target.Places)
  {
    char& own = isOwn[place.Triangle - this->Component.FirstTriangle];
    own = own != 0 && IsMiddle(place) ? 1 : 0;
  }
  return isOwn;
}

void RotationRepair::AddRing(Index localTriangle, std::vector<Index>& ring) const
{
  std::vector<Index> fan;
  for (int c = 0; c < 3; ++c)
  {
    this->Mesh.GetFan(
      this->Mesh.Tail(3 * (this->Component.FirstTriangle + localTriangle) + c), fan);
    for (const Index h : fan)
    {
      ring.push_back(h / 3 - this->Component.FirstTriangle);
    }
  }
}

bool RotationRepair::KeepBase(
  const std::vector<Index>& wrong, int rings, std::vector<RotationSetting>& settings) const
{
  std::vector<char> isOwn = this->OwnTriangles();
  std::vector<Index> outermost;
  std::vector<Index> around;
  for (const Index t : wrong)
  {
    around.clear();
    this->AddRing(t, around);
    if (std::all_of(around.begin(), around.end(), [&](Index near) { return isOwn[near] != 0; }))
    {
      outermost.push_back(t);
    }
  }
  settings.resize(this->Target.Indices.size(), RotationSetting::Prescribed);
  bool hasChanged = false;
  for (int ring = 0; ring < rings && !outermost.empty(); ++ring)
  {
    around.clear();
    for (const Index t : outermost)
    {
      this->AddRing(t, around);
    }
    outermost.clear();
    for (const Index near : around)
    {
      // Each triangle is passed once.
      if (isOwn[near] != 0)
      {
        isOwn[near] = 0;
        hasChanged = hasChanged || settings[near] != RotationSetting::Base;
        settings[near] = RotationSetting::Base;
        outermost.push_back(near);
      }
    }
  }
  return hasChanged;
}

bool RotationRepair::Loosen(
  const std::vector<Index>& wrong, std::vector<RotationSetting>& settings) const
{
  settings.resize(this->Target.Indices.size(), RotationSetting::Prescribed);
  bool hasChanged = false;
  std::vector<Index> around;
  for (const Index t : wrong)
  {
    around.clear();
    this->AddRing(t, around);
    for (const Index near : around)
    {
      if ((this->Target.Indices[near] != 0 || this->BaseIndices[near] != 0) &&
        settings[near] == RotationSetting::Prescribed)
      {
        settings[near] = RotationSetting::Free;
        hasChanged = true;
      }
    }
  }
  return hasChanged;
}

bool RotationRepair::LimitEdges(const EdgeForm& rotation, std::vector<SetEdge>& edges)
{
  const std::size_t before = edges.size();
  for (Index e = 0; e < static_cast<Index>(rotation.size()); ++e)
  {
    if (std::abs(rotation[e]) > MostRotation + Rounding)
    {
      edges.push_back({ e, rotation[e] > 0.0 ? MostRotation : -MostRotation });
    }
  }
  return edges.size() > before;
}
}
