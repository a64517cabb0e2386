# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Computes a direction field with the ParaView plugin, reports on it, writes and draws it.

The module directionfields comes with the plugin, once that is loaded.

Utilities/demo runs it as: pvbatch demo.py PLUGIN MESH OUTDIR DEGREE
"""

import os
import sys

import numpy as np
from paraview import servermanager
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkPolyDataConnectivityFilter, vtkTriangleFilter
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkImagingCore import vtkImageShrink3D

COMPONENTS_LISTED = 10
SIZE = (1600, 1200)
NAMES = {1: "Vector field", 2: "Line field", 4: "Cross field", 6: "Hex field"}


def stop(message):
    sys.exit("demo: " + message)


class Component:
    """What a connected component is by counting alone, without the filter."""

    def __init__(self, points, edge_uses, triangles, index_sum):
        self.characteristic = points - len(edge_uses) + triangles
        self.closed = bool(np.all(edge_uses == 2))
        self.triangles = triangles
        self.index_sum = index_sum


def connectivity(cells):
    """The points of all cells in a row, and where each cell begins there."""
    return (vtk_to_numpy(cells.GetConnectivityArray()).astype(np.int64),
            vtk_to_numpy(cells.GetOffsetsArray()).astype(np.int64)[:-1])


def count_components(mesh, indices):
    """The connected components of the polygons and strips of mesh."""
    triangulate = vtkTriangleFilter()
    triangulate.SetInputData(mesh)
    triangulate.PassVertsOff()
    triangulate.PassLinesOff()
    regions = vtkPolyDataConnectivityFilter()
    regions.SetInputConnection(triangulate.GetOutputPort())
    regions.SetExtractionModeToAllRegions()
    regions.ColorRegionsOn()
    regions.Update()
    # Neither filter drops points or changes their order.
    region = vtk_to_numpy(regions.GetOutput().GetPointData().GetArray("RegionId"))
    corners = connectivity(triangulate.GetOutput().GetPolys())[0].reshape(-1, 3)
    pairs = np.sort(np.vstack((corners[:, :2], corners[:, 1:], corners[:, ::2])), axis=1)
    edges, uses = np.unique(pairs, axis=0, return_counts=True)
    points = np.unique(corners)
    first_points = []
    for cells in (mesh.GetVerts(), mesh.GetLines(), mesh.GetPolys(), mesh.GetStrips()):
        ids, begin = connectivity(cells)
        first_points.append(ids[begin])
    region_of_cell = region[np.concatenate(first_points)]
    return [Component(int(np.sum(region[points] == k)), uses[region[edges[:, 0]] == k],
                      int(np.sum(region[corners[:, 0]] == k)),
                      int(np.sum(indices[region_of_cell == k])))
            for k in np.unique(region[points])]


def report(field, degree):
    """Prints the figures; returns whether the indices sum up as topology wants."""
    indices = vtk_to_numpy(field.GetCellData().GetArray("SingularityIndex"))
    figures = {name: vtk_to_numpy(field.GetFieldData().GetArray(name))
               for name in ("Eigenvalue", "Residual", "Iterations")}
    components = count_components(field, indices)
    print(f"Vertices      {field.GetNumberOfPoints()}")
    print(f"Triangles     {sum(component.triangles for component in components)}")
    print(f"Components    {len(figures['Eigenvalue'])}")
    print(f"Degree        {degree}")
    for k, eigenvalue in enumerate(figures["Eigenvalue"][:COMPONENTS_LISTED]):
        which = f" (component {k})" if len(figures["Eigenvalue"]) > 1 else ""
        print(f"Eigenvalue    {eigenvalue:.9g}{which}")
        print(f"Residual      {figures['Residual'][k]:.2g} after {figures['Iterations'][k]} "
              f"iterations{which}")
    if len(figures["Eigenvalue"]) > COMPONENTS_LISTED:
        print(f"              and {len(figures['Eigenvalue']) - COMPONENTS_LISTED} more components")
    values, counts = np.unique(indices[indices != 0], return_counts=True)
    print(f"Singularities {counts.sum()}")
    for value, count in zip(values, counts):
        print(f"  index {value:+d}/{degree}  {count}")
    print(f"Index sum     {int(indices.sum()):+d}/{degree}")

    agree = True
    closed = [component for component in components if component.closed]
    for component in closed:
        expected = degree * component.characteristic
        if component.index_sum != expected:
            agree = False
            print(f"  a closed component of {component.triangles} triangles has the index sum "
                  f"{component.index_sum:+d}/{degree} instead of {expected:+d}/{degree}")
    if closed and agree:
        characteristic = sum(component.characteristic for component in closed)
        print(f"  equals the Euler characteristic ({characteristic}) on every closed component")
    if len(closed) < len(components):
        print(f"  components with boundary, where any sum is possible: "
              f"{len(components) - len(closed)}")
    return agree


def write(source, port, path):
    # Binary rather than appended: some versions of expat make VTK read appended data as empty.
    simple.SaveData(path, proxy=simple.OutputPort(source, port), DataMode="Binary")
    reader = simple.XMLPolyDataReader(FileName=[path])
    written = servermanager.Fetch(reader)
    expected = servermanager.Fetch(source, idx=port)
    if (written.GetNumberOfPoints() != expected.GetNumberOfPoints() or
            written.GetPointData().GetNumberOfArrays() !=
            expected.GetPointData().GetNumberOfArrays()):
        stop(f"{path} does not read back as it was written.")
    simple.Delete(reader)
    print(f"Wrote {path}")


def save(view, path):
    """Saves the view, drawn at twice the size for smooth edges."""
    simple.SaveScreenshot(path, view, ImageResolution=[2 * pixels for pixels in SIZE],
                          FontScaling="Scale fonts proportionally")
    reader = vtkPNGReader()
    reader.SetFileName(path)
    shrink = vtkImageShrink3D()
    shrink.SetInputConnection(reader.GetOutputPort())
    shrink.SetShrinkFactors(2, 2, 1)
    shrink.AveragingOn()
    shrink.Update()
    writer = vtkPNGWriter()
    writer.SetInputConnection(shrink.GetOutputPort())
    writer.SetFileName(path)
    writer.Write()


def draw(field, title, path):
    import directionfields
    view = simple.CreateView("RenderView", ViewSize=SIZE, OrientationAxesVisibility=0, UseFXAA=1,
                             UseColorPaletteForBackground=0, Background=[1.0, 1.0, 1.0])
    shown = directionfields.show(field, view=view, glyphs={"MaximumNumberOfGlyphs": 1500})
    display = simple.Show(simple.Text(Text=title), view)
    display.WindowLocation = "Upper Left Corner"
    display.Color = [0.15, 0.15, 0.17]
    for text in (display, simple.GetRepresentation(shown.caption, view)):
        text.FontSize = 30
    shown.legend.TitleFontSize = shown.legend.LabelFontSize = 26
    save(view, path)


def main():
    plugin, path, output, degree = sys.argv[1:5]
    degree = int(degree)
    # ParaView 5.13 and newer load no relative path.
    simple.LoadPlugin(os.path.abspath(plugin), remote=False, ns=vars(simple))
    import directionfields
    mesh = directionfields.read(path)
    mesh.UpdatePipeline()
    surface = servermanager.Fetch(mesh)
    if surface.GetNumberOfPolys() + surface.GetNumberOfStrips() == 0:
        stop(f"{path} holds no triangles.")
    filtered = simple.DirectionField(Input=mesh, Degree=degree, Diagnostics=1)
    filtered.UpdatePipeline()
    field = servermanager.Fetch(filtered, idx=0)
    if not field.GetCellData().HasArray("SingularityIndex"):
        stop(f"{path} has no direction field; the message above says why.")
    agree = report(field, degree)
    write(filtered, 0, os.path.join(output, "field.vtp"))
    write(filtered, 1, os.path.join(output, "singularities.vtp"))
    image = os.path.join(output, "field.png")
    name = NAMES.get(degree, f"Field of {degree} directions")
    draw(filtered, f"{name} of {os.path.basename(path)}", image)
    print(f"Wrote {image}")
    if not agree:
        stop("the singularity indices do not sum up to the Euler characteristic.")
    print(f"""
To see it in ParaView's window:
  1. Tools > Manage Plugins > Load New..., choose {os.path.abspath(plugin)}
  2. File > Open, choose {os.path.abspath(path)}, and press Apply
  3. Tools > Show direction field""")


main()
