# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tests of what direction_fields makes of fields: edits, lines, stripes, meshes, guidance, files."""

import os
import tempfile
import unittest
import warnings

import numpy as np

import direction_fields as df
from surfaces import OCTAHEDRON, torus


def disk(rings=12):
    """Triangles of a flat disk of radius 1."""
    radius, angle = np.meshgrid(np.arange(1, rings + 1) / rings, np.arange(6 * rings), indexing="ij")
    angle = 2 * np.pi * angle / (6 * rings)
    points = np.stack([radius * np.cos(angle), radius * np.sin(angle), 0 * angle], -1).reshape(-1, 3)
    around = 6 * rings
    i, j = np.meshgrid(np.arange(rings - 1), np.arange(around), indexing="ij")
    a, b = i * around + j, i * around + (j + 1) % around
    fan = [(len(points), k, (k + 1) % around) for k in range(around)]
    return np.concatenate([points, [[0, 0, 0]]]), np.concatenate(
        [fan, np.stack([a, a + around, b + around], -1).reshape(-1, 3),
         np.stack([a, b + around, b], -1).reshape(-1, 3)])


class Edits(unittest.TestCase):
    def test_singularities_come_where_they_are_wanted(self):
        points, triangles = torus()
        field = df.field(points, triangles, degree=4)
        edited = field.edit({10: 1, 900: -1})
        self.assertEqual(edited.singularities.tolist(), [10, 900])
        self.assertEqual(edited.indices[[10, 900]].tolist(), [1, -1])
        self.assertIn("edited", edited.summary)
        # Nothing is asked for: nothing changes.
        self.assertTrue(np.allclose(edited.edit({}).directions, edited.directions))

    def test_wrong_sums_are_refused_or_balanced(self):
        field = df.field(*torus())
        with self.assertRaisesRegex(ValueError, "must add up to 0"):
            field.edit({10: 1})
        with self.assertWarnsRegex(df.DirectionFieldWarning, "balance"):
            self.assertEqual(field.edit({10: 1}, balance=True).indices.sum(), 0)
        with self.assertRaisesRegex(ValueError, "0 to 2303"):
            field.edit({2304: 1})

    def test_refined_surfaces_hold_what_coarse_ones_cannot(self):
        coarse = df.field(*OCTAHEDRON, degree=4)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", df.DirectionFieldWarning)
            refined = coarse.edit({0: 4, 7: 4}, refine=True)
        self.assertEqual(refined.indices.sum(), 8)
        self.assertEqual(refined.directions.shape[0], len(refined.points))


class Lines(unittest.TestCase):
    def setUp(self):
        self.points, self.triangles = torus()
        self.field = df.field(self.points, self.triangles, alignment="curvature", alignment_strength=0.9)

    def test_evenly_spaced_lines_cover_the_surface(self):
        lines = df.streamlines(self.field, spacing=0.1, offset=0)
        self.assertEqual(lines.offsets[-1], len(lines.points))
        # Two families, each of area / spacing.
        area = 4 * np.pi**2 * 0.4
        self.assertLess(abs(lines.lengths.sum() * 0.1 / area / 2 - 1), 0.3)
        off = np.hypot(np.hypot(lines.points[:, 0], lines.points[:, 1]) - 1, lines.points[:, 2]) - 0.4
        self.assertLess(np.abs(off).max(), 0.02)
        self.assertIn("lines 0.1 apart", lines.summary)

    def test_lines_from_points_and_their_errors(self):
        lines = df.streamlines(self.field, [[1.4, 0, 0], [0, 0.6, 0]])
        self.assertEqual(sorted(set(lines.seeds.tolist())), [0, 1])
        with self.assertRaisesRegex(ValueError, "points must be given"):
            df.streamlines(self.field, start="points")
        with self.assertRaisesRegex(ValueError, "^spacing must be 0 or more"):
            df.streamlines(self.field, spacing=-1.0)
        with self.assertRaisesRegex(TypeError, "field must be a Field"):
            df.streamlines(self.points)

    def test_limited_lines_are_a_warning(self):
        with self.assertWarnsRegex(df.DirectionFieldWarning, "Raise maximum_number") as caught:
            lines = df.streamlines(self.field, spacing=0.1, maximum_number=5)
        self.assertEqual(len(lines.lengths), 5)
        self.assertEqual(caught.filename, __file__)

    def test_graph_has_its_nodes(self):
        graph = df.graph(df.field(*OCTAHEDRON))
        self.assertEqual((graph.node_types == 0).sum(), 8)
        self.assertTrue((graph.end_nodes.max() < len(graph.nodes)))
        self.assertGreaterEqual(len(graph.lengths), 12)

    def test_stripes_are_apart_as_wanted(self):
        field = df.field(self.points, self.triangles, degree=2, alignment="curvature",
                         alignment_strength=0.9)
        stripes = df.stripes(field, spacing=0.15)
        self.assertLess(abs(stripes.lengths.sum() * 0.15 / (4 * np.pi**2 * 0.4) - 1), 0.2)
        self.assertEqual(stripes.band_offsets[-1], len(stripes.band_corners))
        varied = df.stripes(field, spacings=np.full(len(self.points), 0.15))
        self.assertAlmostEqual(varied.lengths.sum() / stripes.lengths.sum(), 1, delta=0.05)
        with self.assertRaisesRegex(ValueError, "Set degree of field\\(\\) to 2"):
            df.stripes(self.field)


