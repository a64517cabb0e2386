# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tests of direction_fields.field: mathematics, options, memory, errors, and stopping."""

import ast
import doctest
import glob
import inspect
import os
import signal
import subprocess
import sys
import threading
import time
import unittest
import warnings

import numpy as np

import direction_fields as df
from surfaces import OCTAHEDRON, torus


class Mathematics(unittest.TestCase):
    def test_indices_sum_to_the_euler_characteristic(self):
        for degree in (1, 2, 4, 6):
            self.assertEqual(df.field(*OCTAHEDRON, degree=degree).indices.sum(), 2 * degree)
            self.assertEqual(df.field(*torus(), degree=degree).indices.sum(), 0)

    def test_directions_are_tangent_units_evenly_apart(self):
        field = df.field(*torus(), degree=4)
        directions = field.directions
        self.assertTrue(np.allclose(np.linalg.norm(directions, axis=-1), 1))
        self.assertLess(np.abs(np.einsum("pkc,pc->pk", directions, field.normals)).max(), 1e-12)
        turned = np.cross(field.normals[:, None], directions)
        self.assertTrue(np.allclose(turned, np.roll(directions, -1, axis=1)))

    def test_curvature_alignment_follows_the_circles_of_a_torus(self):
        points, triangles = torus()
        field = df.field(points, triangles, alignment="curvature", alignment_strength=1)
        around = np.cross([0, 0, 1], points)
        around /= np.linalg.norm(around, axis=1)[:, None]
        cosine = np.abs(np.einsum("pkc,pc->pk", field.directions, around)).max(axis=1)
        self.assertGreater(cosine.min(), np.cos(np.radians(3)))
        # cos v / (0.4 (1 + 0.4 cos v))
        cosine = (np.hypot(points[:, 0], points[:, 1]) - 1) / 0.4
        self.assertLess(
            np.abs(field.gaussian_curvature - cosine / (0.4 + 0.16 * cosine)).max(), 0.3)
        self.assertFalse(hasattr(df.field(points, triangles), "mean_curvature"))

    def test_unit_length_makes_all_representations_units(self):
        points, triangles = torus()
        first = np.abs(df.field(points, triangles, degree=1).representation)
        unit = np.abs(df.field(points, triangles, degree=1, unit_length=True).representation)
        self.assertGreater(np.ptp(first), 0.01)
        self.assertTrue(np.allclose(unit, 1))

    def test_guidance_itself_comes_back(self):
        points, triangles = torus()
        given = np.cross([0, 0, 1], points)
        field = df.field(
            points, triangles, degree=1, alignment="vectors", alignment_strength=1, vectors=given)
        given /= np.linalg.norm(given, axis=1)[:, None]
        self.assertGreater(np.einsum("pc,pc->p", field.directions[:, 0], given).min(), 0.999)


class Arrays(unittest.TestCase):
    def test_layout_and_type_change_no_byte(self):
        points, triangles = torus()
        points = points.astype(np.float32)
        expected = df.field(points.astype(float), triangles).directions.tobytes()
        strided = np.zeros((len(points), 6), np.float32)[:, ::2]
        strided[:] = points
        readonly = points.copy()
        readonly.flags.writeable = False
        for same in (points, strided, readonly, np.asfortranarray(points), points.tolist()):
            self.assertEqual(df.field(same, triangles).directions.tobytes(), expected)
        for kind in (np.int32, np.uint64, np.uint16):
            field = df.field(points, triangles.astype(kind))
            self.assertEqual(field.directions.tobytes(), expected)

    def test_results_outlive_the_field_and_can_be_written(self):
        directions = df.field(*OCTAHEDRON).directions
        again = df.field(*OCTAHEDRON).directions
        directions[0] = 7
        self.assertNotEqual(again[0, 0, 0], 7)

    def test_a_thousand_calls_do_not_grow(self):
        def resident():
            with open("/proc/self/statm", encoding="ascii") as numbers:
                return int(numbers.read().split()[1]) * os.sysconf("SC_PAGESIZE")

        if not os.path.exists("/proc/self/statm"):
            self.skipTest("This system does not tell the memory of a process.")
        points, triangles = torus(8, 16)
        for _ in range(100):
            df.field(points, triangles)
        before = resident()
        for _ in range(1000):
            df.field(points, triangles)
        # The arrays of one call are about 40 kB: those of a thousand would be 40 MB.
        self.assertLess(resident() - before, 8e6)

    def test_threads_at_once_get_the_same(self):
        points, triangles = torus()
        expected = df.field(points, triangles).directions.tobytes()
        results = []
        threads = [
            threading.Thread(
                target=lambda: results.append(df.field(points, triangles).directions.tobytes()))
            for _ in range(4)
        ]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(results, [expected] * 4)


