// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Unfolding/PatchUnfolding.h"

#include "Unfolding/TriangleDistortion.h"

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
/// Places are rounded: a triangle counts as flipped where it is less than so many units of the
/// grid's numbers high, but not for that with more than a part of its area.
constexpr double LeastHeightInUnits = 8.0;
constexpr double MostLeastArea = 1e-2;
/// The epsilon of the distortion: this part of the deepest fold, and at least the other.
constexpr double OfDeepest = 0.2;
constexpr double LeastEpsilon = 1e-6;
/// Triangles in space count as long as this in edges of the grid and as high as this part of their
/// longest edge, at least, since others have no inverse.
constexpr double LeastLength = 1e-4;
constexpr double LeastHeight = 1e-2;
/// Added to each second derivative, relative to it: made positive they may be singular.
constexpr double Regularization = 1e-8;
/// A step is halved until the sum becomes less by this part of what its slope promises, or it is
/// shorter than this part of Newton's.
constexpr double LeastDecrease = 1e-4;
constexpr double ShortestStep = 1e-6;
/// Patches of more coordinates are left: there the map is folded all over.
constexpr Index MostCoordinates = 20000;

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
    const double longest = std::max({ LeastLength, a.norm(), b.norm(), edge(1, 2).norm() });
    const double base = std::max(a.norm(), LeastHeight * longest);
    const double height = std::max(a.cross(b).norm() / base, LeastHeight * longest);
    Eigen::Matrix2d shape;
    shape << base, a.dot(b) / base, 0.0, height;
    this->Inverse = shape.inverse();
    this->Area = 0.5 * base * height;
    this->LeastArea =
      std::min(MostLeastArea, LeastHeightInUnits / IntegerGrid::Unit * longest / (base * height));
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
  /// How much of its area is flipped, or lacks to the least; negative otherwise.
  double FoldAt(const Eigen::VectorXd& x) const { return -this->DeterminantAt(x); }
  double LackAt(const Eigen::VectorXd& x) const { return this->LeastArea + this->FoldAt(x); }
  /// Infinite where it must not go.
  double ValueAt(const Eigen::VectorXd& x, double epsilon) const
  {
    const TriangleDistortion::Derivative j = this->DerivativeAt(x);
    return this->MustStay && !(TriangleDistortion::Determinant(j) > 0.0)
      ? std::numeric_limits<double>::infinity()
      : this->Area * TriangleDistortion::ValueOf(j, this->MustStay ? 0.0 : epsilon);
  }

  /// Calls visit with the row and the column of each of its second derivatives that are not above
  /// the diagonal.
  template <typename Visit>
  void VisitEntries(const Visit& visit) const
  {
    const Coordinates of = this->GetCoordinates();
    for (int i = 0; i < of.Count; ++i)
    {
      for (int j = 0; j < of.Count; ++j)
      {
        if (of.Slot[j] >= of.Slot[i])
        {
          visit(of.Slot[j], of.Slot[i]);
        }
      }
    }
  }

  /// Adds its part of the derivatives of the sum.
  /// @param entry where among the values each of the second derivatives is, in their order
  void AddTo(const Eigen::VectorXd& x, double epsilon, Eigen::VectorXd& gradient, double* values,
    const Index* entry) const
  {
    TriangleDistortion distortion(this->DerivativeAt(x), this->MustStay ? 0.0 : epsilon);
    distortion.Convexify();
    // The derivatives of the map's derivative by each coordinate.
    const Coordinates of = this->GetCoordinates();
    int count = 0;
    Eigen::Matrix<double, 4, 6> by;
    for (int c = 0; c < 3; ++c)
    {
      const Eigen::Vector2d weight = c == 0
        ? Eigen::Vector2d(-(this->Inverse.row(0) + this->Inverse.row(1)).transpose())
        : Eigen::Vector2d(this->Inverse.row(c - 1).transpose());
      for (int i = 0; i < this->Freedom[c]; ++i)
      {
        const Complex d = this->DirectionOf(c, i);
        by.col(count++) << d.real() * weight, d.imag() * weight;
      }
    }
    for (int i = 0; i < of.Count; ++i)
    {
      const auto column = by.col(i);
      gradient[of.Slot[i]] += this->Area * column.dot(distortion.Gradient);
      const TriangleDistortion::Derivative image = this->Area * (distortion.Hessian * column);
      for (int j = 0; j < of.Count; ++j)
      {
        if (of.Slot[j] >= of.Slot[i])
        {
          values[*entry++] += by.col(j).dot(image);
        }
      }
    }
  }

