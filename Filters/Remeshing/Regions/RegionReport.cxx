// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Regions/RegionReport.h"

#include "Regions/FaceRegions.h"
#include "Support/Sentences.h"
#include "Support/SortedEnds.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// A border is on an edge, and a corner is a vertex, within this part of the wanted length.
constexpr double Tolerance = 0.1;
/// Samples of a segment of a border are closer than this part of the wanted length.
constexpr double PerSample = 0.1;
constexpr int MostSamples = 1000;
/// The user is told where less of the borders is on edges.
constexpr double EnoughKept = 0.98;
constexpr double Rounding = 1e-9;
/// The user is told of a larger error of a region's area.
constexpr double MostAreaError = 0.05;

ClosestPoints::Corners Degenerate(const Vector3& a, const Vector3& b)
{
  return { a, b, b };
}

/// The edges of the mesh whose faces are in different regions, and the vertices at their ends.
struct BorderEdges
{
  std::vector<ClosestPoints::Corners> Edges;
  std::vector<ClosestPoints::Corners> Ends;

  BorderEdges(const FaceMesh& mesh, const std::vector<Index>& ofFaces, bool hasCurves)
  {
    for (const FaceMesh::LineEdge& edge : mesh.LineEdges)
    {
      if (hasCurves)
      {
        this->Add(mesh.Points[edge.Ends[0]], mesh.Points[edge.Ends[1]]);
      }
    }
    std::map<std::array<Index, 2>, std::vector<Index>> regionsAt;
    for (std::size_t f = 0; f < mesh.Cells.Corners.size(); ++f)
    {
      const Faces::Face& face = mesh.Cells.Corners[f];
      const int size = Faces::Size(face);
      for (int c = 0; c < size; ++c)
      {
        const Index a = face[c];
        const Index b = face[(c + 1) % size];
        regionsAt[SortedEnds(a, b)].push_back(ofFaces[f]);
      }
    }
    for (const auto& [ends, regions] : regionsAt)
    {
      if (regions.size() > 1 &&
        std::any_of(
          regions.begin(), regions.end(), [first = regions[0]](Index r) { return r != first; }))
      {
        this->Add(mesh.Points[ends[0]], mesh.Points[ends[1]]);
      }
    }
  }

private:
  void Add(const Vector3& a, const Vector3& b)
  {
    this->Edges.push_back(Degenerate(a, b));
    this->Ends.push_back(Degenerate(a, a));
    this->Ends.push_back(Degenerate(b, b));
  }
};

/// The part of the length of some segments that is near others.
double PartNear(const std::vector<ClosestPoints::Corners>& segments,
  const std::vector<ClosestPoints::Corners>& others, double edgeLength)
{
  const ClosestPoints places(others);
  double near = 0.0;
  double all = 0.0;
  for (const ClosestPoints::Corners& segment : segments)
  {
    const Vector3 along = segment[1] - segment[0];
    const double length = along.norm();
    const auto samples = static_cast<int>(
      std::clamp(std::ceil(length / (PerSample * edgeLength)), 1.0, 1.0 * MostSamples));
    all += length;
    for (int k = 0; k < samples; ++k)
    {
      const ClosestPoints::Answer at = places.Find(
        segment[0] + (k + 0.5) / samples * along, Vector3::Zero(), Tolerance * edgeLength);
      near += at.Triangle != None ? length / samples : 0.0;
    }
  }
  return all > 0.0 ? near / all : 1.0;
}

std::map<Index, double> AreasOf(const Surface& surface, const std::vector<Index>& regions)
{
  std::map<Index, double> areas;
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    const Triangle& corners = surface.Triangles[t];
    const Vector3 a = surface.Points[corners[1]] - surface.Points[corners[0]];
    const Vector3 b = surface.Points[corners[2]] - surface.Points[corners[0]];
    areas[regions[t]] += 0.5 * a.cross(b).norm();
  }
  return areas;
}

std::map<Index, double> AreasOf(const FaceMesh& mesh, const std::vector<Index>& ofFaces)
{
  std::map<Index, double> areas;
  for (std::size_t f = 0; f < ofFaces.size(); ++f)
  {
    areas[ofFaces[f]] += AreaOf(mesh.Points, mesh.Cells.Corners[f]);
  }
  return areas;
}
}

