// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPStripePattern
 * @brief covers a surface whose pieces lie on several processes with stripes
 *
 * vtkPStripePattern gives what vtkStripePattern gives for the whole surface.
 * Lines, bands and branch points are on the process that has gathered.
 *
 * See vtkPDirectionFieldFilter for all that filters of several processes have in common.
 */

#ifndef vtkPStripePattern_h
#define vtkPStripePattern_h

#include "vtkDirectionFieldsFiltersParallelModule.h" // For export macro
#include "vtkPDirectionFieldFilter.h"
#include "vtkStripePattern.h"

class vtkMultiProcessController;

// The wrappers for Python and for clients of a server take no templates as base classes.
#ifndef __VTK_WRAP__
#define vtkStripePattern vtkPDirectionFieldFilter<vtkStripePattern>
#endif
class VTKDIRECTIONFIELDSFILTERSPARALLEL_EXPORT vtkPStripePattern : public vtkStripePattern
#ifndef __VTK_WRAP__
#undef vtkStripePattern
#endif
{
public:
  static vtkPStripePattern* New();
  vtkTypeMacro(vtkPStripePattern, vtkStripePattern);

#ifdef __VTK_WRAP__
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  void SetGatherLimit(vtkIdType limit);
  vtkIdType GetGatherLimit();
#endif

protected:
  vtkPStripePattern();
  ~vtkPStripePattern() override = default;

private:
  vtkPStripePattern(const vtkPStripePattern&) = delete;
  void operator=(const vtkPStripePattern&) = delete;
};

#endif
