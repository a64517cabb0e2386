// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "PrescribedSingularities/EditedResult.h"

#include "Fields/PrescribedSingularities/Placements.h"
#include "Meshes/Fields.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <stdexcept>

using namespace DirectionFields;

/// Read back from its directions the result is the edited section, and its indices are those asked for.
TEST(EditedResult, HasTheSectionsDirectionsAndIndices)
{
  for (const Surface& surface : { Meshes::Potato(3), Meshes::Soup(Meshes::Potato(2)) })
  {
    const Result base = Fields::Compute(surface, 4);
    SingularityEditor editor(surface, DirectionsOf(base));
    std::mt19937 random(3);
    const auto wanted = Placements::Random(surface, 8, 1, random);
    const EditedField edited = editor.Edit(wanted);
    const Result result = ToResult(editor, edited);
    EXPECT_EQ(result.Degree, 4);
    ASSERT_EQ(result.SingularityIndex.size(), surface.Triangles.size());
    EXPECT_EQ(Placements::Sum(result.SingularityIndex), 8);
    const GivenField again(surface, DirectionsOf(result));
    ASSERT_EQ(again.GetSection().size(), edited.Section.size());
    for (std::size_t v = 0; v < edited.Section.size(); ++v)
    {
      EXPECT_LT(std::abs(again.GetSection()[v] - edited.Section[v]), 1e-9);
    }
    EXPECT_EQ(result.Repaired.MergedPoints,
      static_cast<Index>(surface.Points.size() - edited.Section.size()));
  }
}

TEST(EditedResult, GuidanceIsTheSectionOfTheVectors)
{
  const Surface square = Meshes::Square(8);
  const Result base = Fields::Compute(square, 4);
  const SingularityEditor editor(square, DirectionsOf(base));
  Options options;
  options.Alignment = Alignment::PointVectors;
  const double angle = 0.3;
  Guidance guidance;
  guidance.Vectors.assign(
    square.Points.size(), 2.0 * Vector3(std::cos(angle), std::sin(angle), 0.0));
  std::vector<std::string> notes;
  const std::vector<Complex> section = GuidanceFor(editor, options, guidance, notes);
  ASSERT_EQ(section.size(), square.Points.size());
  EXPECT_TRUE(notes.empty());
  const SurfaceGeometry& geometry = editor.GetBase().GetGeometry();
  for (Index v = 0; v < geometry.Mesh.GetNumberOfVertices(); ++v)
  {
    const Complex along = geometry.Frames.Tangential(v, guidance.Vectors[0].normalized());
    EXPECT_NEAR(std::arg(section[v] * std::conj(std::pow(along, 4))), 0.0, 1e-9);
  }
}

TEST(EditedResult, GuidanceIsEmptyWithANoteWhereItVanishes)
{
  const Surface square = Meshes::Square(8);
  const Result base = Fields::Compute(square, 3);
  const SingularityEditor editor(square, DirectionsOf(base));
  Options options;
  options.Degree = 3;
  std::vector<std::string> notes;
  EXPECT_TRUE(GuidanceFor(editor, options, {}, notes).empty());
  EXPECT_TRUE(notes.empty());
  options.Alignment = Alignment::PointVectors;
  Guidance zero;
  zero.Vectors.assign(square.Points.size(), Vector3::Zero());
  EXPECT_TRUE(GuidanceFor(editor, options, zero, notes).empty());
  EXPECT_EQ(notes.size(), 1u);
  options.Alignment = Alignment::PrincipalCurvature;
  EXPECT_THROW(GuidanceFor(editor, options, {}, notes), std::invalid_argument);
}
