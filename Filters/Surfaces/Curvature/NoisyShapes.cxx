// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Curvature/NoisyShapes.h"

#include "Curvature/ShapeAverages.h"
#include "Curvature/ShapeIntegral.h"
#include "Curvature/ShapeSteps.h"
#include "Support/Threads.h"

#include <algorithm>

namespace DirectionFields::Internal
{
namespace
{
/// The steps whose averages of the fits the integrals start from, and those at most.
constexpr int StepsOfFits = 4;
constexpr int MostSteps = 64;
/// Of the changes of averaged integrals each doubling leaves an eighth where they are noise, and
/// makes four times as much where they are the surface's own variation. The fits' errors on uneven
/// meshes, which the first doubling may meet, stay about the same. The last doubling stands as it
/// is where noise prevails.
constexpr double FirstGain = 0.7;
constexpr double NextGain = 1.0;
constexpr double LastGain = 0.5;

class NoisySmoothing : public ShapeSteps
{
public:
  NoisySmoothing(
    const SurfaceGeometry& geometry, const std::vector<Shape>& shapes, const PieceOfSurface& piece)
    : ShapeSteps(geometry, shapes, piece)
  {
  }

  /// Averages each vertex as long as that pays.
  void FindScales(const SurfaceGeometry& geometry, const std::vector<Shape>& edges)
  {
    this->Step(StepsOfFits / 2);
    this->Kept = this->Current;
    this->ForOpen([&](Index v) { this->Steps[v] = StepsOfFits / 2; });
    this->Step(StepsOfFits / 2);
    this->EndAtBoundary(geometry);
    this->TakeIntegrals(geometry, edges);
    this->Double();
  }

private:
  /// Goes on with the integrals of curvature over the surroundings of each vertex, by the edges.
  void TakeIntegrals(const SurfaceGeometry& geometry, const std::vector<Shape>& edges)
  {
    this->ForOpen(
      [&](Index v)
      {
        WeightedShape& value = this->Current[v];
        value =
          ShapeIntegral(geometry, v, edges[v], Shape{ value.GetHopf(), value.GetMean(), 0.0 });
        const double factor = 1.0 / this->Mean.SumOfWeights(v);
        value.Hopf *= factor;
        value.Mean *= factor;
        value.Weight *= factor;
      });
    this->Piece.Complete(this->Current);
    this->Scratch = this->Current;
  }

  /// Doubles the steps as long as that pays. What a vertex keeps is freed of the first order of the
  /// surface's own variation: S + (S - S'), S' with twice the steps.
  void Double()
  {
    this->Step(StepsOfFits / 2);
    std::vector<WeightedShape> candidate = this->Current;
    this->Step(StepsOfFits / 2);
    std::vector<float> before = this->Changes(candidate);
    std::vector<char> isDecided(candidate.size(), 0);
    for (int steps = StepsOfFits; steps <= MostSteps && this->IsAnyOpen(); steps *= 2)
    {
      this->ForOpen([&](Index v) { candidate[v] = this->Current[v]; });
      this->Step(steps);
      std::vector<float> after = this->Changes(candidate);
      const double gain = steps == StepsOfFits ? FirstGain
        : steps == MostSteps                   ? LastGain
                                               : NextGain;
      this->ForOpen(
        [&](Index v)
        {
          if (isDecided[v] == 0 && after[v] < gain * before[v])
          {
            this->Kept[v] = this->Current[v];
            this->Steps[v] = 2 * steps;
          }
          else if (isDecided[v] == 0)
          {
            isDecided[v] = 1;
            if (steps > StepsOfFits)
            {
              this->Kept[v] = Extrapolated(candidate[v], this->Current[v]);
              this->Steps[v] = steps;
            }
          }
        });
      if (steps < MostSteps)
      {
        this->CloseDecided(isDecided, steps);
      }
      before.swap(after);
    }
    this->Current.swap(this->Kept);
  }

  static WeightedShape Extrapolated(const WeightedShape& near, const WeightedShape& far)
  {
    const double weight = near.Weight;
    return { weight * (2.0 * near.GetHopf() - far.GetHopf()),
      weight * (2.0 * near.GetMean() - far.GetMean()), weight };
  }
};
}

void SmoothNoise(const SurfaceGeometry& geometry, const std::vector<Shape>& edges,
  const std::vector<char>& isNoisy, std::vector<Shape>& shapes, const PieceOfSurface& piece)
{
  const TriangleMesh& mesh = geometry.Mesh;
  piece.Complete(shapes);
  std::vector<Shape> noisy(shapes.size());
  mesh.ForEachComponent(
    [&](Index c)
    {
      if (isNoisy[c] != 0)
      {
        const TriangleMesh::Component& component = mesh.GetComponents()[c];
        std::copy(shapes.begin() + component.FirstVertex, shapes.begin() + component.EndVertex,
          noisy.begin() + component.FirstVertex);
      }
    });
  NoisySmoothing smoothing(geometry, noisy, piece);
  smoothing.FindScales(geometry, edges);
  mesh.ForEachComponent(
    [&](Index c)
    {
      if (isNoisy[c] != 0)
      {
        smoothing.Write(mesh.GetComponents()[c], shapes);
      }
    });
  piece.Complete(shapes);
}
}
