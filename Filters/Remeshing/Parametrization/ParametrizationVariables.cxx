// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Parametrization/ParametrizationVariables.h"

#include "Parametrization/ConeTree.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// Feature isolines whose wanted length is more than this many edges do not need a bound.
constexpr double LongestBounded = 4.0;
/// Lengths that depend on more variables than this get no bound: every sum with such a length
/// becomes as long.
constexpr std::size_t MostTerms = 64;
/// With up to about this number of integers the places of cones are the free ones. A jump then
/// depends on all cones beyond it, and the matrix is dense among many of them: of more, differences
/// of neighbouring cones are free, on which little depends. Noise of half an edge takes two thirds
/// of the memory, that of one edge a twelfth.
constexpr Index MostTogether = 200;

void Append(IntegerSum& to, const IntegerSum& from, std::int64_t factor)
{
  for (const auto& [variable, coefficient] : from)
  {
    to.emplace_back(variable, factor * coefficient);
  }
}
}

void SymbolicGridPoint::Add(const SymbolicGridPoint& other, std::int64_t factor)
{
  Append(this->A, other.A, factor);
  Append(this->B, other.B, factor);
}

SymbolicGridPoint SymbolicGridPoint::Turned(int turn, int degree) const
{
  SymbolicGridPoint turned = *this;
  for (int k = 0; k < turn; ++k)
  {
    SymbolicGridPoint next;
    Append(next.A, turned.B, -1);
    next.B = turned.A;
    if (degree == 6)
    {
      Append(next.B, turned.B, 1);
    }
    turned = std::move(next);
  }
  return turned;
}

ParametrizationVariables::ParametrizationVariables(const CutMesh& mesh)
  : Mesh(mesh)
  , Degree(mesh.Degree)
  , Vertices(static_cast<Index>(mesh.Positions.size()))
  , IsPoint(mesh.Positions.size(), 0)
  , Solved(this->Flags())
  , Isolines(FindFeatureIsolines(mesh, this->IsPoint))
{
  this->FixOrigin();
  this->FixCones();
  for (const auto& [key, variable] : this->AcrossFeature)
  {
    IntegerSum definition = this->Vertex(key.first).Turned(key.second, this->Degree).B;
    definition.emplace_back(variable, -1);
    this->Solved.Require(definition);
  }
  for (const CutMesh::IsolineEdge& edge : mesh.Isolines)
  {
    this->Solved.Require(this->Along(edge).B);
  }
}

std::vector<char> ParametrizationVariables::ShortIsolines(
  const std::vector<double>& perLength) const
{
  std::vector<char> isShort;
  for (const FeatureIsoline& isoline : this->Isolines)
  {
    double wanted = 0.0;
    for (const FeatureIsoline::Step& step : isoline.Steps)
    {
      const CutMesh::IsolineEdge& edge = this->Mesh.Isolines[step.Isoline];
      wanted += 0.5 * std::abs(this->Mesh.Triangles[edge.Triangle].Target[edge.Corner]) *
        (perLength[EndOf(this->Mesh, edge, false)] + perLength[EndOf(this->Mesh, edge, true)]);
      if (wanted > LongestBounded)
      {
        break;
      }
    }
    isShort.push_back(wanted > LongestBounded ? 0 : 1);
  }
  return isShort;
}

void ParametrizationVariables::BoundIsolines(const std::vector<char>& isShort)
{
  for (std::size_t k = 0; k < this->Isolines.size(); ++k)
  {
    if (isShort[k] == 0)
    {
      continue;
    }
    IntegerSum length;
    for (const FeatureIsoline::Step& step : this->Isolines[k].Steps)
    {
      Append(length, this->Along(this->Mesh.Isolines[step.Isoline]).A, 1);
    }
    this->Bound(std::move(length));
  }
  this->DropSolvedBounds();
}

void ParametrizationVariables::BoundDistances(const std::vector<RowDistance>& distances)
{
  const std::vector<Index> lengths = this->Bounded;
  for (const RowDistance& distance : distances)
  {
    SymbolicGridPoint row =
      this->Corner(distance.Triangle, distance.Corner).Turned(distance.ToFirst.Turn, this->Degree);
    row.Add(this->Jumps(distance.ToFirst), 1);
    row.Add(this->Corner(distance.From / 3, distance.From % 3), -1);
    this->Bound(row.Turned((this->Degree - distance.Axis) % this->Degree, this->Degree).B);
  }
  this->DropSolvedBounds();
  for (const Index variable : this->Bounded)
  {
    if (std::find(lengths.begin(), lengths.end(), variable) == lengths.end())
    {
      this->BoundedDistances.push_back(variable);
    }
  }
}

void ParametrizationVariables::Bound(IntegerSum length)
{
  length = this->Solved.Resolve(length);
  const bool isInteger = std::all_of(length.begin(), length.end(),
    [&](const auto& term) { return this->Solved.IsInteger(term.first); });
  if (length.empty() || length.size() > MostTerms || !isInteger)
  {
    return;
  }
  if (length.size() == 1 && std::abs(length.front().second) == 1)
  {
    const Index variable = length.front().first;
    const auto known = std::find(this->Bounded.begin(), this->Bounded.end(), variable);
    if (length.front().second == 1 && known == this->Bounded.end())
    {
      this->Bounded.push_back(variable);
    }
    if (length.front().second == 1 || known != this->Bounded.end())
    {
      return;
    }
  }
  this->Bounded.push_back(this->Solved.AddFreeInteger());
  length.emplace_back(this->Bounded.back(), -1);
  this->Solved.Require(length);
}

