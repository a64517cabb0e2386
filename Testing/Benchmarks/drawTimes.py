# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the table that TimeOverPolygons prints, both axes logarithmic, and prints its slopes.

    pvpython drawTimes.py TABLE.csv PICTURE.png [--check]

With --check it fails unless each curve can be seen in the picture.
"""

import csv
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkChartsCore import vtkAxis, vtkChart, vtkChartXY
from vtkmodules.vtkCommonDataModel import vtkTable
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter
from vtkmodules.vtkViewsContext2D import vtkContextView
import vtkmodules.vtkRenderingContextOpenGL2  # noqa: F401, the context view draws with it
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401

SERIES = {
    "smooth": ("smoothest", (0, 107, 117)),
    "aligned": ("aligned to curvature", (214, 120, 20)),
    "constrained": ("aligned and constrained", (150, 40, 130)),
}


def main(table_path, picture_path, *options):
    with open(table_path, newline="", encoding="ascii") as file:
        rows = list(csv.DictReader(file))
    columns = {name: np.array([float(row[name]) for row in rows]) for name in rows[0]}
    polygons = columns["polygons"]

    table = vtkTable()
    for name in ("polygons", *SERIES):
        array = numpy_to_vtk(columns[name], deep=True)
        array.SetName(SERIES.get(name, (name,))[0])
        table.AddColumn(array)

    chart = vtkChartXY()
    chart.SetShowLegend(True)
    chart.GetLegend().SetHorizontalAlignment(0)
    times = np.concatenate([columns[name] for name in SERIES])
    for axis, title, values in (
            (vtkAxis.BOTTOM, "polygons", polygons), (vtkAxis.LEFT, "seconds", times)):
        chart.GetAxis(axis).SetTitle(title)
        chart.GetAxis(axis).LogScaleOn()
        # Room for the marks and the last label.
        chart.GetAxis(axis).SetBehavior(vtkAxis.FIXED)
        chart.GetAxis(axis).SetUnscaledMinimum(0.7 * values.min())
        chart.GetAxis(axis).SetUnscaledMaximum(2.0 * values.max())
        chart.GetAxis(axis).GetTitleProperties().SetFontSize(22)
        chart.GetAxis(axis).GetLabelProperties().SetFontSize(18)
    chart.GetLegend().SetLabelSize(18)
    for k, (name, (_, color)) in enumerate(SERIES.items()):
        for kind in (vtkChart.LINE, vtkChart.POINTS):
            plot = chart.AddPlot(kind)
            plot.SetInputData(table, 0, k + 1)
            plot.SetColor(*color, 255)
            plot.SetWidth(3.0 if kind == vtkChart.LINE else 9.0)
            plot.SetLegendVisibility(kind == vtkChart.LINE)
        slope = np.polyfit(np.log(polygons), np.log(columns[name]), 1)[0]
        print(f"{name}: time grows with the polygons to the power of {slope:.2f}")

    view = vtkContextView()
    view.GetRenderWindow().SetSize(1000, 750)
    view.GetRenderWindow().SetMultiSamples(0)
    view.GetScene().AddItem(chart)
    view.GetRenderWindow().Render()
    image = vtkWindowToImageFilter()
    image.SetInput(view.GetRenderWindow())
    writer = vtkPNGWriter()
    writer.SetFileName(picture_path)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()
    if "--check" in options:
        pixels = vtk_to_numpy(image.GetOutput().GetPointData().GetScalars())[:, :3]
        for name, (_, color) in SERIES.items():
            seen = np.count_nonzero((pixels == color).all(axis=1))
            if seen < 300:
                sys.exit(f"The curve of {name} is not in the picture.")


if __name__ == "__main__":
    main(*sys.argv[1:])
