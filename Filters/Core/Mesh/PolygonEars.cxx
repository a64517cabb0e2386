// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/PolygonEars.h"

#include "Support/VectorMath.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <queue>

namespace DirectionFields::Internal
{
namespace
{
/// Coordinates are integers up to this size, so that differences are exact.
constexpr double LargestCoordinate = 1125899906842624.0;
/// The measure of what is no ear.
constexpr double Worst = 1e300;
/// Most cells of the grid along an axis.
constexpr double MostCells = 1024.0;

struct Place
{
  double X;
  double Y;
  bool operator==(const Place& other) const { return this->X == other.X && this->Y == other.Y; }
};

/// The sign of the area of a triangle, exactly: 1 if it is wound counter-clockwise.
int Turn(const Place& a, const Place& b, const Place& c)
{
  const double p = b.X - a.X;
  const double q = c.Y - a.Y;
  const double r = b.Y - a.Y;
  const double s = c.X - a.X;
  // Rounding is monotone: products that are different rounded are different in the same way.
  const double one = p * q;
  const double other = r * s;
  if (one != other)
  {
    return one > other ? 1 : -1;
  }
  const double oneRest = std::fma(p, q, -one);
  const double otherRest = std::fma(r, s, -other);
  return oneRest > otherRest ? 1 : (oneRest < otherRest ? -1 : 0);
}

/// The corners moved and scaled into the cube from -1 to 1.
std::vector<Vector3> Normalized(const std::vector<Vector3>& corners)
{
  Vector3 lower = corners.front();
  Vector3 upper = lower;
  for (const Vector3& corner : corners)
  {
    lower = lower.cwiseMin(corner);
    upper = upper.cwiseMax(corner);
  }
  // Halves, for the difference of the largest numbers is none.
  const Vector3 half = 0.5 * upper - 0.5 * lower;
  const double size = half.maxCoeff();
  std::vector<Vector3> normalized(corners.size());
  for (std::size_t i = 0; i < corners.size() && size > 0.0; ++i)
  {
    normalized[i] = (0.5 * corners[i] - 0.5 * lower - 0.5 * half) / (0.5 * size);
  }
  if (!(size > 0.0))
  {
    std::fill(normalized.begin(), normalized.end(), Vector3(Vector3::Zero()));
  }
  return normalized;
}

/// The unit normal of the polygon's area (Newell); zero if it has none.
Vector3 NormalOf(const std::vector<Vector3>& corners)
{
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const Vector3& next = corners[i + 1 < corners.size() ? i + 1 : 0];
    sum += (corners[i] - corners[0]).cross(next - corners[0]);
  }
  const double length = sum.norm();
  return length > 1e-14 ? Vector3(sum / length) : Vector3::Zero();
}

/// What is left of a polygon while ears are cut off.
class Polygon
{
public:
  Polygon(const std::vector<Vector3>& corners, const Vector3& normal)
    : Corners(corners)
    , Places(corners.size())
    , PreviousOf(corners.size())
    , NextOf(corners.size())
    , Remaining(static_cast<Index>(corners.size()))
  {
    const Vector3 x = AnyOrthogonal(normal);
    const Vector3 y = normal.cross(x);
    for (Index i = 0; i < this->Remaining; ++i)
    {
      this->Places[i] = { std::round(0.5 * LargestCoordinate * corners[i].dot(x)),
        std::round(0.5 * LargestCoordinate * corners[i].dot(y)) };
      this->PreviousOf[i] = i > 0 ? i - 1 : this->Remaining - 1;
      this->NextOf[i] = i + 1 < this->Remaining ? i + 1 : 0;
    }
  }

  Index Previous(Index i) const { return this->PreviousOf[i]; }
  Index Next(Index i) const { return this->NextOf[i]; }
  Index GetRemaining() const { return this->Remaining; }
  bool IsThere(Index i) const { return this->NextOf[i] != None; }
  const Place& At(Index i) const { return this->Places[i]; }
  int Turn(Index a, Index b, Index c) const
  {
    return Internal::Turn(this->Places[a], this->Places[b], this->Places[c]);
  }
  /// Whether the inner angle of a corner is less than half a turn.
  bool IsConvex(Index i) const { return this->Turn(this->Previous(i), i, this->Next(i)) > 0; }

  void Remove(Index i)
  {
    this->NextOf[this->PreviousOf[i]] = this->NextOf[i];
    this->PreviousOf[this->NextOf[i]] = this->PreviousOf[i];
    this->NextOf[i] = None;
    --this->Remaining;
  }