class Meshes(unittest.TestCase):
    def test_quads_along_the_shape(self):
        mesh = df.remesh(*torus(), faces=600, pure_quads=True)
        self.assertEqual(mesh.faces.shape[1], 4)
        self.assertTrue((mesh.faces >= 0).all())
        edges = {tuple(sorted(edge)) for face in mesh.faces.tolist()
                 for edge in zip(face, face[1:] + face[:1])}
        self.assertEqual(len(mesh.points) - len(edges) + len(mesh.faces), 0)
        self.assertLess(abs(len(mesh.faces) - 600), 150)
        self.assertGreater(mesh.quality.min(), 0.3)
        valence = np.bincount(np.array(sorted(edges)).ravel())
        self.assertEqual(np.flatnonzero(valence != 4).tolist(), mesh.irregular.tolist())

    def test_lengths_are_met(self):
        points, triangles = torus()
        mesh = df.remesh(points, triangles, sizing=0.1 + 0.01 * points[:, 0], sizing_is_length=True,
                         gradation=1.3)
        self.assertGreater(mesh.edges_as_wanted, 0.5)
        self.assertIn(f"{100 * mesh.edges_as_wanted:.3g} % of edges within", mesh.summary)
        with self.assertRaisesRegex(ValueError, "at point 0 is 0"):
            df.remesh(points, triangles, sizing=np.zeros(len(points)), sizing_is_length=True)

    def test_a_boundary_is_kept_or_even(self):
        x, y = (c.ravel() for c in np.meshgrid(np.linspace(0, 2, 21), np.linspace(0, 1, 11)))
        plate = np.stack([x, y, 0 * x], axis=1)
        corner = np.array([21 * j + i for j in range(10) for i in range(20)])
        squares = np.stack([corner, corner + 1, corner + 22, corner + 21], axis=1)
        around = {tuple(p) for p in plate[(x == 0) | (x == 2) | (y == 0) | (y == 1)]}
        mesh = df.remesh(plate, squares, faces=230, boundary_spacing="keep", pure_quads=True)
        self.assertEqual(mesh.boundary_points_kept, 60)
        self.assertTrue(around <= {tuple(p) for p in mesh.points})
        mesh = df.remesh(plate, squares, faces=230, boundary_spacing="even")
        self.assertLess(mesh.boundary_unevenness, 0.02)

    def test_sizes_come_from_the_curvature(self):
        points, triangles = torus()
        mesh = df.remesh(points, triangles, faces=800, size_source="curvature")
        self.assertGreater(mesh.error_of_sizes, 0)
        self.assertIn("sizes for an error of", mesh.summary)
        with self.assertRaisesRegex(ValueError, "function at point 0 is NaN"):
            df.remesh(points, triangles, size_source="second_derivatives", sizing=np.full(len(points), np.nan))

    def test_faces_are_judged_by_limits(self):
        with self.assertWarnsRegex(df.DirectionFieldWarning, r"\. passes shows where"):
            mesh = df.remesh(*torus(), faces=300, minimum_scaled_jacobian=0.995,
                             maximum_aspect_ratio=1.3, maximum_warpage=0.005)
        passes = (mesh.quality >= 0.995) & (mesh.aspect_ratios <= 1.3) & (mesh.warpages <= 0.005)
        self.assertEqual(mesh.passes.tolist(), passes.tolist())
        failed = len(passes) - passes.sum()
        self.assertTrue(0 < failed < len(passes))
        self.assertIn(f"{failed} faces fail the limits", mesh.summary)
        self.assertTrue(any(text.startswith(f"{failed} of ") for text in mesh.warnings))
        self.assertEqual(len(df.remesh(*torus(), faces=300).passes), 0)
        quads = mesh.faces[:, 3] >= 0
        self.assertTrue((mesh.aspect_ratios >= 1).all() and (mesh.warpages[~quads] == 0).all())

    def test_a_field_of_the_right_degree_is_followed(self):
        field = df.field(*torus(), degree=6)
        mesh = df.remesh(field, element="triangles", edge_length=0.1)
        self.assertTrue((mesh.faces[:, 3] == -1).all())
        with self.assertRaisesRegex(ValueError, "degree 4, not 6"):
            df.remesh(field)
        with self.assertRaisesRegex(ValueError, "faces has to be at least 1"):
            df.remesh(*torus(), faces=0)


    def test_regions_keep_their_borders_and_values(self):
        points, triangles = torus()
        height = points[triangles].mean(axis=1)[:, 2]
        for values in (np.array([40, 7]), np.array(["lid", "base"])):
            regions = values[(height > 0).astype(int)]
            mesh = df.remesh(points, triangles, faces=600, regions=regions)
            self.assertEqual(mesh.regions.dtype, values.dtype)
            self.assertAlmostEqual(mesh.borders_kept, 1)
            self.assertLessEqual(mesh.borders_kept, 1)
            heights = mesh.points[mesh.faces, 2] * (mesh.faces >= 0)
            above = mesh.regions == values[1]
            self.assertGreater(heights[above].min(), -1e-9)
            self.assertLess(heights[~above].max(), 1e-9)
            np.testing.assert_array_equal(mesh.regions, regions[mesh.source_faces])
            self.assertLess(mesh.largest_area_error, 0.02)
            self.assertEqual((len(mesh.regions_lost), mesh.corners_missed), (0, 0))
        self.assertEqual(len(df.remesh(points, triangles, faces=600).regions), 0)

    def test_curves_become_edges(self):
        points, triangles = torus()
        angle = np.linspace(0, 2 * np.pi, 80)
        curve = np.stack([1.4 * np.cos(angle), 1.4 * np.sin(angle), 0.1 * np.sin(3 * angle)], -1)
        curve[-1] = curve[0]
        mesh = df.remesh(points, triangles, faces=900, curves=[curve])
        self.assertEqual(list(mesh.chains), ["Curve 0 1"])
        ids = mesh.chains["Curve 0 1"]
        self.assertEqual(ids[0], ids[-1])
        far = np.linalg.norm(mesh.points[ids][:, None] - curve[None], axis=2).min(axis=1)
        self.assertLess(far.max(), 0.06)
        with self.assertWarnsRegex(df.DirectionFieldWarning, "Parts of curve 0"):
            df.remesh(points, triangles, faces=300, curves=[2 * curve])

    def test_given_points_become_vertices(self):
        x, y = (k.ravel() for k in np.meshgrid(np.linspace(0, 1, 21), np.linspace(0, 1, 21)))
        points = np.stack([x, y, 0 * x], -1)
        a = np.add.outer(21 * np.arange(20), np.arange(20)).ravel()
        quads = np.stack([a, a + 1, a + 22, a + 21], -1)
        given = np.array([[0.313, 0.777, 0], [0.5, 0.5, 0.4], [0.123, 0, 0], [0.6, 0.25, 0]])
        with self.assertWarnsRegex(df.DirectionFieldWarning, "Point 1 is no vertex of the mesh: farther"):
            mesh = df.remesh(points, quads, faces=300, given_points=given)
        self.assertEqual([name for name in mesh.chains if name.startswith("Point")],
                         ["Point 0", "Point 2", "Point 3"])
        for k in (0, 2, 3):
            ids = mesh.chains[f"Point {k}"]
            self.assertEqual(ids.shape, (1,))
            np.testing.assert_allclose(mesh.points[ids[0]], given[k], rtol=0, atol=1e-15)
            self.assertEqual(mesh.kinds[ids[0]], 3)
        self.assertEqual(len(df.remesh(points, quads, faces=300, given_points=given[:0]).chains), 4)
        for wrong in (given[:, :2], given[0], np.full((1, 3), np.nan)):
            with self.assertRaises(ValueError):
                df.remesh(points, quads, given_points=wrong)

    def test_regions_of_polygons(self):
        points = np.array([[x, y, 0] for y in range(9) for x in range(9)], float)
        a = np.array([9 * y + x for y in range(8) for x in range(8)])
        quads = np.stack([a, a + 1, a + 10, a + 9], -1)
        regions = np.where(points[quads].mean(axis=1)[:, 0] < 4, 3, 5)
        mesh = df.remesh(points, quads, faces=40, regions=regions)
        self.assertEqual(set(mesh.regions), {3, 5})
        self.assertEqual(list(mesh.chains)[-1], "Border 3/5 1")
        self.assertEqual(len(mesh.chains), 7)
        np.testing.assert_allclose(mesh.points[mesh.chains["Border 3/5 1"], 0], 4)
        np.testing.assert_array_equal(
            np.unique(np.concatenate([ids for name, ids in mesh.chains.items() if "Boundary" in name])),
            np.flatnonzero(np.isin(mesh.points[:, :2], (0, 8)).any(axis=1)))
        self.assertTrue(((mesh.points[mesh.faces].mean(axis=1)[:, 0] < 4) == (mesh.regions == 3)).all())
        # A field is of the polygons that it was computed on; bytes are text.
        made = df.remesh(df.field(points, quads), faces=40, regions=np.where(regions == 3, b"lid", b"base"))
        self.assertEqual(set(made.regions), {b"lid", b"base"})
        self.assertEqual(list(made.chains)[-1], "Border base/lid 1")
        for wrong, error in ((regions[1:], ValueError), (0.5 * regions, TypeError)):
            with self.assertRaisesRegex(error, "regions must be"):
                df.remesh(points, quads, regions=wrong)
        with self.assertRaisesRegex(ValueError, "number triangles"):
            df.remesh(*torus(), regions=np.arange(len(torus()[1])))


