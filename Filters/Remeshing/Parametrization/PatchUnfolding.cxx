// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Parametrization/PatchUnfolding.h"

#include "Parametrization/TriangleDistortion.h"

#include <Eigen/LU>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <unordered_map>

namespace DirectionFields::Internal
{
namespace
{
constexpr int MostSteps = 40;
/// Once nothing is flipped, so many steps more make triangles less flat.
constexpr int StepsBeyond = 3;
/// The deepest fold has to become half as deep within so many steps.
constexpr std::size_t Patience = 20;
/// A step by which neither that nor the energy becomes less by this part is the last one.
constexpr double LeastProgress = 0.01;
/// Triangles with less than this part of their area count as flipped, since places are rounded.
constexpr double LeastArea = 1e-6;
/// The epsilon of the distortion: this part of the deepest fold, and at least the other.
constexpr double OfDeepest = 0.2;
constexpr double LeastEpsilon = 1e-6;
/// That of triangles that must not be flipped on the way.
constexpr double NoEpsilon = 1e-9;
/// Triangles in space are as high as this part of their longest edge, at least: others have no
/// inverse.
constexpr double LeastHeight = 1e-2;
constexpr double Regularization = 1e-8;
constexpr double ShortestStep = 1e-6;
/// Of the decrease that the slope lets expect.
constexpr double LeastDecrease = 1e-4;

using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, Index>;

/// One triangle of a patch, as a function of the coordinates by which its corners move.
class Piece
{
public:
  /// @param slots of the first coordinates of vertices
  Piece(const MovablePlaces& places, Index t, const std::unordered_map<Index, Index>& slots)
  {
    const Triangle& vertex = places.Mesh.Triangles[t].Vertex;
    double size = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      const auto slot = slots.find(vertex[c]);
      this->Slot[c] = slot != slots.end() ? slot->second : None;
      this->Freedom[c] = slot != slots.end() ? places.GetFreedom(vertex[c]) : 0;
      this->Direction[c] =
        places.Plane.Root(places.FromVertex(t, c).Turn) * places.GetDirection(vertex[c]);
      this->Start[c] = places.Corner(t, c);
      size += places.PerLength[vertex[c]] / 3.0;
    }
    const auto edge = [&](int from, int to) -> Vector3
    { return size * (places.Mesh.Positions[vertex[to]] - places.Mesh.Positions[vertex[from]]); };
    const Vector3 a = edge(0, 1);
    const Vector3 b = edge(0, 2);
    const double longest = std::max({ a.norm(), b.norm(), edge(1, 2).norm() });
    const double base = std::max(a.norm(), LeastHeight * longest);
    const double height = std::max(a.cross(b).norm() / base, LeastHeight * longest);
    Eigen::Matrix2d shape;
    shape << base, a.dot(b) / base, 0.0, height;
    this->Inverse = shape.inverse();
    this->Area = 0.5 * base * height;
    this->MustStay = places.IsInTriangle(vertex[0]) && this->DeterminantAt({}) > 0.0;
  }

  TriangleDistortion::Derivative DerivativeAt(const Eigen::VectorXd& x) const
  {
    std::array<Complex, 3> p = this->Start;
    for (int c = 0; c < 3; ++c)
    {
      for (int i = 0; i < this->Freedom[c] && x.size() > 0; ++i)
      {
        p[c] += this->DirectionOf(c, i) * x[this->Slot[c] + i];
      }
    }
    const Complex u = p[1] - p[0];
    const Complex v = p[2] - p[0];
    return { u.real() * this->Inverse(0, 0) + v.real() * this->Inverse(1, 0),
      u.real() * this->Inverse(0, 1) + v.real() * this->Inverse(1, 1),
      u.imag() * this->Inverse(0, 0) + v.imag() * this->Inverse(1, 0),
      u.imag() * this->Inverse(0, 1) + v.imag() * this->Inverse(1, 1) };
  }
  double DeterminantAt(const Eigen::VectorXd& x) const
  {
    return TriangleDistortion::Determinant(this->DerivativeAt(x));
  }
  TriangleDistortion DistortionAt(const Eigen::VectorXd& x, double epsilon) const
  {
    return { this->DerivativeAt(x), this->MustStay ? NoEpsilon : epsilon };
  }
  double GetArea() const { return this->Area; }

  /// Adds its part of the derivatives of the energy.
  void AddTo(Eigen::VectorXd& gradient, std::vector<Eigen::Triplet<double, Index>>& hessian,
    const TriangleDistortion& distortion) const
  {
    // Of the derivative of the map by each coordinate.
    std::vector<Index> slot;
    Eigen::Matrix<double, 4, 6> by;
    for (int c = 0; c < 3; ++c)
    {
      const Eigen::Vector2d weight = c == 0
        ? Eigen::Vector2d(-(this->Inverse.row(0) + this->Inverse.row(1)).transpose())
        : Eigen::Vector2d(this->Inverse.row(c - 1).transpose());
      for (int i = 0; i < this->Freedom[c]; ++i)
      {
        const Complex d = this->DirectionOf(c, i);
        by.col(static_cast<Index>(slot.size())) << d.real() * weight, d.imag() * weight;
        slot.push_back(this->Slot[c] + i);
      }
    }
    for (std::size_t i = 0; i < slot.size(); ++i)
    {
      const auto column = by.col(static_cast<Index>(i));
      gradient[slot[i]] += this->Area * column.dot(distortion.Gradient);
      const TriangleDistortion::Derivative image = this->Area * (distortion.Hessian * column);
      for (std::size_t j = 0; j < slot.size(); ++j)
      {
        hessian.emplace_back(slot[j], slot[i], by.col(static_cast<Index>(j)).dot(image));
      }
    }
  }

private:
  Complex DirectionOf(int c, int i) const
  {
    return i == 0 ? this->Direction[c] : this->Direction[c] * Complex(0.0, 1.0);
  }