private:
  /// The coordinates that it depends on.
  struct Coordinates
  {
    std::array<Index, 6> Slot;
    int Count = 0;
  };
  Coordinates GetCoordinates() const
  {
    Coordinates of;
    for (int c = 0; c < 3; ++c)
    {
      for (int i = 0; i < this->Freedom[c]; ++i)
      {
        of.Slot[of.Count++] = this->Slot[c] + i;
      }
    }
    return of;
  }

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
  double LeastArea;
  /// Whether no step may flip it.
  bool MustStay;
};

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
      if (!places.StaysFlat(t))
      {
        this->Pieces.emplace_back(places, t, this->Slots);
      }
    }
    this->X = Eigen::VectorXd::Zero(this->Count);
  }

  Index GetNumberOfCoordinates() const { return this->Count; }

  void Minimize(const Progress& progress)
  {
    std::vector<double> depths;
    int beyond = 0;
    for (int k = 0; k < MostSteps; ++k)
    {
      progress.RequireToGoOn();
      depths.push_back(this->Deepest(&Piece::LackAt));
      beyond += depths.back() > 0.0 ? 0 : 1;
      if (this->IsStuck(depths) || beyond > StepsBeyond ||
        !this->Step(std::max(LeastEpsilon, OfDeepest * this->Deepest(&Piece::FoldAt))))
      {
        return;
      }
    }
  }

  void MoveIn(MovablePlaces& places) const
  {
    if (!(this->X.array().abs() < IntegerGrid::Range).all())
    {
      return;
    }
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

  /// The largest of a figure of the triangles, at least 0.
  double Deepest(double (Piece::*figure)(const Eigen::VectorXd&) const) const
  {
    double deepest = 0.0;
    for (const Piece& piece : this->Pieces)
    {
      deepest = std::max(deepest, (piece.*figure)(this->X));
    }
    return deepest;
  }

  double ValueAt(const Eigen::VectorXd& x, double epsilon) const
  {
    double sum = 0.0;
    for (const Piece& piece : this->Pieces)
    {
      sum += piece.ValueAt(x, epsilon);
    }
    return sum;
  }

  /// Finds which of the second derivatives there are, and where among the values each triangle's
  /// are: they stay the same from step to step.
  void FindPattern()
  {
    std::vector<Eigen::Triplet<double, Index>> entries;
    const auto add = [&](Index row, Index column) { entries.emplace_back(row, column, 0.0); };
    for (const Piece& piece : this->Pieces)
    {
      piece.VisitEntries(add);
    }
    for (Index i = 0; i < this->Count; ++i)
    {
      add(i, i);
    }
    this->Hessian.resize(this->Count, this->Count);
    this->Hessian.setFromTriplets(entries.begin(), entries.end());
    const Index* begin = this->Hessian.outerIndexPtr();
    const Index* rows = this->Hessian.innerIndexPtr();
    for (const Piece& piece : this->Pieces)
    {
      this->FirstEntry.push_back(static_cast<Index>(this->Entries.size()));
      piece.VisitEntries(
        [&](Index row, Index column)
        {
          const Index* last = rows + begin[column + 1];
          this->Entries.push_back(
            static_cast<Index>(std::lower_bound(rows + begin[column], last, row) - rows));
        });
    }
  }

  /// Computes the second derivatives, those that are not above the diagonal, and the gradient.
  void Differentiate(double epsilon, Eigen::VectorXd& gradient)
  {
    double* values = this->Hessian.valuePtr();
    std::fill(values, values + this->Hessian.nonZeros(), 0.0);
    for (std::size_t k = 0; k < this->Pieces.size(); ++k)
    {
      this->Pieces[k].AddTo(
        this->X, epsilon, gradient, values, this->Entries.data() + this->FirstEntry[k]);
    }
    for (Index i = 0; i < this->Count; ++i)
    {
      // Vertices stay all of whose triangles stay flat.
      double& diagonal = values[this->Hessian.outerIndexPtr()[i]];
      diagonal += diagonal > 0.0 ? Regularization * diagonal : 1.0;
    }
  }

  /// Returns whether there was a better place.
  bool Step(double epsilon)
  {
    const double value = this->ValueAt(this->X, epsilon);
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(this->Count);
    if (!this->Solver)
    {
      this->FindPattern();
      this->Solver.emplace();
      this->Solver->analyzePattern(this->Hessian);
    }
    this->Differentiate(epsilon, gradient);
    this->Solver->factorize(this->Hessian);
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
  /// By which part the last step made the sum less.
  double Decrease = 1.0;
  Matrix Hessian;
  /// Where among its values the entries of each triangle are, in the order of Piece::VisitEntries,
  /// and the first one of each.
  std::vector<Index> Entries;
  std::vector<Index> FirstEntry;
  std::optional<Eigen::SimplicialLDLT<Matrix>> Solver;
};
}

void UnfoldPatch(MovablePlaces& places, const std::vector<Index>& vertices,
  const std::vector<Index>& triangles, const Progress& progress)
{
  PatchEnergy energy(places, vertices, triangles);
  if (energy.GetNumberOfCoordinates() > 0 && energy.GetNumberOfCoordinates() <= MostCoordinates)
  {
    energy.Minimize(progress);
    energy.MoveIn(places);
  }
}
}
