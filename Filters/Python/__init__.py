# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Direction fields in plain VTK: from directionfields_vtk import vtkDirectionField."""

from .vtkDirectionFieldsFilters import (
    vtkAbaqusMeshWriter,
    vtkCompareDirectionFields,
    vtkDirectionField,
    vtkDirectionFieldGlyphs,
    vtkDirectionFieldReader,
    vtkDirectionFieldSingularities,
    vtkDirectionFieldStreamlines,
    vtkDirectionFieldWriter,
    vtkFieldAlignedRemesh,
    vtkGuidanceCurves,
    vtkStripePattern,
)
from .vtkDirectionFieldsFiltersParallel import (
    vtkPCompareDirectionFields,
    vtkPDirectionField,
    vtkPDirectionFieldGlyphs,
    vtkPDirectionFieldReader,
    vtkPDirectionFieldSingularities,
    vtkPDirectionFieldStreamlines,
    vtkPDirectionFieldWriter,
    vtkPFieldAlignedRemesh,
    vtkPGatheredSurface,
    vtkPGuidanceCurves,
    vtkPStripePattern,
)

__all__ = [
    "vtkAbaqusMeshWriter",
    "vtkCompareDirectionFields",
    "vtkDirectionField",
    "vtkDirectionFieldGlyphs",
    "vtkDirectionFieldReader",
    "vtkDirectionFieldSingularities",
    "vtkDirectionFieldStreamlines",
    "vtkDirectionFieldWriter",
    "vtkFieldAlignedRemesh",
    "vtkGuidanceCurves",
    "vtkPCompareDirectionFields",
    "vtkPDirectionField",
    "vtkPDirectionFieldGlyphs",
    "vtkPDirectionFieldReader",
    "vtkPDirectionFieldSingularities",
    "vtkPDirectionFieldStreamlines",
    "vtkPDirectionFieldWriter",
    "vtkPFieldAlignedRemesh",
    "vtkPGatheredSurface",
    "vtkPGuidanceCurves",
    "vtkPStripePattern",
    "vtkStripePattern",
]
