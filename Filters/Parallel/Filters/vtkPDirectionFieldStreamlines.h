// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPDirectionFieldStreamlines
 * @brief follows the lines of a direction field on several processes
 *
 * vtkPDirectionFieldStreamlines gives what vtkDirectionFieldStreamlines gives for the whole
 * surface.
 * The seeds of all processes are taken, those that several have alike once. Lines cross from piece
 * to piece as everywhere, and all of them are on the process that has gathered, as their nodes are.
 *
 * See vtkPDirectionFieldFilter for all that filters of several processes have in common.
 */

#ifndef vtkPDirectionFieldStreamlines_h
#define vtkPDirectionFieldStreamlines_h

#include "vtkDirectionFieldStreamlines.h"
#include "vtkDirectionFieldsFiltersParallelModule.h" // For export macro
#include "vtkPDirectionFieldFilter.h"

class VTKDIRECTIONFIELDSFILTERSPARALLEL_EXPORT vtkPDirectionFieldStreamlines
  : public vtkPDirectionFieldFilterOf(vtkDirectionFieldStreamlines)
{
public:
  static vtkPDirectionFieldStreamlines* New();
  vtkTypeMacro(vtkPDirectionFieldStreamlines, vtkDirectionFieldStreamlines);

  vtkPDirectionFieldFilterMethods

    protected : vtkPDirectionFieldStreamlines();
  ~vtkPDirectionFieldStreamlines() override = default;

private:
  vtkPDirectionFieldStreamlines(const vtkPDirectionFieldStreamlines&) = delete;
  void operator=(const vtkPDirectionFieldStreamlines&) = delete;
};

#endif
