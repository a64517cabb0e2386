// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Curves/LinesOnMesh.h"

#include "Chains/MeshChains.h"
#include "Preparation/SurfaceUnit.h"
#include "Support/Sentences.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// Points closer than this part of an edge are one.
constexpr double LeastDistance = 0.1;

/// Lines run along the edges of curves but for rounding, in parts of the surface's extent.
constexpr double Rounding = 1e-9;

/// Cells of a grid in which close points are in the same one or in neighbours.
std::array<double, 3> CellOf(const Vector3& place, double size)
{
  if (!(size > 0.0))
  {
    return {};
  }
  return { std::floor(place.x() / size), std::floor(place.y() / size),
    std::floor(place.z() / size) };
}

/// Adds a sentence on points that are no vertices, if there are any.
void Say(std::vector<Index> numbers, const char* why, std::vector<std::string>& sentences)
{
  if (!numbers.empty())
  {
    std::sort(numbers.begin(), numbers.end());
    sentences.push_back(Numbered("Point", numbers) +
      (numbers.size() == 1 ? " is no vertex" : " are no vertices") + " of the mesh" + why);
  }
}

std::vector<Index> CurvesOfLines(const FaceMesh& mesh, const PreparedSurface& surface,
  const FeatureLines& features, const CurveCut& cut)
{
  std::vector<ClosestPoints::Corners> segments;
  for (const std::array<Index, 2>& edge : cut.Edges)
  {
    const Vector3& end = cut.Cut.Points[edge[1]];
    segments.push_back({ cut.Cut.Points[edge[0]], end, end });
  }
  const ClosestPoints curves(std::move(segments));
  const std::vector<ClosestPoints> lines = surface.LinesOf(surface.GetGeometry(), features);
  const double within = Rounding * Extent(cut.Cut);
  std::vector<Index> found(mesh.LineEdges.size(), None);
  for (std::size_t k = 0; k < found.size(); ++k)
  {
    const FaceMesh::LineEdge& edge = mesh.LineEdges[k];
    if (edge.Line > 0)
    {
      const Vector3 middle = 0.5 * (mesh.Points[edge.Ends[0]] + mesh.Points[edge.Ends[1]]);
      const ClosestPoints::Answer onLine = lines[edge.Line - 1].Find(middle);
      const Index at = curves.Find(onLine.Position, Vector3::Zero(), within).Triangle;
      found[k] = at == None ? None : cut.CurveOf[at];
    }
  }
  return found;
}
}

ChosenPoints::ChosenPoints(const CurveCut* cut, const std::vector<Index>& tips,
  const std::vector<double>& sizes, double edgeLength)
{
  if (cut)
  {
    this->Choose(*cut, sizes, edgeLength);
  }
  this->AddTips(cut, tips, sizes, edgeLength);
}

void ChosenPoints::Choose(const CurveCut& cut, const std::vector<double>& sizes, double edgeLength)
{
  double most = 0.0;
  for (const Index p : cut.Points)
  {
    most = std::max(most, p == None ? 0.0 : LeastDistance * edgeLength * sizes[p]);
  }
  std::map<std::array<double, 3>, std::vector<Index>> grid;
  std::map<Index, Index> chosen;
  for (std::size_t k = 0; k < cut.Points.size(); ++k)
  {
    if (cut.Points[k] == None)
    {
      continue;
    }
    const auto number = static_cast<Index>(k);
    if (chosen.count(cut.Points[k]) > 0)
    {
      this->AtOthers.push_back(number);
      continue;
    }
    const Vector3& place = cut.Places[k];
    const double least = LeastDistance * edgeLength * sizes[cut.Points[k]];
    const std::array<double, 3> cell = CellOf(place, most);
    bool isClose = false;
    for (int n = 0; n < 27; ++n)
    {
      const auto near =
        grid.find({ cell[0] + n % 3 - 1, cell[1] + n / 3 % 3 - 1, cell[2] + n / 9 - 1 });
      isClose = isClose ||
        (near != grid.end() &&
          std::any_of(near->second.begin(), near->second.end(),
            [&](Index other) { return (cut.Places[other] - place).norm() < least; }));
    }
    if (isClose)
    {
      this->TooClose.push_back(number);
      continue;
    }
    grid[cell].push_back(number);
    chosen.emplace(cut.Points[k], number);
  }
  for (const auto& [point, number] : chosen)
  {
    this->Surface.push_back(point);
    this->Numbers.push_back(number);
  }
}