  std::array<Index, 3> Slot;
  std::array<int, 3> Freedom;
  /// Of the corners in the chart of the triangle.
  std::array<Complex, 3> Direction;
  std::array<Complex, 3> Start;
  Eigen::Matrix2d Inverse;
  double Area;
  bool MustStay;
};

/// Whether a triangle has no area wherever its vertices move: it has none, or two corners in the same
/// place, that cannot move.
bool IsHopeless(const MovablePlaces& places, Index t)
{
  std::vector<Complex> fixed;
  for (int c = 0; c < 3; ++c)
  {
    if (places.GetFreedom(places.Mesh.Triangles[t].Vertex[c]) == 0)
    {
      fixed.push_back(places.Corner(t, c));
    }
  }
  return fixed.size() == 3 || (fixed.size() == 2 && fixed[0] == fixed[1]);
}

/// The energy of a patch and its minimization.
class PatchEnergy
{
public:
  PatchEnergy(const MovablePlaces& places, const std::vector<Index>& vertices,
    const std::vector<Index>& triangles)
  {
    for (const Index v : vertices)
    {
      if (places.GetFreedom(v) > 0)
      {
        this->Slots.emplace(v, this->Count);
        this->Count += places.GetFreedom(v);
      }
    }
    for (const Index t : triangles)
    {
      if (!IsHopeless(places, t))
      {
        this->Pieces.emplace_back(places, t, this->Slots);
      }
    }
    this->X = Eigen::VectorXd::Zero(this->Count);
  }

  void Minimize()
  {
    std::vector<double> depths;
    int beyond = 0;
    for (int k = 0; k<MostSteps&& this->Count> 0; ++k)
    {
      depths.push_back(std::max(0.0, LeastArea - this->LeastDeterminant()));
      beyond += depths.back() > 0.0 ? 0 : 1;
      if (this->IsStuck(depths) || beyond > StepsBeyond ||
        !this->Step(std::max(LeastEpsilon, OfDeepest * depths.back())))
      {
        return;
      }
    }
  }

  void MoveIn(MovablePlaces& places) const
  {
    for (const auto& [v, slot] : this->Slots)
    {
      places.Move(v, this->X[slot], places.GetFreedom(v) == 2 ? this->X[slot + 1] : 0.0);
    }
  }

private:
  /// Whether the deepest fold becomes hardly less deep.
  bool IsStuck(const std::vector<double>& depths) const
  {
    const std::size_t count = depths.size();
    const bool isSlow = count > Patience && depths.back() > 0.5 * depths[count - 1 - Patience];
    const bool stays = count > 1 && this->Decrease < LeastProgress &&
      depths.back() > (1.0 - LeastProgress) * depths[count - 2];
    return depths.back() > 0.0 && (isSlow || stays);
  }

  double LeastDeterminant() const
  {
    double least = std::numeric_limits<double>::infinity();
    for (const Piece& piece : this->Pieces)
    {
      least = std::min(least, piece.DeterminantAt(this->X));
    }
    return least;
  }

  double ValueAt(const Eigen::VectorXd& x, double epsilon) const
  {
    double sum = 0.0;
    for (const Piece& piece : this->Pieces)
    {
      sum += piece.GetArea() * piece.DistortionAt(x, epsilon).Value;
    }
    return sum;
  }

  /// Returns whether there was a better place.
  bool Step(double epsilon)
  {
    std::vector<Eigen::Triplet<double, Index>> entries;
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(this->Count);
    double value = 0.0;
    for (const Piece& piece : this->Pieces)
    {
      TriangleDistortion distortion = piece.DistortionAt(this->X, epsilon);
      value += piece.GetArea() * distortion.Value;
      distortion.Convexify();
      piece.AddTo(gradient, entries, distortion);
    }
    // Vertices stay whose triangles are all hopeless.
    double diagonal = 0.0;
    for (const auto& entry : entries)
    {
      diagonal += entry.row() == entry.col() ? entry.value() / this->Count : 0.0;
    }
    for (Index i = 0; i < this->Count; ++i)
    {
      entries.emplace_back(i, i, Regularization * diagonal);
    }
    Matrix hessian(this->Count, this->Count);
    hessian.setFromTriplets(entries.begin(), entries.end());
    if (!this->Solver)
    {
      this->Solver.emplace();
      this->Solver->analyzePattern(hessian);
    }
    this->Solver->factorize(hessian);
    if (this->Solver->info() != Eigen::Success)
    {
      return false;
    }
    const Eigen::VectorXd step = -this->Solver->solve(gradient);
    const double slope = gradient.dot(step);
    for (double factor = 1.0; factor > ShortestStep; factor *= 0.5)
    {
      const Eigen::VectorXd next = this->X + factor * step;
      const double nextValue = this->ValueAt(next, epsilon);
      if (nextValue <= value + LeastDecrease * factor * slope)
      {
        this->Decrease = (value - nextValue) / value;
        this->X = next;
        return true;
      }
    }
    return false;
  }

  std::unordered_map<Index, Index> Slots;
  Index Count = 0;
  std::vector<Piece> Pieces;
  Eigen::VectorXd X;
  /// Of the energy by the last step, as a part of it.
  double Decrease = 1.0;
  std::optional<Eigen::SimplicialLDLT<Matrix>> Solver;
};
}

void UnfoldPatch(
  MovablePlaces& places, const std::vector<Index>& vertices, const std::vector<Index>& triangles)
{
  PatchEnergy energy(places, vertices, triangles);
  energy.Minimize();
  energy.MoveIn(places);
}
}
