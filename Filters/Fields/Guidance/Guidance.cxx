// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Guidance/Guidance.h"

#include "Support/Threads.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
GuidanceScale ScaleOf(const Guidance& guidance)
{
  GuidanceScale scale;
  for (const Vector3& v : guidance.Vectors)
  {
    scale.Longest =
      v.allFinite() ? std::max(scale.Longest, v.lpNorm<Eigen::Infinity>()) : scale.Longest;
  }
  scale.Heaviest = guidance.Weights.empty() ? 1.0 : 0.0;
  for (const double weight : guidance.Weights)
  {
    scale.Heaviest = std::isfinite(weight) ? std::max(scale.Heaviest, weight) : scale.Heaviest;
  }
  return scale;
}

std::vector<Complex> GuidanceSection(
  const SurfaceGeometry& geometry, const Guidance& guidance, int degree)
{
  return GuidanceSection(geometry, guidance, degree, ScaleOf(guidance));
}

std::vector<Complex> GuidanceSection(
  const SurfaceGeometry& geometry, const Guidance& guidance, int degree, const GuidanceScale& scale)
{
  const TriangleMesh& mesh = geometry.Mesh;
  std::vector<Complex> section(mesh.GetNumberOfVertices(), 0.0);
  const double longest = scale.Longest;
  const double heaviest = scale.Heaviest;
  if (longest == 0.0 || heaviest == 0.0)
  {
    return section;
  }
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    const Index point = mesh.Point(v);
    const double given = guidance.Weights.empty() ? 1.0 : guidance.Weights[point];
    const double weight = std::isfinite(given) ? std::max(0.0, given) / heaviest : 0.0;
    const Vector3 vector = guidance.Vectors[point] / longest;
    if (weight > 0.0 && vector.allFinite())
    {
      const Complex z = geometry.Frames.Tangential(v, vector);
      // The tangential part of a normal vector is nothing but rounding.
      if (std::abs(z) > 1e-9 * vector.norm())
      {
        section[v] = std::polar(weight * std::abs(z), degree * std::arg(z));
      }
    }
  }
  return section;
}

std::vector<double> GuidanceStrengths(const TriangleMesh& mesh, const Guidance& guidance)
{
  std::vector<double> strengths;
  if (!guidance.Strengths.empty())
  {
    strengths.reserve(mesh.GetNumberOfVertices());
    for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      const double strength = guidance.Strengths[mesh.Point(v)];
      strengths.push_back(std::isfinite(strength) ? std::clamp(strength, 0.0, 1.0) : 0.0);
    }
  }
  const bool isSoft =
    std::any_of(strengths.begin(), strengths.end(), [](double strength) { return strength < 1.0; });
  return isSoft ? strengths : std::vector<double>();
}

Complex CurvatureValue(
  const Curvature& curvature, Index vertex, int degree, CurvatureDirection direction)
{
  const Complex& q = curvature.Hopf[vertex];
  if (degree == 4)
  {
    const double size = std::abs(q);
    return size > 0.0 ? q * (q / size) : Complex(0.0);
  }
  if (direction == CurvatureDirection::Maximum || direction == CurvatureDirection::Minimum)
  {
    return direction == CurvatureDirection::Maximum ? q : -q;
  }
  // With k = H +- |q|, half of |k_max| - |k_min| is H, but no more than |q| and no less than -|q|.
  const double size = std::abs(q);
  const double mean = curvature.Mean[vertex];
  const Complex most = std::abs(mean) < size ? q * (mean / size) : std::copysign(1.0, mean) * q;
  return direction == CurvatureDirection::MostBent ? most : -most;
}

bool DependsOnSide(int degree, CurvatureDirection direction)
{
  return degree == 2 &&
    (direction == CurvatureDirection::Maximum || direction == CurvatureDirection::Minimum);
}

std::vector<Complex> CurvatureSection(
  const Curvature& curvature, int degree, CurvatureDirection direction)
{
  std::vector<Complex> section(curvature.Hopf.size());
  ParallelFor(static_cast<Index>(section.size()), LightPiece,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        section[v] = CurvatureValue(curvature, v, degree, direction);
      }
    });
  return section;
}

namespace
{
/// The vertices that a section is continued to, from near to far.
class Continuation
{
public:
  Continuation(const SurfaceGeometry& geometry, const PieceOfSurface& piece,
    const std::vector<Complex>& section)
    : Geometry(geometry)
    , Piece(piece)
    , State(section.size(), Unknown)
  {
    const auto vertices = static_cast<Index>(section.size());
    for (Index v = 0; v < vertices; ++v)
    {
      this->State[v] = section[v] != 0.0 ? Known : Unknown;
    }
    this->Piece.Complete(this->State);
    for (Index v = 0; v < vertices; ++v)
    {
      if (!this->Piece.IsOwned(v) && this->State[v] != Known)
      {
        this->Others.push_back(v);
      }
      bool isNext = false;
      if (this->Piece.IsOwned(v) && this->State[v] == Unknown)
      {
        this->ForEachNeighbour(
          v, [&](Index j, double) { isNext = isNext || this->State[j] == Known; });
      }
      if (isNext)
      {
        this->Front.push_back(v);
      }
    }
  }

