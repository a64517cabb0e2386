// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Soup/CutPolygon.h"

#include "Support/VectorMath.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
CutPolygon::CutPolygon(const std::vector<Vector3>& corners, const Vector3& normal)
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

void CutPolygon::Remove(Index i)
{
  this->NextOf[this->PreviousOf[i]] = this->NextOf[i];
  this->PreviousOf[this->NextOf[i]] = this->PreviousOf[i];
  this->NextOf[i] = None;
  --this->Remaining;
}

int CutPolygon::Turn(Index i, Index j, Index k) const
{
  const Place& a = this->Places[i];
  const Place& b = this->Places[j];
  const Place& c = this->Places[k];
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

double CutPolygon::Measure(Index i) const
{
  const Vector3& a = this->Corners[this->Previous(i)];
  const Vector3& b = this->Corners[i];
  const Vector3& c = this->Corners[this->Next(i)];
  const double area = (b - a).cross(c - a).norm();
  const double perimeter = (b - a).norm() + (c - b).norm() + (a - c).norm();
  return area > 0.0 ? std::min(perimeter * perimeter / area, 0.5 * Worst) : 0.5 * Worst;
}

bool CutPolygon::OpensInwards(Index i) const
{
  const Index a = this->Previous(i);
  const Index c = this->Next(i);
  const Index before = this->Previous(a);
  const Index after = this->Next(c);
  // A loop may be closed, which leaves nothing behind it.
  return (!this->IsConvex(a) || this->At(before) == this->At(c) || this->Turn(a, c, before) > 0) &&
    (!this->IsConvex(c) || this->At(after) == this->At(a) || this->Turn(c, after, a) > 0);
}

bool CutPolygon::Blocks(Index blocker, Index ear, bool isWide) const
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
    return isWide && first > 0 && second > 0 && this->IsNear(c, a, blocker);
  }
  // The polygon may touch the ear's sides from outside.
  const auto goesIn = [&](Index from, Index to)
  {
    return this->Turn(from, to, this->Previous(blocker)) > 0 ||
      this->Turn(from, to, this->Next(blocker)) > 0;
  };
  return first == 0 ? goesIn(a, ear) : (second == 0 ? goesIn(ear, c) : true);
}

bool CutPolygon::IsNear(Index a, Index b, Index corner) const
{
  const double x = this->At(b).X - this->At(a).X;
  const double y = this->At(b).Y - this->At(a).Y;
  const double across =
    x * (this->At(corner).Y - this->At(a).Y) - y * (this->At(corner).X - this->At(a).X);
  return std::abs(across) <= Nearness * LargestCoordinate * std::hypot(x, y);
}
}
