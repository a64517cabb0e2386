// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Curvature/ShapeSmoothing.h"

#include "Support/Threads.h"
#include "Support/VectorMath.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace DirectionFields::Internal
{
namespace
{
/// The part of a mean that the neighbours have. A step adds the same number to the mean squared
/// distance of the vertices in the mean, in squared edges; for the points of a fitted quadric that
/// distance is FitRadius^2 / 2.
constexpr double Share = 0.75;
constexpr double FitRadius = 1.5;
/// The cotangent weights are those of linear interpolation: means of them have no drift. Negative
/// ones would make noise larger.
constexpr double LeastWeight = 0.02;
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

/// A shape times the weight that its fit deserves, and the weight.
struct Weighted
{
  Complex Hopf = 0.0;
  double Mean = 0.0;
  double Weight = 0.0;

  Complex GetHopf() const { return this->Hopf * (1.0 / this->Weight); }
  double GetMean() const { return this->Mean * (1.0 / this->Weight); }
};

double SquaredDistance(const Weighted& a, const Weighted& b)
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

/// Means with the neighbours, for sections of degree 2 and for numbers.
class Averages
{
public:
  Averages(const SurfaceGeometry& geometry, const std::vector<Shape>& shapes);

  /// The mean around a vertex.
  Weighted Of(Index v, const std::vector<Weighted>& values) const
  {
    const Index begin = this->Start[v];
    const Index end = this->Start[v + 1];
    const double own = this->Own(begin, end);
    Weighted sum = values[v];
    sum.Hopf *= own;
    sum.Mean *= own;
    sum.Weight *= own;
    for (Index k = begin; k < end; ++k)
    {
      const Coupling& coupling = this->Couplings[k];
      const Weighted& other = values[coupling.Vertex];
      sum.Hopf +=
        Complex(coupling.Real * other.Hopf.real() - coupling.Imaginary * other.Hopf.imag(),
          coupling.Real * other.Hopf.imag() + coupling.Imaginary * other.Hopf.real());
      sum.Mean += coupling.Weight * other.Mean;
      sum.Weight += coupling.Weight * other.Weight;
    }
    return sum;
  }

  /// The mean of the numbers at the vertex and at its neighbours that take part.
  float Of(Index v, const std::vector<float>& values, const std::vector<char>& takesPart) const
  {
    const float own = values[v];
    float sum = own;
    for (Index k = this->Start[v]; k < this->Start[v + 1]; ++k)
    {
      const Coupling& coupling = this->Couplings[k];
      sum +=
        takesPart[coupling.Vertex] != 0 ? coupling.Weight * (values[coupling.Vertex] - own) : 0;
    }
    return sum;
  }

private:
  struct Coupling
  {
    Index Vertex;
    float Weight;
    /// The weight times the transport from that vertex.
    float Real;
    float Imaginary;
  };

  double Own(Index begin, Index end) const
  {
    double sum = 1.0;
    for (Index k = begin; k < end; ++k)
    {
      sum -= this->Couplings[k].Weight;
    }
    return sum;
  }

  void Fill(
    const SurfaceGeometry& geometry, const std::vector<Shape>& shapes, Index begin, Index end);

  std::vector<Index> Start;
  std::vector<Coupling> Couplings;
};

/// Calls body(h, neighbour, outgoing) for the edges of a vertex, by a half-edge that runs out or
/// in.
template <typename Body>
void ForEachEdge(const TriangleMesh& mesh, Index v, const Body& body)
{
  const Index first = mesh.Outgoing(v);
  Index h = first;
  Index last = first;
  do
  {
    body(h, mesh.Head(h), true);
    last = h;
    h = mesh.NextOutgoing(h);
  } while (h != None && h != first);
  if (h == None)
  {
    const Index incoming = TriangleMesh::Previous(last);
    body(incoming, mesh.Tail(incoming), false);
  }
}

/// Half the cotangent of the corner opposite of a half-edge.
double HalfCotangent(const Metric& metric, const TriangleMesh& mesh, Index h)
{
  const double across = metric.SquaredLength[mesh.Edge(TriangleMesh::Next(h))] +
    metric.SquaredLength[mesh.Edge(TriangleMesh::Previous(h))] - metric.SquaredLength[mesh.Edge(h)];
  return across / (8.0 * metric.Area[h / 3]);
}

Averages::Averages(const SurfaceGeometry& geometry, const std::vector<Shape>& shapes)
  : Start(shapes.size() + 1, 0)
{
  const TriangleMesh& mesh = geometry.Mesh;
  const auto vertices = static_cast<Index>(shapes.size());
  ParallelFor(vertices, LightPiece,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        if (shapes[v].IsFitted())
        {
          ForEachEdge(mesh, v,
            [&](Index, Index j, bool) { this->Start[v + 1] += shapes[j].IsFitted() ? 1 : 0; });
        }
      }
    });
  std::partial_sum(this->Start.begin(), this->Start.end(), this->Start.begin());
  this->Couplings.resize(this->Start.back());
  ParallelFor(vertices, HeavyPiece,
    [&](Index begin, Index end) { this->Fill(geometry, shapes, begin, end); });
}

