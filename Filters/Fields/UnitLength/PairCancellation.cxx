// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "UnitLength/PairCancellation.h"

#include "Sections/DoubleCover.h"
#include "Sections/Singularities.h"
#include "Support/Threads.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

namespace DirectionFields::Internal
{
namespace
{
/// The values around a patch are held, which makes the energy of its field larger than it is once
/// all around has come to rest. A pair is cancelled where its patch pays off but for this part of
/// 2 pi ln 2 for each of the two: that costs a few thousandths of the energy, and leaves a tenth
/// of the singularities less. Fields that a guidance draws go without: they would lose
/// singularities by which meshes along them keep even sizes. So do those with more singularities
/// than this part of the vertices, as noise makes them: there would be more patches to try than
/// time for them.
constexpr double HeldPart = 0.4;
constexpr double MostSingularities = 0.04;
/// A patch must pay off by more than rounding may pretend.
constexpr double LeastGain = 1e-6;
/// Patches grow: the field in a narrow one around the path tells most pairs that do not pay off.
/// The gain of a wider one depends on the number k of edges that the path crosses.
double MostGainOfLength(double k)
{
  return 4.0 + k * k / 7.0;
}
constexpr double MostGainOfWidth = 15.0;
/// Where a path crosses no more edges than this, a wide patch decides.
constexpr Index ShortPath = 28;
/// Short paths have patches of this many rings at least, second and third ones, and of this part of
/// their length.
constexpr Index MediumRings = 2;
constexpr Index WideRings = 4;
constexpr Index MediumPart = 4;
constexpr Index WidePart = 2;
/// Patches of long paths have no more vertices than about this.
constexpr Index MostVertices = 8192;
/// A pair whose patch does not pay off, but would by more than this if it were wide, is cancelled
/// on approval.
constexpr double LeastPrediction = 5.0;
/// Predictions from narrow patches may be too high by this.
constexpr double GuessMargin = 5.0;

/// Adds the triangles of a pair, and their mirror images, to those that are done with.
void Finish(const UnitLengthProblem& problem, const SingularityPair& pair, std::set<Index>& done)
{
  for (const Index t : { pair.From, pair.To })
  {
    if (t != None)
    {
      const Index mirror = problem.Surface.Mesh.Mirror(3 * t);
      done.insert({ t, mirror != None ? mirror / 3 : t });
    }
  }
}

bool IsFinished(const SingularityPair& pair, const std::set<Index>& done)
{
  return done.count(pair.From) != 0 || done.count(pair.To) != 0;
}

Index WideRingsOf(Index length)
{
  return std::max(2, std::min(length / MediumPart, MostVertices / (2 * length)));
}

/// The energy in patches of r rings is about a + b / r: its value for one of half the path's
/// length.
double Extrapolated(Index length, Index narrow, double first, Index wide, double second)
{
  const double slope = (first - second) / (1.0 / narrow - 1.0 / wide);
  return second - slope * (1.0 / wide - 2.0 / length);
}

/// The number of pairs whose patches are solved together.
constexpr std::size_t BatchSize = 64;
/// All patches of a round together have no more vertices than this times those of the component:
/// the farthest pairs are left out where there are too many of them.
constexpr double MostWork = 12.0;
/// A rejected pair is tried again where a value was turned by more than this, in radians.
constexpr double Turned = 0.2;
}

PairCancellation::PairCancellation(const UnitLengthProblem& problem, double cost)
  : Problem(problem)
  , Cost(cost)
  , Allowance(cost)
  , Numbers(problem.Rows())
  , Changed(problem.Rows(), 0)
  , Owner(problem.Rows(), None)
{
}

std::vector<SingularityPair> PairCancellation::FindCandidates(const ComplexVector& u)
{
  const std::vector<int> indices = SingularityIndices(
    this->Problem.Geometry, this->Problem.Component, this->Problem.Degree, u.data());
  const auto regular = std::count(indices.begin(), indices.end(), 0);
  const bool isNoisy = static_cast<double>(indices.size()) - static_cast<double>(regular) >
    MostSingularities * this->Problem.Rows();
  const double held =
    isNoisy || this->Problem.Pull.size() > 0 ? 0.0 : HeldPart * 2.0 * Pi * std::log(2.0);
  this->Allowance = std::max(this->Cost, held);
  std::vector<SingularityPair> pairs = FindPairs(this->Problem, indices);
  if (!this->IsFirstRound)
  {
    const TriangleMesh& mesh = this->Problem.Geometry.Mesh;
    const auto isChanged = [&](Index t)
    {
      bool changed = false;
      for (Index h = 3 * t; t != None && h < 3 * t + 3; ++h)
      {
        changed = changed || this->Changed[mesh.Tail(h) - this->Problem.Component.FirstVertex] != 0;
      }
      return changed;
    };
    pairs.erase(
      std::remove_if(pairs.begin(), pairs.end(),
        [&](const SingularityPair& pair) { return !isChanged(pair.From) && !isChanged(pair.To); }),
      pairs.end());
  }
  this->IsFirstRound = false;
  std::fill(this->Changed.begin(), this->Changed.end(), 0);
  return pairs;
}

bool PairCancellation::PaysOff(const PairPatch& patch, const ComplexVector& u) const
{
  const double change = patch.GetEnergyChange();
  if (this->Allowance == 0.0 || change < -LeastGain)
  {
    return change < -LeastGain;
  }
  // Two more of the same sign may be in one of the triangles.
  return change < 4.0 * this->Allowance &&
    change + this->Allowance * patch.CountIndexChange(u) < -LeastGain;
}

void PairCancellation::Accept(const PairPatch& patch, ComplexVector& u)
{
  for (std::size_t k = 0; k < patch.GetVertices().size(); ++k)
  {
    const Index v = patch.GetVertices()[k];
    const Complex& value = patch.GetValues()[k];
    this->Changed[v] |= (std::conj(u[v]) * value).real() < std::cos(Turned) ? 1 : 0;
    u[v] = value;
  }
  if (this->Problem.Component.IsCover)
  {
    const DoubleCover cover(this->Problem.Surface, this->Problem.Component, this->Problem.Degree);
    const Index first = this->Problem.Component.FirstVertex;
    for (const Index v : patch.GetVertices())
    {
      const Index mirror = this->Problem.Surface.Mesh.MirrorVertex(first + v) - first;
      u[mirror] = cover.Mirrored(first + v, u[v]);
      this->Changed[mirror] = this->Changed[v];
    }
  }
}

bool PairCancellation::ReachesItself(const PairPatch& patch)
{
  if (!this->Problem.Component.IsCover)
  {
    return false;
  }
  const Index first = this->Problem.Component.FirstVertex;
  const std::vector<Index>& vertices = patch.GetVertices();
  const auto mark = [&](Index value)
  {
    for (const Index v : vertices)
    {
      this->Owner[v] = value;
    }
    for (const Index v : patch.GetNeighbours())
    {
      this->Owner[v] = value;
    }
  };
  mark(0);
  const bool reaches = std::any_of(vertices.begin(), vertices.end(),
    [&](Index v)
    { return this->Owner[this->Problem.Surface.Mesh.MirrorVertex(first + v) - first] != None; });
  mark(None);
  return reaches;
}

/// The pairs of a round that are not decided.
class PairCancellation::Queue
{
public:
  Queue(PairCancellation& owner, const ComplexVector& u)
    : Owner(owner)
    , Problem(owner.Problem)
    , Pairs(owner.FindCandidates(u))
  {
  }

