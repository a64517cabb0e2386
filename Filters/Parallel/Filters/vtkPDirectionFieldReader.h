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

class vtkMultiProcessController;

// The wrappers for Python and for clients of a server take no templates as base classes.
#ifndef __VTK_WRAP__
#define vtkDirectionFieldReader vtkPDirectionFieldFilter<vtkDirectionFieldReader>
#endif
class VTKDIRECTIONFIELDSFILTERSPARALLEL_EXPORT vtkPDirectionFieldReader
  : public vtkDirectionFieldReader
#ifndef __VTK_WRAP__
#undef vtkDirectionFieldReader
#endif
{
public:
  static vtkPDirectionFieldReader* New();
  vtkTypeMacro(vtkPDirectionFieldReader, vtkDirectionFieldReader);

#ifdef __VTK_WRAP__
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  void SetGatherLimit(vtkIdType limit);
  vtkIdType GetGatherLimit();
#endif

protected:
  vtkPDirectionFieldReader();
  ~vtkPDirectionFieldReader() override = default;

private:
  vtkPDirectionFieldReader(const vtkPDirectionFieldReader&) = delete;
  void operator=(const vtkPDirectionFieldReader&) = delete;
};

#endif
