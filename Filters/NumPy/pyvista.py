# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The accessor ``mesh.directions`` of PyVista's surfaces, and results as these.

PyVista 0.48 and newer find it by themselves; before, ``import direction_fields.pyvista`` brings it.
"""

import numpy
import pyvista

import direction_fields as df

_BLUE, _RED = "#2166ac", "#b2182b"


class FieldSurface(pyvista.PolyData):
    """A surface with a field: arrays Direction0, Direction1, ... over its points."""

    def plot(self, **keywords):
        """Shows the surface, a stroke for each direction, and the singularities."""
        plotter = pyvista.Plotter(off_screen=keywords.pop("off_screen", None))
        plotter.add_mesh(pyvista.PolyData(self), color=keywords.pop("color", "white"))
        plotter.add_mesh(self.directions.glyphs(), color="black", line_width=2)
        points = self.directions.singularities()
        for color, chosen in ((_RED, points["Index"] > 0), (_BLUE, points["Index"] < 0)):
            if chosen.any():
                plotter.add_points(
                    points.points[chosen], color=color, point_size=14,
                    render_points_as_spheres=True)
        return plotter.show(**keywords)


def _row(offsets, corners):
    """PyVista's row of sizes and ids."""
    return numpy.insert(corners, offsets[:-1], numpy.diff(offsets))


def polydata(result, faces=None):
    """Any result of direction_fields as a ``pyvista.PolyData``."""
    if isinstance(result, df.Field):
        triangles = result.triangles
        if faces is None:
            faces = _row(3 * numpy.arange(len(triangles) + 1), triangles.ravel())
        mesh = FieldSurface(result.points.copy(), faces)
        for k in range(result.degree):
            mesh.point_data[f"Direction{k}"] = result.directions[:, k]
        if result.magnitudes is not None:
            mesh.point_data["RepresentationMagnitude"] = result.magnitudes
        for name, attribute in (
                ("EnergyDensity", "energy_density"), ("ConstraintKind", "constraints"),
                ("ConstraintDirection", "constraint_directions"),
                ("MeanCurvature", "mean_curvature"), ("GaussianCurvature", "gaussian_curvature"),
                ("MajorValue", "major_values"), ("MinorValue", "minor_values"),
                ("TensorAnisotropy", "anisotropy"), ("SurfaceTensor", "surface_tensors")):
            values = getattr(result, attribute, ())
            if len(values) == mesh.n_points:
                mesh.point_data[name] = values
        if mesh.n_cells == len(result.indices):
            mesh.cell_data["SingularityIndex"] = result.indices
    elif isinstance(result, df.Mesh):
        sizes = 3 + (result.faces[:, 3] >= 0)
        offsets = numpy.concatenate([[0], numpy.cumsum(sizes)])
        mesh = pyvista.PolyData(result.points, _row(offsets, result.faces[result.faces >= 0]))
        for name, values in (("ScaledJacobian", result.quality), ("AspectRatio", result.aspect_ratios),
                             ("Warpage", result.warpages), ("Pass", result.passes)):
            if len(values) == len(result.faces):
                mesh.cell_data[name] = values
        mesh.point_data["VertexKind"] = result.kinds
    elif isinstance(result, (df.Lines, df.Stripes)):
        mesh = pyvista.PolyData()
        mesh.points = result.points
        mesh.lines = _row(result.offsets, numpy.arange(len(result.points)))
        mesh.point_data["Normals"] = result.normals
        mesh.point_data["Arc"] = result.arc
        mesh.cell_data["Length"] = result.lengths
        if isinstance(result, df.Lines):
            mesh.cell_data["Family"] = result.families
    else:
        raise TypeError(f"{type(result).__name__} has no surface or lines to show.")
    mesh.field_data["Summary"] = [result.summary]
    return mesh


def bands(stripes):
    """The bands of `direction_fields.stripes` as polygons, with the cell array Stripe, 0 or 1."""
    mesh = pyvista.PolyData(stripes.band_points, _row(stripes.band_offsets, stripes.band_corners))
    mesh.cell_data["Stripe"] = stripes.stripe.astype(numpy.uint8)
    return mesh