void ChosenPoints::AddTips(const CurveCut* cut, const std::vector<Index>& tips,
  const std::vector<double>& sizes, double edgeLength)
{
  const std::vector<Index> given = this->Numbers;
  for (const Index p : tips)
  {
    const auto isClose = [&](Index number)
    { return (cut->Places[number] - cut->Cut.Points[p]).norm() < edgeLength * sizes[p]; };
    if (std::none_of(given.begin(), given.end(), isClose))
    {
      const auto at = std::lower_bound(this->Surface.begin(), this->Surface.end(), p);
      this->Numbers.insert(this->Numbers.begin() + (at - this->Surface.begin()), None);
      this->Surface.insert(at, p);
    }
  }
}

Index ChosenPoints::NumberOf(Index point) const
{
  const auto found = std::lower_bound(this->Surface.begin(), this->Surface.end(), point);
  return found != this->Surface.end() && *found == point
    ? this->Numbers[found - this->Surface.begin()]
    : None;
}

void ChosenPoints::Place(const PreparedSurface& surface, const CurveCut& cut, FaceMesh& mesh) const
{
  const std::vector<Index> points = surface.FindPoints();
  for (std::size_t v = 0; !points.empty() && v < mesh.Points.size(); ++v)
  {
    const Index origin = mesh.Vertices[v].Origin;
    const Index number = origin == None ? None : this->NumberOf(points[origin]);
    if (number != None)
    {
      mesh.Points[v] = cut.Places[number];
      mesh.Vertices[v].Line = -1;
    }
  }
}

std::vector<MeshChain> ChosenPoints::Find(const PreparedSurface& surface, const CurveCut& cut,
  const FaceMesh& mesh, std::vector<std::string>& sentences) const
{
  const std::vector<Index> points = surface.FindPoints();
  std::map<Index, Index> vertexOf;
  for (std::size_t v = 0; !points.empty() && v < mesh.Points.size(); ++v)
  {
    const Index origin = mesh.Vertices[v].Origin;
    const Index number = origin == None ? None : this->NumberOf(points[origin]);
    if (number != None && mesh.Points[v] == cut.Places[number])
    {
      vertexOf.emplace(number, static_cast<Index>(v));
    }
  }
  std::vector<MeshChain> chains;
  for (const auto& [number, v] : vertexOf)
  {
    chains.push_back(
      { ChainKind::Point, { v }, { None, None }, "Point " + std::to_string(number), number });
  }
  Say(this->AtOthers,
    ", since others before in the list stand for the same places: points closer than a hundredth of "
    "the surface's edges there are one.",
    sentences);
  Say(this->TooClose,
    ": closer than a tenth of an edge to others before in the list. Shorter edges there would keep "
    "all.",
    sentences);
  std::vector<Index> missed;
  std::copy_if(this->Numbers.begin(), this->Numbers.end(), std::back_inserter(missed),
    [&](Index number) { return number != None && vertexOf.count(number) == 0; });
  Say(missed,
    ", since there is no room for edges beside other points and lines. Shorter edges would keep "
    "them.",
    sentences);
  return chains;
}

std::vector<MeshChain> LinesOn(const FaceMesh& mesh, const LineSources& sources,
  const ChosenPoints& points, const std::vector<Index>& regions,
  const std::vector<std::string>& names, std::vector<std::string>& sentences)
{
  const CurveCut* cut = sources.Cut;
  std::vector<Index> curves;
  if (cut && !cut->Edges.empty())
  {
    curves = CurvesOfLines(mesh, sources.Surface, sources.Features, *cut);
  }
  std::vector<MeshChain> chains = FindChains(mesh,
    LinesOfBoundary(sources.Surface.GetGeometry().Mesh, sources.Features), curves, regions, names);
  if (cut)
  {
    const std::vector<MeshChain> found = points.Find(sources.Surface, *cut, mesh, sentences);
    chains.insert(chains.end(), found.begin(), found.end());
  }
  return chains;
}
}