class Guidance(unittest.TestCase):
    def test_curves_guide(self):
        points, triangles = disk()
        curve = np.stack([np.linspace(-0.9, 0.9, 30), 0.02 + 0 * np.arange(30), 0 * np.arange(30)], -1)
        guide = df.guide_by_curves(points, triangles, [curve], degree=2, radius=0.2)
        self.assertIn("guided by 1 curve", guide.summary)
        field = df.field(points, triangles, degree=2, constrain_guidance=True, vectors=guide.vectors,
                         weights=guide.weights)
        near = np.abs(points[:, 1]) < 0.1
        self.assertGreater(np.abs(field.directions[near, 0, 0])[guide.weights[near] > 0.5].min(), 0.95)

    def test_strengths_make_curves_soft(self):
        points, triangles = disk()
        curve = np.stack([np.linspace(-0.5, 0.5, 30), 0.02 + 0 * np.arange(30), 0 * np.arange(30)], -1)
        last = -1.0
        for strength in (0.01, 0.3, 0.9, 1.0):
            guide = df.guide_by_curves(points, triangles, [curve], strengths=[strength], degree=2)
            field = df.field(points, triangles, degree=2, constrain_boundary=True,
                             constrain_guidance=True, vectors=guide.vectors, weights=guide.weights,
                             strengths=guide.strengths)
            along = np.abs(field.directions[:, 0, 0])[guide.weights > 0].mean()
            self.assertGreater(along, last)
            last = along
        self.assertGreater(last, 0.999)
        self.assertIsNone(df.guide_by_curves(points, triangles, [curve]).strengths)
        for wrong in ([2.0], [0.5, 0.5]):
            with self.assertRaisesRegex(ValueError, "strengths"):
                df.guide_by_curves(points, triangles, [curve], strengths=wrong)

    def test_stress_guides_at_points_and_triangles(self):
        points, triangles = disk()
        for at, places in (("points", points), ("triangles", points[triangles].mean(axis=1))):
            # Tension around the middle: the major direction is along circles.
            around = np.cross([0, 0, 1], places)
            around /= np.maximum(np.linalg.norm(around, axis=1), 1e-12)[:, None]
            tensors = np.einsum("ni,nj->nij", around, around).reshape(-1, 9)
            guide = df.guide_by_tensors(points, triangles, tensors, at=at)
            field = df.field(points, triangles, degree=2, constrain_guidance=True,
                             vectors=guide.vectors, weights=guide.weights)
            radius = np.linalg.norm(points, axis=1)
            cosine = np.abs(np.einsum("pc,pc->p", field.directions[:, 0], points)) / np.maximum(radius, 1e-9)
            self.assertLess(cosine[radius > 0.4].max(), 0.1)
        with self.assertRaisesRegex(ValueError, "6 or 9 components"):
            df.guide_by_tensors(points, triangles, np.ones((len(points), 4)))

    def test_fields_follow_tensors_of_points_triangles_and_polygons(self):
        x, y = (k.ravel() for k in np.meshgrid(np.linspace(-1, 1, 41), np.linspace(-1, 1, 41)))
        points = np.stack([x, y, 0 * x], -1)
        corner = np.add.outer(41 * np.arange(40), np.arange(40)).ravel()
        quads = np.stack([corner, corner + 1, corner + 42, corner + 41], -1)
        triangles = np.concatenate([quads[:, :3], quads[:, [0, 2, 3]]])

        def stress(places):
            """q = (z - 0.4) conj(z + 0.4), and a pressure of 0.2: a wedge and a trisector."""
            z = places[:, 0] + 1j * places[:, 1] - 0.01j
            q, zero = (z - 0.4) * (z + 0.4).conj(), 0 * z.real
            return np.stack([q.real - 0.2, -q.real - 0.2, zero, q.imag, zero, zero], -1)

        def full(six):
            return six[:, [0, 3, 5, 3, 1, 4, 5, 4, 2]]

        for cells, at, tensors in (
                (triangles, "points", stress(points)), (triangles, "points", full(stress(points))),
                (triangles, "triangles", stress(points[triangles].mean(axis=1))),
                (quads, "triangles", stress(points[quads].mean(axis=1)))):
            field = df.field(
                points, cells, degree=2, alignment="tensor", tensors=tensors, tensors_at=at)
            self.assertIn(", along tensors: 1 wedge, 1 trisector, ", field.summary)
            places = field.points[field.triangles[field.singularities]].mean(axis=1)[:, 0]
            turns = field.indices[field.singularities]
            self.assertLess(np.abs(places - 0.4 * turns).max(), 0.06)
            q = (x + 1j * y - 0.4) * (x + 1j * y + 0.4).conj()
            far = np.abs(q) > 0.2
            direction = field.directions[:, 0, 0] + 1j * field.directions[:, 0, 1]
            off = np.degrees(np.abs(np.angle(direction**2 / q))[far] / 2)
            self.assertLess(off.max(), 5)
            self.assertLess(np.abs(field.major_values + 0.2 - np.abs(q))[far].max(), 0.15)
            self.assertLess(np.abs(field.minor_values + 0.2 + np.abs(q))[far].max(), 0.15)
            self.assertEqual(field.surface_tensors.shape, (len(points), 6))
            self.assertLess(field.isotropic_share, 0.05)
            across = df.field(points, cells, degree=2, alignment="tensor", tensors=tensors,
                              tensors_at=at, tensor_direction="minor")
            self.assertLess(np.abs(np.einsum("pc,pc->p", across.directions[:, 0],
                                             field.directions[:, 0]))[far].max(), 1e-6)
        smooth = df.field(points, quads, alignment="tensor", tensors=stress(points), tensor_strength=0)
        plain = df.field(points, quads)
        # What the smoothest field leaves open, a rotation of all, is the tensors'.
        self.assertLess(np.ptp(df.compare(smooth, plain).angles), 0.1)