void Averages::Fill(
  const SurfaceGeometry& geometry, const std::vector<Shape>& shapes, Index begin, Index end)
{
  const TriangleMesh& mesh = geometry.Mesh;
  const Index first = this->Start[begin];
  const Index count = this->Start[end] - first;
  std::vector<double> angles(count);
  std::vector<double> cosines(count);
  std::vector<double> sines(count);
  Index next = first;
  for (Index v = begin; v < end; ++v)
  {
    const Index row = next;
    double sum = 0.0;
    if (shapes[v].IsFitted())
    {
      ForEachEdge(mesh, v,
        [&](Index h, Index j, bool outgoing)
        {
          if (shapes[j].IsFitted())
          {
            const Index twin = mesh.Twin(h);
            const double weight = HalfCotangent(geometry.Lengths, mesh, h) +
              (twin != None ? HalfCotangent(geometry.Lengths, mesh, twin) : 0.0);
            const double rotation = geometry.Transport.RotationAlong(mesh, h);
            angles[next - first] = outgoing ? -2.0 * rotation : 2.0 * rotation;
            this->Couplings[next].Vertex = j;
            this->Couplings[next].Weight = static_cast<float>(std::max(weight, LeastWeight));
            sum += this->Couplings[next].Weight;
            ++next;
          }
        });
    }
    for (Index k = row; k < next; ++k)
    {
      this->Couplings[k].Weight = static_cast<float>(this->Couplings[k].Weight * (Share / sum));
    }
  }
  CosinesAndSines(angles.data(), count, cosines.data(), sines.data());
  for (Index k = 0; k < count; ++k)
  {
    Coupling& coupling = this->Couplings[first + k];
    coupling.Real = static_cast<float>(coupling.Weight * cosines[k]);
    coupling.Imaginary = static_cast<float>(coupling.Weight * sines[k]);
  }
}

