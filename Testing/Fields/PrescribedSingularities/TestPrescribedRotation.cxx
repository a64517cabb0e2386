// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Fields/PrescribedSingularities/Placements.h"
#include "Meshes/Fields.h"
#include "Meshes/Surfaces.h"
#include "PrescribedSingularities/SingularityTargets.h"
#include "Sections/Singularities.h"
#include "Support/Threads.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

using namespace DirectionFields;

namespace
{
/// The corners of a cube on the unit sphere.
std::vector<WantedSingularity> CubeCorners()
{
  std::vector<WantedSingularity> corners;
  for (int k = 0; k < 8; ++k)
  {
    corners.push_back({ Vector3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1).normalized(), 1 });
  }
  return corners;
}

/// Rotation of a section along all edges, from its phases.
double LargestDifference(const SingularityEditor& one, const EditedField& a, const EditedField& b)
{
  const SurfaceGeometry& geometry = one.GetBase().GetGeometry();
  double largest = 0.0;
  for (const TriangleMesh::Component& component : geometry.Mesh.GetComponents())
  {
    const auto first = PhaseDifferences(
      geometry, component, one.GetBase().GetDegree(), a.Section.data() + component.FirstVertex);
    const auto second = PhaseDifferences(
      geometry, component, one.GetBase().GetDegree(), b.Section.data() + component.FirstVertex);
    for (std::size_t e = 0; e < first.size(); ++e)
    {
      largest = std::max(largest, std::abs(first[e] - second[e]));
    }
  }
  return largest;
}

/// The sums of the rotation around all triangles against 2 pi k - Omega, for a target of a component.
double LargestDefect(const SurfaceGeometry& geometry, const TriangleMesh::Component& component,
  int degree, const TrivialConnection& rotation, const RotationTarget& target,
  const TurnedField& field)
{
  double largest = 0.0;
  for (Index t = 0; t < component.Triangles(); ++t)
  {
    const double wanted = 2.0 * Pi * target.Indices[t] -
      degree * geometry.Transport.Curvature[component.FirstTriangle + t];
    largest = std::max(largest,
      std::abs(rotation.GetForms().Around(field.Rotation, component.FirstTriangle + t) - wanted));
  }
  return largest;
}
}

TEST(PrescribedRotation, SumsUpToTheIndexLessTheHolonomyAroundEachTriangle)
{
  std::mt19937 random(4);
  for (const Surface& surface : { Meshes::Potato(3), Meshes::Torus(32, 16), Meshes::Disk(9),
         Meshes::FlatlySubdivided(Meshes::DoubleTorus(), 1), Meshes::KleinBottle(32, 16) })
  {
    for (const int degree : { 1, 2, 4, 6 })
    {
      const Result base = Fields::Compute(surface, degree);
      const GivenField given(surface, Fields::Of(base));
      const SurfaceGeometry& geometry = given.GetGeometry();
      const TriangleMesh::Component& component = geometry.Mesh.GetComponents()[0];
      TrivialConnection rotation(geometry, component, degree, given.GetSection(), {});
      for (const auto objective : { RotationObjective::Smoothest, RotationObjective::LeastChange })
      {
        std::vector<PrescribedSingularity> wanted;
        std::uniform_int_distribution<Index> triangles(0, component.Triangles() - 1);
        for (const int index : { 1, -1, 1, -1 })
        {
          Index t = triangles(random);
          while (!geometry.Mesh.IsFront(t))
          {
            t = triangles(random);
          }
          wanted.push_back({ { t, { 0.2, 0.3, 0.5 } }, index });
        }
        EditOptions options = Placements::With(objective);
        options.AddsToBase = true;
        std::vector<std::string> notes;
        const RotationTarget target = MakeTarget(
          geometry, component, degree, rotation, geometry.Positions, wanted, options, notes);
        const TurnedField field = rotation.Turn(target, {});
        EXPECT_LT(LargestDefect(geometry, component, degree, rotation, target, field), 1e-9);
      }
    }
  }
}

