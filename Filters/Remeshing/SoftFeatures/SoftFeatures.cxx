// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SoftFeatures/SoftFeatures.h"

#include "Features/EdgeChains.h"
#include "Geometry/DihedralAngles.h"
#include "Refinement/LongEdges.h"
#include "SoftFeatures/FeaturesInNoise.h"
#include "SoftFeatures/LineRoom.h"
#include "SoftFeatures/Roughness.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// Degrees.
constexpr double LeastAngle = 15.0;
constexpr double MostAngle = 90.0;
/// Rims are bent by this part of the angle of features.
constexpr double SoftPart = 0.5;
/// Radians.
constexpr double Rounding = 1e-6;
/// How many times as much as the edges beside it an edge of a rim is bent.
constexpr double LeastContrast = 4.0;
/// The same for a whole rim that ends freely, unless it is straight on a surface that is mostly in
/// planes: creases of bodies without edges end so, too.
constexpr double FreeContrast = 24.0;
/// The distance of its ends as part of its length.
constexpr double Straight = 0.999;
/// Rims that end freely, or are closed, are as long as this, in faces, and others as this.
constexpr double LongEnough = 6.0;
constexpr double Shortest = 2.0;
/// Places on rims, in rooms.
constexpr double Spacing = 0.5;
/// The part of a rim that may be beside others.
constexpr double MostCrowded = 0.25;
/// Rims whose bends differ by less are about as sharp, radians.
constexpr double AsSharp = 0.05;
/// Rims that are dropped let others end freely, which are looked at again.
constexpr int MostRounds = 8;

double ToRadians(double degrees)
{
  return degrees * Pi / 180.0;
}

/// Edges of a rim one after the other, without any of a feature.
struct Rim
{
  std::vector<Index> Edges;
  double Length = 0.0;
  /// The means of the angles along it, and of those of the edges beside it.
  double Bend = 0.0;
  double BendBeside = 0.0;
  bool IsClosed = false;
  Vector3 Chord = Vector3::Zero();

  bool IsStraight() const { return this->Chord.norm() >= Straight * this->Length; }
};

/// What is at the end of a rim.
enum class End
{
  /// No line goes on.
  Free,
  /// Lines meet, or the boundary is there.
  Meeting,
  /// A single feature goes on.
  Feature
};

class Finder
{
public:
  Finder(const SurfaceGeometry& geometry, const std::vector<char>& isFeature,
    const SoftFeatureSettings& settings)
    : Geometry(geometry)
    , Mesh(geometry.Mesh)
    , IsFeature(isFeature)
    , Wanted(settings)
    , Bend(DihedralAngles(geometry))
    , IsRim(geometry.Mesh.GetNumberOfEdges(), 0)
  {
    for (double& bend : this->Bend)
    {
      bend = std::abs(bend);
    }
  }

  SoftFeatures Run()
  {
    SoftFeatures found;
    if (this->Mark())
    {
      this->IsOfPlanes = IsMostlyFlat(this->Geometry);
      std::vector<Rim> rims = this->DropFree();
      found.DependsOnRoom = !rims.empty();
      this->DropCrowded(std::move(rims));
      rims = this->DropFree();
      found.IsRim = rims.empty() ? std::vector<char>() : std::move(this->IsRim);
    }
    return found;
  }

private:
  const Vector3& PlaceOf(Index v) const { return this->Geometry.Positions[v]; }
  double LengthOf(Index e) const
  {
    const Index h = this->Mesh.HalfEdge(e);
    return (this->PlaceOf(this->Mesh.Head(h)) - this->PlaceOf(this->Mesh.Tail(h))).norm();
  }

  /// The mean angle of the edges of an edge's triangles that are no feature, and not itself.
  double BendBeside(Index e) const
  {
    const Index h = this->Mesh.HalfEdge(e);
    double sum = 0.0;
    double length = 0.0;
    for (const Index side : { h, this->Mesh.Twin(h) })
    {
      for (const Index other : { TriangleMesh::Next(side), TriangleMesh::Previous(side) })
      {
        const Index beside = this->Mesh.Edge(other);
        if (this->IsFeature[beside] == 0)
        {
          sum += this->LengthOf(beside) * this->Bend[beside];
          length += this->LengthOf(beside);
        }
      }
    }
    return length > 0.0 ? sum / length : 0.0;
  }

  double Area() const
  {
    const auto& lengths = this->Geometry.Lengths;
    double area = 0.0;
    for (std::size_t c = 0; c < lengths.ComponentArea.size(); ++c)
    {
      area += lengths.ComponentArea[c] * lengths.Unit[c] * lengths.Unit[c];
    }
    return area;
  }

  /// Marks edges that may belong to rims. Returns whether there are any, but not so many that no
  /// face would fit between them.
  bool Mark()
  {
    double length = 0.0;
    for (Index e = 0; e < this->Mesh.GetNumberOfEdges(); ++e)
    {
      const bool isBent = this->IsFeature[e] == 0 &&
        this->Bend[e] > this->Wanted.LeastBend - Rounding &&
        this->Mesh.Twin(this->Mesh.HalfEdge(e)) != None;
      if (isBent && this->Bend[e] >= LeastContrast * this->BendBeside(e))
      {
        this->IsRim[e] = 1;
        length += this->LengthOf(e);
      }
    }
    return length > 0.0 && length * this->Wanted.Face < this->Area();
  }

