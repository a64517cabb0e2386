# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The results that functions return."""

import types

import numpy

from . import _core
from ._calls import _call, _keyword_options, _listener, _optional, _result
from ._texts import in_python


class _Result(types.SimpleNamespace):
    def __repr__(self):
        return f"<{type(self).__name__}: {in_python(self.summary)}>"

    def polydata(self):
        """The result as a ``pyvista.PolyData``, ready to plot; needs PyVista."""
        from . import pyvista

        return pyvista.polydata(self)

    def plot(self, **keywords):
        """Shows the result; keywords are those of ``pyvista.Plotter.show``."""
        return self.polydata().plot(**keywords)


class Field(_Result):
    """A direction field; its arrays own their memory.

    Points are those of the input, in their order, then those that were split off where the surface
    is no manifold; triangles are those of the input. Fields of `from_directions` have no more than
    degree, directions, magnitudes, indices, singularities, points, triangles and summary.

    Attributes
    ----------
    degree : int
        Directions at each point.
    directions : (points, degree, 3) float64
        Unit tangent vectors, counter-clockwise about the normal.
    magnitudes : (points,) float64
        Weight of a point's directions against those of its neighbours: the modulus of
        `representation`, whose argument is degree times the angle of a direction from `x_axes`.
    representation : (points,) complex128
    energy_density : (points,) float64
        How much the directions turn around the point, in 1 / length^2.
    normals, x_axes : (points, 3) float64
        Unit normals, and the unit tangent vectors from which angles are measured.
    constraints, constraint_directions : (points,) int8, (points, 3) float64
        Why the direction of a point is given, and which: 1 boundary, 2 sharp edge, 3 curvature, 4
        edge of more than two triangles, 5 `vectors`; 0 for free points. Empty without any.
    points, triangles : (points, 3) float64, (triangles, 3) int32
        The surface with the points that were split off; read-only.
    polygons : (triangles,) int64 or None
        The input's polygon of each triangle; None where the input was triangles.
    original_points : (points,) int32
        The input's point of each point.
    indices : (triangles,) int32
        Singularity index of each triangle, in units of 1/degree.
    singularities : (singularities,) int64
        The triangles whose index is not 0.
    components : (triangles,) int32
        Connected component of each triangle; -1 for triangles that are ignored.
    eigenvalue : (components,) float64
        Smallest eigenvalue of each component, in 1 / length^2.
    converged : bool
        Whether the solvers reached the tolerance on all components.
    summary : str
    warnings : list of str
        The sentences that were given as warnings, too.
    principal_directions : pair of (points, 3) float64
        Of the larger and of the smaller curvature; zero where the two are equal. This and the
        following are there only where the options use curvature.
    mean_curvature, gaussian_curvature : (points,) float64
        In 1 / length and 1 / length^2; the mean is positive where the surface is convex.
    major_values, minor_values, anisotropy : (points,) float64
        The larger and the smaller principal value of the averaged tensors in the surface, with
        their signs, and half of their difference. This and the following are there only with
        ``alignment="tensor"``.
    surface_tensors : (points, 6) float64
        The averaged part in the surface: XX, YY, ZZ, XY, YZ, XZ.
    isotropic_share : float
        Part of the area where both values are the same within noise, 0 to 1.
    """

    @property
    def points(self):
        return self._surface.points

    @property
    def triangles(self):
        return self._surface.triangles

    @property
    def singularities(self):
        return numpy.flatnonzero(self.indices)

    def _given(self):
        return _core.Given(self._surface, self.directions, self.magnitudes)

    @_keyword_options("edit")
    def edit(self, wanted, *, vectors=None, weights=None, progress=None, **options):
        """The smoothest field with other singularities, or the nearest to this one.

        Parameters
        ----------
        wanted : dict
            Index, in units of 1/degree, of each triangle that is to have one. Their sum over a
            closed component must be degree times its Euler characteristic. Components without any
            keep their directions.
        vectors, weights, progress
            As for `field`.
        **options

        Returns
        -------
        Field

        Examples
        --------
        >>> sphere = field([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]],
        ...     [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]],
        ...     degree=1)
        >>> sphere.edit({2: 1, 5: 1}).singularities
        array([2, 5])
        """
        triangles = [int(k) for k in wanted]
        if triangles and not 0 <= min(triangles) <= max(triangles) < len(self.triangles):
            raise ValueError(f"wanted must name triangles, 0 to {len(self.triangles) - 1}.")
        constraints = getattr(self, "constraint_directions", ())
        edited = _result(Field, _call(
            _core.edit, self._given(), constraints if len(constraints) else None, triangles, [int(k) for k in wanted.values()],
            _optional("vectors", vectors, len(self.points), 3),
            _optional("weights", weights, len(self.points)), _listener(progress), options))
        edited.polygons = self.polygons if len(edited.triangles) == len(self.triangles) else None
        return edited

    def at_triangles(self):
        """Directions at the middles of the triangles, as finite elements take them.

        Returns
        -------
        (triangles, degree, 3) float64
            Unit vectors in the triangles' planes; zero for triangles that are ignored.
        """
        return _call(_core.at_triangles, self._given())

    def derivatives(self):
        """Divergence and curl of a vector or line field on each triangle.

        Returns
        -------
        pair of (triangles,) float64
            In 1 / length; their moduli for degree 2.
        """
        return _call(_core.derivatives, self._given())

    @_keyword_options("write")
    def write(self, path, **options):
        """Writes files for other programs, by the ending: .rosy, .ffield, .rawfield or .sing.

        The mesh, an .obj of the same name, and what else the program needs come with it.

        Parameters
        ----------
        path : str or path
        **options
        """
        _call(_core.write, self._given(), str(path), options)


