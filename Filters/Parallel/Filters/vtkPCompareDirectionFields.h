// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPCompareDirectionFields
 * @brief compares two fields on a surface whose pieces lie on several processes
 *
 * vtkPCompareDirectionFields gives what vtkCompareDirectionFields gives for the whole surface.
 * Both inputs have the same pieces. The differences go back to them; the pairs of singularities are
 * on the process that has gathered.
 *
 * See vtkPDirectionFieldFilter for all that filters of several processes have in common.
 */

#ifndef vtkPCompareDirectionFields_h
#define vtkPCompareDirectionFields_h

#include "vtkCompareDirectionFields.h"
#include "vtkDirectionFieldsFiltersParallelModule.h" // For export macro
#include "vtkPDirectionFieldFilter.h"

class VTKDIRECTIONFIELDSFILTERSPARALLEL_EXPORT vtkPCompareDirectionFields
  : public vtkPDirectionFieldFilterOf(vtkCompareDirectionFields)
{
public:
  static vtkPCompareDirectionFields* New();
  vtkTypeMacro(vtkPCompareDirectionFields, vtkCompareDirectionFields);

  vtkPDirectionFieldFilterMethods

    protected : vtkPCompareDirectionFields();
  ~vtkPCompareDirectionFields() override = default;

private:
  vtkPCompareDirectionFields(const vtkPCompareDirectionFields&) = delete;
  void operator=(const vtkPCompareDirectionFields&) = delete;
};

#endif
