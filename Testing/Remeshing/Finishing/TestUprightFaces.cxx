// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Meshes/Surfaces.h"
#include "Remesh.h"

#include <gtest/gtest.h>

#include <memory>

using namespace DirectionFields;
using namespace Meshes;

/// A disk with a hub and holes for bolts has corners where faces of two sides meet; vertices that get over an edge
/// there turn a face over, and it is half an edge away from the part.
TEST(UprightFaces, AreAllOfThemBesideTheFeaturesOfAPart)
{
  const auto part = std::make_shared<const Surface>(Flange(1));
  Remesh remesh(part);
  Index turned = 0;
  for (const int faces : { 1000, 1500, 2000, 2500 })
  {
    RemeshOptions options;
    options.NumberOfFaces = faces;
    turned += remesh.Compute(options).TurnedFaces;
  }
  EXPECT_LE(turned, 1);
}
