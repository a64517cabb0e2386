// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Solver/DistributedGuide.h"

#include "Guidance/Constraints.h"
#include "Guidance/Guidance.h"
#include "Mesh/MeshPiece.h"
#include "Solver/DistributedCurvature.h"
#include "Solver/PetscObjects.h"

#include <algorithm>
#include <new>

namespace DirectionFields::Parallel
{
namespace
{
/// Memory that curvatures take while they are made.
constexpr std::size_t BytesOfCurvedVertex = 800;
constexpr std::size_t BytesOfCurvature = 1 << 20;

/// The user's vectors as a section, in the scale of the whole surface.
std::vector<Complex> GivenSection(Processes& processes, const Messages& messages,
  const DistributedMesh& mesh, const PieceWithSurroundings& piece, const Options& options,
  const Guidance& guidance)
{
  GuidanceScale scale = ScaleOf(guidance);
  scale.Longest = messages.Largest(scale.Longest);
  scale.Heaviest = messages.Largest(scale.Heaviest);
  std::vector<Complex> section;
  processes.Together(
    [&]
    {
      Guidance all = guidance;
      all.Vectors.resize(piece.Number.size(), Vector3::Zero());
      if (!all.Weights.empty())
      {
        all.Weights.resize(piece.Number.size(), 0.0);
      }
      section = GuidanceSection(mesh.GetGeometry(), all, options.Degree, scale);
    });
  return section;
}

/// Whether a value is not zero at any owned vertex of the whole surface.
template <typename IsThere>
bool AnyOwned(const Messages& messages, const DistributedMesh& mesh, const IsThere& isThere)
{
  bool any = false;
  for (Index v = 0; v < mesh.GetMesh().GetNumberOfVertices() && !any; ++v)
  {
    any = mesh.IsOwned(v) && isThere(v);
  }
  return messages.Any(any);
}

void DrawToCurvature(const Messages& messages, const DistributedMesh& mesh,
  const PieceWithSurroundings& piece, const Options& options, DistributedGuide& guide)
{
  messages.Together(
    [&]
    {
      const auto vertices = static_cast<std::size_t>(mesh.GetMesh().GetNumberOfVertices());
      RequireMemory(BytesOfCurvature + vertices * BytesOfCurvedVertex);
    });
  guide.Curved = CurvatureOf(messages, mesh, piece, options.CurvatureScale);
  guide.Shares = CurvatureShares(messages, mesh, *guide.Curved);
  guide.Drawn = CurvatureSection(*guide.Curved, options.Degree, options.CurvatureDirection);
  guide.IsDrawn = AnyOwned(messages, mesh, [&](Index v) { return guide.Drawn[v] != 0.0; });
  if (guide.IsDrawn)
  {
    Continue(mesh.GetGeometry(), options.Degree, guide.Drawn, MeshPiece(messages, mesh));
  }
  else
  {
    guide.Reason = "it is curved alike in all directions";
  }
}
}

DistributedGuide MakeGuide(Processes& processes, const Messages& messages,
  const DistributedMesh& mesh, const PieceWithSurroundings& piece, const Options& options,
  const Guidance& guidance)
{
  DistributedGuide guide;
  std::vector<Complex> given;
  if (mesh.HasCovers() && options.Alignment == Alignment::PrincipalCurvature)
  {
    guide.Reason = "it has only one side, where curvatures need the whole surface";
    return guide;
  }
  if (mesh.HasCovers() && options.ConstrainBoundary && options.Degree % 2 != 0)
  {
    // The two sides of a boundary have opposite directions: a whole loop of it decides which.
    guide.Reason = "it has only one side, whose boundary has no direction of its own";
    return guide;
  }
  if (options.Alignment == Alignment::PointVectors || options.ConstrainGuidance)
  {
    given = GivenSection(processes, messages, mesh, piece, options, guidance);
    if (!AnyOwned(messages, mesh, [&](Index v) { return given[v] != 0.0; }))
    {
      guide.Reason = "its guidance is zero everywhere";
      return guide;
    }
  }
  if (options.ConstrainBoundary || options.ConstrainGuidance)
  {
    guide.IsConstrained = true;
    processes.Together(
      [&]
      {
        std::vector<std::string> notes;
        Constraints constraints({ mesh.GetGeometry(), {}, nullptr, given, {} }, options, notes);
        const auto vertices = static_cast<std::size_t>(mesh.GetMesh().GetNumberOfVertices());
        guide.Kind = std::move(constraints.Kind);
        guide.Value = std::move(constraints.Value);
        guide.Kind.resize(vertices, ConstraintKind::None);
        guide.Value.resize(vertices, 0.0);
      });
    mesh.Complete(guide.Kind);
    mesh.Complete(guide.Value);
    const auto isOf = [&](ConstraintKind kind)
    { return AnyOwned(messages, mesh, [&](Index v) { return guide.Kind[v] == kind; }); };
    if (options.ConstrainBoundary && !isOf(ConstraintKind::Boundary) &&
      !isOf(ConstraintKind::Given))
    {
      guide.Reason = "it has no boundary to constrain";
    }
  }
  if (options.Alignment == Alignment::PointVectors)
  {
    guide.IsDrawn = true;
    guide.Drawn = std::move(given);
  }
  else if (options.Alignment == Alignment::PrincipalCurvature)
  {
    try
    {
      DrawToCurvature(messages, mesh, piece, options, guide);
    }
    catch (const TooLittleMemory&)
    {
      throw;
    }
    catch (const std::bad_alloc&)
    {
      EndAllForMemory("");
    }
  }
  return guide;
}
}
