// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPGuidanceCurves
 * @brief guides a field by curves on a surface whose pieces lie on several processes
 *
 * vtkPGuidanceCurves gives what vtkGuidanceCurves gives for the whole surface.
 * The curves of all processes are taken, those that several have alike once. The vectors go back to
 * the pieces; the strokes are on the process that has gathered.
 *
 * See vtkPDirectionFieldFilter for all that filters of several processes have in common.
 */

#ifndef vtkPGuidanceCurves_h
#define vtkPGuidanceCurves_h

#include "vtkDirectionFieldsFiltersParallelModule.h" // For export macro
#include "vtkGuidanceCurves.h"
#include "vtkPDirectionFieldFilter.h"

class vtkMultiProcessController;

// The wrappers for Python and for clients of a server take no templates as base classes.
#ifndef __VTK_WRAP__
#define vtkGuidanceCurves vtkPDirectionFieldFilter<vtkGuidanceCurves>
#endif
class VTKDIRECTIONFIELDSFILTERSPARALLEL_EXPORT vtkPGuidanceCurves : public vtkGuidanceCurves
#ifndef __VTK_WRAP__
#undef vtkGuidanceCurves
#endif
{
public:
  static vtkPGuidanceCurves* New();
  vtkTypeMacro(vtkPGuidanceCurves, vtkGuidanceCurves);

#ifdef __VTK_WRAP__
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  void SetGatherLimit(vtkIdType limit);
  vtkIdType GetGatherLimit();
#endif

protected:
  vtkPGuidanceCurves();
  ~vtkPGuidanceCurves() override = default;

private:
  vtkPGuidanceCurves(const vtkPGuidanceCurves&) = delete;
  void operator=(const vtkPGuidanceCurves&) = delete;
};

#endif