  /// The rims of a chain between its features, with what is at their ends.
  template <typename Visit>
  void ForRims(const EdgeChain& chain, const std::vector<int>& lines, const Visit& visit) const
  {
    const std::size_t count = chain.Edges.size();
    const auto isRim = [&](std::size_t i) { return this->IsRim[chain.Edges[i % count]] != 0; };
    std::size_t first = 0;
    while (chain.IsClosed && first < count && isRim(first))
    {
      ++first;
    }
    // A closed one begins at a feature, if there is any.
    first %= count;
    const auto endAt = [&](std::size_t i)
    {
      const Index v = chain.Vertices[i];
      return this->Mesh.IsBoundary(v) || lines[v] != 1 ? End::Meeting : End::Free;
    };
    for (std::size_t i = first; i < first + count;)
    {
      if (!isRim(i))
      {
        ++i;
        continue;
      }
      Rim rim;
      const std::size_t begin = i;
      for (; i < first + count && isRim(i); ++i)
      {
        const Index e = chain.Edges[i % count];
        rim.Edges.push_back(e);
        rim.Length += this->LengthOf(e);
        rim.Bend += this->LengthOf(e) * this->Bend[e];
        rim.BendBeside += this->LengthOf(e) * this->BendBeside(e);
      }
      rim.Bend /= rim.Length > 0.0 ? rim.Length : 1.0;
      rim.BendBeside /= rim.Length > 0.0 ? rim.Length : 1.0;
      const bool isWhole = rim.Edges.size() == count;
      rim.IsClosed = chain.IsClosed && isWhole;
      const End from = rim.IsClosed       ? End::Meeting
        : begin > first || chain.IsClosed ? End::Feature
                                          : endAt(0);
      const End to = rim.IsClosed             ? End::Meeting
        : i < first + count || chain.IsClosed ? End::Feature
                                              : endAt(count);
      rim.Chord = this->PlaceOf(chain.Vertices[i > count ? i - count : i]) -
        this->PlaceOf(chain.Vertices[begin % count]);
      visit(std::move(rim), from, to);
    }
  }

  bool IsKept(const Rim& rim, End from, End to) const
  {
    if (from == End::Feature && to == End::Feature)
    {
      return true;
    }
    // What is sharper, and no feature, is noise.
    if (from == End::Feature || to == End::Feature || rim.Bend > this->Wanted.MostBend)
    {
      return false;
    }
    const bool endsFreely = from == End::Free || to == End::Free;
    const double shortest = endsFreely || rim.IsClosed ? LongEnough : Shortest;
    return rim.Length >= shortest * this->Wanted.Face &&
      (!endsFreely || (this->IsOfPlanes && rim.IsStraight()) ||
        rim.Bend >= FreeContrast * rim.BendBeside);
  }

  /// Returns the rims that are left.
  std::vector<Rim> DropFree()
  {
    std::vector<Rim> rims;
    for (int k = 0; k < MostRounds && this->DropRound(rims); ++k)
    {
    }
    return rims;
  }

  /// Returns whether any was dropped.
  bool DropRound(std::vector<Rim>& rims)
  {
    rims.clear();
    std::vector<char> isLine = this->IsRim;
    std::vector<int> lines(this->Mesh.GetNumberOfVertices(), 0);
    for (Index e = 0; e < this->Mesh.GetNumberOfEdges(); ++e)
    {
      isLine[e] = isLine[e] != 0 || this->IsFeature[e] != 0 ? 1 : 0;
      lines[this->Mesh.Tail(this->Mesh.HalfEdge(e))] += isLine[e];
      lines[this->Mesh.Head(this->Mesh.HalfEdge(e))] += isLine[e];
    }
    std::vector<Index> dropped;
    for (const EdgeChain& chain : ChainsOf(this->Mesh, isLine))
    {
      this->ForRims(chain, lines,
        [&](Rim&& rim, End from, End to)
        {
          if (this->IsKept(rim, from, to))
          {
            rims.push_back(std::move(rim));
          }
          else
          {
            dropped.insert(dropped.end(), rim.Edges.begin(), rim.Edges.end());
          }
        });
    }
    for (const Index e : dropped)
    {
      this->IsRim[e] = 0;
    }
    return !dropped.empty();
  }

  void AppendPlaces(Index e, const LineRoom& room, std::vector<LineRoom::Place>& places) const
  {
    const Index h = this->Mesh.HalfEdge(e);
    Vector3 normal = Vector3::Zero();
    for (const Index side : { h, this->Mesh.Twin(h) })
    {
      if (side != None)
      {
        const Vector3& tail = this->PlaceOf(this->Mesh.Tail(side));
        const Vector3& apex = this->PlaceOf(this->Mesh.Tail(TriangleMesh::Previous(side)));
        normal +=
          (this->PlaceOf(this->Mesh.Head(side)) - tail).cross(apex - tail).stableNormalized();
      }
    }
    room.AppendPlaces(this->PlaceOf(this->Mesh.Tail(h)), this->PlaceOf(this->Mesh.Head(h)),
      normal.stableNormalized(), places);
  }