  bool IsEmpty() const { return this->Next == this->Pairs.size() && this->Waiting.empty(); }

  /// Decides some pairs. Returns the number of those that were cancelled.
  int Step(ComplexVector& u)
  {
    this->Fill();
    this->Screen(u);
    this->SelectBatch();
    ParallelFor(static_cast<Index>(this->Batch.size()), 1,
      [&](Index k, Index) { this->Batch[k].Patch->Try(u); });
    int cancelled = 0;
    for (const Candidate& candidate : this->Batch)
    {
      this->Work += static_cast<double>(candidate.Patch->GetVertices().size());
      if (!this->Owner.ReachesItself(*candidate.Patch) && this->Owner.PaysOff(*candidate.Patch, u))
      {
        this->Owner.Accept(*candidate.Patch, u);
        Finish(this->Problem, *candidate.Pair, this->Done);
        ++cancelled;
      }
    }
    if (this->Work > MostWork * this->Problem.Rows())
    {
      this->Next = this->Pairs.size();
      this->Waiting.clear();
    }
    return cancelled;
  }

  /// The pairs that a wider patch would cancel.
  std::vector<SingularityPair> OnApproval;
  bool IsDone(const SingularityPair& pair) const { return IsFinished(pair, this->Done); }

private:
  struct Candidate
  {
    const SingularityPair* Pair;
    std::unique_ptr<PairPatch> Patch;
    /// Whether the pair is cancelled because of the gain predicted for a wider patch.
    bool OnApproval = false;
    /// The vertices of all patches that were tried for it.
    double Work = 0.0;
  };

  void Fill()
  {
    this->Waiting.erase(std::remove_if(this->Waiting.begin(), this->Waiting.end(),
                          [&](const Candidate& c) { return this->IsDone(*c.Pair); }),
      this->Waiting.end());
    while (this->Waiting.size() < BatchSize && this->Next < this->Pairs.size())
    {
      const SingularityPair& pair = this->Pairs[this->Next++];
      if (!this->IsDone(pair))
      {
        this->Waiting.push_back({ &pair, nullptr });
      }
    }
  }

  std::unique_ptr<PairPatch> Tried(Candidate& candidate, Index rings, const ComplexVector& u) const
  {
    auto patch =
      std::make_unique<PairPatch>(this->Problem, *candidate.Pair, rings, this->Owner.Numbers);
    patch->Try(u);
    candidate.Work += static_cast<double>(patch->GetVertices().size());
    return patch;
  }

