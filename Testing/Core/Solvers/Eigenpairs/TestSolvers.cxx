// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Geometry/TangentFrames.h"
#include "Meshes/Surfaces.h"
#include "Meshes/System.h"
#include "Sections/Assembly.h"
#include "Sections/SectionIntegrals.h"
#include "Sections/Singularities.h"
#include "Solvers/Eigenpairs/Lanczos.h"
#include "Solvers/Matrices/Factorization.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>

#include <cmath>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
Eigen::VectorXd DenseEigenvalues(const Operators& o)
{
  return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXcd>(
    Eigen::MatrixXcd(o.Energy), Eigen::MatrixXcd(o.Mass), Eigen::EigenvaluesOnly)
    .eigenvalues();
}

bool PositiveDefinite(const SparseMatrix& m)
{
  const Eigen::SimplicialLDLT<SparseMatrix> solver(m);
  return solver.info() == Eigen::Success && solver.vectorD().real().minCoeff() > 0.0;
}
}

TEST(Operators, AreHermitianWithOnePattern)
{
  const System system(Potato(2), 3, 0.4);
  const SparseMatrix& a = system.Matrices.Energy;
  const SparseMatrix& m = system.Matrices.Mass;
  EXPECT_EQ((a - SparseMatrix(a.adjoint())).norm(), 0.0);
  EXPECT_EQ((m - SparseMatrix(m.adjoint())).norm(), 0.0);
  EXPECT_EQ(a.nonZeros(), system.Mesh.GetNumberOfVertices() + 2 * system.Mesh.GetNumberOfEdges());
  EXPECT_EQ(m.nonZeros(), a.nonZeros());
  for (Eigen::Index column = 0; column < a.cols(); ++column)
  {
    for (Index k = a.outerIndexPtr()[column] + 1; k < a.outerIndexPtr()[column + 1]; ++k)
    {
      EXPECT_LT(a.innerIndexPtr()[k - 1], a.innerIndexPtr()[k]);
    }
  }
}

TEST(Operators, FlatSurfaceHasCotangentWeightsAndTheLinearMassMatrix)
{
  Surface flat = Jittered(Square(5), 0.05, 8);
  for (Vector3& p : flat.Points)
  {
    p.z() = 0.0;
  }
  const System s(flat, 4, 0.0);
  for (Index e = 0; e < s.Mesh.GetNumberOfEdges(); ++e)
  {
    const Index h = s.Mesh.HalfEdge(e);
    double cotangents = 0.0;
    double area = 0.0;
    for (const Index side : { h, s.Mesh.Twin(h) })
    {
      if (side != None)
      {
        cotangents += 1.0 / std::tan(s.Lengths.CornerAngle(s.Mesh, TriangleMesh::Previous(side)));
        area += s.Lengths.Area[side / 3];
      }
    }
    const Complex back = std::polar(1.0, 4.0 * s.Transport.Rotation[e]);
    const Complex a = s.Matrices.Energy.coeff(s.Mesh.Tail(h), s.Mesh.Head(h)) * back;
    const Complex m = s.Matrices.Mass.coeff(s.Mesh.Tail(h), s.Mesh.Head(h)) * back;
    EXPECT_NEAR(a.real(), -0.5 * cotangents, 1e-11);
    EXPECT_NEAR(a.imag(), 0.0, 1e-11);
    EXPECT_NEAR(m.real(), area / 12.0, 1e-11);
    EXPECT_NEAR(m.imag(), 0.0, 1e-11);
  }
}

TEST(Operators, MatricesAreHermitianToTheBit)
{
  Surface sheet = Jittered(Potato(3), 0.03, 2);
  sheet.Triangles.push_back({ 0, sheet.Triangles[0][1], 600 });
  const System system(sheet, 3, 0.4);
  for (const SparseMatrix& matrix : { system.Matrices.Energy, system.Matrices.Mass })
  {
    EXPECT_EQ((matrix - SparseMatrix(matrix.adjoint())).norm(), 0.0);
  }
}

