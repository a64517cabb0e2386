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

class VTKDIRECTIONFIELDSFILTERSPARALLEL_EXPORT vtkPGuidanceCurves
  : public vtkPDirectionFieldFilterOf(vtkGuidanceCurves)
{
public:
  static vtkPGuidanceCurves* New();
  vtkTypeMacro(vtkPGuidanceCurves, vtkGuidanceCurves);

  vtkPDirectionFieldFilterMethods

    protected : vtkPGuidanceCurves();
  ~vtkPGuidanceCurves() override = default;

private:
  vtkPGuidanceCurves(const vtkPGuidanceCurves&) = delete;
  void operator=(const vtkPGuidanceCurves&) = delete;
};

#endif