  /// The patch that is to decide about a pair; null where a smaller one tells that it does not pay
  /// off.
  void Prepare(Candidate& candidate, const ComplexVector& u) const
  {
    const SingularityPair& pair = *candidate.Pair;
    const auto length = static_cast<Index>(pair.Crossed.size());
    const double bonus = 2.0 * this->Owner.Allowance;
    if (this->Tried(candidate, 1, u)->GetEnergyChange() > bonus + MostGainOfLength(length))
    {
      return;
    }
    if (length <= ShortPath)
    {
      const Index medium = std::max(MediumRings, length / MediumPart);
      if (this->Tried(candidate, medium, u)->GetEnergyChange() < bonus + MostGainOfWidth)
      {
        candidate.Patch = std::make_unique<PairPatch>(
          this->Problem, pair, std::max(WideRings, length / WidePart), this->Owner.Numbers);
      }
      return;
    }
    const Index wide = WideRingsOf(length);
    const Index medium = std::max(2, wide / 2);
    const Index narrow = medium / 2;
    const double first = this->Tried(candidate, narrow, u)->GetEnergyChange();
    const double second = this->Tried(candidate, medium, u)->GetEnergyChange();
    const double guess = Extrapolated(length, narrow, first, medium, second);
    if (guess > bonus + GuessMargin)
    {
      return;
    }
    auto patch = this->Tried(candidate, wide, u);
    const double widened = patch->GetEnergyChange();
    const double prediction = Extrapolated(length, medium, second, wide, widened);
    if (prediction < bonus - LeastPrediction || widened < bonus)
    {
      candidate.OnApproval = widened >= bonus;
      candidate.Patch = candidate.OnApproval ? nullptr : std::move(patch);
    }
  }

  /// Rejects pairs that cannot pay off, and makes the patches of the others.
  void Screen(const ComplexVector& u)
  {
    ParallelFor(static_cast<Index>(this->Waiting.size()), 1,
      [&](Index k, Index)
      {
        Candidate& candidate = this->Waiting[k];
        if (!candidate.Patch)
        {
          this->Prepare(candidate, u);
        }
      });
    for (Candidate& candidate : this->Waiting)
    {
      this->Work += candidate.Work;
      candidate.Work = 0.0;
      if (candidate.OnApproval)
      {
        this->OnApproval.push_back(*candidate.Pair);
      }
    }
    this->Waiting.erase(std::remove_if(this->Waiting.begin(), this->Waiting.end(),
                          [](const Candidate& c) { return !c.Patch; }),
      this->Waiting.end());
  }

  /// Of patches that touch each other the first is tried now, the others in their turn.
  void SelectBatch()
  {
    std::vector<Index>& owner = this->Owner.Owner;
    const auto isTaken = [&](Index v) { return owner[v] != None; };
    this->Batch.clear();
    std::vector<Candidate> later;
    std::vector<Index> taken;
    for (Candidate& candidate : this->Waiting)
    {
      const std::vector<Index>& vertices = candidate.Patch->GetVertices();
      const std::vector<Index>& neighbours = candidate.Patch->GetNeighbours();
      const bool touches = std::any_of(vertices.begin(), vertices.end(), isTaken) ||
        std::any_of(neighbours.begin(), neighbours.end(), isTaken);
      // Waiting pairs keep their places before later ones.
      for (const Index v : vertices)
      {
        if (!isTaken(v))
        {
          owner[v] = 0;
          taken.push_back(v);
        }
      }
      // On a cover the mirror image of a patch changes with it, wherever that may be.
      const bool alone = this->Problem.Component.IsCover && !this->Batch.empty();
      (touches || alone ? later : this->Batch).push_back(std::move(candidate));
    }
    for (const Index v : taken)
    {
      owner[v] = None;
    }
    this->Waiting = std::move(later);
  }

  PairCancellation& Owner;
  const UnitLengthProblem& Problem;
  std::vector<SingularityPair> Pairs;
  std::size_t Next = 0;
  std::vector<Candidate> Waiting;
  std::vector<Candidate> Batch;
  /// The triangles whose singularities have gone in this round.
  std::set<Index> Done;
  double Work = 0.0;
};

int PairCancellation::Round(ComplexVector& u, const Progress& progress)
{
  Queue queue(*this, u);
  int cancelled = 0;
  while (!queue.IsEmpty())
  {
    progress.RequireToGoOn();
    cancelled += queue.Step(u);
  }
  this->OnApproval.clear();
  for (const SingularityPair& pair : queue.OnApproval)
  {
    if (!queue.IsDone(pair))
    {
      this->OnApproval.push_back(pair);
    }
  }
  return cancelled;
}

int PairCancellation::CancelOnApproval(ComplexVector& u)
{
  std::set<Index> done;
  int cancelled = 0;
  for (const SingularityPair& pair : this->OnApproval)
  {
    PairPatch patch(
      this->Problem, pair, WideRingsOf(static_cast<Index>(pair.Crossed.size())), this->Numbers);
    if (IsFinished(pair, done) || this->ReachesItself(patch))
    {
      continue;
    }
    patch.Try(u);
    this->Accept(patch, u);
    Finish(this->Problem, pair, done);
    ++cancelled;
  }
  return cancelled;
}
}
