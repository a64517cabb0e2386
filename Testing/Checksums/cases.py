# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""What is computed on each surface: the filters with their options, on fields of several degrees.

Options are dictionaries of properties; several in a row are set one after another on the same filter, which
executes after each, so that what it keeps between executions counts, too. Stretched is no property: it scales the
x coordinates of the input by a factor, as a step of a time series would.
"""

import itertools
import os
import pathlib
import tempfile

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData

import digests
import meshes

ALIGNED = {"Alignment": 1}
GUIDED = {"Alignment": 2, "GuidanceVectors": "Guide"}
BOUND = {"ConstrainBoundary": True, "ConstrainSharpEdges": True}
HELD = {"ConstrainGuidance": True, "GuidanceVectors": "Guide", "GuidanceWeights": "Weight"}
DIRECT, MULTIGRID = {"Solver": 2}, {"Solver": 1}


def of(degree, *options):
    """The options of a field of a degree."""
    return dict(itertools.chain([("Degree", degree)], *(some.items() for some in options)))


# The fields that the other filters take, on all surfaces but large ones.
DEGREES = (1, 2, 3, 4, 6)
BASIC_FIELDS = [
    [of(2, {"EnergyBias": 1.0})],
    [of(2, ALIGNED)],
    [of(2, ALIGNED, {"CurvatureDirection": 3, "CurvatureScale": 3.0})],
    [of(1, GUIDED)],
    [of(4, GUIDED, {"GuidanceWeights": "Weight", "AlignmentStrength": 0.8})],
    [of(4, ALIGNED, BOUND)],
    [of(3, BOUND)],
    [of(4, HELD)],
    [of(4, {"ConstrainCurvature": True, "ConstraintSolver": 0})],
    [of(4, {"UnitLength": True})],
    [of(2, BOUND, {"UnitLength": True, "SingularityCost": 0.5})],
    [of(4, {"IntrinsicDelaunay": True, "CellDirections": True})],
    [of(4, MULTIGRID)],
    [of(4, {"NumberOfThreads": 1})],
    [of(4, {"NumberOfThreads": 2})],
    [of(4, {"MergePoints": 0})],
]
FULL_FIELDS = [
    [of(5)],
    [of(16)],
    [of(4, {"EnergyBias": -1.0})],
    [of(1, {"EnergyBias": 0.5})],
    [of(2, DIRECT, {"Tolerance": 1e-11})],
    [of(2, MULTIGRID, {"Tolerance": 1e-3})],
    [of(4, MULTIGRID, {"MaximumIterations": 1})],
    [of(4, {"MergePoints": 1})],
    [of(2, {"CellDirections": True})],
    [of(1, {"CellDirections": True})],
    *([of(2, ALIGNED, {"CurvatureDirection": kind})] for kind in (1, 2)),
    [of(4, ALIGNED, {"UseShift": True, "Shift": 3.0})],
    [of(4, ALIGNED, {"AlignmentStrength": 0.0})],
    [of(4, ALIGNED, {"AlignmentStrength": 1.0, "CurvatureScale": 8.0})],
    [of(6, GUIDED, {"GuidanceWeights": "Weight"})],
    [of(4, GUIDED, {"EnergyBias": 1.0, "IntrinsicDelaunay": True})],
    [of(4, ALIGNED, MULTIGRID, {"NumberOfThreads": 2})],
    [of(4, {"ConstrainSharpEdges": True, "FeatureAngle": 10.0, "MinimumFeatureLength": 0.0})],
    [of(1, {"ConstrainSharpEdges": True, "FeatureAngle": 20.0})],
    [of(2, {"ConstrainCurvature": True, "CurvatureTolerance": 0.5, "ConsistencyAngle": 8.0})],
    [of(4, {"ConstrainCurvature": True, "CurvatureTolerance": 0.2, "DropConstraintsAtSingularities": True})],
    [of(4, BOUND, HELD, {"ConstraintSolver": 0, "IntrinsicDelaunay": True})],
    [of(4, BOUND, GUIDED, MULTIGRID)],
    [of(2, BOUND, HELD, MULTIGRID, {"ConstraintSolver": 0})],
    [of(1, {"UnitLength": True})],
    [of(6, {"UnitLength": True, "SingularityCost": 2.0})],
    [of(4, ALIGNED, BOUND, {"UnitLength": True, "IntrinsicDelaunay": True})],
    [of(4, HELD, {"UnitLength": True, "EnergyBias": -0.5})],
    [of(4, ALIGNED), {"AlignmentStrength": 0.2}, {"AlignmentStrength": 0.9}],
    [of(4, ALIGNED, MULTIGRID), {"AlignmentStrength": 0.2}],
    [of(4), {"Degree": 2}, {"Alignment": 1}],
    [of(4, BOUND), {"ConstrainSharpEdges": False}, ALIGNED],
    [of(4, {"KeepStages": False}), ALIGNED],
    [of(4), {"Stretched": 1.02}, {"Stretched": 1.05}],
    [of(2, {"UnitLength": True}), {"Stretched": 1.02}],
    # Errors.
    [of(3, ALIGNED)],
    [of(4, {"Alignment": 2, "GuidanceVectors": "NoSuchArray"})],
    [of(4, {"ConstrainGuidance": True})],
    [of(4, GUIDED, {"GuidanceWeights": "Guide"})],
]
# The first of a degree is the one that the other filters take.
LARGE_FIELDS = [
    [of(4)],
    [of(4, DIRECT)],
    [of(2, MULTIGRID, {"NumberOfThreads": 2})],
    [of(2, ALIGNED)],
    [of(1, {"EnergyBias": 1.0})],
    [of(4, ALIGNED), {"AlignmentStrength": 0.25}],
    [of(4, BOUND, ALIGNED)],
    [of(4, HELD, DIRECT)],
    [of(4, HELD, {"ConstraintSolver": 0})],
    [of(4, {"UnitLength": True, "SingularityCost": 0.5})],
    [of(4, GUIDED, {"IntrinsicDelaunay": True})],
    [of(4), {"Stretched": 1.02}],
]

# For each filter on a field: degree, then the steps of its options.
BASIC_GLYPHS = [(1,), (2,), (4, {"GlyphType": 4, "MaximumNumberOfGlyphs": 200}), (6, {"GlyphMode": 1})]
FULL_GLYPHS = [
    *((4, {"GlyphType": kind, "Side": side}) for kind, side in ((1, 1), (2, 2), (3, 3))),
    (1, {"GlyphType": 4, "MaximumNumberOfGlyphs": 200}), (1, {"GlyphType": 1}), (3,),
    (2, {"GlyphMode": 1, "MaximumNumberOfGlyphs": 50}),
    (2, {"MaximumNumberOfGlyphs": 30, "Scale": 2.0, "Offset": -0.2}),
    (4, {"Spacing": 0.4, "FollowSurface": False}),
    (4, {"MaximumNumberOfGlyphs": 200}, {"Scale": 0.5}, {"MaximumNumberOfGlyphs": 20}),
]
BASIC_LINES = [
    (1,), (2,), (4,), (4, {"SeedType": 1}), (4, {"SeedType": 1, "StopAtCrossings": True}), (3, {"SeedType": 1}),
    (2, {"SeedType": 2}), (1, {"SeedType": 2, "IntegrationDirection": 1}),
]
FULL_LINES = [
    (3,), (6,), (6, {"SeedType": 1}), (1, {"SeedType": 1, "StopAtCrossings": True}), (2, {"SeedType": 1}),
    (4, {"SeparatingDistance": 0.15, "SeparatingDistanceRatio": 0.9}),
    (2, {"MaximumStreamlineLength": 1.0, "MinimumStreamlineLength": 0.2, "Offset": -0.1}),
    (4, {"MaximumNumberOfLines": 5}), (1, {"SeedType": 2, "IntegrationDirection": 2}),
]
BASIC_STRIPES = [(1,), (2, {"StripeDirection": 1}), (2, {"TextureCoordinates": True, "SpacingArray": "Size"})]
FULL_STRIPES = [
    (1, {"StripeDirection": 1, "LineOffset": 0.3}), (2, {"LineOffset": 0.2}),
    (2, {"LineOffset": 0.5, "Bands": False}), (2, {"Spacing": 0.05}),
    (2, {"Spacing": 0.15, "SpacingArray": "Weight"}),
    # Errors.
    (4,), (1, {"SpacingArray": "NoSuchArray"}),
]
COARSE, FINE = {"NumberOfFaces": 150}, {"NumberOfFaces": 1500}
BASIC_REMESH = [(None, COARSE), (4, COARSE), (6, COARSE, {"Element": 1}), (None, {**COARSE, "PureQuads": True})]
FULL_REMESH = [
    (None, {**COARSE, "Element": 1}),
    (4, {**COARSE, "KeepFeatures": False, "SmoothingIterations": 0}),
    (4, {**COARSE, "PureQuads": True, "SmoothingIterations": 0}),
    (4, {**COARSE, "FeatureAngle": 15.0, "NumberOfThreads": 2}),
    (4, {**COARSE, "SizingArray": "Size"}),
    (None, {**COARSE, "PureQuads": True, "SizingArray": "Size", "NumberOfThreads": 1}),
    (None, {"SizeMode": 1, "EdgeLength": 0.3}),
    (None, COARSE, {"NumberOfFaces": 400}, {"KeepStages": False, "FeatureAngle": 60.0}),
    (2, COARSE),
    # Errors.
    (4, {"SizeMode": 1, "EdgeLength": 0.0}), (4, {"SizingArray": "NoSuchArray"}),
]
MOVED = "moved"
# The points that are given: the field's own singularities, these moved, a pair, or a single one.
BASIC_EDITS = [
    (4, "own"), (4, MOVED), (2, MOVED, {"Objective": 1}), (1, "pair", {"SingularityMode": 1}),
    (4, "single", {"BalanceAutomatically": True}),
]
FULL_EDITS = [
    (4, "own", {"Objective": 1}), (6, MOVED, {"RefineWhereNeeded": True}), (4, "single"), (2, "none"),
    (4, "pair", {"SingularityMode": 1, "Objective": 1, "KeepStages": False}),
    (4, MOVED, {**ALIGNED, "AlignmentStrength": 0.6}), (3, MOVED, GUIDED),
    (4, MOVED, {"KeepConstraints": False}, {"Objective": 1}),
    (4, "pair", {"SingularityMode": 1}, {"Stretched": 1.01}),
    (2, "strong", {"RefineWhereNeeded": True, "BalanceAutomatically": True}),
]
BASIC_CURVES = [{}, {"Degree": 2, "Radius": 0.4}]
FULL_CURVES = [
    {"Degree": 1}, {"Degree": 1, "Radius": 0.5, "Falloff": 0.2}, {"Degree": 3, "MaximumDistance": 0.05},
    {"Degree": 6, "Radius": 1.5, "Falloff": 2.0},
]
FORMATS = ("rosy", "ffield", "rawfield", "sing")


def label(steps):
    """Options as text; steps on one filter are joined by 'then'."""
    return " then ".join(" ".join(f"{key}={value}" for key, value in step.items()) or "defaults" for step in steps)


def copy_of(data):
    copy = data.NewInstance()
    copy.ShallowCopy(data)
    return copy


def stretched(surface, factor):
    result = copy_of(surface)
    data = meshes.polydata(meshes.points_of(surface) * [factor, 1.0, 1.0], ())
    result.SetPoints(data.GetPoints())
    return result


def span(surface):
    """A corner of the box around a surface and its sides; unit lengths where it has none."""
    points = meshes.points_of(surface)
    points = points[np.isfinite(points).all(axis=1)]
    if not len(points):
        return np.zeros(3), np.ones(3)
    return points.min(axis=0), np.ptp(points, axis=0)


def curves_on(surface):
    """A circle and an open stroke through the box of a surface."""
    low, size = span(surface)
    angle = 2.0 * np.pi * np.arange(40) / 40
    circle = np.stack([0.5 + 0.3 * np.cos(angle), 0.5 + 0.3 * np.sin(angle), 0.8 + 0.0 * angle], axis=-1)
    stroke = np.stack([np.linspace(0.1, 0.9, 25)] * 3, axis=-1) * [1.0, 0.6, 0.9]
    points = low + size * np.concatenate([circle, stroke])
    return meshes.polydata(points, (), lines=[[*range(40), 0], range(40, 65)])


def seeds_on(surface):
    low, size = span(surface)
    places = np.array(list(itertools.product((0.2, 0.65), (0.3, 0.8), (0.1, 0.95))))
    return meshes.polydata(low + size * places, (), verts=[(k,) for k in range(len(places))])


def singular_points(kind, surface, singularities):
    """The points that say where the singularities are to be."""
    if kind == "own":
        return singularities
    low, size = span(surface)
    if kind == MOVED:
        result = copy_of(singularities)
        data = meshes.polydata(meshes.points_of(singularities) + 0.08 * size * [1.0, -1.0, 0.5], ())
        result.SetPoints(data.GetPoints())
        return result
    places, indices = {
        "pair": ([(0.2, 0.3, 0.9), (0.7, 0.6, 0.9)], [1, -1]), "single": ([(0.4, 0.4, 1.0)], [1]),
        "strong": ([(0.4, 0.4, 1.0), (0.6, 0.5, 0.0)], [3, 1]), "none": (np.zeros((0, 3)), np.zeros(0))}[kind]
    result = meshes.polydata(low + size * np.reshape(places, (-1, 3)), ())
    result.GetPointData().AddArray(meshes.array("SingularityIndex", np.array(indices, dtype=np.int32)))
    return result


def blocks_of(*surfaces):
    result = vtkMultiBlockDataSet()
    for k, surface in enumerate(surfaces):
        result.SetBlock(k, surface)
    return result


class Runner:
    """Runs filters, and gives each case's items to report(filter, options, items)."""

    def __init__(self, filters, report):
        self.filters = filters
        self.report = report
        self.messages = digests.Messages()

    def run(self, name, inputs, steps, of_field=""):
        """Executes a filter after each step of options; returns copies of its outputs."""
        algorithm = getattr(self.filters, name)()
        with self.messages:
            for port, data in enumerate(inputs):
                algorithm.SetInputDataObject(port, data)
            for step in steps:
                for key, value in step.items():
                    if key == "Stretched":
                        algorithm.SetInputDataObject(0, stretched(inputs[0], value))
                    else:
                        getattr(algorithm, f"Set{key}")(value)
                algorithm.Update()
        outputs = [copy_of(algorithm.GetOutputDataObject(k)) for k in range(algorithm.GetNumberOfOutputPorts())]
        items = [item for k, data in enumerate(outputs) for item in digests.describe_data(data, str(k))]
        self.report(name, of_field + label(steps), [*items, *self.messages.describe()])
        return outputs


