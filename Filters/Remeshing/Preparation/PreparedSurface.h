// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_PreparedSurface_h
#define DirectionFields_PreparedSurface_h

#include "Charts/FeatureLines.h"
#include "Distance/ClosestPoints.h"
#include "Features/KeptFeatures.h"
#include "Geometry/SurfaceGeometry.h"
#include "Mesh/MergePoints.h"
#include "Preparation/FeaturePaths.h"
#include "Progress.h"
#include "SoftFeatures/SoftFeatures.h"
#include "Surface.h"

#include <map>
#include <memory>
#include <type_traits>
#include <vector>

namespace DirectionFields::Internal
{
/// How long the edges of a prepared surface are, in the unit of the input. Wanted lengths within a
/// factor of two share them.
struct WorkingLengths
{
  /// Longest edge that decimation makes at each point of the input; empty for no decimation.
  std::vector<double> Decimated;
  /// Longest edge at each point of the input that is not split; empty for no splitting.
  std::vector<double> Split;
  /// Of a usual face; a shorter step of a region's border may be one of stairs.
  double Face = 0.0;
  /// As HasNeedles. Edges are split whatever the surface is like then.
  bool HasNeedles = false;
  /// How many points splitting may add.
  Index MostMiddles = 0;
  /// How many singularities a field may have that the surface does not need, before the surface is
  /// smoothed for it; None where it never is.
  Index MostNeedless = None;

  bool operator==(const WorkingLengths& other) const
  {
    return this->Decimated == other.Decimated && this->Split == other.Split &&
      this->Face == other.Face && this->HasNeedles == other.HasNeedles &&
      this->MostMiddles == other.MostMiddles && this->MostNeedless == other.MostNeedless;
  }
};

/// What a mesh keeps of a surface: features by their shape, the borders of regions, curves, and
/// points.
struct KeptEdges
{
  // NOLINTNEXTLINE(google-explicit-constructor): features alone are enough.
  KeptEdges(const FeatureSettings& features, std::vector<Index> regions = {},
    std::vector<std::array<Index, 2>> curves = {}, std::vector<Index> points = {},
    double softRoom = 0.0)
    : Features(features)
    , Regions(std::move(regions))
    , Curves(std::move(curves))
    , Points(std::move(points))
    , SoftRoom(softRoom)
  {
  }
  FeatureSettings Features;
  /// The region of each triangle of the input; empty for one region. Edges between two of them are
  /// hard: kept whatever their shape.
  std::vector<Index> Regions;
  /// Edges of the input that are hard, too: the points at their ends, the lower one first,
  /// ascending.
  std::vector<std::array<Index, 2>> Curves;
  /// Points of the input that stay, ascending.
  std::vector<Index> Points;
  /// The room of features that are bent less and kept, too, as SoftFeatureSettings; 0 for none.
  double SoftRoom;

  bool HasHard() const { return !this->Regions.empty() || !this->Curves.empty(); }
};

/// A surface that can be mapped: connected across seams, one-sided components cut open, wound
/// consistently, with a point in the middle of each edge whose two ends have no frame
/// (FramelessVertices), with fewer triangles where they are much smaller than the wanted faces, and
/// with more where they are longer.
class PreparedSurface
{
public:
  /// Throws MeshError and Stopped.
  PreparedSurface(const Surface& input, int degree, const KeptEdges& kept,
    const WorkingLengths& lengths = {}, const Progress& progress = {});

  /// Its points are the input's, then copies of points where a one-sided component was cut open,
  /// then the middles of edges.
  const std::shared_ptr<const Surface>& GetSurface() const { return this->Prepared; }
  const SurfaceGeometry& GetGeometry() const { return *this->Geometry; }
  /// The places of its vertices before any smoothing.
  std::vector<Vector3> GetGivenPositions() const;
  /// Smooths it, but for its boundary and features.
  void Smooth(const std::vector<char>& isFeature, int steps);
  /// Moves its points to where they are on a surface that differs from it in nothing else.
  void MoveTo(const std::shared_ptr<const Surface>& surface)
  {
    this->Prepared = surface;
    this->Geometry = std::make_unique<const SurfaceGeometry>(*surface);
  }
  /// Of each of its points the one that it is a copy of, or itself.
  std::vector<Index> GetOriginals() const;
  const Repairs& GetRepairs() const { return this->Repaired; }

  /// Whether it was rough before its edges were split. Beside the halves of a triangle, which are
  /// flat, noise stands out as features do; so they are those found before.
  bool IsRough() const { return this->IsNoisy; }

  /// Not 0 for each edge of the prepared surface that is a feature.
  std::vector<char> FindFeatures(const FeatureSettings& settings) const;
  /// Whether they were told from noise (FeaturesInNoise).
  bool AreFeaturesInNoise() const { return this->IsInNoise; }
  /// Whether any of them is soft.
  bool HasSoft() const { return this->HasSoftFeatures; }
  /// Whether soft features would be others with another room.
  bool DependsOnRoom() const { return this->DoRimsNeedRoom; }
  /// Not 0 for each edge of the prepared surface between two regions, or on a curve; empty where
  /// there is only one region and no curve.
  std::vector<char> FindHard() const;
  /// The point of the input that each vertex of the prepared surface stands for, if it is one of
  /// those that stay, else None; empty where there are none of these.
  std::vector<Index> FindPoints() const;
  /// The vertices that stand for one.
  std::vector<Index> FindPointVertices() const;
  /// The part of the length of the borders of regions that runs in stairs, which are not kept.
  double GetStairs() const { return this->Stairs; }
  /// The points of the input along an edge of a feature or the boundary, from end to end.
  std::vector<Index> PathAlong(Index p, Index q) const;