  std::vector<LineRoom::Place> PlacesOf(const std::vector<Index>& edges, const LineRoom& room) const
  {
    std::vector<LineRoom::Place> places;
    for (const Index e : edges)
    {
      this->AppendPlaces(e, room, places);
    }
    return places;
  }

  /// Features and the boundary.
  std::vector<Index> FeatureEdges() const
  {
    std::vector<Index> edges;
    for (Index e = 0; e < this->Mesh.GetNumberOfEdges(); ++e)
    {
      if (this->IsFeature[e] != 0 || this->Mesh.Twin(this->Mesh.HalfEdge(e)) == None)
      {
        edges.push_back(e);
      }
    }
    return edges;
  }

  /// Of rims beside each other leaves the sharper ones, and of those that are as sharp the ones
  /// beside the fewest others: the outer ones of a fillet. None is left beside a feature.
  void DropCrowded(std::vector<Rim>&& rims)
  {
    LineRoom all(this->Wanted.Room, Spacing * this->Wanted.Room);
    LineRoom kept = all;
    kept.Add(this->PlacesOf(this->FeatureEdges(), kept), None);
    for (std::size_t k = 0; k < rims.size(); ++k)
    {
      all.Add(this->PlacesOf(rims[k].Edges, all), static_cast<Index>(k));
    }
    struct Rank
    {
      std::size_t Rim;
      Index Sharpness;
      std::size_t Neighbours;
    };
    std::vector<Rank> ranks;
    for (std::size_t k = 0; k < rims.size(); ++k)
    {
      const auto sharpness = static_cast<Index>(std::lround(rims[k].Bend / AsSharp));
      ranks.push_back({ k, sharpness, all.LinesBeside(this->PlacesOf(rims[k].Edges, all)).size() });
    }
    std::stable_sort(ranks.begin(), ranks.end(),
      [](const Rank& a, const Rank& b)
      {
        return std::make_tuple(-a.Sharpness, a.Neighbours) <
          std::make_tuple(-b.Sharpness, b.Neighbours);
      });
    for (const Rank& rank : ranks)
    {
      const std::vector<LineRoom::Place> places = this->PlacesOf(rims[rank.Rim].Edges, kept);
      if (kept.CrowdedPart(places) <= MostCrowded)
      {
        kept.Add(places, static_cast<Index>(rank.Rim));
        continue;
      }
      for (const Index e : rims[rank.Rim].Edges)
      {
        this->IsRim[e] = 0;
      }
    }
  }

  const SurfaceGeometry& Geometry;
  const TriangleMesh& Mesh;
  const std::vector<char>& IsFeature;
  const SoftFeatureSettings& Wanted;
  std::vector<double> Bend;
  std::vector<char> IsRim;
  bool IsOfPlanes = false;
};
}

SoftFeatureSettings::SoftFeatureSettings(const FeatureSettings& features, double face, double room)
  : LeastBend(ToRadians(std::max(LeastAngle, SoftPart * features.Angle)))
  , MostBend(features.AreKept && features.Angle <= MostAngle ? ToRadians(features.Angle) : 0.0)
  , Face(face)
  , Room(room)
{
}

SoftFeatures FindSoftFeatures(const SurfaceGeometry& geometry, const std::vector<char>& isFeature,
  const SoftFeatureSettings& settings)
{
  return settings.AreKept() ? Finder(geometry, isFeature, settings).Run() : SoftFeatures();
}

AllFeatures FindAllFeatures(const SurfaceGeometry& geometry, const FeatureSettings& settings,
  const std::vector<char>& isHard, double face, double room)
{
  // Soft features do not depend on which short ones a mesh could show, so that wanted lengths
  // within a factor of two share them.
  FeatureSettings ofAnyLength = settings;
  ofAnyLength.ShortestChain = 0.0;
  AllFeatures features;
  features.AreInNoise = settings.AreKept && HasNoise(geometry);
  features.All = features.AreInNoise ? FeaturesInNoise(geometry, settings)
                                     : FindFeatures(geometry, ofAnyLength, isHard);
  for (std::size_t e = 0; features.AreInNoise && e < isHard.size(); ++e)
  {
    features.All[e] = features.All[e] != 0 || isHard[e] != 0 ? 1 : 0;
  }
  features.Soft = FindSoftFeatures(geometry, features.All, { settings, face, room });
  std::vector<char> stays = isHard;
  if (!features.Soft.IsRim.empty())
  {
    stays.resize(features.All.size(), 0);
    for (std::size_t e = 0; e < stays.size(); ++e)
    {
      features.All[e] = features.All[e] != 0 || features.Soft.IsRim[e] != 0 ? 1 : 0;
      stays[e] = stays[e] != 0 || features.Soft.IsRim[e] != 0 ? 1 : 0;
    }
  }
  if (settings.AreKept)
  {
    DropShortFeatures(geometry, settings, features.All, stays);
  }
  return features;
}
}
