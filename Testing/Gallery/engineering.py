# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figures of meshes that programs compute on: regions of a part, sizes for an error, and a roof that bends."""

import os
import re
import subprocess
import tempfile

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

import meshes
from gallery import producer
from remeshed import RemeshedPanel

COLORS = [0.55, 0.70, 0.85, 0.95, 0.75, 0.45, 0.60, 0.80, 0.55, 0.85, 0.60, 0.60, 0.75, 0.65, 0.85, 0.95, 0.88, 0.55]
WIDTH = 0.08


def with_array(mesh, name, values, of_cells):
    copy = vtkPolyData()
    copy.ShallowCopy(mesh)
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    array.SetName(name)
    (copy.GetCellData() if of_cells else copy.GetPointData()).AddArray(array)
    return copy


def smooth_patches(mesh, degrees=30.0):
    """A number for each triangle: those between edges of at least this angle have the same one."""
    points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    triangles = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    _, same = np.unique(np.round(points, 6), axis=0, return_inverse=True)
    corners = same.reshape(-1)[triangles]
    a, b, c = (points[triangles[:, k]] for k in range(3))
    normals = np.cross(b - a, c - a)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    at = {}
    for t, corner in enumerate(corners):
        for k in range(3):
            at.setdefault(tuple(sorted((corner[k], corner[(k + 1) % 3]))), []).append(t)
    parent = list(range(len(triangles)))

    def root(t):
        while parent[t] != t:
            parent[t] = parent[parent[t]]
            t = parent[t]
        return t

    for beside in at.values():
        if len(beside) == 2 and normals[beside[0]] @ normals[beside[1]] > np.cos(np.radians(degrees)):
            parent[root(beside[0])] = root(beside[1])
    return np.unique([root(t) for t in range(len(triangles))], return_inverse=True)[1].astype(np.int32)


def colored(display, name, of_cells, preset=None, span=None):
    simple.ColorBy(display, ("CELLS" if of_cells else "POINTS", name))
    table = display.LookupTable
    if preset:
        table.ApplyPreset(preset, True)
        table.RescaleTransferFunction(*span)


def front(x, y):
    """Steep along an oblique line."""
    return np.tanh((x + 0.4 * y - 0.7) / WIDTH)


def errors(panel):
    """Of each face, how far the mean of the front at its corners is from the front at its middle."""
    starts = panel.offsets[:-1]
    x, y, _ = panel.points.T

    def mean(values):
        return np.add.reduceat(values[panel.ids], starts) / panel.sizes

    return np.abs(mean(front(x, y)) - front(mean(x), mean(y)))


class ErrorPanel(RemeshedPanel):
    """The error of each face in colors."""

    def __init__(self, source, camera, span, **properties):
        super().__init__(source, camera, **properties)
        simple.HideAll(self.view)
        self.shown = producer(with_array(self.mesh, "Error", errors(self), True))
        display = simple.Show(self.shown, self.view)
        display.SetRepresentationType("Surface With Edges")
        display.EdgeColor = [0.35, 0.35, 0.35]
        colored(display, "Error", True, "Viridis (matplotlib)" if has("Viridis (matplotlib)") else "Viridis", span)

    def spoil(self):
        display = simple.GetRepresentation(self.shown, self.view)
        display.Input = producer(with_array(self.mesh, "Error", 3.0 * errors(self), True))


def has(preset):
    return servermanager.vtkSMTransferFunctionPresets().HasPreset(preset)


def engineering(directory):
    """A part in the colors of its regions; a mesh graded for the interpolation of a front, and its error
    beside that of even faces, in the same colors."""
    part = simple.STLReader(FileNames=[os.path.join(directory, "bracket.stl")])
    skin = servermanager.Fetch(part)
    labels = smooth_patches(skin)
    regions = RemeshedPanel(
        producer(with_array(skin, "Region", labels, True)), ([0.75, -0.9, 0.75], [0.0, 0.0, 1.0], 0.85),
        NumberOfFaces=2000, RegionArray="Region")
    regions.check(4, 0.97)
    assert regions.number("RegionsLost") == 0.0 and regions.number("BordersKept") > 0.99
    assert regions.number("TurnedFaces") == 0.0
    display = simple.GetRepresentation(regions.proxy, regions.view)
    simple.ColorBy(display, ("CELLS", "Region"))
    table = display.LookupTable
    table.InterpretValuesAsCategories = 1
    kinds = range(labels.max() + 1)
    table.Annotations = [text for k in kinds for text in (str(k), str(k))]
    table.IndexedColors = [COLORS[(3 * k + c) % len(COLORS)] for k in kinds for c in range(3)]

    side = np.linspace(0.0, 1.0, 121)
    y, x = (a.ravel() for a in np.meshgrid(side, side, indexing="ij"))
    square = with_array(
        meshes.polydata(np.stack([x, y, 0.0 * x], axis=1), meshes.grid_triangles(121, 121)), "Front",
        front(x, y), False)
    camera = ([0.0, 0.0, 1.0], [0.0, 1.0, 0.0], 1.35)
    span = (0.0, 0.012)
    even = ErrorPanel(producer(square), camera, span, NumberOfFaces=1200)
    fitted = {"SizeSource": "Second Derivatives", "SizingArray": "Front", "NumberOfFaces": 1200}
    graded = RemeshedPanel(producer(square), camera, **fitted)
    error = ErrorPanel(producer(square), camera, span, **fitted)
    assert errors(error).max() < 0.5 * errors(even).max(), (errors(error).max(), errors(even).max())
    return [regions, graded, error, even]


