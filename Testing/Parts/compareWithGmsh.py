# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Quads of parts whose faces are known, beside those of Gmsh (Debian's package gmsh, by OpenCASCADE):

    PYTHONPATH=build/lib/python3/dist-packages pvpython Testing/Parts/compareWithGmsh.py [FACES [PART.geo...]]

Gmsh makes the surface of each part in triangles that carry the number of their face, and quads from the same geometry,
which we do not see, by recombination (Blossom), of about the same number. A row is one mesh: ours, ours of quads alone,
Gmsh's. The columns: quads and triangles; the least scaled Jacobian; irregular vertices off the borders of faces; faces
of the part that are lost; how far a border of the part is from those of the mesh, and these from that, in thousandths of
the diagonal; the largest error of a face's area in %; faces turned against the surface; whether Euler's number is the
part's; processor seconds."""
import collections
import os
import re
import subprocess
import sys
import tempfile
import time

import numpy as np
from vtkmodules.numpy_interface import dataset_adapter as dsa
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import mutable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData, vtkStaticCellLocator

from directionfields_vtk import vtkFieldAlignedRemesh

LABEL = "CellEntityIds"
FINE = {"Mesh.MeshSizeMax": 0.05, "Mesh.MeshSizeMin": 0.008, "Mesh.MeshSizeFromCurvature": 24}


class Mesh:
    """Points, faces of three or four corners, and the number of the part's face of each."""

    def __init__(self, points, faces, labels):
        self.points, self.faces, self.labels = points, faces, labels

    def edges(self):
        """The faces at each edge."""
        found = collections.defaultdict(list)
        for f, face in enumerate(self.faces):
            for a, b in zip(face, np.roll(face, -1)):
                found[min(a, b), max(a, b)].append(f)
        return found

    def borders(self):
        """The edges that do not lie between two faces of one label."""
        return [edge for edge, at in self.edges().items()
                if len(at) != 2 or self.labels[at[0]] != self.labels[at[1]]]

    def normals(self):
        """Of the faces, as long as their areas."""
        corners = [self.points[[face[k] for face in self.faces]] for k in (0, 1, 2)]
        last = self.points[[face[-1] for face in self.faces]]
        isQuad = np.array([len(face) == 4 for face in self.faces])[:, None]
        a, b, c = corners
        return 0.5 * np.where(isQuad, np.cross(c - a, last - b), np.cross(b - a, c - a))

    def areas(self):
        """By label; of a quad, both triangles of each of its halvings, in the mean."""
        sums = collections.defaultdict(float)
        for face, label in zip(self.faces, self.labels):
            p = self.points[list(face)]
            k = len(p)
            corner = [np.linalg.norm(np.cross(p[(i + 1) % k] - p[i], p[i - 1] - p[i])) for i in range(k)]
            sums[label] += sum(corner) / (4 if k == 4 else 6)
        return sums

    def least_jacobian(self):
        """Scaled, as Verdict defines it; of triangles too."""
        unit = self.normals()
        unit = unit / np.maximum(np.linalg.norm(unit, axis=1), 1e-300)[:, None]
        least = np.inf
        for face, normal in zip(self.faces, unit):
            p = self.points[list(face)]
            k = len(p)
            after, before = np.roll(p, -1, axis=0) - p, np.roll(p, 1, axis=0) - p
            length = np.linalg.norm(after, axis=1) * np.linalg.norm(before, axis=1)
            sines = np.cross(after, before) @ normal / np.maximum(length, 1e-300)
            least = min(least, sines.min() * (1 if k == 4 else 2 / np.sqrt(3)))
        return least

    def irregular(self):
        """Vertices off borders at which not four edges meet."""
        edges = self.edges()
        valence, isBorder = collections.Counter(), set()
        for edge in edges:
            valence.update(edge)
        for edge in self.borders():
            isBorder.update(edge)
        return sum(1 for p, number in valence.items() if number != 4 and p not in isBorder)

    def euler(self):
        return len({p for face in self.faces for p in face}) - len(self.edges()) + len(self.faces)


