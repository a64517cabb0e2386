// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Meshes/Fields.h"
#include "Meshes/Surfaces.h"
#include "Soup/JoinedSets.h"
#include "Streamlines.h"
#include "Streamlines/MotorcycleGraph.h"
#include "Streamlines/TracedStreamline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <vector>

using namespace DirectionFields;

namespace
{
/// The graph of the field of a closed surface of one component.
struct Graph
{
  Graph(const Surface& surface, int degree)
    : Computed(Fields::Compute(surface, degree))
    , Field(surface, Fields::Of(this->Computed))
    , Zeros(this->Field)
  {
    std::vector<ZeroRay> rays;
    for (Index i = 0; i < static_cast<Index>(this->Zeros.GetZeros().size()); ++i)
    {
      const std::vector<ZeroRay> more = this->Zeros.Rays(i);
      rays.insert(rays.end(), more.begin(), more.end());
    }
    this->Rays = rays.size();
    const PieceLimit limit(this->Field.GetMesh().GetNumberOfTriangles());
    TracedField traced{ this->Field, this->Zeros, limit };
    traced.Capture = 0.1;
    this->Lines = TraceMotorcycleGraph(traced, rays, 1e4, Progress());
  }

  int EulerCharacteristic() const
  {
    const TriangleMesh& mesh = this->Field.GetMesh();
    return mesh.GetNumberOfVertices() - mesh.GetNumberOfEdges() + mesh.GetNumberOfTriangles();
  }

  Result Computed;
  GivenField Field;
  SingularPoints Zeros;
  std::size_t Rays;
  std::vector<TracedStreamline> Lines;
};

/// The parts that lines cut a surface into, by flood fill: parts of the edges of the mesh between
/// the lines that cross them are joined through each triangle wherever no line lies between.
class FloodFill
{
public:
  explicit FloodFill(const Graph& graph)
    : Mesh(graph.Field.GetMesh())
    , Geometry(graph.Field.GetGeometry())
    , OnEdge(this->Mesh.GetNumberOfEdges())
  {
    // Joined within a triangle: the lines through a singularity, and lines that end at
    // others.
    Index trees = 0;
    std::vector<std::vector<Index>> treeOf(graph.Lines.size());
    for (std::size_t i = 0; i < graph.Lines.size(); ++i)
    {
      Index triangle = None;
      for (const LinePiece& piece : graph.Lines[i].Pieces)
      {
        // A visit to a triangle is one tree: consecutive pieces in it hang together.
        trees += piece.Triangle != triangle ? 1 : 0;
        treeOf[i].push_back(trees - 1);
        if (piece.Triangle != triangle && triangle != None)
        {
          this->AddCrossing(piece, treeOf[i].back(), treeOf[i].back() - 1, triangle);
        }
        triangle = piece.Triangle;
      }
    }
    this->Trees.resize(trees);
    std::iota(this->Trees.begin(), this->Trees.end(), 0);
    std::map<Index, Index> treeAtZero;
    for (std::size_t i = 0; i < graph.Lines.size(); ++i)
    {
      const TracedStreamline& line = graph.Lines[i];
      for (int e = 0; e < 2; ++e)
      {
        const Index tree = e == 0 ? treeOf[i].front() : treeOf[i].back();
        if (line.Zeros[e] != None)
        {
          const auto [at, isNew] = treeAtZero.emplace(line.Zeros[e], tree);
          this->Inside += isNew || this->Join(at->second, tree) ? 0 : 1;
        }
      }
      if (line.Crossed[1] != None)
      {
        this->Inside += this->Join(treeOf[i].back(), this->TreeAt(graph, line, treeOf)) ? 0 : 1;
      }
    }
  }

