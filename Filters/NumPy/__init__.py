# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Globally optimal direction fields of triangle meshes, from and to NumPy arrays.

>>> import direction_fields as df
>>> points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
>>> triangles = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]
>>> field = df.field(points, triangles, degree=4)
>>> field.directions.shape
(4, 4, 3)
>>> int(field.indices.sum())
8
"""

import types
import warnings

import numpy

from . import _core
from ._core import MeshError

__all__ = ["DirectionFieldWarning", "Field", "MeshError", "field", "options"]


class DirectionFieldWarning(UserWarning):
    """Options that changed nothing, likely mistakes in the input, and fields not converged."""


class Field(types.SimpleNamespace):
    """A direction field; its arrays own their memory.

    Points are those of the input, in their order, then those that were split off where the surface
    is no manifold; triangles are those of the input.

    Attributes
    ----------
    degree : int
        Directions at each point.
    directions : (points, degree, 3) float64
        Unit tangent vectors, counter-clockwise about the normal.
    representation : (points,) complex128
        Its argument is degree times the angle of a direction from `x_axes`.
    energy_density : (points,) float64
        How much the directions turn around the point, in 1 / length^2.
    normals, x_axes : (points, 3) float64
        Unit normals, and the unit tangent vectors from which angles are measured.
    original_points : (points,) int32
        The input's point of each point.
    split_triangles : (triangles, 3) int32 or None
        The triangles with the points that were split off; None where none were.
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
    warnings : list of str
        The sentences that were given as warnings, too.
    principal_directions : pair of (points, 3) float64
        Of the larger and of the smaller curvature; zero where the two are equal. This and the
        following are there only where the options use curvature.
    mean_curvature, gaussian_curvature : (points,) float64
        In 1 / length and 1 / length^2; the mean is positive where the surface is convex.
    """

    def __repr__(self):
        points, degree, _ = self.directions.shape
        return (
            f"<Field: {degree} directions at {points} points, "
            f"{len(self.singularities)} singularities>"
        )


def options():
    """The options of `field`: what each keyword is by default, and what it may be.

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
    ('none', ['none', 'curvature', 'vectors'])
    """
    return _core.options()


def _numbers(name, array, width=None):
    array = numpy.asarray(array)
    if array.dtype.kind not in "iuf":
        raise TypeError(f"{name} must be real numbers, not {array.dtype}.")
    if width is None:
        if array.ndim != 1:
            raise ValueError(f"{name} must be of the shape (n,), not {array.shape}.")
    elif array.ndim != 2 or array.shape[1] != width:
        raise ValueError(f"{name} must be of the shape (n, {width}), not {array.shape}.")
    return numpy.ascontiguousarray(array, dtype=numpy.float64)


def _triangles(array, points):
    array = numpy.asarray(array)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(
            f"triangles must be of the shape (n, 3), not {array.shape}; split other polygons first."
        )
    if len(array) == 0:
        raise ValueError("triangles is empty: a field needs at least one triangle.")
    if array.dtype.kind not in "iu":
        raise TypeError(f"triangles must be integers, the ids of points, not {array.dtype}.")
    if array.min() < 0 or array.max() >= points:
        raise ValueError(
            f"triangles must be ids of points, 0 to {points - 1}; "
            f"they are {array.min()} to {array.max()}."
        )
    return numpy.ascontiguousarray(array, dtype=numpy.int32)


def field(points, triangles, *, vectors=None, weights=None, progress=None, **options):
    """The smoothest, an aligned or a constrained direction field of a triangle mesh.

    Other threads of Python go on meanwhile, and Ctrl-C in the main thread stops the computation.

    Parameters
    ----------
    points : (n, 3) array of numbers
        Coordinates; they are copied, and need be neither contiguous nor writeable.
    triangles : (m, 3) array of integers
        Ids of points, 0 to n - 1, counter-clockwise as seen from outside.
    vectors : (n, 3) array of numbers, optional
        Guidance for ``alignment="vectors"`` and ``constrain_guidance=True``. Each is projected to
        the tangent plane; the length that remains is a weight.
    weights : (n,) array of numbers, optional
        Further weights of the guidance; 1 by default.
    progress : callable, optional
        Called with the fraction done, 0 to 1. An exception that it raises stops the computation
        and reaches the caller.
    **options
        The filter's options, as ``degree=4``, ``unit_length=True``, ``alignment="curvature"``;
        see `options` for all of them, with defaults, ranges and units.

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
        For options that changed nothing, likely mistakes, and fields that are not converged.
    """
    points = _numbers("points", points, 3)
    triangles = _triangles(triangles, len(points))
    if vectors is not None:
        vectors = _numbers("vectors", vectors, 3)
    if weights is not None:
        weights = _numbers("weights", weights)
    if progress is not None and not callable(progress):
        raise TypeError("progress must be a function of the fraction done.")
    result = Field(**_core.field(points, triangles, vectors, weights, progress, options))
    result.singularities = numpy.flatnonzero(result.indices)
    if not result.converged:
        result.warnings.append(
            "The field is not converged on all components: raise maximum_iterations or tolerance."
        )
    for sentence in result.warnings:
        warnings.warn(sentence, DirectionFieldWarning, stacklevel=2)
    return result
