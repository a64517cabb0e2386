// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Interpolation/FieldInterpolant.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
FlatTriangle::FlatTriangle(const IntrinsicGeometry& geometry, Index triangle)
{
  const Index h = 3 * triangle;
  std::array<double, 3> squared;
  for (int c = 0; c < 3; ++c)
  {
    squared[c] = geometry.Lengths.SquaredLength[geometry.Mesh.Edge(h + c)];
    this->Lengths[c] = std::sqrt(squared[c]);
  }
  this->Area_ = geometry.Lengths.Area[triangle];
  const double base = this->Lengths[0];
  this->Corners[0] = 0.0;
  this->Corners[1] = base;
  this->Corners[2] =
    Complex(0.5 * (squared[0] + squared[2] - squared[1]) / base, 2.0 * this->Area_ / base);
  const double perArea = 0.5 / this->Area_;
  for (int c = 0; c < 3; ++c)
  {
    const Complex edge = this->Corners[(c + 1) % 3] - this->Corners[c];
    this->Edges[c] = edge * (1.0 / std::sqrt(std::norm(edge)));
    const Complex opposite = this->Corners[(c + 2) % 3] - this->Corners[(c + 1) % 3];
    this->Slopes[c] = Complex(-opposite.imag(), opposite.real()) * perArea;
  }
}

FieldInterpolant::FieldInterpolant(
  const IntrinsicGeometry& geometry, int degree, const Complex* section, Index triangle)
  : Shape(geometry, triangle)
  , N(degree)
{
  for (int c = 0; c < 3; ++c)
  {
    const Index h = 3 * triangle + c;
    const Index vertex = geometry.Mesh.Tail(h);
    const double angle = geometry.Transport.EdgeAngle[h];
    this->ConeAngle[c] = angle;
    this->Excess[c] = 1.0 - geometry.Transport.Scale[vertex];
    this->Power[c] = section[vertex] * std::polar(1.0, -degree * angle) *
      IntegerPower(this->Shape.Along(c), degree);
  }
}

double FieldInterpolant::RayAngle(int corner, const Complex& place) const
{
  const Complex ray = (place - this->Shape.Corner(corner)) * std::conj(this->Shape.Along(corner));
  if (ray == 0.0)
  {
    return 0.0;
  }
  // On the half-edge rounding may put the place on either side of it.
  const double angle = std::atan2(ray.imag(), ray.real());
  return angle > -0.5 * Pi ? angle : angle + 2.0 * Pi;
}

Complex FieldInterpolant::At(const Complex& place) const
{
  Complex sum = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    Complex power = this->Shape.Weight(c, place) * this->Power[c];
    if (this->Excess[c] != 0.0)
    {
      const double turn = this->N * this->Excess[c] * this->RayAngle(c, place);
      power *= UnitNumber(turn);
    }
    sum += power;
  }
  return sum;
}

FieldInterpolant::Jet FieldInterpolant::JetAt(const Complex& place) const
{
  Jet jet{ 0.0, 0.0, 0.0 };
  for (int c = 0; c < 3; ++c)
  {
    const double weight = this->Shape.Weight(c, place);
    const Complex& slope = this->Shape.Slope(c);
    Complex power = this->Power[c];
    Complex turning = 0.0;
    if (this->Excess[c] != 0.0)
    {
      const double factor = this->N * this->Excess[c];
      const double turn = factor * this->RayAngle(c, place);
      power *= UnitNumber(turn);
      turning = factor * weight / (place - this->Shape.Corner(c));
    }
    jet.Value += weight * power;
    jet.AlongZ += 0.5 * power * (std::conj(slope) + turning);
    jet.AlongConjugate += 0.5 * power * (slope - std::conj(turning));
  }
  return jet;
}

double FieldInterpolant::AngleInFlat(int corner, double angleInCone, const Complex& place) const
{
  return angleInCone - this->ConeAngle[corner] + std::arg(this->Shape.Along(corner)) +
    this->Excess[corner] * this->RayAngle(corner, place);
}
}
