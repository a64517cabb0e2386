// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LatticeMap/LatticeSystem.h"

#include <Eigen/Cholesky>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#ifdef DIRECTIONFIELDS_HAVE_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

#include <algorithm>
#include <cmath>
#include <numeric>

namespace DirectionFields::Internal
{
/// A factorization P K P^T = L L^T.
class LatticeSystem::Backend
{
public:
  virtual ~Backend() = default;
  /// @param order the rows in the order in which they are to be eliminated, as far as it matters for the fill
  virtual bool Compute(const Matrix& lower, const std::vector<std::int32_t>& order) = 0;
  virtual Eigen::VectorXd Solve(const Eigen::VectorXd& rightHandSide) const = 0;
  /// The rows from a number on in the order of their columns in L, and that block of it.
  virtual void GetTrailing(
    Index first, std::vector<Index>& rows, Eigen::MatrixXd& factor) const = 0;
};

class LatticeSystem::EigenBackend : public LatticeSystem::Backend
{
public:
  bool Compute(const Matrix& lower, const std::vector<std::int32_t>& order) override
  {
    this->Order = order;
    this->Place.resize(order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      this->Place[order[i]] = static_cast<Index>(i);
    }
    std::vector<Entry> placed;
    placed.reserve(lower.nonZeros());
    for (Eigen::Index column = 0; column < lower.cols(); ++column)
    {
      for (Matrix::InnerIterator entry(lower, column); entry; ++entry)
      {
        const Index i = this->Place[entry.row()];
        const Index j = this->Place[column];
        placed.emplace_back(std::max(i, j), std::min(i, j), entry.value());
      }
    }
    Matrix matrix(lower.rows(), lower.cols());
    matrix.setFromTriplets(placed.begin(), placed.end());
    this->Solver.compute(matrix);
    return this->Solver.info() == Eigen::Success;
  }
  Eigen::VectorXd Solve(const Eigen::VectorXd& rightHandSide) const override
  {
    Eigen::VectorXd x(rightHandSide.size());
    for (Eigen::Index i = 0; i < x.size(); ++i)
    {
      x[i] = rightHandSide[this->Order[i]];
    }
    x = this->Solver.solve(x).eval();
    Eigen::VectorXd solution(x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i)
    {
      solution[this->Order[i]] = x[i];
    }
    return solution;
  }
  void GetTrailing(Index first, std::vector<Index>& rows, Eigen::MatrixXd& factor) const override
  {
    const auto size = static_cast<Index>(this->Order.size());
    rows.assign(this->Order.begin() + first, this->Order.end());
    factor = Eigen::MatrixXd::Zero(size - first, size - first);
    const Matrix& lower = this->Solver.matrixL().nestedExpression();
    for (Index column = first; column < size; ++column)
    {
      for (Matrix::InnerIterator entry(lower, column); entry; ++entry)
      {
        factor(entry.row() - first, column - first) = entry.value();
      }
    }
  }

private:
  std::vector<std::int32_t> Order;
  std::vector<Index> Place;
  Eigen::SimplicialLLT<Matrix, Eigen::Lower, Eigen::NaturalOrdering<std::int32_t>> Solver;
};

#ifdef DIRECTIONFIELDS_HAVE_CHOLMOD
class LatticeSystem::CholmodBackend : public LatticeSystem::Backend
{
public:
  CholmodBackend()
  {
    cholmod_start(&this->Common);
    // A failure is reported by Compute; nothing is printed.
    this->Common.print = 0;
    this->Common.supernodal = CHOLMOD_SUPERNODAL;
    this->Common.final_ll = 1;
  }
  ~CholmodBackend() override
  {
    cholmod_free_factor(&this->Factor, &this->Common);
    cholmod_finish(&this->Common);
  }
  CholmodBackend(const CholmodBackend&) = delete;
  CholmodBackend& operator=(const CholmodBackend&) = delete;

