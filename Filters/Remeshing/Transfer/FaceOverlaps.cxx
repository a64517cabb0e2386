// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Transfer/FaceOverlaps.h"

#include "Distance/ClosestPoints.h"
#include "FaceMesh/Faces.h"
#include "Support/Threads.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace DirectionFields
{
namespace
{
/// Triangles that are searched for by one thread at a time.
constexpr Index PieceSize = 256;
/// Parts are smaller than this share of the faces around, and needles than the other one, so that
/// there are no more than its inverse a face.
constexpr double LargestPart = 1.0 / 16.0;
constexpr double SmallestNeedle = 1.0 / 256.0;
/// A part that is large for the face at its middle is halved so often before the next search.
constexpr int MostUnsearched = 3;
/// Faces count as no smaller than this, in squares of wanted edges, so that those without area do
/// not ask for parts without end.
constexpr double SmallestFace = 1.0 / 256.0;
/// Faces that look the other way are taken where no other is as near as this, in wanted edges.
constexpr double NearFace = 0.5;

/// The faces of one region, for searches.
struct SearchedFaces
{
  std::vector<ClosestPoints::Corners> Corners;
  std::vector<Index> Face;
};

/// The mesh, or what of it is searched, in the unit of areas.
struct ScaledMesh
{
  explicit ScaledMesh(const RemeshResult& mesh)
    : Unit(UnitOfAreas(mesh))
    , EdgeLength(mesh.EdgeLength / Unit)
    , Mesh(mesh)
  {
    this->Points.reserve(mesh.Points.size());
    for (const Vector3& point : mesh.Points)
    {
      this->Points.emplace_back(point / this->Unit);
    }
  }

  double Unit;
  double EdgeLength;
  std::vector<Vector3> Points;
  const RemeshResult& Mesh;
};

/// Adds a face as triangles around its middle.
void AddFace(const ScaledMesh& scaled, Index f, SearchedFaces& faces)
{
  const Faces::Face& face = scaled.Mesh.Faces[f];
  const std::vector<Vector3>& points = scaled.Points;
  const int size = Faces::Size(face);
  const Vector3 middle = MiddleOf(points, face);
  for (int c = 0; c < size; ++c)
  {
    faces.Corners.push_back({ points[face[c]], points[face[(c + 1) % size]], middle });
    faces.Face.push_back(f);
  }
}

/// Part of a triangle that a face covers.
struct Part
{
  Index Face;
  Index Triangle;
  double Area;
};

/// Finds the faces of a region that parts of triangles belong to.
class Search
{
public:
  Search(const ScaledMesh& mesh, SearchedFaces&& faces)
    : Limit(NearFace * mesh.EdgeLength)
    , Face(std::move(faces.Face))
    , Tree(std::move(faces.Corners))
  {
    const double least = SmallestFace * mesh.EdgeLength * mesh.EdgeLength;
    for (const Index f : this->Face)
    {
      this->Area.push_back(std::max(least, AreaOf(mesh.Points, mesh.Mesh.Faces[f])));
    }
  }

  /// Adds the parts of a triangle, those of one face together.
  void Divide(const ClosestPoints::Corners& corners, Index triangle, std::vector<Part>& parts) const
  {
    const std::size_t first = parts.size();
    const Vector3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    Index last = None;
    std::vector<Piece> waiting = { { corners, 0.0, 0 } };
    while (!waiting.empty())
    {
      Piece piece = waiting.back();
      waiting.pop_back();
      const ClosestPoints::Corners& at = piece.Corners;
      const double area = 0.5 * (at[1] - at[0]).cross(at[2] - at[0]).norm();
      Index found = None;
      if (piece.Unsearched == 0 || !IsLarge(piece, area))
      {
        found = this->Find((at[0] + at[1] + at[2]) / 3.0, normal, last);
        piece.Around = found == None ? 0.0 : this->Area[found];
        piece.Unsearched = MostUnsearched;
      }
      if (!(piece.Around > 0.0) || !(area > 0.0))
      {
        continue;
      }
      if (!IsLarge(piece, area))
      {
        parts.push_back({ this->Face[found], triangle, area });
        continue;
      }
      const int longest = LongestEdge(at);
      const Vector3& a = at[longest];
      const Vector3& b = at[(longest + 1) % 3];
      const Vector3& opposite = at[(longest + 2) % 3];
      const Vector3 middle = 0.5 * (a + b);
      waiting.push_back({ { middle, b, opposite }, piece.Around, piece.Unsearched - 1 });
      waiting.push_back({ { a, middle, opposite }, piece.Around, piece.Unsearched - 1 });
    }
    Gather(first, parts);
  }

private:
  /// A part of a triangle that may be too large.
  struct Piece
  {
    ClosestPoints::Corners Corners;
    /// The area of the last face found around it.
    double Around;
    /// How often it may be halved until the next search.
    int Unsearched;
  };

  static bool IsLarge(const Piece& piece, double area)
  {
    const int longest = LongestEdge(piece.Corners);
    const double square = (piece.Corners[(longest + 1) % 3] - piece.Corners[longest]).squaredNorm();
    return area > LargestPart * piece.Around ||
      (area > SmallestNeedle * piece.Around && square > 0.25 * piece.Around);
  }

  static int LongestEdge(const ClosestPoints::Corners& part)
  {
    int longest = 0;
    for (int c = 1; c < 3; ++c)
    {
      const bool isLonger = (part[(c + 1) % 3] - part[c]).squaredNorm() >
        (part[(longest + 1) % 3] - part[longest]).squaredNorm();
      longest = isLonger ? c : longest;
    }
    return longest;
  }

  /// The triangle of the tree that is closest to a place; None without faces.
  Index Find(const Vector3& place, const Vector3& normal, Index& last) const
  {
    ClosestPoints::Answer at = this->Tree.Find(place, normal, this->Limit, last);
    if (at.Triangle == None)
    {
      at = this->Tree.Find(place, Vector3::Zero(), std::numeric_limits<double>::infinity(), last);
    }
    last = at.Place;
    return at.Triangle;
  }

  /// Joins the parts from the first one on that are of the same face.
  static void Gather(std::size_t first, std::vector<Part>& parts)
  {
    std::stable_sort(parts.begin() + static_cast<std::ptrdiff_t>(first), parts.end(),
      [](const Part& a, const Part& b) { return a.Face < b.Face; });
    std::size_t end = first;
    for (std::size_t k = first; k < parts.size(); ++k)
    {
      if (end > first && parts[end - 1].Face == parts[k].Face)
      {
        parts[end - 1].Area += parts[k].Area;
      }
      else
      {
        parts[end++] = parts[k];
      }
    }
    parts.resize(end);
  }

  double Limit;
  /// Of the triangles of the tree.
  std::vector<Index> Face;
  std::vector<double> Area;
  ClosestPoints Tree;
};

std::map<Index, Search> SearchesOf(const ScaledMesh& mesh)
{
  const std::vector<Index>& regions = mesh.Mesh.Regions;
  std::map<Index, SearchedFaces> faces;
  for (std::size_t f = 0; f < mesh.Mesh.Faces.size(); ++f)
  {
    AddFace(mesh, static_cast<Index>(f), faces[regions.empty() ? 0 : regions[f]]);
  }
  std::map<Index, Search> searches;
  for (auto& [region, own] : faces)
  {
    searches.emplace(std::piecewise_construct, std::forward_as_tuple(region),
      std::forward_as_tuple(mesh, std::move(own)));
  }
  return searches;
}

/// The rows of the faces from the parts of the triangles in their order.
FaceOverlaps RowsOf(const std::vector<std::vector<Part>>& pieces, std::size_t faces)
{
  FaceOverlaps overlaps;
  overlaps.Offsets.assign(faces + 1, 0);
  for (const std::vector<Part>& parts : pieces)
  {
    for (const Part& part : parts)
    {
      ++overlaps.Offsets[part.Face + 1];
    }
  }
  for (std::size_t f = 0; f < faces; ++f)
  {
    overlaps.Offsets[f + 1] += overlaps.Offsets[f];
  }
  overlaps.Triangles.resize(overlaps.Offsets.back());
  overlaps.Areas.resize(overlaps.Offsets.back());
  std::vector<std::size_t> next(overlaps.Offsets.begin(), overlaps.Offsets.end() - 1);
  for (const std::vector<Part>& parts : pieces)
  {
    for (const Part& part : parts)
    {
      const std::size_t at = next[part.Face]++;
      overlaps.Triangles[at] = part.Triangle;
      overlaps.Areas[at] = part.Area;
    }
  }
  return overlaps;
}
}

double UnitOfAreas(const RemeshResult& mesh)
{
  const bool hasLength = mesh.EdgeLength > 0.0 && std::isfinite(mesh.EdgeLength);
  // The inverse of the smallest numbers is none.
  return hasLength ? std::ldexp(1.0, std::max(std::ilogb(mesh.EdgeLength), -1000)) : 1.0;
}

FaceOverlaps FindOverlaps(
  const Surface& surface, const RemeshResult& mesh, const std::vector<Index>& regions)
{
  const ScaledMesh scaled(mesh);
  const std::map<Index, Search> searches = SearchesOf(scaled);
  const auto count = static_cast<Index>(surface.Triangles.size());
  const auto points = static_cast<Index>(surface.Points.size());
  std::vector<std::vector<Part>> pieces(NumberOfPieces(count, PieceSize));
  ParallelFor(count, PieceSize,
    [&](Index begin, Index end)
    {
      for (Index t = begin; t < end; ++t)
      {
        const Triangle& corners = surface.Triangles[t];
        const bool isThere = std::all_of(
          corners.begin(), corners.end(), [points](Index p) { return p >= 0 && p < points; });
        const auto own = searches.find(mesh.Regions.empty() ? 0 : regions[t]);
        if (isThere && own != searches.end())
        {
          const auto at = [&](int c) -> Vector3
          { return surface.Points[corners[c]] / scaled.Unit; };
          own->second.Divide({ at(0), at(1), at(2) }, t, pieces[begin / PieceSize]);
        }
      }
    });
  FaceOverlaps overlaps = RowsOf(pieces, mesh.Faces.size());
  overlaps.Unit = scaled.Unit;
  return overlaps;
}
}