  /// The segments of a feature, as triangles without area.
  std::vector<ClosestPoints::Corners> SegmentsOf(
    const SurfaceGeometry& geometry, const FeatureLines::Chain& chain) const;
  /// Those of each feature.
  std::vector<ClosestPoints> LinesOf(
    const SurfaceGeometry& geometry, const FeatureLines& features) const;

  /// Values at the input's points continued to the middles.
  template <typename T>
  std::vector<T> Continued(std::vector<T> values) const
  {
    for (const std::array<Index, 2>& ends : this->Middles)
    {
      if constexpr (std::is_same_v<T, double>)
      {
        values.push_back(0.5 * (values[ends[0]] + values[ends[1]]));
      }
      else
      {
        values.push_back(values[ends[0]]);
      }
    }
    return values;
  }

  /// Vectors at the input's points, continued to copies of these, and zero in the middles of edges.
  std::vector<Vector3> ContinuedToCopies(std::vector<Vector3> vectors) const
  {
    for (const std::array<Index, 2>& ends : this->Middles)
    {
      vectors.push_back(ends[0] == ends[1] ? vectors[ends[0]] : Vector3::Zero());
    }
    return vectors;
  }
  /// Whether edges were split since they were long.
  bool IsRefined() const { return this->HasLongSplit; }

  /// The triangles of the input, as far as they are used, wound consistently; smoothed as it is.
  std::vector<ClosestPoints::Corners> GetTriangles() const
  {
    return this->CornersOn(this->Prepared->Points);
  }
  /// The same where they were before any smoothing.
  std::vector<ClosestPoints::Corners> GetGivenTriangles() const
  {
    return this->CornersOn(this->GivenPoints.empty() ? this->Prepared->Points : this->GivenPoints);
  }
  /// Their points.
  std::vector<Triangle> GetUsedTriangles() const
  {
    std::vector<Triangle> triangles;
    for (const UsedTriangle& used : this->Used)
    {
      triangles.push_back(used.Points);
    }
    return triangles;
  }
  /// Not 0 for each triangle of the input that is used.
  std::vector<char> FindUsed(std::size_t inputTriangles) const
  {
    std::vector<char> isUsed(inputTriangles, 0);
    for (const UsedTriangle& used : this->Used)
    {
      isUsed[used.Input] = 1;
    }
    return isUsed;
  }
  /// Where a point of these is on the input.
  Index InputTriangle(Index triangle) const { return this->Used[triangle].Input; }
  std::array<double, 3> InputWeights(Index triangle, const std::array<double, 3>& weights) const
  {
    const UsedTriangle& used = this->Used[triangle];
    std::array<double, 3> own{};
    for (int c = 0; c < 3; ++c)
    {
      own[used.InputCorner[c]] = weights[c];
    }
    return own;
  }

private:
  struct UsedTriangle
  {
    Triangle Points;
    Index Input;
    std::array<int, 3> InputCorner;

    /// Triangle t of the mesh of the input.
    static UsedTriangle Of(Index t, const Surface& input, const MergedMesh& merged);
  };
  /// The point in the middle of each edge that is split, by the points at its ends.
  using MiddlePoints = std::map<std::array<Index, 2>, Index>;

  /// The surface of consistently wound triangles, one-sided components cut open.
  Surface CutOpen(const Surface& input, const MergedMesh& merged);
  /// Not 0 for the vertices of a mesh of this surface that stay; empty for none.
  std::vector<char> StayAt(const TriangleMesh& mesh) const;
  /// Returns the triangles that remain.
  std::vector<Triangle> Decimated(const SurfaceGeometry& geometry, const KeptEdges& kept,
    const std::vector<char>& isHard, const WorkingLengths& lengths, Surface& surface,
    const Progress& progress);
  AllFeatures FindAll(const SurfaceGeometry& geometry, const KeptEdges& kept,
    const std::vector<char>& isHard, const WorkingLengths& lengths);
  /// Of the features those that are kept whatever the settings say; empty for none.
  std::vector<char> FindHardAndSoft() const;
  std::vector<ClosestPoints::Corners> CornersOn(const std::vector<Vector3>& points) const;
  /// Noise lets features turn to and fro, which their lines in the field do not.
  void SmoothLines(const TriangleMesh& mesh, const std::vector<char>& isFeature,
    const std::vector<char>& isHard, Surface& surface);
  /// Adds the middles of edges.
  MiddlePoints AddMiddles(Surface& surface, const std::vector<char>& isSplit);
  /// Puts points in the middles of edges. Returns whether there were any.
  bool Split(Surface& surface, const std::vector<char>& isSplit);
  /// Splits edges that are too long, and turns others to Delaunay.
  void Refine(Surface& surface, const FeatureSettings& settings, const WorkingLengths& lengths);
  /// Splits the chords of SharpCorners.
  void SplitInSharpCorners(
    Surface& surface, int degree, const FeatureSettings& settings, double face);
  /// Returns whether any edge was split.
  bool SplitBetweenFrameless(Surface& surface, int degree, const FeatureSettings& settings);

  /// Features are those found before edges were collapsed or split.
  bool AreFeaturesFixed;
  bool IsNoisy = false;
  bool IsInNoise = false;
  bool HasLongSplit = false;
  bool HasHard = false;
  bool HasSoftFeatures = false;
  bool DoRimsNeedRoom = false;
  std::vector<Index> Points;
  double Stairs = 0.0;
  FeaturePaths Paths;
  std::vector<UsedTriangle> Used;
  std::vector<std::array<Index, 2>> Middles;
  std::shared_ptr<const Surface> Prepared;
  std::unique_ptr<const SurfaceGeometry> Geometry;
  /// Its points before it was smoothed; empty where it was not.
  std::vector<Vector3> GivenPoints;
  Repairs Repaired;
};
}

#endif
