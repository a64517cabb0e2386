// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_CyclePreconditioner_h
#define DirectionFields_CyclePreconditioner_h

#include "Multigrid/Cycle.h"
#include "Multigrid/SectionBlock.h"

namespace DirectionFields::Internal
{
/// A section in single precision.
using CompactVector = LargeArray<CompactComplex>;

/// z = B r, where B is a V-cycle in single precision and a correction towards the inverse on the
/// lowest sections.
class CyclePreconditioner
{
public:
  /// @param hierarchy, lowest must outlive the object; lowest may be empty
  /// @param shift             that of the matrix A + shift M, whose inverse B approximates
  CyclePreconditioner(const Hierarchy& hierarchy, double shift, const LowestSections& lowest);
  bool IsUsable() const { return this->Cycles.IsUsable(); }
  /// The work of a cycle (see WorkLimit).
  double Work() const { return this->Cycles.Work(); }

  /// z, which is put together row by row where it is needed.
  class Result
  {
  public:
    Complex operator()(Index v) const
    {
      Complex z(this->Corrected[v]);
      if (this->Lowest)
      {
        const CompactValues<SectionBlock::Width> x(this->Lowest, v);
        const Numbers re = x.Real.cast<double>();
        const Numbers im = x.Imaginary.cast<double>();
        z += Complex((this->Real * re - this->Imaginary * im).sum(),
          (this->Real * im + this->Imaginary * re).sum());
      }
      return z;
    }
    /// Re r^* z
    double Product = 0.0;

  private:
    friend CyclePreconditioner;
    using Numbers = Eigen::Array<double, SectionBlock::Width, 1>;
    const CompactComplex* Corrected;
    const float* Lowest;
    Numbers Real;
    Numbers Imaginary;
  };
  /// @param r about of unit length
  Result Apply(const CompactVector& r);

private:
  Cycle Cycles;
  /// The vectors of the lowest sections; null where V-cycles lack little.
  const float* Lowest = nullptr;
  /// The correction for each of the lowest sections.
  Eigen::ArrayXd PerValue;
  CompactVector Corrected;
};
}

#endif
