// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCompareDirectionFields
 * @brief says how far two direction fields on one surface are apart
 *
 * vtkCompareDirectionFields compares two fields of the same degree n, of other options or from
 * other programs (vtkDirectionFieldReader), on the same surface: the angle between their directions
 * at each point, modulo 360 / n degrees, and matches the singularities of the two fields. It does
 * not matter which of the n directions is called Direction0.
 *
 * With DivergenceAndCurl it also gives divergence and curl of vector fields and line fields, n = 1
 * and 2. For one field alone give it twice.
 *
 * @section Input Input
 * Both ports: a vtkPolyData with the point arrays `Direction0`, ... that vtkDirectionField gives.
 * They have the same points and the same cells. Where port 0 has a composite dataset, port 1 has
 * one of the same structure, or one surface that is compared with all. Without any connection to
 * port 1 the output is the first input as it is, with a warning.
 *
 * @section Output Output
 * Port 0: the first surface with
 * - point data `AngleDifference`: double, active scalars. The angle between a direction of the one
 *   field and the nearest of the other, in degrees, 0 to 180 / n. Not a number where one of them
 *   has no direction.
 * - field data `MeanAngleDifference` (weighted by area) and `MaximumAngleDifference`: double,
 *   degrees. Ghosts do not count.
 * - field data `MatchedSingularities`: int, three components: how many match, and how many of the
 *   first and of the second field have no match; `MeanMatchDistance` and `MaximumMatchDistance`:
 *   double, in the surface's unit of length. Only with MatchSingularities.
 * - cell data `Divergence0`, `Curl0`, `Divergence1`, `Curl1`: double, of the unit vectors of the
 *   first and the second field in 1 / length; moduli for n = 2, whose vectors have no sign. Not a
 *   number in singular triangles of line fields, the mean over the triangles of a polygon. Only
 *   with DivergenceAndCurl.
 *
 * Port 1: with MatchSingularities a vertex for each singularity of both fields where the field
 * vanishes, and a line between each two that match; point data `Field` (int, 0 or 1),
 * `SingularityIndex` (int), `Match` (vtkIdType, the other point or -1), `MatchDistance` (double,
 * along the surface; not a number without match) and `CellId`. Singularities match if their indices
 * are the same: the two that are nearest to each other along the surface, then the next two, and so
 * on.
 *
 * @sa
 * vtkDirectionField vtkDirectionFieldReader
 */

#ifndef vtkCompareDirectionFields_h
#define vtkCompareDirectionFields_h

#include "vtkDirectionFieldAlgorithm.h"
#include "vtkDirectionFieldsFiltersModule.h" // For export macro

class vtkCompositeDataSet;

class VTKDIRECTIONFIELDSFILTERS_EXPORT vtkCompareDirectionFields : public vtkDirectionFieldAlgorithm
{
public:
  static vtkCompareDirectionFields* New();
  vtkTypeMacro(vtkCompareDirectionFields, vtkDirectionFieldAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The field that the first one is compared with, which becomes the input of port 1.
   */
  void SetOtherConnection(vtkAlgorithmOutput* output);
  void SetOtherData(vtkDataObject* field);
  ///@}

  ///@{
  /**
   * Match the singularities of the two fields. Default on.
   */
  vtkSetMacro(MatchSingularities, bool);
  vtkGetMacro(MatchSingularities, bool);
  vtkBooleanMacro(MatchSingularities, bool);
  ///@}

  ///@{
  /**
   * Give divergence and curl of both fields, for degree 1 and 2; an error for other degrees.
   * Default off.
   */
  vtkSetMacro(DivergenceAndCurl, bool);
  vtkGetMacro(DivergenceAndCurl, bool);
  vtkBooleanMacro(DivergenceAndCurl, bool);
  ///@}

protected:
  vtkCompareDirectionFields();
  ~vtkCompareDirectionFields() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void Execute(
    const Ports& inputs, const Ports& outputs, const DirectionFields::Progress& progress) override;
  bool TakesBlocks() const override { return true; }

private:
  vtkCompareDirectionFields(const vtkCompareDirectionFields&) = delete;
  void operator=(const vtkCompareDirectionFields&) = delete;

  /// Compares two surfaces. Throws DirectionFields::Stopped.
  void Compare(vtkPolyData* input, vtkPolyData* other, const DirectionFields::Progress& progress,
    vtkPolyData* output, vtkPolyData* matches);
  void CompareBlocks(vtkCompositeDataSet* input, vtkDataObject* other,
    const DirectionFields::Progress& progress, vtkCompositeDataSet* output,
    vtkCompositeDataSet* matches);

  bool MatchSingularities;
  bool DivergenceAndCurl;
};

#endif
