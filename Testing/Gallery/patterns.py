# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Compares pictures of patterns by how they run, not by where each of their lines is.

Stripes have many patterns that miss the wanted spacing by nearly the same: rounding, which differs between libraries,
decides where lines branch. What all of them share is the direction of the stripes everywhere, and how much of the
picture each color has.
"""

import numpy as np

# In degrees. Patterns that differ by where lines branch stay below the first, those of a field turned by ten degrees
# above the second.
SAME, DIFFERENT = 2.0, 3.2
# Cells whose mean colors are this much apart, of 255, count as turned by as far as can be.
COLOR = 18.0


def cells(values, size):
    """The means over the cells of a picture."""
    rows, columns = (pixels // size for pixels in values.shape[:2])
    values = values[:rows * size, :columns * size]
    return values.reshape(rows, size, columns, size, *values.shape[2:]).mean(axis=(1, 3))


def runs(image, size):
    """How edges run in each cell: four times the angle of their gradients, as crossing stripes have two, by their squared
    lengths."""
    rises = np.gradient(image.astype(float).sum(axis=-1))
    gradient = rises[1] + 1j * rises[0]
    return cells(gradient**4 / np.maximum(np.abs(gradient), 1e-9)**2, size)


def turn(image, baseline, size):
    """By how many degrees a pattern runs otherwise than another, in the mean over what there is of it. They are compared
    by cells of some pixels, which are to be some stripes wide."""
    if image.shape != baseline.shape:
        return 45.0
    a, b = runs(image, size), runs(baseline, size)
    weights = np.sqrt(np.abs(a) * np.abs(b))
    angles = np.degrees(np.abs(np.angle(a * np.conj(b)))) / 4.0
    colors = np.abs(cells(image.astype(float), size) - cells(baseline.astype(float), size)).max(axis=-1)
    angles[colors > COLOR] = 45.0
    return float((weights * angles).sum() / weights.sum())