  int Count()
  {
    // The intervals of the edges, numbered along these.
    std::vector<Index> first(1, 0);
    for (std::vector<Crossing>& crossings : this->OnEdge)
    {
      std::sort(crossings.begin(), crossings.end(),
        [](const Crossing& a, const Crossing& b) { return a.Part < b.Part; });
      first.push_back(first.back() + static_cast<Index>(crossings.size()) + 1);
    }
    std::vector<Index> intervals(first.back());
    std::iota(intervals.begin(), intervals.end(), 0);
    const auto join = [&](Index a, Index b) { intervals[Find(intervals, a)] = Find(intervals, b); };
    for (Index t = 0; t < this->Mesh.GetNumberOfTriangles(); ++t)
    {
      // Around the triangle: the interval after each crossing, and the tree of the crossing.
      std::vector<std::pair<Index, Index>> around;
      std::vector<Index> all;
      for (Index h = 3 * t; h < 3 * t + 3; ++h)
      {
        const Index e = this->Mesh.Edge(h);
        const auto count = static_cast<Index>(this->OnEdge[e].size());
        for (Index k = 0; k <= count; ++k)
        {
          const bool forward = this->Mesh.GivesDirection(h);
          all.push_back(first[e] + (forward ? k : count - k));
          const Index tree = k < count ? this->TreeOn(e, forward ? k : count - 1 - k, t) : None;
          around.emplace_back(all.back(), tree);
        }
      }
      // A corner of the triangle lies between two intervals that no line separates.
      const std::size_t size = around.size();
      std::map<Index, std::size_t> last;
      for (int round = 0; round < 2; ++round)
      {
        for (std::size_t k = 0; k < size; ++k)
        {
          const Index tree = around[k].second;
          if (tree == None)
          {
            join(around[k].first, around[(k + 1) % size].first);
            continue;
          }
          // Between this crossing and the last one of the same tree nothing of it separates.
          const auto found = last.find(tree);
          if (found != last.end())
          {
            join(around[(found->second + 1) % size].first, around[k].first);
          }
          last[tree] = k;
        }
      }
    }
    int count = this->Inside;
    for (Index i = 0; i < static_cast<Index>(intervals.size()); ++i)
    {
      count += intervals[i] == i ? 1 : 0;
    }
    return count;
  }

private:
  /// Where a line crosses an edge, and the trees on both sides, by triangle.
  struct Crossing
  {
    double Part;
    Index Triangle[2];
    Index Tree[2];
  };

  static Index Find(std::vector<Index>& sets, Index i)
  {
    while (sets[i] != i)
    {
      i = sets[i] = sets[sets[i]];
    }
    return i;
  }
  /// Returns whether they were apart.
  bool Join(Index a, Index b)
  {
    const Index first = Find(this->Trees, a);
    const Index second = Find(this->Trees, b);
    this->Trees[first] = second;
    return first != second;
  }

  /// @param piece the first one beyond the edge
  void AddCrossing(const LinePiece& piece, Index tree, Index treeBefore, Index before)
  {
    const FlatTriangle flat(this->Geometry, piece.Triangle);
    const std::array<double, 3> weights = flat.Weights(piece.Begin);
    // The edge opposite of the corner whose weight vanishes; of several the one that leads back.
    Index edge = None;
    double part = 0.0;
    double least = 1e300;
    for (int c = 0; c < 3; ++c)
    {
      const Index h = 3 * piece.Triangle + (c + 1) % 3;
      const Index twin = this->Mesh.Twin(h);
      if (twin != None && twin / 3 == before && std::abs(weights[c]) < least)
      {
        least = std::abs(weights[c]);
        edge = this->Mesh.Edge(h);
        part = weights[(c + 2) % 3];
        part = this->Mesh.GivesDirection(h) ? part : 1.0 - part;
      }
    }
    ASSERT_NE(edge, None);
    this->OnEdge[edge].push_back({ part, { piece.Triangle, before }, { tree, treeBefore } });
  }

