// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SingularityEditor_h
#define DirectionFields_SingularityEditor_h

#include "Distance/TriangleRuns.h"
#include "Interpolation/GivenField.h"
#include "PrescribedSingularities/SingularityTargets.h"
#include "Progress.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace DirectionFields::Internal
{
/// A singularity as it is asked for: at a place in space, in units of 1/n.
struct WantedSingularity
{
  Vector3 Position;
  int Index = 1;
};

struct EditOptions : TargetOptions
{
  /// tau, free of units, 0 to less than 1, as Options::AlignmentStrength: the field is drawn to the guidance without
  /// any change of its singularities. 0 for not at all.
  double AlignmentStrength = 0.0;
};

/// What became of one component.
struct EditedComponent
{
  /// Its field is another one than the base. Components without singularities that were asked for keep theirs, to the
  /// last bit, and so do those whose singularities are the base's where the least change is wanted.
  bool IsChanged = false;
  /// Half of it is the Dirichlet energy of the directions' phases.
  double Energy = 0.0;
  /// The largest rotation along an edge over pi: below 1 all indices are the prescribed ones.
  double MaximumRotation = 0.0;
  Index WrongTriangles = 0;
  std::vector<int> TurningNumbers;
  double Residual = 0.0;
  /// What the strength of the alignment was to be multiplied with for the indices to stay.
  double AlignmentShare = 1.0;
};

struct EditedField
{
  /// Over the vertices of the mesh.
  std::vector<Complex> Section;
  std::vector<EditedComponent> Components;
  /// Triangles of the mesh, on the front, whose index is not the one asked for.
  std::vector<Index> WrongTriangles;
  std::vector<std::string> Notes;
};

/// Moves, adds and takes away singularities of a field. What does not depend on the singularities is kept, and so is
/// each component's solver: further edits take one linear system each.
class SingularityEditor
{
public:
  /// @param surface     must outlive this
  /// @param directions  the base
  /// @param constraints tangent vectors at the points that are to keep their directions, zero at others; empty for none
  SingularityEditor(const Surface& surface, const PointDirections& directions,
    const std::vector<Vector3>& constraints = {});

  const GivenField& GetBase() const { return this->Base; }
  /// For each point of the surface the one that stands for it in the mesh; empty where each stands for itself.
  const std::vector<Index>& GetFirstPoints() const { return this->FirstPoint; }
  /// What the field may be drawn to: a section of the field's degree over the vertices of the mesh; empty for nothing.
  void SetGuidance(std::vector<Complex> guidance) { this->Guidance = std::move(guidance); }

  /// Throws std::invalid_argument for singularities that cannot be (see MakeTarget), and Stopped.
  EditedField Edit(const std::vector<WantedSingularity>& wanted, const EditOptions& options,
    const Progress& progress);

private:
  std::vector<std::vector<PrescribedSingularity>> Snapped(
    const std::vector<WantedSingularity>& wanted);
  TrivialConnection& GetRotation(std::size_t component);
  void EditComponent(std::size_t component, const std::vector<PrescribedSingularity>& singularities,
    const EditOptions& options, const Progress& progress, EditedField& edited);
  void SetSection(std::size_t component, const RotationTarget& target, const TurnedField& field,
    EditedField& edited);

  SingularityEditor(const Surface& surface, const std::shared_ptr<const FieldSurface>& made,
    const PointDirections& directions, const std::vector<Vector3>& constraints);
  const TriangleRuns& GetNearest();

  GivenField Base;
  std::vector<Index> FirstPoint;
  /// The base where directions are given, and whether they are, of each vertex.
  std::vector<Complex> Section;
  std::vector<char> IsGiven;
  std::vector<Complex> Guidance;
  /// Of the surface's triangles that the mesh has.
  std::optional<TriangleRuns> Nearest;
  std::vector<std::unique_ptr<TrivialConnection>> Rotations;
};
}

#endif