TEST(Operators, EdgesThatJoinTheSameVerticesAddUp)
{
  // A fin inside a sheet leaves a slit: its two sides are edges between the same two vertices.
  Surface sheet = Jittered(Square(4), 0.03, 2);
  sheet.Points.emplace_back(0.4, 0.5, 1.0);
  sheet.Triangles.push_back({ 11, 12, 25 });
  const System system(sheet, 4, 0.3);
  const auto& component = system.Mesh.GetComponents()[0];
  ASSERT_EQ(component.Vertices(), 25);
  EXPECT_EQ(system.Matrices.Energy.nonZeros(), 25 + 2 * (component.Edges() - 1));
  const ComplexVector u = RandomVector(25, 3);
  double energy = 0.0;
  for (Index t = component.FirstTriangle; t < component.EndTriangle; ++t)
  {
    std::array<double, 3> squaredLength;
    std::array<Complex, 3> transport;
    for (int c = 0; c < 3; ++c)
    {
      squaredLength[c] = system.Lengths.SquaredLength[system.Mesh.Edge(3 * t + c)];
      transport[c] =
        std::polar(1.0, 4.0 * system.Transport.RotationAlong(system.Mesh, 3 * t + c));
    }
    const LocalMatrices local(squaredLength, system.Lengths.Area[t],
      4.0 * system.Transport.Curvature[t], transport, 0.3);
    for (int c = 0; c < 3; ++c)
    {
      const Complex tail = u[system.Mesh.Tail(3 * t + c)];
      const Complex head = u[system.Mesh.Head(3 * t + c)];
      energy += std::norm(tail) * local.EnergyDiagonal[c] +
        2.0 * (std::conj(tail) * local.Energy[c] * head).real();
    }
  }
  EXPECT_NEAR(u.dot(system.Matrices.Energy * u).real(), energy, 1e-11 * energy);
}

TEST(Operators, EnergyIsPositiveSemidefiniteAlsoWithBoundary)
{
  for (const Surface& surface : { Tetrahedron(), Cube(), Hemisphere(1), Disk(3), Potato(1),
         Jittered(Cylinder(7, 3, 1.0), 0.2, 5), Jittered(Torus(8, 6), 0.1, 6) })
  {
    for (const int degree : { 1, 2, 4, 7 })
    {
      for (const double bias : { -1.0, -0.6, 0.0, 0.5, 1.0 })
      {
        const System system(surface, degree, bias);
        const Eigen::VectorXd values = DenseEigenvalues(system.Matrices);
        EXPECT_GT(values[0], -1e-12 * values[values.size() - 1])
          << "degree " << degree << " bias " << bias;
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd> mass(
          Eigen::MatrixXcd(system.Matrices.Mass), Eigen::EigenvaluesOnly);
        EXPECT_GT(mass.eigenvalues()[0], 0.0);
      }
    }
  }
}

TEST(Lanczos, EqualsTheDenseSolver)
{
  for (const Surface& surface : { Potato(2), Hemisphere(2), Jittered(Torus(12, 9), 0.05, 2), DoubleTorus() })
  {
    for (const double bias : { -0.9, 0.0, 0.9 })
    {
      const System system(surface, 4, bias);
      EigenpairSettings settings;
      settings.Tolerance = 1e-9;
      settings.Scale = system.Scale;
      const Eigenpair pair = SolveByLanczos(system.Matrices.Energy, system.Matrices.Mass,
        RandomVector(system.Matrices.Energy.rows(), 1), settings);
      const double exact = DenseEigenvalues(system.Matrices)[0];
      EXPECT_LE(pair.Residual, 1e-9);
      EXPECT_NEAR(pair.Value / exact, 1.0, 1e-9);
      EXPECT_NEAR(pair.Vector.dot(system.Matrices.Mass * pair.Vector).real(), 1.0, 1e-12);
      const ComplexVector residual = system.Matrices.Energy * pair.Vector -
        pair.Value * (system.Matrices.Mass * pair.Vector);
      EXPECT_LE(residual.norm(), 1.1e-9 * (system.Matrices.Energy * pair.Vector).norm());
    }
  }
}

TEST(Lanczos, NoEigenvalueLiesBelow)
{
  // By Sylvester's law of inertia: A - x M is definite just below the value found, not above it.
  for (const int degree : { 1, 4, 6 })
  {
    const System system(Potato(4), degree, 0.0);
    EigenpairSettings settings;
    settings.Scale = system.Scale;
    const Eigenpair pair = SolveByLanczos(system.Matrices.Energy, system.Matrices.Mass,
      RandomVector(system.Matrices.Energy.rows(), 7), settings);
    EXPECT_LE(pair.Residual, settings.Tolerance);
    EXPECT_TRUE(PositiveDefinite(
      system.Matrices.Energy - (pair.Value * (1.0 - 1e-6)) * system.Matrices.Mass));
    EXPECT_FALSE(PositiveDefinite(
      system.Matrices.Energy - (pair.Value * (1.0 + 1e-6)) * system.Matrices.Mass));
  }
}