class Lines(_Result):
    """Lines along a field: line i has the points ``offsets[i]`` to ``offsets[i + 1] - 1``.

    Attributes
    ----------
    points, normals, directions : (points, 3) float64
        Places, the surface's normals there, and the tangents of the lines.
    arc, magnitudes : (points,) float64
        Length from the line's begin; weight of the field.
    offsets : (lines + 1,) int64
    lengths : (lines,) float64
    closed : (lines,) bool
    families : (lines,) int32
        Lines that cross are of different families.
    ends : (lines, 2) int32
        Why they end: 0 not, 1 boundary, 4 length, 5 stuck, 6 singularity, 7 closed, 8 too close,
        9 crossing.
    nodes : (nodes, 3) float64
        Places of the singularities, then of crossings and ends at the boundary.
    node_types, node_indices, node_triangles : (nodes,) int32
        0 singularity, 1 crossing, 2 boundary; singularity index; triangle.
    end_nodes : (lines, 2) int32
        The nodes where the lines begin and end, -1 for none: the graph of the field.
    spacing : float
    summary : str
    warnings : list of str
    """


class Stripes(_Result):
    """Evenly spaced stripes: their middles as lines, and the surface cut into bands.

    Attributes
    ----------
    points, normals : (points, 3) float64
    arc : (points,) float64
    offsets : (lines + 1,) int64
        Line i has the points ``offsets[i]`` to ``offsets[i + 1] - 1``.
    lengths, closed : (lines,) float64, (lines,) bool
    band_points, band_normals : (corners, 3) float64
    band_offsets, band_corners : int64
        Polygons of the bands, as offsets and ids of band points.
    stripe : (polygons,) bool
        Whether a polygon is on a stripe, not between two.
    band_triangles : (polygons,) int32
    singularities, singular_triangles, stripe_indices, field_indices
        Where stripes branch or end: places, triangles, and numbers of lines that begin there.
    misfit : float
        0 for stripes with the wanted directions and spacing everywhere.
    spacing : float
    summary : str
    warnings : list of str
    """


class Mesh(_Result):
    """A mesh along a field.

    Attributes
    ----------
    points : (points, 3) float64
    faces : (faces, 4) int32
        Corners, counter-clockwise; the fourth of a triangle is -1.
    quality : (faces,) float64
        Scaled Jacobian: 1 for a square, 0 or less for a face that is folded.
    aspect_ratios, warpages : (faces,) float64
        1 for a square, and 0 for a face in a plane, or more.
    passes : (faces,) bool
        Which faces keep all limits of their quality; without limits of no length.
    irregular : (irregular,) int32
        Inner points with another number of edges than 4, or 6 for triangles.
    kinds : (points,) int8
        0 surface, 1 boundary, 2 feature, 3 corner, 4 singularity of the field.
    source_triangles, source_weights : (points,) int32, (points, 3) float64
        Where each point is on the surface given.
    source_faces : (faces,) int32
        The triangle of the surface given that the middle of each face is closest to.
    chains : dict of str to (points,) int32
        The points of each part of the boundary, of features, of borders of regions and of curves,
        between places where these end, meet or turn, in their order: ``chains["Boundary 1"]``,
        ``chains["Border steel/glass 1"]``, ``chains["Curve 0 1"]``. Of a closed one the first point
        is the last one, too. ``chains["Point 3"]`` is the vertex of the given point 3 alone.
    regions : (faces,) array
        The region of each face, as it was given; empty without regions.
    regions_lost : (lost,) array
        Regions without faces.
    borders_kept : float
        The part of the length of the regions' borders that is on edges of the mesh, 0 to 1.
    corners_missed : int
        Places where three regions meet, or two at the boundary, that are no points of the mesh.
    largest_area_error : float
        Of all regions with faces, relative to the area on the surface.
    edge_length, maximum_distance : float
        Wanted edge length, and distance of middles of faces and edges from the surface.
    edges_as_wanted : float
        The part of the edges, 0 to 1, whose length is within 25 % of what sizing asks for.
    error_of_sizes : float
        With another size_source the error at the middles of faces that the sizes are for, else 0.
    boundary_unevenness : float
        With even spacing the standard deviation of the lengths of the boundary's edges between two
        corners, relative to their mean.
    boundary_points_kept : int
        With boundary_spacing 'keep' the points of the boundary that are points of the mesh.
    summary : str
    warnings : list of str
    """


class Guidance(_Result):
    """Vectors and weights from 0 to 1 at the points, and strengths if any, for `field`; see its
    maker for the rest."""


class Comparison(_Result):
    """How far two fields of one degree are apart.

    Attributes
    ----------
    angles : (points,) float64
        Degrees, 0 to 180 / degree.
    mean, maximum : float
    singularities : list of (field, index, triangle, match, distance)
        Those of both fields, 0 and 1; match is the number of the other in this list, or -1.
    summary : str
    """
