# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Python trace: TestTrace.py PLUGIN"""
import sys

from paraview import servermanager, smtrace
from paraview.simple import *

import AllFigures
from Figures import figures, sets

LoadPlugin(sys.argv[1], remote=False, ns=globals())
AllFigures.switch_on()


def test_trace():
    """A trace names what was set, and does the same again."""
    sphere = Sphere(registrationName="mesh", ThetaResolution=24)
    view = CreateRenderView()
    config = smtrace.start_trace()
    config.SetFullyTraceSupplementalProxies(False)
    field = DirectionField(registrationName="field", Input=sphere, Degree=3, EnergyBias=-0.25,
                           ConstraintSolver="Least Squares")
    Show(field, view)
    singularities = Show(OutputPort(field, 1), view)
    text = smtrace.stop_trace()
    for line in ("DirectionField(registrationName='field', Input=mesh)", "Show(OutputPort(field, 1)"):
        assert line in text, (line, text)
    for name, value in (("Degree", "3"), ("EnergyBias", "-0.25"),
                        ("ConstraintSolver", "'Least Squares'")):
        assert sets(text, "field", name, value), (name, text)
    # What was left alone is left out.
    assert "MaximumIterations" not in text, text
    before = figures(servermanager.Fetch(field), servermanager.Fetch(field, idx=1))
    assert before["Total"] == 6, before

    ResetSession()
    Sphere(registrationName="mesh", ThetaResolution=24)
    CreateRenderView(registrationName="RenderView1")
    exec(compile(text, "trace", "exec"), dict(globals()))
    field = FindSource("field")
    assert (field.Degree, field.EnergyBias, field.ConstraintSolver) == (3, -0.25, "Least Squares")
    assert figures(servermanager.Fetch(field), servermanager.Fetch(field, idx=1)) == before


test_trace()
print("passed")
