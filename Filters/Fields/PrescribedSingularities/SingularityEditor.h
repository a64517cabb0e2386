// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SingularityEditor_h
#define DirectionFields_SingularityEditor_h

#include "Interpolation/GivenField.h"
#include "PrescribedSingularities/EditOptions.h"
#include "Progress.h"

#include <memory>
#include <string>
#include <vector>

namespace DirectionFields
{
/// How the edit of one connected component went.
struct EditedComponent
{
  /// With EditOptions::KeepsUnmet: whether the singularities cannot be, so that it keeps its field.
  bool IsUnmet = false;
  /// Whether its field differs from the given one. Components without singularities that were asked
  /// for keep their directions to the last bit, and so do components that are to have the
  /// singularities that they have, with RotationObjective::LeastChange.
  bool IsChanged = false;
  /// The sum over the edges of weight times the square of the rotation along the edge, radians:
  /// twice the Dirichlet energy of the phases. Free of units.
  double Energy = 0.0;
  /// The largest rotation along an edge over pi: below 1 all indices are the prescribed ones.
  double MaximumRotation = 0.0;
  /// Triangles whose index is not the one asked for.
  Index WrongTriangles = 0;
  /// How often the directions turn along each generator of the component's loops, in units of 1/n:
  /// 2g of them on a closed surface of genus g, and one more for each boundary but the first.
  std::vector<int> TurningNumbers;
  /// Relative residual of the linear system.
  double Residual = 0.0;
  /// The factor, 0 to 1, by which AlignmentStrength's weight was reduced so that the indices stay.
  double AlignmentShare = 1.0;
};

/// A field with edited singularities over the mesh of SingularityEditor::GetBase.
struct EditedField
{
  /// Representation vector of each vertex of the mesh, in its tangent frame.
  std::vector<Complex> Section;
  /// One for each connected component of the mesh.
  std::vector<EditedComponent> Components;
  /// Triangles of the mesh, on the front, whose index is not the one asked for.
  std::vector<Index> WrongTriangles;
  /// Sentences for the user.
  std::vector<std::string> Notes;
};

/// Moves, adds and removes singularities of a field of any degree n: the result is the smoothest
/// field with the singularities that are asked for, or the one that is nearest to the given field
/// (trivial connections),
///
/// K. Crane, M. Desbrun, P. Schröder: Trivial Connections on Discrete Surfaces. Computer Graphics
/// Forum 29(5), 2010.
///
/// The mesh and the solver of each component are kept: the first edit of a component prepares its
/// solver, further edits take one linear system each, in time linear in the triangles. Two threads
/// may not use one object at once.
///
/// EditedResult.h turns an edited field into a Result over the points of the surface, and makes the
/// guidance.
class SingularityEditor
{
public:
  /// Takes linear time, on the threads of the scope.
  /// @param surface     must outlive this
  /// @param directions  the given field (DirectionsOf makes one of a Result); needed in this call
  ///                    only
  /// @param constraints one a point: tangent vectors where directions are to stay, zero elsewhere;
  ///                    empty for none
  SingularityEditor(const Surface& surface, const PointDirections& directions,
    const std::vector<Vector3>& constraints = {});
  ~SingularityEditor();
  SingularityEditor(SingularityEditor&&) noexcept;
  SingularityEditor& operator=(SingularityEditor&&) noexcept;

  /// The given field and its mesh.
  const GivenField& GetBase() const;
  /// For each point of the surface the one that stands for it in the mesh; empty where each stands
  /// for itself.
  const std::vector<Index>& GetFirstPoints() const;
  /// The singularities of the given field, each in the middle of its triangle.
  std::vector<WantedSingularity> GetOwnSingularities() const;
  /// Directions that EditOptions::AlignmentStrength draws the field to, for all further edits.
  /// @param guidance a section of the field's degree over the vertices of the mesh (GuidanceFor);
  ///                 empty for none
  void SetGuidance(std::vector<Complex> guidance);

  /// The field with the singularities that are asked for. An edit starts from the given field, not
  /// from an earlier edit. Several singularities in one triangle add up. Where the smoothest field
  /// cannot carry singularities that the given one has in the same triangles, it turns around them
  /// as the given one does. Where else the mesh is too
  /// coarse for an index, the field has another one there, and says so in WrongTriangles and Notes:
  /// split the surface with SurfaceRefinement.
  ///
  /// Throws std::invalid_argument, its text a sentence for the user, for positions that are not
  /// finite, for indices that do not add up to n times the Euler characteristic of a closed
  /// component (without EditOptions::Balances), and for indices that no triangles can hold, all
  /// unless EditOptions::KeepsUnmet; and Stopped.
  EditedField Edit(const std::vector<WantedSingularity>& wanted, const EditOptions& options = {},
    const Progress& progress = {});

private:
  class Components;
  std::unique_ptr<Components> Cache;
};
}

#endif
