// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_IntegerGrid_h
#define DirectionFields_IntegerGrid_h

#include "Types.h"

#include <cstdint>

namespace DirectionFields::Internal
{
/// A point a + b zeta of the plane, zeta = exp(2 pi i / n), in fixed-point numbers: multiples of 1
/// / IntegerGrid::Unit. It is a grid point where both are multiples of IntegerGrid::Unit.
struct GridPoint
{
  std::int64_t A = 0;
  std::int64_t B = 0;

  friend GridPoint operator+(const GridPoint& p, const GridPoint& q)
  {
    return { p.A + q.A, p.B + q.B };
  }
  friend GridPoint operator-(const GridPoint& p, const GridPoint& q)
  {
    return { p.A - q.A, p.B - q.B };
  }
  GridPoint operator-() const { return { -this->A, -this->B }; }
  friend bool operator==(const GridPoint& p, const GridPoint& q)
  {
    return p.A == q.A && p.B == q.B;
  }
  friend bool operator!=(const GridPoint& p, const GridPoint& q) { return !(p == q); }
};

/// z -> zeta^Turn z + Shift: from the coordinates of one chart to those of another.
struct Transition
{
  /// 0 ... n - 1
  int Turn = 0;
  /// A grid point.
  GridPoint Shift;

  friend bool operator==(const Transition& s, const Transition& t)
  {
    return s.Turn == t.Turn && s.Shift == t.Shift;
  }
};

/// The integer grid Z[zeta] of the squares (degree 4) or of the equilateral triangles (degree 6) of
/// side 1, and exact predicates on its plane: no rounding makes two triangles of a map disagree.
class IntegerGrid
{
public:
  static constexpr int Bits = 18;
  static constexpr std::int64_t Unit = std::int64_t(1) << Bits;
  /// The modulus of coordinates is smaller than this, in units of the grid.
  static constexpr double Range = 1048576.0;

  /// @param degree 4 or 6
  explicit IntegerGrid(int degree)
    : Degree(degree)
  {
  }
  int GetDegree() const { return this->Degree; }
  /// k modulo n, 0 ... n - 1.
  int Wrapped(int k) const
  {
    const int turn = k % this->Degree;
    return turn < 0 ? turn + this->Degree : turn;
  }

  /// zeta^k p
  GridPoint Turned(GridPoint p, int k) const
  {
    for (int turn = this->Wrapped(k); turn > 0; --turn)
    {
      p = this->Degree == 4 ? GridPoint{ -p.B, p.A } : GridPoint{ -p.B, p.A + p.B };
    }
    return p;
  }
  GridPoint Apply(const Transition& t, const GridPoint& p) const
  {
    return this->Turned(p, t.Turn) + t.Shift;
  }
  /// First t, then s.
  Transition Composed(const Transition& s, const Transition& t) const
  {
    return { this->Wrapped(s.Turn + t.Turn), this->Apply(s, t.Shift) };
  }
  Transition Inverse(const Transition& t) const
  {
    return { this->Wrapped(-t.Turn), -this->Turned(t.Shift, -t.Turn) };
  }

  /// As a complex number, in units of the grid.
  Complex Place(const GridPoint& p) const
  {
    return this->Combined(static_cast<double>(p.A) / Unit, static_cast<double>(p.B) / Unit);
  }
  /// a + b zeta
  Complex Combined(double a, double b) const
  {
    return this->Degree == 4 ? Complex(a, b) : Complex(a + 0.5 * b, HalfRootOfThree * b);
  }
  /// a and b of a complex number.
  std::array<double, 2> Coordinates(const Complex& z) const
  {
    const double b = this->Degree == 4 ? z.imag() : z.imag() / HalfRootOfThree;
    return { this->Degree == 4 ? z.real() : z.real() - 0.5 * b, b };
  }
  /// zeta^k
  Complex Root(int k) const { return std::polar(1.0, 2.0 * Pi * this->Wrapped(k) / this->Degree); }

  static bool IsGridPoint(const GridPoint& p)
  {
    return (p.A & (Unit - 1)) == 0 && (p.B & (Unit - 1)) == 0;
  }

  /// The sign of the area of the triangle p, q, r: 1 where it is counter-clockwise.
  static int Orientation(const GridPoint& p, const GridPoint& q, const GridPoint& r);
  /// Whether s is inside of the circle through p, q, r, which are counter-clockwise.
  bool IsInCircle(
    const GridPoint& p, const GridPoint& q, const GridPoint& r, const GridPoint& s) const;

private:
  static constexpr double HalfRootOfThree = 0.86602540378443864676;
  int Degree;
};
}

#endif
