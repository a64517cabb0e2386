// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Curvature/ShapeSteps.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// The weight of a fit, the inverse of its standard deviation: between 1, which is best for the
/// surface's own variation, and the inverse of the variance, which is best for noise.
double WeightOf(const Shape& shape)
{
  return 1.0 / std::sqrt(std::clamp(shape.Variance, 1e-100, 1e100));
}
}

ShapeSteps::ShapeSteps(
  const SurfaceGeometry& geometry, const std::vector<Shape>& shapes, const PieceOfSurface& piece)
  : Piece(piece)
  , Mean(geometry, shapes)
  , Current(shapes.size())
  , IsOpen(shapes.size(), 0)
  , Steps(shapes.size(), 0)
{
  for (Index v = 0; v < static_cast<Index>(shapes.size()); ++v)
  {
    if (shapes[v].IsFitted())
    {
      const double weight = WeightOf(shapes[v]);
      this->Current[v] = { weight * shapes[v].Hopf, weight * shapes[v].Mean, weight };
      this->IsOpen[v] = 1;
      if (piece.IsOwned(v))
      {
        this->Open.push_back(v);
      }
    }
  }
  this->Scratch = this->Current;
}

int ShapeSteps::StepsOver(double squaredRadius)
{
  return static_cast<int>(std::lround(std::max(0.0, squaredRadius) / (2.0 * ShapeAverages::Share)));
}

void ShapeSteps::Write(const TriangleMesh::Component& component, std::vector<Shape>& shapes) const
{
  ParallelFor(component.Vertices(), LightPiece,
    [&](Index begin, Index end)
    {
      for (Index v = component.FirstVertex + begin; v < component.FirstVertex + end; ++v)
      {
        if (shapes[v].IsFitted())
        {
          shapes[v].Hopf = this->Current[v].GetHopf();
          shapes[v].Mean = this->Current[v].GetMean();
          // That of white noise falls with the sixth power of the radius, but near boundaries and
          // between slivers with its square only.
          shapes[v].Variance /=
            1.0 + 2.0 * ShapeAverages::Share * this->Steps[v] / (FitRadius * FitRadius);
        }
      }
    });
}

void ShapeSteps::Step(int steps)
{
  for (int k = 0; k < steps; ++k)
  {
    this->ForOpen([&](Index v) { this->Scratch[v] = this->Mean.Of(v, this->Current); });
    this->Current.swap(this->Scratch);
    this->Piece.Complete(this->Current);
  }
}

void ShapeSteps::Close(Index v, const WeightedShape& value)
{
  this->IsOpen[v] = 0;
  this->Current[v] = value;
  this->Scratch[v] = value;
}

void ShapeSteps::ForgetClosed()
{
  this->Open.erase(std::remove_if(this->Open.begin(), this->Open.end(),
                     [&](Index v) { return this->IsOpen[v] == 0; }),
    this->Open.end());
  this->Piece.Complete(this->IsOpen);
  this->Piece.Complete(this->Current);
}

void ShapeSteps::CloseDecided(const std::vector<char>& isDecided, int steps)
{
  std::vector<float> near(isDecided.size());
  this->ForOpen([&](Index v) { near[v] = isDecided[v] == 0 ? 1.0F : 0.0F; });
  // Steps reach as far as their weights are noticeable: each adds less than an edge squared to the
  // mean squared distance.
  this->Average(near, static_cast<int>(std::ceil(std::sqrt(2.0 * steps))));
  this->ForOpen(
    [&](Index v)
    {
      if (!(near[v] > 0.0F))
      {
        this->Close(v, this->Kept[v]);
      }
    });
  this->ForgetClosed();
}

void ShapeSteps::EndAtBoundary(const SurfaceGeometry& geometry)
{
  const TriangleMesh& mesh = geometry.Mesh;
  const auto isInside = [&](Index v) { return !mesh.IsBoundary(v); };
  std::vector<char> ends(this->Current.size(), 0);
  this->ForOpen(
    [&](Index v) { ends[v] = !isInside(v) && this->Mean.HasNeighbour(v, isInside) ? 1 : 0; });
  this->Piece.Complete(ends);
  this->Mean.EndAt(geometry, ends);
}

void ShapeSteps::Average(std::vector<float>& numbers, int steps) const
{
  std::vector<float> averaged(numbers.size());
  for (int k = 0; k < steps; ++k)
  {
    this->Piece.Complete(numbers);
    this->ForOpen([&](Index v) { averaged[v] = this->Mean.Of(v, numbers, this->IsOpen); });
    numbers.swap(averaged);
  }
}

std::vector<float> ShapeSteps::Changes(const std::vector<WeightedShape>& then) const
{
  return this->Around(
    [&](Index v) { return static_cast<float>(SquaredDistance(this->Current[v], then[v])); });
}

double ShapeSteps::SquaredDistance(const WeightedShape& a, const WeightedShape& b)
{
  const double mean = a.GetMean() - b.GetMean();
  return std::norm(a.GetHopf() - b.GetHopf()) + mean * mean;
}
}
