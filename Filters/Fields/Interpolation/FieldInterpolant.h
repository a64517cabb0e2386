// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FieldInterpolant_h
#define DirectionFields_FieldInterpolant_h

#include "Geometry/IntrinsicGeometry.h"

#include <array>
#include <cmath>

namespace DirectionFields::Internal
{
/// A triangle laid flat, its corners as complex numbers in the unit of its component: corner 0 at
/// 0, corner 1 on the positive real axis, corner 2 above that.
class FlatTriangle
{
public:
  FlatTriangle(const IntrinsicGeometry& geometry, Index triangle);

  const Complex& Corner(int c) const { return this->Corners[c]; }
  /// Unit number along the edge from corner c to the next one.
  const Complex& Along(int c) const { return this->Edges[c]; }
  double Length(int c) const { return this->Lengths[c]; }
  double Area() const { return this->Area_; }

  /// Barycentric coordinates of a place, negative beyond an edge; they sum up to 1.
  std::array<double, 3> Weights(const Complex& place) const
  {
    const double first = this->Weight(0, place);
    const double second = this->Weight(1, place);
    return { first, second, 1.0 - first - second };
  }
  double Weight(int c, const Complex& place) const
  {
    const Complex offset = place - this->Corners[(c + 1) % 3];
    const Complex& slope = this->Slopes[c];
    return slope.real() * offset.real() + slope.imag() * offset.imag();
  }
  /// The gradient of barycentric coordinate c.
  const Complex& Slope(int c) const { return this->Slopes[c]; }
  Complex Place(const std::array<double, 3>& weights) const
  {
    return weights[1] * this->Corners[1] + weights[2] * this->Corners[2];
  }

private:
  std::array<Complex, 3> Corners, Edges, Slopes;
  std::array<double, 3> Lengths;
  double Area_;
};

/// A section of degree n on a triangle, not only at its corners: the n-th power q(z) of the
/// directions at each place z of the triangle laid flat, whose n directions stand at the angles
/// (arg q(z) + 2 pi k) / n from the edge from corner 0 to corner 1.
///
/// It is the section that the operators of the field mean, that of KCPS13, section 6.1 (hat
/// functions times the corners' vectors carried along straight rays), with the rays of the cones at
/// the corners laid onto those of the flat triangle:
///
///     q(z) = sum over corners c of b_c(z) u_c exp(i n (E_c - theta_c + (1 - s_c) g_c(z)))
///
/// with barycentric coordinates b, the corner's vector u, the angles E and theta of the half-edge
/// that starts there in the flat triangle and in the vertex's cone, the vertex's scale s and the
/// angle g_c(z) from that half-edge to z. Consequences:
/// - at a corner, q is u, whatever ray leads there;
/// - on an edge, measured against the edge, q is the linear blend of its ends, hence the same from
///   both triangles: lines of the field go on across edges without a bend;
/// - around the triangle, q winds as often as Singularities.h says, if the turns n (s - 1) alpha at
///   the corners are counted: its zeros, counted with their signs, add up to the triangle's index;
/// - it depends on lengths only, and not on numbers, position or scale.
class FieldInterpolant
{
public:
  /// @param section the representation vector of each vertex of the mesh
  FieldInterpolant(
    const IntrinsicGeometry& geometry, int degree, const Complex* section, Index triangle);

  const FlatTriangle& Flat() const { return this->Shape; }
  int Degree() const { return this->N; }

  /// q. At a corner itself it is that from the half-edge that starts there.
  Complex At(const Complex& place) const;

  /// q(z + dz) ~ Value + AlongZ dz + AlongConjugate conj(dz).
  struct Jet
  {
    Complex Value, AlongZ, AlongConjugate;

    Complex Times(const Complex& step) const
    {
      return this->AlongZ * step + this->AlongConjugate * std::conj(step);
    }
    /// Positive where q turns like z, negative where it turns against z.
    double Determinant() const { return std::norm(this->AlongZ) - std::norm(this->AlongConjugate); }
  };
  /// Not at a corner.
  Jet JetAt(const Complex& place) const;

  /// The directions' angle at a corner: where the direction that has an angle in the cone of the
  /// vertex stands, on the ray to a place, in the flat triangle.
  double AngleInFlat(int corner, double angleInCone, const Complex& place) const;

private:
  /// The angle from the half-edge at a corner to a place, at least 0 inside of the triangle.
  double RayAngle(int corner, const Complex& place) const;

  FlatTriangle Shape;
  int N;
  /// u_c exp(i n (E_c - theta_c)).
  std::array<Complex, 3> Power;
  /// 1 - s_c, and theta_c.
  std::array<double, 3> Excess, ConeAngle;
};

/// exp(i angle). Small angles, which are almost all there are on fine meshes, take a third of the
/// time.
inline Complex UnitNumber(double angle)
{
  constexpr double small = 0.25;
  if (!(std::abs(angle) < small))
  {
    return { std::cos(angle), std::sin(angle) };
  }
  // Taylor series; the omitted terms are below rounding.
  const double x = angle * angle;
  const double cosine = 1.0 +
    x *
      (-1.0 / 2 +
        x *
          (1.0 / 24 + x * (-1.0 / 720 + x * (1.0 / 40320 + x * (-1.0 / 3628800 + x / 479001600)))));
  const double sine = 1.0 +
    x *
      (-1.0 / 6 + x * (1.0 / 120 + x * (-1.0 / 5040 + x * (1.0 / 362880 + x * (-1.0 / 39916800)))));
  return { cosine, angle * sine };
}

/// The argument of a complex number, -pi to pi. Small ones take a third of the time.
inline double AngleOf(const Complex& z)
{
  constexpr double small = 0.1;
  if (!(z.real() > 0.0 && std::abs(z.imag()) < small * z.real()))
  {
    return std::atan2(z.imag(), z.real());
  }
  const double tangent = z.imag() / z.real();
  const double x = tangent * tangent;
  return tangent *
    (1.0 +
      x *
        (-1.0 / 3 +
          x *
            (1.0 / 5 +
              x * (-1.0 / 7 + x * (1.0 / 9 + x * (-1.0 / 11 + x * (1.0 / 13 - x / 15)))))));
}

/// An integer power of a complex number.
inline Complex IntegerPower(Complex base, int exponent)
{
  Complex power = 1.0;
  for (; exponent > 0; exponent /= 2, base *= base)
  {
    if (exponent % 2 == 1)
    {
      power *= base;
    }
  }
  return power;
}
}

#endif
