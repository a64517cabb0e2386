# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""A macro: each run is the next step of the playback of the same name. Checks what the sliders of
the panel have changed in the ParaView window."""
import os
import sys

from paraview import servermanager
from paraview.simple import *

sys.path.insert(0, os.environ["HOME"])
import Steps


def field():
    return FindSource("Field of bunny.ply")


def remesh():
    return next(source for source in GetSources().values()
                if source.GetXMLName() == "FieldAlignedRemesh")


def values(proxy, *names):
    """The values that have been applied."""
    return [getattr(proxy, name) for name in names]


def caption():
    words = FindSource("Summary of bunny.ply")
    return servermanager.Fetch(words).GetColumn(0).GetValue(0)


def check_undone():
    """The second move is undone, not the first one; the picture is that of its value."""
    assert values(field(), "EnergyBias") == [0.6], values(field(), "EnergyBias")
    other = DirectionField(Input=FindSource("bunny.ply"), UnitLength=1, EnergyBias=0.6)
    count = servermanager.Fetch(other, idx=1).GetNumberOfPoints()
    assert caption().startswith(f"{count} singularities"), (count, caption())
    Delete(other)
    SetActiveSource(field())


def check_waiting():
    assert values(field(), "EnergyBias", "Degree", "SingularityCost") == [0.6, 4, 1.0], (
        values(field(), "EnergyBias", "Degree", "SingularityCost"))


def check_applied():
    assert values(field(), "EnergyBias", "Degree", "SingularityCost") == [0.25, 2, 1.0], (
        values(field(), "EnergyBias", "Degree", "SingularityCost"))


def check_new():
    """A filter that has not been applied waits for that."""
    assert values(remesh(), "NumberOfFaces") == [5000], values(remesh(), "NumberOfFaces")


def check_count():
    """The slider of a count goes from 100 to a million in equal factors."""
    assert values(remesh(), "NumberOfFaces") == [251], values(remesh(), "NumberOfFaces")
    faces = remesh().GetDataInformation(0).GetNumberOfCells()
    assert 150 < faces < 400, faces


def check_preset():
    """A preset of the menu changes the field of what is selected, and shows it."""
    names = ("Degree", "Alignment", "CurvatureDirection", "ConstrainBoundary", "EnergyBias")
    assert values(field(), *names) == [2, "Principal Curvature", "Least Bent", 0, 0.0], (
        values(field(), *names))
    assert GetActiveSource() == field() and caption().startswith("10 singularities"), caption()


Steps.take_next([check_undone, check_waiting, check_applied, check_new, check_count,
                 check_preset])