class Fields(unittest.TestCase):
    def test_files_come_back(self):
        points, triangles = torus()
        field = df.field(points, triangles)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "field.rawfield")
            field.write(path, at="points")
            again = df.read(points, triangles, path, at="points")
            self.assertLess(df.compare(field, again).maximum, 1e-4)
            self.assertTrue(np.array_equal(again.indices, field.indices))
            with self.assertRaisesRegex(df.FileError, "ends with"):
                field.write(os.path.join(folder, "field.txt"))
            with self.assertRaises(OSError):
                df.read(points, triangles, os.path.join(folder, "none.rosy"))

    def test_comparison(self):
        points, triangles = torus()
        one, two = df.field(points, triangles), df.field(points, triangles, alignment="curvature")
        turned = df.from_directions(points, triangles, one.directions + 0.1 * np.roll(one.directions, -1, 1))
        difference = df.compare(one, turned)
        self.assertAlmostEqual(difference.mean, np.degrees(np.arctan(0.1)), places=6)
        self.assertLess(df.compare(one, two).maximum, 45.0001)
        with self.assertRaisesRegex(ValueError, "degree"):
            df.compare(one, df.field(points, triangles, degree=2))

    def test_directions_at_triangles_and_derivatives(self):
        points, triangles = torus()
        field = df.field(points, triangles, degree=1)
        rows = field.at_triangles()
        self.assertEqual(rows.shape, (len(triangles), 1, 3))
        normals = np.cross(points[triangles[:, 1]] - points[triangles[:, 0]],
                           points[triangles[:, 2]] - points[triangles[:, 0]])
        self.assertLess(np.abs(np.einsum("tc,tc->t", rows[:, 0], normals)).max(), 1e-12)
        divergence, curl = field.derivatives()
        self.assertEqual(divergence.shape, curl.shape)

    def test_curvature(self):
        curved = df.curvature(*torus())
        self.assertEqual(len(curved.principal_directions), 2)
        self.assertLess(abs(curved.mean_curvature.max() - (1 / 0.4 + 1 / 1.4) / 2), 0.1)

    def test_surfaces_without_manifold_are_split(self):
        points = [[0, 0, 0], [0, 0, 1], [1, 0, 0], [0, 1, 0], [-1, -1, 0]]
        with self.assertWarnsRegex(df.DirectionFieldWarning, "1 edge of more than two triangles"):
            field = df.field(points, [[0, 1, 2], [0, 1, 3], [0, 1, 4]])
        self.assertEqual(len(field.points), len(field.directions))
        self.assertTrue(np.array_equal(field.points, np.array(points)[field.original_points]))
        self.assertEqual(df.streamlines(field).points.shape[1], 3)