def read(path):
    """Of a file in Gmsh's format 2: triangles (type 2) and quads (3), whose second tag is the part's face."""
    lines = open(path, encoding="ascii").read().split("\n")
    begin = {name: lines.index("$" + name) for name in ("Nodes", "Elements")}
    nodes = [line.split() for line in lines[begin["Nodes"] + 2:lines.index("$EndNodes")]]
    number = {row[0]: k for k, row in enumerate(nodes)}
    faces, labels = [], []
    for line in lines[begin["Elements"] + 2:lines.index("$EndElements")]:
        _, kind, tags, *rest = line.split()
        if kind in ("2", "3"):
            labels.append(int(rest[1]))
            faces.append([number[node] for node in rest[int(tags):]])
    return Mesh(np.array([row[1:] for row in nodes], dtype=float), faces, np.array(labels))


def mesh_of(data):
    """Of the triangles and quads of a data set."""
    labels = vtk_to_numpy(data.GetCellData().GetArray(LABEL))
    faces = [(c, [data.GetCell(c).GetPointId(k) for k in range(data.GetCell(c).GetNumberOfPoints())])
             for c in range(data.GetNumberOfCells()) if data.GetCell(c).GetCellDimension() == 2]
    return Mesh(dsa.WrapDataObject(data).Points.astype(float), [face for _, face in faces],
                np.array([labels[c] for c, _ in faces]))


def poly_data(mesh, cells):
    """The faces or edges of a mesh in VTK's data."""
    points = vtkPoints()
    points.SetDataTypeToDouble()
    for p in mesh.points:
        points.InsertNextPoint(p)
    array = vtkCellArray()
    for cell in cells:
        array.InsertNextCell(len(cell), [int(p) for p in cell])
    data = vtkPolyData()
    data.SetPoints(points)
    (data.SetLines if cells and len(cells[0]) == 2 else data.SetPolys)(array)
    return data


def gmsh(part, output, **options):
    """Seconds of meshing."""
    command = ["gmsh", "-2", "-format", "msh2", "-save_all", "-o", output, part]
    for name, value in options.items():
        command += ["-setnumber", name, str(value)]
    told = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    return sum(float(s) for s in re.findall(r"Done meshing [12]D \(Wall .*?s, CPU ([0-9.e+-]+)s\)", told))


def gmsh_quads(part, output, wanted, area):
    length = np.sqrt(area / wanted)
    for _ in range(3):
        seconds = gmsh(part, output, **{"Mesh.MeshSizeMax": length, "Mesh.MeshSizeMin": length,
                                        "Mesh.RecombineAll": 1, "Mesh.RecombinationAlgorithm": 1,
                                        "Mesh.Algorithm": 6})
        mesh = read(output)
        length *= np.sqrt(len(mesh.faces) / wanted)
    return mesh, seconds


def our_quads(surface, wanted, pure):
    data = poly_data(surface, surface.faces)
    labels = dsa.numpyTovtkDataArray(surface.labels.astype(np.int32), LABEL)
    data.GetCellData().AddArray(labels)
    remesh = vtkFieldAlignedRemesh()
    remesh.SetInputData(data)
    remesh.SetNumberOfFaces(wanted)
    remesh.SetPureQuads(pure)
    remesh.SetRegionArray(LABEL)
    start = time.process_time()
    remesh.Update()
    return mesh_of(remesh.GetOutput()), time.process_time() - start


def samples(mesh, edges):
    return np.concatenate([(1 - t) * mesh.points[[a for a, _ in edges]] + t * mesh.points[[b for _, b in edges]]
                           for t in (0.0, 0.25, 0.5, 0.75)])


