// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "PrescribedSingularities/SingularityHand.h"

#include "Distance/TriangleRuns.h"
#include "Interpolation/GivenField.h"
#include "PrescribedSingularities/ConstrainedVertices.h"
#include "Soup/JoinedSets.h"

#include <cstdlib>
#include <functional>
#include <limits>
#include <queue>
#include <set>
#include <unordered_map>
#include <utility>

namespace DirectionFields
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
/// How many steps from triangle to triangle the two of a new pair are apart: each is to have a
/// handle of its own, and triangles next to each other could not turn as much as both ask for.
constexpr int RingsOfPair = 4;
}

/// The triangles of a surface, in parts between which no singularity can go.
class SingularityHand::Parts
{
public:
  Parts(const Surface& surface, const std::vector<Vector3>& constraints);

  /// The triangle of the mesh that a place is nearest to; None where it is not finite or the
  /// surface has no triangles.
  /// @param found gets the nearest point
  Index TriangleAt(const Vector3& place, Vector3& found) const;
  Index TriangleAt(const Vector3& place) const
  {
    Vector3 found;
    return this->TriangleAt(place, found);
  }
  Index PartOf(Index triangle) const { return this->Part[triangle]; }
  bool IsOpen(Index triangle) const { return this->Open[this->Part[triangle]] != 0; }
  Vector3 Middle(Index triangle) const;

  /// Visits the triangles of a part, the nearest ones first, by the lengths of paths from middle to
  /// middle, until a visit returns true.
  /// @param visit gets the triangle, and how many triangles the path has before it
  void VisitFrom(Index triangle, const std::function<bool(Index triangle, int steps)>& visit) const;

  /// The sum of the indices in the part of a triangle.
  int SumAround(const std::vector<WantedSingularity>& singularities, Index triangle) const;
  /// What a closed part asks for.
  std::string Rule(const std::vector<WantedSingularity>& singularities, Index triangle) const;

  const TriangleMesh& Mesh() const { return this->Made.Geometry->Mesh; }

private:
  bool IsCrossable(Index h) const
  {
    return this->IsGiven.empty() || !this->IsGiven[this->Mesh().Tail(h)] ||
      !this->IsGiven[this->Mesh().Head(h)];
  }

  const Surface& Input;
  FieldSurface Made;
  std::vector<char> IsGiven;
  std::vector<Index> Part;
  std::vector<char> Open;
  std::unique_ptr<TriangleRuns> Nearest;
};

SingularityHand::Parts::Parts(const Surface& surface, const std::vector<Vector3>& constraints)
  : Input(surface)
  , Made(surface)
{
  const TriangleMesh& mesh = this->Mesh();
  for (const Complex& direction : ConstrainedVertices(*this->Made.Geometry, constraints))
  {
    this->IsGiven.push_back(direction != 0.0);
  }
  const Index triangles = mesh.GetNumberOfTriangles();
  JoinedSets sets(triangles);
  this->Open.resize(triangles, 0);
  std::vector<char> touches(triangles, 0);
  for (Index h = 0; h < 3 * triangles; ++h)
  {
    const Index twin = mesh.Twin(h);
    if (twin == None)
    {
      touches[h / 3] |= static_cast<char>(this->IsCrossable(h));
    }
    else if (this->IsCrossable(h))
    {
      sets.Join(h / 3, twin / 3);
    }
  }
  LargeArray<Index> order;
  order.reserve(triangles);
  this->Part.resize(triangles);
  for (Index t = 0; t < triangles; ++t)
  {
    this->Part[t] = sets.Find(t);
    this->Open[this->Part[t]] |= touches[t];
    if (mesh.IsFront(t))
    {
      order.push_back(mesh.InputTriangle(t));
    }
  }
  this->Nearest = std::make_unique<TriangleRuns>(this->Input, std::move(order));
}

Index SingularityHand::Parts::TriangleAt(const Vector3& place, Vector3& found) const
{
  if (!place.allFinite())
  {
    return None;
  }
  const ClosestPoints::Answer answer = this->Nearest->Find(place);
  found = answer.Position;
  return answer.Triangle == None ? None : this->Made.MeshTriangle[answer.Triangle];
}

