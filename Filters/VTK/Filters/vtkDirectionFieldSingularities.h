// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkDirectionFieldSingularities
 * @brief moves, adds and takes away singularities of a direction field
 *
 * vtkDirectionFieldSingularities gives a field the singularities that points tell: where each of
 * them is, and its index. Of all fields with these singularities it takes the smoothest (a trivial
 * connection), or the one that is closest to the input's. The output can be used wherever that of
 * vtkDirectionField can, and be edited again.
 *
 * K. Crane, M. Desbrun, P. Schroeder: Trivial Connections on Discrete Surfaces. Computer Graphics
 * Forum 29(5), 2010.
 *
 * The indices, in units of 1/n, must add up to n times the Euler characteristic on each closed
 * component with a singularity in it; else it is an error that names both numbers, unless
 * BalanceAutomatically adds the missing singularities. On a component with a boundary any sum will
 * do, unless the boundary is constrained. A component without any point keeps its field.
 *
 * A point counts for the nearest triangle. Its place within the triangle counts, too: while a point
 * moves, the smoothest field changes continuously. A triangle can hardly have more than the index 1
 * or -1; the rest of larger ones goes to triangles nearby. Where the mesh is too coarse for the
 * smoothest field to turn as much as is asked for, it turns as the input's field does around
 * singularities that this has in the same triangles. Elsewhere the triangles whose index is another
 * one are counted in `WrongTriangles`, with a warning; RefineWhereNeeded subdivides the surface
 * there.
 *
 * Data that do not depend on the points are kept until the input changes: to drag a point takes one
 * linear system.
 *
 * @section Input Input
 * Port 0: a surface with the arrays of vtkDirectionField's first output, or of
 * vtkDirectionFieldReader's; port 1: points, or a composite dataset of such, with the point data
 * `SingularityIndex`: integers in units of 1/n, 1 where there is no such array. That is the format
 * of vtkDirectionField's second output, which can be edited and given here. Without any connection
 * to port 1 they are the field's own singularities, to which ADD adds none. Where port 0 is a
 * composite dataset, a point counts for the same block where port 1 has the same structure, else
 * for the nearest block.
 *
 * @section Output Output
 * Port 0: the surface with the arrays of vtkDirectionField, but for the field data that tell how a
 * field was computed; `RepresentationMagnitude` is 1 but near singularities. Further field data,
 * one tuple per connected component, ordered by their first cells, 0 for those that keep their
 * field:
 * - `RotationEnergy`: double, no unit. The sum over the edges of half the cotangents of the angles
 *   opposite of an edge, times the square of the angle by which the representation vector turns
 *   along it. Over all fields with these singularities the least for the smoothest one.
 * - `MaximumRotation`: double. The largest such angle over pi. Below 1 all indices are the
 *   prescribed ones.
 * - `WrongTriangles`: int. How many triangles have another index than was asked for.
 *
 * and `TurningNumbers`: int, components Component and TurningNumber, one tuple for each independent
 * loop of the components that are edited, two for each handle and one for each further boundary:
 * how often the field turns against the loop's tangent, in units of 1/n.
 *
 * Port 1: the singularities, as vtkDirectionField gives them.
 *
 * @sa
 * vtkDirectionField vtkDirectionFieldReader vtkCompareDirectionFields
 */

#ifndef vtkDirectionFieldSingularities_h
#define vtkDirectionFieldSingularities_h

#include "vtkDirectionFieldAlgorithm.h"
#include "vtkDirectionFieldsFiltersModule.h" // For export macro

#include <array>  // For std::array
#include <memory> // For std::unique_ptr
#include <string> // For std::string
#include <vector> // For std::vector

class vtkCompositeDataSet;

namespace DirectionFields
{
class SingularityEditor;
class SingularityEditorCache;
struct EditedField;
struct EditOptions;
struct WantedSingularity;
}

