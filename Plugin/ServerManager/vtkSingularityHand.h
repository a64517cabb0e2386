// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSingularityHand
 * @brief what a list of singularities becomes when one of them is moved, taken away, or others come
 *
 * It runs where the surface is, so that a window can edit the singularities of a field that only a
 * server has: it is told the ray below the mouse. The input is that of
 * vtkDirectionFieldSingularities, a vtkPolyData or a composite dataset of such, whole on one
 * process; the output has the points of the list after the step, with the point data
 * - `SingularityIndex`: int, in units of 1/n;
 * - `Visible`: unsigned char, 1 where the surface does not hide the point from the eye;
 *
 * and the field data `Note`, a sentence for the user, `IsDone`, 1 where the step was done, and
 * `Hit`, the first point of the surface on the ray; no tuple where there is none. A place that is
 * asked for is that point. What is kept of the surface is found once for each input.
 *
 * A surface that cannot be processed is no error here: nothing is done, and the note says why.
 */

#ifndef vtkSingularityHand_h
#define vtkSingularityHand_h

#include "vtkDirectionFieldsServerManagerModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <array>
#include <memory>
#include <vector>

class VTKDIRECTIONFIELDSSERVERMANAGER_EXPORT vtkSingularityHand : public vtkPolyDataAlgorithm
{
public:
  static vtkSingularityHand* New();
  vtkTypeMacro(vtkSingularityHand, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Steps
  {
    LOOK = 0,
    MOVE = 1,
    MERGE = 2,
    ADD = 3,
    ADD_PAIR = 4
  };

  ///@{
  /**
   * The list before the step. Default: none.
   */
  void AddSingularity(double x, double y, double z, double index);
  void RemoveAllSingularities();
  ///@}

  ///@{
  /**
   * What is done, as DirectionFields::SingularityHand does it. Default: LOOK, nothing.
   */
  vtkSetClampMacro(Step, int, LOOK, ADD_PAIR);
  vtkGetMacro(Step, int);
  ///@}

  ///@{
  /**
   * The number of the singularity for MOVE and MERGE, and the index for ADD and ADD_PAIR. Default:
   * 0 and 1.
   */
  vtkSetMacro(Which, int);
  vtkGetMacro(Which, int);
  vtkSetMacro(Index, int);
  vtkGetMacro(Index, int);
  ///@}

  ///@{
  /**
   * The ends of the ray that the mouse points along. Default: both at the origin.
   */
  vtkSetVector6Macro(Ray, double);
  vtkGetVector6Macro(Ray, double);
  ///@}

  ///@{
  /**
   * Where the eye is: a place and 1, or the direction towards an eye far away and 0. Default: 0, 0,
   * 1, 0.
   */
  vtkSetVector4Macro(Eye, double);
  vtkGetVector4Macro(Eye, double);
  ///@}

  ///@{
  /**
   * Whether lines of constrained directions are not crossed, as in vtkDirectionFieldSingularities.
   * Default: on.
   */
  vtkSetMacro(KeepConstraints, bool);
  vtkGetMacro(KeepConstraints, bool);
  ///@}

protected:
  vtkSingularityHand();
  ~vtkSingularityHand() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  class Target;
  void Take(Target& target, vtkPolyData* output) const;

  std::vector<std::array<double, 4>> List;
  int Step = LOOK;
  int Which = 0;
  int Index = 1;
  double Ray[6] = {};
  double Eye[4] = { 0.0, 0.0, 1.0, 0.0 };
  bool KeepConstraints = true;
  std::unique_ptr<Target> Last;

  vtkSingularityHand(const vtkSingularityHand&) = delete;
  void operator=(const vtkSingularityHand&) = delete;
};

#endif
