// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Curvature/ShapeSmoothing.h"

#include "Curvature/ShapeAverages.h"
#include "Curvature/ShapeSteps.h"
#include "Support/Threads.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
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
/// Noise prevails in a component if, after so many doublings, more than this part of its vertices
/// are averaged on whose shapes scatter as errors of heights between these two lead to, in mean
/// edges. Smaller ones do not matter to the fits. Larger scatter is that of shapes too fine for the
/// triangles, as of coarse meshes that have all of an animal's face; to average it takes the shape
/// away.
constexpr int DoublingsToNoise = 3;
constexpr double NoisyPart = 0.5;
constexpr double LeastError = 0.001;
constexpr double MostError = 0.1;
/// How much more a first step changes white noise than a second one, in the mean square, and the
/// variance of its mean of k steps times k, in parts of the noise's variance: those of regular
/// triangulations.
constexpr double ScatterOfNoise = 0.634;
constexpr double VarianceOfMeans = 0.184;

/// Finds how far shapes are to be averaged.
class Smoothing : public ShapeSteps
{
public:
  Smoothing(
    const SurfaceGeometry& geometry, const std::vector<Shape>& shapes, const PieceOfSurface& piece)
    : ShapeSteps(geometry, shapes, piece)
  {
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
    this->ForOpen(
      [&](Index v)
      {
        noise[v] = static_cast<float>(SquaredDistance(off[v], average[v]));
        bias[v] = static_cast<float>(SquaredDistance(average[v], { 0.0, 0.0, 1.0 }));
      });
    this->Average(noise, CorrectionSteps);
    this->Average(bias, CorrectionSteps);
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

  /// Averages each vertex as long as that pays.
  void FindScales()
  {
    this->StartDoubling();
    for (int doubling = 1; doubling <= MostDoublings && this->IsAnyOpen(); ++doubling)
    {
      this->Double(doubling);
    }
    this->KeepLast();
  }

  /// Averages each vertex as long as that pays, but for components where noise prevails.
  /// @return which these are
  std::vector<char> FindScalesWithoutNoise(
    const TriangleMesh& mesh, const std::vector<Shape>& shapes)
  {
    std::vector<char> isNoisy(mesh.GetComponents().size(), 0);
    std::vector<char> isError(shapes.size(), 0);
    this->StartDoubling();
    for (int doubling = 1; doubling <= MostDoublings && this->IsAnyOpen(); ++doubling)
    {
      const std::vector<float> before = doubling == 1 ? this->LastChange : std::vector<float>();
      this->Double(doubling);
      if (doubling == 1)
      {
        this->ForOpen(
          [&](Index v)
          {
            const double error = (before[v] - this->LastChange[v]) / shapes[v].Variance;
            isError[v] = error > LeastError * LeastError && error < MostError * MostError ? 1 : 0;
          });
      }
      if (doubling == DoublingsToNoise)
      {
        isNoisy = this->FindNoise(mesh, isError);
      }
    }
    this->KeepLast();
    return isNoisy;
  }

  /// How much more the first step changes q than the second one does, squared and averaged over
  /// the surroundings; before any step is taken. Noise is mostly gone after one step, while q's own
  /// variation changes as much in both.
  std::vector<float> Scatter()
  {
    std::vector<WeightedShape> first(this->Current.size());
    this->ForOpen([&](Index v) { first[v] = this->Mean.Of(v, this->Current); });
    this->Piece.Complete(first);
    std::vector<float> scatter = this->Around(
      [&](Index v)
      {
        const Complex once = first[v].GetHopf();
        const Complex twice = this->Mean.Of(v, first).GetHopf();
        const double more = std::norm(this->Current[v].GetHopf() - once) - std::norm(once - twice);
        return static_cast<float>(more);
      });
    this->ForOpen([&](Index v) { scatter[v] = std::max(scatter[v], 0.0F); });
    return scatter;
  }

  /// The means, and the variances that noise of this scatter leaves in them.
  using ShapeSteps::Write;
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

private:
  void StartDoubling()
  {
    this->Kept = this->Current;
    this->Step(1);
    this->Candidate = this->Current;
    this->LastChange = this->Changes(this->Kept);
  }

  /// Doubles the steps of what is open, and closes the vertices to which this does not pay.
  void Double(int doubling)
  {
    this->Step(1 << (doubling - 1));
    std::vector<float> change = this->Changes(this->Candidate);
    const double gain = doubling == 1 ? FirstGain : NextGain;
    this->ForOpen(
      [&](Index v)
      {
        if (change[v] < gain * this->LastChange[v])
        {
          this->Kept[v] = this->Candidate[v];
          this->Steps[v] = 1 << (doubling - 1);
          this->Candidate[v] = this->Current[v];
        }
        else
        {
          this->Close(v, this->Kept[v]);
        }
      });
    this->ForgetClosed();
    this->LastChange.swap(change);
  }

  void KeepLast()
  {
    this->ForOpen([&](Index v) { this->Current[v] = this->Kept[v]; });
  }

  /// The components that noise prevails in, which are averaged no further.
  /// @param isError whether a vertex scatters as errors of heights do
  std::vector<char> FindNoise(const TriangleMesh& mesh, const std::vector<char>& isError)
  {
    const std::size_t components = mesh.GetComponents().size();
    std::vector<double> noisy(components, 0.0);
    std::vector<double> all(components, 0.0);
    mesh.ForEachComponent(
      [&](Index c)
      {
        const TriangleMesh::Component& component = mesh.GetComponents()[c];
        for (Index v = component.FirstVertex; v < component.EndVertex; ++v)
        {
          if (this->Piece.IsOwned(v))
          {
            noisy[c] += this->IsOpen[v] != 0 && isError[v] != 0 ? 1.0 : 0.0;
            all[c] += 1.0;
          }
        }
      });
    this->Piece.Sum(noisy);
    this->Piece.Sum(all);
    std::vector<char> isNoisy(components, 0);
    mesh.ForEachComponent(
      [&](Index c)
      {
        if (noisy[c] > NoisyPart * all[c])
        {
          isNoisy[c] = 1;
          const TriangleMesh::Component& component = mesh.GetComponents()[c];
          std::fill(this->IsOpen.begin() + component.FirstVertex,
            this->IsOpen.begin() + component.EndVertex, 0);
        }
      });
    this->ForgetClosed();
    return isNoisy;
  }

  /// The averages that the next doubling is compared to, and the squared changes by the last one.
  std::vector<WeightedShape> Candidate;
  std::vector<float> LastChange;
};
}

std::vector<char> SmoothShapes(const SurfaceGeometry& geometry, const std::vector<Shape>& edges,
  double rings, std::vector<Shape>& shapes, const PieceOfSurface& piece)
{
  const TriangleMesh& mesh = geometry.Mesh;
  piece.Complete(shapes);
  Smoothing smoothing(geometry, shapes, piece);
  smoothing.Correct(shapes, edges);
  std::vector<char> isNoisy(mesh.GetComponents().size(), 0);
  if (rings > 0.0)
  {
    smoothing.TakeSteps(
      ShapeSteps::StepsOver(rings * rings - ShapeSteps::FitRadius * ShapeSteps::FitRadius));
  }
  else
  {
    isNoisy = smoothing.FindScalesWithoutNoise(mesh, shapes);
  }
  mesh.ForEachComponent(
    [&](Index c)
    {
      if (isNoisy[c] == 0)
      {
        smoothing.Write(mesh.GetComponents()[c], shapes);
      }
    });
  piece.Complete(shapes);
  return isNoisy;
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
    smoothing.TakeSteps(ShapeSteps::StepsOver(edges * edges));
  }
  else
  {
    smoothing.FindScales();
  }
  smoothing.Write(scatter, tensors);
}
}