Vector3 SingularityHand::Parts::Middle(Index triangle) const
{
  // Divided first: the sum of the largest coordinates would overflow.
  Vector3 middle = Vector3::Zero();
  for (const Index i : this->Input.Triangles[this->Mesh().InputTriangle(triangle)])
  {
    middle += this->Input.Points[i] / 3.0;
  }
  return middle;
}

void SingularityHand::Parts::VisitFrom(
  Index triangle, const std::function<bool(Index triangle, int steps)>& visit) const
{
  const TriangleMesh& mesh = this->Mesh();
  struct Reached
  {
    double Distance;
    Index Triangle;
    int Steps;
    bool operator>(const Reached& other) const
    {
      return this->Distance != other.Distance ? this->Distance > other.Distance
                                              : this->Triangle > other.Triangle;
    }
  };
  std::vector<double> least(mesh.GetNumberOfTriangles(), Infinity);
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue;
  queue.push({ 0.0, triangle, 0 });
  least[triangle] = 0.0;
  while (!queue.empty())
  {
    const Reached at = queue.top();
    queue.pop();
    if (at.Distance > least[at.Triangle])
    {
      continue;
    }
    if (visit(at.Triangle, at.Steps))
    {
      return;
    }
    const Vector3 middle = this->Middle(at.Triangle);
    for (Index h = 3 * at.Triangle; h < 3 * at.Triangle + 3; ++h)
    {
      const Index twin = mesh.Twin(h);
      if (twin == None || !this->IsCrossable(h))
      {
        continue;
      }
      const double distance = at.Distance + (this->Middle(twin / 3) - middle).stableNorm();
      if (distance < least[twin / 3])
      {
        least[twin / 3] = distance;
        queue.push({ distance, twin / 3, at.Steps + 1 });
      }
    }
  }
}

int SingularityHand::Parts::SumAround(
  const std::vector<WantedSingularity>& singularities, Index triangle) const
{
  int sum = 0;
  for (const WantedSingularity& singularity : singularities)
  {
    const Index t = this->TriangleAt(singularity.Position);
    sum += t != None && this->PartOf(t) == this->PartOf(triangle) ? singularity.Index : 0;
  }
  return sum;
}

std::string SingularityHand::Parts::Rule(
  const std::vector<WantedSingularity>& singularities, Index triangle) const
{
  return "the indices on this closed part of the surface add up to " +
    std::to_string(this->SumAround(singularities, triangle)) + ", and have to";
}

SingularityHand::SingularityHand(const Surface& surface, const std::vector<Vector3>& constraints)
  : Found(std::make_unique<Parts>(surface, constraints))
{
}

SingularityHand::~SingularityHand() = default;
SingularityHand::SingularityHand(SingularityHand&&) noexcept = default;
SingularityHand& SingularityHand::operator=(SingularityHand&&) noexcept = default;

HandStep SingularityHand::Move(const std::vector<WantedSingularity>& singularities,
  std::size_t which, const Vector3& place) const
{
  HandStep step{ singularities, false, {} };
  Vector3 to = Vector3::Zero();
  const Index after = this->Found->TriangleAt(place, to);
  const Index before =
    which < singularities.size() ? this->Found->TriangleAt(singularities[which].Position) : None;
  if (after == None || before == None)
  {
    step.Note = "There is no singularity to move, or no surface there.";
    return step;
  }
  const bool isSamePart = this->Found->PartOf(before) == this->Found->PartOf(after);
  if (!isSamePart && !(this->Found->IsOpen(before) && this->Found->IsOpen(after)))
  {
    const Index closed = this->Found->IsOpen(before) ? after : before;
    step.Note =
      "The singularity cannot go there: " + this->Found->Rule(singularities, closed) + ".";
    return step;
  }
  step.Singularities[which].Position = to;
  step.IsDone = true;
  return step;
}

