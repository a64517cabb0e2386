// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Eigenpairs/DeflatedGradients.h"

#include "Matrices/VectorOperations.h"
#include "Support/Free.h"
#include "Support/Threads.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
constexpr int Width = SectionBlock::Width;
constexpr Index PieceRows = CompactMatrix::PieceRows;
/// The products of this many rows are added up in single precision, their sums in double precision.
constexpr Index FewRows = 256;
/// W gets K v for a section v where v^* K v is above this part of v^* A v; below it K nearly maps v
/// to 0, and W gets m v.
constexpr double SmallestPart = 0.01;
/// The work of a step besides its cycle (see WorkLimit).
constexpr double WorkPerEntry = 3.0;
constexpr double WorkPerRow = 40.0;

/// Products of a section with the four of a block, and another sum.
struct Sums
{
  std::array<double, Width> Real{};
  std::array<double, Width> Imaginary{};
  double Other = 0.0;

  Sums& operator+=(const Sums& other)
  {
    for (int b = 0; b < Width; ++b)
    {
      this->Real[b] += other.Real[b];
      this->Imaginary[b] += other.Imaginary[b];
    }
    this->Other += other.Other;
    return *this;
  }
  /// The products with the four sections.
  Eigen::Vector4cd WithBlock() const
  {
    Eigen::Vector4cd products;
    for (int b = 0; b < Width; ++b)
    {
      products[b] = Complex(this->Real[b], this->Imaginary[b]);
    }
    return products;
  }
};

/// The same in single precision, for a few rows.
struct FewSums
{
  CompactValues<Width> Products;
  float Other = 0.0f;

  /// Adds conj(row v of the block) times a value.
  void Add(const CompactSections& block, Index v, float real, float imaginary)
  {
    const CompactValues<Width> x(block.data(), v);
    this->Products.Real += x.Real * real + x.Imaginary * imaginary;
    this->Products.Imaginary += x.Real * imaginary - x.Imaginary * real;
  }
  explicit operator Sums() const
  {
    Sums sums;
    for (int b = 0; b < Width; ++b)
    {
      sums.Real[b] = this->Products.Real[b];
      sums.Imaginary[b] = this->Products.Imaginary[b];
    }
    sums.Other = this->Other;
    return sums;
  }
};

/// Sums the contributions of body(v, sums) over the rows.
template <typename Body>
Sums SumRows(Index rows, const Body& body)
{
  return ParallelSum<Sums>(rows, PieceRows, {},
    [&](Index begin, Index end)
    {
      Sums sums;
      for (Index first = begin; first < end; first += FewRows)
      {
        FewSums few;
        const Index last = std::min(end, first + FewRows);
        for (Index v = first; v < last; ++v)
        {
          body(v, few);
        }
        sums += Sums(few);
      }
      return sums;
    });
}

/// The coefficients c = matrix * products of a linear combination of a block's four sections.
struct Coefficients
{
  Coefficients(const Eigen::Matrix4cd& matrix, const Eigen::Vector4cd& products)
  {
    const Eigen::Vector4cd c = matrix * products;
    this->Values.Real = c.real().cast<float>();
    this->Values.Imaginary = c.imag().cast<float>();
  }
  /// Row v of the linear combination.
  CompactComplex Times(const CompactSections& block, Index v) const
  {
    const CompactValues<Width> x(block.data(), v);
    return { (x.Real * this->Values.Real - x.Imaginary * this->Values.Imaginary).sum(),
      (x.Real * this->Values.Imaginary + x.Imaginary * this->Values.Real).sum() };
  }
  CompactValues<Width> Values;
};
}

DeflatedGradients::DeflatedGradients(
  const Hierarchy::Level& finest, const Cycle& cycle, const SectionBlock& deflated)
  : Finest(finest)
  , Preconditioner(cycle)
  , StepWork(cycle.Work() + WorkPerEntry * static_cast<double>(finest.Matrices.Energy.Entries()) +
      WorkPerRow * finest.Rows())
  , Deflated(deflated)
{
  const auto size = static_cast<std::size_t>(2) * finest.Rows();
  for (CompactSections* section :
    { &this->Solution, &this->Residual, &this->Direction, &this->Preconditioned, &this->Product })
  {
    section->resize(size);
  }
}

