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
/// Faces with a lower scaled Jacobian are flaws, too.
constexpr double Bad = 0.2;

/// The faces of a mesh that are turned over or bad.
struct Flaws
{
  Flaws(const FaceMesh& mesh, Index turned)
    : Turned(turned)
    , Count(turned)
  {
    for (const Faces::Face& face : mesh.Cells.Corners)
    {
      const double quality = ScaledJacobian(mesh.Points, face);
      this->Count += quality >= Bad ? 0 : 1;
      this->LeastQuality = std::min(this->LeastQuality, quality);
    }
  }

  /// Whether no more faces are turned over, and a third fewer are flawed, or no more and the worst
  /// one is no worse.
  bool AreLessThan(const Flaws& others) const
  {
    return this->Turned <= others.Turned &&
      (3 * this->Count <= 2 * others.Count ||
        (this->Count <= others.Count && this->LeastQuality >= others.LeastQuality));
  }

  Index Turned;
  Index Count;
  double LeastQuality = 1.0;
};
}

UprightFaces FinishUpright(FaceMesh& mesh, const FinishedFaces& wanted,
  const SurfaceContext& context, const FeatureLines& features, const Progress& progress)
{
  const bool mayRepeat = !context.Patches && wanted.Steps > 0;
  FaceMesh unfinished = mayRepeat ? mesh : FaceMesh();
  const auto countTurned = [&](const FaceMesh& counted, const SurfacePatches* patches)
  {
    return CountTurned(
      counted, context.Prepared, context.Triangles, features, wanted.EdgeLength, patches);
  };
  UprightFaces result;
  result.Boundary = FinishFaces(mesh, wanted, context, progress.Part(0.0, mayRepeat ? 0.6 : 1.0));
  result.Turned = countTurned(mesh, context.Patches);
  const Index most =
    std::min(MostSingle, static_cast<Index>(mesh.Cells.Corners.size()) / PartSingle);
  if (!mayRepeat || result.Turned == 0 || result.Turned > most)
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