  /// The square of the perimeter of a corner's triangle over its area: the less, the better.
  double Measure(Index i) const
  {
    const Vector3& a = this->Corners[this->Previous(i)];
    const Vector3& b = this->Corners[i];
    const Vector3& c = this->Corners[this->Next(i)];
    const double area = (b - a).cross(c - a).norm();
    const double perimeter = (b - a).norm() + (c - b).norm() + (a - c).norm();
    return area > 0.0 ? std::min(perimeter * perimeter / area, 0.5 * Worst) : 0.5 * Worst;
  }

  /// Whether the diagonal from an end of an ear to the other runs into the polygon there.
  bool OpensInwards(Index i) const
  {
    const Index a = this->Previous(i);
    const Index c = this->Next(i);
    const Index before = this->Previous(a);
    const Index after = this->Next(c);
    // A loop may be closed, which leaves nothing behind it.
    return (!this->IsConvex(a) || this->At(before) == this->At(c) ||
             this->Turn(a, c, before) > 0) &&
      (!this->IsConvex(c) || this->At(after) == this->At(a) || this->Turn(c, after, a) > 0);
  }

  /// Whether a corner is in the way of the ear of another one.
  bool Blocks(Index blocker, Index ear) const
  {
    const Index a = this->Previous(ear);
    const Index c = this->Next(ear);
    const Place& at = this->At(blocker);
    // Around a place that is visited several times each visit keeps to its own side.
    if (at == this->At(a) || at == this->At(ear) || at == this->At(c))
    {
      return false;
    }
    const int first = this->Turn(a, ear, blocker);
    const int second = this->Turn(ear, c, blocker);
    if (first < 0 || second < 0 || this->Turn(c, a, blocker) < 0)
    {
      return false;
    }
    // The polygon may touch the ear's sides from outside.
    const auto goesIn = [&](Index from, Index to)
    {
      return this->Turn(from, to, this->Previous(blocker)) > 0 ||
        this->Turn(from, to, this->Next(blocker)) > 0;
    };
    return first == 0 ? goesIn(a, ear) : (second == 0 ? goesIn(ear, c) : true);
  }

private:
  const std::vector<Vector3>& Corners;
  std::vector<Place> Places;
  std::vector<Index> PreviousOf;
  std::vector<Index> NextOf;
  Index Remaining;
};

/// The corners that can be in the way of ears, those that are not convex, in square cells.
class Grid
{
public:
  explicit Grid(const Polygon& polygon)
    : Shape(polygon)
    , IsIn(static_cast<std::size_t>(polygon.GetRemaining()), 0)
  {
  }

  /// Holds all corners that are not convex, and no others.
  void Fill()
  {
    std::vector<Index> corners;
    for (std::size_t i = 0; i < this->IsIn.size(); ++i)
    {
      const auto corner = static_cast<Index>(i);
      this->IsIn[i] = this->Shape.IsThere(corner) && !this->Shape.IsConvex(corner);
      if (this->IsIn[i])
      {
        corners.push_back(corner);
      }
    }
    this->Number = this->Filled = corners.size();
    this->Across =
      std::clamp(std::ceil(std::sqrt(static_cast<double>(this->Number))), 1.0, MostCells);
    const auto cells = static_cast<std::size_t>(this->Across * this->Across);
    this->Begin.assign(cells + 1, 0);
    for (const Index i : corners)
    {
      ++this->Begin[this->CellOf(this->Shape.At(i)) + 1];
    }
    std::partial_sum(this->Begin.begin(), this->Begin.end(), this->Begin.begin());
    std::vector<std::size_t> next(this->Begin.begin(), this->Begin.end() - 1);
    this->Members.resize(corners.size());
    for (const Index i : corners)
    {
      this->Members[next[this->CellOf(this->Shape.At(i))]++] = i;
    }
  }

  /// Whether a corner can be in the way.
  bool Has(Index i) const { return this->IsIn[i] != 0; }

  /// Looks whether a corner is still there and not convex. Once that holds for half of them only, the
  /// cells are made anew.
  void Update(Index i)
  {
    if (this->IsIn[i] && (!this->Shape.IsThere(i) || this->Shape.IsConvex(i)))
    {
      this->IsIn[i] = 0;
      if (--this->Number < this->Filled / 2)
      {
        this->Fill();
      }
    }
  }

