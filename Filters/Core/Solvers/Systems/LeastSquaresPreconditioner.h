// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_LeastSquaresPreconditioner_h
#define DirectionFields_LeastSquaresPreconditioner_h

#include "Solvers/Matrices/Factorization.h"
#include "Solvers/Matrices/OperatorProducts.h"
#include "Solvers/Multigrid/Cycle.h"

#include <vector>

namespace DirectionFields::Internal
{
/// For conjugate gradients on K_f^* K_f, K_f the columns of K = a A + m M that belong to the free
/// vertices. All vectors are over all vertices, those of free values zero at the given ones.
///
/// A V-cycle inverts K_ff up to a factor in the energy norm. In the norm of least squares it does
/// not: interpolated sections leave a rough residual that grows with the mesh. A cycle B with
/// several sweeps after each correction, and none before, takes most of that away; B B^* inverts
/// K_ff^2. What remains are sections that are smooth along curves of given vertices and bend across
/// them: those sections of a coarse level of the hierarchy that are near given vertices hold them, and
/// are deflated, solved for exactly (R. Nicolaides, SIAM J. Numer. Anal. 24, 1987).
class LeastSquaresPreconditioner
{
public:
  /// @param matrix    K
  /// @param free      the free vertices, ascending
  /// @param hierarchy that of K_ff; must outlive this
  /// @param shift     m / a, at least 0
  LeastSquaresPreconditioner(const SparseMatrix& matrix, const std::vector<Index>& free,
    const Hierarchy& hierarchy, double shift);

  bool IsUsable() const { return this->Coarsest.IsUsable(); }

  /// Finds z = B B^* r, for which the values of r at given vertices do not matter. Returns Re r^* z.
  /// @param size ‖r‖
  double Apply(const ComplexVector& r, double size);
  /// The z of the latest Apply, divided by ‖r‖: a section over the free vertices.
  const CompactSections& GetResult() const { return this->Levels.front().Sum; }

  /// y -= K_f Z c, the sections Z of the coarse level as far as they are near given vertices,
  /// c = (Z^* K_f^* K_f Z)^-1 Z^* K_f^* y, which leaves least of y: with y = K_f x, x - Z c is deflated,
  /// with y = K_f x - b it is the best change of x among those sections. Returns c, or nothing where
  /// nothing is deflated.
  ComplexVector Deflate(ComplexVector& y) const;
  /// x -= Z c
  void Correct(const ComplexVector& c, ComplexVector& x) const;

private:
  /// The storage of one level.
  struct Workspace
  {
    SweepDiagonal Diagonal;
    CompactSections Right;
    CompactSections Sum;
    CompactSections Rest;
  };
  /// A sparse matrix by its rows: the columns of the adjoint, and which of them are not empty.
  struct SparseRows
  {
    explicit SparseRows(const SparseMatrix& matrix);
    SparseRows() = default;
    /// y -= W c
    void SubtractProduct(const ComplexVector& c, ComplexVector& y) const;

    SparseMatrix Adjoint;
    std::vector<Index> Filled;
  };
  void MakeCoarse(const SparseMatrix& matrix);
  /// Finds the Sum of the level from its Right.
  /// @param after whether the cycle sweeps after the correction of the coarser level, or, its
  ///              adjoint, before
  void ApplyCycle(std::size_t level, bool after);

  const std::vector<Index>& Free;
  const Hierarchy& Multigrid;
  /// Solves on the coarsest level.
  Cycle Coarsest;
  std::vector<Workspace> Levels;
  /// Whether anything is deflated.
  bool Deflates = false;
  /// Z
  SparseRows Sections;
  /// K_f Z, once by its columns and once by its rows.
  SparseMatrix CoarseColumns;
  SparseRows CoarseRows;
  Factorization CoarseFactor;
};
}

#endif
