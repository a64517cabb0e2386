// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Parametrization/ParametrizationEnergy.h"

#include "Integers/IntegerRounding.h"

#include <algorithm>
#include <limits>

namespace DirectionFields::Internal
{
namespace
{
constexpr double LeastWeight = 0.05;
/// Where a cone or line is beyond a line by more than this many rows in the map over the reals,
/// that is folded there, or they were laid flat on another way: to keep them apart would bend it a
/// lot.
constexpr double LeastRow = -0.5;
}

ParametrizationEnergy::ParametrizationEnergy(
  const CutMesh& mesh, const std::vector<double>& perLength)
  : Plane(mesh.Degree)
  , Variables(mesh)
  , IsShort(this->Variables.ShortIsolines(perLength))
  , Distances(FindRowDistances(mesh, perLength))
{
  this->Variables.BoundIsolines(this->IsShort);
  this->Variables.BoundDistances(this->Distances);
  const IntegerElimination& solved = this->Variables.Solved;
  this->Slot.assign(solved.GetNumberOfVariables(), None);
  for (const bool areIntegers : { false, true })
  {
    for (Index v = 0; v < solved.GetNumberOfVariables(); ++v)
    {
      if (solved.IsFree(v) && solved.IsInteger(v) == areIntegers)
      {
        this->Slot[v] = this->Count++;
      }
    }
    this->Reals = areIntegers ? this->Reals : this->Count;
  }
  const std::size_t edges = 3 * mesh.Triangles.size() / 2;
  this->Edges.reserve(edges);
  this->Sums.Reserve(edges);
  for (Index t = 0; t < static_cast<Index>(mesh.Triangles.size()); ++t)
  {
    for (int c = 0; c < 3; ++c)
    {
      const CutMesh::MapTriangle& triangle = mesh.Triangles[t];
      const Index twin = triangle.Twin[c];
      if (twin != None && twin < 3 * t + c)
      {
        continue;
      }
      const double beyond = twin != None ? mesh.Triangles[twin / 3].Weight[twin % 3] : 0.0;
      this->AddEdge(3 * t + c, std::max(LeastWeight, triangle.Weight[c] + beyond));
    }
  }
  this->Edges.shrink_to_fit();
  this->Sums.ShrinkToFit();
}

void ParametrizationEnergy::AddEdge(Index halfEdge, double weight)
{
  const Index t = halfEdge / 3;
  const int c = halfEdge % 3;
  SymbolicGridPoint difference = this->Variables.Corner(t, (c + 1) % 3);
  difference.Add(this->Variables.Corner(t, c), -1);
  const std::array<IntegerSum, 2> sums = { this->Variables.Solved.Resolve(difference.A),
    this->Variables.Solved.Resolve(difference.B) };
  std::array<std::vector<EdgeSums::Term>, 2> coordinates;
  for (int i = 0; i < 2; ++i)
  {
    for (const auto& [v, p] : sums[i])
    {
      coordinates[i].push_back({ this->Slot[v], static_cast<double>(p) });
    }
    std::sort(coordinates[i].begin(), coordinates[i].end(),
      [](const EdgeSums::Term& a, const EdgeSums::Term& b) { return a.Variable < b.Variable; });
  }
  this->Edges.push_back(halfEdge);
  this->Sums.Append(weight, coordinates);
}

Eigen::VectorXd ParametrizationEnergy::RightHandSide(const std::vector<double>& perLength) const
{
  Eigen::VectorXd side = Eigen::VectorXd::Zero(this->Count);
  for (std::size_t e = 0; e < this->Edges.size(); ++e)
  {
    const CutMesh::MapTriangle& triangle = this->GetMesh().Triangles[this->Edges[e] / 3];
    const int c = this->Edges[e] % 3;
    const double size =
      0.5 * (perLength[triangle.Vertex[c]] + perLength[triangle.Vertex[(c + 1) % 3]]);
    const std::array<double, 2> target = this->Plane.Coordinates(size * triangle.Target[c]);
    for (int i = 0; i < 2; ++i)
    {
      // |a + b zeta|^2 = a^2 + b^2 + 2 Re(zeta) a b
      const double value = this->Sums.GetWeight(e) * (target[i] + this->Mixed() * target[1 - i]);
      this->Sums.ForTerms(
        e, i, [&](Index variable, double factor) { side[variable] += factor * value; });
    }
  }
  return side;
}

Eigen::VectorXd ParametrizationEnergy::Least(const Eigen::VectorXd& relaxed) const
{
  Eigen::VectorXd least = Eigen::VectorXd::Constant(
    this->GetNumberOfIntegers(), -std::numeric_limits<double>::infinity());
  for (const Index v : this->Variables.Bounded)
  {
    least[this->Slot[v] - this->Reals] = 1.0;
  }
  for (const Index v : this->Variables.BoundedDistances)
  {
    const Index k = this->Slot[v] - this->Reals;
    if (relaxed[k] < LeastRow)
    {
      least[k] = -std::numeric_limits<double>::infinity();
    }
  }
  return least;
}

double ParametrizationEnergy::AreaAt(const Eigen::VectorXd& x)
{
  std::vector<double> value(this->Slot.size(), 0.0);
  for (Index v = 0; v < static_cast<Index>(value.size()); ++v)
  {
    if (this->Variables.Solved.IsFree(v))
    {
      value[v] = x[this->Slot[v]];
      continue;
    }
    for (const auto& [w, p] : this->Variables.Solved.Resolve(v))
    {
      value[v] += static_cast<double>(p) * x[this->Slot[w]];
    }
  }
  // zeta^turn times a variable.
  using Place = std::array<double, 2>;
  const auto turned = [&](Index variable, int turn)
  {
    Place place = { value[2 * variable], value[2 * variable + 1] };
    for (; turn > 0; --turn)
    {
      place = { -place[1], place[0] + (this->Plane.GetDegree() == 6 ? place[1] : 0.0) };
    }
    return place;
  };
  double area = 0.0;
  for (const CutMesh::MapTriangle& triangle : this->GetMesh().Triangles)
  {
    std::array<Place, 3> corners;
    for (int c = 0; c < 3; ++c)
    {
      const SymbolicTransition& t = triangle.Corner[c];
      corners[c] = turned(triangle.Vertex[c], t.Turn);
      for (const Jump& jump : t.Jumps)
      {
        const Place shift = turned(this->Variables.Vertices + jump.Variable, jump.Turn);
        corners[c] = { corners[c][0] + shift[0], corners[c][1] + shift[1] };
      }
    }
    area += 0.5 *
      ((corners[1][0] - corners[0][0]) * (corners[2][1] - corners[0][1]) -
        (corners[1][1] - corners[0][1]) * (corners[2][0] - corners[0][0]));
  }
  return area;
}

bool ParametrizationEnergy::IsFactored() const
{
  return this->GetNumberOfIntegers() <= MostRounded;
}

const SchurSystem& ParametrizationEnergy::GetSystem()
{
  if (!this->System)
  {
    this->System.emplace(this->Sums.Squares(this->Count, this->Mixed()), this->Reals);
  }
  this->System->Restore();
  return *this->System;
}

void ParametrizationEnergy::Shrink(std::size_t mostValues)
{
  if (this->System)
  {
    this->System->Shrink(mostValues);
  }
}

Eigen::VectorXd ParametrizationEnergy::SolveInRounds(const Eigen::VectorXd& rightHandSide) const
{
  return Internal::SolveInRounds(
    this->Sums.Squares(this->Count, this->Mixed()), rightHandSide, this->Reals);
}
}
