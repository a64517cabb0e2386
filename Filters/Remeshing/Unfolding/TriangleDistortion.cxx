// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Unfolding/TriangleDistortion.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// How much a wrong area counts as against a wrong shape: little, since the integers decide on
/// the area.
constexpr double AreaWeight = 0.2;

double RootOf(double determinant, double epsilon)
{
  return std::sqrt(determinant * determinant + epsilon * epsilon);
}

/// (d + root) / 2 without cancellation where d is negative.
double ChiOf(double determinant, double root, double epsilon)
{
  return determinant > 0.0 ? 0.5 * (determinant + root)
                           : 0.5 * epsilon * epsilon / (root - determinant);
}

double SumOf(const TriangleDistortion::Derivative& j, double determinant)
{
  return j.squaredNorm() + AreaWeight * (determinant * determinant + 1.0);
}
}

double TriangleDistortion::ValueOf(const Derivative& j, double epsilon)
{
  const double d = Determinant(j);
  return SumOf(j, d) / ChiOf(d, RootOf(d, epsilon), epsilon);
}

TriangleDistortion::TriangleDistortion(const Derivative& j, double epsilon)
  : J(j)
{
  const double d = Determinant(j);
  const double root = RootOf(d, epsilon);
  const double chi = ChiOf(d, root, epsilon);
  const double sum = SumOf(j, d);
  this->Value = sum / chi;
  // The derivatives of 1 / chi by d are -first and second.
  const double first = 1.0 / (root * chi);
  const double second = 2.0 / (root * root * root);
  const double byDeterminant = AreaWeight * 2.0 * d / chi - sum * first;
  this->Of = { 2.0 / chi, byDeterminant, AreaWeight * (2.0 / chi - 4.0 * d * first) + sum * second,
    -2.0 * first };
  const Derivative cofactors(j[3], -j[2], -j[1], j[0]);
  this->Gradient = 2.0 / chi * j + byDeterminant * cofactors;
  Eigen::Matrix4d ofDeterminant = Eigen::Matrix4d::Zero();
  ofDeterminant(0, 3) = ofDeterminant(3, 0) = 1.0;
  ofDeterminant(1, 2) = ofDeterminant(2, 1) = -1.0;
  this->Hessian = this->Of.All * Eigen::Matrix4d::Identity() +
    this->Of.Mixed * (j * cofactors.transpose() + cofactors * j.transpose()) +
    this->Of.Squared * cofactors * cofactors.transpose() + this->Of.OfDeterminant * ofDeterminant;
}

namespace
{
/// An orthonormal basis of a plane whose first vector is along a given one.
struct Basis
{
  /// @param x, y of the given vector in an orthonormal basis
  Basis(double x, double y, const TriangleDistortion::Derivative& ofX,
    const TriangleDistortion::Derivative& ofY)
    : Length(std::hypot(x, y))
  {
    const double cos = this->Length > 0.0 ? x / this->Length : 1.0;
    const double sin = this->Length > 0.0 ? y / this->Length : 0.0;
    this->Along = cos * ofX + sin * ofY;
    this->Across = cos * ofY - sin * ofX;
  }
  double Length;
  TriangleDistortion::Derivative Along;
  TriangleDistortion::Derivative Across;
};
}

void TriangleDistortion::Convexify()
{
  // The maps that keep angles, and those that reflect: det J = (p.Length^2 - q.Length^2) / 2.
  const double half = std::sqrt(0.5);
  const Derivative& j = this->J;
  const Basis p(half * (j[0] + j[3]), half * (j[2] - j[1]), { half, 0.0, 0.0, half },
    { 0.0, -half, half, 0.0 });
  const Basis q(half * (j[0] - j[3]), half * (j[2] + j[1]), { half, 0.0, 0.0, -half },
    { 0.0, half, half, 0.0 });
  const double ofTurn = this->Of.All + this->Of.OfDeterminant;
  const double ofReflectedTurn = this->Of.All - this->Of.OfDeterminant;
  const double pp = ofTurn + (this->Of.Squared + 2.0 * this->Of.Mixed) * p.Length * p.Length;
  const double qq =
    ofReflectedTurn + (this->Of.Squared - 2.0 * this->Of.Mixed) * q.Length * q.Length;
  const double pq = -this->Of.Squared * p.Length * q.Length;
  const double middle = 0.5 * (pp + qq);
  const double difference = 0.5 * (pp - qq);
  const double radius = std::hypot(difference, pq);
  if (ofTurn >= 0.0 && ofReflectedTurn >= 0.0 && middle >= radius)
  {
    return;
  }
  // Both eigenvalues of the plane of p and q, as a mean and half the difference.
  const double larger = std::max(0.0, middle + radius);
  const double smaller = std::max(0.0, middle - radius);
  const double mean = 0.5 * (larger + smaller);
  const double scale = radius > 0.0 ? 0.5 * (larger - smaller) / radius : 0.0;
  const Derivative ofP = (mean + scale * difference) * p.Along + scale * pq * q.Along;
  const Derivative ofQ = (mean - scale * difference) * q.Along + scale * pq * p.Along;
  this->Hessian = std::max(0.0, ofTurn) * p.Across * p.Across.transpose() +
    std::max(0.0, ofReflectedTurn) * q.Across * q.Across.transpose() + ofP * p.Along.transpose() +
    ofQ * q.Along.transpose();
}
}
