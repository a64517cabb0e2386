// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Guide_h
#define DirectionFields_Guide_h

#include "Guidance/Constraints.h"
#include "Guidance/GuidanceTerms.h"
#include "Guidance/SurfaceTensors.h"
#include "Options.h"

#include <memory>
#include <string>
#include <vector>

namespace DirectionFields::Internal
{
class Stages;

/// The tensors that fields follow.
struct FollowedTensors
{
  std::shared_ptr<const SurfaceTensors> Tensors;
  TensorGuidanceOptions Options;
};

/// The guidance that the options draw a field to, and its constraints. All arrays are over the
/// vertices of the mesh.
class Guide
{
public:
  /// @param guidance of the input's points
  /// @param notes    gets a sentence for each option that changes nothing
  /// @param tensors  null where the field follows none
  Guide(Stages& stages, const Options& options, const Guidance& guidance,
    std::vector<std::string>& notes, const FollowedTensors* tensors = nullptr);

  /// Whether there is anything to follow.
  bool Any() const
  {
    return this->Constrained.Any() || !this->Drawn.empty() || !this->ExactKind.empty() ||
      !this->Soft.empty();
  }
  const Constraints& GetConstraints() const { return this->Constrained; }
  /// The part of one component.
  ComponentGuide Of(const TriangleMesh& mesh, std::size_t component) const;
  /// The guidance by the tensors at the output points; null without tensors.
  std::shared_ptr<const TensorGuidance> TensorsAtPoints(Stages& stages) const;

private:
  void Follow(Stages& stages, const Options& options, std::vector<std::string>& notes);
  void Soften(std::vector<std::string>& notes);
  void Constrain(const TriangleMesh& mesh, const std::vector<Complex>& section);
  SoftConstraints SoftOf(const TriangleMesh::Component& component) const;

  /// The user's vectors as a section of the field's degree; empty where no option asks for them.
  std::vector<Complex> Given;
  /// GuidanceStrengths where the vectors constrain.
  std::vector<double> Strengths;
  Constraints Constrained;
  /// The guidance that the field is drawn to; empty for none.
  std::vector<Complex> Drawn;
  /// The constraints together with the directions of tensors, where the field has these themselves;
  /// else empty.
  std::vector<ConstraintKind> ExactKind;
  std::vector<Complex> ExactValue;
  /// The directions that free vertices are drawn to, of the modulus of their stiffness, zero
  /// elsewhere; empty for none.
  std::vector<Complex> Soft;
  const FollowedTensors* Tensors;
  /// The share of the strength of each component; empty for all of it.
  std::vector<double> Shares;
};

/// The part of one component.
/// @param drawn       the guidance that the field is drawn to, over the vertices of the mesh; empty
///                    for none
/// @param kind, value as in Constraints
ComponentGuide GuideOf(const TriangleMesh& mesh, std::size_t component,
  const std::vector<Complex>& drawn, const std::vector<ConstraintKind>& kind,
  const std::vector<Complex>& value);

/// The share of the strength of each component: one of which almost nothing is curved beside others
/// that are has all of it down to a fiftieth of the most curved one, below that by the square.
/// @param bends how curved each component is for its size, the root of the integral of |q|^2
std::vector<double> SharesOfBends(std::vector<double> bends);

/// Where curvature is used, and Curvature::IsInsideOut.
constexpr const char* InsideOutNote =
  "Turn the triangles if that was not meant: a closed part of the surface is wound inside out. Its "
  "curvature is taken as seen from outside.";

/// Whether a field that follows tensors has their directions themselves.
bool FollowsExactly(const Options& options);

/// Whether the options need the curvature of the surface.
bool UsesCurvature(const Options& options);
}

#endif