class Polygons(unittest.TestCase):
    def test_all_forms_are_the_same(self):
        points = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 0, 0.5], [2, 1, 0.4]]
        rows = [[0, 1, 2, 3, -1], [1, 4, 2, -1, -1], [4, 5, 2, -1, -1]]
        fields = [df.field(points, form) for form in (
            rows, [4, 0, 1, 2, 3, 3, 1, 4, 2, 3, 4, 5, 2],
            (np.array([0, 4, 7, 10]), [0, 1, 2, 3, 1, 4, 2, 4, 5, 2]))]
        self.assertEqual(fields[0].polygons.tolist(), [0, 0, 1, 2])
        self.assertEqual(len({field.directions.tobytes() for field in fields}), 1)

    def test_wrong_forms_are_refused(self):
        points = np.eye(3)
        for form, text in (
                ([3, 0, 1], "sizes"), ([-1, 0, 1], "sizes"), (([0, 2], [0, 1, 2]), "offsets"),
                (([0, 3, 1, 3], [0, 1, 2]), "offsets"), ([[0, 1, 2, 7]], "0 to 2"), ([], "empty")):
            with self.assertRaisesRegex(ValueError, text):
                df.field(points, np.array(form, int) if isinstance(form, list) else form)


if __name__ == "__main__":
    unittest.main()