RegionLines::RegionLines(const PreparedSurface& surface, const FeatureLines& features)
  : IsBorder(features.Chains.size() + 1, 0)
{
  const SurfaceGeometry& geometry = surface.GetGeometry();
  const TriangleMesh& mesh = geometry.Mesh;
  const std::vector<char> isHard = surface.FindHard();
  if (isHard.empty())
  {
    return;
  }
  for (std::size_t k = 0; k < features.Chains.size(); ++k)
  {
    const FeatureLines::Chain& chain = features.Chains[k];
    const Index h = chain.Steps.front().HalfEdge;
    const bool isBetween = isHard[mesh.Edge(h)] != 0;
    this->IsBorder[k + 1] = isBetween || mesh.Twin(h) == None ? 1 : 0;
    if (isBetween)
    {
      const std::vector<ClosestPoints::Corners> segments = surface.SegmentsOf(geometry, chain);
      this->Segments.insert(this->Segments.end(), segments.begin(), segments.end());
    }
  }
  std::vector<int> borders(mesh.GetNumberOfVertices(), 0);
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    if (isHard[e] != 0)
    {
      ++borders[mesh.Tail(mesh.HalfEdge(e))];
      ++borders[mesh.Head(mesh.HalfEdge(e))];
    }
  }
  const std::vector<Vector3> positions = surface.GetGivenPositions();
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    if (borders[v] > 2 || (borders[v] > 0 && mesh.IsBoundary(v)))
    {
      this->Corners.push_back(positions[v]);
    }
  }
}

RegionFigures FiguresOf(const Surface& surface, const std::vector<Index>& regions,
  const RegionLines& lines, const FaceMesh& mesh, const std::vector<Index>& ofFaces, bool hasCurves,
  double edgeLength)
{
  RegionFigures figures;
  const BorderEdges edges(mesh, ofFaces, hasCurves);
  figures.BordersKept = std::min(1.0, PartNear(lines.Segments, edges.Edges, edgeLength));
  const ClosestPoints ends(edges.Ends);
  for (const Vector3& corner : lines.Corners)
  {
    const bool isMissed =
      ends.Find(corner, Vector3::Zero(), Tolerance * edgeLength).Triangle == None;
    figures.MissedCorners += isMissed ? 1 : 0;
  }
  const std::map<Index, double> wanted = AreasOf(surface, regions);
  std::map<Index, double> found = AreasOf(mesh, ofFaces);
  for (const auto& [region, area] : wanted)
  {
    ++figures.Regions;
    if (found.count(region) == 0)
    {
      figures.Lost.push_back(region);
    }
    else if (area > 0.0)
    {
      figures.LargestAreaError =
        std::max(figures.LargestAreaError, std::abs(found[region] - area) / area);
    }
  }
  return figures;
}

namespace
{
/// Of the borders and the places where they meet, those of regions without faces: that these are
/// missed is said with the regions.
struct LostBorders
{
  double Part = 0.0;
  Index Corners = 0;
};

LostBorders BordersOfLost(const std::vector<Index>& lost, const Surface& surface,
  const std::vector<Index>& regions, const RegionLines& lines, double edgeLength)
{
  const auto isLost = [&](Index region)
  { return std::binary_search(lost.begin(), lost.end(), region); };
  std::vector<ClosestPoints::Corners> triangles;
  std::map<std::array<Index, 2>, std::array<Index, 2>> regionsAt;
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    const Triangle& corners = surface.Triangles[t];
    for (int c = 0; c < 3; ++c)
    {
      const auto [at, isNew] = regionsAt.try_emplace(
        SortedEnds(corners[c], corners[(c + 1) % 3]), std::array{ regions[t], regions[t] });
      at->second[1] = regions[t];
    }
    if (isLost(regions[t]))
    {
      triangles.push_back(
        { surface.Points[corners[0]], surface.Points[corners[1]], surface.Points[corners[2]] });
    }
  }
  double all = 0.0;
  double ofLost = 0.0;
  for (const auto& [ends, sides] : regionsAt)
  {
    const double length = (surface.Points[ends[1]] - surface.Points[ends[0]]).norm();
    all += sides[0] != sides[1] ? length : 0.0;
    ofLost += sides[0] != sides[1] && (isLost(sides[0]) || isLost(sides[1])) ? length : 0.0;
  }
  const ClosestPoints places(std::move(triangles));
  const auto isNear = [&](const Vector3& corner)
  { return places.Find(corner, Vector3::Zero(), Tolerance * edgeLength).Triangle != None; };
  LostBorders borders;
  borders.Part = all > 0.0 ? ofLost / all : 0.0;
  borders.Corners =
    static_cast<Index>(std::count_if(lines.Corners.begin(), lines.Corners.end(), isNear));
  return borders;
}

