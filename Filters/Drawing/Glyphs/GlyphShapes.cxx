// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Glyphs/GlyphShapes.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// Sides of a tube.
constexpr int Sides = 10;
}

GlyphShapes::GlyphShapes(GlyphType type, int degree, GlyphMesh& mesh)
  : Type(type)
  , Degree(degree)
  , Mesh(mesh)
{
  mesh.AreLines = type == GlyphType::Lines;
  this->MakeProfile(type, degree);
}

void GlyphShapes::MakeProfile(GlyphType type, int degree)
{
  const double gap = std::sin(Pi / degree);
  if (degree == 1)
  {
    const double half =
      type == GlyphType::Ribbons ? 0.24 : (type == GlyphType::Tubes ? 0.11 : 0.12);
    // The corners of the tail are on the circle.
    const double tail = -std::sqrt(1.0 - half * half);
    if (type == GlyphType::Ribbons)
    {
      this->Profile = { { tail, half }, { 1.0, 0.0 } };
      return;
    }
    if (type == GlyphType::Tubes)
    {
      this->Profile.push_back({ tail, 0.0 });
    }
    this->Profile.insert(
      this->Profile.end(), { { tail, half }, { 0.1, half }, { 0.1, 3.0 * half }, { 1.0, 0.0 } });
    return;
  }
  // Neighbouring arms leave some of the surface to be seen between them.
  const double half = std::min(type == GlyphType::Arrows ? 0.11 : 0.2, 0.3 * gap);
  if (type == GlyphType::Tubes)
  {
    this->Profile = { { 0.0, half }, { 1.0 - 0.5 * half, 0.7 * half }, { 1.0, 0.0 } };
    return;
  }
  // The arms meet without overlap: the edges of neighbouring arms cross at this distance.
  const double core = half * std::cos(Pi / degree) / gap;
  if (degree > 2)
  {
    this->Profile.push_back({ 0.0, 0.0 });
  }
  this->Profile.push_back({ degree > 2 ? core : 0.0, half });
  if (type == GlyphType::Arrows)
  {
    const double head = std::min(0.24, 0.55 * gap);
    this->Profile.insert(this->Profile.end(), { { 0.58, half }, { 0.58, head }, { 1.0, 0.0 } });
  }
  else
  {
    // The corners of the tip are on the circle.
    const double tip = 0.6 * half;
    this->Profile.push_back({ std::sqrt(1.0 - tip * tip), tip });
  }
}

void GlyphShapes::Draw(
  Index glyph, int branch, const SurfacePath& path, double length, double height)
{
  this->Glyph = glyph;
  this->Branch = branch;
  switch (this->Type)
  {
    case GlyphType::Lines:
      this->DrawLines(path, length, height);
      break;
    case GlyphType::Tubes:
      this->DrawTube(path, length, height);
      break;
    default:
      this->DrawBand(path, length, height);
  }
}

void GlyphShapes::FindStations(const SurfacePath& path, double begin, double end)
{
  this->Stations = { begin };
  for (const auto& station : path.Stations)
  {
    if (station.Distance > begin && station.Distance < end)
    {
      this->Stations.push_back(station.Distance);
    }
  }
  this->Stations.push_back(end);
}

void GlyphShapes::DrawLines(const SurfacePath& path, double length, double height)
{
  this->FindStations(path, path.Stations.front().Distance, length);
  for (const double distance : this->Stations)
  {
    const auto at = path.At(distance);
    this->Mesh.Connectivity.push_back(this->AddPoint(at.Position + height * at.Normal, at.Normal));
  }
  this->EndCell();
  if (this->Degree == 1)
  {
    const auto tip = path.At(length);
    const auto barb = path.At(0.3 * length);
    const Vector3 left = path.Left(0.3 * length) * (0.35 * length);
    const Vector3 foot = barb.Position + height * barb.Normal;
    this->AddCell({ this->AddPoint(foot + left, barb.Normal),
      this->AddPoint(tip.Position + height * tip.Normal, tip.Normal),
      this->AddPoint(foot - left, barb.Normal) });
  }
}

