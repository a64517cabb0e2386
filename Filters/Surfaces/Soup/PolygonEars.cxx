// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Soup/PolygonEars.h"

#include "Soup/CutPolygon.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <queue>

namespace DirectionFields
{
namespace
{
/// Most cells of the grid along an axis.
constexpr double MostCells = 1024.0;

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
  std::vector<Vector3> normalized(corners.size(), Vector3(Vector3::Zero()));
  if (half.maxCoeff() > 0.0)
  {
    // A power of two, which rounds nothing: points on one line stay there.
    int exponent = 0;
    std::frexp(half.maxCoeff(), &exponent);
    const double halfSize = std::ldexp(0.5, std::max(exponent, -1021));
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      normalized[i] = (0.5 * corners[i] - 0.5 * lower - 0.5 * half) / halfSize;
    }
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

/// The corners that can be in the way of ears, those that are not convex, in square cells.
class Grid
{
public:
  explicit Grid(const CutPolygon& polygon)
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

  /// Looks whether a corner is still there and not convex. Once that holds for half of them only,
  /// the cells are made again.
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
  Index FindBlocker(Index ear, bool isWide) const
  {
    const CutPolygon::Place& a = this->Shape.At(this->Shape.Previous(ear));
    const CutPolygon::Place& b = this->Shape.At(ear);
    const CutPolygon::Place& c = this->Shape.At(this->Shape.Next(ear));
    constexpr double margin = CutPolygon::Nearness * CutPolygon::LargestCoordinate;
    const double left = std::min({ a.X, b.X, c.X }) - margin;
    const double right = std::max({ a.X, b.X, c.X }) + margin;
    const double low = std::min({ a.Y, b.Y, c.Y }) - margin;
    const double high = std::max({ a.Y, b.Y, c.Y }) + margin;
    for (std::size_t y = this->Along(low); y <= this->Along(high); ++y)
    {
      const std::size_t row = y * static_cast<std::size_t>(this->Across);
      const std::size_t end = this->Begin[row + this->Along(right) + 1];
      for (std::size_t k = this->Begin[row + this->Along(left)]; k < end; ++k)
      {
        const Index i = this->Members[k];
        const CutPolygon::Place& at = this->Shape.At(i);
        if (at.X >= left && at.X <= right && at.Y >= low && at.Y <= high && this->IsIn[i] &&
          this->Shape.Blocks(i, ear, isWide))
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
    const double part = 0.5 + 0.5 * coordinate / CutPolygon::LargestCoordinate;
    return static_cast<std::size_t>(std::clamp(this->Across * part, 0.0, this->Across - 1.0));
  }
  std::size_t CellOf(const CutPolygon::Place& at) const
  {
    return this->Along(at.Y) * static_cast<std::size_t>(this->Across) + this->Along(at.X);
  }

  const CutPolygon& Shape;
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
        if (this->Stage == Care::None || (this->Stage == Care::Exact && !this->Force))
        {
          return {};
        }
        this->Stage = this->Stage == Care::Wide ? Care::Exact : Care::None;
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
      const Index blocker = this->Stage == Care::None
        ? None
        : this->InTheWay.FindBlocker(ear.Corner, this->Stage == Care::Wide);
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
    const bool takesAll = this->Stage == Care::None;
    const bool isEar = this->Shape.IsConvex(i) && (takesAll || this->Shape.OpensInwards(i));
    if (isEar || takesAll)
    {
      // Corners that are not convex are cut in turns, so that few triangles meet in a corner.
      this->Ears.push(
        { isEar ? this->Shape.Measure(i) : CutPolygon::Worst * (1.0 + 1e-9 * this->Version[i]), i,
          this->Version[i] });
    }
  }

  /// Checks a corner again around which something has changed, and the ears that wait for it.
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
      const bool goesOn = isNow && this->InTheWay.Has(i) &&
        this->Shape.Blocks(i, ear.Corner, this->Stage == Care::Wide);
      if (isNow && !goesOn)
      {
        this->Ears.push(ear);
      }
      return !goesOn;
    };
    waiting.erase(std::remove_if(waiting.begin(), waiting.end(), isOver), waiting.end());
  }

  /// Cuts off the corners after one that are at the same place, by triangles without area: others
  /// may have an edge in common with them.
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

  /// Removes corners around one where the polygon runs back along the edge that it came by, and so
  /// has no area. Returns the corner that is left there.
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

  CutPolygon Shape;
  Grid InTheWay;
  bool Force;
  /// The corners that keep an ear from being cut: all inside it or beside its diagonal; once no ear
  /// is left, all inside it; and once the rest of the polygon crosses itself, none.
  enum class Care
  {
    Wide,
    Exact,
    None
  };
  Care Stage = Care::Wide;
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
