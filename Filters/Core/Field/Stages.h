// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Stages_h
#define DirectionFields_Stages_h

#include "Field/ComponentField.h"
#include "Field/Curvature.h"
#include "Geometry/Connection.h"
#include "Geometry/Metric.h"
#include "Geometry/TangentFrames.h"
#include "Mesh/MergePoints.h"
#include "Mesh/TriangleMesh.h"
#include "Progress.h"
#include "Sections/Assembly.h"

#include <memory>
#include <optional>
#include <vector>

namespace DirectionFields
{
/// The options that the smoothest field depends on.
struct EnergyOptions
{
  int Degree;
  double EnergyBias;
  double Tolerance;
  int MaximumIterations;
  DirectionFields::Solver Solver;
  bool IntrinsicDelaunay;

  explicit EnergyOptions(const Options& options)
    : Degree(options.Degree)
    , EnergyBias(options.EnergyBias)
    , Tolerance(options.Tolerance)
    , MaximumIterations(options.MaximumIterations)
    , Solver(options.Solver)
    , IntrinsicDelaunay(options.IntrinsicDelaunay)
  {
  }
  bool operator==(const EnergyOptions& other) const
  {
    return this->Degree == other.Degree && this->EnergyBias == other.EnergyBias &&
      this->Tolerance == other.Tolerance && this->MaximumIterations == other.MaximumIterations &&
      this->Solver == other.Solver && this->IntrinsicDelaunay == other.IntrinsicDelaunay;
  }
};

/// Matrices and smallest eigenpair of each component.
struct EnergyStage
{
  EnergyOptions Key;
  std::vector<Operators> Matrices;
  std::vector<SmallestPairs> Smoothest;
  /// Hierarchies of what the constraints last solved for by multigrid left free; null before.
  std::vector<std::unique_ptr<FreeSystem>> Free;
  /// Of the solutions without constraints.
  std::vector<ReducedBasis> Solved;
  std::vector<std::optional<GuidanceTerms>> Terms;
};

/// What is kept between calls of DirectionField::Compute: the surface's stages for good, the others
/// until the options change that they depend on.
class Stages
{
public:
  /// Throws MeshError.
  explicit Stages(const Surface& surface);

  const TriangleMesh& GetMesh() const { return this->Mesh; }
  /// Of the vertices.
  const std::vector<Vector3>& GetPositions() const { return this->Positions; }
  const Metric& GetMetric() const { return this->Geometry; }
  const Connection& GetConnection() const { return this->Transport; }
  const TangentFrames& GetFrames() const { return this->Frames; }
  const BoundaryPoints& GetBoundaryPoints() const { return this->Boundary; }

  /// The order of magnitude of a component's smallest eigenvalue: 2 pi n / area, in 1 / unit^2.
  double GetScale(std::size_t component, int degree) const;

  /// Null where the progress function stopped it.
  EnergyStage* GetEnergy(const Options& options, const ProgressFunction& progress);
  const std::vector<double>& GetDihedralAngles();
  const Curvature& GetCurvature();

private:
  TriangleMesh Mesh;
  std::vector<Vector3> Positions;
  Metric Geometry;
  Connection Transport;
  TangentFrames Frames;
  BoundaryPoints Boundary;
  std::optional<EnergyStage> Energy;
  std::optional<std::vector<double>> Dihedral;
  std::optional<Curvature> Curved;
};
}

#endif
