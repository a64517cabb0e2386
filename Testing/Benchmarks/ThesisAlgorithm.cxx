// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ThesisAlgorithm.h"

#include "Eigenpairs/Lanczos.h"
#include "Geometry/SurfaceGeometry.h"
#include "Sections/Assembly.h"
#include "Sections/Singularities.h"
#include "Support/Division.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <chrono>
#include <random>
#include <stdexcept>

using namespace DirectionFields;

namespace
{
/// Added to A, in multiples of the mass and of the order of the smallest eigenvalue: keeps the
/// factorization from failing where that is 0.
constexpr double Shift = 1e-8;

ComplexVector RandomVector(Eigen::Index size)
{
  std::mt19937 random(1);
  ComplexVector vector(size);
  for (Complex& entry : vector)
  {
    const double real = random() / 4294967296.0 - 0.5;
    entry = { real, random() / 4294967296.0 - 0.5 };
  }
  return vector;
}

ComplexVector InverseIterations(const Operators& matrices, double shift)
{
  using Factor = Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::AMDOrdering<Index>>;
  const SparseMatrix shifted = matrices.Energy + shift * matrices.Mass;
  const Factor factor(shifted);
  if (factor.info() != Eigen::Success)
  {
    throw std::runtime_error("The matrix could not be factored.");
  }
  ComplexVector u = RandomVector(matrices.Energy.rows());
  for (int k = 0; k < ThesisAlgorithm::Iterations; ++k)
  {
    u = factor.solve(matrices.Mass * u);
    u /= std::sqrt(u.dot(matrices.Mass * u).real());
  }
  return u;
}
}

ThesisAlgorithm::ThesisAlgorithm(const Surface& surface, int degree)
{
  const auto begin = std::chrono::steady_clock::now();
  const auto elapsed = [&begin]
  { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(); };
  const SurfaceGeometry geometry(surface);
  const TriangleMesh& mesh = geometry.Mesh;
  std::vector<Operators> matrices;
  for (const TriangleMesh::Component& component : mesh.GetComponents())
  {
    matrices.push_back(AssembleOperators(geometry, component, degree, 0.0));
  }
  this->SetupSeconds = elapsed();

  std::vector<Complex> field(mesh.GetNumberOfVertices());
  for (std::size_t c = 0; c < matrices.size(); ++c)
  {
    const Operators& both = matrices[c];
    const double scale = 2.0 * Pi * degree / geometry.Lengths.ComponentArea[c];
    const ComplexVector u = InverseIterations(both, Shift * scale);
    const double lambda = u.dot(both.Energy * u).real();
    this->Residual =
      std::max(this->Residual, RelativeResidual(both.Energy, SectionProducts(both, u), lambda));
    if (c == 0)
    {
      this->Eigenvalue = PerSquare(lambda, geometry.Lengths.Unit[c]);
    }
    std::copy(u.begin(), u.end(), field.begin() + mesh.GetComponents()[c].FirstVertex);
  }
  for (const int index : SingularityIndices(geometry, degree, field))
  {
    this->Singularities += index != 0;
  }
  this->Seconds = elapsed();
}
