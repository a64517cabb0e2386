// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_UnitStage_h
#define DirectionFields_UnitStage_h

#include "Computation/ComponentStage.h"
#include "Geometry/IntrinsicGeometry.h"

namespace DirectionFields::Internal
{
/// Data that the fields of unit length over one component share, besides the matrices.
class UnitStage
{
public:
  /// @param triangulation that the energy was integrated on
  /// @param surface       the surface's own triangulation
  /// @param stage         of the component; must outlive this object, as the triangulations must
  UnitStage(const IntrinsicGeometry& triangulation, const IntrinsicGeometry& surface,
    const TriangleMesh::Component& component, const Options& options, ComponentStage& stage);

  /// Makes of the smoothest, aligned or constrained field the one of unit length. Throws Stopped.
  /// @param report SmoothnessEnergy and the figures of Options::UnitLength are filled in
  void Improve(const ComponentGuide& guide, const Options& options, const Progress& progress,
    ComplexVector& u, ComponentReport& report);

private:
  /// How strongly the guidance draws, over its mean modulus: w of UnitLengthField's Pull.
  double PullStrength(const ComponentGuide& guide, const Options& options) const;
  /// p of UnitLengthProblem; empty for none.
  ComplexVector Pull(const ComponentGuide& guide, double strength) const;

  const IntrinsicGeometry& Triangulation;
  const IntrinsicGeometry& Surface;
  TriangleMesh::Component Component;
  int Degree;
  ComponentStage& Stage;
  SparseMatrix Energy;
};
}

#endif
