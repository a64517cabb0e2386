# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tests of the accessor mesh.directions, where PyVista is installed; plots need a display."""

import sys
import unittest

import numpy as np

try:
    import pyvista
except ImportError:
    print("PyVista is not installed.")
    sys.exit(77)

# From 0.48 on PyVista finds the accessor by the entry point, as long as nobody has imported it.
FINDS_ACCESSORS = hasattr(pyvista, "register_dataset_accessor")
if not FINDS_ACCESSORS:
    import direction_fields.pyvista  # noqa: F401


class Accessor(unittest.TestCase):
    def setUp(self):
        self.sphere = pyvista.Icosphere(nsub=2)
        self.field = self.sphere.directions.field(degree=4)

    def test_field_is_a_surface_with_arrays(self):
        self.assertIsInstance(self.field, pyvista.PolyData)
        self.assertEqual(self.field.n_cells, self.sphere.n_cells)
        self.assertEqual(self.field.cell_data["SingularityIndex"].sum(), 8)
        length = np.linalg.norm(self.field.point_data["Direction3"], axis=1)
        self.assertLess(np.abs(length - 1).max(), 1e-6)
        self.assertIn("index sum 8", self.field.field_data["Summary"][0])
        self.assertEqual(self.field.directions.singularities().point_data["Index"].sum(), 8)

    def test_surfaces_keep_their_polygons(self):
        cube = pyvista.Cube(clean=True) if hasattr(pyvista.Cube, "clean") else pyvista.Cube()
        quads = cube.directions.field(constrain_sharp_edges=True)
        self.assertEqual(quads.n_cells, 6)
        self.assertTrue(np.array_equal(quads.faces, cube.faces))

    def test_tensors_are_named_arrays_of_points_or_cells(self):
        sphere = self.sphere.copy()
        around = np.cross([0, 0, 1], sphere.points)
        sphere.point_data["Stress"] = np.einsum("pi,pj->pij", around, around).reshape(-1, 9)
        cells = sphere.point_data_to_cell_data()
        for mesh, at in ((sphere, "points"), (cells, "triangles")):
            field = mesh.directions.field(
                degree=2, alignment="tensor", tensors="Stress", tensors_at=at)
            self.assertIn("along tensors", field.field_data["Summary"][0])
            self.assertEqual(field.point_data["SurfaceTensor"].shape, (sphere.n_points, 6))
            self.assertLess(np.abs(field.point_data["MajorValue"] - (around**2).sum(axis=1)).max(), 0.1)

    def test_everything_that_follows_a_field(self):
        directions = self.field.directions
        lines = directions.streamlines(spacing=0.1)
        self.assertEqual(lines.n_lines, lines.n_cells)
        self.assertGreater(lines.n_cells, 10)
        self.assertGreater(directions.graph().n_cells, 8)
        quads = directions.remesh(faces=300, pure_quads=True)
        self.assertEqual(set(quads.faces.reshape(-1, 5)[:, 0]), {4})
        mixed = self.sphere.directions.remesh(faces=300)
        self.assertEqual(mixed.n_cells, len(mixed.cell_data["ScaledJacobian"]))
        halves = self.sphere.copy()
        halves.cell_data["Half"] = (halves.cell_centers().points[:, 2] > 0).astype(int)
        parts = halves.directions.remesh(faces=300, regions="Half")
        self.assertEqual(set(parts.cell_data["Half"]), {0, 1})
        line = self.sphere.directions.field(degree=2).directions
        self.assertGreater(line.stripes(spacing=0.1).n_cells, 4)
        bands = line.bands(spacing=0.1)
        self.assertEqual(set(bands.cell_data["Stripe"]), {0, 1})
        self.assertAlmostEqual(bands.area, self.sphere.area, places=4)
        self.assertEqual(directions.glyphs().n_cells, 4 * self.sphere.n_points)
        vector = self.sphere.directions.field(degree=1).directions
        edited = vector.edit({3: 1, 40: 1})
        self.assertEqual(np.flatnonzero(edited.cell_data["SingularityIndex"]).tolist(), [3, 40])
        self.assertAlmostEqual(
            self.sphere.directions.curvature().point_data["MeanCurvature"].mean(),
            1.0 / np.linalg.norm(self.sphere.points[0]), delta=0.05)

    def test_guidance_by_name(self):
        self.sphere.point_data["guide"] = np.cross([0, 0, 1], self.sphere.points)
        field = self.sphere.directions.field(
            degree=2, vectors="guide", alignment="vectors", alignment_strength=0.9)
        self.assertIn("aligned", field.field_data["Summary"][0])

    def test_surfaces_without_a_field_say_so(self):
        with self.assertRaisesRegex(ValueError, "apply field"):
            self.sphere.directions.streamlines()

    def test_plots(self):
        self.field.plot(off_screen=True)
        self.field.directions.remesh(faces=200).plot(off_screen=True, show_edges=True)


if __name__ == "__main__":
    unittest.main()
