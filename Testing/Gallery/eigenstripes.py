# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The published stripe pattern of a flat annulus: the smallest eigenvector (F. Knöppel, K. Crane, U. Pinkall,
P. Schröder, Stripe Patterns on Surfaces, 2015), by dense linear algebra, for comparison with Stripe Pattern."""

import numpy as np

import meshes


class EigenStripes:
    """Stripes across a field of vectors on a plane surface."""

    def __init__(self, points, triangles, directions, spacing):
        self.points, self.triangles = points, triangles
        tails, heads = (np.concatenate([triangles[:, k] for k in order])
                        for order in ((0, 1, 2), (1, 2, 0)))
        along = points[heads] - points[tails]
        # In radians, of the half-edges of corners 0, 1, 2 one after the other.
        self.wanted = np.pi / spacing * np.sum((directions[tails] + directions[heads]) * along, axis=1)
        self.tails, self.heads = tails, heads
        weights = np.concatenate([self.cotangents(k) for k in (2, 0, 1)]) / 2.0
        count = len(points)
        energy = np.zeros((count, count), dtype=complex)
        np.add.at(energy, (tails, tails), weights)
        np.add.at(energy, (heads, heads), weights)
        np.add.at(energy, (heads, tails), -weights * np.exp(1j * self.wanted))
        np.add.at(energy, (tails, heads), -weights * np.exp(-1j * self.wanted))
        areas = np.zeros(count)
        np.add.at(areas, triangles, np.repeat(self.areas()[:, None] / 3.0, 3, axis=1))
        self.section = self.smallest(energy, areas)
        self.phases = np.angle(self.section)

    def cotangents(self, corner):
        """Of the angles at a corner of the triangles."""
        at, a, b = (self.points[self.triangles[:, (corner + k) % 3]] for k in range(3))
        return np.sum((a - at) * (b - at), axis=1) / np.linalg.norm(np.cross(a - at, b - at), axis=1)

    def areas(self):
        a, b, c = (self.points[self.triangles[:, k]] for k in range(3))
        return 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)

    @staticmethod
    def smallest(energy, areas, count=16, steps=60):
        """The eigenvector of energy x = lambda areas x for the smallest lambda, by inverse iteration of some at once: on
        a ring many eigenvalues are about the same."""
        scales = 1.0 / np.sqrt(areas)
        inverse = np.linalg.inv(scales[:, None] * energy * scales[None, :])
        x = np.exp(2.4j * np.outer(np.arange(len(areas)), 1.0 + np.sqrt(np.arange(count))))
        for _ in range(steps):
            x, _ = np.linalg.qr(inverse @ x)
        values, vectors = np.linalg.eigh(x.conj().T @ inverse @ x)
        first = x @ vectors[:, -1]
        rest = inverse @ first - values[-1] * first
        assert np.linalg.norm(rest) < 1e-6 * values[-1], np.linalg.norm(rest) / values[-1]
        return scales * first

    def steps(self):
        """Of the phase along the half-edges: those nearest to the wanted ones."""
        missing = self.phases[self.heads] - self.phases[self.tails] - self.wanted
        return self.wanted + missing - 2.0 * np.pi * np.round(missing / (2.0 * np.pi))

    def misfit(self):
        """The root mean square of what the steps miss over that of the wanted ones, each edge once."""
        _, once = np.unique(np.sort(np.stack([self.tails, self.heads], axis=1), axis=1), axis=0,
                            return_index=True)
        missing = (self.steps() - self.wanted)[once]
        return np.sqrt(np.mean(missing**2) / np.mean(self.wanted[once]**2))

    def branch_points(self):
        """The number of triangles around which the phase turns."""
        turns = self.steps().reshape(3, -1).sum(axis=0) / (2.0 * np.pi)
        return int(np.count_nonzero(np.round(turns)))

    def bands(self, parts=8):
        """The surface, each triangle in parts^2, with the cell array Stripe: 0 or 1."""
        from vtkmodules.util.numpy_support import numpy_to_vtk
        steps = self.steps().reshape(3, -1)
        phases = self.phases[self.triangles[:, 0]][:, None] + np.stack(
            [np.zeros(steps.shape[1]), steps[0], -steps[2]], axis=1)
        corners = self.points[self.triangles]
        pieces, stripes = [], []
        for i in range(parts):
            for j in range(parts - i):
                for piece in ([(i, j), (i + 1, j), (i, j + 1)], [(i + 1, j), (i + 1, j + 1), (i, j + 1)]):
                    if max(a + b for a, b in piece) > parts:
                        continue
                    weights = np.array([(parts - a - b, a, b) for a, b in piece]) / parts
                    pieces.append(np.einsum("kc,tcx->tkx", weights, corners))
                    stripes.append(np.cos(phases @ weights.mean(axis=0)) < 0.0)
        pieces = np.concatenate(pieces)
        mesh = meshes.polydata(pieces.reshape(-1, 3), np.arange(3 * len(pieces)).reshape(-1, 3))
        array = numpy_to_vtk(np.concatenate(stripes).astype(np.int8), deep=True)
        array.SetName("Stripe")
        mesh.GetCellData().AddArray(array)
        return mesh
