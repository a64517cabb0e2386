// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Guide_h
#define DirectionFields_Guide_h

#include "Guidance/Constraints.h"
#include "Guidance/GuidanceTerms.h"
#include "Options.h"

#include <string>
#include <vector>

namespace DirectionFields::Internal
{
class Stages;

/// The guidance that the options draw a field to, and its constraints. All arrays are over the
/// vertices of the mesh.
class Guide
{
public:
  /// @param guidance of the input's points
  /// @param notes    gets a sentence for each option that changes nothing
  Guide(Stages& stages, const Options& options, const Guidance& guidance,
    std::vector<std::string>& notes);

  /// Whether there is anything to follow.
  bool Any() const { return this->Constrained.Any() || !this->Drawn.empty(); }
  const Constraints& GetConstraints() const { return this->Constrained; }
  /// The part of one component.
  ComponentGuide Of(const TriangleMesh& mesh, std::size_t component) const;

private:
  /// The user's vectors as a section of the field's degree; empty where no option asks for them.
  std::vector<Complex> Given;
  Constraints Constrained;
  /// The guidance that the field is drawn to; empty for none.
  std::vector<Complex> Drawn;
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

/// Whether the options need the curvature of the surface.
bool UsesCurvature(const Options& options);
}

#endif