/// Variables that had to be solved for in the end have no bound.
void ParametrizationVariables::DropSolvedBounds()
{
  this->Bounded.erase(std::remove_if(this->Bounded.begin(), this->Bounded.end(),
                        [&](Index variable) { return !this->Solved.IsFree(variable); }),
    this->Bounded.end());
}

SymbolicGridPoint ParametrizationVariables::Along(const CutMesh::IsolineEdge& edge) const
{
  SymbolicGridPoint along = this->Corner(edge.Triangle, (edge.Corner + 1) % 3);
  along.Add(this->Corner(edge.Triangle, edge.Corner), -1);
  return along.Turned((this->Degree - edge.Axis) % this->Degree, this->Degree);
}

SymbolicGridPoint ParametrizationVariables::Jumps(const SymbolicTransition& t) const
{
  SymbolicGridPoint sum;
  for (const Jump& jump : t.Jumps)
  {
    sum.Add(this->Vertex(this->Vertices + jump.Variable).Turned(jump.Turn, this->Degree), 1);
  }
  return sum;
}

SymbolicGridPoint ParametrizationVariables::Corner(Index t, int c) const
{
  const CutMesh::MapTriangle& triangle = this->Mesh.Triangles[t];
  SymbolicGridPoint sum =
    this->Vertex(triangle.Vertex[c]).Turned(triangle.Corner[c].Turn, this->Degree);
  sum.Add(this->Jumps(triangle.Corner[c]), 1);
  return sum;
}

/// Each cone is a fixed point of the transition once around it.
void ParametrizationVariables::FixCones()
{
  const auto equationsOf = [&](Index k)
  {
    const CutMesh::Cone& cone = this->Mesh.Cones[k];
    SymbolicGridPoint image = this->Vertex(cone.Vertex).Turned(cone.Holonomy.Turn, this->Degree);
    image.Add(this->Jumps(cone.Holonomy), 1);
    image.Add(this->Vertex(cone.Vertex), -1);
    return image;
  };
  if (2 * this->Mesh.NumberOfJumps <= MostTogether)
  {
    for (Index k = 0; k < static_cast<Index>(this->Mesh.Cones.size()); ++k)
    {
      const SymbolicGridPoint equations = equationsOf(k);
      this->Solved.Require(equations.A);
      this->Solved.Require(equations.B);
    }
    return;
  }
  for (const TreeCone& member : LeavesFirst(this->Mesh))
  {
    const SymbolicGridPoint equations = equationsOf(member.Cone);
    const Index place = 2 * this->Mesh.Cones[member.Cone].Vertex;
    const Index jump = member.Jump == None ? None : 2 * (this->Vertices + member.Jump);
    this->Solved.RequireLocally(equations.A, place, jump);
    this->Solved.RequireLocally(equations.B, place + 1, jump);
  }
}

/// Finds the features at each vertex, and returns which variables are to be integers.
std::vector<char> ParametrizationVariables::Flags()
{
  for (const CutMesh::Cone& cone : this->Mesh.Cones)
  {
    this->IsPoint[cone.Vertex] = 1;
  }
  // The ends of features are grid points, too.
  for (std::size_t v = 0; v < this->Mesh.IsChainEnd.size(); ++v)
  {
    this->IsPoint[v] = this->IsPoint[v] != 0 || this->Mesh.IsChainEnd[v] != 0 ? 1 : 0;
  }
  std::vector<char> flags(2 * (this->Vertices + this->Mesh.NumberOfJumps), 1);
  for (Index v = 0; v < this->Vertices; ++v)
  {
    flags[2 * v] = flags[2 * v + 1] = this->IsPoint[v];
  }
  auto count = static_cast<Index>(flags.size());
  for (const CutMesh::IsolineEdge& edge : this->Mesh.Isolines)
  {
    const CutMesh::MapTriangle& triangle = this->Mesh.Triangles[edge.Triangle];
    for (const int c : { edge.Corner, (edge.Corner + 1) % 3 })
    {
      // zeta^-axis in the chart of the vertex, up to the sign.
      const int turn = (triangle.Corner[c].Turn + this->Degree - edge.Axis) % (this->Degree / 2);
      if (this->IsPoint[triangle.Vertex[c]] == 0 &&
        this->AcrossFeature.emplace(std::pair(triangle.Vertex[c], turn), count).second)
      {
        ++count;
      }
    }
  }
  flags.resize(count, 1);
  return flags;
}

/// Of all maps that differ by a translation takes one with a grid point in 0.
void ParametrizationVariables::FixOrigin()
{
  Index origin = this->Mesh.Cones.empty() ? None : this->Mesh.Cones.front().Vertex;
  for (std::size_t v = 0; origin == None && v < this->Mesh.IsChainEnd.size(); ++v)
  {
    origin = this->Mesh.IsChainEnd[v] != 0 ? static_cast<Index>(v) : None;
  }
  if (origin == None && !this->AcrossFeature.empty())
  {
    origin = this->AcrossFeature.begin()->first.first;
  }
  if (origin != None)
  {
    this->Solved.Require({ { 2 * origin, 1 } });
    this->Solved.Require({ { 2 * origin + 1, 1 } });
  }
}
}
