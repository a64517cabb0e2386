// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Sections/ShapePhase.h"

#include "Support/Threads.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// The sum decides where it is larger than this many standard deviations of a sum of as many
/// independent directions, and more than this part of the sum without any cancellation.
constexpr double Significant = 5.0;
constexpr double LeastAgreement = 0.02;
/// A surface that is bent by less than this all in all, relative to the root of its area, counts as
/// flat.
constexpr double LeastBend = 1e-3;

/// Sums over the vertices.
struct Agreement
{
  Complex Sum = 0.0;
  double Squares = 0.0;
  double Size = 0.0;

  void operator+=(const Agreement& other)
  {
    this->Sum += other.Sum;
    this->Squares += other.Squares;
    this->Size += other.Size;
  }
};

/// The direction in which the surface is bent least at a vertex, to the power of the degree, times
/// the angles by which edges along it are bent more than those across, times their lengths.
Complex LeastBent(const SurfaceGeometry& geometry, const std::vector<double>& dihedralAngles,
  Index v, int degree, std::vector<Index>& fan)
{
  const TriangleMesh& mesh = geometry.Mesh;
  Complex along = 0.0;
  double mean = 0.0;
  mesh.GetFan(v, fan);
  for (const Index h : fan)
  {
    const double bend =
      dihedralAngles[mesh.Edge(h)] * std::sqrt(geometry.Lengths.SquaredLength[mesh.Edge(h)]);
    along += bend * std::polar(1.0, 2.0 * geometry.Transport.EdgeAngle[h]);
    mean += bend;
  }
  const double size = std::abs(along);
  if (!(size > 0.0))
  {
    return 0.0;
  }
  // Crosses are the same along and across. For the others the curvature of larger modulus has the
  // sign of the mean, and is larger by no more than twice that.
  const int power = degree / 2;
  const double weight = power % 2 == 0 ? size : std::clamp(mean, -size, size);
  return weight * std::pow(along / size, power);
}
}

void TurnTowardsShape(const SurfaceGeometry& geometry, const std::vector<double>& dihedralAngles,
  std::size_t c, int degree, ComplexVector& u)
{
  const TriangleMesh::Component& component = geometry.Mesh.GetComponents()[c];
  if (degree % 2 != 0 || component.IsCover)
  {
    return;
  }
  const Agreement agreement = ParallelSum(component.Vertices(), MediumPiece, Agreement{},
    [&](Index begin, Index end)
    {
      Agreement part;
      std::vector<Index> fan;
      for (Index v = begin; v < end; ++v)
      {
        const Complex term = std::conj(u[v]) *
          LeastBent(geometry, dihedralAngles, component.FirstVertex + v, degree, fan);
        part += { term, std::norm(term), std::abs(term) };
      }
      return part;
    });
  const double least = std::max({ Significant * std::sqrt(agreement.Squares),
    LeastAgreement * agreement.Size, LeastBend * std::sqrt(geometry.Lengths.ComponentArea[c]) });
  const double size = std::abs(agreement.Sum);
  if (!(size > least))
  {
    return;
  }
  const Complex phase = agreement.Sum / size;
  ParallelFor(component.Vertices(), MediumPiece,
    [&](Index begin, Index end) { u.segment(begin, end - begin) *= phase; });
}
}