TEST(PrescribedRotation, CrossesOnTheSphereTurnLeastAroundTheCornersOfACube)
{
  const Surface sphere = Meshes::Icosphere(4);
  const Result base = Fields::Compute(sphere, 4);
  SingularityEditor editor(sphere, Fields::Of(base));
  const double cube = editor.Edit(CubeCorners(), {}, {}).Components[0].Energy;
  const double own = editor.Edit(Placements::Of(sphere, base), {}, {}).Components[0].Energy;
  std::cout << "energy: cube " << cube << ", smoothest field's " << own << "\n";
  EXPECT_LT(cube, own);
  std::mt19937 random(1);
  for (int k = 0; k < 10; ++k)
  {
    EXPECT_LT(
      cube, editor.Edit(Placements::Random(sphere, 8, 0, random), {}, {}).Components[0].Energy);
  }
}

/// A trivial connection is known in closed form where two singularities sit at the poles: parallel to the meridians.
TEST(PrescribedRotation, IsTheTrivialConnectionOfTwoPolesOnASphere)
{
  for (const int levels : { 3, 4, 5 })
  {
    const Surface sphere = Meshes::Icosphere(levels);
    const Result base = Fields::Compute(sphere, 1);
    SingularityEditor editor(sphere, Fields::Of(base));
    const EditedField edited =
      editor.Edit({ { Vector3(0.02, 0.01, 1), 1 }, { Vector3(-0.02, 0.01, -1), 1 } }, {}, {});
    const SurfaceGeometry& geometry = editor.GetBase().GetGeometry();
    // The angle to the meridian is the same everywhere.
    Complex mean = 0.0;
    double weight = 0.0;
    for (Index v = 0; v < geometry.Mesh.GetNumberOfVertices(); ++v)
    {
      const Vector3& p = geometry.Positions[v];
      if (std::abs(p[2]) < 0.8)
      {
        const Complex meridian = geometry.Frames.Tangential(v, Vector3(0, 0, 1));
        mean += edited.Section[v] / std::abs(edited.Section[v]) * std::conj(meridian) /
          std::abs(meridian);
        weight += 1.0;
      }
    }
    const double spread = std::sqrt(2.0 * (1.0 - std::abs(mean) / weight)) * 180.0 / Pi;
    std::cout << levels << ": " << spread << " degrees\n";
    EXPECT_LT(spread, 3.0);
  }
}

TEST(PrescribedRotation, LeastChangeWithTheFieldsOwnIndicesIsTheFieldToTheLastBit)
{
  for (const Surface& surface :
    { Meshes::Potato(3), Meshes::Torus(24, 12), Meshes::Disk(8), Meshes::MoebiusStrip(30, 4) })
  {
    for (const int degree : { 1, 2, 4, 6 })
    {
      const Result base = Fields::Compute(surface, degree);
      SingularityEditor editor(surface, Fields::Of(base));
      const EditedField edited = editor.Edit(
        Placements::Of(surface, base), Placements::With(RotationObjective::LeastChange), {});
      EXPECT_EQ(edited.Section, editor.GetBase().GetSection());
    }
  }
}

TEST(PrescribedRotation, ComponentsWithoutSingularitiesKeepTheirField)
{
  const Surface far =
    Meshes::Transformed(Meshes::Potato(3), Eigen::Matrix3d::Identity(), { 9, 0, 0 });
  const Surface both = Meshes::Joined(Meshes::Icosphere(3), far);
  const Result base = Fields::Compute(both, 4);
  SingularityEditor editor(both, Fields::Of(base));
  const EditedField edited = editor.Edit(CubeCorners(), {}, {});
  const auto& components = editor.GetBase().GetMesh().GetComponents();
  ASSERT_EQ(components.size(), 2u);
  EXPECT_TRUE(edited.Components[0].IsChanged);
  EXPECT_FALSE(edited.Components[1].IsChanged);
  for (Index v = components[1].FirstVertex; v < components[1].EndVertex; ++v)
  {
    EXPECT_EQ(edited.Section[v], editor.GetBase().GetSection()[v]);
  }
}

