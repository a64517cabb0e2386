// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Fields/PrescribedSingularities/Placements.h"
#include "Interpolation/FieldInterpolant.h"
#include "Meshes/Fields.h"
#include "Meshes/Surfaces.h"
#include "Sections/DoubleCover.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

using namespace DirectionFields;

TEST(PrescribedRotation, KeepsConstrainedDirections)
{
  // A disk whose field follows its boundary: crosses need four singularities, or rather their index.
  const Surface disk = Meshes::Disk(12);
  Options options;
  options.ConstrainBoundary = true;
  const Result base = DirectionField(disk).Compute(options);
  const int needed = Placements::Sum(base.SingularityIndex);
  SingularityEditor editor(disk, Fields::Of(base), base.ConstraintDirection);
  std::vector<WantedSingularity> wanted;
  for (int k = 0; k < needed; ++k)
  {
    wanted.push_back({ Vector3(0.4 * std::cos(k), 0.4 * std::sin(k), 0.0), 1 });
  }
  const EditedField edited = editor.Edit(wanted, {}, {});
  EXPECT_TRUE(edited.WrongTriangles.empty());
  const GivenField& given = editor.GetBase();
  for (Index v = 0; v < given.GetMesh().GetNumberOfVertices(); ++v)
  {
    const Index point = given.GetMesh().Point(v);
    if (!base.ConstraintDirection[point].isZero())
    {
      const Complex at =
        given.GetGeometry().Frames.Tangential(v, base.ConstraintDirection[point].normalized());
      const Complex power = IntegerPower(at / std::abs(at), 4);
      EXPECT_LT(std::abs(edited.Section[v] / std::abs(edited.Section[v]) - power), 1e-9);
    }
  }
  wanted.pop_back();
  try
  {
    editor.Edit(wanted, {}, {});
    FAIL();
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_NE(
      std::string(error.what()).find("add up to " + std::to_string(needed - 1)), std::string::npos)
      << error.what();
    EXPECT_NE(std::string(error.what()).find("must add up to " + std::to_string(needed)),
      std::string::npos);
  }
}

/// A boundary and a hole are groups of their own: how far the field turns from one to the other is chosen.
TEST(PrescribedRotation, KeepsDirectionsOfSeveralBoundaries)
{
  const Surface plate = Meshes::PlateWithHole(48, 10, 0.4, false);
  Options options;
  options.ConstrainBoundary = true;
  options.ConstrainSharpEdges = true;
  const Result base = DirectionField(plate).Compute(options);
  SingularityEditor editor(plate, Fields::Of(base), base.ConstraintDirection);
  for (const auto objective : { RotationObjective::Smoothest, RotationObjective::LeastChange })
  {
    EditOptions edit = Placements::With(objective);
    edit.AddsToBase = true;
    const EditedField edited =
      editor.Edit({ { Vector3(0.7, 0.1, 0), 1 }, { Vector3(-0.7, 0.1, 0), -1 } }, edit, {});
    EXPECT_TRUE(edited.WrongTriangles.empty());
    const GivenField& given = editor.GetBase();
    for (Index v = 0; v < given.GetMesh().GetNumberOfVertices(); ++v)
    {
      const Vector3& direction = base.ConstraintDirection[given.GetMesh().Point(v)];
      if (!direction.isZero())
      {
        const Complex at = given.GetGeometry().Frames.Tangential(v, direction.normalized());
        const Complex power = IntegerPower(at / std::abs(at), 4);
        EXPECT_LT(std::abs(edited.Section[v] / std::abs(edited.Section[v]) - power), 1e-9);
      }
    }
  }
}

TEST(PrescribedRotation, IsDrawnToAGuidanceWithoutMovingSingularities)
{
  const Surface potato = Meshes::Potato(4);
  const Result base = Fields::Compute(potato, 4);
  Options options;
  options.Alignment = Alignment::PrincipalCurvature;
  const Result aligned = DirectionField(potato).Compute(options);
  SingularityEditor editor(potato, Fields::Of(base));
  std::vector<Complex> guidance = GivenField(potato, Fields::Of(aligned)).GetSection();
  editor.SetGuidance(guidance);
  const auto wanted = Placements::Of(potato, base);
  const auto deviation = [&](double strength)
  {
    EditOptions edit;
    edit.AlignmentStrength = strength;
    const EditedField edited = editor.Edit(wanted, edit, {});
    EXPECT_TRUE(edited.WrongTriangles.empty());
    double sum = 0.0;
    for (std::size_t v = 0; v < guidance.size(); ++v)
    {
      sum += std::abs(std::arg(edited.Section[v] * std::conj(guidance[v])));
    }
    return sum / static_cast<double>(guidance.size()) * 45.0 / Pi;
  };
  const double none = deviation(0.0);
  const double some = deviation(0.5);
  const double strong = deviation(0.9);
  std::cout << "mean deviation: " << none << ", " << some << ", " << strong << " degrees\n";
  EXPECT_LT(some, none);
  EXPECT_LT(strong, some);
}

/// Both sides of a strip that cannot be oriented show the same directions.
TEST(PrescribedRotation, IsTheSameOnBothSidesOfSurfacesThatCannotBeOriented)
{
  for (const Surface& surface :
    { Meshes::MoebiusStrip(48, 8), Meshes::KleinBottle(48, 24), Meshes::ProjectivePlane(4) })
  {
    const Result base = Fields::Compute(surface, 4);
    SingularityEditor editor(surface, Fields::Of(base));
    const TriangleMesh& mesh = editor.GetBase().GetMesh();
    const TriangleMesh::Component& component = mesh.GetComponents()[0];
    ASSERT_TRUE(component.IsCover);
    std::mt19937 random(8);
    const auto wanted =
      Placements::Random(surface, 4 * base.Components[0].EulerCharacteristic, 1, random);
    const EditedField edited = editor.Edit(wanted, {}, {});
    EXPECT_TRUE(edited.WrongTriangles.empty());
    const DoubleCover cover(editor.GetBase().GetGeometry(), component, 4);
    for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      const Complex there = edited.Section[mesh.MirrorVertex(v)];
      EXPECT_LT(std::abs(cover.Mirrored(v, edited.Section[v]) / std::abs(edited.Section[v]) -
                  there / std::abs(there)),
        1e-6);
    }
  }
}
