// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SparseCholesky/SupernodalCholesky.h"

namespace DirectionFields::Internal
{
Eigen::VectorXd SupernodalCholesky::Solve(const Eigen::VectorXd& rightHandSide) const
{
  const Eigen::Index size = rightHandSide.size();
  Eigen::VectorXd x(size);
  for (Eigen::Index k = 0; k < size; ++k)
  {
    x[k] = rightHandSide[this->Order[k]];
  }
  Eigen::VectorXd below;
  for (const Supernode& node : this->Nodes)
  {
    const Eigen::Map<const Eigen::MatrixXd> block = this->Block(node);
    auto own = x.segment(node.First, node.Width());
    block.topRows(node.Width()).triangularView<Eigen::Lower>().solveInPlace(own);
    below.noalias() = block.bottomRows(static_cast<Index>(node.Rows.size())) * own;
    for (std::size_t i = 0; i < node.Rows.size(); ++i)
    {
      x[node.Rows[i]] -= below[static_cast<Index>(i)];
    }
  }
  this->SubstituteBackward(x, this->Nodes.size());
  return this->InOrder(x);
}

Eigen::VectorXd SupernodalCholesky::Continued(const Eigen::VectorXd& last) const
{
  Eigen::VectorXd x = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(this->Order.size()));
  x.tail(this->Last) = last;
  this->SubstituteBackward(x, this->Nodes.size() - (this->Last > 0 ? 1 : 0));
  return this->InOrder(x);
}

void SupernodalCholesky::SubstituteBackward(Eigen::VectorXd& x, std::size_t nodes) const
{
  Eigen::VectorXd below;
  for (std::size_t s = nodes; s-- > 0;)
  {
    const Supernode& node = this->Nodes[s];
    const Eigen::Map<const Eigen::MatrixXd> block = this->Block(node);
    const auto rows = static_cast<Index>(node.Rows.size());
    auto own = x.segment(node.First, node.Width());
    below.resize(rows);
    for (Index i = 0; i < rows; ++i)
    {
      below[i] = x[node.Rows[i]];
    }
    own.noalias() -= block.bottomRows(rows).transpose() * below;
    block.topRows(node.Width()).triangularView<Eigen::Lower>().transpose().solveInPlace(own);
  }
}

Eigen::VectorXd SupernodalCholesky::InOrder(const Eigen::VectorXd& x) const
{
  Eigen::VectorXd ordered(x.size());
  for (Eigen::Index k = 0; k < x.size(); ++k)
  {
    ordered[this->Order[k]] = x[k];
  }
  return ordered;
}

Eigen::MatrixXd SupernodalCholesky::TrailingFactor() const
{
  if (this->Last == 0)
  {
    return {};
  }
  return Eigen::MatrixXd(this->Block(this->Nodes.back()).triangularView<Eigen::Lower>());
}
}
