// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Finishing/UprightFaces.h"

#include <algorithm>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// More faces than this, or than a part of all, are not single ones.
constexpr Index MostSingle = 10;
constexpr Index PartSingle = 100;
/// The scaled Jacobian of faces that are as bad as one that is turned over.
constexpr double Bad = 0.2;

/// What is wrong with a mesh.
struct Flaws
{
  Flaws(const FaceMesh& mesh, Index turned)
    : Count(turned)
  {
    for (const Faces::Face& face : mesh.Cells.Corners)
    {
      const double quality = ScaledJacobian(mesh.Points, face);
      this->Count += quality < Bad ? 1 : 0;
      this->LeastQuality = std::min(this->LeastQuality, quality);
    }
  }

  /// Whether there are a third less, or at least no more and no worse faces.
  bool AreLessThan(const Flaws& others) const
  {
    return 3 * this->Count <= 2 * others.Count ||
      (this->Count <= others.Count && this->LeastQuality >= others.LeastQuality);
  }

  Index Count;
  double LeastQuality = 1.0;
};
}

UprightFaces FinishUpright(FaceMesh& mesh, const FinishedFaces& wanted,
  const SurfaceContext& context, const FeatureLines& features, const Progress& progress)
{
  FaceMesh unfinished = context.Patches ? FaceMesh() : mesh;
  const auto countTurned = [&](const FaceMesh& counted, const SurfacePatches* patches)
  {
    return CountTurned(
      counted, context.Prepared, context.Triangles, features, wanted.EdgeLength, patches);
  };
  UprightFaces result;
  result.Boundary = FinishFaces(mesh, wanted, context, progress.Part(0.0, 0.6));
  result.Turned = countTurned(mesh, context.Patches);
  const Index most =
    std::min(MostSingle, static_cast<Index>(mesh.Cells.Corners.size()) / PartSingle);
  if (context.Patches || result.Turned == 0 || result.Turned > most || wanted.Steps == 0)
  {
    return result;
  }
  const SurfacePatches patches(context.Prepared, features, wanted.EdgeLength);
  SurfaceContext divided = context;
  divided.Patches = &patches;
  UprightFaces other;
  other.Boundary = FinishFaces(unfinished, wanted, divided, progress.Part(0.6, 1.0));
  other.Turned = countTurned(unfinished, &patches);
  if (Flaws(unfinished, other.Turned).AreLessThan(Flaws(mesh, result.Turned)))
  {
    mesh = std::move(unfinished);
    result = other;
  }
  return result;
}
}
