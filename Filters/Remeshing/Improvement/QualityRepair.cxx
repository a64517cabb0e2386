// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Improvement/QualityRepair.h"

#include "FaceMesh/FaceRules.h"
#include "Improvement/WorstFaces.h"

#include <algorithm>
#include <optional>

namespace DirectionFields::Internal
{
namespace
{
constexpr int Passes = 3;
/// Repair at most 16 + n/64 of the n faces. Above that the surface is rough, or has no good map.
constexpr Index MostAnyway = 16;
constexpr Index OneOf = 64;
/// Faces with a scaled Jacobian below the first are repaired; above the second they are good
/// enough.
constexpr double Bad = 0.3;
constexpr double GoodEnough = 0.4;
/// Quality lost per irregular vertex (weight 10).
constexpr double PerGrowth = 0.004;
/// Smallest gain for which an edit is kept.
constexpr double LeastGain = 0.03;
/// Centers of faces are at most this far from the surface, in lengths of edges, unless they were
/// before.
constexpr double FarthestMiddle = 0.35;
/// First edits that are followed by a second one. Of triangles, which have more edits, those gain
/// little.
constexpr std::size_t MostPairs = 6;
constexpr int Moves = 6;
/// Number of edits that look best after a few moves and are tried thoroughly.
constexpr std::size_t MostLooks = 12;

class FaceRepairs
{
public:
  FaceRepairs(VertexStars& faces, MovableFaces& places, std::vector<FaceEdits::Rule> rules,
    bool mayMakeTriangles, int degree)
    : Cells(faces)
    , Places(places)
    , Edits(faces, std::move(rules), &places, degree)
    , IsNearHub(FindVerticesNearHubs(faces, places))
    , AreTriangles(degree == 6)
    , MayMakeTriangles(mayMakeTriangles || degree == 6)
  {
  }

  /// Vertices of edits are away from hubs.
  bool MayRepair(Index f) const
  {
    const Faces::Face& face = this->Cells.Face(f);
    return std::none_of(face.begin(), face.begin() + Faces::Size(face),
      [&](Index v)
      { return static_cast<std::size_t>(v) < this->IsNearHub.size() && this->IsNearHub[v] != 0; });
  }

  double Quality(Index f) const
  {
    const double quality = this->Places.Quality(this->Cells.Face(f));
    return this->AreTriangles && this->IsFolded(f) ? -std::abs(quality) : quality;
  }

  bool Repair(Index f)
  {
    const std::size_t start = this->Cells.GetChanges().size();
    std::vector<Trial> trials;
    this->GrownBefore = 0;
    this->RememberFolds(f);
    this->TryAll(this->CornersOf({ f }), {}, start, 0.0, trials);
    const auto isBetter = [](const Trial& a, const Trial& b) { return a.Gain > b.Gain; };
    std::stable_sort(trials.begin(), trials.end(), isBetter);
    const bool isEnough = !trials.empty() && trials.front().IsMended;
    if (!isEnough)
    {
      const std::size_t count = this->AreTriangles ? 0 : std::min(trials.size(), MostPairs);
      double best = trials.empty() ? 0.0 : trials.front().Gain;
      for (std::size_t k = 0; k < count; ++k)
      {
        const FaceEdits::Edit first = trials[k].Edits.front();
        this->GrownBefore = this->Edits.GrowthBy(first);
        if (this->Edits.Do(first))
        {
          best = std::max(best, LeastGain);
          this->TryAll(this->Cells.TouchedSince(start), { first }, start, best, trials);
          for (const Trial& trial : trials)
          {
            best = std::max(best, trial.Gain);
          }
        }
        this->Cells.UndoTo(start);
      }
      std::stable_sort(trials.begin(), trials.end(), isBetter);
    }
    if (trials.empty() || trials.front().Gain < LeastGain)
    {
      return false;
    }
    for (const FaceEdits::Edit& edit : trials.front().Edits)
    {
      this->Edits.Do(edit);
    }
    this->Settle(this->Cells.TouchedSince(start), true);
    return true;
  }

private:
  struct Trial
  {
    std::vector<FaceEdits::Edit> Edits;
    double Gain;
    /// No bad face is left.
    bool IsMended;
  };

