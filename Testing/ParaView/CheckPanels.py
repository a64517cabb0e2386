# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""A macro: each run makes the next filter, whose panel ParaView then shows and the playback Panels
measures, with the switches on that show further rows."""
import os
import traceback

from paraview.simple import *

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


step = int(os.environ.get("DIRECTIONFIELDS_TEST_STEP", "0"))
os.environ["DIRECTIONFIELDS_TEST_STEP"] = str(step + 1)
verdict = "passed\n" if step + 1 == len(FILTERS) else None
try:
    make(*FILTERS[step])
except BaseException:
    verdict = traceback.format_exc()
# The first failure is the one that counts.
path = os.path.join(os.environ["DIRECTIONFIELDS_TEST_OUTPUT"], "Panels.txt")
if verdict and not os.path.exists(path):
    with open(path, "w") as file:
        file.write(verdict)
