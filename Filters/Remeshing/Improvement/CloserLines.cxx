// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Improvement/CloserLines.h"

#include "FaceMesh/LineCuts.h"
#include "Support/SortedEnds.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace DirectionFields::Internal
{
namespace
{
constexpr int Sweeps = 24;
/// Faces better than this may become worse by moves.
constexpr double GoodEnough = 0.4;
/// Edges shorter than this part of the wanted length are not split.
constexpr double ShortestSplit = 0.5;

class Spacing
{
public:
  Spacing(const VertexStars& faces, MovableFaces& places, const SmoothingDomain& domain)
    : Cells(faces)
    , Places(places)
    , Domain(domain)
  {
  }

  /// Returns whether it has moved.
  bool Move(Index v)
  {
    std::vector<Vector3>& points = this->Places.GetPoints();
    const std::vector<Index>& ends = this->Cells.LineEnds(v);
    const std::array<double, 2> before = this->StrayingAt(v);
    const double most = std::max(before[0], before[1]);
    if (!(most > this->Domain.MostStraying * this->Domain.EdgeLength[v]))
    {
      return false;
    }
    // An edge strays by the square of its length.
    const std::array<double, 2> roots = { std::sqrt(before[0]), std::sqrt(before[1]) };
    const Vector3 ahead = points[ends[roots[0] > roots[1] ? 0 : 1]] - points[v];
    const double both = (points[ends[0]] - points[v]).norm() + (points[ends[1]] - points[v]).norm();
    const double way =
      0.25 * both * std::abs(roots[0] - roots[1]) / ((roots[0] + roots[1]) * ahead.norm());
    if (!(way > 1e-3))
    {
      return false;
    }
    const std::vector<Index> around = this->Around(v);
    const std::vector<Seen> faces = this->See(around);
    std::vector<Vector3> old;
    for (const Index w : around)
    {
      old.push_back(points[w]);
    }
    points[v] = this->Places.Projected(v, points[v] + std::min(way, 0.5) * ahead, points);
    this->Relax(around);
    const std::array<double, 2> after = this->StrayingAt(v);
    const bool isBetter = std::max(after[0], after[1]) < most && this->AreAsGood(faces);
    for (std::size_t k = 0; !isBetter && k < around.size(); ++k)
    {
      points[around[k]] = old[k];
    }
    return isBetter;
  }

private:
  std::array<double, 2> StrayingAt(Index v) const
  {
    const ClosestPoints& line = this->Domain.Lines[this->Domain.Line[v] - 1];
    const std::vector<Vector3>& points = this->Places.GetPoints();
    const std::vector<Index>& ends = this->Cells.LineEnds(v);
    return { Straying(line, points[v], points[ends[0]]),
      Straying(line, points[v], points[ends[1]]) };
  }

  /// The vertex and all others of its faces, ascending.
  std::vector<Index> Around(Index v) const
  {
    std::vector<Index> around;
    for (const Index f : this->Cells.At(v))
    {
      const Faces::Face& face = this->Cells.Face(f);
      around.insert(around.end(), face.begin(), face.begin() + Faces::Size(face));
    }
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    return around;
  }

  /// Moves those that are on no line.
  void Relax(const std::vector<Index>& vertices)
  {
    std::vector<Index> free;
    std::copy_if(vertices.begin(), vertices.end(), std::back_inserter(free),
      [&](Index w) { return this->Domain.Line[w] == 0 && !this->Places.IsHub(w); });
    this->Places.Relax(free, 1);
  }

  /// A face before a move.
  struct Seen
  {
    Index Face;
    double Quality;
    Vector3 Normal;
  };

  Seen See(Index f) const
  {
    const std::vector<Vector3>& points = this->Places.GetPoints();
    const Faces::Face& face = this->Cells.Face(f);
    return { f, ScaledJacobian(points, face), AreaVector(points, face) };
  }

  /// The faces at vertices.
  std::vector<Seen> See(const std::vector<Index>& vertices) const
  {
    std::vector<Index> faces;
    for (const Index w : vertices)
    {
      faces.insert(faces.end(), this->Cells.At(w).begin(), this->Cells.At(w).end());
    }
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    std::vector<Seen> seen;
    std::transform(
      faces.begin(), faces.end(), std::back_inserter(seen), [&](Index f) { return this->See(f); });
    return seen;
  }

  /// Whether no face is turned over, and each as good as before, or good enough.
  bool AreAsGood(const std::vector<Seen>& faces) const
  {
    return std::all_of(faces.begin(), faces.end(),
      [&](const Seen& before)
      {
        const Seen now = this->See(before.Face);
        return now.Quality >= std::min(before.Quality, GoodEnough) &&
          now.Normal.dot(before.Normal) >= 0.0;
      });
  }

  const VertexStars& Cells;
  MovableFaces& Places;
  const SmoothingDomain& Domain;
};
}

void SpaceLines(const VertexStars& faces, MovableFaces& places, const SmoothingDomain& domain,
  const Progress& progress)
{
  std::vector<Index> vertices;
  for (Index v = 0; v < faces.GetNumberOfVertices(); ++v)
  {
    if (domain.Line[v] > 0 && faces.LineEnds(v).size() == 2 && !places.IsHub(v))
    {
      vertices.push_back(v);
    }
  }
  Spacing spacing(faces, places, domain);
  bool hasMoved = true;
  for (int k = 0; k < Sweeps && hasMoved; ++k)
  {
    hasMoved = false;
    for (const Index v : vertices)
    {
      hasMoved = spacing.Move(v) || hasMoved;
    }
    progress.Report((k + 1.0) / Sweeps);
  }
}

namespace
{
/// The edges of the lines of a mesh, in the order of the lines.
class OrderedLines
{
public:
  explicit OrderedLines(const FaceMesh& mesh)
    : At(mesh.Points.size())
  {
    for (const FaceMesh::LineEdge& edge : mesh.LineEdges)
    {
      const std::array<Index, 2> ends = { std::min(edge.Ends[0], edge.Ends[1]),
        std::max(edge.Ends[0], edge.Ends[1]) };
      if (edge.Line > 0 && this->Line.emplace(ends, edge.Line).second)
      {
        this->At[ends[0]].push_back(ends[1]);
        this->At[ends[1]].push_back(ends[0]);
      }
    }
    for (const bool isClosed : { false, true })
    {
      for (Index v = 0; v < static_cast<Index>(mesh.Points.size()); ++v)
      {
        for (const Index next : this->At[v])
        {
          if (isClosed || !this->IsInner(mesh, v))
          {
            this->Walk(mesh, v, next);
          }
        }
      }
    }
  }

  /// The lines one after the other; the lower vertex of an edge is its first.
  std::vector<std::vector<std::array<Index, 2>>> Chains;
  /// Of each edge.
  std::map<std::array<Index, 2>, Index> Line;

private:
  bool IsInner(const FaceMesh& mesh, Index v) const
  {
    return mesh.Vertices[v].Line > 0 && this->At[v].size() == 2;
  }

  void Walk(const FaceMesh& mesh, Index v, Index next)
  {
    std::vector<std::array<Index, 2>> chain;
    while (true)
    {
      const std::array<Index, 2> ends = SortedEnds(v, next);
      if (!this->Seen.emplace(ends, true).second)
      {
        break;
      }
      chain.push_back(ends);
      if (!this->IsInner(mesh, next))
      {
        break;
      }
      const Index after = this->At[next][this->At[next][0] == v ? 1 : 0];
      v = next;
      next = after;
    }
    if (!chain.empty())
    {
      this->Chains.push_back(std::move(chain));
    }
  }

  std::vector<std::vector<Index>> At;
  std::map<std::array<Index, 2>, bool> Seen;
};

/// The faces at each edge of lines.
std::map<std::array<Index, 2>, std::vector<Index>> FacesAtLines(
  const FaceMesh& mesh, const OrderedLines& lines)
{
  std::map<std::array<Index, 2>, std::vector<Index>> faces;
  for (std::size_t f = 0; f < mesh.Cells.Corners.size(); ++f)
  {
    const Faces::Face& face = mesh.Cells.Corners[f];
    const int size = Faces::Size(face);
    for (int c = 0; c < size; ++c)
    {
      const Index a = face[c];
      const Index b = face[(c + 1) % size];
      const std::array<Index, 2> ends = SortedEnds(a, b);
      if (lines.Line.count(ends) > 0)
      {
        faces[ends].push_back(static_cast<Index>(f));
      }
    }
  }
  return faces;
}
}

bool SplitLines(FaceMesh& mesh, const std::vector<ClosestPoints>& lines,
  const std::vector<double>& edgeLength, const CloseLines& wanted)
{
  const OrderedLines ordered(mesh);
  const auto faces = FacesAtLines(mesh, ordered);
  const std::vector<Vector3> points = mesh.Points;
  LineCuts cuts(mesh);
  bool hasSplit = false;
  for (const std::vector<std::array<Index, 2>>& chain : ordered.Chains)
  {
    // Evenly spaced edges would be the sum of these many.
    double more = 0.0;
    for (const std::array<Index, 2>& ends : chain)
    {
      const ClosestPoints& line = lines[ordered.Line.at(ends) - 1];
      const Vector3& a = points[ends[0]];
      const Vector3& b = points[ends[1]];
      const double length = 0.5 * (edgeLength[ends[0]] + edgeLength[ends[1]]);
      const double straying = Straying(line, a, b) / length;
      more = std::clamp(more + std::sqrt(straying / wanted.MostUnsplit) - 1.0, -0.5, 1.5);
      if (more < 0.5 || (b - a).norm() < ShortestSplit * length)
      {
        continue;
      }
      const LineCuts::Wall wall{ ends, faces.at(ends), ordered.Line.at(ends) };
      const Vector3 middle = line.Find(0.5 * (a + b)).Position;
      const bool isGood = std::all_of(wall.Faces.begin(), wall.Faces.end(),
        [&](Index f) { return cuts.QualityOf(f, ends, middle) >= wanted.LeastQuality; });
      if (isGood)
      {
        cuts.Cut(wall, middle);
        hasSplit = true;
        more -= 1.0;
      }
    }
  }
  return hasSplit;
}
}
