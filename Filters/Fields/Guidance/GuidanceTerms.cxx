// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Guidance/GuidanceTerms.h"

#include "Matrices/OperatorProducts.h"
#include "Matrices/VectorOperations.h"
#include "Support/Threads.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// Calls set(v) at the given vertices and their neighbours, which are the rows that given values
/// enter.
template <typename Set>
void ForEachNear(const std::vector<Index>& given, const SparseMatrix& mass, const Set& set)
{
  for (const Index v : given)
  {
    for (SparseMatrix::InnerIterator it(mass, v); it; ++it)
    {
      set(it.row());
    }
  }
}

/// The largest of numbers, as ParallelSum adds them up.
struct Largest
{
  double Value = 0.0;
  Largest& operator+=(const Largest& other)
  {
    this->Value = std::max(this->Value, other.Value);
    return *this;
  }
};

}

Eigen::VectorXd VertexAreas(const SparseMatrix& mass)
{
  Eigen::VectorXd areas(mass.cols());
  ParallelFor(static_cast<Index>(mass.cols()), VectorPiece,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        areas[v] = 2.0 * mass.coeff(v, v).real();
      }
    });
  return areas;
}

void ClearNear(const std::vector<Index>& given, const SparseMatrix& mass, Eigen::VectorXd& areas)
{
  ForEachNear(given, mass, [&](Index v) { areas[v] = 0.0; });
}

double LargestPart(const ComplexVector& guidance, const Eigen::VectorXd& areas)
{
  return ParallelSum<Largest>(static_cast<Index>(guidance.size()), VectorPiece, {},
    [&](Index begin, Index end)
    {
      Largest part;
      for (Index v = begin; v < end; ++v)
      {
        if (areas[v] > 0.0)
        {
          part += { std::max(std::abs(guidance[v].real()), std::abs(guidance[v].imag())) };
        }
      }
      return part;
    })
    .Value;
}

namespace
{
/// The guidance scaled to modulus 1 in the mean square over the vertices whose area is not 0; empty
/// where the guidance is zero at all of them.
ComplexVector Normalized(ComplexVector guidance, const Eigen::VectorXd& areas)
{
  const auto rows = static_cast<Index>(guidance.size());
  // The guidance is divided by its largest part first, since squares of tiny guidance underflow.
  const double largest = LargestPart(guidance, areas);
  if (!(largest > 0.0))
  {
    return {};
  }
  // Real and imaginary part are divided one by one: a quotient of complex numbers squares the
  // divisor.
  ForRows(guidance,
    [&](Index begin, Index end)
    {
      guidance.segment(begin, end - begin).real() /= largest;
      guidance.segment(begin, end - begin).imag() /= largest;
    });
  const double squares = ParallelSum<double>(rows, VectorPiece, 0.0,
    [&](Index begin, Index end)
    {
      return areas.segment(begin, end - begin)
        .dot(guidance.segment(begin, end - begin).cwiseAbs2());
    });
  const double factor = std::sqrt(areas.sum() / squares);
  ForRows(
    guidance, [&](Index begin, Index end) { guidance.segment(begin, end - begin) *= factor; });
  return guidance;
}
}

GuidanceTerms::GuidanceTerms(const Operators& operators, const ComponentGuide& guide)
  : Guidance(guide.Guidance)
  , GivenVertices(guide.Given.Vertices)
{
  Eigen::VectorXd areas = VertexAreas(operators.Mass);
  this->Area = areas.sum();
  ClearNear(this->GivenVertices, operators.Mass, areas);
  const ComplexVector scaled = Normalized(this->Guidance, areas);
  if (scaled.size() > 0)
  {
    this->MassTimes = Product(operators.Mass, scaled);
  }
}

bool GuidanceTerms::Fit(const ComponentGuide& guide) const
{
  return this->GivenVertices == guide.Given.Vertices &&
    this->Guidance.size() == guide.Guidance.size() && Equal(this->Guidance, guide.Guidance);
}

ComplexVector GuidanceTerms::RightHandSide(const Operators& operators, double factor) const
{
  if (!this->Any())
  {
    return ComplexVector::Zero(operators.Energy.rows());
  }
  ComplexVector b = Uninitialized(this->MassTimes.size());
  ForRows(b,
    [&](Index begin, Index end)
    { b.segment(begin, end - begin) = factor * this->MassTimes.segment(begin, end - begin); });
  ForEachNear(this->GivenVertices, operators.Mass, [&](Index v) { b[v] = 0.0; });
  return b;
}
}
