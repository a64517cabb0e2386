// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPDirectionFieldReader
 * @brief reads the field of a surface whose pieces lie on several processes
 *
 * vtkPDirectionFieldReader gives what vtkDirectionFieldReader gives for the whole surface.
 * Rows of a file belong to points or cells in the order that the whole surface had: pieces need
 * global ids for that, or lie on one process. The field goes back to the pieces, each singularity
 * to a process that has its triangle.
 *
 * See vtkPDirectionFieldFilter for all that filters of several processes have in common.
 */

#ifndef vtkPDirectionFieldReader_h
#define vtkPDirectionFieldReader_h

#include "vtkDirectionFieldReader.h"
#include "vtkDirectionFieldsFiltersParallelModule.h" // For export macro
#include "vtkPDirectionFieldFilter.h"

class VTKDIRECTIONFIELDSFILTERSPARALLEL_EXPORT vtkPDirectionFieldReader
  : public vtkPDirectionFieldFilterOf(vtkDirectionFieldReader)
{
public:
  static vtkPDirectionFieldReader* New();
  vtkTypeMacro(vtkPDirectionFieldReader, vtkDirectionFieldReader);

  vtkPDirectionFieldFilterMethods

    protected : vtkPDirectionFieldReader();
  ~vtkPDirectionFieldReader() override = default;

private:
  vtkPDirectionFieldReader(const vtkPDirectionFieldReader&) = delete;
  void operator=(const vtkPDirectionFieldReader&) = delete;
};

#endif