  const std::vector<Index>& GetFront() const { return this->Front; }

  template <typename Body>
  void ForEachKnown(Index v, const Body& body)
  {
    this->ForEachNeighbour(v,
      [&](Index j, double rotation)
      {
        if (this->State[j] == Known)
        {
          body(j, rotation);
        }
      });
  }

  /// Goes on from the front, whose vertices are known from now on.
  void Advance()
  {
    std::vector<Index> reached;
    reached.swap(this->Front);
    for (const Index v : reached)
    {
      this->State[v] = Known;
    }
    this->Piece.Complete(this->State);
    const auto isUnknown = [&](Index v) { return this->State[v] != Known; };
    const auto known = std::partition(this->Others.begin(), this->Others.end(), isUnknown);
    reached.insert(reached.end(), known, this->Others.end());
    this->Others.erase(known, this->Others.end());
    for (const Index v : reached)
    {
      this->ForEachNeighbour(v,
        [&](Index j, double)
        {
          if (this->State[j] == Unknown && this->Piece.IsOwned(j))
          {
            this->State[j] = Queued;
            this->Front.push_back(j);
          }
        });
    }
  }

private:
  static constexpr char Unknown = 0;
  static constexpr char Known = 1;
  static constexpr char Queued = 2;

  /// Calls body(neighbour, rotation from there).
  template <typename Body>
  void ForEachNeighbour(Index v, const Body& body)
  {
    const TriangleMesh& mesh = this->Geometry.Mesh;
    mesh.GetFan(v, this->Fan);
    for (const Index h : this->Fan)
    {
      body(mesh.Head(h), -this->Geometry.Transport.RotationAlong(mesh, h));
    }
    if (mesh.IsBoundary(v))
    {
      const Index incoming = TriangleMesh::Previous(this->Fan.back());
      body(mesh.Tail(incoming), this->Geometry.Transport.RotationAlong(mesh, incoming));
    }
  }

  const SurfaceGeometry& Geometry;
  const PieceOfSurface& Piece;
  std::vector<char> State;
  std::vector<Index> Front;
  /// Vertices of other pieces that are not known yet.
  std::vector<Index> Others;
  std::vector<Index> Fan;
};
}

void Continue(const SurfaceGeometry& geometry, int degree, std::vector<Complex>& section,
  const PieceOfSurface& piece)
{
  constexpr double decay = 0.1;
  // Weights below this are not reduced further, lest they be rounded to zero.
  constexpr double least = 1e-100;
  piece.Complete(section);
  Continuation continuation(geometry, piece, section);
  std::vector<Complex> values;
  while (piece.Any(!continuation.GetFront().empty()))
  {
    const std::vector<Index>& front = continuation.GetFront();
    values.assign(front.size(), 0.0);
    for (std::size_t k = 0; k < front.size(); ++k)
    {
      double known = 0.0;
      continuation.ForEachKnown(front[k],
        [&](Index j, double rotation)
        {
          values[k] += section[j] * std::polar(1.0, degree * rotation);
          known += 1.0;
        });
      values[k] *= (std::abs(values[k]) > least ? decay : 1.0) / known;
    }
    for (std::size_t k = 0; k < front.size(); ++k)
    {
      section[front[k]] = values[k];
    }
    piece.Complete(section);
    continuation.Advance();
  }
}

void ClearCovers(const TriangleMesh& mesh, std::vector<Complex>& section)
{
  for (const TriangleMesh::Component& component : mesh.GetComponents())
  {
    if (component.IsCover)
    {
      std::fill(
        section.begin() + component.FirstVertex, section.begin() + component.EndVertex, 0.0);
    }
  }
}

Guidance Merged(Guidance guidance, const std::vector<Index>& first)
{
  const auto counts = [&guidance](std::size_t i)
  {
    return guidance.Vectors[i].allFinite() && !guidance.Vectors[i].isZero() &&
      (guidance.Weights.empty() || guidance.Weights[i] > 0.0);
  };
  for (std::size_t i = 0; i < guidance.Vectors.size() && i < first.size(); ++i)
  {
    const auto target = static_cast<std::size_t>(first[i]);
    if (target != i && counts(i) && !counts(target))
    {
      guidance.Vectors[target] = guidance.Vectors[i];
      if (!guidance.Weights.empty())
      {
        guidance.Weights[target] = guidance.Weights[i];
      }
      if (!guidance.Strengths.empty())
      {
        guidance.Strengths[target] = guidance.Strengths[i];
      }
    }
  }
  return guidance;
}
}
