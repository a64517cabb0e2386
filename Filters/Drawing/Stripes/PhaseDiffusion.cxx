// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Stripes/PhaseDiffusion.h"

#include "Matrices/OperatorProducts.h"
#include "Matrices/VectorOperations.h"
#include "Multigrid/Hierarchy.h"
#include "Stripes/StripeMatrices.h"
#include "Support/MortonCurve.h"
#include "Support/VectorMath.h"
#include "Systems/CyclePreconditioner.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// The kappas in turn, in units of the density of the flux: long distances are settled first. Each
/// is used for this number of steps, with this number of V-cycles for a system.
constexpr std::array<double, 3> Kappas = { 0.1, 0.3, 1.0 };
constexpr int Turns = 6;
constexpr int CyclesPerTurn = 2;

/// Moments of positions about a point, weighted by area.
struct Moments
{
  double Area = 0.0;
  Vector3 First = Vector3::Zero();
  Eigen::Matrix3d Second = Eigen::Matrix3d::Zero();
  Moments& operator+=(const Moments& other)
  {
    this->Area += other.Area;
    this->First += other.First;
    this->Second += other.Second;
    return *this;
  }
};

/// The center of a component and its principal axes, the sense of each such that most lies farther
/// out on its positive side.
class PrincipalAxes
{
public:
  PrincipalAxes(const WantedPhases& wanted, const WantedPhases::Component& component)
    : Wanted(wanted)
    , Component(component)
  {
    const Moments about = this->About(Vector3::Zero());
    this->Center = about.First / about.Area;
    const Moments moments = this->About(this->Center);
    this->Axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moments.Second).eigenvectors();
    Vector3 cubes = Vector3::Zero();
    for (Index node = component.FirstNode; node < component.EndNode; ++node)
    {
      const Vector3 p = this->Place(node);
      cubes += this->Weight(node) * p.cwiseProduct(p).cwiseProduct(p);
    }
    for (int k = 0; k < 3; ++k)
    {
      if (cubes[k] < 0.0)
      {
        this->Axes.col(k) *= -1.0;
      }
    }
  }

  Vector3 Place(Index node) const
  {
    return this->Axes.transpose() * (this->Position(node) - this->Center);
  }
  Vector3 Seen(const Vector3& direction) const { return this->Axes.transpose() * direction; }

private:
  const Vector3& Position(Index node) const
  {
    return this->Wanted.GetField().GetGeometry().Positions[this->Wanted.Vertex(node)];
  }

  /// The areas of the triangles at a node.
  double Weight(Index node) const
  {
    const SurfaceGeometry& geometry = this->Wanted.GetField().GetGeometry();
    const TriangleMesh& mesh = geometry.Mesh;
    const Index first = mesh.Outgoing(this->Wanted.Vertex(node));
    double area = 0.0;
    Index h = first;
    do
    {
      area += geometry.Lengths.Area[h / 3];
      h = mesh.NextOutgoing(h);
    } while (h != None && h != first);
    return area;
  }

  Moments About(const Vector3& point) const
  {
    return ParallelSum<Moments>(this->Component.Nodes(), MediumPiece, {},
      [&](Index begin, Index end)
      {
        Moments moments;
        for (Index v = begin; v < end; ++v)
        {
          const Index node = this->Component.FirstNode + v;
          const double weight = this->Weight(node);
          const Vector3 p = this->Position(node) - point;
          moments.Area += weight;
          moments.First += weight * p;
          moments.Second += weight * p * p.transpose();
        }
        return moments;
      });
  }

  const WantedPhases& Wanted;
  const WantedPhases::Component& Component;
  Vector3 Center = Vector3::Zero();
  Eigen::Matrix3d Axes = Eigen::Matrix3d::Identity();
};

/// Scatters numbers (the finalizer of MurmurHash3 by A. Appleby); 0 to 1.
double Noise(std::uint64_t key)
{
  key ^= key >> 33;
  key *= 0xff51afd7ed558ccdULL;
  key ^= key >> 33;
  key *= 0xc4ceb9fe1a85ec53ULL;
  key ^= key >> 33;
  return static_cast<double>(key >> 11) / static_cast<double>(1ULL << 53);
}

void MakeUnit(ComplexVector& x, const ComplexVector& other)
{
  ForRows(x,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        const double modulus = Modulus(x[v]);
        x[v] = modulus > 0.0 && std::isfinite(modulus) ? x[v] / modulus : other[v];
      }
    });
}
}

PhaseDiffusion::PhaseDiffusion(const WantedPhases& wanted, const WantedPhases::Component& component)
  : Wanted(wanted)
  , Component(component)
  , Matrices(AssembleStripeMatrices(wanted, component))
  , Density(std::max(TotalFlux(wanted, component), 2.0 * Pi) /
      wanted.GetField().GetGeometry().Lengths.ComponentArea[component.Number])
{
}