class Cases(Runner):
    """All cases of one surface."""

    def __init__(self, filters, report, surface, extent):
        super().__init__(filters, report)
        self.surface = surface
        self.is_full = extent == meshes.FULL
        # The outputs of the fields by their degrees.
        self.fields = {}
        if extent == meshes.LARGE:
            self.run_large()
        else:
            self.run_small()

    def chosen(self, basic, full):
        return basic + full if self.is_full else basic

    def run_on_fields(self, name, cases, extra=()):
        """A filter on fields of their degrees, or on the surface alone where there is none."""
        for degree, *steps in cases:
            of_field = f"of degree {degree}: " if degree else ""
            inputs = [self.fields[degree][0] if degree else self.surface, *extra]
            self.run(name, inputs, steps or [{}], of_field)

    def run_small(self):
        for degree in DEGREES:
            self.fields[degree] = self.run("vtkDirectionField", [self.surface], [of(degree)])
        for steps in self.chosen(BASIC_FIELDS, FULL_FIELDS):
            self.run("vtkDirectionField", [self.surface], steps)
        self.run("vtkDirectionField", [self.fields[6][0]], [of(2)], "of a field of degree 6: ")
        self.run("vtkPDirectionField", [self.surface], [of(4, ALIGNED, BOUND)])
        self.run_on_fields("vtkDirectionFieldGlyphs", self.chosen(BASIC_GLYPHS, FULL_GLYPHS))
        self.run_on_fields("vtkPDirectionFieldGlyphs", [(2,)])
        self.run_on_fields(
            "vtkDirectionFieldStreamlines", self.chosen(BASIC_LINES, FULL_LINES), [seeds_on(self.surface)])
        self.run_on_fields("vtkStripePattern", self.chosen(BASIC_STRIPES, FULL_STRIPES))
        self.run_on_fields("vtkFieldAlignedRemesh", self.chosen(BASIC_REMESH, FULL_REMESH))
        self.run_edits()
        self.run_curves()
        self.run_comparisons()
        self.run_files()
        if self.is_full:
            self.run_blocks()

    def run_large(self):
        for steps in LARGE_FIELDS:
            outputs = self.run("vtkDirectionField", [self.surface], steps)
            self.fields.setdefault(steps[0]["Degree"], outputs)
        self.run_on_fields("vtkDirectionFieldGlyphs", [(4,)])
        self.run_on_fields("vtkDirectionFieldStreamlines", [(2,), (4, {"SeedType": 1, "StopAtCrossings": True})])
        self.run_on_fields("vtkStripePattern", [(2,)])
        self.run_on_fields("vtkFieldAlignedRemesh", [
            (None, FINE), (None, {**FINE, "Element": 1}), (4, {**FINE, "PureQuads": True})])
        self.edit(self.fields[4], 4, MOVED)

    def run_edits(self):
        """Singularities that are edited; constraints are kept where the field has some."""
        for degree, kind, *steps in self.chosen(BASIC_EDITS, FULL_EDITS):
            self.edit(self.fields[degree], degree, kind, *steps)
        bound = self.run("vtkDirectionField", [self.surface], [of(4, BOUND, {"FeatureAngle": 35.0})])
        self.edit(bound, "4 with constraints", "pair", {"SingularityMode": 1})

    def edit(self, outputs, degree, kind, *steps):
        """Edits the singularities of a field's outputs."""
        points = singular_points(kind, self.surface, outputs[1])
        of_field = f"of degree {degree}, {kind}: "
        self.run("vtkDirectionFieldSingularities", [outputs[0], points], steps or [{}], of_field)

    def run_curves(self):
        curves = curves_on(self.surface)
        for options in self.chosen(BASIC_CURVES, FULL_CURVES):
            guided = self.run("vtkGuidanceCurves", [self.surface, curves], [options])[0]
            if options == BASIC_CURVES[0]:
                arrays = {name: name for name in ("GuidanceVectors", "GuidanceWeights")}
                held = of(4, {"ConstrainGuidance": True}, arrays)
                self.run("vtkDirectionField", [guided], [held], "along curves: ")

    def run_comparisons(self):
        """Fields with others of another energy, and of another degree, which is an error."""
        fields = {degree: outputs[0] for degree, outputs in self.fields.items()}
        others = {
            degree: self.run("vtkDirectionField", [self.surface], [of(degree, {"EnergyBias": 0.9})])[0]
            for degree in (1, 2, 4)}
        for degree, other in others.items():
            options = {"DivergenceAndCurl": degree < 4}
            self.run("vtkCompareDirectionFields", [fields[degree], other], [options], f"of degree {degree}: ")
        if self.is_full:
            for degree, other, options in (
                    (4, 3, {}), (4, 4, {"DivergenceAndCurl": True}), (4, 4, {"MatchSingularities": False})):
                inputs = [fields[degree], others.get(other, fields[other])]
                self.run("vtkCompareDirectionFields", inputs, [options], f"of degrees {degree} and {other}: ")

    def run_files(self):
        """Files in all formats, and the fields that are read from them."""
        for degree, ending, place in itertools.product((1, 4) if self.is_full else (4,), FORMATS, (0, 1)):
            before = os.getcwd()
            with tempfile.TemporaryDirectory() as directory:
                # Messages and files name no directory.
                os.chdir(directory)
                try:
                    self.write_and_read(degree, f"field.{ending}", place)
                finally:
                    os.chdir(before)

    def write_and_read(self, degree, name, place):
        options = {"FileName": name, "FieldOn": place}
        of_field = f"of degree {degree}: "
        writer = self.filters.vtkDirectionFieldWriter()
        with self.messages:
            writer.SetInputDataObject(0, self.fields[degree][0])
            for key, value in options.items():
                getattr(writer, f"Set{key}")(value)
            writer.Write()
        items = [*digests.describe_files("."), *self.messages.describe()]
        self.report("vtkDirectionFieldWriter", of_field + label([options]), items)
        of_field = f"of degree {degree}, on {('cells', 'points')[place]}: "
        names = [] if name.endswith("sing") else [name, *self.change_files(degree, place)]
        for name in names:
            self.run("vtkDirectionFieldReader", [self.surface], [{"FileName": name}], of_field)

    def change_files(self, degree, place):
        """The names of files as only other programs write them, made of those that are there."""
        raw = pathlib.Path("field.rawfield")
        if raw.exists():
            # Directions at other than equal angles.
            rows = [line.split() for line in raw.read_text().splitlines()]
            rows[1:] = [[repr(float(x) + 0.3), *others] for x, *others in rows[1:]]
            pathlib.Path("bent.rawfield").write_text("\n".join(map(" ".join, rows)) + "\n")
            yield "bent.rawfield"
        elif place and pathlib.Path("field.rosy").exists():
            directions = self.fields[degree][0].GetPointData().GetArray("Direction0")
            comments = [f"#degree {degree}"] + [
                "#field {} {!r} {!r} {!r}".format(k + 1, *directions.GetTuple3(k))
                for k in range(directions.GetNumberOfTuples())]
            mesh = pathlib.Path("field.obj")
            mesh.write_text(mesh.read_text() + "\n".join(comments) + "\n")
            yield "field.obj"
            yield "missing.rosy"

    def run_blocks(self):
        """All filters on composite datasets."""
        surfaces = blocks_of(self.surface, vtkPolyData(), stretched(self.surface, 1.3))
        fields, singularities = self.run("vtkDirectionField", [surfaces], [of(2)], "of blocks: ")
        blocks = [singularities.GetBlock(k) for k in range(surfaces.GetNumberOfBlocks())]
        moved = blocks_of(*(block and singular_points(MOVED, self.surface, block) for block in blocks))
        for name, inputs, options in (
                ("vtkPDirectionField", [surfaces], of(4, BOUND)),
                ("vtkDirectionFieldGlyphs", [fields], {}),
                ("vtkDirectionFieldStreamlines", [fields], {"SeedType": 1}),
                ("vtkStripePattern", [fields], {}),
                ("vtkFieldAlignedRemesh", [surfaces], COARSE),
                ("vtkDirectionFieldSingularities", [fields, moved], {}),
                ("vtkGuidanceCurves", [surfaces, blocks_of(curves_on(self.surface))], {"Radius": 0.2}),
                ("vtkCompareDirectionFields", [fields, fields], {"DivergenceAndCurl": True}),
                ("vtkCompareDirectionFields", [blocks_of(*[fields.GetBlock(0)] * 2), fields.GetBlock(0)], {})):
            self.run(name, inputs, [options], "of blocks: ")
