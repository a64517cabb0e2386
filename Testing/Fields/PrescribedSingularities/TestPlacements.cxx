// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/ClosestPoints.h"
#include "Fields/PrescribedSingularities/Placements.h"
#include "Fields/PrescribedSingularities/Representable.h"
#include "Meshes/Fields.h"
#include "Meshes/Surfaces.h"
#include "Sections/Singularities.h"

#include <gtest/gtest.h>

#include <iostream>
#include <random>
#include <string>
#include <vector>

using namespace DirectionFields;

namespace
{
/// The index that each triangle of the mesh is asked for, on the front.
std::vector<int> AskedFor(const SingularityEditor& editor, const Surface& surface,
  const std::vector<WantedSingularity>& all)
{
  std::vector<int> indices(surface.Triangles.size(), 0);
  const ClosestPoints nearest(surface);
  for (const WantedSingularity& wanted : all)
  {
    indices[nearest.Find(wanted.Position).Triangle] += wanted.Index;
  }
  std::vector<int> front(editor.GetBase().GetMesh().GetNumberOfTriangles(), 0);
  for (std::size_t t = 0; t < indices.size(); ++t)
  {
    front[editor.GetBase().GetMeshTriangles()[t]] = indices[t];
  }
  return front;
}

struct Counts
{
  int Placements = 0;
  int Right = 0;
  int Silent = 0;
  /// Placements that no field on this mesh has.
  int Impossible = 0;
};

/// Gives the other side of a cover the indices of the front.
void MirrorIndices(const TriangleMesh& mesh, std::vector<int>& indices)
{
  for (Index t = 0; t < static_cast<Index>(indices.size()); ++t)
  {
    if (!mesh.IsFront(t))
    {
      indices[t] = indices[mesh.Mirror(3 * t) / 3];
    }
  }
}

/// Random placements on a surface, for all degrees.
Counts TryPlacements(const std::string& name, const Surface& surface, int rounds)
{
  Counts counts;
  std::mt19937 random(7);
  for (const int degree : { 1, 2, 3, 4, 5, 6 })
  {
    const Result base = Fields::Compute(surface, degree);
    const bool isClosed = base.Components[0].Closed;
    const int sum = base.Components[0].EulerCharacteristic * degree;
    SingularityEditor editor(surface, Fields::Of(base));
    for (int round = 0; round < rounds; ++round)
    {
      const auto wanted =
        Placements::Random(surface, isClosed ? sum : sum - 1 + round % 3, 1 + round % 3, random);
      const std::vector<int> asked = AskedFor(editor, surface, wanted);
      const EditedField edited = editor.Edit(wanted, {}, {});
      const std::vector<int> got =
        SingularityIndices(editor.GetBase().GetGeometry(), degree, edited.Section);
      int wrong = 0;
      for (std::size_t t = 0; t < got.size(); ++t)
      {
        wrong += editor.GetBase().GetMesh().IsFront(static_cast<Index>(t)) && got[t] != asked[t];
      }
      ++counts.Placements;
      counts.Right += wrong == 0 ? 1 : 0;
      if (wrong > 0)
      {
        std::vector<int> both = asked;
        MirrorIndices(editor.GetBase().GetMesh(), both);
        counts.Impossible +=
          Placements::Flow(editor.GetBase().GetGeometry(), degree, both, 0.995 * Pi).IsFeasible()
          ? 0
          : 1;
      }
      counts.Silent += wrong != static_cast<int>(edited.WrongTriangles.size());
      for (const Complex& value : edited.Section)
      {
        EXPECT_TRUE(std::isfinite(std::abs(value)));
      }
    }
  }
  std::cout << name << ": " << counts.Right << " of " << counts.Placements << ", "
            << counts.Impossible << " cannot be\n";
  return counts;
}
}

TEST(PrescribedRotation, RandomPlacementsHaveTheIndicesThatAreAskedFor)
{
  struct Named
  {
    const char* Name;
    Surface Mesh;
  };
  const std::vector<Named> meshes = { { "sphere", Meshes::Icosphere(4) },
    { "potato", Meshes::Potato(4) }, { "torus", Meshes::Torus(64, 32) },
    { "genus 2", Meshes::FlatlySubdivided(Meshes::DoubleTorus(), 2) }, { "disk", Meshes::Disk(16) },
    { "cylinder", Meshes::Cylinder(48, 16, 2.0) }, { "hemisphere", Meshes::Hemisphere(4) },
    { "chamfered cube", Meshes::ChamferedCube(12) },
    { "slivers", Meshes::Scrambled(Meshes::ChamferedCube(10), 5) },
    { "plate", Meshes::PlateWithHole(48, 12, 0.4, true) },
    { "Moebius strip", Meshes::MoebiusStrip(60, 8) },
    { "Klein bottle", Meshes::KleinBottle(64, 32) } };
  Counts all;
  for (const Named& mesh : meshes)
  {
    const Counts counts = TryPlacements(mesh.Name, mesh.Mesh, 7);
    all.Placements += counts.Placements;
    all.Right += counts.Right;
    all.Silent += counts.Silent;
    all.Impossible += counts.Impossible;
  }
  const int possible = all.Placements - all.Impossible;
  std::cout << all.Right << " of " << possible << " placements that the meshes can represent, of "
            << all.Placements << ", have all indices right\n";
  EXPECT_GE(all.Placements, 500);
  EXPECT_EQ(all.Silent, 0);
  EXPECT_GE(all.Right, 0.975 * possible);
}
