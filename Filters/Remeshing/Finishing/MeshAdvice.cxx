// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Finishing/MeshAdvice.h"

#include "Finishing/CloserMesh.h"
#include "Soup/JoinedSets.h"
#include "Support/Sentences.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace DirectionFields::Internal
{
namespace
{
/// A triangle at an odd rim or at a corner is normal; more than this part of all faces is not.
constexpr double MostTriangles = 0.01;
constexpr Index FewTriangles = 4;
/// Of the diagonal of the box around the surface; and of the length of edges, since faces that are
/// wanted as large as the bends of the surface cut them off.
constexpr double MostDistance = 0.02;
constexpr double MostPerLength = 1.0 / 3.0;
/// How many times too large or too small a size may be.
constexpr double MostMissed = 1.3;
/// Where there are more than this many times as many faces as were wanted, and this part of the
/// vertices is on features, these need them.
constexpr double ManyTimes = 2.0;
constexpr double MostOnFeatures = 0.25;
/// Directions that cross more of the kept edges are what makes faces bad.
constexpr double MostCrossed = 0.1;
/// Sizes are judged by this part of the faces, those that are to be the smallest or the largest.
constexpr double Extremes = 0.1;
/// Sizes whose largest one is less than this times the smallest one are the same.
constexpr double HardlyOther = 1.05;
/// The user is told where fewer edges have the wanted length. Of even ones about .75 to 1 have.
constexpr double FewAsWanted = 0.6;

bool IsMissed(double ratio)
{
  return ratio > MostMissed || ratio < 1.0 / MostMissed;
}

std::string AboutTriangles(const Faces& faces, const MeshWishes& wishes)
{
  const Index triangles = static_cast<Index>(std::count_if(faces.Corners.begin(),
    faces.Corners.end(), [](const Faces::Face& face) { return Faces::Size(face) == 3; }));
  const auto all = static_cast<double>(faces.Corners.size());
  if (!wishes.IsOfQuads || wishes.IsPure || triangles <= FewTriangles ||
    triangles <= MostTriangles * all)
  {
    return {};
  }
  return std::to_string(triangles) + " of " + std::to_string(faces.Corners.size()) +
    " faces are triangles. Pure Quads would join them in pairs; where features are closer to each "
    "other than edges are long, shorter edges leave fewer of them.";
}

std::string AboutQuality(
  const std::vector<Vector3>& points, const Faces& faces, const MeshWishes& wishes)
{
  const auto isBad = [&](const Faces::Face& face)
  { return ScaledJacobian(points, face) < LeastUsable; };
  const auto bad = std::count_if(faces.Corners.begin(), faces.Corners.end(), isBad);
  if (bad == 0)
  {
    return {};
  }
  return std::to_string(bad) + (bad == 1 ? " face has" : " faces have") +
    " a scaled Jacobian below " + Figure(LeastUsable) +
    ", as the array ScaledJacobian shows: nearly flat or folded. " +
    (wishes.PartCrossed > MostCrossed
        ? "The directions given cross " + Figure(100.0 * wishes.PartCrossed) +
          " % of the edges that are kept: Constrain Sharp Edges and Constrain Boundary of Direction "
          "Field make them follow these."
        : wishes.IsSmoothed
        ? "A tenth fewer or more faces may avoid that, unless the surface itself is as pointed or "
          "folded there."
        : "Smoothing Iterations above 0 would make most of them regular.");
}

std::string AboutTurned(const MeshWishes& wishes)
{
  if (wishes.Turned == 0)
  {
    return {};
  }
  return std::to_string(wishes.Turned) + (wishes.Turned == 1 ? " face is" : " faces are") +
    " turned over, to the other side than the surface below, beside an edge of it "
    "that bends more than theirs can follow" +
    (wishes.HasHard
        ? ", or beside a kept curve or border at about 45 degrees to others or to the boundary"
        : "") +
    ". An edge length of " + Figure(0.5 * wishes.ShortestEdge) + " gives them room" +
    (wishes.HasHard ? " at edges. Curves at up to 34 degrees to the others have enough." : ".");
}

std::string AboutDistance(const MeshWishes& wishes)
{
  const double most = std::max(MostDistance * wishes.Extent, MostPerLength * wishes.EdgeLength);
  const double farthest = std::max({ wishes.ToSurface, wishes.ToMesh, wishes.OfBoundary });
  if (farthest <= most)
  {
    return {};
  }
  const std::string shorter =
    ". An edge length of " + Figure(0.5 * wishes.ShortestEdge) + " would come closer.";
  const auto percent = [&](double distance)
  { return Figure(100.0 * distance / wishes.Extent) + " % of the diagonal"; };
  if (wishes.ToSurface <= most && wishes.ToMesh <= most)
  {
    return "The boundaries of surface and mesh are up to " + Figure(wishes.OfBoundary) + " (" +
      percent(wishes.OfBoundary) +
      ") away from each other: slits and notches there are narrower than a face" + shorter;
  }
  return wishes.ToMesh > most
    ? "Parts of the surface are up to " + Figure(wishes.ToMesh) + " (" + percent(wishes.ToMesh) +
      ") away from the mesh, since they are thinner or more bent than its "
      "faces can show" +
      shorter
    : "The mesh is up to " + Figure(wishes.ToSurface) + " (" + percent(wishes.ToSurface) +
      ") away from the surface, since its faces span bends" + shorter;
}

std::string AboutNumber(const Faces& faces, const MeshWishes& wishes)
{
  const auto made = static_cast<double>(faces.Corners.size());
  const auto wanted = static_cast<double>(wishes.NumberOfFaces);
  if (made == 0.0 || wanted == 0.0 || !IsMissed(made / wanted))
  {
    return {};
  }
  const auto better = static_cast<Index>(std::min(1e9, std::ceil(wanted * wanted / made)));
  return "There are " + std::to_string(faces.Corners.size()) + " faces in place of " +
    std::to_string(wishes.NumberOfFaces) + ". " +
    (made > ManyTimes * wanted && wishes.PartOnFeatures > MostOnFeatures
        ? (wishes.HasHard
              ? "The borders, curves and points that are to be kept need so many: fewer "
                "of them would come closer."
              : "Its sharp edges need so many: Keep Features off would come closer.")
        : better == wishes.NumberOfFaces
        ? "So few cannot show the surface."
        : "A Number Of Faces of " + std::to_string(better) + " should come closer.");
}

/// The area of a face, by its diagonals or two of its sides.
double AreaOf(const std::vector<Vector3>& points, const Faces::Face& face)
{
  const Vector3 a = points[face[2]] - points[face[0]];
  const Vector3 b = points[face[face[3] == None ? 1 : 3]] - points[face[face[3] == None ? 0 : 1]];
  return 0.5 * a.cross(b).norm();
}

/// A face's wanted size, how many times it is as large, and how many faces were wanted there.
struct SizedFace
{
  double Wanted;
  double Ratio;
  double Weight;
};

/// The middle ratio of the first faces, a part of all that were wanted.
double MiddleRatio(const std::vector<SizedFace>& faces, double part)
{
  double all = 0.0;
  for (const SizedFace& face : faces)
  {
    all += face.Weight;
  }
  std::vector<SizedFace> first;
  double sum = 0.0;
  for (std::size_t k = 0; k < faces.size() && sum < part * all; ++k)
  {
    sum += faces[k].Weight;
    first.push_back(faces[k]);
  }
  std::sort(first.begin(), first.end(),
    [](const SizedFace& a, const SizedFace& b) { return a.Ratio < b.Ratio; });
  std::size_t middle = 0;
  for (double half = 0.0; middle + 1 < first.size(); ++middle)
  {
    half += first[middle].Weight;
    if (half >= 0.5 * sum)
    {
      break;
    }
  }
  return first[middle].Ratio;
}

std::string TimesWanted(double ratio)
{
  return Figure(ratio < 1.0 ? 1.0 / ratio : ratio) +
    (ratio < 1.0 ? " times shorter than wanted" : " times as long as wanted");
}

std::string AboutSizes(
  const std::vector<Vector3>& points, const Faces& faces, const MeshWishes& wishes)
{
  if (wishes.Sizes.empty() || faces.Corners.empty())
  {
    return {};
  }
  std::vector<SizedFace> sized;
  for (const Faces::Face& face : faces.Corners)
  {
    const int size = Faces::Size(face);
    double wanted = 0.0;
    for (int c = 0; c < size; ++c)
    {
      wanted += wishes.Sizes[face[c]] / size;
    }
    const double even = size == 4 ? 1.0 : std::sqrt(3.0) / 4.0;
    const double ratio = std::sqrt(AreaOf(points, face) / even) / wanted;
    sized.push_back({ wanted, ratio, even * ratio * ratio });
  }
  const auto isSmaller = [](const SizedFace& a, const SizedFace& b) { return a.Wanted < b.Wanted; };
  std::stable_sort(sized.begin(), sized.end(), isSmaller);
  // Other sentences tell why sizes that hardly differ are missed.
  if (!(sized.back().Wanted > HardlyOther * sized.front().Wanted))
  {
    return {};
  }
  const double shortest = MiddleRatio(sized, Extremes);
  std::reverse(sized.begin(), sized.end());
  const double longest = MiddleRatio(sized, Extremes);
  if (!IsMissed(shortest) && !IsMissed(longest))
  {
    const double share = EdgesAsWanted(points, faces, wishes.Sizes);
    return share < FewAsWanted ? Figure(100.0 * share) +
        " % of the edges are as long as the sizes ask for, within 25 %: they differ more than a grid "
        "of few irregular vertices can follow. " +
        (wishes.HasGradation ? "A Gradation closer to 1 makes them grow more slowly."
                             : "A Gradation of 1.3 makes them grow step by step.")
                               : std::string();
  }
  return "Edges are " + TimesWanted(shortest) + " where they are to be shortest, and " +
    TimesWanted(longest) +
    " where they are to be longest: a grid of few irregular vertices cannot change its size that "
    "fast. " +
    (wishes.AddsPairs ? "" : "Add Irregular Pairs would help, unless a field is given. ") +
    "Sizes that differ less, as their square roots do, would be kept better.";
}
}

std::vector<std::string> MeshAdvice(
  const std::vector<Vector3>& points, const Faces& faces, const MeshWishes& wishes)
{
  std::vector<std::string> sentences;
  for (std::string& sentence : std::array{ AboutTriangles(faces, wishes),
         AboutQuality(points, faces, wishes), AboutTurned(wishes), AboutDistance(wishes),
         AboutNumber(faces, wishes), AboutSizes(points, faces, wishes) })
  {
    if (!sentence.empty())
    {
      sentences.push_back(std::move(sentence));
    }
  }
  return sentences;
}

std::vector<std::string> TopologyAdvice(Index touching, int before, int after, double edgeLength)
{
  std::vector<std::string> sentences;
  if (touching > 0)
  {
    sentences.push_back("At " + std::to_string(touching) + (touching == 1 ? " point" : " points") +
      " sheets of the surface only touch: they are separate in the mesh. Sheets that are to be "
      "joined need an edge in common.");
  }
  if (before != after)
  {
    sentences.push_back("The mesh has other holes or handles than the surface: its Euler "
                        "characteristic is " +
      std::to_string(after) + " in place of " + std::to_string(before) + ". An edge length of " +
      Figure(0.5 * edgeLength) + " would keep more of them.");
  }
  return sentences;
}

Index CountTouching(const TriangleMesh& mesh, const std::vector<Index>& original)
{
  JoinedSets sets(mesh.GetNumberOfVertices());
  const auto placeOf = [&](Index v) { return original[mesh.Point(v)]; };
  std::map<std::array<Index, 2>, std::array<Index, 2>> seams;
  for (Index h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    std::array<Index, 2> ends = { mesh.Tail(h), mesh.Head(h) };
    if (mesh.Twin(h) != None)
    {
      continue;
    }
    if (placeOf(ends[0]) > placeOf(ends[1]))
    {
      std::swap(ends[0], ends[1]);
    }
    const auto first = seams.emplace(std::array{ placeOf(ends[0]), placeOf(ends[1]) }, ends).first;
    sets.Join(ends[0], first->second[0]);
    sets.Join(ends[1], first->second[1]);
  }
  std::vector<Index> sheetAt(original.size(), None);
  std::vector<char> isTouched(original.size(), 0);
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    Index& sheet = sheetAt[placeOf(v)];
    isTouched[placeOf(v)] |= sheet != None && sheet != sets.Find(v) ? 1 : 0;
    sheet = sets.Find(v);
  }
  return static_cast<Index>(std::count(isTouched.begin(), isTouched.end(), 1));
}

Index CountUnused(const std::vector<Triangle>& triangles, const std::vector<char>& isUsed)
{
  Index points = 0;
  for (const Triangle& t : triangles)
  {
    points = std::max(points, 1 + *std::max_element(t.begin(), t.end()));
  }
  JoinedSets sets(points);
  for (const Triangle& t : triangles)
  {
    sets.Join(t[0], t[1]);
    sets.Join(t[0], t[2]);
  }
  std::vector<char> isKept(points, 0);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    isKept[sets.Find(triangles[t][0])] |= isUsed[t];
  }
  Index unused = 0;
  for (const Triangle& t : triangles)
  {
    char& kept = isKept[sets.Find(t[0])];
    unused += kept == 0 ? 1 : 0;
    kept = 1;
  }
  return unused;
}
}
