# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Times over sizes in a chart with both axes logarithmic."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkChartsCore import vtkAxis, vtkChart, vtkChartXY
from vtkmodules.vtkCommonDataModel import vtkTable
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter
from vtkmodules.vtkViewsContext2D import vtkContextView
import vtkmodules.vtkRenderingContextOpenGL2  # noqa: F401, the context view draws with it
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401


def slope(sizes, times):
    """The power of the size to which the time grows."""
    return np.polyfit(np.log(sizes), np.log(times), 1)[0]


def draw(path, curves, titles):
    """Writes a PNG. Curves are (label, color of three bytes, sizes, times), titles those of the
    axes. Returns the labels of the curves that cannot be seen in the picture."""
    chart = vtkChartXY()
    chart.SetShowLegend(True)
    chart.GetLegend().SetHorizontalAlignment(0)
    chart.GetLegend().SetLabelSize(18)
    for axis, title, column in ((vtkAxis.BOTTOM, titles[0], 2), (vtkAxis.LEFT, titles[1], 3)):
        values = np.concatenate([curve[column] for curve in curves])
        chart.GetAxis(axis).SetTitle(title)
        chart.GetAxis(axis).LogScaleOn()
        # Room for the marks and the last label.
        chart.GetAxis(axis).SetBehavior(vtkAxis.FIXED)
        chart.GetAxis(axis).SetUnscaledMinimum(0.7 * values.min())
        chart.GetAxis(axis).SetUnscaledMaximum(2.0 * values.max())
        chart.GetAxis(axis).GetTitleProperties().SetFontSize(22)
        chart.GetAxis(axis).GetLabelProperties().SetFontSize(18)
    tables = []
    for label, color, sizes, times in curves:
        table = vtkTable()
        for name, values in ((titles[0], sizes), (label, times)):
            array = numpy_to_vtk(np.asarray(values, dtype=float), deep=True)
            array.SetName(name)
            table.AddColumn(array)
        tables.append(table)
        for kind in (vtkChart.LINE, vtkChart.POINTS):
            plot = chart.AddPlot(kind)
            plot.SetInputData(table, 0, 1)
            plot.SetColor(*color, 255)
            plot.SetWidth(3.0 if kind == vtkChart.LINE else 9.0)
            plot.SetLegendVisibility(kind == vtkChart.LINE)

    view = vtkContextView()
    view.GetRenderWindow().SetSize(1000, 750)
    view.GetRenderWindow().SetMultiSamples(0)
    view.GetScene().AddItem(chart)
    view.GetRenderWindow().Render()
    image = vtkWindowToImageFilter()
    image.SetInput(view.GetRenderWindow())
    writer = vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()
    pixels = vtk_to_numpy(image.GetOutput().GetPointData().GetScalars())[:, :3]
    return [label for label, color, *_ in curves
            if np.count_nonzero((pixels == color).all(axis=1)) < 300]
