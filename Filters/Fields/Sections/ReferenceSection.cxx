// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Sections/ReferenceSection.h"

#include "Support/MortonCurve.h"
#include "Support/Threads.h"
#include "Support/VectorMath.h"

#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// A sum below this part of the sum of absolute values cancels by symmetry.
constexpr double Cancelled = 1e-3;
Complex IntegerPower(Complex z, int exponent)
{
  Complex power = 1.0;
  for (; exponent > 0; exponent /= 2)
  {
    power *= exponent % 2 == 1 ? z : Complex(1.0);
    z *= z;
  }
  return power;
}
}

ReferenceSection::ReferenceSection(
  const SurfaceGeometry& geometry, const TriangleMesh::Component& component, int degree)
  : Frames(geometry.Frames)
  , Positions(geometry.Positions)
  , Component(component)
  , Degree(degree)
{
  const auto box = ParallelSum(component.Vertices(), MediumPiece, BoundingBox{},
    [&](Index begin, Index end)
    {
      BoundingBox part;
      for (Index v = begin; v < end; ++v)
      {
        part.Add(this->Positions[component.FirstVertex + v]);
      }
      return part;
    });
  this->SetBox(box.Low, box.High);
}

void ReferenceSection::SetBox(const Vector3& lower, const Vector3& upper)
{
  this->Center = 0.5 * lower + 0.5 * upper;
  const double size = (upper - lower).maxCoeff();
  this->HalfSize = size > 0.0 ? 0.5 * size : 1.0;
}

Complex ReferenceSection::Power(Index vertex, const Vector3& v) const
{
  const Complex z = this->Frames.Tangential(this->Component.FirstVertex + vertex, v);
  const double length = Modulus(z);
  return length > 0.0 ? length * IntegerPower(z / length, this->Degree) : Complex(0.0);
}

Vector3 ReferenceSection::Position(Index vertex) const
{
  return (this->Positions[this->Component.FirstVertex + vertex] - this->Center) / this->HalfSize;
}

ComplexVector ReferenceSection::Start() const
{
  ComplexVector start(this->Component.Vertices());
  ParallelFor(this->Component.Vertices(), MediumPiece,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        const Vector3 p = this->Position(v);
        // Irregular coefficients, so that no symmetry of the surface makes the section orthogonal
        // to the eigenvector.
        const Vector3 field(
          0.83 + 0.31 * p[1] - 0.24 * p[2] + 0.17 * std::sin(1.3 * p[0] + 2.1 * p[1]),
          0.47 - 0.38 * p[0] + 0.29 * p[2] + 0.19 * std::sin(1.7 * p[1] + 0.9 * p[2] + 0.4),
          0.29 + 0.22 * p[0] - 0.35 * p[1] + 0.23 * std::sin(2.3 * p[2] - 1.1 * p[0] + 0.7));
        start[v] = this->Power(v, field);
      }
    });
  if (!(start.norm() > 0.0))
  {
    start.setOnes();
  }
  return start;
}

bool ReferenceSection::Overlap::Decides() const
{
  return std::abs(this->Sum) > Cancelled * this->Size && this->Size > 0.0;
}

ReferenceSection::Overlap ReferenceSection::OverlapWith(
  int axis, const ComplexVector& u, const std::vector<char>& counts) const
{
  return ParallelSum(static_cast<Index>(u.size()), MediumPiece, Overlap{},
    [&](Index begin, Index end)
    {
      Overlap part;
      for (Index v = begin; v < end; ++v)
      {
        if (counts.empty() || counts[v])
        {
          const Complex term = std::conj(u[v]) * this->Power(v, Vector3::Unit(axis));
          part.Sum += term;
          part.Size += Modulus(term);
        }
      }
      return part;
    });
}

ReferenceSection::Candidate ReferenceSection::FindCandidate(
  const ComplexVector& u, const std::vector<char>& counts) const
{
  const Vector3 oblique(0.37, 0.23, 0.11);
  Candidate found = ParallelSum(static_cast<Index>(u.size()), MediumPiece, Candidate{},
    [&](Index begin, Index end)
    {
      Candidate part;
      for (Index v = begin; v < end; ++v)
      {
        if (counts.empty() || counts[v])
        {
          part += Candidate{ Modulus(u[v]) * (2.0 + oblique.dot(this->Position(v))), v, 0.0 };
        }
      }
      return part;
    });
  if (found.Value >= 0.0)
  {
    found.Overlap = std::conj(u[found.Vertex]) * this->Power(found.Vertex, oblique);
  }
  return found;
}

void ReferenceSection::FixPhase(ComplexVector& u) const
{
  const auto turn = [&](const Complex& overlap)
  {
    const Complex phase = overlap / std::abs(overlap);
    ParallelFor(static_cast<Index>(u.size()), MediumPiece,
      [&](Index begin, Index end) { u.segment(begin, end - begin) *= phase; });
  };
  for (int axis = 0; axis < 3; ++axis)
  {
    const Overlap overlap = this->OverlapWith(axis, u, {});
    if (overlap.Decides())
    {
      turn(overlap.Sum);
      return;
    }
  }
  const Complex overlap = this->FindCandidate(u, {}).Overlap;
  if (std::abs(overlap) > 0.0)
  {
    turn(overlap);
  }
}

void TurnTowards(const ComplexVector& reference, bool isCover, ComplexVector& u)
{
  Complex sum = u.dot(reference);
  if (std::abs(sum) <= 1e-3 * u.cwiseAbs().dot(reference.cwiseAbs()))
  {
    return;
  }
  if (isCover)
  {
    sum = sum.real() < 0.0 ? -1.0 : 1.0;
  }
  u *= sum / std::abs(sum);
}
}
