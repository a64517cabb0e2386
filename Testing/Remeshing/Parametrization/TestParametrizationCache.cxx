// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Parametrization/ParametrizationCache.h"

#include "Meshes/Surfaces.h"
#include "Remeshing/CutExample.h"

#include <gtest/gtest.h>

using namespace DirectionFields;
using Meshes::CutExample;

TEST(ParametrizationCache, MapsAreTheSameWithACachedFactorAsWithAFreshOne)
{
  for (const int degree : { 4, 6 })
  {
    CutExample example = CutExample::Random(Meshes::PlateWithHole(16, 5, 0.4, true), degree, 5);
    ParametrizationCache cache;
    const auto mapFor = [&](double perLength)
    {
      cache.MeshFor(example.Geometry, example.Component, example.Matching, example.Features,
        example.IsFrameless, example.Section);
      const IntegerGridMap::Settings settings = example.Settings(perLength);
      return IntegerGridMap(cache.EnergyFor(settings.PerLength), settings);
    };
    const IntegerGridMap first = mapFor(10.0);
    ASSERT_FALSE(first.GetFailure());
    EXPECT_NE(mapFor(11.0).GetCorners(), first.GetCorners());
    EXPECT_EQ(mapFor(10.0).GetCorners(), first.GetCorners());
    // The factor is released, then all but the mesh.
    cache.Shrink(0.0);
    EXPECT_EQ(mapFor(10.0).GetCorners(), first.GetCorners());
    const IntegerGridMap fresh(example.Mesh, example.Settings(10.0));
    EXPECT_EQ(fresh.GetCorners(), first.GetCorners());
  }
}

TEST(ParametrizationCache, KeepsTheMeshUntilTheFeaturesChange)
{
  CutExample example = CutExample::AlongX(Meshes::Square(6), 4);
  ParametrizationCache cache;
  const auto mesh = [&]() -> const CutMesh&
  {
    return cache.MeshFor(example.Geometry, example.Component, example.Matching, example.Features,
      example.IsFrameless, example.Section);
  };
  const CutMesh* first = &mesh();
  const ParametrizationEnergy* energy = &cache.EnergyFor(example.Settings(20.0).PerLength);
  EXPECT_EQ(&mesh(), first);
  EXPECT_EQ(&cache.EnergyFor(example.Settings(21.0).PerLength), energy);
  const std::size_t isolines = first->Isolines.size();
  EXPECT_EQ(isolines, 24U);
  example.Features.IsFeature[example.Mesh.Isolines.front().Edge] = 0;
  EXPECT_EQ(mesh().Isolines.size(), isolines - 1);
}
