# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Globally optimal direction fields of surfaces, from and to NumPy arrays.

>>> import direction_fields as df
>>> points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
>>> triangles = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]
>>> field = df.field(points, triangles, degree=4)
>>> field.directions.shape
(4, 4, 3)
>>> int(field.indices.sum())
8
"""

import atexit
import inspect
import sys
import types
import warnings

import numpy

from . import _core
from ._core import FileError, MeshError
from ._texts import DESCRIPTIONS, in_python

__all__ = [
    "Comparison", "DirectionFieldWarning", "Field", "FileError", "Guidance", "Lines", "Mesh",
    "MeshError", "Stripes", "compare", "curvature", "field", "from_directions", "graph",
    "guide_by_curves", "guide_by_tensors", "options", "read", "remesh", "streamlines", "stripes",
]
MeshError.__doc__ = "A mesh that cannot be processed: a ValueError."
FileError.__doc__ = "A file that cannot be read or written, or has other contents: an OSError."
# The interpreter must not end before computations that nobody waits for any more.
atexit.register(_core.stop_all)


class DirectionFieldWarning(UserWarning):
    """Mended meshes, options that changed nothing, likely mistakes, fields not converged."""


def options(function="field"):
    """What a function takes by keyword: the default, and what it may be.

    Parameters
    ----------
    function : str
        Name of a function: field, edit, remesh, streamlines, stripes, guide_by_curves,
        guide_by_tensors, read or write.

    Returns
    -------
    dict
        For each keyword ``(default, least, most, unit)`` for numbers, ``(default,)`` for flags, and
        ``(default, names)`` for choices.

    Examples
    --------
    >>> options()["degree"]
    (4, 1.0, 16.0, '')
    >>> options()["alignment"]
    ('none', ['none', 'curvature', 'vectors', 'tensor'])
    """
    if function not in _core.options:
        raise ValueError(f"function must be one of {', '.join(_core.options)}.")
    return dict(_core.options[function])


def _keyword_options(name):
    """Puts the options of a function into its docstring and its signature."""

    def words(default, least=None, most=None, unit=""):
        if isinstance(least, list):
            return "{" + ", ".join(map(repr, least)) + f"}}, default {default!r}"
        kind = f"{type(default).__name__}, default {default!r}"
        if least is None:
            return kind
        return kind + (f", {least:g} to {most:g}" if most and most < 1e300 else f", at least {least:g}") + unit

    def decorate(call):
        described = _core.options[name]
        if call.__doc__:
            lines = "".join(
                f"\n{key} : {words(*entry)}\n    {DESCRIPTIONS[name][key]}"
                for key, entry in described.items())
            # From Python 3.13 on the compiler takes the indentation away.
            call.__doc__ = inspect.cleandoc(call.__doc__).replace("\n**options", lines)
        signature = inspect.signature(call)
        kept = [p for p in signature.parameters.values() if p.kind is not p.VAR_KEYWORD]
        call.__signature__ = signature.replace(parameters=kept + [
            inspect.Parameter(key, inspect.Parameter.KEYWORD_ONLY, default=entry[0])
            for key, entry in described.items()])
        return call

    return decorate


def _call(function, *arguments):
    """Calls the libraries; errors name the keywords of Python."""
    try:
        return function(*arguments)
    except (ValueError, FileError) as error:
        if error.__traceback__.tb_next is not None:
            # Raised by a function of the caller's, such as progress.
            raise
        raise type(error)(in_python(str(error))) from None


def _numbers(name, array, *shape):
    """The array as real numbers of a shape; None stands for any length."""
    array = numpy.require(array, requirements="A")
    if array.dtype.kind not in "iuf":
        raise TypeError(f"{name} must be real numbers, not {array.dtype}.")
    if array.ndim != len(shape) or any(k not in (None, n) for k, n in zip(shape, array.shape)):
        words = ", ".join("n" if k is None else str(k) for k in shape)
        raise ValueError(f"{name} must be of the shape ({words}), not {array.shape}.")
    return array


def _ids(name, array):
    array = numpy.require(array, requirements="A")
    if array.dtype.kind not in "iu":
        raise TypeError(f"{name} must be integers, the ids of points, not {array.dtype}.")
    return array


def _require_ids(array, points):
    if array.size and (array.min() < 0 or array.max() >= points):
        raise ValueError(
            f"triangles must be ids of points, 0 to {points - 1}; "
            f"they are {array.min()} to {array.max()}.")


def _polygons(faces):
    """Offsets and corners of polygons: a pair of these, PyVista's row of sizes and ids, or an array
    whose rows end with -1 where they have fewer corners."""
    if isinstance(faces, tuple):
        offsets, corners = (_ids("triangles", part) for part in faces)
        if offsets.ndim != 1 or corners.ndim != 1 or len(offsets) < 1 or offsets[0] != 0 or \
                offsets[-1] != len(corners) or (numpy.diff(offsets.astype(numpy.int64)) < 0).any():
            raise ValueError(
                "triangles must be (offsets, corners), offsets from 0 to the number of corners.")
        return offsets, corners
    faces = _ids("triangles", faces)
    if faces.ndim == 1:
        offsets, at, row = [0], 0, faces.tolist()
        while at < len(row):
            at += row[at] + 1 if row[at] >= 0 else len(row) + 1
            offsets.append(at - len(offsets))
        if at != len(row):
            raise ValueError("triangles must be sizes, each with as many ids after it (PyVista).")
        starts = numpy.array(offsets[:-1]) + numpy.arange(len(offsets) - 1)
        return numpy.array(offsets), numpy.delete(faces, starts)
    if faces.ndim != 2 or faces.shape[1] < 3:
        raise ValueError(f"triangles must be of the shape (n, 3), not {faces.shape}.")
    is_there = numpy.logical_and.accumulate(faces.astype(numpy.int64) != -1, axis=1)
    return numpy.concatenate([[0], numpy.cumsum(is_there.sum(axis=1))]), faces[is_there]


def _surface(points, triangles):
    """The surface, and the polygon of each triangle."""
    points = _numbers("points", points, None, 3)
    polygons = None
    if isinstance(triangles, tuple) or numpy.ndim(triangles) != 2 or numpy.shape(triangles)[1] != 3:
        if not isinstance(triangles, tuple) and numpy.size(triangles) == 0:
            raise ValueError("triangles is empty: a field needs at least one triangle.")
        offsets, corners = _polygons(triangles)
        _require_ids(corners, len(points))
        bare = _core.Surface(points, numpy.zeros((0, 3), numpy.int32))
        if not numpy.isfinite(points[corners]).all():
            raise MeshError("A point of the surface has a coordinate that is NaN or infinite.")
        triangles, polygons = _core.cut(bare, offsets, corners)
    triangles = _ids("triangles", triangles)
    if len(triangles) == 0:
        raise ValueError("triangles is empty: a field needs at least one triangle.")
    _require_ids(triangles, len(points))
    return _core.Surface(points, triangles), polygons


def _optional(name, array, *shape):
    return None if array is None else _numbers(name, array, *shape)


def _tensors(tensors, at_triangles, surface, polygons):
    """The tensors, one for each triangle in place of one for each polygon."""
    tensors = _numbers("tensors", tensors, None, None)
    if at_triangles and polygons is not None and polygons.max() < len(tensors) < len(surface.triangles):
        tensors = tensors[polygons]
    return tensors


def _listener(progress):
    if progress is not None and not callable(progress):
        raise TypeError("progress must be a function of the fraction done.")
    return progress


def _result(kind, made, **more):
    result = kind(**made, **more)
    # Warnings name the caller's line.
    level, frame = 1, sys._getframe()
    while frame.f_back and frame.f_globals.get("__name__", "").split(".")[0] == __name__:
        level, frame = level + 1, frame.f_back
    result.warnings = [in_python(sentence) for sentence in getattr(result, "warnings", [])]
    for sentence in result.warnings:
        warnings.warn(sentence, DirectionFieldWarning, stacklevel=level)
    return result


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
    irregular : (irregular,) int32
        Inner points with another number of edges than 4, or 6 for triangles.
    kinds : (points,) int8
        0 surface, 1 boundary, 2 feature, 3 corner, 4 singularity of the field.
    source_triangles, source_weights : (points,) int32, (points, 3) float64
        Where each point is on the surface given.
    edge_length, maximum_distance : float
        Wanted edge length, and distance of the faces' middles from the surface.
    summary : str
    warnings : list of str
    """


