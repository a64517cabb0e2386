// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPDirectionFieldSingularities
 * @brief edits the singularities of a field on several processes
 *
 * vtkPDirectionFieldSingularities gives what vtkDirectionFieldSingularities gives for the whole
 * surface.
 * The points of all processes are taken, those that several have alike once. The field goes back to
 * the pieces, each singularity to a process that has its triangle; a surface that was refined stays
 * on the process that has gathered.
 *
 * See vtkPDirectionFieldFilter for all that filters of several processes have in common.
 */

#ifndef vtkPDirectionFieldSingularities_h
#define vtkPDirectionFieldSingularities_h

#include "vtkDirectionFieldSingularities.h"
#include "vtkDirectionFieldsFiltersParallelModule.h" // For export macro
#include "vtkPDirectionFieldFilter.h"

class VTKDIRECTIONFIELDSFILTERSPARALLEL_EXPORT vtkPDirectionFieldSingularities
  : public vtkPDirectionFieldFilterOf(vtkDirectionFieldSingularities)
{
public:
  static vtkPDirectionFieldSingularities* New();
  vtkTypeMacro(vtkPDirectionFieldSingularities, vtkDirectionFieldSingularities);

  vtkPDirectionFieldFilterMethods

    protected : vtkPDirectionFieldSingularities();
  ~vtkPDirectionFieldSingularities() override = default;

private:
  vtkPDirectionFieldSingularities(const vtkPDirectionFieldSingularities&) = delete;
  void operator=(const vtkPDirectionFieldSingularities&) = delete;
};

#endif
