// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "PrescribedSingularities/SingularityHand.h"

#include "Fields/PrescribedSingularities/Placements.h"
#include "Meshes/Fields.h"
#include "Meshes/Surfaces.h"
#include "PrescribedSingularities/EditedResult.h"
#include "Sections/Singularities.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

using namespace DirectionFields;

namespace
{
using List = std::vector<WantedSingularity>;

int SumOf(const List& list)
{
  int sum = 0;
  for (const WantedSingularity& singularity : list)
  {
    sum += singularity.Index;
  }
  return sum;
}

EditOptions WholeList()
{
  EditOptions options;
  options.Objective = RotationObjective::LeastChange;
  options.IsWholeList = true;
  options.KeepsUnmet = true;
  return options;
}

/// The indices of the field that an edit gives.
std::vector<int> IndicesOf(SingularityEditor& editor, const List& list)
{
  const EditedField edited = editor.Edit(list, WholeList());
  EXPECT_TRUE(edited.Notes.empty()) << edited.Notes.front();
  return SingularityIndices(
    editor.GetBase().GetGeometry(), editor.GetBase().GetDegree(), edited.Section);
}

std::ptrdiff_t Number(const std::vector<int>& indices)
{
  return std::count_if(indices.begin(), indices.end(), [](int index) { return index != 0; });
}

/// A flat square of n x n cells, (0, 0) to (n, n), each cut in two.
Surface Square(Index n)
{
  Surface square;
  for (Index j = 0; j <= n; ++j)
  {
    for (Index i = 0; i <= n; ++i)
    {
      square.Points.emplace_back(i, j, 0.0);
    }
  }
  for (Index j = 0; j < n; ++j)
  {
    for (Index i = 0; i < n; ++i)
    {
      const Index a = j * (n + 1) + i;
      square.Triangles.push_back({ a, a + 1, a + n + 2 });
      square.Triangles.push_back({ a, a + n + 2, a + n + 1 });
    }
  }
  return square;
}
}

TEST(SingularityHand, EachStepIsAListThatTheFieldCanHave)
{
  const Surface potato = Meshes::Potato(4);
  const Result base = Fields::Compute(potato, 4);
  SingularityEditor editor(potato, DirectionsOf(base));
  const SingularityHand hand(potato);
  const List own = editor.GetOwnSingularities();
  ASSERT_EQ(SumOf(own), 8);

  const Vector3 place = potato.Points[potato.Points.size() / 3];
  const HandStep moved = hand.Move(own, 2, place);
  ASSERT_TRUE(moved.IsDone && moved.Note.empty()) << moved.Note;
  ASSERT_EQ(moved.Singularities.size(), own.size());
  for (std::size_t k = 0; k < own.size(); ++k)
  {
    EXPECT_EQ(moved.Singularities[k].Index, own[k].Index);
    EXPECT_LT((moved.Singularities[k].Position - (k == 2 ? place : own[k].Position)).norm(), 1e-9);
  }
  EXPECT_EQ(Number(IndicesOf(editor, moved.Singularities)), own.size());

  const HandStep added = hand.AddPair(moved.Singularities, potato.Points.back(), -1);
  ASSERT_TRUE(added.IsDone);
  ASSERT_EQ(added.Singularities.size(), own.size() + 2);
  EXPECT_EQ(SumOf(added.Singularities), 8);
  EXPECT_EQ(added.Singularities[own.size()].Index, -1);
  EXPECT_EQ(Number(IndicesOf(editor, added.Singularities)), own.size() + 2);

  // The new ones are each other's nearest of opposite sign.
  const HandStep merged = hand.Merge(added.Singularities, own.size() + 1);
  ASSERT_TRUE(merged.IsDone);
  ASSERT_EQ(merged.Singularities.size(), own.size());
  for (std::size_t k = 0; k < own.size(); ++k)
  {
    EXPECT_EQ(merged.Singularities[k].Position, moved.Singularities[k].Position);
  }
  EXPECT_NE(merged.Note.find("both are gone"), std::string::npos) << merged.Note;
}

TEST(SingularityHand, APairComesWhereNoOtherIs)
{
  const Surface square = Square(20);
  const SingularityHand hand(square);
  const Vector3 place(9.3, 9.1, 0.0);
  const Vector3 partner = hand.AddPair({}, place, 1).Singularities[1].Position;
  const HandStep added = hand.AddPair({ { partner, 1 } }, place, 1);
  ASSERT_EQ(added.Singularities.size(), 3u);
  EXPECT_GT((added.Singularities[2].Position - partner).norm(), 0.1);
}

