// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "TrivialConnection/RotationAlignment.h"

#include "Fields/TrivialConnection/Components.h"
#include "Meshes/Surfaces.h"
#include "Sections/Singularities.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace DirectionFields;

namespace
{
double Deviation(const ComplexVector& a, const ComplexVector& b)
{
  double sum = 0.0;
  for (Eigen::Index v = 0; v < a.size(); ++v)
  {
    sum += std::abs(std::arg(a[v] * std::conj(b[v])));
  }
  return sum / static_cast<double>(a.size());
}
}

TEST(RotationAlignment, DrawsTheFieldToTheGuidanceAndKeepsItsCurvature)
{
  const Components::Tested parts(Meshes::Disk(12));
  const std::vector<Complex> base(parts.Mesh.GetNumberOfVertices(), 1.0);
  TrivialConnection connection(parts.Geometry, parts.Component, 4, base, {});
  RotationTarget target;
  target.Indices = connection.GetBaseIndices();
  const TurnedField start = connection.Turn(target, {});
  // The guidance has the field's singularities, but waves.
  ComplexVector guidance = connection.SectionOf(start);
  for (Index v = 0; v < guidance.size(); ++v)
  {
    guidance[v] *= std::polar(1.0, std::sin(3.0 * parts.Geometry.Positions[v].x()));
  }
  double last = Deviation(connection.SectionOf(start), guidance);
  for (const double tau : { 0.3, 0.9, 0.99 })
  {
    TurnedField field = start;
    const double share = AlignField(connection, target, guidance,
      StrengthOf(tau, 4, connection.GetSolver().GetArea()), {}, field);
    EXPECT_EQ(share, 1.0);
    const double deviation = Deviation(connection.SectionOf(field), guidance);
    EXPECT_LT(deviation, last) << tau;
    last = deviation;
    EXPECT_GT(field.Energy, start.Energy);
    for (Index t = 0; t < parts.Component.Triangles(); ++t)
    {
      EXPECT_NEAR(
        parts.Forms.Around(field.Rotation, t), parts.Forms.Around(start.Rotation, t), 1e-9);
    }
    EXPECT_TRUE(connection.WrongTriangles(target, field).empty());
  }
  EXPECT_LT(last, 0.05);
}

TEST(RotationAlignment, LeavesTheFieldWhereThereIsNoGuidance)
{
  const Components::Tested parts(Meshes::Disk(6));
  const std::vector<Complex> base(parts.Mesh.GetNumberOfVertices(), 1.0);
  TrivialConnection connection(parts.Geometry, parts.Component, 2, base, {});
  RotationTarget target;
  target.Indices = connection.GetBaseIndices();
  TurnedField field = connection.Turn(target, {});
  const Eigen::VectorXd turn = field.Turn;
  EXPECT_EQ(
    AlignField(connection, target, ComplexVector::Zero(parts.Component.Vertices()), 1.0, {}, field),
    0.0);
  EXPECT_EQ(field.Turn, turn);
}

TEST(RotationAlignment, StrengthIsThatOfAlignedFields)
{
  EXPECT_EQ(StrengthOf(0.0, 4, 3.0), 0.0);
  EXPECT_NEAR(StrengthOf(0.5, 4, 3.0), 2.0 * Pi * 4 / 3.0, 1e-12);
  EXPECT_NEAR(StrengthOf(0.75, 1, 2.0), 3.0 * Pi, 1e-12);
  EXPECT_TRUE(std::isfinite(StrengthOf(1.0, 4, 3.0)));
}