void DeflatedGradients::Prepare(double shift)
{
  const float* const mass = this->Finest.LumpedMass.data();
  const CompactSections& vectors = this->Deflated.Vectors;
  const CompactSections& energies = this->Deflated.Energy;
  // Real holds v^* A v and Imaginary v^* m v for each section v.
  const Sums values = SumRows(this->Deflated.Rows(),
    [&](Index v, FewSums& sums)
    {
      const CompactValues<Width> x(vectors.data(), v);
      const CompactValues<Width> energy(energies.data(), v);
      sums.Products.Real += x.Real * energy.Real + x.Imaginary * energy.Imaginary;
      sums.Products.Imaginary += mass[v] * (x.Real * x.Real + x.Imaginary * x.Imaginary);
    });
  // W = Real A V + Imaginary m V
  CompactValues<Width> factors;
  for (int b = 0; b < Width; ++b)
  {
    const bool byMatrix =
      b > 0 && values.Real[b] + shift * values.Imaginary[b] > SmallestPart * values.Real[b];
    factors.Real[b] = byMatrix ? 1.0f : 0.0f;
    factors.Imaginary[b] = byMatrix ? static_cast<float>(shift) : 1.0f;
  }
  this->Tested.resize(vectors.size());
  ParallelFor(this->Deflated.Rows(), PieceRows,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        const CompactValues<Width> x(vectors.data(), v);
        CompactValues<Width> tested(energies.data(), v);
        tested.Real = factors.Real * tested.Real + mass[v] * factors.Imaginary * x.Real;
        tested.Imaginary =
          factors.Real * tested.Imaginary + mass[v] * factors.Imaginary * x.Imaginary;
        tested.Store(this->Tested.data(), v);
      }
    });
  Eigen::Matrix4cd products =
    InnerProducts(this->Deflated.Rows(), { { &this->Tested, &vectors } }).front();
  for (int b = 0; b < Width; ++b)
  {
    // A section that is zero deflates nothing, whatever its diagonal entry.
    if (products(b, b) == 0.0)
    {
      products(b, b) = 1.0;
    }
  }
  this->Inverse = products.inverse();
  this->InverseAdjoint = this->Inverse.adjoint();
}

DeflatedGradients::Outcome DeflatedGradients::Solve(const ResidualOfSection& rightHandSide,
  double shift, double reduction, int mostSteps, SolveCounter& cycles, ComplexVector& solution)
{
  const Index rows = rightHandSide.Rows();
  const double size = rightHandSide.Norm;
  Outcome outcome;
  Resize(solution, rows);
  if (!(size > 0.0) || !std::isfinite(size))
  {
    solution.setZero();
    return outcome;
  }
  this->Prepare(shift);
  const double first = this->Begin(rightHandSide);
  double previous = 0.0;
  for (; outcome.Steps < mostSteps; ++outcome.Steps)
  {
    cycles.Next();
    cycles.Spend(this->StepWork);
    const double product = this->Precondition();
    this->Turn(outcome.Steps == 0 ? 0.0f : static_cast<float>(product / previous));
    previous = product;
    Eigen::Vector4cd along;
    const double form = this->Multiply(shift, along);
    if (!(form > 0.0))
    {
      outcome.Indefinite = true;
      this->Solution.swap(this->Direction);
      break;
    }
    const double rest = this->Advance(static_cast<float>(product / form), along);
    if (!(rest > reduction * reduction * first))
    {
      ++outcome.Steps;
      break;
    }
  }
  Free(this->Tested);
  ParallelFor(rows, PieceRows,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        solution[v] = size * Complex(this->Solution[2 * v], this->Solution[2 * v + 1]);
      }
    });
  return outcome;
}

