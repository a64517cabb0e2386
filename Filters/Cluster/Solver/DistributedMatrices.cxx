// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Solver/DistributedMatrices.h"

#include "Processes.h"
#include "Sections/Assembly.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace DirectionFields::Parallel
{
namespace
{
/// Memory of PETSc's matrices, hierarchy and vectors for an own row, and for everything else.
constexpr std::size_t BytesOfRow = 2000;
constexpr std::size_t BytesOfSolver = 1 << 21;

/// Own rows, compressed, with columns of the whole.
struct Rows
{
  std::vector<PetscInt> Begin = { 0 };
  std::vector<PetscInt> Columns;
  std::vector<PetscScalar> Energy;
  std::vector<PetscScalar> Mass;
};

/// Appends the rows of the owned vertices of a part: their columns are complete, for all their
/// neighbours have all their triangles here.
void AppendRows(const DistributedMesh& mesh, const TriangleMesh::Component& part, int degree,
  double energyBias, const std::vector<PetscInt>& rowOf, double massFactor, Rows& rows)
{
  const Operators operators = AssembleOperators(mesh.GetGeometry(), part, degree, energyBias);
  const Index* const outer = operators.Energy.outerIndexPtr();
  const Index* const inner = operators.Energy.innerIndexPtr();
  std::vector<std::pair<PetscInt, Index>> order;
  for (Index v = part.FirstVertex; v < part.EndVertex; ++v)
  {
    if (!mesh.IsOwned(v))
    {
      continue;
    }
    order.clear();
    for (Index k = outer[v - part.FirstVertex]; k < outer[v - part.FirstVertex + 1]; ++k)
    {
      order.emplace_back(rowOf[part.FirstVertex + inner[k]], k);
    }
    std::sort(order.begin(), order.end());
    for (const auto& [column, k] : order)
    {
      rows.Columns.push_back(column);
      // A column of a Hermitian matrix is the conjugate of the row.
      rows.Energy.push_back(std::conj(operators.Energy.valuePtr()[k]));
      rows.Mass.push_back(massFactor * std::conj(operators.Mass.valuePtr()[k]));
    }
    rows.Begin.push_back(static_cast<PetscInt>(rows.Columns.size()));
  }
}
}

DistributedMatrices AssembleMatrices(const Messages& members, const std::vector<int>& processes,
  const DistributedMesh& mesh, int component, int degree, double energyBias,
  std::vector<PetscInt>& rowOf)
{
  DistributedMatrices matrices;
  const TriangleMesh& triangles = mesh.GetMesh();
  const std::vector<std::size_t>& parts = mesh.PartsOf(component);
  double unit = 0.0;
  DoOnAll(members.GetCommunicator(),
    [&]
    {
      for (const std::size_t c : parts)
      {
        unit = std::max(unit, mesh.GetGeometry().Lengths.Unit[c]);
        const TriangleMesh::Component& part = triangles.GetComponents()[c];
        for (Index v = part.FirstVertex; v < part.EndVertex; ++v)
        {
          if (mesh.IsOwned(v))
          {
            matrices.Vertices.push_back(v);
          }
        }
      }
    });
  matrices.Unit = members.Largest(unit);
  const auto own = static_cast<vtkIdType>(matrices.Vertices.size());
  const std::vector<vtkIdType> first =
    Processes::FirstOf(members.AllGather(std::vector<vtkIdType>{ own }).Values);
  matrices.FirstRow = static_cast<PetscInt>(first[members.Own()]);
  for (std::size_t k = 0; k < matrices.Vertices.size(); ++k)
  {
    rowOf[matrices.Vertices[k]] = matrices.FirstRow + static_cast<PetscInt>(k);
  }
  mesh.Complete(rowOf, component, members, processes);
  Rows rows;
  double area = 0.0;
  DoOnAll(members.GetCommunicator(),
    [&]
    {
      // Where PETSc itself notices, the others wait in one of its functions.
      RequireMemory(BytesOfSolver + matrices.Vertices.size() * BytesOfRow);
      for (const std::size_t c : parts)
      {
        const double ratio = mesh.GetGeometry().Lengths.Unit[c] / matrices.Unit;
        AppendRows(
          mesh, triangles.GetComponents()[c], degree, energyBias, rowOf, ratio * ratio, rows);
      }
      for (std::size_t k = 0; k < matrices.Vertices.size(); ++k)
      {
        const auto row = rows.Columns.begin();
        const auto diagonal = std::lower_bound(row + rows.Begin[k], row + rows.Begin[k + 1],
          matrices.FirstRow + static_cast<PetscInt>(k));
        // A third of the area of the triangles at a vertex is twice its diagonal entry.
        area += 2.0 * PetscRealPart(rows.Mass[diagonal - row]);
      }
    });
  matrices.Area = members.Sum(area);
  const auto count = static_cast<PetscInt>(own);
  const auto total = static_cast<PetscInt>(first.back());
  const auto make = [&](const std::vector<PetscScalar>& values, OwnedMat& matrix)
  {
    Require(MatCreateMPIAIJWithArrays(members.GetCommunicator(), count, count, total, total,
      rows.Begin.data(), rows.Columns.data(), values.data(), matrix.New()));
  };
  make(rows.Energy, matrices.Energy);
  make(rows.Mass, matrices.Mass);
  return matrices;
}
}
