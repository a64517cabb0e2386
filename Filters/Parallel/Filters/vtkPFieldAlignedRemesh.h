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

class VTKDIRECTIONFIELDSFILTERSPARALLEL_EXPORT vtkPFieldAlignedRemesh
  : public vtkPDirectionFieldFilterOf(vtkFieldAlignedRemesh)
{
public:
  static vtkPFieldAlignedRemesh* New();
  vtkTypeMacro(vtkPFieldAlignedRemesh, vtkFieldAlignedRemesh);

  vtkPDirectionFieldFilterMethods

    protected : vtkPFieldAlignedRemesh();
  ~vtkPFieldAlignedRemesh() override = default;

private:
  vtkPFieldAlignedRemesh(const vtkPFieldAlignedRemesh&) = delete;
  void operator=(const vtkPFieldAlignedRemesh&) = delete;
};

#endif