void GlyphShapes::DrawBand(const SurfacePath& path, double length, double height)
{
  for (std::size_t i = 0; i + 1 < this->Profile.size(); ++i)
  {
    const Width& a = this->Profile[i];
    const Width& b = this->Profile[i + 1];
    if (a.Distance == b.Distance)
    {
      continue;
    }
    this->FindStations(path, a.Distance * length, b.Distance * length);
    std::int64_t lastRight = 0, lastLeft = 0;
    for (std::size_t k = 0; k < this->Stations.size(); ++k)
    {
      const double distance = this->Stations[k];
      const double part = (distance / length - a.Distance) / (b.Distance - a.Distance);
      const double half =
        k + 1 == this->Stations.size() ? b.Half : a.Half + part * (b.Half - a.Half);
      const auto at = path.At(distance);
      const Vector3 middle = at.Position + height * at.Normal;
      std::int64_t right, left;
      if (half == 0.0)
      {
        right = left = this->AddPoint(middle, at.Normal);
      }
      else
      {
        const Vector3 side = path.Left(distance) * (half * length);
        right = this->AddPoint(middle - side, at.Normal);
        left = this->AddPoint(middle + side, at.Normal);
      }
      if (k > 0)
      {
        if (lastRight == lastLeft)
        {
          this->AddCell({ lastRight, right, left });
        }
        else if (right == left)
        {
          this->AddCell({ lastRight, right, lastLeft });
        }
        else
        {
          this->AddCell({ lastRight, right, left, lastLeft });
        }
      }
      lastRight = right;
      lastLeft = left;
    }
  }
}

void GlyphShapes::DrawTube(const SurfacePath& path, double length, double height)
{
  for (std::size_t i = 0; i + 1 < this->Profile.size(); ++i)
  {
    // Each part has points of its own, for its normals turn sharply at the ends.
    const Width& a = this->Profile[i];
    const Width& b = this->Profile[i + 1];
    const double run = b.Distance - a.Distance;
    const double rise = b.Half - a.Half;
    const double slope = std::hypot(run, rise);
    this->FindStations(path, a.Distance * length, b.Distance * length);
    std::int64_t lastRing = 0;
    for (std::size_t k = 0; k < this->Stations.size(); ++k)
    {
      const double distance = this->Stations[k];
      const bool isEnd = k + 1 == this->Stations.size();
      const double part = isEnd ? 1.0 : k == 0 ? 0.0 : (distance / length - a.Distance) / run;
      const double radius = (a.Half + part * rise) * length;
      const auto at = path.At(distance);
      const Vector3 middle = at.Position + height * at.Normal;
      const Vector3 heading = path.Heading(distance);
      const Vector3 left = path.Left(distance);
      const Vector3 up = heading.cross(left);
      const auto ring = static_cast<std::int64_t>(this->Mesh.Points.size());
      for (int s = 0; s < Sides; ++s)
      {
        const double angle = 2.0 * Pi * s / Sides;
        const Vector3 outward = std::cos(angle) * left + std::sin(angle) * up;
        this->AddPoint(middle + radius * outward, (run * outward - rise * heading) / slope);
      }
      for (int s = 0; s < Sides && k > 0; ++s)
      {
        const int next = (s + 1) % Sides;
        if (isEnd && b.Half == 0.0)
        {
          this->AddCell({ lastRing + s, lastRing + next, ring + s });
        }
        else if (k == 1 && a.Half == 0.0)
        {
          this->AddCell({ lastRing + s, ring + next, ring + s });
        }
        else
        {
          this->AddCell({ lastRing + s, lastRing + next, ring + next, ring + s });
        }
      }
      lastRing = ring;
    }
  }
}

std::int64_t GlyphShapes::AddPoint(const Vector3& position, const Vector3& normal)
{
  this->Mesh.Points.push_back(position);
  this->Mesh.Normals.push_back(normal);
  return static_cast<std::int64_t>(this->Mesh.Points.size()) - 1;
}

void GlyphShapes::AddCell(std::initializer_list<std::int64_t> points)
{
  this->Mesh.Connectivity.insert(this->Mesh.Connectivity.end(), points);
  this->EndCell();
}

void GlyphShapes::EndCell()
{
  this->Mesh.Offsets.push_back(static_cast<std::int64_t>(this->Mesh.Connectivity.size()));
  this->Mesh.Glyph.push_back(this->Glyph);
  this->Mesh.Branch.push_back(this->Branch);
}
}
