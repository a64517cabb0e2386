// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SingularityHand_h
#define DirectionFields_SingularityHand_h

#include "PrescribedSingularities/EditOptions.h"
#include "Surface.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace DirectionFields
{
/// What a step of an edit by hand makes of a list of singularities.
struct HandStep
{
  /// The list after the step; as it was before where it cannot be done.
  std::vector<WantedSingularity> Singularities;
  /// Whether the step was done.
  bool IsDone = false;
  /// A sentence for the user: what was done beside what was asked for, or why nothing was. Empty
  /// where there is nothing to say.
  std::string Note;
};

/// Steps of an edit by hand: a singularity is moved, one goes, others come. Each takes a list of
/// all singularities of a surface and gives one that a field can have, for SingularityEditor::Edit
/// with EditOptions::IsWholeList.
///
/// On a part of the surface that is closed, by itself or by lines of constrained directions, the
/// indices add up to the same number before and after each step. A part with a boundary that is
/// free lets indices in and out.
class SingularityHand
{
public:
  /// Takes linear time, on the threads of the scope. Throws MeshError for a surface that cannot be
  /// processed.
  /// @param surface     must outlive this
  /// @param constraints as for SingularityEditor: one a point, zero where nothing is constrained;
  ///                    empty for none
  explicit SingularityHand(const Surface& surface, const std::vector<Vector3>& constraints = {});
  ~SingularityHand();
  SingularityHand(SingularityHand&&) noexcept;
  SingularityHand& operator=(SingularityHand&&) noexcept;

  /// Moves a singularity to the point of the surface that is nearest to a place. It can only go
  /// where the sums of indices stay: not to another part of the surface, unless both have a free
  /// boundary.
  /// @param which of the list
  HandStep Move(const std::vector<WantedSingularity>& singularities, std::size_t which,
    const Vector3& place) const;

  /// Takes a singularity away: it goes into the nearest one of opposite sign on the same part of
  /// the surface, along paths over the triangles' middles that cross no line of constrained
  /// directions, and both vanish where their indices are opposite. Without such a one it leaves
  /// through a free boundary. A list never gets empty: its last entry has the index 0 then.
  HandStep Merge(const std::vector<WantedSingularity>& singularities, std::size_t which) const;

  /// Adds a singularity of an index, in units of 1/n, at the point of the surface nearest to a
  /// place, which must have a free boundary.
  HandStep Add(
    const std::vector<WantedSingularity>& singularities, const Vector3& place, int index) const;

  /// Adds a singularity as Add does, and one of the opposite index a few triangles away, so that
  /// the sum stays.
  HandStep AddPair(
    const std::vector<WantedSingularity>& singularities, const Vector3& place, int index) const;

private:
  class Parts;
  std::unique_ptr<Parts> Found;
};
}

#endif
