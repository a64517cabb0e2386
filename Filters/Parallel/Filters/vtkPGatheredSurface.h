// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPGatheredSurface
 * @brief brings a surface whose pieces lie on several processes to one of them
 *
 * vtkPGatheredSurface makes one surface of the pieces of all processes, on the one with the largest
 * piece, for whatever takes a surface as a whole: each point of several pieces is there once, and
 * so is each polygon that others have as a ghost cell. With global ids the points have the order of
 * these. The other processes have a surface without points, with the same arrays. With one process
 * the output is the input.
 *
 * See vtkPDirectionFieldFilter for all that filters of several processes have in common.
 */

#ifndef vtkPGatheredSurface_h
#define vtkPGatheredSurface_h

#include "vtkDirectionFieldAlgorithm.h"
#include "vtkDirectionFieldsFiltersParallelModule.h" // For export macro
#include "vtkPDirectionFieldFilter.h"

class VTKDIRECTIONFIELDSFILTERSPARALLEL_EXPORT vtkPGatheredSurface
  : public vtkPDirectionFieldFilterOf(vtkDirectionFieldAlgorithm)
{
public:
  static vtkPGatheredSurface* New();
  vtkTypeMacro(vtkPGatheredSurface, vtkDirectionFieldAlgorithm);

  vtkPDirectionFieldFilterMethods

    protected : vtkPGatheredSurface();
  ~vtkPGatheredSurface() override = default;

  void Execute(
    const Ports& inputs, const Ports& outputs, const DirectionFields::Progress& progress) override;

private:
  vtkPGatheredSurface(const vtkPGatheredSurface&) = delete;
  void operator=(const vtkPGatheredSurface&) = delete;
};

#endif