/// @param names of the regions, by their numbers; empty for the numbers themselves
std::vector<std::string> RegionAdvice(const RegionFigures& figures, const LostBorders& lost,
  const std::vector<std::string>& names, bool hasCurves)
{
  std::vector<std::string> sentences;
  if (!figures.Lost.empty())
  {
    const Index first = figures.Lost.front();
    const std::size_t others = figures.Lost.size() - 1;
    sentences.push_back("Region " + (names.empty() ? std::to_string(first) : names[first]) +
      (others > 0 ? " and " + Count(others, "other") + " have" : " has") +
      " no faces, since there is less room than for one. More faces, or shorter edges, show "
      "narrower regions.");
  }
  if (figures.Stairs > lost.Part + Rounding)
  {
    sentences.push_back(Figure(100.0 * figures.Stairs) +
      " % of the borders of regions run in stairs along the triangles of the surface, or closer "
      "to each other than faces are, so that rows of faces cannot follow. They are not kept, and each "
      "face there has the region that it is closest to. Regions that a cut divides, as Clip makes, "
      "have smooth borders.");
  }
  if (figures.LargestAreaError > MostAreaError)
  {
    sentences.push_back("The faces of a region have another area than it has on the surface, by " +
      Figure(100.0 * figures.LargestAreaError) +
      " %: they overlap, or cut off what is narrow. Another number of faces may avoid that.");
  }
  if (figures.BordersKept + figures.Stairs + lost.Part < EnoughKept ||
    figures.MissedCorners > lost.Corners)
  {
    sentences.push_back(Figure(100.0 * (1.0 - figures.BordersKept - figures.Stairs)) +
      (hasCurves ? " % of the curves, and of borders of regions,"
                 : " % of the borders of regions") +
      " are not on edges of the mesh, " +
      (figures.MissedCorners == 0
          ? std::string()
          : "and " + std::to_string(figures.MissedCorners) + " of the places where they meet " +
            (figures.MissedCorners == 1 ? "is no vertex, " : "are no vertices, ")) +
      "since " + (hasCurves ? "they are close" : "regions are narrow") +
      " there, or round. More faces, or shorter edges, "
      "come closer.");
  }
  return sentences;
}
}

RegionReport ReportRegions(const Surface& input, const std::vector<Index>& regions,
  const std::vector<std::string>& names, bool hasCurves, const PreparedSurface& surface,
  const FeatureLines& features, const FaceMesh& mesh, double edgeLength,
  std::vector<Index>& closest)
{
  RegionReport report;
  const RegionLines lines(surface, features);
  if (regions.empty())
  {
    const std::vector<Index> ofTriangles(input.Triangles.size(), 0);
    const std::vector<Index> ofFaces(mesh.Cells.Corners.size(), 0);
    const RegionFigures curves =
      FiguresOf(input, ofTriangles, lines, mesh, ofFaces, hasCurves, edgeLength);
    report.Shown.BordersKept = curves.BordersKept;
    report.Shown.MissedCorners = curves.MissedCorners;
    report.Sentences = RegionAdvice(report.Shown, {}, names, hasCurves);
    return report;
  }
  report.OfFaces = RegionsOfFaces(mesh, regions, closest, lines.IsBorder);
  FindInRegions(surface, mesh, regions, report.OfFaces, closest);
  report.Shown = FiguresOf(input, regions, lines, mesh, report.OfFaces, hasCurves, edgeLength);
  report.Shown.Stairs = surface.GetStairs();
  report.Shown.BordersKept *= 1.0 - surface.GetStairs();
  LostBorders lost;
  if (!report.Shown.Lost.empty())
  {
    lost = BordersOfLost(report.Shown.Lost, input, regions, lines, edgeLength);
  }
  report.Sentences = RegionAdvice(report.Shown, lost, names, hasCurves);
  return report;
}
}