TEST(SingularityHand, MergesAlongTheSurfaceAndNotThroughIt)
{
  // Two sheets, one close over the other, that are joined far away at x = 10.
  Surface sheets = Square(20);
  for (Vector3& point : sheets.Points)
  {
    const double x = point.x();
    point.x() = x <= 10.0 ? x : 20.0 - x;
    point.z() = x <= 10.0 ? 0.0 : 0.5;
  }
  const SingularityHand hand(sheets);
  const List list = { { Vector3(1.0, 10.3, 0.0), 1 }, { Vector3(1.0, 10.3, 0.5), -1 },
    { Vector3(4.0, 10.3, 0.0), -1 } };
  const HandStep merged = hand.Merge(list, 0);
  ASSERT_EQ(merged.Singularities.size(), 1u);
  EXPECT_EQ(merged.Singularities[0].Position, list[1].Position);
}

TEST(SingularityHand, TheSumStaysWhereIndicesDiffer)
{
  const Surface square = Square(12);
  const SingularityHand hand(square);
  const List list = { { Vector3(2.3, 2.1, 0.0), -2 }, { Vector3(5.3, 5.1, 0.0), 1 } };
  const HandStep merged = hand.Merge(list, 0);
  ASSERT_TRUE(merged.IsDone);
  ASSERT_EQ(merged.Singularities.size(), 1u);
  EXPECT_EQ(merged.Singularities[0].Index, -1);
  EXPECT_EQ(merged.Singularities[0].Position, list[1].Position);
  EXPECT_NE(merged.Note.find("is -1 now"), std::string::npos) << merged.Note;
}

TEST(SingularityHand, ClosedPartsKeepTheirSum)
{
  const Surface sphere = Meshes::Icosphere(3);
  const Surface both = Meshes::Joined(
    sphere, Meshes::Transformed(sphere, Eigen::Matrix3d::Identity(), Vector3(5.0, 0.0, 0.0)));
  const SingularityHand hand(both);
  List list;
  for (std::size_t t = 0; t < 8; ++t)
  {
    list.push_back({ Placements::Middle(sphere, 100 * t), 1 });
  }
  for (const HandStep& step : { hand.Move(list, 0, Vector3(5.0, 1.0, 0.0)),
         hand.Add(list, Vector3(1.0, 0.0, 0.0), 1), hand.Merge(list, 3) })
  {
    EXPECT_FALSE(step.IsDone);
    EXPECT_EQ(step.Singularities.size(), list.size());
    EXPECT_EQ(step.Singularities[0].Position, list[0].Position);
    EXPECT_NE(step.Note.find("add up to"), std::string::npos) << step.Note;
  }
  EXPECT_NE(hand.Merge(list, 3).Note.find("add up to 8"), std::string::npos);
}

TEST(SingularityHand, IndicesComeAndGoThroughAFreeBoundary)
{
  const Surface square = Square(12);
  const SingularityHand hand(square);
  const HandStep added = hand.Add({}, Vector3(3.2, 3.1, 4.0), 1);
  ASSERT_TRUE(added.IsDone);
  EXPECT_EQ(added.Singularities[0].Position, Vector3(3.2, 3.1, 0.0));
  const HandStep merged = hand.Merge(added.Singularities, 0);
  ASSERT_TRUE(merged.IsDone);
  // That nothing is left is a list, too.
  ASSERT_EQ(merged.Singularities.size(), 1u);
  EXPECT_EQ(merged.Singularities[0].Index, 0);

  // Constrained directions close the boundary, and part the square along a line.
  std::vector<Vector3> constraints(square.Points.size(), Vector3::Zero());
  for (std::size_t i = 0; i < square.Points.size(); ++i)
  {
    const Vector3& point = square.Points[i];
    const bool isBorder =
      point.x() == 0.0 || point.x() == 12.0 || point.y() == 0.0 || point.y() == 12.0;
    constraints[i] = Vector3(isBorder || point.x() == 6.0 ? 1.0 : 0.0, 0.0, 0.0);
  }
  const SingularityHand parted(square, constraints);
  EXPECT_FALSE(parted.Add({}, Vector3(3.2, 3.1, 0.0), 1).IsDone);
  const List pair = { { Vector3(2.2, 3.1, 0.0), 1 }, { Vector3(8.2, 3.1, 0.0), -1 } };
  EXPECT_FALSE(parted.Move(pair, 0, pair[1].Position).IsDone);
  EXPECT_TRUE(parted.Move(pair, 0, Vector3(4.2, 7.1, 0.0)).IsDone);
  EXPECT_FALSE(parted.Merge(pair, 0).IsDone);
}