def farthest(places, mesh, edges):
    """How far one of the places is from the edges."""
    locator = vtkStaticCellLocator()
    locator.SetDataSet(poly_data(mesh, edges))
    locator.BuildLocator()
    point, cell, sub, squared = [0.0] * 3, mutable(0), mutable(0), mutable(0.0)
    most = 0.0
    for place in places:
        locator.FindClosestPoint(place, point, cell, sub, squared)
        most = max(most, squared.get())
    return np.sqrt(most)


def turned(mesh, surface):
    """Faces whose normals are opposite to those of the surface's triangles below their middles."""
    locator = vtkStaticCellLocator()
    locator.SetDataSet(poly_data(surface, surface.faces))
    locator.BuildLocator()
    normals, below = mesh.normals(), surface.normals()
    point, cell, sub, squared = [0.0] * 3, mutable(0), mutable(0), mutable(0.0)
    count = 0
    for face, normal in zip(mesh.faces, normals):
        locator.FindClosestPoint(mesh.points[list(face)].mean(axis=0), point, cell, sub, squared)
        count += normal @ below[cell.get()] < 0
    return count


def row(name, mesh, surface, seconds):
    diagonal = np.linalg.norm(np.ptp(surface.points, axis=0))
    borders, own = surface.borders(), mesh.borders()
    there = farthest(samples(surface, borders), mesh, own)
    back = farthest(samples(mesh, own), surface, borders)
    wanted, made = surface.areas(), mesh.areas()
    error = max(abs(made.get(label, 0.0) / area - 1) for label, area in wanted.items())
    lost = len(wanted.keys() - made.keys())
    quads = sum(len(face) == 4 for face in mesh.faces)
    least, irregular = mesh.least_jacobian(), mesh.irregular()
    print(f"{name:22}{quads:6}{len(mesh.faces) - quads:5}{least:8.3f}{irregular:6}{lost:5}"
          f"{1000 * there / diagonal:7.2f}{1000 * back / diagonal:7.2f}{100 * error:7.2f}"
          f"{turned(mesh, surface):6}{'yes' if mesh.euler() == surface.euler() else 'no':>6}{seconds:8.2f}", flush=True)
    return least, irregular, max(there, back) / diagonal, error, seconds


def main():
    wanted = int(sys.argv[1]) if len(sys.argv) > 1 else 3000
    folder = os.path.dirname(os.path.abspath(__file__))
    parts = sys.argv[2:] or sorted(os.path.join(folder, name) for name in os.listdir(folder) if name.endswith(".geo"))
    print("mesh                   quads  tri  least J  irr lost border/1000 back  area %  turn Euler  s")
    figures = collections.defaultdict(list)
    with tempfile.TemporaryDirectory() as temporary:
        for part in parts:
            name = os.path.splitext(os.path.basename(part))[0]
            file = os.path.join(temporary, "part.msh")
            gmsh(part, file, **FINE)
            surface = read(file)
            for kind, pure in (("", 0), (" pure", 1)):
                mesh, seconds = our_quads(surface, wanted, pure)
                figures[kind].append(row(name + kind, mesh, surface, seconds))
            mesh, seconds = gmsh_quads(part, file, wanted, sum(surface.areas().values()))
            figures["Gmsh"].append(row(name + " Gmsh", mesh, surface, seconds))
    for kind in ("", " pure"):
        ours, theirs = np.array(figures[kind]), np.array(figures["Gmsh"])
        print(f"\n{len(parts)} parts{kind}: least Jacobian at least 0.2 at {np.sum(ours[:, 0] >= 0.2)}, no more irregular "
              f"vertices than Gmsh at {np.sum(ours[:, 1] <= theirs[:, 1])}, borders within a thousandth at "
              f"{np.sum(ours[:, 2] <= 1e-3)} (Gmsh {np.sum(theirs[:, 2] <= 1e-3)}), areas within 1 % at "
              f"{np.sum(ours[:, 3] <= 0.01)} (Gmsh {np.sum(theirs[:, 3] <= 0.01)}), processor time no longer than Gmsh's at "
              f"{np.sum(ours[:, 4] <= theirs[:, 4])}")


main()