  struct Look
  {
    FaceEdits::Edit Edit;
    int Grown;
    double Gain;
  };

  /// Whether a triangle looks to the other side than the faces around most of its corners.
  bool IsFolded(Index f) const
  {
    const Faces::Face& face = this->Cells.Face(f);
    const std::vector<Vector3>& points = this->Places.GetPoints();
    const Vector3 area = AreaVector(points, face);
    int against = 0;
    for (int c = 0; c < Faces::Size(face); ++c)
    {
      against += area.dot(this->Places.NormalAt(face[c], points)) < 0.0 ? 1 : 0;
    }
    return against > 1;
  }

  /// Of triangles only their vertices tell which are folded: edits need not mend the ones that are
  /// there before them.
  void RememberFolds(Index f)
  {
    this->Before.clear();
    if (!this->AreTriangles)
    {
      return;
    }
    constexpr int rings = 3;
    std::vector<Index> vertices = this->CornersOf({ f });
    for (int k = 0; k < rings; ++k)
    {
      vertices = this->CornersOf(this->FacesAround(vertices));
    }
    for (const Index v : vertices)
    {
      this->Before.emplace_back(v, this->Places.LeastQuality(v));
    }
  }

  double LeastBefore(const std::vector<Index>& vertices) const
  {
    double least = 1.0;
    for (const Index v : vertices)
    {
      const auto found =
        std::lower_bound(this->Before.begin(), this->Before.end(), std::pair(v, -2.0));
      least =
        found != this->Before.end() && found->first == v ? std::min(least, found->second) : least;
    }
    return least;
  }

  std::vector<Index> CornersOf(const std::vector<Index>& faces) const
  {
    std::vector<Index> corners;
    for (const Index f : faces)
    {
      const Faces::Face& face = this->Cells.Face(f);
      corners.insert(corners.end(), face.begin(), face.begin() + Faces::Size(face));
    }
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    return corners;
  }

  static bool IsSame(const FaceEdits::Edit& a, const FaceEdits::Edit& b)
  {
    return a.First == b.First && a.Second == b.Second && a.Diagonal == b.Diagonal;
  }

  /// Tries each edit of the faces at the vertices, after the edits that are already applied.
  void TryAll(const std::vector<Index>& vertices, const std::vector<FaceEdits::Edit>& done,
    std::size_t start, double least, std::vector<Trial>& trials)
  {
    std::vector<FaceEdits::Edit> edits;
    for (const Index v : vertices)
    {
      for (const auto& found : { this->Edits.Find(v), this->Edits.FindForBadFaces(v) })
      {
        std::copy_if(found.begin(), found.end(), std::back_inserter(edits),
          [&](const FaceEdits::Edit& edit)
          {
            return std::none_of(edits.begin(), edits.end(),
              [&](const FaceEdits::Edit& other) { return IsSame(edit, other); });
          });
      }
    }
    std::vector<Look> looks;
    const std::size_t before = this->Cells.GetChanges().size();
    for (const FaceEdits::Edit& edit : edits)
    {
      const int grown = this->Edits.GrowthBy(edit) + this->GrownBefore;
      if (this->Edits.Do(edit))
      {
        const bool mayBe = this->MayMakeTriangles || !this->HasTriangleSince(start);
        const std::optional<Trial> trial =
          mayBe ? this->Try(start, grown, least, false) : std::nullopt;
        if (trial)
        {
          looks.push_back({ edit, grown, trial->Gain });
        }
        this->Cells.UndoTo(before);
      }
    }
    std::stable_sort(
      looks.begin(), looks.end(), [](const Look& a, const Look& b) { return a.Gain > b.Gain; });
    looks.erase(looks.begin() + std::min(looks.size(), MostLooks), looks.end());
    for (const Look& look : looks)
    {
      this->Edits.Do(look.Edit);
      std::optional<Trial> trial = this->Try(start, look.Grown, least, true);
      if (trial)
      {
        trial->Edits = done;
        trial->Edits.push_back(look.Edit);
        trials.push_back(std::move(*trial));
      }
      this->Cells.UndoTo(before);
    }
  }

