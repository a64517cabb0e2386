// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Curvature/ShapeFit.h"

#include "Support/Threads.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// Neighbours of neighbours are gathered around vertices of fewer edges than this only: the others
/// are tips of needles, which would be gathered for each vertex of the rim.
constexpr int MostEdges = 100;
/// 1, x, y, x^2 / 2, x y, y^2 / 2.
constexpr int Terms = 6;
/// Points whose part in the tangent plane is a smaller part of their squared distance are left out.
constexpr double LeastTangential = 0.1;
/// The smallest pivot of the normal equations, whose diagonal is of the order of the number of
/// points.
constexpr double SmallestPivot = 1e-4;

/// Symmetric positive definite equations for the coefficients of the quadric.
class NormalEquations
{
public:
  void Add(double x, double y, double z)
  {
    const std::array<double, Terms> term = { 1.0, x, y, 0.5 * x * x, x * y, 0.5 * y * y };
    for (int i = 0; i < Terms; ++i)
    {
      for (int j = 0; j <= i; ++j)
      {
        this->Lower[i][j] += term[i] * term[j];
      }
      this->Right[i] += term[i] * z;
    }
  }

  /// Replaces the matrix by its Cholesky factor; false where it is nearly singular.
  bool Factorize()
  {
    for (int i = 0; i < Terms; ++i)
    {
      for (int j = 0; j < i; ++j)
      {
        double sum = this->Lower[i][j];
        for (int k = 0; k < j; ++k)
        {
          sum -= this->Lower[i][k] * this->Lower[j][k];
        }
        this->Lower[i][j] = sum * this->Inverse[j];
      }
      double pivot = this->Lower[i][i];
      for (int k = 0; k < i; ++k)
      {
        pivot -= this->Lower[i][k] * this->Lower[i][k];
      }
      if (!(pivot > SmallestPivot))
      {
        return false;
      }
      this->Inverse[i] = 1.0 / std::sqrt(pivot);
    }
    return true;
  }

  /// The second derivatives xx, xy and yy, and the sum of the variances of (xx - yy) / 2 and xy.
  std::array<double, 4> SecondDerivatives() const
  {
    std::array<double, Terms> c = this->Right;
    for (int i = 0; i < Terms; ++i)
    {
      for (int k = 0; k < i; ++k)
      {
        c[i] -= this->Lower[i][k] * c[k];
      }
      c[i] *= this->Inverse[i];
    }
    // The last three unknowns depend on the last rows of the factor only: so do their variances,
    // which are the squared lengths of L^-1 e.
    const double xyy = this->Lower[5][4];
    const double xxy = this->Lower[4][3];
    const double xxyy = this->Lower[5][3];
    const double yy = c[5] * this->Inverse[5];
    const double xy = (c[4] - xyy * yy) * this->Inverse[4];
    const double xx = (c[3] - xxy * xy - xxyy * yy) * this->Inverse[3];
    const double a = 0.5 * this->Inverse[3];
    const double b = -xxy * a * this->Inverse[4];
    const double d = (-0.5 - xxyy * a - xyy * b) * this->Inverse[5];
    const double e = this->Inverse[4];
    const double f = -xyy * e * this->Inverse[5];
    return { xx, xy, yy, a * a + b * b + d * d + e * e + f * f };
  }

private:
  std::array<std::array<double, Terms>, Terms> Lower = {};
  std::array<double, Terms> Inverse = {};
  std::array<double, Terms> Right = {};
};

/// The points around a vertex.
class Neighbourhood
{
public:
  Neighbourhood(const SurfaceGeometry& geometry, const Creases& creases)
    : Geometry(geometry)
    , Bent(creases)
  {
  }

  /// The neighbours of a vertex and the corners beyond the triangles around it. Those that are both
  /// count twice.
  void Gather(Index v)
  {
    const TriangleMesh& mesh = this->Geometry.Mesh;
    this->Near.clear();
    const Index first = mesh.Outgoing(v);
    Index h = first;
    Index last = first;
    do
    {
      this->Near.push_back(mesh.Head(h));
      const Index across = TriangleMesh::Next(h);
      const Index beyond = mesh.Twin(across);
      if (beyond != None && this->Bent.Edge[mesh.Edge(across)] == 0)
      {
        this->Near.push_back(mesh.Tail(TriangleMesh::Previous(beyond)));
      }
      last = h;
      h = mesh.NextOutgoing(h);
    } while (h != None && h != first);
    if (h == None)
    {
      this->Near.push_back(mesh.Tail(TriangleMesh::Previous(last)));
    }
  }

  /// Whether a vertex has too many edges for its neighbours' neighbours to be gathered.
  bool IsTipOfNeedles(Index v) const
  {
    const Index first = this->Geometry.Mesh.Outgoing(v);
    Index h = first;
    int edges = 0;
    do
    {
      ++edges;
      h = this->Geometry.Mesh.NextOutgoing(h);
    } while (h != None && h != first && edges < MostEdges);
    return edges == MostEdges;
  }

