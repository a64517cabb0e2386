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
import sys

import numpy

from . import _core
from ._calls import (
    DirectionFieldWarning, _call, _keyword_options, _listener, _numbers, _optional, _region_name, _regions,
    _result,
    _surface, _tensors)
from ._core import FileError, MeshError
from ._results import Comparison, Field, Guidance, Lines, Mesh, Stripes

__all__ = [
    "Comparison", "DirectionFieldWarning", "Field", "FileError", "Guidance", "Lines", "Mesh",
    "MeshError", "Stripes", "compare", "curvature", "field", "from_directions", "graph",
    "guide_by_curves", "guide_by_tensors", "options", "read", "remesh", "streamlines", "stripes",
]
MeshError.__doc__ = "A mesh that cannot be processed: a ValueError."
FileError.__doc__ = "A file that cannot be read or written, or has other contents: an OSError."
# The interpreter must not end before computations that nobody waits for any more.
atexit.register(_core.stop_all)


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

@_keyword_options("field")
def field(
        points, triangles, *, vectors=None, weights=None, strengths=None, tensors=None,
        progress=None, **options):
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
    strengths : (n,) array of numbers, optional
        How strongly ``constrain_guidance=True`` holds each vector, 0 to 1: exactly at 1, the
        default; with less by a term of the energy, so that the field may deviate; at 0 not at all.
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
        _optional("weights", weights, size), _optional("strengths", strengths, size), tensors,
        _listener(progress), options), polygons=polygons)


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
    made = _call(_core.field, surface, None, None, None, None, None, {
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
def remesh(points, triangles=None, *, sizing=None, regions=None, curves=(), given_points=None, progress=None,
           **options):
    """A mesh of quads or triangles that follows a field.

    Parameters
    ----------
    points, triangles
        As for `field`; or a Field of degree 4, or 6 for ``element="triangles"``, alone.
    sizing : (points,) array of numbers, optional
        Wanted edge length at each point relative to elsewhere, 1/8 to 8; with
        ``sizing_is_length`` the length itself.
    regions : (triangles,) array of integers or strings, optional
        Of each triangle, or polygon. Borders between regions become edges of the mesh, places where
        three meet points, and each face has the value of its region.
    curves : list of (n, 3) arrays of numbers, optional
        Poly lines on the surface that become edges of the mesh; the first point again at the end of
        closed ones. They are projected; parts farther away than a hundredth of the diagonal are
        left out, with a warning.
    given_points : (n, 3) array of numbers, optional
        Points on the surface that become vertices of the mesh, at the closest places there: the
        vertex of point 3 is `chains["Point 3"][0]`. Those farther away than a hundredth of the
        diagonal, or closer than a tenth of an edge to others, are left out, with a warning.
    progress : callable, optional
    **options

    Returns
    -------
    Mesh
    """
    directions, polygons = None, None
    if isinstance(points, Field):
        degree = 6 if options.get("element") == "triangles" else 4
        if points.degree != degree:
            raise ValueError(f"field must be of degree {degree}, not {points.degree}.")
        surface, directions = points._surface, points.directions[:, 0]
        polygons = points.polygons
    else:
        surface, polygons = _surface(points, triangles)
    sizing = _optional("sizing", sizing, len(surface.points))
    values, numbers, names = numpy.zeros(0, int), None, []
    if regions is not None:
        values, numbers = _regions(regions, surface, polygons)
        names = [_region_name(value) for value in values.tolist()]
    made = _call(
        _core.remesh, surface, directions, sizing, numbers, names,
        [_numbers("curves", curve, None, 3) for curve in curves],
        None if given_points is None else _numbers("given_points", given_points, None, 3), _listener(progress), options)
    if "regions" in made:
        made["regions"] = values[made["regions"]]
        made["regions_lost"] = values[made["regions_lost"]]
    return _result(Mesh, made)


@_keyword_options("guide_by_curves")
def guide_by_curves(
        points, triangles, curves, *, strengths=None, progress=None, **options):
    """Guidance for a field along curves on a surface.

    Parameters
    ----------
    points, triangles
        As for `field`.
    curves : list of (n, 3) arrays of numbers
        Poly lines, near the surface.
    strengths : array of a number for each curve, optional
        How strongly `field` is to hold each curve, 0 to 1; 1 by default, exactly.
    progress : callable, optional
    **options

    Returns
    -------
    Guidance
        `vectors`, `weights`, and `strengths`, or None where none are given; `samples` of the
        curves, and `far_samples` of them.
    """
    surface, _ = _surface(points, triangles)
    curves = [_numbers("curves", curve, None, 3) for curve in curves]
    return _result(Guidance, _call(
        _core.guide_by_curves, surface, curves,
        _optional("strengths", strengths, len(curves)), _listener(progress), options))


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