  bool Compute(const Matrix& lower, const std::vector<std::int32_t>& order) override
  {
    cholmod_sparse view = ViewOf(lower);
    std::vector<std::int32_t> permutation = order;
    // The order of a tree's nodes from the leaves up, which CHOLMOD makes of this one, leaves integers behind
    // all the reals that they depend on.
    this->Common.nmethods = 1;
    this->Common.method[0].ordering = CHOLMOD_GIVEN;
    this->Common.postorder = 1;
    this->Factor = cholmod_analyze_p(&view, permutation.data(), nullptr, 0, &this->Common);
    return this->Factor != nullptr && cholmod_factorize(&view, this->Factor, &this->Common) != 0 &&
      this->Common.status == CHOLMOD_OK && this->Factor->is_super != 0;
  }
  Eigen::VectorXd Solve(const Eigen::VectorXd& rightHandSide) const override
  {
    cholmod_dense view{};
    view.nrow = view.d = view.nzmax = static_cast<std::size_t>(rightHandSide.size());
    view.ncol = 1;
    view.x = const_cast<double*>(rightHandSide.data()); // NOLINT: it is only read
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    cholmod_dense* x = cholmod_solve(CHOLMOD_A, this->Factor, &view, &this->Common);
    if (x == nullptr)
    {
      throw std::bad_alloc();
    }
    const Eigen::VectorXd solution =
      Eigen::Map<const Eigen::VectorXd>(static_cast<const double*>(x->x), rightHandSide.size());
    cholmod_free_dense(&x, &this->Common);
    return solution;
  }
  void GetTrailing(Index first, std::vector<Index>& rows, Eigen::MatrixXd& factor) const override
  {
    const cholmod_factor& l = *this->Factor;
    const auto* permutation = static_cast<const std::int32_t*>(l.Perm);
    const auto* super = static_cast<const std::int32_t*>(l.super);
    const auto* firstRow = static_cast<const std::int32_t*>(l.pi);
    const auto* firstValue = static_cast<const std::int32_t*>(l.px);
    const auto* row = static_cast<const std::int32_t*>(l.s);
    const auto* value = static_cast<const double*>(l.x);
    std::vector<Index> place(l.n, None);
    rows.clear();
    for (std::size_t k = 0; k < l.n; ++k)
    {
      if (permutation[k] >= first)
      {
        place[k] = static_cast<Index>(rows.size());
        rows.push_back(permutation[k]);
      }
    }
    const auto count = static_cast<Eigen::Index>(rows.size());
    factor = Eigen::MatrixXd::Zero(count, count);
    for (std::size_t s = 0; s < l.nsuper; ++s)
    {
      const std::int32_t height = firstRow[s + 1] - firstRow[s];
      for (std::int32_t column = super[s]; column < super[s + 1]; ++column)
      {
        for (std::int32_t k = column - super[s]; place[column] != None && k < height; ++k)
        {
          const Index to = place[row[firstRow[s] + k]];
          if (to != None)
          {
            factor(to, place[column]) = value[firstValue[s] + (column - super[s]) * height + k];
          }
        }
      }
    }
  }

private:
  static cholmod_sparse ViewOf(const Matrix& lower)
  {
    cholmod_sparse view{};
    view.nrow = view.ncol = static_cast<std::size_t>(lower.rows());
    view.nzmax = static_cast<std::size_t>(lower.nonZeros());
    // CHOLMOD's interface has no constant pointers; it reads only.
    view.p = const_cast<std::int32_t*>(lower.outerIndexPtr()); // NOLINT
    view.i = const_cast<std::int32_t*>(lower.innerIndexPtr()); // NOLINT
    view.x = const_cast<double*>(lower.valuePtr());            // NOLINT
    view.stype = -1;
    view.itype = CHOLMOD_INT;
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    view.sorted = 1;
    view.packed = 1;
    return view;
  }