  /// A corner that is in the way of an ear; None without one.
  Index FindBlocker(Index ear) const
  {
    const Place& a = this->Shape.At(this->Shape.Previous(ear));
    const Place& b = this->Shape.At(ear);
    const Place& c = this->Shape.At(this->Shape.Next(ear));
    const auto [left, right] = std::minmax({ a.X, b.X, c.X });
    const auto [low, high] = std::minmax({ a.Y, b.Y, c.Y });
    for (std::size_t y = this->Along(low); y <= this->Along(high); ++y)
    {
      const std::size_t row = y * static_cast<std::size_t>(this->Across);
      const std::size_t end = this->Begin[row + this->Along(right) + 1];
      for (std::size_t k = this->Begin[row + this->Along(left)]; k < end; ++k)
      {
        const Index i = this->Members[k];
        const Place& at = this->Shape.At(i);
        if (at.X >= left && at.X <= right && at.Y >= low && at.Y <= high && this->IsIn[i] &&
          this->Shape.Blocks(i, ear))
        {
          return i;
        }
      }
    }
    return None;
  }

private:
  std::size_t Along(double coordinate) const
  {
    const double part = 0.5 + 0.5 * coordinate / LargestCoordinate;
    return static_cast<std::size_t>(std::clamp(this->Across * part, 0.0, this->Across - 1.0));
  }
  std::size_t CellOf(const Place& at) const
  {
    return this->Along(at.Y) * static_cast<std::size_t>(this->Across) + this->Along(at.X);
  }

  const Polygon& Shape;
  std::vector<char> IsIn;
  double Across = 1.0;
  /// The corners that are in, and that were when the cells were made.
  std::size_t Number = 0;
  std::size_t Filled = 0;
  /// The corners of cell k: Members[Begin[k]] ... Members[Begin[k + 1] - 1].
  std::vector<std::size_t> Begin;
  std::vector<Index> Members;
};

/// Cuts one ear after the other.
class Cutting
{
public:
  Cutting(const std::vector<Vector3>& corners, const Vector3& normal, bool force)
    : Shape(corners, normal)
    , InTheWay(this->Shape)
    , Force(force)
    , Version(corners.size(), 0)
    , Waiting(corners.size())
  {
    const auto number = static_cast<Index>(corners.size());
    for (Index i = 0; i < number; ++i)
    {
      this->JoinRepeated(i);
    }
    for (Index i = 0; i < number; ++i)
    {
      if (this->Shape.IsThere(i))
      {
        this->RemoveSpikes(i);
      }
    }
    this->InTheWay.Fill();
    for (Index i = 0; i < number; ++i)
    {
      this->Queue(i);
    }
  }

  std::vector<Index> CutAll()
  {
    while (this->Shape.GetRemaining() > 3)
    {
      if (this->Ears.empty())
      {
        if (!this->Force || this->Forced)
        {
          return {};
        }
        this->Forced = true;
        for (std::size_t i = 0; i < this->Version.size(); ++i)
        {
          this->Queue(static_cast<Index>(i));
        }
        continue;
      }
      const Ear ear = this->Ears.top();
      this->Ears.pop();
      if (!this->Shape.IsThere(ear.Corner) || this->Version[ear.Corner] != ear.Version)
      {
        continue;
      }
      const Index blocker = this->Forced ? None : this->InTheWay.FindBlocker(ear.Corner);
      if (blocker == None)
      {
        this->Cut(ear.Corner);
      }
      else
      {
        this->Waiting[blocker].push_back(ear);
      }
    }
    return this->CutLast() ? std::move(this->Triangles) : std::vector<Index>();
  }

private:
  struct Ear
  {
    double Measure;
    Index Corner;
    Index Version;
    bool operator>(const Ear& other) const
    {
      return this->Measure != other.Measure ? this->Measure > other.Measure
                                            : this->Corner > other.Corner;
    }
  };

  /// Queues a corner if it is an ear, or one that may be blocked.
  void Queue(Index i)
  {
    if (!this->Shape.IsThere(i))
    {
      return;
    }
    const bool isEar = this->Shape.IsConvex(i) && (this->Forced || this->Shape.OpensInwards(i));
    if (isEar || this->Forced)
    {
      // What is not convex is cut in turns, so that few triangles meet in a corner.
      this->Ears.push({ isEar ? this->Shape.Measure(i) : Worst * (1.0 + 1e-9 * this->Version[i]), i,
        this->Version[i] });
    }
  }

  /// Looks anew at a corner around which something has changed, and at what waits for it.
  void Update(Index i)
  {
    this->InTheWay.Update(i);
    ++this->Version[i];
    this->Queue(i);
    std::vector<Ear>& waiting = this->Waiting[i];
    const auto isOver = [&](const Ear& ear)
    {
      const bool isNow =
        this->Shape.IsThere(ear.Corner) && this->Version[ear.Corner] == ear.Version;
      const bool goesOn = isNow && this->InTheWay.Has(i) && this->Shape.Blocks(i, ear.Corner);
      if (isNow && !goesOn)
      {
        this->Ears.push(ear);
      }
      return !goesOn;
    };
    waiting.erase(std::remove_if(waiting.begin(), waiting.end(), isOver), waiting.end());
  }

