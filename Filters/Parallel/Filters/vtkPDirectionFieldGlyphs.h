// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPDirectionFieldGlyphs
 * @brief draws the glyphs of a direction field on a surface whose pieces lie on several processes
 *
 * vtkPDirectionFieldGlyphs gives the glyphs that vtkDirectionFieldGlyphs draws on the whole
 * surface: spread over the seams between pieces as everywhere, none twice. Spacing and
 * MaximumNumberOfGlyphs mean the whole surface. Each glyph goes to a process that has its point
 * `PointId`, the id of that piece.
 *
 * See vtkPDirectionFieldFilter for all that filters of several processes have in common.
 */

#ifndef vtkPDirectionFieldGlyphs_h
#define vtkPDirectionFieldGlyphs_h

#include "vtkDirectionFieldGlyphs.h"
#include "vtkDirectionFieldsFiltersParallelModule.h" // For export macro
#include "vtkPDirectionFieldFilter.h"

class VTKDIRECTIONFIELDSFILTERSPARALLEL_EXPORT vtkPDirectionFieldGlyphs
  : public vtkPDirectionFieldFilterOf(vtkDirectionFieldGlyphs)
{
public:
  static vtkPDirectionFieldGlyphs* New();
  vtkTypeMacro(vtkPDirectionFieldGlyphs, vtkDirectionFieldGlyphs);

  vtkPDirectionFieldFilterMethods

    protected : vtkPDirectionFieldGlyphs();
  ~vtkPDirectionFieldGlyphs() override = default;

private:
  vtkPDirectionFieldGlyphs(const vtkPDirectionFieldGlyphs&) = delete;
  void operator=(const vtkPDirectionFieldGlyphs&) = delete;
};

#endif