  mutable cholmod_common Common{};
  cholmod_factor* Factor = nullptr;
};
#endif

LatticeSystem::LatticeSystem(std::vector<Entry>& entries, Index size, Index reals)
  : Size(size)
  , Reals(reals)
{
  Matrix matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  std::vector<Entry>().swap(entries);
  std::vector<std::int32_t> order(size);
  std::iota(order.begin(), order.end(), 0);
  if (reals > 0)
  {
    const Matrix block = matrix.topLeftCorner(reals, reals);
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, std::int32_t> least;
    Eigen::AMDOrdering<std::int32_t>()(block.selfadjointView<Eigen::Lower>(), least);
    std::copy_n(least.indices().data(), reals, order.begin());
  }
#ifdef DIRECTIONFIELDS_HAVE_CHOLMOD
  this->Factor = std::make_unique<CholmodBackend>();
#else
  this->Factor = std::make_unique<EigenBackend>();
#endif
  this->Definite = size == 0 || this->Factor->Compute(matrix, order);
  if (this->Definite && size > reals)
  {
    std::vector<Index> rows;
    this->Factor->GetTrailing(reals, rows, this->Trailing);
    if (!std::is_sorted(rows.begin(), rows.end()))
    {
      const Eigen::MatrixXd schur =
        this->Trailing.triangularView<Eigen::Lower>() * this->Trailing.transpose();
      Eigen::MatrixXd sorted(schur.rows(), schur.cols());
      for (std::size_t i = 0; i < rows.size(); ++i)
      {
        for (std::size_t j = 0; j < rows.size(); ++j)
        {
          sorted(rows[i] - reals, rows[j] - reals) =
            schur(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
        }
      }
      const Eigen::LLT<Eigen::MatrixXd> factor(sorted);
      this->Definite = factor.info() == Eigen::Success;
      this->Trailing = factor.matrixL();
    }
  }
}

LatticeSystem::~LatticeSystem() = default;

Eigen::VectorXd LatticeSystem::Solve(const Eigen::VectorXd& rightHandSide) const
{
  return this->Size == 0 ? rightHandSide : this->Factor->Solve(rightHandSide);
}

Eigen::VectorXd LatticeSystem::SolveWith(
  const Eigen::VectorXd& rightHandSide, const Eigen::VectorXd& integers) const
{
  // K x = b + (0, r) has the integers that it is to have if r is the Schur complement of how far they are from those
  // of K x = b.
  Eigen::VectorXd side = rightHandSide;
  const Index count = this->Size - this->Reals;
  const Eigen::VectorXd step = integers - this->Solve(rightHandSide).tail(count);
  const auto factor = this->Trailing.triangularView<Eigen::Lower>();
  side.tail(count) += factor * (factor.transpose() * step).eval();
  Eigen::VectorXd solution = this->Solve(side);
  solution.tail(count) = integers;
  return solution;
}

Eigen::VectorXd SolveInRounds(const std::vector<LatticeSystem::Entry>& entries,
  const Eigen::VectorXd& rightHandSide, Index reals)
{
  constexpr int rounds = 4;
  const auto size = static_cast<Index>(rightHandSide.size());
  Eigen::VectorXd x = Eigen::VectorXd::Zero(size);
  std::vector<char> isFixed(size, 0);
  for (int round = 0; round <= rounds; ++round)
  {
    std::vector<Index> place(size, None);
    Index count = 0;
    for (Index i = 0; i < size; ++i)
    {
      place[i] = isFixed[i] == 0 ? count++ : None;
    }
    Eigen::VectorXd side(count);
    for (Index i = 0; i < size; ++i)
    {
      if (isFixed[i] == 0)
      {
        side[place[i]] = rightHandSide[i];
      }
    }
    std::vector<LatticeSystem::Entry> left;
    for (const LatticeSystem::Entry& entry : entries)
    {
      const Index i = entry.row();
      const Index j = entry.col();
      if (isFixed[i] == 0 && isFixed[j] == 0)
      {
        left.emplace_back(place[i], place[j], entry.value());
      }
      else if (isFixed[i] == 0)
      {
        side[place[i]] -= entry.value() * x[j];
      }
      else if (isFixed[j] == 0)
      {
        side[place[j]] -= entry.value() * x[i];
      }
    }
    const LatticeSystem system(left, count, count);
    if (!system.IsDefinite())
    {
      return {};
    }
    const Eigen::VectorXd solution = system.Solve(side);
    std::vector<std::pair<double, Index>> order;
    for (Index i = 0; i < size; ++i)
    {
      if (isFixed[i] == 0)
      {
        x[i] = solution[place[i]];
        if (i >= reals)
        {
          order.emplace_back(std::abs(x[i] - std::nearbyint(x[i])), i);
        }
      }
    }
    std::sort(order.begin(), order.end());
    // All that are left in the last round but one.
    const std::size_t part = (order.size() + rounds - 1 - round) / std::max(1, rounds - round);
    for (std::size_t k = 0; k < std::min(part, order.size()); ++k)
    {
      const Index i = order[k].second;
      x[i] = std::nearbyint(x[i]);
      isFixed[i] = 1;
    }
  }
  return x;
}
}
