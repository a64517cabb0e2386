// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "PrescribedSingularities/SingularityEditor.h"

#include "Fields/PrescribedSingularities/Placements.h"
#include "Meshes/Fields.h"
#include "Meshes/Surfaces.h"
#include "Sections/Singularities.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <utility>

using namespace DirectionFields;

TEST(SingularityEditor, TheIndicesAreThoseAskedFor)
{
  std::mt19937 random(5);
  for (const auto& [surface, euler] : { std::pair(Meshes::Potato(4), 2),
         std::pair(Meshes::Torus(60, 30), 0), std::pair(Meshes::Disk(24), 1) })
  {
    for (const int degree : { 2, 4 })
    {
      const Result base = Fields::Compute(surface, degree);
      SingularityEditor editor(surface, DirectionsOf(base));
      // On a disk any sum will do.
      const auto wanted = Placements::Random(surface, degree * euler, 2, random);
      const EditedField edited = editor.Edit(wanted);
      ASSERT_TRUE(edited.WrongTriangles.empty());
      const std::vector<int> indices =
        SingularityIndices(editor.GetBase().GetGeometry(), degree, edited.Section);
      EXPECT_EQ(Placements::Sum(indices), degree * euler);
      EXPECT_EQ(std::count_if(indices.begin(), indices.end(), [](int k) { return k != 0; }),
        static_cast<std::ptrdiff_t>(wanted.size()));
      EXPECT_LT(edited.Components[0].MaximumRotation, 1.0);
      EXPECT_TRUE(edited.Components[0].IsChanged);
    }
  }
}

TEST(SingularityEditor, AnEditStartsFromTheGivenField)
{
  const Surface potato = Meshes::Potato(3);
  const Result base = Fields::Compute(potato, 4);
  std::mt19937 random(6);
  const auto first = Placements::Random(potato, 8, 0, random);
  const auto second = Placements::Random(potato, 8, 1, random);
  SingularityEditor editor(potato, DirectionsOf(base));
  editor.Edit(first);
  SingularityEditor other(potato, DirectionsOf(base));
  EXPECT_EQ(editor.Edit(second).Section, other.Edit(second).Section);
  // An editor can be moved, with all that it keeps.
  const SingularityEditor moved = std::move(editor);
  EXPECT_EQ(moved.GetBase().GetDegree(), 4);
}

TEST(SingularityEditor, OtherComponentsStayAsTheyAre)
{
  const Surface potato = Meshes::Potato(2);
  const Surface both = Meshes::Joined(
    potato, Meshes::Transformed(potato, Eigen::Matrix3d::Identity(), Vector3(10.0, 0.0, 0.0)));
  const Result base = Fields::Compute(both, 4);
  SingularityEditor editor(both, DirectionsOf(base));
  std::mt19937 random(7);
  const EditedField edited = editor.Edit(Placements::Random(potato, 8, 0, random));
  ASSERT_EQ(edited.Components.size(), 2u);
  const TriangleMesh& mesh = editor.GetBase().GetMesh();
  for (std::size_t c = 0; c < 2; ++c)
  {
    const TriangleMesh::Component& component = mesh.GetComponents()[c];
    const bool isFirst = editor.GetBase().GetGeometry().Positions[component.FirstVertex].x() < 5.0;
    EXPECT_EQ(edited.Components[c].IsChanged, isFirst);
    const auto& before = editor.GetBase().GetSection();
    EXPECT_EQ(
      std::equal(before.begin() + component.FirstVertex, before.begin() + component.EndVertex,
        edited.Section.begin() + component.FirstVertex),
      !isFirst);
  }
}

TEST(SingularityEditor, RefusesPlacesThatAreNoneAndSumsThatCannotBe)
{
  const Surface sphere = Meshes::Icosphere(2);
  const Result base = Fields::Compute(sphere, 4);
  SingularityEditor editor(sphere, DirectionsOf(base));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(editor.Edit({ { Vector3(nan, 0.0, 0.0), 1 } }), std::invalid_argument);
  EXPECT_THROW(editor.Edit({ { Vector3::UnitX(), 1 } }), std::invalid_argument);
  // An index of 0 is none.
  EXPECT_EQ(editor.Edit({ { Vector3::UnitX(), 0 } }).Section, editor.GetBase().GetSection());
  const ProgressFunction stop = [](double) { return false; };
  EXPECT_THROW(editor.Edit({ { Vector3::UnitX(), 8 } }, {}, Progress(stop)), Stopped);
}

/// Rough surfaces have singularities close together and large angles, where the smoothest field alone
/// would turn too much for the mesh.
TEST(SingularityEditor, OwnSingularitiesComeBackWhateverTheMesh)
{
  std::vector<Surface> surfaces = { Meshes::Icosphere(3), Meshes::Torus(40, 20), Meshes::Disk(16),
    Meshes::MoebiusStrip(40, 6), Meshes::BadSphere(4, 0.3, 2) };
  for (const unsigned seed : { 1u, 2u, 3u })
  {
    surfaces.push_back(Meshes::Roughened(Meshes::Potato(4), 0.5, seed));
    surfaces.push_back(Meshes::Roughened(Meshes::Torus(60, 30), 0.5, seed));
  }
  Index kept = 0;
  for (const Surface& surface : surfaces)
  {
    for (const int degree : { 1, 2, 4, 6 })
    {
      const Result base = Fields::Compute(surface, degree);
      SingularityEditor editor(surface, DirectionsOf(base));
      const std::vector<WantedSingularity> own = editor.GetOwnSingularities();
      const std::vector<int> before = editor.GetBase().Indices();
      for (const bool adds : { false, true })
      {
        for (const auto objective :
          { RotationObjective::Smoothest, RotationObjective::LeastChange })
        {
          EditOptions options = Placements::With(objective);
          options.AddsToBase = adds;
          const EditedField edited =
            editor.Edit(adds ? std::vector<WantedSingularity>() : own, options);
          EXPECT_TRUE(edited.WrongTriangles.empty());
          EXPECT_TRUE(edited.Notes.empty());
          EXPECT_EQ(
            SingularityIndices(editor.GetBase().GetGeometry(), degree, edited.Section), before);
          kept += !edited.Components.empty() && edited.Components[0].MaximumRotation > 0.999;
        }
      }
    }
  }
  EXPECT_GT(kept, 0);
}

/// Points across seams are one in the mesh where the directions agree there.
TEST(SingularityEditor, KnowsThePointsThatBecameOne)
{
  const Surface sphere = Meshes::Icosphere(2);
  const Result base = Fields::Compute(sphere, 4);
  EXPECT_TRUE(SingularityEditor(sphere, DirectionsOf(base)).GetFirstPoints().empty());
  const Surface soup = Meshes::Soup(sphere);
  const Result ofSoup = Fields::Compute(soup, 4);
  const SingularityEditor editor(soup, DirectionsOf(ofSoup));
  const std::vector<Index>& first = editor.GetFirstPoints();
  ASSERT_EQ(first.size(), soup.Points.size());
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    EXPECT_EQ(soup.Points[i], soup.Points[first[i]]);
  }
  EXPECT_EQ(
    editor.GetBase().GetMesh().GetNumberOfVertices(), static_cast<Index>(sphere.Points.size()));
}