  Index TreeOn(Index edge, Index crossing, Index triangle)
  {
    const Crossing& at = this->OnEdge[edge][crossing];
    return Find(this->Trees, at.Tree[at.Triangle[0] == triangle ? 0 : 1]);
  }

  /// The tree of the line that another one stops at, where it does.
  Index TreeAt(const Graph& graph, const TracedStreamline& line,
    const std::vector<std::vector<Index>>& treeOf) const
  {
    const LinePiece& last = line.Pieces.back();
    const std::vector<LinePiece>& pieces = graph.Lines[line.Crossed[1]].Pieces;
    double least = 1e300;
    Index tree = None;
    for (std::size_t k = 0; k < pieces.size(); ++k)
    {
      const LinePiece& piece = pieces[k];
      if (piece.Triangle != last.Triangle || &piece == &last)
      {
        continue;
      }
      const Complex along = piece.End - piece.Begin;
      const double length = std::norm(along);
      const double part = length > 0.0
        ? std::clamp(((last.End - piece.Begin) * std::conj(along)).real() / length, 0.0, 1.0)
        : 0.0;
      const double distance = std::abs(piece.Begin + part * along - last.End);
      if (distance < least)
      {
        least = distance;
        tree = treeOf[line.Crossed[1]][k];
      }
    }
    EXPECT_LT(least, 1e-7);
    return tree;
  }

  const TriangleMesh& Mesh;
  const SurfaceGeometry& Geometry;
  std::vector<std::vector<Crossing>> OnEdge;
  std::vector<Index> Trees;
  /// Parts within a single triangle, which no edge leads to: a line that joins a tree to itself closes one
  /// off.
  int Inside = 0;
};

int Merged(const Graph& graph)
{
  return static_cast<int>(graph.Rays - graph.Lines.size());
}
}

TEST(MotorcycleGraph, EnclosesAsManyPatchesAsTheFormulasSay)
{
  const std::vector<Surface> surfaces = { Meshes::DoubleTorus(),
    Meshes::FlatlySubdivided(Meshes::DoubleTorus(), 2), Meshes::ChamferedCube(2), Meshes::Potato(3),
    Meshes::Roughened(Meshes::Potato(3), 0.2, 2), Meshes::ChamferedCube(5), Meshes::Potato(2),
    Meshes::Roughened(Meshes::Torus(30, 20), 0.3, 6) };
  int quads = 0;
  for (const Surface& surface : surfaces)
  {
    const Graph graph(surface, 4);
    const auto singularities = static_cast<int>(graph.Zeros.GetZeros().size());
    const auto lines = static_cast<int>(graph.Lines.size());
    for (const TracedStreamline& line : graph.Lines)
    {
      EXPECT_TRUE(
        line.Ends[1] == StreamlineEnd::Crossing || line.Ends[1] == StreamlineEnd::Singularity)
        << static_cast<int>(line.Ends[1]);
    }
    const int patches = FloodFill(graph).Count();
    EXPECT_EQ(patches, graph.EulerCharacteristic() + lines - singularities)
      << graph.Field.GetMesh().GetNumberOfTriangles() << " triangles, " << singularities
      << " singularities";
    // All patches are quads: their corners are two at each crossing, and one between any two rays
    // of a singularity. A line that ends in a singularity is one of its rays.
    const auto crossings = std::count_if(graph.Lines.begin(), graph.Lines.end(),
      [](const TracedStreamline& line) { return line.Ends[1] == StreamlineEnd::Crossing; });
    if (lines - crossings == Merged(graph))
    {
      EXPECT_EQ(2 * crossings + static_cast<int>(graph.Rays), 4 * patches);
      ++quads;
    }
    if (crossings == lines)
    {
      EXPECT_EQ(3 * lines, 4 * patches);
    }
  }
  EXPECT_GE(quads, 3);
}