TEST(SingularityHand, SurfacesThatCannotBeOrientedAreTheSameOnBothSides)
{
  const Surface strip = Meshes::MoebiusStrip(40, 6);
  const SingularityHand hand(strip);
  // The second one is nearest the long way round, from the other side.
  const HandStep added = hand.AddPair({}, Placements::Middle(strip, 3), 1);
  ASSERT_TRUE(added.IsDone);
  EXPECT_EQ(SumOf(added.Singularities), 0);
  EXPECT_EQ(hand.Merge(added.Singularities, 0).Singularities[0].Index, 0);
}

TEST(SingularityHand, WhatIsNoPlaceChangesNothing)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Surface square = Square(4);
  const SingularityHand hand(square);
  const List list = { { Vector3(1.2, 1.1, 0.0), 1 } };
  const Surface nothing;
  const SingularityHand none(nothing);
  const Vector3 there(nan, 0.0, 0.0);
  for (const HandStep& step : { hand.Move(list, 0, there), hand.Move(list, 1, Vector3::Zero()),
         hand.Merge(list, 7), hand.Add(list, there, 1), hand.Add(list, Vector3::Zero(), 0),
         hand.AddPair(list, there, 1), none.Move(list, 0, Vector3::Zero()), none.Merge(list, 0),
         none.Add(list, Vector3::Zero(), 1), none.AddPair(list, Vector3::Zero(), 1) })
  {
    EXPECT_FALSE(step.IsDone);
    EXPECT_FALSE(step.Note.empty());
    EXPECT_EQ(step.Singularities.size(), 1u);
  }
}

TEST(SingularityEditor, AWholeListLeavesNoOtherSingularities)
{
  const Surface torus = Meshes::Torus(60, 30);
  const Result computed = Fields::Compute(torus, 4);
  SingularityEditor singular(torus, DirectionsOf(computed));
  const Result base = ToResult(singular, singular.Edit({ { torus.Points[0], 0 } }, WholeList()));
  SingularityEditor smooth(torus, DirectionsOf(base));
  ASSERT_FALSE(singular.GetOwnSingularities().empty());
  ASSERT_TRUE(smooth.GetOwnSingularities().empty());
  EXPECT_EQ(smooth.Edit({}, WholeList()).Section, smooth.GetBase().GetSection());

  // A field with two, both of which are to go.
  const SingularityHand hand(torus);
  const HandStep pair = hand.AddPair({}, torus.Points[7], 1);
  const EditedField edited = smooth.Edit(pair.Singularities, WholeList());
  const Result given = ToResult(smooth, edited);
  SingularityEditor editor(torus, DirectionsOf(given));
  ASSERT_EQ(editor.GetOwnSingularities().size(), 2u);
  const HandStep gone = hand.Merge(editor.GetOwnSingularities(), 0);
  EXPECT_EQ(Number(IndicesOf(editor, gone.Singularities)), 0);
  // Without the flag a list without singularities keeps the field.
  EXPECT_EQ(editor.Edit(gone.Singularities).Section, editor.GetBase().GetSection());
}

TEST(SingularityEditor, WhatCannotBeMetKeepsTheFieldOfItsComponent)
{
  const Surface potato = Meshes::Potato(3);
  const Surface both = Meshes::Joined(
    potato, Meshes::Transformed(potato, Eigen::Matrix3d::Identity(), Vector3(10.0, 0.0, 0.0)));
  const Result base = Fields::Compute(both, 4);
  SingularityEditor editor(both, DirectionsOf(base));
  List list = editor.GetOwnSingularities();
  const bool isFirst = list.front().Position.x() < 5.0;
  list.front().Index = 2;
  const SingularityHand hand(both);
  list = hand.Move(list, list.size() - 1, both.Points[isFirst ? both.Points.size() - 9 : 9])
           .Singularities;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  list.push_back({ Vector3(0.0, nan, 0.0), 1 });
  EXPECT_THROW(editor.Edit(list), std::invalid_argument);
  const EditedField edited = editor.Edit(list, WholeList());
  ASSERT_EQ(edited.Notes.size(), 2u);
  EXPECT_NE(edited.Notes[0].find("not finite"), std::string::npos);
  EXPECT_NE(edited.Notes[1].find("add up to 9"), std::string::npos) << edited.Notes[1];
  EXPECT_EQ(edited.Components[0].IsUnmet, isFirst);
  EXPECT_EQ(edited.Components[1].IsUnmet, !isFirst);
  EXPECT_EQ(edited.Components[0].IsChanged, !isFirst);
  EXPECT_EQ(edited.Components[1].IsChanged, isFirst);
}
