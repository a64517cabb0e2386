// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Curvature/ShapeSmoothing.h"

#include "Curvature/ShapeAverages.h"
#include "Support/Threads.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// A step adds the same number to the mean squared distance of the vertices in the mean, in squared
/// edges; for the points of a fitted quadric that distance is FitRadius^2 / 2.
constexpr double FitRadius = 1.5;
/// A first step pays where the second one changes less than this times as much, in the mean square;
/// a doubling of steps, which adds more of the surface's own variation, where the next one does.
constexpr double FirstGain = 0.55;
constexpr double NextGain = 1.0;
constexpr int MostDoublings = 7;
/// The correction is made in full where the squared scatter of the edges is less than the first
/// times the squared correction, and not at all where it is more than the second times. Means of
/// scatter alone leave a fourth of it.
constexpr double LeastNoise = 0.25;
constexpr double MostNoise = 1.5;
constexpr int CorrectionSteps = 2;
/// Steps by which squared changes are averaged before they are compared.
constexpr int ChangeSteps = 4;
/// How much more a first step changes white noise than a second one, in the mean square, and the
/// variance of its mean of k steps times k, in parts of the noise's variance: those of regular
/// triangulations.
constexpr double ScatterOfNoise = 0.634;
constexpr double VarianceOfMeans = 0.184;

double SquaredDistance(const WeightedShape& a, const WeightedShape& b)
{
  const double mean = a.GetMean() - b.GetMean();
  return std::norm(a.GetHopf() - b.GetHopf()) + mean * mean;
}

/// The weight of a fit, the inverse of its standard deviation: between 1, which is best for the
/// surface's own variation, and the inverse of the variance, which is best for noise.
double WeightOf(const Shape& shape)
{
  return 1.0 / std::sqrt(std::clamp(shape.Variance, 1e-100, 1e100));
}