class RoofPanel(RemeshedPanel):
    """A cylindrical roof on two diaphragms under its own weight (Scordelis and Lo 1964), computed by CalculiX on our
    quads and drawn with twenty times the displacements, in the colors of the deflection."""
    SCALE = 20.0

    def __init__(self, camera):
        angle = np.radians(np.linspace(-40.0, 40.0, 41))
        v, a = (c.ravel() for c in np.meshgrid(np.linspace(0.0, 50.0, 41), angle, indexing="ij"))
        roof = meshes.polydata(
            np.stack([25.0 * np.sin(a), v, 25.0 * np.cos(a)], axis=1), meshes.grid_triangles(41, 41))
        triangles = vtk_to_numpy(roof.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        half = (v[triangles].mean(axis=1) > 25.0).astype(np.int32)
        super().__init__(producer(with_array(roof, "Half", half, True)), camera, NumberOfFaces=1000, PureQuads=1,
                         RegionArray="Half")
        self.moved = self.displacements()
        edge = np.argmin(np.linalg.norm(
            self.points - [25.0 * np.sin(angle[-1]), 25.0, 25.0 * np.cos(angle[-1])], axis=1))
        assert abs(-self.moved[edge, 2] / 0.3024 - 1.0) < 0.02, self.moved[edge]
        simple.HideAll(self.view)
        self.shown = producer(self.bent(self.SCALE))
        display = simple.Show(self.shown, self.view)
        display.SetRepresentationType("Surface With Edges")
        display.EdgeColor = [0.35, 0.35, 0.35]
        colored(display, "Deflection", False, "Viridis (matplotlib)" if has("Viridis (matplotlib)") else "Viridis",
                (-0.05, 0.31))

    def bent(self, scale):
        mesh = with_array(self.mesh, "Deflection", -self.moved[:, 2], False)
        points = type(mesh.GetPoints())()
        points.SetData(numpy_to_vtk(self.points + scale * self.moved, deep=True))
        mesh.SetPoints(points)
        return mesh

    def displacements(self):
        """Runs CalculiX on the file that the writer makes of the mesh."""
        with tempfile.TemporaryDirectory() as folder:
            writer = servermanager.writers.AbaqusMeshWriter(
                Input=self.proxy, FileName=os.path.join(folder, "mesh.inp"), Thickness=0.25, RegionArray="Half")
            writer.UpdatePipeline()
            with open(os.path.join(folder, "mesh.inp"), encoding="ascii") as file:
                materials = sorted(set(re.findall(r"MATERIAL=(\w+)", file.read())))
            y = self.points[:, 1]
            ends = 1 + np.flatnonzero((y < 1e-6) | (y > 50.0 - 1e-6))
            corner = 1 + np.argmin(y + self.points[:, 0])
            with open(os.path.join(folder, "run.inp"), "w", encoding="ascii") as file:
                file.write("*INCLUDE, INPUT=mesh.inp\n")
                for material in materials:
                    file.write(f"*MATERIAL, NAME={material}\n*ELASTIC\n4.32e8, 0.\n*DENSITY\n1.\n")
                file.write(f"*NSET, NSET=SHOWN, GENERATE\n1, {len(self.points)}\n*NSET, NSET=DIAPHRAGMS\n")
                file.write("".join(f"{node},\n" for node in ends))
                file.write(f"*NSET, NSET=CORNER\n{corner},\n*BOUNDARY\nDIAPHRAGMS, 1\nDIAPHRAGMS, 3\nCORNER, 2\n"
                           "*STEP\n*STATIC\n*DLOAD\nEALL, GRAV, 360., 0., 0., -1.\n*NODE PRINT, NSET=SHOWN\nU\n"
                           "*END STEP\n")
            subprocess.run(["ccx", "-i", "run"], cwd=folder, check=True, stdout=subprocess.DEVNULL,
                           env={**os.environ, "OMP_NUM_THREADS": "1"})
            moved = np.zeros_like(self.points)
            with open(os.path.join(folder, "run.dat"), encoding="ascii") as file:
                for line in file:
                    fields = line.split()
                    if len(fields) == 4 and fields[0].isdigit():
                        moved[int(fields[0]) - 1] = [float(number) for number in fields[1:]]
        return moved

    def spoil(self):
        simple.GetRepresentation(self.shown, self.view).Input = producer(self.bent(0.0))


def roof(_):
    """The roof as CalculiX bends it, within 2 % of the published deflection in the middle of its edge."""
    panel = RoofPanel(([0.9, -1.0, 0.7], [0.0, 0.0, 1.0], 0.9))
    panel.check(4, 1.0)
    return [panel]
