// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Improvement/ValenceOptimization.h"

#include "FaceMesh/FaceRules.h"

#include <algorithm>

namespace DirectionFields::Internal
{
namespace
{
constexpr int Passes = 4;
/// Length of a sequence of edits, and the penalty that all but the last one may add.
constexpr int MostEdits = 3;
constexpr int Slack = 10;
/// Number of edits tried for a vertex, and of sequences tried in space.
constexpr int MostTried = 4000;
constexpr int MostLooks = 16;
/// Faces are as good as they need be from this scaled Jacobian on.
constexpr double GoodEnough = 0.3;
/// New faces are at least as good as this.
constexpr double Least = 0.2;
constexpr int Moves = 6;
/// Middles of faces are to be as near the surface as this, in lengths of edges.
constexpr double FarthestMiddle = 0.5;
constexpr double FarthestMiddleOfTriangle = 0.3;
/// And triangles to the vertices that have gone, as a tip of three that goes is lost.
constexpr double FarthestGone = 0.2;

class Cleanup
{
public:
  Cleanup(VertexStars& faces, MovableFaces& places, std::vector<FaceEdits::Rule> rules, int degree)
    : Cells(faces)
    , Places(places)
    , AreTriangles(degree == 6)
    , Edits(faces, std::move(rules), &places, degree)
    , IsHopeless(faces.GetNumberOfVertices(), 0)
    , IsNearHub(FindVerticesNearHubs(faces, places))
  {
  }

  bool IsSeed(Index v) const
  {
    const std::vector<Index>& star = this->Cells.At(v);
    const bool hasTriangle = !this->AreTriangles &&
      std::any_of(
        star.begin(), star.end(), [&](Index f) { return Faces::Size(this->Cells.Face(f)) == 3; });
    return this->IsHopeless[v] == 0 && this->IsNearHub[v] == 0 &&
      (hasTriangle || this->Edits.Irregularity(v) > 0);
  }

  /// Returns whether something was found for a vertex.
  bool Improve(Index v)
  {
    this->Tried = 0;
    this->Looks = 0;
    this->Start = this->Cells.GetChanges().size();
    for (int edits = 1; edits <= MostEdits; ++edits)
    {
      if (this->Search({ v }, 0, edits))
      {
        for (const Index w : this->Cells.TouchedSince(this->Start))
        {
          this->IsHopeless[w] = 0;
          for (const Index u : this->Cells.Neighbours(w))
          {
            this->IsHopeless[u] = 0;
          }
        }
        return true;
      }
    }
    this->IsHopeless[v] = 1;
    return false;
  }

private:
  /// Tries edits at vertices, best first; the last edit of a sequence must lower the penalty.
  bool Search(const std::vector<Index>& vertices, int grown, int edits)
  {
    struct Candidate
    {
      int Grown;
      FaceEdits::Edit Edit;
    };
    std::vector<Candidate> candidates;
    for (const Index v : vertices)
    {
      if (this->IsNearHub[v] != 0)
      {
        continue;
      }
      for (const FaceEdits::Edit& edit : this->Edits.Find(v))
      {
        const int now = grown + this->Edits.GrowthBy(edit);
        if (now <= (edits == 1 ? -1 : Slack))
        {
          candidates.push_back({ now, edit });
        }
      }
    }
    std::stable_sort(candidates.begin(), candidates.end(),
      [](const Candidate& a, const Candidate& b) { return a.Grown < b.Grown; });
    for (const Candidate& candidate : candidates)
    {
      if (this->Tried == MostTried || this->Looks == MostLooks)
      {
        return false;
      }
      ++this->Tried;
      const std::size_t before = this->Cells.GetChanges().size();
      if (!this->Edits.Do(candidate.Edit))
      {
        continue;
      }
      if (edits == 1 ? this->Settle()
                     : this->Search(this->IrregularSince(before), candidate.Grown, edits - 1))
      {
        return true;
      }
      this->Cells.UndoTo(before);
    }
    return false;
  }

  std::vector<Index> IrregularSince(std::size_t change) const
  {
    std::vector<Index> touched = this->Cells.TouchedSince(change);
    touched.erase(std::remove_if(touched.begin(), touched.end(),
                    [&](Index v) { return this->Edits.Irregularity(v) == 0; }),
      touched.end());
    return touched;
  }

  /// Moves the vertices of changed faces. Puts them back and returns false if the faces are not as
  /// good as before.
  bool Settle()
  {
    ++this->Looks;
    const std::vector<Index> touched = this->Cells.TouchedSince(this->Start);
    std::vector<Vector3>& points = this->Places.GetPoints();
    double before = GoodEnough;
    const std::vector<VertexStars::Change>& changes = this->Cells.GetChanges();
    for (std::size_t k = this->Start; k < changes.size(); ++k)
    {
      // Later changes of a face tell of faces that were never there, which are no better.
      if (changes[k].Corners[0] != None)
      {
        before = std::min(before, ScaledJacobian(points, changes[k].Corners));
      }
    }
    std::vector<Vector3> start;
    for (const Index v : touched)
    {
      start.push_back(points[v]);
    }
    this->Places.Relax(touched, Moves);
    double after = 1.0;
    for (const Index v : touched)
    {
      after = std::min(after, this->Cells.At(v).empty() ? 1.0 : this->Places.LeastQuality(v));
    }
    if (after >= std::max(before, Least) && this->AreNear(touched) &&
      this->KeepTips(touched, start))
    {
      return true;
    }
    for (std::size_t k = 0; k < touched.size(); ++k)
    {
      points[touched[k]] = start[k];
    }
    return false;
  }

  /// Whether the middles of the faces that were changed are near the surface.
  bool AreNear(const std::vector<Index>& touched) const
  {
    return std::all_of(touched.begin(), touched.end(),
      [&](Index v)
      {
        return this->Cells.At(v).empty() ||
          this->Places.LargestDistance(v) <=
          (this->AreTriangles ? FarthestMiddleOfTriangle : FarthestMiddle);
      });
  }

  /// Whether the places of vertices that have gone are near the faces.
  bool KeepTips(const std::vector<Index>& touched, const std::vector<Vector3>& places) const
  {
    for (std::size_t k = 0; this->AreTriangles && k < touched.size(); ++k)
    {
      if (this->Cells.At(touched[k]).empty() &&
        this->Places.DistanceFrom(touched, touched[k], places[k]) > FarthestGone)
      {
        return false;
      }
    }
    return true;
  }

  VertexStars& Cells;
  MovableFaces& Places;
  bool AreTriangles;
  FaceEdits Edits;
  /// Nothing was found for a vertex, and nothing has changed around it since.
  std::vector<char> IsHopeless;
  /// A vertex with many faces is near.
  std::vector<char> IsNearHub;
  std::size_t Start = 0;
  int Tried = 0;
  int Looks = 0;
};
}

void OptimizeValences(VertexStars& faces, MovableFaces& places,
  const std::vector<FaceMesh::Vertex>& vertices, int degree, const Progress& progress)
{
  Cleanup cleanup(faces, places, RulesFor(faces, places, vertices, degree), degree);
  bool hasChanged = true;
  for (int k = 0; k < Passes && hasChanged; ++k)
  {
    hasChanged = false;
    for (Index v = 0; v < faces.GetNumberOfVertices(); ++v)
    {
      hasChanged = (cleanup.IsSeed(v) && cleanup.Improve(v)) || hasChanged;
    }
    progress.Report((k + 1.0) / Passes);
  }
}
}