/// Shapes on their way to larger and larger surroundings.
class Smoothing
{
public:
  Smoothing(
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

  /// Adds the difference between the shapes of the edges and the fits, averaged over the
  /// surroundings, as far as it is not noise of the edges.
  void Correct(const std::vector<Shape>& shapes, const std::vector<Shape>& edges)
  {
    std::vector<WeightedShape> off(shapes.size());
    std::vector<WeightedShape> average(shapes.size());
    this->ForOpen(
      [&](Index v) {
        off[v] = { edges[v].Hopf - shapes[v].Hopf, edges[v].Mean - shapes[v].Mean, 1.0 };
      });
    this->Piece.Complete(off);
    this->ForOpen([&](Index v) { average[v] = this->Mean.Of(v, off); });
    std::vector<float> noise(shapes.size());
    std::vector<float> bias(shapes.size());
    std::vector<float> averaged(shapes.size());
    this->ForOpen(
      [&](Index v)
      {
        noise[v] = static_cast<float>(SquaredDistance(off[v], average[v]));
        bias[v] = static_cast<float>(SquaredDistance(average[v], { 0.0, 0.0, 1.0 }));
      });
    for (std::vector<float>* numbers : { &noise, &bias })
    {
      for (int k = 0; k < CorrectionSteps; ++k)
      {
        this->Average(*numbers, averaged);
      }
    }
    this->ForOpen(
      [&](Index v)
      {
        const double part =
          std::clamp((MostNoise - noise[v] / bias[v]) / (MostNoise - LeastNoise), 0.0, 1.0);
        if (part > 0.0)
        {
          WeightedShape& value = this->Current[v];
          value.Hopf += part * value.Weight * average[v].GetHopf();
          value.Mean += part * value.Weight * average[v].GetMean();
        }
      });
    this->Piece.Complete(this->Current);
    this->Scratch = this->Current;
  }

  /// As many steps at all vertices.
  void TakeSteps(int steps)
  {
    this->Step(steps);
    this->ForOpen([&](Index v) { this->Steps[v] = steps; });
  }

  /// ShapeAverages each vertex as long as that pays.
  void FindScales()
  {
    std::vector<WeightedShape> kept = this->Current;
    this->Step(1);
    std::vector<WeightedShape> candidate = this->Current;
    std::vector<float> before = this->Changes(kept);
    for (int doubling = 1; doubling <= MostDoublings && this->Piece.Any(!this->Open.empty());
         ++doubling)
    {
      this->Step(1 << (doubling - 1));
      std::vector<float> after = this->Changes(candidate);
      const double gain = doubling == 1 ? FirstGain : NextGain;
      this->ForOpen(
        [&](Index v)
        {
          if (after[v] < gain * before[v])
          {
            kept[v] = candidate[v];
            this->Steps[v] = 1 << (doubling - 1);
            candidate[v] = this->Current[v];
          }
          else
          {
            this->IsOpen[v] = 0;
            this->Current[v] = kept[v];
            this->Scratch[v] = kept[v];
          }
        });
      this->Open.erase(std::remove_if(this->Open.begin(), this->Open.end(),
                         [&](Index v) { return this->IsOpen[v] == 0; }),
        this->Open.end());
      this->Piece.Complete(this->IsOpen);
      this->Piece.Complete(this->Current);
      before.swap(after);
    }
    this->ForOpen([&](Index v) { this->Current[v] = kept[v]; });
  }

  /// How much more the first step changes q than the second one does, squared and averaged over
  /// the surroundings; before any step is taken. Noise is mostly gone after one step, while q's own
  /// variation changes as much in both.
  std::vector<float> Scatter()
  {
    std::vector<WeightedShape> first(this->Current.size());
    std::vector<float> scatter(first.size());
    std::vector<float> averaged(first.size());
    this->ForOpen([&](Index v) { first[v] = this->Mean.Of(v, this->Current); });
    this->Piece.Complete(first);
    this->ForOpen(
      [&](Index v)
      {
        const Complex once = first[v].GetHopf();
        const Complex twice = this->Mean.Of(v, first).GetHopf();
        const double more = std::norm(this->Current[v].GetHopf() - once) - std::norm(once - twice);
        scatter[v] = static_cast<float>(more);
      });
    for (int k = 0; k < ChangeSteps; ++k)
    {
      this->Average(scatter, averaged);
    }
    this->ForOpen([&](Index v) { scatter[v] = std::max(scatter[v], 0.0F); });
    return scatter;
  }

  /// The means, and the variances that noise of this scatter leaves in them.
  void Write(const std::vector<float>& scatter, std::vector<Shape>& shapes) const
  {
    for (std::size_t v = 0; v < shapes.size(); ++v)
    {
      const double left =
        this->Steps[v] == 0 ? 1.0 : std::min(1.0, VarianceOfMeans / this->Steps[v]);
      shapes[v].Hopf = this->Current[v].GetHopf();
      shapes[v].Mean = this->Current[v].GetMean();
      shapes[v].Variance = left * scatter[v] / ScatterOfNoise;
    }
  }

  void Write(std::vector<Shape>& shapes) const
  {
    ParallelFor(static_cast<Index>(shapes.size()), LightPiece,
      [&](Index begin, Index end)
      {
        for (Index v = begin; v < end; ++v)
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

private:
  /// ShapeAverages the open vertices.
  void Step(int steps)
  {
    for (int k = 0; k < steps; ++k)
    {
      this->ForOpen([&](Index v) { this->Scratch[v] = this->Mean.Of(v, this->Current); });
      this->Current.swap(this->Scratch);
      this->Piece.Complete(this->Current);
    }
  }

  /// Replaces the numbers of the open vertices by their means with those of open neighbours.
  void Average(std::vector<float>& numbers, std::vector<float>& scratch)
  {
    this->Piece.Complete(numbers);
    this->ForOpen([&](Index v) { scratch[v] = this->Mean.Of(v, numbers, this->IsOpen); });
    numbers.swap(scratch);
  }

  template <typename Body>
  void ForOpen(const Body& body)
  {
    ParallelFor(static_cast<Index>(this->Open.size()), MediumPiece,
      [&](Index begin, Index end)
      {
        for (Index k = begin; k < end; ++k)
        {
          body(this->Open[k]);
        }
      });
  }

  /// The squared changes of the open vertices since then, averaged over their surroundings.
  std::vector<float> Changes(const std::vector<WeightedShape>& then)
  {
    std::vector<float> changes(then.size());
    std::vector<float> averaged(then.size());
    this->ForOpen([&](Index v)
      { changes[v] = static_cast<float>(SquaredDistance(this->Current[v], then[v])); });
    for (int k = 0; k < ChangeSteps; ++k)
    {
      this->Average(changes, averaged);
    }
    return changes;
  }

  const PieceOfSurface& Piece;
  ShapeAverages Mean;
  std::vector<WeightedShape> Current;
  std::vector<WeightedShape> Scratch;
  /// The vertices of the piece that are averaged on; IsOpen also tells those next to them.
  std::vector<Index> Open;
  std::vector<char> IsOpen;
  /// How many steps each vertex has come.
  std::vector<int> Steps;
};
}

void SmoothShapes(const SurfaceGeometry& geometry, const std::vector<Shape>& edges, double rings,
  std::vector<Shape>& shapes, const PieceOfSurface& piece)
{
  piece.Complete(shapes);
  Smoothing smoothing(geometry, shapes, piece);
  smoothing.Correct(shapes, edges);
  if (rings > 0.0)
  {
    const double steps = (rings * rings - FitRadius * FitRadius) / (2.0 * ShapeAverages::Share);
    smoothing.TakeSteps(std::max(0, static_cast<int>(std::lround(steps))));
  }
  else
  {
    smoothing.FindScales();
  }
  smoothing.Write(shapes);
  piece.Complete(shapes);
}

void SmoothTensors(const SurfaceGeometry& geometry, double edges, std::vector<Shape>& tensors)
{
  for (Shape& tensor : tensors)
  {
    tensor.Variance = 1.0;
  }
  const PieceOfSurface whole;
  Smoothing smoothing(geometry, tensors, whole);
  const std::vector<float> scatter = smoothing.Scatter();
  if (edges > 0.0)
  {
    smoothing.TakeSteps(
      static_cast<int>(std::lround(edges * edges / (2.0 * ShapeAverages::Share))));
  }
  else
  {
    smoothing.FindScales();
  }
  smoothing.Write(scatter, tensors);
}
}