  /// Cuts off the corners after one that are at the same place, by triangles without area: others may
  /// have an edge in common with them.
  void JoinRepeated(Index i)
  {
    while (this->Shape.IsThere(i) && this->Shape.GetRemaining() > 3 &&
      this->Shape.At(i) == this->Shape.At(this->Shape.Next(i)))
    {
      const Index repeated = this->Shape.Next(i);
      this->Triangles.insert(this->Triangles.end(), { i, repeated, this->Shape.Next(repeated) });
      this->Shape.Remove(repeated);
    }
  }

  void Cut(Index i)
  {
    const Index a = this->Shape.Previous(i);
    const Index c = this->Shape.Next(i);
    this->Triangles.insert(this->Triangles.end(), { a, i, c });
    this->Shape.Remove(i);
    this->Update(i);
    Index left = this->RemoveSpikes(a);
    const Index right = this->Shape.IsThere(c) ? this->RemoveSpikes(c) : left;
    left = this->Shape.IsThere(left) ? left : right;
    // The ears beside the changed corners see other inner angles at these.
    this->Update(this->Shape.Previous(left));
    this->Update(left);
    if (right != left)
    {
      this->Update(right);
    }
    this->Update(this->Shape.Next(right));
  }

  /// Removes corners around one where the polygon runs back along the edge that it came by, and so has
  /// no area. Returns the corner that is left there.
  Index RemoveSpikes(Index i)
  {
    while (this->Shape.GetRemaining() > 2)
    {
      const Index before = this->Shape.Previous(i);
      const Index after = this->Shape.Next(i);
      if (this->Shape.At(before) == this->Shape.At(after))
      {
        // The tip goes, and one of the two corners at the place behind it.
        this->Drop(i);
        this->Drop(after);
        i = before;
      }
      else
      {
        break;
      }
    }
    return i;
  }

  void Drop(Index i)
  {
    this->Shape.Remove(i);
    this->Update(i);
  }

  /// The last three corners. False if they have no area, unless that is forced.
  bool CutLast()
  {
    Index i = 0;
    while (i < static_cast<Index>(this->Version.size()) && !this->Shape.IsThere(i))
    {
      ++i;
    }
    if (this->Shape.GetRemaining() < 3)
    {
      return true;
    }
    this->Triangles.insert(
      this->Triangles.end(), { this->Shape.Previous(i), i, this->Shape.Next(i) });
    return this->Force || this->Shape.IsConvex(i);
  }

  Polygon Shape;
  Grid InTheWay;
  bool Force;
  /// What is left crosses itself: corners are cut whatever is in the way.
  bool Forced = false;
  /// How often a corner has got other neighbours.
  std::vector<Index> Version;
  std::priority_queue<Ear, std::vector<Ear>, std::greater<Ear>> Ears;
  /// The ears that each corner is in the way of.
  std::vector<std::vector<Ear>> Waiting;
  std::vector<Index> Triangles;
};
}

bool ReturnsToPlaces(const std::vector<Vector3>& corners)
{
  const std::size_t number = corners.size();
  const auto isReturn = [&](std::size_t i, std::size_t later)
  { return corners[i] == corners[later] && later - i > 1 && later - i + 1 < number; };
  constexpr std::size_t few = 16;
  if (number <= few)
  {
    for (std::size_t i = 0; i < number; ++i)
    {
      for (std::size_t later = i + 2; later < number; ++later)
      {
        if (isReturn(i, later))
        {
          return true;
        }
      }
    }
    return false;
  }
  std::vector<std::size_t> order(number);
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(),
    [&](std::size_t i, std::size_t j)
    {
      const Vector3& a = corners[i];
      const Vector3& b = corners[j];
      return a.x() != b.x() ? a.x() < b.x()
        : a.y() != b.y()    ? a.y() < b.y()
        : a.z() != b.z()    ? a.z() < b.z()
                            : i < j;
    });
  for (std::size_t k = 0; k + 1 < number; ++k)
  {
    if (isReturn(order[k], order[k + 1]))
    {
      return true;
    }
  }
  return false;
}

std::vector<Index> CutEars(const std::vector<Vector3>& corners, bool force)
{
  if (corners.size() < 3)
  {
    return {};
  }
  const std::vector<Vector3> normalized = Normalized(corners);
  Vector3 normal = NormalOf(normalized);
  if (normal.isZero(0.0))
  {
    if (!force)
    {
      return {};
    }
    normal = Vector3::UnitZ();
  }
  return Cutting(normalized, normal, force).CutAll();
}
}