class Errors(unittest.TestCase):
    def refused(self, error, text, *arrays, **options):
        points, triangles = arrays or OCTAHEDRON
        with self.assertRaisesRegex(error, text):
            df.field(points, triangles, **options)

    def test_arrays(self):
        points, triangles = OCTAHEDRON
        broken = points.copy()
        broken[3, 1] = np.nan
        self.refused(df.MeshError, "3", broken, triangles)
        self.refused(df.MeshError, "(?s)point.*1e\\+?300", 1.1e300 * points, triangles)
        df.field(1e299 * points, triangles)
        self.refused(ValueError, r"\(n, 3\)", points[:, :2], triangles)
        self.refused(ValueError, r"\(n, 3\)", points, triangles[:, :2])
        self.refused(ValueError, "empty", points, triangles[:0])
        self.refused(ValueError, "0 to 5; they are -1 to 4", points, triangles - 1)
        self.refused(ValueError, "0 to 5", points, triangles + 2**32)
        self.refused(TypeError, "integers", points, triangles.astype(float))
        self.refused(TypeError, "complex128", points.astype(complex), triangles)
        self.refused(ValueError, r"vectors must be of the shape \(6, 3\)", vectors=points[:3])
        self.refused(ValueError, r"weights must be of the shape \(6\)", weights=np.ones(5))

    def test_options(self):
        self.refused(ValueError, "^degree must be 1 to 16", degree=0)
        self.refused(ValueError, "^energy_bias must be", energy_bias=2)
        self.refused(ValueError, "constrain_curvature out", constrain_curvature=True, degree=3)
        self.refused(TypeError, "'degre'", degre=4)
        self.refused(TypeError, "whole number", degree=2.5)
        self.refused(TypeError, "True or False", unit_length=1)
        self.refused(TypeError, "not a bool", degree=True)
        self.refused(ValueError, "'none', 'curvature', 'vectors'", alignment="shape")
        self.refused(ValueError, "2 or 4", alignment="curvature", degree=3)
        self.refused(ValueError, "alignment='vectors'", alignment="vectors")
        self.refused(ValueError, "Give tensors", alignment="tensor")
        tensors = np.ones((len(OCTAHEDRON[0]), 6))
        self.refused(ValueError, "Set alignment='tensor'", tensors=tensors)
        for error, options in (
                ("degree to 2 or 4", {"degree": 3}), ("6 or 9 components", {"tensors": tensors[:, :4]}),
                ("one tensor for each point", {"tensors": tensors[1:]}),
                ("that of point [0-5] is not", {"tensors": tensors * np.nan}),
                ("tensor_strength must be 0 to 1", {"tensor_strength": 2.0}),
                ("averaged over must be 0 to 32", {"tensor_scale": 33.0})):
            self.refused(ValueError, error, **{"alignment": "tensor", "tensors": tensors, **options})
        self.refused(TypeError, "progress", progress=3)

    def test_every_option_takes_its_default_and_refuses_beyond_its_range(self):
        described = df.options()
        defaults = {keyword: entry[0] for keyword, entry in described.items()}
        self.assertEqual(
            df.field(*OCTAHEDRON, **defaults).directions.tobytes(),
            df.field(*OCTAHEDRON).directions.tobytes())
        for keyword, entry in described.items():
            if len(entry) == 4:
                self.refused(ValueError, "must be", **{keyword: type(entry[0])(entry[1] - 1)})

    def test_notes_are_warnings(self):
        with self.assertWarns(df.DirectionFieldWarning) as caught:
            field = df.field(*OCTAHEDRON, constrain_boundary=True)
        self.assertEqual(str(caught.warning), field.warnings[0])
        self.assertEqual(caught.filename, __file__)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            df.field(*torus())

    def test_callers_need_no_name(self):
        # Doctests and exec run with any globals.
        found = {"df": df, "mesh": OCTAHEDRON}
        exec("field = df.field(*mesh)", found)
        self.assertEqual(found["field"].indices.sum(), 8)

    def test_mended_meshes_are_warnings(self):
        points, triangles = OCTAHEDRON
        turned = triangles.copy()
        turned[0] = turned[0, ::-1]
        with self.assertWarnsRegex(df.DirectionFieldWarning, "1 triangle wound against"):
            df.field(points, turned)

    def test_warnings_name_keywords(self):
        points, triangles = torus()
        noise = np.random.default_rng(1).normal(size=points.shape)
        with self.assertWarnsRegex(df.DirectionFieldWarning, "raise maximum_iterations|Raise maximum_iterations"):
            df.field(points + 0.05 * noise, triangles, maximum_iterations=1, tolerance=1e-12,
                     solver="multigrid")