class VTKDIRECTIONFIELDSFILTERS_EXPORT vtkDirectionFieldSingularities
  : public vtkDirectionFieldAlgorithm
{
public:
  static vtkDirectionFieldSingularities* New();
  vtkTypeMacro(vtkDirectionFieldSingularities, vtkDirectionFieldAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// How the points relate to the singularities that the field has.
  enum SingularityModes
  {
    /// They take the place of all others on their components.
    REPLACE = 0,
    /// They are added to the others.
    ADD = 1
  };
  /// Which field is taken of those with the singularities.
  enum Objectives
  {
    /// The one that turns least.
    SMOOTHEST = 0,
    /// The one that turns least against the input's: it changes near the moved singularities.
    /// Without any change it is the input's to the last bit.
    LEAST_CHANGE = 1
  };
  enum Alignments
  {
    ALIGN_NONE = 0,
    ALIGN_PRINCIPAL_CURVATURE = 1,
    ALIGN_POINT_VECTORS = 2
  };

  ///@{
  /**
   * The singularities, which become the input of port 1.
   */
  void SetSingularitiesConnection(vtkAlgorithmOutput* output);
  void SetSingularitiesData(vtkDataObject* points);
  ///@}

  ///@{
  /**
   * Whether the points replace the singularities of their components (REPLACE, the default) or come
   * on top of them (ADD), so that their indices have to add up to 0 on closed components.
   */
  vtkSetClampMacro(SingularityMode, int, REPLACE, ADD);
  vtkGetMacro(SingularityMode, int);
  void SetSingularityModeToReplace() { this->SetSingularityMode(REPLACE); }
  void SetSingularityModeToAdd() { this->SetSingularityMode(ADD); }
  ///@}

  ///@{
  /**
   * A list of all singularities that the surface is to have: the place of each in space, which
   * counts for the nearest point of the surface, and its index in units of 1/n, rounded to a whole
   * number. Once it has an entry, it takes the place of port 1 and SingularityMode, and parts of
   * the surface without an entry lose their singularities; an index of 0 is none. What the field
   * cannot have is no error: the component keeps its directions, and `Warnings` and `Summary` say
   * why. Default: none.
   */
  void AddSingularity(double x, double y, double z, double index);
  void RemoveAllSingularities();
  ///@}

  ///@{
  /**
   * Which of the fields with these singularities: the smoothest (SMOOTHEST, the default), or that
   * of least change against the input's (LEAST_CHANGE). With LEAST_CHANGE a singularity that is
   * where the input has one, given as the middle of its triangle, stays as it is.
   */
  vtkSetClampMacro(Objective, int, SMOOTHEST, LEAST_CHANGE);
  vtkGetMacro(Objective, int);
  void SetObjectiveToSmoothest() { this->SetObjective(SMOOTHEST); }
  void SetObjectiveToLeastChange() { this->SetObjective(LEAST_CHANGE); }
  ///@}

  ///@{
  /**
   * Where indices do not add up to the required sum, whether to add singularities of index 1 or -1
   * until they do: where the input has such, those first that are farthest from all others. Default
   * off, which is an error then.
   */
  vtkSetMacro(BalanceAutomatically, bool);
  vtkGetMacro(BalanceAutomatically, bool);
  vtkBooleanMacro(BalanceAutomatically, bool);
  ///@}

  ///@{
  /**
   * Whether to subdivide the surface around triangles whose index is not the one asked for, up to
   * four times, so that it can be. The output has more points and cells then, with interpolated
   * data, and its polygons are triangles. Default off.
   */
  vtkSetMacro(RefineWhereNeeded, bool);
  vtkGetMacro(RefineWhereNeeded, bool);
  vtkBooleanMacro(RefineWhereNeeded, bool);
  ///@}

  ///@{
  /**
   * Whether points that the input's `ConstraintKind` tells keep their `ConstraintDirection`.
   * Singularities cannot cross edges between such points: the indices in each part that they bound
   * have to add up to the sum that the input has there. Default on.
   */
  vtkSetMacro(KeepConstraints, bool);
  vtkGetMacro(KeepConstraints, bool);
  vtkBooleanMacro(KeepConstraints, bool);
  ///@}

  ///@{
  /**
   * The guidance that the field is drawn to while its singularities stay: ALIGN_NONE (the default),
   * ALIGN_PRINCIPAL_CURVATURE (degrees 2 and 4), or ALIGN_POINT_VECTORS, the arrays GuidanceVectors
   * and GuidanceWeights.
   */
  vtkSetClampMacro(Alignment, int, ALIGN_NONE, ALIGN_POINT_VECTORS);
  vtkGetMacro(Alignment, int);
  ///@}

  ///@{
  /**
   * How strongly the field is drawn: as vtkDirectionField::AlignmentStrength, 0 not at all, towards
   * 1 ever more. Where the singularities could not stay the strength is halved until they can, with
   * a warning. Range 0 to 1, default 0.5.
   */
  vtkSetClampMacro(AlignmentStrength, double, 0.0, 1.0);
  vtkGetMacro(AlignmentStrength, double);
  ///@}

  ///@{
  /**
   * Names of the point array of 3 components that the field is drawn to with ALIGN_POINT_VECTORS,
   * and of one of 1 component with further weights, or null for none. Default null.
   */
  vtkSetStringMacro(GuidanceVectors);
  vtkGetStringMacro(GuidanceVectors);
  vtkSetStringMacro(GuidanceWeights);
  vtkGetStringMacro(GuidanceWeights);
  ///@}

  ///@{
  /**
   * Whether to keep the surface and the solver for the next execution. Default on.
   */
  vtkSetMacro(KeepStages, bool);
  vtkGetMacro(KeepStages, bool);
  vtkBooleanMacro(KeepStages, bool);
  ///@}

protected:
  vtkDirectionFieldSingularities();
  ~vtkDirectionFieldSingularities() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void Execute(
    const Ports& inputs, const Ports& outputs, const DirectionFields::Progress& progress) override;
  void Release(bool hasFailed) override;
  bool TakesBlocks() const override { return true; }

private:
  vtkDirectionFieldSingularities(const vtkDirectionFieldSingularities&) = delete;
  void operator=(const vtkDirectionFieldSingularities&) = delete;

  /// Edits one surface. Throws DirectionFields::Stopped.
  /// @param given null where there is no second input
  void EditBlock(vtkPolyData* input, const std::vector<DirectionFields::WantedSingularity>* given,
    const DirectionFields::Progress& progress, vtkPolyData* output, vtkPolyData* singularities);
  DirectionFields::EditedField EditField(vtkPolyData* surface,
    DirectionFields::SingularityEditor& editor,
    const std::vector<DirectionFields::WantedSingularity>& wanted,
    const DirectionFields::Progress& progress, std::vector<std::string>& warnings);
  void EditBlocks(vtkCompositeDataSet* input, vtkDataObject* points,
    const DirectionFields::Progress& progress, vtkCompositeDataSet* output,
    vtkCompositeDataSet* singularities);
  DirectionFields::EditOptions MakeOptions() const;

  int SingularityMode;
  int Objective;
  bool BalanceAutomatically;
  bool RefineWhereNeeded;
  bool KeepConstraints;
  int Alignment;
  double AlignmentStrength;
  char* GuidanceVectors;
  char* GuidanceWeights;
  bool KeepStages;
  /// Place and index of each singularity of the list.
  std::vector<std::array<double, 4>> List;
  std::unique_ptr<DirectionFields::SingularityEditorCache> Last;
};

#endif