  bool HasTriangleSince(std::size_t start) const
  {
    const std::vector<VertexStars::Change>& changes = this->Cells.GetChanges();
    return std::any_of(changes.begin() + static_cast<std::ptrdiff_t>(start), changes.end(),
      [&](const VertexStars::Change& change)
      {
        return change.Face != None && this->Cells.IsFace(change.Face) &&
          Faces::Size(this->Cells.Face(change.Face)) == 3;
      });
  }

  /// How much is missing to good faces, and the worst one.
  struct Figures
  {
    double Missing = 0.0;
    double Least = 1.0;

    void Add(double quality)
    {
      this->Missing += std::max(0.0, GoodEnough - quality);
      this->Least = std::min(this->Least, quality);
    }
  };

  /// The faces that were changed, as they were.
  std::vector<Faces::Face> FacesBefore(std::size_t start, std::vector<Index>& changed) const
  {
    std::vector<Faces::Face> faces;
    const std::vector<VertexStars::Change>& changes = this->Cells.GetChanges();
    for (std::size_t k = start; k < changes.size(); ++k)
    {
      const VertexStars::Change& change = changes[k];
      // Later changes of a face record its states in between.
      if (change.Face != None &&
        std::find(changed.begin(), changed.end(), change.Face) == changed.end())
      {
        changed.push_back(change.Face);
        if (change.Corners[0] != None)
        {
          faces.push_back(change.Corners);
        }
      }
    }
    return faces;
  }
  std::vector<Index> FacesAround(const std::vector<Index>& vertices) const
  {
    std::vector<Index> around;
    for (const Index v : vertices)
    {
      around.insert(around.end(), this->Cells.At(v).begin(), this->Cells.At(v).end());
    }
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    return around;
  }

  /// The gain of the applied edits, or nothing if they are not allowed or gain too little.
  /// Everything stays in place.
  /// @param isThorough vertices are moved to better places, and the faces must be good enough
  std::optional<Trial> Try(std::size_t start, int grown, double least, bool isThorough)
  {
    std::vector<Vector3>& points = this->Places.GetPoints();
    const std::vector<Index> touched = this->Cells.TouchedSince(start);
    const std::vector<Index> around = this->FacesAround(touched);
    std::vector<Index> changed;
    std::vector<Faces::Face> facesBefore = this->FacesBefore(start, changed);
    for (const Index f : around)
    {
      if (std::find(changed.begin(), changed.end(), f) == changed.end())
      {
        facesBefore.push_back(this->Cells.Face(f));
      }
    }
    Figures before;
    for (const Faces::Face& face : facesBefore)
    {
      before.Add(this->Places.Quality(face));
    }
    before.Least = std::min(before.Least, this->LeastBefore(touched));
    if (before.Missing - PerGrowth * grown < least)
    {
      return {};
    }
    std::vector<Vector3> places;
    for (const Index v : touched)
    {
      places.push_back(points[v]);
    }
    this->Settle(touched, isThorough);
    Figures after;
    for (const Index v : touched)
    {
      // Triangles on the wrong side are seen from their vertices only.
      const bool isThere = !this->Cells.At(v).empty();
      after.Least = std::min(after.Least, isThere ? this->Places.LeastQuality(v) : 1.0);
    }
    for (const Index f : around)
    {
      after.Add(this->Quality(f));
    }
    const double gain = before.Missing - after.Missing - PerGrowth * grown;
    bool isGood = !isThorough || (after.Least >= before.Least && gain >= least);
    double farthest = 0.0;
    for (std::size_t k = 0; isThorough && isGood && k < around.size(); ++k)
    {
      farthest = std::max(farthest, this->Places.Distance(around[k]));
    }
    for (std::size_t k = 0; this->AreTriangles && isThorough && isGood && k < touched.size(); ++k)
    {
      isGood = !this->Cells.At(touched[k]).empty() ||
        this->Places.DistanceFrom(touched, touched[k], places[k]) <= FarthestMiddle;
    }
    for (std::size_t k = 0; k < touched.size(); ++k)
    {
      points[touched[k]] = places[k];
    }
    if (isGood && farthest > FarthestMiddle)
    {
      isGood = std::any_of(facesBefore.begin(), facesBefore.end(),
        [&](const Faces::Face& face) { return this->Places.Distance(face) >= farthest; });
    }
    return isGood ? std::optional<Trial>(Trial{ {}, gain, after.Least >= Bad }) : std::nullopt;
  }