class Stopping(unittest.TestCase):
    def test_progress_grows_and_its_exception_comes_back(self):
        told = []
        df.field(*torus(100, 200), progress=told.append)
        self.assertEqual(told, sorted(told))
        self.assertGreater(told[-1], 0.5)

        def stop(fraction):
            raise RuntimeError(f"enough at {fraction}")

        with self.assertRaisesRegex(RuntimeError, "enough"):
            df.field(*torus(), progress=stop)

    def test_an_exception_of_progress_is_not_touched(self):
        class Enough(ValueError):
            def __init__(self, first, second):
                super().__init__("Degree", first, second)

        def stop(fraction):
            raise Enough(1, 2)

        with self.assertRaises(Enough) as raised:
            df.field(*torus(), progress=stop)
        self.assertEqual(raised.exception.args, ("Degree", 1, 2))

    def test_interrupt_stops(self):
        with self.assertRaises(KeyboardInterrupt):
            df.field(*torus(), progress=lambda done: os.kill(os.getpid(), signal.SIGINT))

    def test_interrupt_comes_back_soon_and_nothing_is_lost(self):
        points, triangles = torus(200, 400)
        before = points.copy()
        for delay in (0.05, 0.2):
            sent = []

            def interrupt():
                sent.append(time.monotonic())
                os.kill(os.getpid(), signal.SIGINT)

            timer = threading.Timer(delay, interrupt)
            timer.start()
            with self.assertRaises(KeyboardInterrupt):
                df.field(points, triangles)
            self.assertLess(time.monotonic() - sent[0], 0.5)
        self.assertTrue(np.array_equal(points, before))
        self.assertEqual(df.field(*OCTAHEDRON).indices.sum(), 8)

    def test_a_program_may_end_while_it_computes(self):
        subprocess.run(
            [sys.executable, "-c", "import direction_fields as df, surfaces, threading, time\n"
             "mesh = surfaces.torus(150, 300)\n"
             "threading.Thread(target=lambda: df.field(*mesh), daemon=True).start()\n"
             "time.sleep(0.05)"],
            check=True, cwd=os.path.dirname(os.path.abspath(__file__)), stderr=subprocess.DEVNULL)

    def test_other_threads_go_on(self):
        turns = []
        done = threading.Event()

        def count():
            while not done.is_set():
                turns.append(None)
                done.wait(0.001)

        thread = threading.Thread(target=count)
        thread.start()
        before = len(turns)
        df.field(*torus(200, 400))
        after = len(turns)
        done.set()
        thread.join()
        self.assertGreater(after - before, 10)

    def test_import_brings_neither_vtk_nor_pyvista(self):
        subprocess.run(
            [sys.executable, "-c", "import direction_fields, sys\n"
             "assert not [name for name in sys.modules if name.startswith(('vtk', 'pyvista'))]"],
            check=True)

    def test_import_takes_little_time_beside_numpy(self):
        times = [float(subprocess.run(
            [sys.executable, "-c", "import time, numpy\nbegin = time.perf_counter()\n"
             "import direction_fields\nprint(time.perf_counter() - begin)"],
            check=True, capture_output=True, text=True).stdout) for _ in range(3)]
        self.assertLess(min(times), 0.2)


class Documentation(unittest.TestCase):
    def test_examples(self):
        page = os.environ["DIRECTIONFIELDS_NUMPY_PAGE"]
        os.chdir(os.path.join(os.path.dirname(page), ".."))
        pages = [page, *glob.glob(os.path.join(os.path.dirname(page), "NumPy", "*.md"))]
        self.assertEqual(len(pages), 3)
        tested = [doctest.testfile(page, module_relative=False) for page in pages]
        of_results = doctest.testmod(df._results, extraglobs={"field": df.field})
        for results in (doctest.testmod(df), of_results, *tested):
            self.assertGreater(results.attempted, 1)
            self.assertEqual(results.failed, 0)

    def test_help_and_stubs_have_every_option(self):
        with open(os.path.join(os.path.dirname(df.__file__), "__init__.pyi"), encoding="utf-8") as stub:
            tree = ast.parse(stub.read())
        stubs = {node.name: {a.arg for a in node.args.kwonlyargs} for node in ast.walk(tree)
                 if isinstance(node, ast.FunctionDef)}
        for name in ("field", "edit", "remesh", "streamlines", "stripes", "guide_by_curves",
                     "guide_by_tensors", "read", "write"):
            function = getattr(df.Field if name in ("edit", "write") else df, name)
            for keyword in df.options(name):
                self.assertIn(f"\n{keyword} : ", function.__doc__)
                self.assertIn(keyword, stubs[name])
                self.assertIn(keyword, inspect.signature(function).parameters)
            self.assertNotIn("**options", function.__doc__)
        for name in df.__all__:
            self.assertTrue(getattr(df, name).__doc__, name)


if __name__ == "__main__":
    unittest.main()