/// Only the class of the base matters, and on a sphere there is only one.
TEST(PrescribedRotation, DoesNotDependOnTheBase)
{
  const Surface sphere = Meshes::Potato(3);
  const Result smooth = Fields::Compute(sphere, 4);
  Result rough = smooth;
  std::mt19937 random(2);
  std::uniform_real_distribution<double> angle(-Pi, Pi);
  for (Complex& u : rough.Representation)
  {
    u = std::polar(1.0, angle(random));
  }
  SingularityEditor one(sphere, Fields::Of(smooth));
  SingularityEditor other(sphere, Fields::Of(rough));
  const auto wanted = Placements::Random(sphere, 8, 1, random);
  EXPECT_LT(LargestDifference(one, one.Edit(wanted, {}, {}), other.Edit(wanted, {}, {})), 1e-4);
}

TEST(PrescribedRotation, DoesNotDependOnNumberingAndScale)
{
  const Surface potato = Meshes::Potato(3);
  std::vector<Index> newPoint;
  std::vector<Index> newTriangle;
  Surface shuffled = Meshes::Shuffled(potato, 3, newPoint, newTriangle);
  for (Vector3& point : shuffled.Points)
  {
    point *= 1000.0;
  }
  std::mt19937 random(2);
  auto wanted = Placements::Random(potato, 8, 1, random);
  double energy[2];
  const Surface* surfaces[] = { &potato, &shuffled };
  for (int k = 0; k < 2; ++k)
  {
    const Result base = Fields::Compute(*surfaces[k], 4);
    SingularityEditor editor(*surfaces[k], Fields::Of(base));
    energy[k] = editor.Edit(wanted, {}, {}).Components[0].Energy;
    for (WantedSingularity& singularity : wanted)
    {
      singularity.Position *= 1000.0;
    }
  }
  EXPECT_NEAR(energy[0], energy[1], 1e-6 * energy[0]);
}

TEST(PrescribedRotation, HasTheSameBytesForAnyNumberOfThreads)
{
  const Surface surface = Meshes::Torus(128, 64);
  const Result base = Fields::Compute(surface, 4);
  std::mt19937 random(2);
  const auto wanted = Placements::Random(surface, 0, 3, random);
  std::vector<Complex> sections[2];
  for (int k = 0; k < 2; ++k)
  {
    Threads threads(k == 0 ? 1 : 3);
    const Threads::Scope scope(threads);
    SingularityEditor editor(surface, Fields::Of(base));
    sections[k] = editor.Edit(wanted, {}, {}).Section;
  }
  EXPECT_EQ(sections[0], sections[1]);
}

/// Further edits with cached solvers are those of a new editor, and come back to where they began.
TEST(PrescribedRotation, EditsDoNotDependOnThoseBefore)
{
  const Surface surface = Meshes::Torus(48, 24);
  const Result base = Fields::Compute(surface, 4);
  std::mt19937 random(5);
  const auto wanted = Placements::Random(surface, 0, 2, random);
  const auto others = Placements::Random(surface, 0, 3, random);
  SingularityEditor editor(surface, Fields::Of(base));
  const std::vector<Complex> first = editor.Edit(wanted, {}, {}).Section;
  editor.Edit(others, {}, {});
  EXPECT_EQ(first, editor.Edit(wanted, {}, {}).Section);
  SingularityEditor anew(surface, Fields::Of(base));
  EXPECT_EQ(anew.Edit(others, {}, {}).Section, editor.Edit(others, {}, {}).Section);
}

TEST(PrescribedRotation, ChangesContinuouslyWhileASingularityMoves)
{
  const Surface sphere = Meshes::Icosphere(4);
  const Result base = Fields::Compute(sphere, 4);
  SingularityEditor editor(sphere, Fields::Of(base));
  auto wanted = CubeCorners();
  EditedField before;
  double largest = 0.0;
  for (int step = 0; step <= 60; ++step)
  {
    const double angle = 0.005 * step;
    wanted[7].Position = Vector3(std::cos(angle), std::sin(angle), 0.9).normalized();
    EditedField now = editor.Edit(wanted, {}, {});
    EXPECT_TRUE(now.WrongTriangles.empty());
    if (step > 0)
    {
      // Away from the singularity, which is a point where no field is continuous.
      const SurfaceGeometry& geometry = editor.GetBase().GetGeometry();
      for (Index v = 0; v < geometry.Mesh.GetNumberOfVertices(); ++v)
      {
        if ((geometry.Positions[v] - wanted[7].Position).norm() > 0.4)
        {
          largest =
            std::max(largest, std::abs(std::arg(now.Section[v] * std::conj(before.Section[v]))));
        }
      }
    }
    before = std::move(now);
  }
  std::cout << "largest change of the phase in a step: " << largest << "\n";
  EXPECT_LT(largest, 0.06);
}

