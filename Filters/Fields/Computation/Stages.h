// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Stages_h
#define DirectionFields_Stages_h

#include "Computation/ComponentStage.h"
#include "Computation/UnitStage.h"
#include "Curvature/Curvature.h"
#include "Geometry/IntrinsicTriangulation.h"
#include "Geometry/SurfaceGeometry.h"
#include "Guidance/TensorSection.h"
#include "Mesh/MergePoints.h"
#include "Mesh/OutputPoints.h"
#include "Progress.h"

#include <memory>
#include <optional>
#include <vector>

namespace DirectionFields::Internal
{
/// The curvature at the output points, in the units of the input.
CurvatureReport ReportOf(
  const SurfaceGeometry& geometry, const Curvature& curvature, const OutputPoints& points);

/// Matrices and smallest eigenpairs of all components.
struct EnergyStage
{
  Options MadeFor;
  std::vector<ComponentStage> Components;
  /// The data of fields of unit length, made for the first one.
  std::optional<IntrinsicTriangulation> Delaunay;
  std::vector<std::unique_ptr<UnitStage>> Units;
};

/// Stages that DirectionField::Compute keeps for its next call. Those that depend on the surface
/// alone are kept for good, each other one until an option changes that it depends on.
class Stages
{
public:
  /// Throws MeshError.
  /// @param mergePoints as Options::MergePoints
  /// @param sizes       at each point, above 0: everything is computed in the metric where lengths
  ///                    count in units of the size, as Metric says; empty for the surface's own
  explicit Stages(std::shared_ptr<const Surface> surface,
    MergePoints mergePoints = MergePoints::Off, const std::vector<double>& sizes = {});
  explicit Stages(const Surface& surface);

  /// The surface as it came in.
  const Surface& GetInput() const { return *this->Input; }
  MergePoints GetMergePoints() const { return this->Merges; }
  /// For each point of the input the one that stands for it in the mesh; empty where each stands
  /// for itself.
  const std::vector<Index>& GetFirstPoints() const { return this->FirstPoint; }
  const SurfaceGeometry& GetGeometry() const { return this->Geometry; }
  const TriangleMesh& GetMesh() const { return this->Geometry.Mesh; }
  /// How many points became one with an earlier one.
  Index CountMergedPoints() const;

  /// Throws Stopped.
  EnergyStage& GetEnergy(const Options& options, const Progress& progress);
  const BoundaryPoints& GetBoundaryPoints();
  /// The data of a component's fields of unit length, kept with the energy, which must be that of
  /// the options.
  UnitStage& GetUnit(EnergyStage& energy, std::size_t component, const Options& options) const;
  const std::vector<double>& GetDihedralAngles();
  /// @param scale as Options::CurvatureScale
  const Curvature& GetCurvature(double scale = 0.0);
  /// The averaged tensors of the surface, kept for the last ones and their scale.
  const VertexTensors& GetTensors(
    const std::shared_ptr<const SurfaceTensors>& tensors, double scale);
  const OutputPoints& GetOutputPoints();
  /// The curvature at the output points, in the units of the input. All results of one scale share
  /// it.
  const std::shared_ptr<const CurvatureReport>& GetCurvatureReport(double scale = 0.0);

private:
  Stages(std::shared_ptr<const Surface> surface, MergePoints mergePoints, MergedMesh&& mesh,
    const std::vector<double>& sizes);

  std::shared_ptr<const Surface> Input;
  MergePoints Merges;
  std::vector<Index> FirstPoint;
  SurfaceGeometry Geometry;
  std::optional<EnergyStage> Energy;
  std::optional<BoundaryPoints> Boundary;
  std::optional<std::vector<double>> Dihedral;
  std::optional<Curvature> Curved;
  double CurvatureScale = 0.0;
  std::optional<VertexTensors> Tensors;
  std::shared_ptr<const SurfaceTensors> TensorsGiven;
  double TensorScale = 0.0;
  std::optional<OutputPoints> Points;
  std::shared_ptr<const CurvatureReport> CurvatureAtPoints;
};
}

#endif