class Directions:
    """Direction fields of a surface: ``mesh.directions.field(degree=4).plot()``.

    Options are those of the functions of direction_fields. A surface that `field` gave, or a filter
    of ParaView, has its field in its point arrays, which the other methods read.
    """

    def __init__(self, mesh):
        self._mesh = mesh

    def _array(self, values):
        return self._mesh.point_data[values] if isinstance(values, str) else values

    def field(self, *, vectors=None, weights=None, strengths=None, tensors=None, **options):
        """The surface with a field; vectors, weights, strengths and tensors may be names of point
        arrays.

        With ``tensors_at="triangles"`` tensors may be the name of a cell array.
        """
        faces = self._mesh.faces
        if isinstance(tensors, str) and options.get("tensors_at") == "triangles":
            tensors = self._mesh.cell_data[tensors]
        field = df.field(
            self._mesh.points, faces, vectors=self._array(vectors), weights=self._array(weights),
            strengths=self._array(strengths), tensors=self._array(tensors), **options)
        return polydata(field, faces if len(field.points) == self._mesh.n_points else None)

    def curvature(self, scale=0.0):
        """The surface with the field of its principal directions, and its curvatures."""
        return polydata(df.curvature(self._mesh.points, self._mesh.faces, scale=scale))

    def given(self):
        """The field of the point arrays Direction0, ..., for the functions of direction_fields."""
        data = self._mesh.point_data
        names = []
        while f"Direction{len(names)}" in data:
            names.append(f"Direction{len(names)}")
        if not names:
            raise ValueError("The surface has no point array Direction0: apply field() first.")
        magnitudes = numpy.asarray(data["RepresentationMagnitude"]) \
            if "RepresentationMagnitude" in data else None
        field = df.from_directions(
            self._mesh.points, self._mesh.faces,
            numpy.stack([data[name] for name in names], axis=1), magnitudes)
        if "ConstraintDirection" in data:
            field.constraint_directions = numpy.asarray(data["ConstraintDirection"])
        return field

    def glyphs(self, length=None):
        """A stroke for each direction, of a length; 0.8 of the mean edge by default."""
        field = self.given()
        sides = field.points[field.triangles] - field.points[numpy.roll(field.triangles, 1, axis=1)]
        length = 0.8 * numpy.linalg.norm(sides, axis=-1).mean() if length is None else length
        arms = field.directions * (0.5 * length)
        begins = numpy.repeat(field.points, field.degree, axis=0)
        ends = begins + arms.reshape(-1, 3)
        mesh = pyvista.PolyData()
        mesh.points = numpy.stack([begins, ends], axis=1).reshape(-1, 3)
        mesh.lines = _row(2 * numpy.arange(len(begins) + 1), numpy.arange(2 * len(begins)))
        return mesh

    def singularities(self):
        """Points in the middles of singular triangles, with the point array Index."""
        field = self.given()
        triangles = field.triangles[field.singularities]
        mesh = pyvista.PolyData(field.points[triangles].mean(axis=1).reshape(-1, 3))
        mesh.point_data["Index"] = field.indices[field.singularities]
        return mesh

    def edit(self, wanted, **options):
        """The surface with the field's singularities edited."""
        return polydata(self.given().edit(wanted, **options))

    def streamlines(self, points=None, **options):
        """Lines along the field."""
        return polydata(df.streamlines(self.given(), points, **options))

    def graph(self, **options):
        """The field's graph as lines."""
        return polydata(df.graph(self.given(), **options))

    def stripes(self, *, spacings=None, **options):
        """The middles of stripes along the field, as lines."""
        return polydata(df.stripes(self.given(), spacings=self._array(spacings), **options))

    def bands(self, *, spacings=None, **options):
        """The surface cut into stripes and what is between, with the cell array Stripe."""
        return bands(df.stripes(self.given(), spacings=self._array(spacings), **options))

    def remesh(self, *, sizing=None, regions=None, curves=(), given_points=None, **options):
        """A mesh along the field, where there is one of the right degree, or along the shape.

        ``regions`` may be the name of a cell array, which the mesh has then, too; values that are
        given become the cell array Region. ``curves`` are arrays of points, or a ``PolyData`` of lines.
        ``given_points`` are places, or a dataset of them.
        """
        degree = 6 if options.get("element") == "triangles" else 4
        arguments = self._mesh.points, self._mesh.faces
        if f"Direction{degree - 1}" in self._mesh.point_data and \
                f"Direction{degree}" not in self._mesh.point_data:
            arguments = (self.given(),)
        values = self._mesh.cell_data[regions] if isinstance(regions, str) else regions
        if isinstance(curves, pyvista.PolyData):
            curves = [numpy.asarray(cell.points) for cell in curves.cell]
        made = df.remesh(
            *arguments, sizing=self._array(sizing), regions=values, curves=curves,
            given_points=getattr(given_points, "points", given_points), **options)
        mesh = polydata(made)
        if regions is not None:
            mesh.cell_data[regions if isinstance(regions, str) else "Region"] = made.regions
        return mesh


if hasattr(pyvista, "register_dataset_accessor"):
    pyvista.register_dataset_accessor("directions", pyvista.PolyData)(Directions)
else:
    pyvista.PolyData.directions = property(Directions)