class Guidance(_Result):
    """Vectors, and weights from 0 to 1, at the points, for `field`; see its maker for the rest."""


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


@_keyword_options("field")
def field(
        points, triangles, *, vectors=None, weights=None, tensors=None, progress=None, **options):
    """The smoothest, an aligned or a constrained direction field of a mesh.

    Other threads of Python go on meanwhile, and Ctrl-C in the main thread returns at once.

    Parameters
    ----------
    points : (n, 3) array of numbers
        Coordinates; float32 and float64 are read where they are, whatever their strides.
    triangles : (m, 3) array of integers
        Ids of points, 0 to n - 1, counter-clockwise as seen from outside. Or polygons: a pair
        (offsets, corners), PyVista's ``faces``, or rows of more ids that end with -1.
    vectors : (n, 3) array of numbers, optional
        Guidance for ``alignment="vectors"`` and ``constrain_guidance=True``. Each is projected to
        the tangent plane; the length that remains is a weight.
    weights : (n,) array of numbers, optional
        Further weights of the guidance; 1 by default.
    tensors : (n, 6) or (n, 9) array of numbers, optional
        For ``alignment="tensor"``: XX, YY, ZZ, XY, YZ, XZ, or rows of three, in the axes of space.
        With ``tensors_at="triangles"``, of the polygons, where these were given.
    progress : callable, optional
        Called with the fraction done, 0 to 1. An exception that it raises stops the computation
        and reaches the caller.
    **options

    Returns
    -------
    Field

    Raises
    ------
    TypeError
        For an unknown keyword, and for arrays and options of the wrong type.
    ValueError
        For arrays of the wrong shape, ids that no point has, and options out of range.
    MeshError
        A ValueError: for a used point with a coordinate that is NaN or infinite.

    Warns
    -----
    DirectionFieldWarning
        For mended meshes, options that changed nothing, and fields that are not converged.
    """
    surface, polygons = _surface(points, triangles)
    size = len(surface.points)
    if tensors is not None:
        tensors = _tensors(tensors, options.get("tensors_at") == "triangles", surface, polygons)
    return _result(Field, _call(
        _core.field, surface, _optional("vectors", vectors, size, 3),
        _optional("weights", weights, size), tensors, _listener(progress), options),
        polygons=polygons)


