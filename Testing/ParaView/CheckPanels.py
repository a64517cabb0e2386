# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""A macro: each run makes the next filter, whose panel ParaView then shows and the playback Panels
measures, with the switches on that show further rows."""
import functools
import os
import sys

from paraview.simple import *

sys.path.insert(0, os.environ["HOME"])
import Steps

FILTERS = (
    ("DirectionField", {"Alignment": "Principal Curvature", "Degree": 2, "ConstrainSharpEdges": 1,
                        "ConstrainCurvature": 1, "UnitLength": 1}),
    ("DirectionField", {"Alignment": "Principal Curvature", "UseShift": 1}),
    ("DirectionFieldGlyphs", {}), ("DirectionFieldStreamlines", {}), ("StripePattern", {}),
    ("EditSingularities", {}), ("GuidanceFromCurves", {}), ("CompareDirectionFields", {}),
    ("ReadDirectionField", {}), ("FieldAlignedRemesh", {}),
    ("FieldAlignedRemesh", {"SizeMode": "Edge Length"}))


def make(name, properties):
    field = FindSource("DirectionField1")
    if field:
        field.UpdatePipeline()
    SetActiveSource(globals()[name](Input=field or GetActiveSource(), **properties))


Steps.take_next([functools.partial(make, *filter) for filter in FILTERS])
