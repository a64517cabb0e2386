// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Geometry/IntrinsicTriangulation.h"

#include "Support/Threads.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace DirectionFields
{
namespace
{
/// Most flips, in multiples of the edges; a mesh takes one or two at the most.
constexpr std::int64_t MaximumFlips = 50;
/// The triangle inequality must hold in a new triangle by this part of its longest edge.
constexpr double Slack = 1e-12;
class Flipper
{
public:
  explicit Flipper(IntrinsicTriangulation& triangulation)
    : Mesh(triangulation.Mesh)
    , Lengths(triangulation.Lengths)
    , Transport(triangulation.Transport)
    , Length(this->Lengths.SquaredLength.size())
    , Angle(this->Mesh.GetNumberOfHalfEdges())
    , Open(this->Length.size())
    , Queued(this->Length.size(), 0)
    , Touched(this->Mesh.GetNumberOfVertices(), 0)
  {
    ParallelFor(this->Mesh.GetNumberOfEdges(), MediumPiece,
      [this](Index begin, Index end)
      {
        for (Index e = begin; e < end; ++e)
        {
          this->Length[e] = std::sqrt(this->Lengths.SquaredLength[e]);
        }
      });
    ParallelFor(this->Mesh.GetNumberOfHalfEdges(), MediumPiece,
      [this](Index begin, Index end)
      {
        for (Index h = begin; h < end; ++h)
        {
          this->Angle[h] =
            this->Transport.CornerAngle(this->Mesh, h) / this->Transport.Scale[this->Mesh.Tail(h)];
        }
      });
    ParallelFor(this->Mesh.GetNumberOfEdges(), MediumPiece,
      [this](Index begin, Index end)
      {
        for (Index e = begin; e < end; ++e)
        {
          this->Open[e] = this->IsDelaunay(e) ? 0 : 1;
        }
      });
  }

  Index FlipAll()
  {
    const Index edges = this->Mesh.GetNumberOfEdges();
    std::int64_t flips = 0;
    std::vector<Index> stack;
    for (Index first = 0; first < edges && flips < MaximumFlips * edges; ++first)
    {
      if (this->Open[first])
      {
        stack.push_back(first);
      }
      while (!stack.empty())
      {
        const Index edge = stack.back();
        stack.pop_back();
        this->Queued[edge] = 0;
        if (!this->Flip(edge))
        {
          continue;
        }
        if (++flips == MaximumFlips * edges)
        {
          break;
        }
        const Index h = this->Mesh.HalfEdge(edge);
        for (const Index one : { h, this->Mesh.Twin(h) })
        {
          for (const Index side : { TriangleMesh::Next(one), TriangleMesh::Previous(one) })
          {
            const Index other = this->Mesh.Edge(side);
            this->Open[other] = 1;
            // Others are yet to come.
            if (other <= first && !this->Queued[other])
            {
              this->Queued[other] = 1;
              stack.push_back(other);
            }
          }
        }
      }
    }
    return static_cast<Index>(std::min<std::int64_t>(flips, std::numeric_limits<Index>::max()));
  }

  /// Angles in the tangent cones of the vertices whose triangles have changed.
  void UpdateConnection()
  {
    ParallelFor(this->Mesh.GetNumberOfVertices(), MediumPiece,
      [this](Index begin, Index end)
      {
        std::vector<Index> fan;
        for (Index v = begin; v < end; ++v)
        {
          if (this->Touched[v])
          {
            this->UpdateAngles(v, fan);
          }
        }
      });
    this->Transport.Connect(this->Mesh);
  }

private:
  bool IsDelaunay(Index edge) const
  {
    const Index h = this->Mesh.HalfEdge(edge);
    const Index g = this->Mesh.Twin(h);
    // An edge with the same triangle on both sides is Delaunay.
    return g == None || g / 3 == h / 3 ||
      !(this->Angle[TriangleMesh::Previous(h)] + this->Angle[TriangleMesh::Previous(g)] >
        Pi + IntrinsicTriangulation::Tolerance);
  }

  /// Flips an edge unless it is Delaunay.
  bool Flip(Index edge)
  {
    if (this->IsDelaunay(edge))
    {
      return false;
    }
    const Index h = this->Mesh.HalfEdge(edge);
    const Index g = this->Mesh.Twin(h);
    const Index h1 = TriangleMesh::Next(h);
    const Index h2 = TriangleMesh::Previous(h);
    const Index g1 = TriangleMesh::Next(g);
    const Index g2 = TriangleMesh::Previous(g);
    const auto length = [this](Index side) { return this->Length[this->Mesh.Edge(side)]; };
    // Both triangles laid out in the plane, h along the x axis.
    const auto apexX = [base = length(h)](double left, double right)
    { return 0.5 * (base + (left - right) * ((left + right) / base)); };
    const double dx = apexX(length(h2), length(h1)) - apexX(length(g1), length(g2));
    const double dy = 2.0 * (this->Lengths.Area[h / 3] + this->Lengths.Area[g / 3]) / length(h);
    const double squaredLength = dx * dx + dy * dy;
    const double diagonal = std::sqrt(squaredLength);
    const std::array<double, 3> lengthsH = { diagonal, length(h2), length(g1) };
    const std::array<double, 3> lengthsG = { diagonal, length(g2), length(h1) };
    if (!IsTriangle(lengthsH) || !IsTriangle(lengthsG))
    {
      return false;
    }
    const double areaH = TriangleArea(lengthsH);
    const double areaG = TriangleArea(lengthsG);
    const std::array<double, 3> anglesH = TriangleAngles(lengthsH, areaH);
    const std::array<double, 3> anglesG = TriangleAngles(lengthsG, areaG);
    // Rounding must not turn an edge back and forth.
    if (!(anglesH[2] + anglesG[2] < Pi))
    {
      return false;
    }

    for (const Index corner : { h, h2, g, g2 })
    {
      this->Touched[this->Mesh.Tail(corner)] = 1;
    }
    LargeArray<double>& theta = this->Transport.EdgeAngle;
    const double thetaH1 = theta[h1];
    theta[h1] = theta[h2];
    theta[h2] = theta[g1];
    theta[g1] = theta[g2];
    theta[g2] = thetaH1;
    this->Mesh.FlipEdge(edge);
    theta[h] = this->Direction(g1, anglesG[1]);
    theta[g] = this->Direction(h1, anglesH[1]);
    this->Length[edge] = diagonal;
    this->Lengths.SquaredLength[edge] = squaredLength;
    this->Lengths.Area[h / 3] = areaH;
    this->Lengths.Area[g / 3] = areaG;
    const Index corners[] = { h, h1, h2, g, g1, g2 };
    for (int c = 0; c < 3; ++c)
    {
      this->Angle[corners[c]] = anglesH[c];
      this->Angle[corners[3 + c]] = anglesG[c];
    }
    return true;
  }

  static bool IsTriangle(const std::array<double, 3>& length)
  {
    const double longest = std::max({ length[0], length[1], length[2] });
    return length[0] + length[1] + length[2] - 2.0 * longest > Slack * longest;
  }

  /// The angle in the tangent cone of the edge that leaves the tail of a half-edge at an angle to
  /// the left of it.
  double Direction(Index halfEdge, double angle) const
  {
    const Index v = this->Mesh.Tail(halfEdge);
    const double theta = this->Transport.EdgeAngle[halfEdge] + this->Transport.Scale[v] * angle;
    return theta >= 2.0 * Pi && !this->Mesh.IsBoundary(v) ? theta - 2.0 * Pi : theta;
  }

  void UpdateAngles(Index v, std::vector<Index>& fan)
  {
    this->Mesh.GetFan(v, fan);
    double sum = 0.0;
    for (const Index h : fan)
    {
      sum += this->Angle[h];
    }
    const bool boundary = this->Mesh.IsBoundary(v);
    const double scale = boundary ? 1.0 : 2.0 * Pi / sum;
    this->Transport.Scale[v] = scale;
    this->Transport.AngleSum[v] = boundary ? sum : 2.0 * Pi;
    double theta = this->Transport.EdgeAngle[fan.front()];
    for (const Index h : fan)
    {
      this->Transport.EdgeAngle[h] = theta;
      theta += scale * this->Angle[h];
    }
  }

  TriangleMesh& Mesh;
  Metric& Lengths;
  Connection& Transport;
  /// The length of each edge.
  LargeArray<double> Length;
  /// The angle of the corner at the tail of each half-edge, not scaled.
  LargeArray<double> Angle;
  /// Edges that may not be Delaunay.
  LargeArray<char> Open;
  /// Edges on the stack.
  std::vector<char> Queued;
  /// Vertices of flipped triangles.
  std::vector<char> Touched;
};
}

IntrinsicTriangulation::IntrinsicTriangulation(const IntrinsicGeometry& geometry)
  : IntrinsicGeometry(geometry)
{
  Flipper flipper(*this);
  this->NumberOfFlips = flipper.FlipAll();
  if (this->NumberOfFlips > 0)
  {
    flipper.UpdateConnection();
  }
}
}
