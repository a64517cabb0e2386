// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPFieldAlignedRemesh
 * @brief makes one mesh of a surface whose pieces lie on several processes
 *
 * vtkPFieldAlignedRemesh gives what vtkFieldAlignedRemesh gives for the whole surface.
 * The mesh is on the process that has gathered, without seams, as its irregular vertices are.
 *
 * See vtkPDirectionFieldFilter for all that filters of several processes have in common.
 */

#ifndef vtkPFieldAlignedRemesh_h
#define vtkPFieldAlignedRemesh_h

#include "vtkDirectionFieldsFiltersParallelModule.h" // For export macro
#include "vtkFieldAlignedRemesh.h"
#include "vtkPDirectionFieldFilter.h"

class vtkMultiProcessController;

// The wrappers for Python and for clients of a server take no templates as base classes.
#ifndef __VTK_WRAP__
#define vtkFieldAlignedRemesh vtkPDirectionFieldFilter<vtkFieldAlignedRemesh>
#endif
class VTKDIRECTIONFIELDSFILTERSPARALLEL_EXPORT vtkPFieldAlignedRemesh : public vtkFieldAlignedRemesh
#ifndef __VTK_WRAP__
#undef vtkFieldAlignedRemesh
#endif
{
public:
  static vtkPFieldAlignedRemesh* New();
  vtkTypeMacro(vtkPFieldAlignedRemesh, vtkFieldAlignedRemesh);

#ifdef __VTK_WRAP__
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  void SetGatherLimit(vtkIdType limit);
  vtkIdType GetGatherLimit();
#endif

protected:
  vtkPFieldAlignedRemesh();
  ~vtkPFieldAlignedRemesh() override = default;

private:
  vtkPFieldAlignedRemesh(const vtkPFieldAlignedRemesh&) = delete;
  void operator=(const vtkPFieldAlignedRemesh&) = delete;
};

#endif
