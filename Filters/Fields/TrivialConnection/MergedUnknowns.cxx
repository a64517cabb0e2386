// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "TrivialConnection/MergedUnknowns.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace DirectionFields::Internal
{
MergedUnknowns::MergedUnknowns(Index unknowns)
  : Parent(unknowns)
  , Offset(unknowns, 0.0)
{
  std::iota(this->Parent.begin(), this->Parent.end(), 0);
}

Index MergedUnknowns::Find(Index a)
{
  while (this->Parent[a] != a)
  {
    const Index parent = this->Parent[a];
    if (this->Parent[parent] != parent)
    {
      this->Offset[a] += this->Offset[parent];
      this->Parent[a] = this->Parent[parent];
    }
    a = parent;
  }
  return a;
}

double MergedUnknowns::Difference(Index a) const
{
  double difference = 0.0;
  for (; this->Parent[a] != a; a = this->Parent[a])
  {
    difference += this->Offset[a];
  }
  return difference;
}

void MergedUnknowns::Join(Index a, Index b, double difference)
{
  Index first = this->Find(a);
  Index second = this->Find(b);
  if (first == second)
  {
    return;
  }
  // value(second) - value(first)
  double offset = this->Difference(a) + difference - this->Difference(b);
  if (second < first)
  {
    std::swap(first, second);
    offset = -offset;
  }
  this->Parent[second] = first;
  this->Offset[second] = offset;
  this->Touched.push_back(a);
  this->Touched.push_back(b);
}

void MergedUnknowns::Close()
{
  std::vector<std::pair<Index, Index>> members;
  std::sort(this->Touched.begin(), this->Touched.end());
  this->Touched.erase(std::unique(this->Touched.begin(), this->Touched.end()), this->Touched.end());
  for (const Index a : this->Touched)
  {
    members.emplace_back(this->Find(a), a);
  }
  std::sort(members.begin(), members.end());
  for (std::size_t k = 0; k < members.size(); ++k)
  {
    if (k == 0 || members[k].first != members[k - 1].first)
    {
      this->Begin.push_back(static_cast<Index>(k));
    }
    this->Members.push_back(members[k].second);
    this->Differences.push_back(this->Difference(members[k].second));
  }
  this->Begin.push_back(static_cast<Index>(members.size()));
}

void MergedUnknowns::Satisfy(Eigen::VectorXd& values) const
{
  for (std::size_t k = 0; k + 1 < this->Begin.size(); ++k)
  {
    double sum = 0.0;
    for (Index m = this->Begin[k]; m < this->Begin[k + 1]; ++m)
    {
      sum += values[this->Members[m]] - this->Differences[m];
    }
    const double mean = sum / (this->Begin[k + 1] - this->Begin[k]);
    for (Index m = this->Begin[k]; m < this->Begin[k + 1]; ++m)
    {
      values[this->Members[m]] = mean + this->Differences[m];
    }
  }
}

template <typename Vector>
void MergedUnknowns::AverageSets(Vector& values) const
{
  for (std::size_t k = 0; k + 1 < this->Begin.size(); ++k)
  {
    double sum = 0.0;
    for (Index m = this->Begin[k]; m < this->Begin[k + 1]; ++m)
    {
      sum += values[this->Members[m]];
    }
    const double mean = sum / (this->Begin[k + 1] - this->Begin[k]);
    for (Index m = this->Begin[k]; m < this->Begin[k + 1]; ++m)
    {
      values[this->Members[m]] = static_cast<typename Vector::Scalar>(mean);
    }
  }
}

void MergedUnknowns::Average(Eigen::Ref<Eigen::VectorXd> values) const
{
  this->AverageSets(values);
}

void MergedUnknowns::Average(Eigen::Ref<Eigen::VectorXf> values) const
{
  this->AverageSets(values);
}
}