HandStep SingularityHand::Merge(
  const std::vector<WantedSingularity>& singularities, std::size_t which) const
{
  HandStep step{ singularities, false, {} };
  const Index from = which < singularities.size() && singularities[which].Index != 0
    ? this->Found->TriangleAt(singularities[which].Position)
    : None;
  if (from == None)
  {
    step.Note = "There is no singularity to take away.";
    return step;
  }
  const int index = singularities[which].Index;
  std::unordered_map<Index, std::size_t> opposites;
  for (std::size_t k = 0; k < singularities.size(); ++k)
  {
    const Index t = this->Found->TriangleAt(singularities[k].Position);
    if (t == None || singularities[k].Index == 0 || (singularities[k].Index > 0) == (index > 0))
    {
      continue;
    }
    opposites.emplace(t, k);
    // A path over a surface that cannot be oriented may come from its other side.
    const Index mirror = this->Found->Mesh().Mirror(3 * t);
    if (mirror != None)
    {
      opposites.emplace(mirror / 3, k);
    }
  }
  std::size_t with = singularities.size();
  this->Found->VisitFrom(from,
    [&](Index triangle, int)
    {
      const auto found = opposites.find(triangle);
      with = found == opposites.end() ? with : found->second;
      return found != opposites.end();
    });
  int& left = step.Singularities[which].Index;
  left = 0;
  if (with < singularities.size())
  {
    const int rest = step.Singularities[with].Index += index;
    step.Note = rest == 0
      ? "Two singularities have met: both are gone, and the sum of the indices stays."
      : "The singularity has gone into the nearest one of opposite sign, whose index is " +
        std::to_string(rest) + " now, in units of 1/n.";
  }
  else if (this->Found->IsOpen(from))
  {
    step.Note = "The singularity has left through the boundary.";
  }
  else
  {
    left = index;
    step.Note = "The singularity stays: " + this->Found->Rule(singularities, from) +
      ", and none of opposite sign is there to meet it.";
    return step;
  }
  step.IsDone = true;
  for (std::size_t k = step.Singularities.size(); k-- > 0 && step.Singularities.size() > 1;)
  {
    if (step.Singularities[k].Index == 0)
    {
      step.Singularities.erase(step.Singularities.begin() + static_cast<std::ptrdiff_t>(k));
    }
  }
  return step;
}

HandStep SingularityHand::Add(
  const std::vector<WantedSingularity>& singularities, const Vector3& place, int index) const
{
  HandStep step{ singularities, false, {} };
  Vector3 to = Vector3::Zero();
  const Index triangle = this->Found->TriangleAt(place, to);
  if (triangle == None || index == 0)
  {
    step.Note = "There is no surface to put a singularity on, or its index is 0.";
  }
  else if (!this->Found->IsOpen(triangle))
  {
    step.Note =
      "A single singularity cannot come here: " + this->Found->Rule(singularities, triangle) +
      ". Add a pair.";
  }
  else
  {
    step.Singularities.push_back({ to, index });
    step.IsDone = true;
  }
  return step;
}

HandStep SingularityHand::AddPair(
  const std::vector<WantedSingularity>& singularities, const Vector3& place, int index) const
{
  HandStep step{ singularities, false, {} };
  Vector3 to = Vector3::Zero();
  const Index triangle = this->Found->TriangleAt(place, to);
  if (triangle == None || index == 0)
  {
    step.Note = "There is no surface to put a pair on, or its index is 0.";
    return step;
  }
  // Where there is a singularity already, the two would add up.
  std::set<Index> taken = { triangle };
  for (const WantedSingularity& singularity : singularities)
  {
    Vector3 position;
    taken.insert(this->Found->TriangleAt(singularity.Position, position));
  }
  Index other = None;
  this->Found->VisitFrom(triangle,
    [&](Index reached, int steps)
    {
      other = this->Found->Mesh().IsFront(reached) && taken.count(reached) == 0 ? reached : other;
      return steps >= RingsOfPair && other == reached;
    });
  if (other == None)
  {
    step.Note = "The part of the surface has no room for a pair: subdivide it.";
    return step;
  }
  step.Singularities.push_back({ to, index });
  step.Singularities.push_back({ this->Found->Middle(other), -index });
  step.IsDone = true;
  return step;
}
}