  void Settle(const std::vector<Index>& vertices, bool isThorough)
  {
    this->Places.Relax(vertices, Moves);
    double size = 1.0;
    for (int k = 0; isThorough && k < Moves; ++k, size *= 0.7)
    {
      for (const Index v : vertices)
      {
        if (this->Places.IsFree(v) && this->Places.LeastQuality(v) < GoodEnough)
        {
          MoveToBetterPlace(this->Places, v, size);
        }
      }
    }
  }

  VertexStars& Cells;
  MovableFaces& Places;
  FaceEdits Edits;
  std::vector<char> IsNearHub;
  bool AreTriangles;
  bool MayMakeTriangles;
  /// Vertices around the face that is repaired, ascending, and their least qualities before that.
  std::vector<std::pair<Index, double>> Before;
  /// The penalty of the edits that are already applied.
  int GrownBefore = 0;
};
}

void RepairQuality(VertexStars& faces, MovableFaces& places,
  const std::vector<FaceMesh::Vertex>& vertices, bool mayMakeTriangles, int degree,
  const Progress& progress)
{
  // A singularity is better than a bad face, but not the other way round.
  FaceRepairs repairs(faces, places, WithoutLocks(RulesFor(faces, places, vertices, degree)),
    mayMakeTriangles, degree);
  Index left = MostAnyway + faces.GetNumberOfFaces() / OneOf;
  // Nothing was found for a face, and nothing has changed around it since.
  std::vector<char> isHopeless;
  bool hasChanged = true;
  for (int k = 0; k < Passes && hasChanged; ++k)
  {
    std::vector<std::pair<double, Index>> bad;
    isHopeless.resize(faces.GetNumberOfFaces(), 0);
    for (Index f = 0; f < faces.GetNumberOfFaces(); ++f)
    {
      const double quality = faces.IsFace(f) && isHopeless[f] == 0 ? repairs.Quality(f) : 1.0;
      if (quality < Bad)
      {
        bad.emplace_back(quality, f);
      }
    }
    std::sort(bad.begin(), bad.end());
    hasChanged = false;
    for (const auto& [quality, f] : bad)
    {
      if (left == 0 || !faces.IsFace(f) || repairs.Quality(f) >= Bad || !repairs.MayRepair(f))
      {
        continue;
      }
      --left;
      const std::size_t before = faces.GetChanges().size();
      const bool isRepaired = repairs.Repair(f);
      isHopeless[f] = isRepaired ? 0 : 1;
      hasChanged = hasChanged || isRepaired;
      isHopeless.resize(faces.GetNumberOfFaces(), 0);
      for (const Index v : faces.TouchedSince(before))
      {
        for (const Index g : faces.At(v))
        {
          isHopeless[g] = 0;
        }
      }
      progress.RequireToGoOn();
    }
    progress.Report((k + 1.0) / Passes);
  }
}
}