  /// The neighbours of a vertex that is no tip of needles, and those of its neighbours that are
  /// none either. A neighbour on a crease has some beyond it.
  void GatherMore(Index v)
  {
    this->Near.clear();
    this->AddRing(v, v);
    const std::size_t ring = this->Near.size();
    for (std::size_t k = 0; k < ring; ++k)
    {
      if (this->Bent.Vertex[this->Near[k]] == 0 && !this->IsTipOfNeedles(this->Near[k]))
      {
        this->AddRing(this->Near[k], v);
      }
    }
  }

  /// The quadric through the gathered points.
  Shape Fit(Index v, double unit) const
  {
    const Vector3& origin = this->Geometry.Positions[v];
    const Vector3& normal = this->Geometry.Frames.Normal[v];
    const Vector3& xAxis = this->Geometry.Frames.X[v];
    const Vector3 yAxis = this->Geometry.Frames.Y(v);
    double squares = 0.0;
    for (const Index j : this->Near)
    {
      squares += ((this->Geometry.Positions[j] - origin) / unit).squaredNorm();
    }
    // Distances are divided by their mean square, so that all pivots are of one order.
    const double inverse = std::sqrt(static_cast<double>(this->Near.size()) / squares);
    const double scale = inverse / unit;
    NormalEquations equations;
    equations.Add(0.0, 0.0, 0.0);
    for (const Index j : this->Near)
    {
      const Vector3 p = (this->Geometry.Positions[j] - origin) * scale;
      const double x = p.dot(xAxis);
      const double y = p.dot(yAxis);
      const double z = p.dot(normal);
      const double tangential = x * x + y * y;
      const double square = tangential + z * z;
      if (tangential > LeastTangential * square)
      {
        const double stretch = std::sqrt(square / tangential);
        equations.Add(stretch * x, stretch * y, z);
      }
    }
    Shape shape;
    if (std::isfinite(scale) && equations.Factorize())
    {
      const std::array<double, 4> second = equations.SecondDerivatives();
      shape.Hopf = Complex(-0.5 * (second[0] - second[2]) * inverse, -second[1] * inverse);
      shape.Mean = -0.5 * (second[0] + second[2]) * inverse;
      const double square = inverse * inverse;
      shape.Variance = second[3] * square * square;
    }
    return shape;
  }

private:
  void AddRing(Index v, Index middle)
  {
    const TriangleMesh& mesh = this->Geometry.Mesh;
    const auto add = [&](Index j)
    {
      if (j != middle && std::find(this->Near.begin(), this->Near.end(), j) == this->Near.end())
      {
        this->Near.push_back(j);
      }
    };
    mesh.GetFan(v, this->Fan);
    for (const Index h : this->Fan)
    {
      add(mesh.Head(h));
    }
    if (mesh.IsBoundary(v))
    {
      add(mesh.Tail(TriangleMesh::Previous(this->Fan.back())));
    }
  }

  const SurfaceGeometry& Geometry;
  const Creases& Bent;
  std::vector<Index> Near;
  std::vector<Index> Fan;
};

/// Fits the shapes of the vertices for which a statement holds.
template <typename Statement>
void Fit(const SurfaceGeometry& geometry, const Creases& creases, const Statement& isWanted,
  std::vector<Shape>& shapes)
{
  const TriangleMesh& mesh = geometry.Mesh;
  mesh.ForEachComponent(
    [&](Index c)
    {
      const TriangleMesh::Component& component = mesh.GetComponents()[c];
      ParallelFor(component.Vertices(), HeavyPiece,
        [&](Index begin, Index end)
        {
          Neighbourhood neighbourhood(geometry, creases);
          for (Index v = component.FirstVertex + begin; v < component.FirstVertex + end; ++v)
          {
            if (creases.Vertex[v] != 0 || !isWanted(v))
            {
              continue;
            }
            neighbourhood.Gather(v);
            shapes[v] = neighbourhood.Fit(v, geometry.Lengths.Unit[c]);
            if (!shapes[v].IsFitted() && !neighbourhood.IsTipOfNeedles(v))
            {
              neighbourhood.GatherMore(v);
              shapes[v] = neighbourhood.Fit(v, geometry.Lengths.Unit[c]);
            }
          }
        });
    });
}
}

std::vector<Shape> FitShapes(const SurfaceGeometry& geometry, const Creases& creases)
{
  std::vector<Shape> shapes(geometry.Mesh.GetNumberOfVertices());
  Fit(
    geometry, creases, [](Index) { return true; }, shapes);
  return shapes;
}

void FitShapesAgain(const SurfaceGeometry& geometry, const Creases& creases,
  const std::vector<char>& wereOnCreases, std::vector<Shape>& shapes)
{
  const TriangleMesh& mesh = geometry.Mesh;
  const auto hasChanged = [&](Index v) { return creases.Vertex[v] != wereOnCreases[v]; };
  const auto isNextToChange = [&](Index v)
  {
    const Index first = mesh.Outgoing(v);
    Index h = first;
    do
    {
      if (hasChanged(v) || hasChanged(mesh.Head(h)) ||
        hasChanged(mesh.Tail(TriangleMesh::Previous(h))))
      {
        return true;
      }
      h = mesh.NextOutgoing(h);
    } while (h != None && h != first);
    return false;
  };
  Fit(geometry, creases, isNextToChange, shapes);
}
}