def curvature(points, triangles, *, scale=0.0):
    """Principal directions, mean and Gaussian curvature of a mesh.

    Parameters
    ----------
    points, triangles
        As for `field`.
    scale : float, default 0.0, 0 to 32
        Radius that curvature is averaged over, in edges; 0 finds it by the noise.

    Returns
    -------
    Field
        Of the principal directions, degree 4, with `principal_directions`, `mean_curvature` and
        `gaussian_curvature`.
    """
    surface, polygons = _surface(points, triangles)
    made = _call(_core.field, surface, None, None, None, None, {
        "alignment": "curvature", "alignment_strength": 1.0, "curvature_scale": scale})
    # Nobody has asked for an alignment, which changes nothing on spheres and planes.
    made["warnings"] = [text for text in made["warnings"] if "another Alignment" not in text]
    return _result(Field, made, polygons=polygons)


def from_directions(points, triangles, directions, magnitudes=None):
    """A field of given directions, for all functions that take one.

    Parameters
    ----------
    points, triangles
        As for `field`.
    directions : (points, degree, 3) array of numbers
        Vectors of any length, counter-clockwise about the normal; zero for none.
    magnitudes : (points,) array of numbers, optional
        Weights against the neighbours; 1 by default.

    Returns
    -------
    Field
    """
    surface, polygons = _surface(points, triangles)
    size = len(surface.points)
    directions = _numbers("directions", directions, size, None, 3).astype(numpy.float64)
    if not 1 <= directions.shape[1] <= 16:
        raise ValueError("directions must be 1 to 16 a point.")
    magnitudes = _optional("magnitudes", magnitudes, size)
    indices = _call(_core.indices, _core.Given(surface, directions, magnitudes))
    return Field(
        _surface=surface, degree=directions.shape[1], directions=directions, magnitudes=magnitudes,
        indices=indices, polygons=polygons, warnings=[],
        summary=f"{numpy.count_nonzero(indices)} singularities, index sum {indices.sum()}, as given")


@_keyword_options("read")
def read(points, triangles, path, **options):
    """The field of a file of another program: .rosy, .ffield, .rawfield, or .obj with comments.

    Parameters
    ----------
    points, triangles
        The very mesh that the file belongs to, in its order; triangles only.
    path : str or path
    **options

    Returns
    -------
    Field
    """
    surface, polygons = _surface(points, triangles)
    if polygons is not None:
        raise ValueError("triangles must be triangles: the rows of a file belong to these.")
    return _result(Field, _call(_core.read, surface, str(path), options), polygons=None)


def _given(field):
    if not isinstance(field, Field):
        raise TypeError("field must be a Field, of field(), from_directions() or read().")
    return field._given()


@_keyword_options("streamlines")
def streamlines(field, points=None, *, progress=None, **options):
    """Lines along a field: evenly spaced, from the singularities, or from points.

    Parameters
    ----------
    field : Field
    points : (n, 3) array of numbers, optional
        Where lines start, with ``start="points"``, which it brings: the nearest places count.
    progress : callable, optional
    **options

    Returns
    -------
    Lines
    """
    points = _optional("points", points, None, 3)
    if points is not None:
        options.setdefault("start", "points")
    elif options.get("start") == "points":
        raise ValueError("points must be given for start='points'.")
    return _result(
        Lines, _call(_core.streamlines, _given(field), points, _listener(progress), options))