TEST(MotorcycleGraph, HasLinesBetweenTwoSingularitiesOnceOnSymmetricSurfaces)
{
  // Lines out of both run over one another: the same line, found twice.
  const Eigen::Matrix3d stretch = Eigen::Vector3d(1.5, 1.0, 0.7).asDiagonal();
  const Surface surface = Meshes::Transformed(Meshes::Icosphere(5), stretch, Vector3::Zero());
  const Graph graph(surface, 4);
  ASSERT_EQ(graph.Zeros.GetZeros().size(), 8u);
  EXPECT_EQ(graph.Rays, 24u);
  EXPECT_EQ(Merged(graph), 6);
  const auto between = std::count_if(graph.Lines.begin(), graph.Lines.end(),
    [](const TracedStreamline& line) { return line.Zeros[1] != None; });
  EXPECT_EQ(between, 6);
  EXPECT_EQ(FloodFill(graph).Count(), 12);
}

TEST(MotorcycleGraph, OfChamferedCubesHasTheEdgesAndFacesOfCubes)
{
  // Singularities lie on vertices, or almost: lines run into them from all triangles there.
  for (const int parts : { 2, 3, 4, 5, 6, 8, 12 })
  {
    const Graph graph(Meshes::ChamferedCube(parts), 4);
    EXPECT_EQ(graph.Zeros.GetZeros().size(), 8u);
    EXPECT_EQ(graph.Lines.size(), 12u) << parts;
    for (const TracedStreamline& line : graph.Lines)
    {
      EXPECT_NE(line.Zeros[1], None);
      // The line ends where the singularity is, in its triangle.
      const SingularPoint& zero = graph.Zeros.GetZeros()[std::max(line.Zeros[1], Index(0))];
      EXPECT_EQ(line.Pieces.back().Triangle, zero.Triangle);
      EXPECT_EQ(line.Pieces.back().End, zero.Place);
    }
    EXPECT_EQ(FloodFill(graph).Count(), 6) << parts;
  }
}

TEST(MotorcycleGraph, StopsLinesAtTrailsThatWereThereBefore)
{
  const Graph graph(Meshes::Roughened(Meshes::Potato(3), 0.2, 2), 4);
  int crossings = 0;
  for (const TracedStreamline& line : graph.Lines)
  {
    if (line.Crossed[1] != None)
    {
      ++crossings;
      EXPECT_EQ(line.Ends[1], StreamlineEnd::Crossing);
      EXPECT_LE(0.0, line.Length());
    }
  }
  EXPECT_GT(crossings, 10);
}

TEST(MotorcycleGraph, IsBoundedWhereLinesWindAround)
{
  // A spike, on which lines that set out side by side wind around thousands of times and would cross
  // each other in every triangle, had they not ended at their first crossings.
  Surface disk = Meshes::Disk(3);
  disk.Points[5] = Vector3(-4.375, 7.0625, -4.1875);
  disk.Points[36] = Vector3(-std::sqrt(1.0 / 3.0), 1.0 / 3.0, 0.0);
  disk.Triangles[27] = { 21, 8, 9 };
  disk.Triangles.push_back({ 2, 10, 3 });
  const Result computed = Fields::Compute(disk, 1);
  Surface torn;
  for (const Index point : computed.OriginalPoint)
  {
    torn.Points.push_back(disk.Points[point]);
  }
  torn.Triangles = computed.SplitTriangles.empty() ? disk.Triangles : computed.SplitTriangles;
  const GivenField field(torn, Fields::Of(computed));
  StreamlineOptions options;
  options.Seeds = SeedType::Singularities;
  options.StopAtCrossings = true;
  const Streamlines lines = TraceStreamlines(field, Fields::Of(computed), {}, options);
  EXPECT_EQ(lines.Length.size(), 4u);
  EXPECT_LT(lines.Points.size(), 1000u);
  for (const std::array<StreamlineEnd, 2>& ends : lines.Ends)
  {
    EXPECT_NE(ends[1], StreamlineEnd::Length);
  }
}