TEST(Lanczos, StartNearlyOrthogonalToTheSolution)
{
  const System system(Potato(3), 4, 0.0);
  const SparseMatrix& a = system.Matrices.Energy;
  const SparseMatrix& m = system.Matrices.Mass;
  EigenpairSettings settings;
  settings.Tolerance = 1e-10;
  settings.Scale = system.Scale;
  const Eigenpair pair = SolveByLanczos(a, m, RandomVector(a.rows(), 3), settings);
  ComplexVector start = RandomVector(a.rows(), 4);
  start -= pair.Vector * pair.Vector.dot(m * start);
  start += 1e-6 * pair.Vector;
  const Eigenpair other = SolveByLanczos(a, m, start, settings);
  EXPECT_NEAR(other.Value / pair.Value, 1.0, 1e-9);
  EXPECT_LE(other.Residual, 1e-10);
}

TEST(Lanczos, DegenerateEigenspaceGivesTheProjectionOfTheStart)
{
  // The tetrahedral symmetry leaves no single direction; both solvers must agree on what is left.
  const System system(Icosphere(1), 1, 0.0);
  const SparseMatrix& a = system.Matrices.Energy;
  const SparseMatrix& m = system.Matrices.Mass;
  const ComplexVector start = RandomVector(a.rows(), 9);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXcd> dense{ Eigen::MatrixXcd(a),
    Eigen::MatrixXcd(m) };
  const Eigen::Index multiplicity =
    (dense.eigenvalues().array() < dense.eigenvalues()[0] * (1.0 + 1e-9)).count();
  EXPECT_EQ(multiplicity, 3);
  const auto space = dense.eigenvectors().leftCols(multiplicity);
  ComplexVector projection = space * (space.adjoint() * (m * start));
  projection /= std::sqrt(projection.dot(m * projection).real());
  ASSERT_LE(a.rows(), 48) << "the dense branch is meant";
  const Eigenpair small = SolveByLanczos(a, m, start, {});
  EXPECT_NEAR(std::abs(projection.dot(m * small.Vector)), 1.0, 1e-9);
  EXPECT_EQ(small.Iterations, 0);

  const System fine(Icosphere(3), 1, 0.0);
  EigenpairSettings settings;
  settings.Scale = fine.Scale;
  settings.Tolerance = 1e-9;
  const Eigenpair large = SolveByLanczos(
    fine.Matrices.Energy, fine.Matrices.Mass, RandomVector(fine.Matrices.Energy.rows(), 9), settings);
  EXPECT_LE(large.Residual, 1e-9);
}

TEST(Lanczos, SaysWhenItHasNotConverged)
{
  const System system(Potato(4), 4, 0.0);
  EigenpairSettings settings;
  settings.Tolerance = 1e-12;
  settings.MaximumIterations = 4;
  settings.Scale = system.Scale;
  const Eigenpair pair = SolveByLanczos(system.Matrices.Energy, system.Matrices.Mass,
    RandomVector(system.Matrices.Energy.rows(), 5), settings);
  EXPECT_EQ(pair.Iterations, 4);
  EXPECT_GT(pair.Residual, 1e-12);
  EXPECT_TRUE(pair.Vector.allFinite());
  EXPECT_NEAR(pair.Residual,
    RelativeResidual(system.Matrices.Energy, system.Matrices.Mass, pair.Vector, pair.Value), 1e-15);
}

TEST(Lanczos, RestartsKeepConverging)
{
  // The holomorphic energy has 2n + 1 small eigenvalues that lie close together.
  const System system(Jittered(Icosphere(3), 0.01, 1), 6, 1.0);
  EigenpairSettings settings;
  settings.Tolerance = 1e-10;
  settings.Scale = system.Scale;
  settings.MaximumIterations = 1000;
  const Eigenpair pair = SolveByLanczos(system.Matrices.Energy, system.Matrices.Mass,
    RandomVector(system.Matrices.Energy.rows(), 5), settings);
  EXPECT_LE(pair.Residual, 1e-10);
  EXPECT_TRUE(PositiveDefinite(
    system.Matrices.Energy - (pair.Value * (1.0 - 1e-6)) * system.Matrices.Mass));
}