/// Shapes on their way to larger and larger surroundings.
class Smoothing
{
public:
  Smoothing(const SurfaceGeometry& geometry, const std::vector<Shape>& shapes)
    : Mean(geometry, shapes)
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
        this->Open.push_back(v);
        this->IsOpen[v] = 1;
      }
    }
    this->Scratch = this->Current;
  }

  /// Adds the difference between the shapes of the edges and the fits, averaged over the
  /// surroundings, as far as it is not noise of the edges.
  void Correct(const std::vector<Shape>& shapes, const std::vector<Shape>& edges)
  {
    std::vector<Weighted> off(shapes.size());
    std::vector<Weighted> average(shapes.size());
    this->ForOpen(
      [&](Index v) {
        off[v] = { edges[v].Hopf - shapes[v].Hopf, edges[v].Mean - shapes[v].Mean, 1.0 };
      });
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
        this->ForOpen([&](Index v) { averaged[v] = this->Mean.Of(v, *numbers, this->IsOpen); });
        numbers->swap(averaged);
      }
    }
    this->ForOpen(
      [&](Index v)
      {
        const double part =
          std::clamp((MostNoise - noise[v] / bias[v]) / (MostNoise - LeastNoise), 0.0, 1.0);
        if (part > 0.0)
        {
          Weighted& value = this->Current[v];
          value.Hopf += part * value.Weight * average[v].GetHopf();
          value.Mean += part * value.Weight * average[v].GetMean();
        }
      });
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
    std::vector<Weighted> kept = this->Current;
    this->Step(1);
    std::vector<Weighted> candidate = this->Current;
    std::vector<float> before = this->Changes(kept);
    for (int doubling = 1; doubling <= MostDoublings && !this->Open.empty(); ++doubling)
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
      before.swap(after);
    }
    this->ForOpen([&](Index v) { this->Current[v] = kept[v]; });
  }

  /// How much more the first step changes q than the second one does, squared and averaged over
  /// the surroundings; before any step is taken. Noise is mostly gone after one step, while q's own
  /// variation changes as much in both.
  std::vector<float> Scatter()
  {
    std::vector<Weighted> first(this->Current.size());
    std::vector<float> scatter(first.size());
    std::vector<float> averaged(first.size());
    this->ForOpen([&](Index v) { first[v] = this->Mean.Of(v, this->Current); });
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
      this->ForOpen([&](Index v) { averaged[v] = this->Mean.Of(v, scatter, this->IsOpen); });
      scatter.swap(averaged);
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
            shapes[v].Variance /= 1.0 + 2.0 * Share * this->Steps[v] / (FitRadius * FitRadius);
          }
        }
      });
  }

private:
  /// Averages the open vertices.
  void Step(int steps)
  {
    for (int k = 0; k < steps; ++k)
    {
      this->ForOpen([&](Index v) { this->Scratch[v] = this->Mean.Of(v, this->Current); });
      this->Current.swap(this->Scratch);
    }
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
  std::vector<float> Changes(const std::vector<Weighted>& then)
  {
    std::vector<float> changes(then.size());
    std::vector<float> averaged(then.size());
    this->ForOpen([&](Index v)
      { changes[v] = static_cast<float>(SquaredDistance(this->Current[v], then[v])); });
    for (int k = 0; k < ChangeSteps; ++k)
    {
      this->ForOpen([&](Index v) { averaged[v] = this->Mean.Of(v, changes, this->IsOpen); });
      changes.swap(averaged);
    }
    return changes;
  }

  Averages Mean;
  std::vector<Weighted> Current;
  std::vector<Weighted> Scratch;
  std::vector<Index> Open;
  std::vector<char> IsOpen;
  /// How many steps each vertex has come.
  std::vector<int> Steps;
};
}

void SmoothShapes(const SurfaceGeometry& geometry, const std::vector<Shape>& edges, double rings,
  std::vector<Shape>& shapes)
{
  Smoothing smoothing(geometry, shapes);
  smoothing.Correct(shapes, edges);
  if (rings > 0.0)
  {
    const double steps = (rings * rings - FitRadius * FitRadius) / (2.0 * Share);
    smoothing.TakeSteps(std::max(0, static_cast<int>(std::lround(steps))));
  }
  else
  {
    smoothing.FindScales();
  }
  smoothing.Write(shapes);
}

void SmoothTensors(const SurfaceGeometry& geometry, double edges, std::vector<Shape>& tensors)
{
  for (Shape& tensor : tensors)
  {
    tensor.Variance = 1.0;
  }
  Smoothing smoothing(geometry, tensors);
  const std::vector<float> scatter = smoothing.Scatter();
  if (edges > 0.0)
  {
    smoothing.TakeSteps(static_cast<int>(std::lround(edges * edges / (2.0 * Share))));
  }
  else
  {
    smoothing.FindScales();
  }
  smoothing.Write(scatter, tensors);
}
}