ComplexVector PhaseDiffusion::Start() const
{
  const PrincipalAxes axes(this->Wanted, this->Component);
  std::vector<Vector3> places(this->Component.Nodes());
  BoundingBox box;
  for (Index v = 0; v < this->Component.Nodes(); ++v)
  {
    places[v] = axes.Place(this->Component.FirstNode + v);
    box.Add(places[v]);
  }
  const MortonCurve curve(box);
  const Index sheets = this->Component.HasTwoSheets ? 2 : 1;
  ComplexVector psi = Uninitialized(sheets * this->Component.Nodes());
  ParallelFor(this->Component.Nodes(), MediumPiece,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        const Complex value = std::polar(1.0, 2.0 * Pi * Noise(curve.Place(places[v])));
        // Which of the two vectors across the stripes was chosen is not to matter.
        const Vector3 gradient = axes.Seen(this->Wanted.Gradient(this->Component.FirstNode + v));
        Index largest = 0;
        gradient.cwiseAbs().maxCoeff(&largest);
        psi[sheets * v] = gradient[largest] > 0.0 ? value : std::conj(value);
        if (sheets == 2)
        {
          psi[2 * v + 1] = std::conj(psi[2 * v]);
        }
      }
    });
  return psi;
}

void PhaseDiffusion::MakeSymmetric(ComplexVector& psi) const
{
  if (!this->Component.HasTwoSheets)
  {
    return;
  }
  ParallelFor(this->Component.Nodes(), VectorPiece,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        psi[2 * v] = 0.5 * (psi[2 * v] + std::conj(psi[2 * v + 1]));
        psi[2 * v + 1] = std::conj(psi[2 * v]);
      }
    });
}

void PhaseDiffusion::Relax(const Progress& progress, ComplexVector& psi) const
{
  const Hierarchy hierarchy(this->Matrices, this->Density, LeftOver::Drop);
  CompactVector right(psi.size());
  int done = 0;
  for (const double factor : Kappas)
  {
    const double kappa = factor * this->Density;
    CyclePreconditioner inverse(hierarchy, kappa, {});
    for (int turn = 0; turn < Turns && inverse.IsUsable(); ++turn)
    {
      progress.Report(static_cast<double>(done++) / (Kappas.size() * Turns));
      ComplexVector x = Copied(psi);
      for (int cycle = 0; cycle < CyclesPerTurn; ++cycle)
      {
        ComplexVector residual = Product(this->Matrices.Energy, x);
        if (cycle > 0)
        {
          const ComplexVector way = x - psi;
          Combine(kappa, Product(this->Matrices.Mass, way), 1.0, residual);
        }
        // In single precision squares of small numbers would underflow.
        const double size = Norm(residual);
        if (!(size > 0.0))
        {
          break;
        }
        ForRows(x,
          [&](Index begin, Index end)
          {
            for (Index v = begin; v < end; ++v)
            {
              right[v] = CompactComplex(residual[v] / size);
            }
          });
        const CyclePreconditioner::Result step = inverse.Apply(right);
        ForRows(x,
          [&](Index begin, Index end)
          {
            for (Index v = begin; v < end; ++v)
            {
              x[v] -= size * step(v);
            }
          });
      }
      this->MakeSymmetric(x);
      MakeUnit(x, psi);
      psi.swap(x);
    }
  }
}

std::vector<double> PhaseDiffusion::Phases(const ComplexVector& psi) const
{
  const Index sheets = this->Component.HasTwoSheets ? 2 : 1;
  std::vector<double> phases(this->Component.Nodes());
  ParallelFor(this->Component.Nodes(), VectorPiece,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        const double cycles = std::arg(psi[sheets * v]) / (2.0 * Pi);
        phases[v] = cycles - std::floor(cycles);
      }
    });
  return phases;
}

double Misfit(const WantedPhases& wanted, const std::vector<double>& phases)
{
  using Sums = Eigen::Array2d;
  const TriangleMesh& mesh = wanted.GetMesh();
  const Sums sums = ParallelSum<Sums>(mesh.GetNumberOfEdges(), MediumPiece, Sums::Zero(),
    [&](Index begin, Index end)
    {
      Sums part = Sums::Zero();
      for (Index e = begin; e < end; ++e)
      {
        const Index h = mesh.HalfEdge(e);
        if (wanted.Use(h).HalfEdge != h)
        {
          continue;
        }
        const WantedPhases::Step step = wanted.Along(h);
        const double atEnd = phases[wanted.Node(mesh.Head(h))];
        const double missing =
          (step.Flips ? -atEnd : atEnd) - phases[wanted.Node(mesh.Tail(h))] - step.Increment;
        const double wrapped = missing - std::round(missing);
        part += Sums(wrapped * wrapped, step.Increment * step.Increment);
      }
      return part;
    });
  return sums[1] > 0.0 ? std::sqrt(sums[0] / sums[1]) : 0.0;
}
}