TEST(Lanczos, StopsWhenTold)
{
  const System system(Potato(3), 4, 0.0);
  int calls = 0;
  const ProgressFunction stop = [&](double) { return ++calls < 3; };
  EXPECT_THROW(SolveByLanczos(system.Matrices.Energy, system.Matrices.Mass,
                 RandomVector(system.Matrices.Energy.rows(), 5), {}, Progress(stop)),
    Stopped);
  EXPECT_EQ(calls, 3);
}

TEST(Factorization, IsGivenUpWhenTold)
{
  // The second one is large enough to be asked about while it is factored.
  for (const int levels : { 3, 6 })
  {
    const System system(Potato(levels), 4, 0.0);
    const SparseMatrix matrix = system.Matrices.Energy + system.Matrices.Mass;
    const ComplexVector b = RandomVector(matrix.rows(), 1);
    int calls = 0;
    Factorization stopped;
    const ProgressFunction stop = [&](double) { return calls++ < (levels == 6 ? 1 : 0); };
    EXPECT_THROW(stopped.Compute(matrix, Progress(stop)), Stopped);
    EXPECT_EQ(calls, levels == 6 ? 2 : 1);
    struct Trouble
    {
    };
    const ProgressFunction trouble = [](double) -> bool { throw Trouble(); };
    EXPECT_THROW(stopped.Compute(matrix, Progress(trouble)), Trouble);
    // Others know nothing of it, and what they compute is the same as without questions.
    Factorization asked;
    Factorization plain;
    const ProgressFunction goOn = [](double) { return true; };
    ASSERT_TRUE(asked.Compute(matrix, Progress(goOn)));
    ASSERT_TRUE(plain.Compute(matrix));
    EXPECT_EQ(asked.Solve(b), plain.Solve(b));
    EXPECT_LT((matrix * plain.Solve(b) - b).norm(), 1e-10 * b.norm());
  }
}

TEST(Singularities, SumIsDegreeTimesChiForAnyField)
{
  const std::vector<std::pair<Surface, int>> surfaces = { { Tetrahedron(), 2 }, { Octahedron(), 2 },
    { Cube(), 2 }, { Icosphere(1), 2 }, { Potato(2), 2 }, { Torus(5, 4), 0 }, { DoubleTorus(), -2 } };
  for (const auto& [surface, chi] : surfaces)
  {
    for (int degree = 1; degree <= 16; ++degree)
    {
      const System system(surface, degree, 0.0);
      const auto n = static_cast<std::size_t>(system.Mesh.GetNumberOfVertices());
      std::vector<std::vector<Complex>> fields;
      const ComplexVector random = RandomVector(static_cast<Eigen::Index>(n), degree);
      fields.emplace_back(random.begin(), random.end());
      // Vanishing vectors, and signs only: ties of omega at +-pi.
      fields.emplace_back(n, 0.0);
      fields.emplace_back(n, 1.0);
      fields.emplace_back(n, 1e-300);
      for (std::size_t i = 0; i < n; i += 2)
      {
        fields[2][i] = -1.0;
        fields[3][i] = Complex(0.0, -1e300);
      }
      for (const auto& field : fields)
      {
        int sum = 0;
        for (const int index : SingularityIndices(system.Mesh, system.Transport, degree, field))
        {
          sum += index;
        }
        EXPECT_EQ(sum, degree * chi) << "degree " << degree;
      }
    }
  }
}

TEST(Singularities, KnownFieldsOnTheDisk)
{
  // u = (z / |z|)^k has one singularity of index k / n, at the center, for any n.
  Surface disk = Disk(6);
  for (Vector3& p : disk.Points)
  {
    p += Vector3(0.02, 0.03, 0.0);
  }
  const System system(disk, 1, 0.0);
  const TangentFrames frames(system.Mesh, system.Transport, system.Positions);
  for (const int k : { -2, -1, 0, 1, 2 })
  {
    for (const int degree : { 1, 2, 4, 6 })
    {
      std::vector<Complex> field;
      for (Index v = 0; v < system.Mesh.GetNumberOfVertices(); ++v)
      {
        const Vector3& p = disk.Points[system.Mesh.Point(v)];
        const double frame = std::atan2(frames.X[v].y(), frames.X[v].x());
        field.push_back(std::polar(1.0, k * std::atan2(p.y(), p.x()) - degree * frame));
      }
      int sum = 0;
      int nonZero = 0;
      for (const int index : SingularityIndices(system.Mesh, system.Transport, degree, field))
      {
        sum += index;
        nonZero += index != 0;
      }
      EXPECT_EQ(sum, k);
      EXPECT_LE(nonZero, std::abs(k));
    }
  }
}
