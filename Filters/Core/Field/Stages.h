// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Stages_h
#define DirectionFields_Stages_h

#include "Field/ComponentStage.h"
#include "Field/Curvature.h"
#include "Geometry/SurfaceGeometry.h"
#include "Mesh/MergePoints.h"
#include "Mesh/OutputPoints.h"
#include "Progress.h"

#include <memory>
#include <optional>
#include <tuple>
#include <vector>

namespace DirectionFields::Internal
{
/// The options that matrices and smallest eigenpairs depend on.
using EnergyKey = std::tuple<int, double, double, int, Solver, bool>;

inline EnergyKey EnergyKeyOf(const Options& options)
{
  return { options.Degree, options.EnergyBias, options.Tolerance, options.MaximumIterations,
    options.Solver, options.IntrinsicDelaunay };
}

/// Matrices and smallest eigenpairs of all components.
struct EnergyStage
{
  EnergyKey Key;
  std::vector<ComponentStage> Components;
};

/// What is kept between calls of DirectionField::Compute. What depends on the surface alone is kept for
/// good, everything else until the options change that it depends on.
class Stages
{
public:
  /// Throws MeshError.
  /// @param mergePoints as Options::MergePoints
  explicit Stages(std::shared_ptr<const Surface> surface, bool mergePoints = false);
  explicit Stages(const Surface& surface);

  /// The surface as it came in.
  const Surface& GetInput() const { return *this->Input; }
  bool MergesPoints() const { return this->Merges; }
  /// For each point of the input the one that stands for it in the mesh; empty where points are not
  /// merged.
  const std::vector<Index>& GetFirstPoints() const { return this->FirstPoint; }
  const SurfaceGeometry& GetGeometry() const { return this->Geometry; }
  const TriangleMesh& GetMesh() const { return this->Geometry.Mesh; }
  const BoundaryPoints& GetBoundaryPoints() const { return this->Boundary; }

  /// The order of magnitude of a component's smallest eigenvalue: 2 pi n / area, in 1 / unit^2.
  double GetScale(std::size_t component, int degree) const;

  /// Throws Stopped.
  EnergyStage& GetEnergy(const Options& options, const Progress& progress);
  const std::vector<double>& GetDihedralAngles();
  const Curvature& GetCurvature();
  const OutputPoints& GetOutputPoints();
  /// The curvature at the output points, in the units of the input. All results share it.
  const std::shared_ptr<const CurvatureReport>& GetCurvatureReport();

private:
  /// @param triangulation that the energy is integrated on
  ComponentStage MakeComponent(const Options& options, std::size_t c,
    const IntrinsicGeometry& triangulation, const Progress& progress) const;

  std::shared_ptr<const Surface> Input;
  bool Merges;
  std::vector<Index> FirstPoint;
  SurfaceGeometry Geometry;
  BoundaryPoints Boundary;
  std::optional<EnergyStage> Energy;
  std::optional<std::vector<double>> Dihedral;
  std::optional<Curvature> Curved;
  std::optional<OutputPoints> Points;
  std::shared_ptr<const CurvatureReport> CurvatureAtPoints;
};
}

#endif