double DeflatedGradients::Begin(const ResidualOfSection& rightHandSide)
{
  const Index rows = this->Finest.Rows();
  float* const t = this->Solution.data();
  float* const r = this->Residual.data();
  const Coefficients outside(this->InverseAdjoint,
    SumRows(rows,
      [&](Index v, FewSums& sums)
      {
        const Complex value = rightHandSide[v] / rightHandSide.Norm;
        sums.Add(this->Deflated.Vectors, v, static_cast<float>(value.real()),
          static_cast<float>(value.imag()));
      })
      .WithBlock());
  return SumRows(rows,
    [&](Index v, FewSums& sums)
    {
      const CompactComplex value =
        CompactComplex(rightHandSide[v] / rightHandSide.Norm) - outside.Times(this->Tested, v);
      r[2 * v] = value.real();
      r[2 * v + 1] = value.imag();
      t[2 * v] = 0.0f;
      t[2 * v + 1] = 0.0f;
      sums.Other += std::norm(value);
    })
    .Other;
}

double DeflatedGradients::Precondition()
{
  const Index rows = this->Finest.Rows();
  const float* const r = this->Residual.data();
  float* const z = this->Preconditioned.data();
  this->Preconditioner.Apply<1>(r, z);
  const Coefficients along(this->Inverse,
    SumRows(
      rows, [&](Index v, FewSums& sums) { sums.Add(this->Tested, v, z[2 * v], z[2 * v + 1]); })
      .WithBlock());
  return SumRows(rows,
    [&](Index v, FewSums& sums)
    {
      const CompactComplex out = along.Times(this->Deflated.Vectors, v);
      z[2 * v] -= out.real();
      z[2 * v + 1] -= out.imag();
      sums.Other += r[2 * v] * z[2 * v] + r[2 * v + 1] * z[2 * v + 1];
    })
    .Other;
}

void DeflatedGradients::Turn(float keep)
{
  const float* const z = this->Preconditioned.data();
  float* const p = this->Direction.data();
  ParallelFor(this->Finest.Rows(), PieceRows,
    [&](Index begin, Index end)
    {
      for (Index k = 2 * begin; k < 2 * end; ++k)
      {
        p[k] = keep == 0.0f ? z[k] : z[k] + keep * p[k];
      }
    });
}

double DeflatedGradients::Multiply(double shift, Eigen::Vector4cd& along)
{
  const CompactMatrix& matrix = this->Finest.Matrices.Energy;
  const float* const p = this->Direction.data();
  float* const q = this->Product.data();
  const Sums products = SumRows(this->Finest.Rows(),
    [&](Index v, FewSums& sums)
    {
      CompactValues<1> product = matrix.RowTimes<1>(v, p);
      product.AddReal(static_cast<float>(shift) * this->Finest.LumpedMass[v], p, v);
      product.Store(q, v);
      const CompactComplex value = product.Value();
      sums.Add(this->Deflated.Vectors, v, value.real(), value.imag());
      sums.Other += p[2 * v] * value.real() + p[2 * v + 1] * value.imag();
    });
  along = products.WithBlock();
  return products.Other;
}

double DeflatedGradients::Advance(float step, const Eigen::Vector4cd& along)
{
  const float* const p = this->Direction.data();
  const float* const q = this->Product.data();
  float* const t = this->Solution.data();
  float* const r = this->Residual.data();
  const Coefficients out(this->InverseAdjoint, along);
  return SumRows(this->Finest.Rows(),
    [&](Index v, FewSums& sums)
    {
      const CompactComplex projected = out.Times(this->Tested, v);
      t[2 * v] += step * p[2 * v];
      t[2 * v + 1] += step * p[2 * v + 1];
      r[2 * v] -= step * (q[2 * v] - projected.real());
      r[2 * v + 1] -= step * (q[2 * v + 1] - projected.imag());
      sums.Other += r[2 * v] * r[2 * v] + r[2 * v + 1] * r[2 * v + 1];
    })
    .Other;
}
}