TEST(PrescribedRotation, RefusesSumsThatCannotBeWithBothNumbers)
{
  const Surface sphere = Meshes::Icosphere(3);
  const Result base = Fields::Compute(sphere, 4);
  SingularityEditor editor(sphere, Fields::Of(base));
  auto wanted = CubeCorners();
  wanted.resize(5);
  try
  {
    editor.Edit(wanted, {}, {});
    FAIL();
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_NE(std::string(error.what()).find("add up to 5"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("must add up to 8"), std::string::npos);
  }
  EditOptions balanced;
  balanced.Balances = true;
  const EditedField edited = editor.Edit(wanted, balanced, {});
  EXPECT_EQ(
    Placements::Sum(SingularityIndices(editor.GetBase().GetGeometry(), 4, edited.Section)), 8);
  EXPECT_TRUE(edited.WrongTriangles.empty());
  // With a boundary there is no such sum.
  const Surface disk = Meshes::Disk(10);
  const Result flat = Fields::Compute(disk, 4);
  SingularityEditor free(disk, Fields::Of(flat));
  for (const int index : { -3, -1, 1, 2 })
  {
    const EditedField on =
      free.Edit({ { Vector3(0.3, 0.2, 0), index }, { Vector3(-0.3, 0.2, 0), 1 } }, {}, {});
    EXPECT_EQ(
      Placements::Sum(SingularityIndices(free.GetBase().GetGeometry(), 4, on.Section)), index + 1);
    EXPECT_TRUE(on.WrongTriangles.empty()) << index;
  }
}

TEST(PrescribedRotation, SpreadsLargeIndicesOverTrianglesNearby)
{
  const Surface sphere = Meshes::Icosphere(4);
  const Result base = Fields::Compute(sphere, 4);
  SingularityEditor editor(sphere, Fields::Of(base));
  const EditedField edited =
    editor.Edit({ { Vector3(0.1, 0.2, 1), 4 }, { Vector3(0.1, 0.2, -1), 4 } }, {}, {});
  EXPECT_TRUE(edited.WrongTriangles.empty());
  const std::vector<int> indices =
    SingularityIndices(editor.GetBase().GetGeometry(), 4, edited.Section);
  EXPECT_EQ(std::count(indices.begin(), indices.end(), 1), 8);
  EXPECT_EQ(edited.Notes.size(), 1u);
}

TEST(PrescribedRotation, TurnsAlongTheLoopsOfATorusAsLittleAsCanBe)
{
  const Surface torus = Meshes::Torus(48, 24);
  for (const int degree : { 1, 2, 4 })
  {
    // A base that turns around both loops, which is far from the least.
    Result base = Fields::Compute(torus, degree);
    for (std::size_t i = 0; i < base.Representation.size(); ++i)
    {
      const Vector3& p = torus.Points[i];
      base.Representation[i] *= std::polar(1.0, 2.0 * std::atan2(p[1], p[0]));
    }
    SingularityEditor editor(torus, Fields::Of(base));
    // A pair that annihilates: the field has no singularity in the end.
    const EditedField edited =
      editor.Edit({ { torus.Points[5], 1 }, { torus.Points[5], -1 } }, {}, {});
    EXPECT_TRUE(edited.WrongTriangles.empty());
    ASSERT_EQ(edited.Components[0].TurningNumbers.size(), 2u);
    // The field of least energy goes with the circles of the torus: it turns against none of them.
    const Result best = Fields::Compute(torus, degree);
    SingularityEditor own(torus, Fields::Of(best));
    const double energy =
      own.Edit({ { torus.Points[5], 1 }, { torus.Points[5], -1 } }, {}, {}).Components[0].Energy;
    EXPECT_NEAR(edited.Components[0].Energy, energy, 1e-5 * energy);
    std::cout << "degree " << degree << ": energy " << energy << ", turning numbers "
              << edited.Components[0].TurningNumbers[0] << " "
              << edited.Components[0].TurningNumbers[1] << "\n";
  }
}
