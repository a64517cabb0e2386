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

class VTKDIRECTIONFIELDSFILTERSPARALLEL_EXPORT vtkPStripePattern
  : public vtkPDirectionFieldFilterOf(vtkStripePattern)
{
public:
  static vtkPStripePattern* New();
  vtkTypeMacro(vtkPStripePattern, vtkStripePattern);

  vtkPDirectionFieldFilterMethods

    protected : vtkPStripePattern();
  ~vtkPStripePattern() override = default;

private:
  vtkPStripePattern(const vtkPStripePattern&) = delete;
  void operator=(const vtkPStripePattern&) = delete;
};

#endif
