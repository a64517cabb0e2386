// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Integers/IntegerSearch.h"

#include "Integers/TriangularSquares.h"

#include <cmath>
#include <limits>
#include <vector>

namespace DirectionFields::Internal
{
namespace
{
constexpr int MostPasses = 8;
/// Steps of one chain.
constexpr std::size_t MostSteps = 8;
/// A chain has to lower the energy by this part of what its first step alone would cost at the
/// minimum: rounding errors are no gain.
constexpr double LeastGain = 1e-6;
constexpr double Infinity = std::numeric_limits<double>::infinity();

class ChainSearch
{
public:
  ChainSearch(const Eigen::MatrixXd& factor, const Eigen::VectorXd& relaxed, Eigen::VectorXd& x,
    const Eigen::VectorXd& least)
    : Matrix(SquareOf(factor))
    , X(x)
    , Least(least.size() == x.size() ? least : Eigen::VectorXd::Constant(x.size(), -Infinity))
    , IsTaken(x.size(), 0)
  {
    this->Slope = this->Matrix * (x - relaxed);
  }

  /// Returns whether the chain that begins with this step was done.
  bool Follow(Eigen::Index variable, double by)
  {
    Step step{ variable, by, this->Change(variable, by) };
    if (this->X[variable] + by < this->Least[variable])
    {
      return false;
    }
    const double before = -LeastGain * this->Matrix(variable, variable);
    this->Chain.clear();
    double energy = 0.0;
    double best = before;
    std::size_t bestSteps = 0;
    while (true)
    {
      energy += step.Change;
      this->Do(step);
      if (energy < best)
      {
        best = energy;
        bestSteps = this->Chain.size();
      }
      if (this->Chain.size() == MostSteps)
      {
        break;
      }
      step = this->Next();
      if (!(step.Change < 0.0))
      {
        break;
      }
    }
    while (this->Chain.size() > bestSteps)
    {
      this->Undo();
    }
    for (const Step& done : this->Chain)
    {
      this->IsTaken[done.Variable] = 0;
    }
    return bestSteps > 0;
  }

private:
  struct Step
  {
    Eigen::Index Variable;
    double By;
    /// Of the energy.
    double Change;
  };

  double Change(Eigen::Index variable, double by) const
  {
    return this->Matrix(variable, variable) + 2.0 * by * this->Slope[variable];
  }

  /// The best step of a variable that has not moved in this chain.
  Step Next() const
  {
    Step next{ 0, 0.0, Infinity };
    for (Eigen::Index i = 0; i < this->X.size(); ++i)
    {
      const double by = this->Slope[i] > 0.0 ? -1.0 : 1.0;
      const double change = this->Change(i, by);
      if (change < next.Change && this->IsTaken[i] == 0 && this->X[i] + by >= this->Least[i])
      {
        next = { i, by, change };
      }
    }
    return next;
  }

  void Do(const Step& step)
  {
    this->X[step.Variable] += step.By;
    this->Slope += step.By * this->Matrix.col(step.Variable);
    this->IsTaken[step.Variable] = 1;
    this->Chain.push_back(step);
  }

  void Undo()
  {
    const Step step = this->Chain.back();
    this->X[step.Variable] -= step.By;
    this->Slope -= step.By * this->Matrix.col(step.Variable);
    this->IsTaken[step.Variable] = 0;
    this->Chain.pop_back();
  }

  Eigen::MatrixXd Matrix;
  Eigen::VectorXd& X;
  Eigen::VectorXd Least;
  /// Half the gradient of the energy.
  Eigen::VectorXd Slope;
  std::vector<Step> Chain;
  std::vector<char> IsTaken;
};
}

void ImproveIntegers(const Eigen::MatrixXd& factor, const Eigen::VectorXd& relaxed,
  Eigen::VectorXd& x, const Eigen::VectorXd& least)
{
  ChainSearch search(factor, relaxed, x, least);
  bool hasChanged = true;
  for (int pass = 0; pass < MostPasses && hasChanged; ++pass)
  {
    hasChanged = false;
    for (Eigen::Index k = 0; k < x.size(); ++k)
    {
      for (const double by : { 1.0, -1.0 })
      {
        hasChanged = search.Follow(k, by) || hasChanged;
      }
    }
  }
}
}
