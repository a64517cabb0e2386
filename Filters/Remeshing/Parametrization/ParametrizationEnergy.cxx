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
}

ParametrizationEnergy::ParametrizationEnergy(
  const CutMesh& mesh, const std::vector<double>& perLength)
  : Plane(mesh.Degree)
  , Variables(mesh)
  , IsShort(this->Variables.ShortIsolines(perLength))
{
  this->Variables.BoundIsolines(this->IsShort);
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
  // Most edges lead from one vertex to another, in each coordinate.
  const std::size_t edges = 3 * mesh.Triangles.size() / 2;
  this->Edges.reserve(edges);
  this->Ends.reserve(2 * edges);
  this->Terms.reserve(4 * edges);
  this->Factors.reserve(4 * edges);
  this->Entries.reserve((mesh.Degree == 4 ? 6 : 10) * edges);
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
      this->Edges.push_back({ 3 * t + c, std::max(LeastWeight, triangle.Weight[c] + beyond) });
      this->AddEdge(this->Edges.back());
    }
  }
  this->Edges.shrink_to_fit();
  this->Ends.shrink_to_fit();
  this->Terms.shrink_to_fit();
  this->Factors.shrink_to_fit();
}

void ParametrizationEnergy::AddEdge(const Edge& edge)
{
  const Index t = edge.HalfEdge / 3;
  const int c = edge.HalfEdge % 3;
  SymbolicGridPoint difference = this->Variables.Corner(t, (c + 1) % 3);
  difference.Add(this->Variables.Corner(t, c), -1);
  const std::array<IntegerSum, 2> sums = { this->Variables.Solved.Resolve(difference.A),
    this->Variables.Solved.Resolve(difference.B) };
  // |a + b zeta|^2 = a^2 + b^2 + 2 Re(zeta) a b
  const double mixed = this->Mixed();
  for (int i = 0; i < 2; ++i)
  {
    for (const auto& [v, p] : sums[i])
    {
      const Index row = this->Slot[v];
      this->Terms.push_back(row);
      this->Factors.push_back(static_cast<double>(p));
      for (int j = 0; j < 2; ++j)
      {
        const double factor = edge.Weight * static_cast<double>(p) * (i == j ? 1.0 : mixed);
        for (const auto& [w, q] : sums[j])
        {
          const Index column = this->Slot[w];
          if (factor != 0.0 && column <= row)
          {
            this->Entries.emplace_back(row, column, factor * static_cast<double>(q));
          }
        }
      }
    }
    this->Ends.push_back(this->Terms.size());
  }
}

Eigen::VectorXd ParametrizationEnergy::RightHandSide(const std::vector<double>& perLength) const
{
  Eigen::VectorXd side = Eigen::VectorXd::Zero(this->Count);
  std::size_t k = 0;
  for (std::size_t e = 0; e < this->Edges.size(); ++e)
  {
    const CutMesh::MapTriangle& triangle = this->GetMesh().Triangles[this->Edges[e].HalfEdge / 3];
    const int c = this->Edges[e].HalfEdge % 3;
    const double size =
      0.5 * (perLength[triangle.Vertex[c]] + perLength[triangle.Vertex[(c + 1) % 3]]);
    const std::array<double, 2> target = this->Plane.Coordinates(size * triangle.Target[c]);
    for (int i = 0; i < 2; ++i)
    {
      const double value = this->Edges[e].Weight * (target[i] + this->Mixed() * target[1 - i]);
      for (; k < this->Ends[2 * e + i]; ++k)
      {
        side[this->Terms[k]] += this->Factors[k] * value;
      }
    }
  }
  return side;
}

Eigen::VectorXd ParametrizationEnergy::Least() const
{
  Eigen::VectorXd least = Eigen::VectorXd::Constant(
    this->GetNumberOfIntegers(), -std::numeric_limits<double>::infinity());
  for (const Index v : this->Variables.Bounded)
  {
    least[this->Slot[v] - this->Reals] = 1.0;
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
    this->System.emplace(this->Entries, this->Count, this->Reals);
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
  return Internal::SolveInRounds(this->Entries, rightHandSide, this->Reals);
}
}