def graph(field, **options):
    """The field's graph: lines from the singularities that end where they cross.

    Parameters
    ----------
    field : Field
    **options
        As for `streamlines`.

    Returns
    -------
    Lines
        Its `nodes` and `end_nodes` are the graph.
    """
    made = {"start": "singularities", "stop_at_crossings": True, **options}
    progress = _listener(made.pop("progress", None))
    return _result(Lines, _call(_core.streamlines, _given(field), None, progress, made))


@_keyword_options("stripes")
def stripes(field, *, spacings=None, progress=None, **options):
    """Evenly spaced stripes along a field of degree 1 or 2.

    Parameters
    ----------
    field : Field
    spacings : (points,) array of numbers, optional
        Distance between stripes at each point, in place of ``spacing``.
    progress : callable, optional
    **options

    Returns
    -------
    Stripes
    """
    given = _given(field)
    spacings = _optional("spacings", spacings, len(field.points))
    return _result(Stripes, _call(_core.stripes, given, spacings, _listener(progress), options))


@_keyword_options("remesh")
def remesh(points, triangles=None, *, sizing=None, progress=None, **options):
    """A mesh of quads or triangles that follows a field.

    Parameters
    ----------
    points, triangles
        As for `field`; or a Field of degree 4, or 6 for ``element="triangles"``, alone.
    sizing : (points,) array of numbers, optional
        Wanted edge length at each point relative to elsewhere, 1/8 to 8.
    progress : callable, optional
    **options

    Returns
    -------
    Mesh
    """
    directions = None
    if isinstance(points, Field):
        degree = 6 if options.get("element") == "triangles" else 4
        if points.degree != degree:
            raise ValueError(f"field must be of degree {degree}, not {points.degree}.")
        surface, directions = points._surface, points.directions[:, 0]
    else:
        surface, _ = _surface(points, triangles)
    sizing = _optional("sizing", sizing, len(surface.points))
    return _result(
        Mesh, _call(_core.remesh, surface, directions, sizing, _listener(progress), options))


@_keyword_options("guide_by_curves")
def guide_by_curves(points, triangles, curves, *, progress=None, **options):
    """Guidance for a field along curves on a surface.

    Parameters
    ----------
    points, triangles
        As for `field`.
    curves : list of (n, 3) arrays of numbers
        Poly lines, near the surface.
    progress : callable, optional
    **options

    Returns
    -------
    Guidance
        `vectors`, `weights`; `samples` of the curves, and `far_samples` of them.
    """
    surface, _ = _surface(points, triangles)
    curves = [_numbers("curves", curve, None, 3) for curve in curves]
    return _result(Guidance, _call(
        _core.guide_by_curves, surface, curves, _listener(progress), options))


@_keyword_options("guide_by_tensors")
def guide_by_tensors(points, triangles, tensors, *, at="points", progress=None, **options):
    """Guidance along the principal directions of stress, strain or other tensors.

    Parameters
    ----------
    points, triangles
        As for `field`.
    tensors : (n, 6) or (n, 9) array of numbers
        XX, YY, ZZ, XY, YZ, XZ, or rows of three, in the axes of space.
    at : {'points', 'triangles'}
        What has a tensor each; the polygons, where these were given.
    progress : callable, optional
    **options

    Returns
    -------
    Guidance
        `vectors`, `weights`; `major_values`, `minor_values`, `anisotropy` at the points; the
        `isotropic_share` of the area, and the `asymmetric_part`, 0 to 1.
    """
    if at not in ("points", "triangles"):
        raise ValueError("at must be one of 'points', 'triangles'.")
    surface, polygons = _surface(points, triangles)
    made = _call(
        _core.guide_by_tensors, surface,
        _tensors(tensors, at == "triangles", surface, polygons), at == "triangles",
        _listener(progress), options)
    guided = numpy.count_nonzero(made["weights"])
    return _result(Guidance, made, summary=f"{guided} of {len(made['weights'])} points guided")


def compare(field, other, *, progress=None):
    """Angles between two fields of the same degree on one surface, and which singularities match.

    Parameters
    ----------
    field, other : Field
    progress : callable, optional

    Returns
    -------
    Comparison
    """
    one, two = _given(field), _given(other)
    if field.directions.shape != other.directions.shape:
        raise ValueError("other must be of the degree and on the surface of field.")
    if not numpy.array_equal(field.triangles, other.triangles):
        raise ValueError("other must be on the surface of field: their triangles differ.")
    return _result(Comparison, _call(_core.compare, one, two, _listener(progress)))


if "pyvista" in sys.modules:
    from . import pyvista as _
