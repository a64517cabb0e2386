# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files, guidance from curves and comparison in Python: TestFieldTools.py PLUGIN PRINT_PROPERTIES DIRECTORY

PRINT_PROPERTIES is the program that prints the defaults and ranges of the C++ classes."""
import locale
import math
import os
import sys

from paraview import servermanager
from paraview.simple import *

import AllFigures
from Properties import check_properties, check_property, printed

LoadPlugin(sys.argv[1], remote=False, ns=globals())
AllFigures.switch_on()
FOLDER = os.path.join(sys.argv[3], "FieldTools")
os.makedirs(FOLDER, exist_ok=True)
ENUMERATIONS = {"ReadDirectionField": ["Automatic", "Cells", "Points"],
                "DirectionFieldWriter": ["Cells", "Points"]}
ADVANCED = {"ReadDirectionField": ["FieldOn", "GatherLimit"], "DirectionFieldWriter": [],
            "GuidanceFromCurves": ["Falloff", "GatherLimit", "MaximumDistance"],
            "CompareDirectionFields": ["GatherLimit"]}


def mesh():
    return Sphere(ThetaResolution=32, PhiResolution=24)


def clean(name):
    for ending in ("rosy", "ffield", "rawfield", "sing", "sharp", "obj"):
        path = os.path.join(FOLDER, f"{name}.{ending}")
        if os.path.exists(path):
            os.remove(path)


def numbers(data, name):
    return data.GetFieldData().GetArray(name).GetTuple(0)


def make(name):
    field = DirectionField(Input=mesh())
    if name == "ReadDirectionField":
        return ReadDirectionField(Input=mesh(), FileName="")
    if name == "GuidanceFromCurves":
        return GuidanceFromCurves(Input=mesh(), Curves=SplineSource())
    if name == "CompareDirectionFields":
        return CompareDirectionFields(Input=field, Other=field)
    if name == "AbaqusMeshWriter":
        return servermanager.writers.AbaqusMeshWriter(Input=field)
    return servermanager.writers.DirectionFieldWriter(Input=field)


def test_properties():
    """Defaults and ranges equal those of C++, and everything is documented."""
    names = ("ReadDirectionField", "DirectionFieldWriter", "AbaqusMeshWriter",
             "GuidanceFromCurves", "CompareDirectionFields")
    for name, figures in zip(names, printed(sys.argv[2], *names)):
        proxy = make(name)
        enumerations = {"FieldOn": ENUMERATIONS.get(name)}
        if name.endswith("Writer"):
            for own in figures:
                check_property(proxy.SMProxy.GetProperty(own), own, figures[own], enumerations)
            continue
        check_properties(proxy, figures, enumerations, ADVANCED[name],
                         others=("Input", "Curves", "Other", "FileName"))


def test_labels():
    for name, label in (("ReadDirectionField", "Read Direction Field"),
                        ("GuidanceFromCurves", "Guidance From Curves"),
                        ("CompareDirectionFields", "Compare Direction Fields")):
        assert make(name).SMProxy.GetXMLLabel() == label


def test_save_data():
    """File, Save Data offers the formats for surfaces, and writes what belongs together."""
    field = DirectionField(Input=mesh())
    field.UpdatePipeline()
    factory = servermanager.vtkSMProxyManager.GetProxyManager().GetWriterFactory()
    formats = factory.GetSupportedFileTypes(field.SMProxy, 0)
    for ending in ("rosy", "ffield", "rawfield", "sing"):
        assert f"*.{ending}" in formats, formats
    expected = {"rosy": {"rosy", "obj", "sharp"}, "ffield": {"ffield", "obj"},
                "rawfield": {"rawfield", "obj", "sing"}, "sing": {"sing", "obj"}}
    for ending, endings in expected.items():
        name = f"saved-{ending}"
        clean(name)
        SaveData(os.path.join(FOLDER, f"{name}.{ending}"), proxy=field)
        written = {file.split(".")[-1] for file in os.listdir(FOLDER)
                   if file.startswith(name + ".")}
        assert written == endings, written
    clean("points")
    SaveData(os.path.join(FOLDER, "points.rawfield"), proxy=field, FieldOn="Points")
    with open(os.path.join(FOLDER, "points.rawfield"), encoding="ascii") as file:
        assert file.readline() == "4 706\n"


def test_save_mesh():
    """File, Save Data offers the file for solvers; arrays for regions and axes can be chosen."""
    divided = PythonCalculator(Input=mesh(), ArrayAssociation="Cell Data", ArrayName="Part",
                               Expression="(numpy.arange(inputs[0].GetNumberOfCells()) > 9).astype(int)")
    divided.UpdatePipeline()
    factory = servermanager.vtkSMProxyManager.GetProxyManager().GetWriterFactory()
    assert "*.inp" in factory.GetSupportedFileTypes(divided.SMProxy, 0)
    writer = servermanager.writers.AbaqusMeshWriter(Input=divided)
    assert "Part" in writer.GetProperty("RegionArray").Available
    path = os.path.join(FOLDER, "mesh.inp")
    SaveData(path, proxy=divided, RegionArray="Part", SecondOrder=1, Thickness=0.5)
    with open(path, encoding="ascii") as file:
        lines = file.read().splitlines()
    for line in ("*ELSET, ELSET=PART_0", "*ELSET, ELSET=PART_1", "*ELEMENT, TYPE=S6, ELSET=EALL",
                 "*SHELL SECTION, ELSET=PART_1, MATERIAL=PART_1"):
        assert lines.count(line) == 1, line


def test_save_regions():
    """Save Data writes the regions that a mesh was made for, if nobody chooses others."""
    divided = PythonCalculator(Input=mesh(), ArrayAssociation="Cell Data", ArrayName="Part",
                               Expression="(numpy.arange(inputs[0].GetNumberOfCells()) > 9).astype(int)")
    remesh = FieldAlignedRemesh(Input=divided, NumberOfFaces=100, RegionArray="Part")
    remesh.UpdatePipeline()
    writer = servermanager.writers.AbaqusMeshWriter(Input=remesh)
    regions = writer.GetProperty("RegionArray")
    assert regions.GetData() == "Automatic" and regions.Available[0] == "Automatic", regions
    path = os.path.join(FOLDER, "regions.inp")
    for chosen, count in (({}, 2), ({"RegionArray": "None"}, 0)):
        SaveData(path, proxy=remesh, **chosen)
        with open(path, encoding="ascii") as file:
            assert file.read().count("*ELSET, ELSET=PART_") == count, chosen


def test_decimal_comma():
    """Fields are written, opened and shown as ever where numbers have a decimal comma."""
    try:
        locale.setlocale(locale.LC_ALL, "de_DE.UTF-8")
    except locale.Error:
        print("skipped: this machine has no de_DE.UTF-8 (package locales)")
        return
    try:
        assert locale.localeconv()["decimal_point"] == ","
        field = DirectionField(Input=mesh())
        for ending in ("rosy", "ffield", "rawfield"):
            clean("comma")
            SaveData(os.path.join(FOLDER, f"comma.{ending}"), proxy=field)
            opened = OpenDataFile(os.path.join(FOLDER, f"comma.{ending}"))
            opened.UpdatePipeline()
            found, wanted = (proxy.GetDataInformation().GetBounds() for proxy in (opened, field))
            assert all(math.isclose(a, b, abs_tol=1e-6) for a, b in zip(found, wanted)), (found, wanted)
            assert opened.GetDataInformation(1).GetNumberOfPoints() > 0, ending
            display = Show(opened, CreateRenderView())
            assert list(display.AmbientColor) == [0.93, 0.91, 0.87], display.AmbientColor
    finally:
        locale.setlocale(locale.LC_ALL, "C")


def test_time_steps():
    """Each time step of a moving surface becomes a field and a mesh of its own."""
    files = []
    for i, radius in enumerate((0.5, 1.0, 2.0)):
        files.append(os.path.join(FOLDER, f"moving{i}.vtp"))
        SaveData(files[-1], proxy=Sphere(Radius=radius), DataMode="Binary")
        clean(f"moving_{i}")
    field = DirectionField(Input=XMLPolyDataReader(FileName=files))
    SaveData(os.path.join(FOLDER, "moving.rosy"), proxy=field, WriteTimeSteps=1)
    for i, radius in enumerate((0.5, 1.0, 2.0)):
        with open(os.path.join(FOLDER, f"moving_{i}.obj"), encoding="ascii") as file:
            first = [line.split() for line in file if line.startswith("v ")][0]
        assert math.isclose(math.hypot(*map(float, first[1:])), radius), (i, first)
        assert os.path.exists(os.path.join(FOLDER, f"moving_{i}.rosy"))


def test_round_trip():
    """What is saved is read back, with true indices, and glyphs show it."""
    field = DirectionField(Input=mesh())
    for ending in ("rosy", "ffield", "rawfield"):
        path = os.path.join(FOLDER, f"round.{ending}")
        clean("round")
        SaveData(path, proxy=field)
        back = ReadDirectionField(Input=mesh(), FileName=path)
        data = servermanager.Fetch(back)
        assert numbers(data, "IndexSum") == (8.0,)
        # File, Open takes the mesh beside it, too.
        opened = OpenDataFile(path)
        assert opened.GetXMLName() == "DirectionFieldFile", opened
        figures = [servermanager.Fetch(proxy).GetFieldData().GetAbstractArray("Summary").GetValue(0)
                   for proxy in (back, opened)]
        assert figures[0] == figures[1] and " singularities (" in figures[0], figures
        assert numbers(data, "EulerCharacteristic") == (2.0,)
        assert data.GetPointData().GetVectors().GetName() == "Direction0"
        assert data.GetPointData().GetArray("Direction3") is not None
        singularities = servermanager.Fetch(back, idx=1)
        assert singularities.GetNumberOfPoints() >= 8
        glyphs = servermanager.Fetch(DirectionFieldGlyphs(Input=back))
        assert numbers(glyphs, "NumberOfGlyphs")[0] > 425
        comparison = servermanager.Fetch(CompareDirectionFields(Input=field, Other=back))
        assert numbers(comparison, "MeanAngleDifference")[0] < 2.0
    # On points, in single precision as the sphere's: half of the digits of an angle near zero.
    clean("round")
    path = os.path.join(FOLDER, "round.rawfield")
    SaveData(path, proxy=field, FieldOn="Points")
    comparison = servermanager.Fetch(CompareDirectionFields(
        Input=field, Other=ReadDirectionField(Input=mesh(), FileName=path)))
    assert numbers(comparison, "MaximumAngleDifference")[0] < 1e-4
    assert numbers(comparison, "MatchedSingularities")[1:] == (0.0, 0.0)


def test_curves():
    """A poly line on the surface guides a field."""
    points = []
    for i in range(20):
        points += [0.5 * math.cos(0.3 * i), 0.5 * math.sin(0.3 * i), 0.0]
    guided = GuidanceFromCurves(Input=mesh(), Curves=PolyLineSource(Points=points), Degree=4,
                                Radius=0.1)
    data = servermanager.Fetch(guided)
    weights = data.GetPointData().GetArray("GuidanceWeights")
    assert weights.GetRange()[0] == 0.0 and 0.5 < weights.GetRange()[1] <= 1.0, weights.GetRange()
    field = DirectionField(Input=guided, Alignment="Point Vectors")
    field.GuidanceVectors = "GuidanceVectors"
    field.UpdatePipeline()
    assert servermanager.Fetch(field).GetPointData().GetArray("Direction0") is not None


def test_composite():
    group = GroupDatasets(Input=[mesh(), Sphere(ThetaResolution=16, PhiResolution=12)])
    field = DirectionField(Input=group)
    other = DirectionField(Input=group, EnergyBias=0.9)
    data = servermanager.Fetch(CompareDirectionFields(Input=field, Other=other))
    blocks = [data.GetBlock(i) for i in range(data.GetNumberOfBlocks())]
    assert len(blocks) == 2
    for block in blocks:
        assert block.GetPointData().GetArray("AngleDifference") is not None
    guided = servermanager.Fetch(GuidanceFromCurves(Input=group, Curves=SplineSource()))
    assert guided.GetBlock(1).GetPointData().GetArray("GuidanceVectors") is not None


def test_state():
    state = os.path.join(FOLDER, "state.pvsm")
    path = os.path.join(FOLDER, "saved-rosy.rosy")
    RenameSource("read", ReadDirectionField(Input=mesh(), FileName=path, FieldOn="Cells"))
    RenameSource("guided", GuidanceFromCurves(Input=mesh(), Curves=SplineSource(), Degree=2,
                                              Radius=0.25, Falloff=0.75, MaximumDistance=3.0))
    field = DirectionField(Input=mesh())
    RenameSource("compared", CompareDirectionFields(Input=field, Other=field,
                                                    MatchSingularities=0, DivergenceAndCurl=1))
    SaveState(state)
    ResetSession()
    LoadState(state)
    read = FindSource("read")
    assert (read.FileName, read.FieldOn) == (path, "Cells"), read.FileName
    guided = FindSource("guided")
    assert (guided.Degree, guided.Radius, guided.Falloff, guided.MaximumDistance) == (
        2, 0.25, 0.75, 3.0)
    compared = FindSource("compared")
    assert (compared.MatchSingularities, compared.DivergenceAndCurl) == (0, 1)


test_properties()
test_labels()
test_save_data()
test_decimal_comma()
test_time_steps()
test_round_trip()
test_curves()
test_composite()
test_state()
print("passed")
