# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""How functions of Python call the libraries: keywords, arrays, errors, warnings."""

import inspect
import sys
import warnings

import numpy

from . import _core
from ._core import FileError, MeshError
from ._texts import DESCRIPTIONS, in_python


class DirectionFieldWarning(UserWarning):
    """Mended meshes, options that changed nothing, likely mistakes, fields not converged."""

    __module__ = __package__


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


def _regions(regions, surface, polygons):
    """The different values, and which of them each triangle has."""
    regions = numpy.asarray(regions)
    if regions.dtype.kind not in "iuUSb":
        raise TypeError(f"regions must be integers or strings, not {regions.dtype}.")
    count = len(surface.triangles)
    if polygons is not None and regions.shape == (polygons.max() + 1,):
        regions = regions[polygons]
    if regions.shape != (count,):
        raise ValueError(
            f"regions must be one value for each of the {count} triangles, not {regions.shape}.")
    values, numbers = numpy.unique(regions, return_inverse=True)
    # Borders around more regions than these are the edges of the surface.
    if len(values) > 10000 or (count > 100 and 2 * len(values) > count):
        raise ValueError(
            f"regions has {len(values)} values on {count} triangles: they number triangles, not regions.")
    return values, numbers.reshape(-1)


def _region_name(value):
    """As the libraries name the region of a value: strings are in quotation marks."""
    if isinstance(value, bytes):
        value = value.decode("utf-8", errors="replace")
    return f'"{value}"' if isinstance(value, str) else str(value)


def _listener(progress):
    if progress is not None and not callable(progress):
        raise TypeError("progress must be a function of the fraction done.")
    return progress


def _result(kind, made, **more):
    result = kind(**made, **more)
    # Warnings name the caller's line.
    level, frame = 1, sys._getframe()
    while frame.f_back and frame.f_globals.get("__name__", "").split(".")[0] == __package__:
        level, frame = level + 1, frame.f_back
    result.warnings = [in_python(sentence) for sentence in getattr(result, "warnings", [])]
    for sentence in result.warnings:
        warnings.warn(sentence, DirectionFieldWarning, stacklevel=level)
    return result
