// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Carries one vector to all points of a surface, along the shortest ways, by the vector heat method:
//
// N. Sharp, Y. Soliman, K. Crane: The Vector Heat Method. ACM Transactions on Graphics 38(3), 2019.
//
// The vector at the source diffuses for a short time t, (M + t A) u = M u_0, where A is the connection
// Laplacian (the energy of fields of degree 1) and M the mass matrix. What arrives at a point has the
// direction of the carried vector. On a plane and on a sphere the answer is known, and by symmetry it
// is the same for any t.

#include "Surfaces.h"

#include <DirectionFields/Geometry/SurfaceGeometry.h>
#include <DirectionFields/Sections/Assembly.h>

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <vector>

using namespace DirectionFields;

namespace
{
/// The unit tangent vectors that a vector at one vertex becomes at each vertex of a connected surface.
/// @param time t, in the square of the surface's unit. On a surface without symmetries the shorter it
///             is the nearer the ways are to the shortest ones; the square of the mean edge length
///             is as short as it can be.
std::vector<Vector3> Carried(
  const SurfaceGeometry& geometry, Index source, const Vector3& vector, double time)
{
  const TriangleMesh::Component& component = geometry.Mesh.GetComponents().at(0);
  const Operators operators = AssembleOperators(geometry, component, 1, 0.0);
  // The matrices are in units of the mean edge length.
  const double unit = geometry.Lengths.Unit[0];
  const SparseMatrix flow = operators.Mass + time / (unit * unit) * operators.Energy;
  const Eigen::SimplicialLDLT<SparseMatrix> factor(flow);
  if (factor.info() != Eigen::Success)
  {
    throw std::runtime_error("The matrix could not be factored.");
  }
  ComplexVector u = ComplexVector::Zero(component.Vertices());
  u[source] = geometry.Frames.Tangential(source, vector);
  u = factor.solve(u).eval();
  std::vector<Vector3> carried(component.Vertices());
  for (Index v = 0; v < component.Vertices(); ++v)
  {
    const Complex direction = u[v] / std::abs(u[v]);
    carried[v] = direction.real() * geometry.Frames.X[v] + direction.imag() * geometry.Frames.Y(v);
  }
  return carried;
}

double Degrees(const Vector3& a, const Vector3& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / Pi;
}

/// A square of 2 n^2 triangles, the points of its inside moved a little.
Surface Square(Index n)
{
  Surface square;
  for (Index j = 0; j <= n; ++j)
  {
    for (Index i = 0; i <= n; ++i)
    {
      const bool inside = i > 0 && i < n && j > 0 && j < n;
      square.Points.emplace_back(i + (inside ? 0.3 * std::sin(i + 5.0 * j) : 0.0),
        j + (inside ? 0.3 * std::cos(7.0 * i + j) : 0.0), 0.0);
      if (i < n && j < n)
      {
        const Index corner = j * (n + 1) + i;
        square.Triangles.push_back({ corner, corner + 1, corner + n + 2 });
        square.Triangles.push_back({ corner, corner + n + 2, corner + n + 1 });
      }
    }
  }
  return square;
}

/// The largest error on the square, where vectors stay what they are. In degrees.
double ErrorOnSquare()
{
  const SurfaceGeometry geometry(Square(30));
  const Vector3 vector = Vector3(1.0, 2.0, 0.0).normalized();
  double error = 0.0;
  for (const Vector3& carried : Carried(geometry, 100, vector, 20.0))
  {
    error = std::max(error, Degrees(carried, vector));
  }
  return error;
}

/// The largest error on the sphere, in degrees. A great circle carries vectors along by the turns
/// about its axis. Near the point opposite of the source, where many shortest ways meet, nothing is
/// compared.
double ErrorOnSphere(Index n)
{
  constexpr double time = 0.1;
  const SurfaceGeometry geometry(Sphere(n));
  const Index source = geometry.Mesh.GetNumberOfVertices() / 3;
  const Vector3 from = geometry.Positions[source];
  const Vector3 vector = geometry.Frames.X[source];
  const std::vector<Vector3> carried = Carried(geometry, source, vector, time);
  double error = 0.0;
  for (std::size_t v = 0; v < carried.size(); ++v)
  {
    const Vector3& to = geometry.Positions[v];
    if (Degrees(from, to) < 150.0)
    {
      error =
        std::max(error, Degrees(carried[v], Eigen::Quaterniond::FromTwoVectors(from, to) * vector));
    }
  }
  return error;
}
}

int main()
{
  const double square = ErrorOnSquare();
  const std::array<double, 3> sphere = { ErrorOnSphere(10), ErrorOnSphere(20), ErrorOnSphere(40) };
  std::printf("Square: %.6f degrees\n", square);
  std::printf("Spheres of 800, 3200 and 12800 triangles: %.2f, %.2f and %.2f degrees\n", sphere[0],
    sphere[1], sphere[2]);
  // Halving the edges quarters the error.
  const bool isRight =
    square < 1e-6 && sphere[0] < 2.0 && sphere[1] < 0.3 * sphere[0] && sphere[2] < 0.3 * sphere[1];
  return isRight ? EXIT_SUCCESS : EXIT_FAILURE;
}
