# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Measures the filter beside the algorithm of C. Clemenz' thesis, in turns, and writes a report.

    pvpython measure.py MEASUREFIELD DIRECTORY [options]

MEASUREFIELD is the program built from MeasureField.cxx. Each figure is measured in a process of its
own and is the least of all rounds; the baseline takes its turn after the filter in each round. Into
the directory go results.json, report.md and the chart times.png (counterparts of the thesis' table
4.1 and figure 4.6). The report says of each figure what it is required to be.
"""

import argparse
import json
import math
import os
import subprocess
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

SIZES = (10000, 100000, 400000, 1600000, 6400000)
# How many times faster than the baseline, from each number of triangles on.
REQUIRED_RATIO = {100000: 10, 400000: 20, 1600000: 50}
# Meshes of slivers, as they are given.
SLIVER_PART = 0.5
REQUIRED_EXPONENT = 1.15
REQUIRED_GROWTH = 5.0  # of the time from 1.6 to 6.4 million triangles
REQUIRED_BYTES = 5e9
REQUIRED_BYTES_PER_TRIANGLE = 700
REQUIRED_CHANGE = 0.1  # another strength of the alignment, in parts of the first aligned field
REQUIRED_CONSTRAINED = 1.0  # times the first smoothest field, at 400 000 triangles
SMALL = 5000  # no slower than with the direct solver:
DIRECT = "Solver=2"
TOLERANCE = 1e-6
DEGREE = 4
# Numbers of triangles beyond which the baseline does not fit, and beyond which it is run once.
LARGEST_BASELINE = 2500000
REPEATED_BASELINE = 500000
# A product of A with a vector in single precision: an entry and its column; a row's begin, the
# vector's value and the product's.
BYTES_PER_ENTRY = 12
BYTES_PER_ROW = 20


class Runs:
    """What has been measured: for each task, mesh and properties the least of each time."""

    def __init__(self, program):
        self.program = program
        self.results = {}

    def run(self, task, mesh, *properties):
        """The figures; None where the filter has no such property."""
        command = [self.program, task, str(mesh), *properties]
        print(" ".join(command[1:]), flush=True)
        done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=False)
        if done.returncode == 2:
            return None
        done.check_returncode()
        figures = json.loads(done.stdout.splitlines()[-1])
        key = " ".join(command[1:])
        known = self.results.setdefault(key, figures)
        for name, value in figures.items():
            if name.endswith("seconds"):
                known[name] = min(known[name], value)
            elif name.startswith("bytes_per_second"):
                known[name] = max(known[name], value)
        return known

    def get(self, task, mesh, *properties):
        return self.results.get(" ".join([task, str(mesh), *properties]))


def required_ratio(triangles, part=1.0):
    found = [ratio for size, ratio in REQUIRED_RATIO.items() if triangles >= 0.95 * size]
    return part * max(found) if found else None


def verdict(value, limit, at_most=True):
    if limit is None:
        return ""
    return "yes" if (value <= limit if at_most else value >= limit) else "**no**"


def number(value, digits=3):
    if value is None:
        return "–"
    return f"{value:.{digits}g}" if value < 10 ** digits else f"{value:.0f}"


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    lines += ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]
    return "\n".join(lines) + "\n"


class Report:
    def __init__(self, runs, cases):
        self.runs = runs
        # (mesh, properties, part of the required ratio)
        self.cases = cases
        self.bandwidth = runs.get("bandwidth", "-")["bytes_per_second"]

    def field(self, case):
        return self.runs.get("field", case[0], *case[1])

    @staticmethod
    def name(case):
        mesh = os.path.basename(str(case[0])) if not str(case[0]).isdigit() else "generated"
        return mesh + "".join(f", {p}" for p in case[1])

    def passes(self, case):
        """How many products of the matrix with a vector the time of a field equals."""
        stages = self.runs.get("stages", case[0])
        moved = BYTES_PER_ENTRY * stages["entries"] + BYTES_PER_ROW * stages["rows"]
        return self.field(case)["seconds"] * self.bandwidth / moved

    def comparison(self):
        rows = []
        for case in self.cases:
            ours = self.field(case)
            base = self.runs.get("baseline", case[0])
            ratio = base["seconds"] / ours["seconds"] if base else None
            limit = required_ratio(ours["triangles"], case[2]) if base else None
            rows.append([
                self.name(case), f"{ours['triangles']:.0f}", number(ours["seconds"]),
                number(base and base["seconds"]), number(ratio),
                f"≥ {limit:g}" if limit else "–", verdict(ratio, limit, at_most=False),
                f"{ours['residual']:.1e}", f"{base['residual']:.1e}" if base else "–",
                f"{ours['peak_bytes'] / ours['triangles']:.0f}", f"{self.passes(case):.0f}"])
        return table(["mesh", "triangles", "ours s", "baseline s", "ratio", "required", "holds",
                      "residual ours", "residual baseline", "peak bytes/triangle",
                      "passes over A"], rows)

    def generated(self):
        """Sizes and figures of the generated meshes, by size."""
        return [(int(case[0]), self.field(case)) for case in self.cases if str(case[0]).isdigit()]

    def figures(self):
        rows = []

        def add(what, value, limit, unit=""):
            rows.append([what, number(value) + unit, f"≤ {limit:g}{unit}", verdict(value, limit)])

        sizes = self.generated()
        large = [(f["triangles"], f["seconds"]) for size, f in sizes if size >= 100000]
        if len(large) > 1:
            (n0, t0), (n1, t1) = large[0], large[-1]
            add(f"growth exponent, {n0:.0f} to {n1:.0f} triangles",
                math.log(t1 / t0) / math.log(n1 / n0), REQUIRED_EXPONENT)
        by_size = dict(sizes)
        if 1600000 in by_size and 6400000 in by_size:
            # Beyond four million triangles the C library keeps no memory from run to run, and the
            # system, or the host of a virtual machine, clears it anew.
            for runs, key in (("time, first runs", "first_seconds"), ("time, best runs", "seconds"),
                              ("processors' time without the system's",
                               "program_processor_seconds")):
                add(f"6.4 over 1.6 million triangles: {runs}",
                    by_size[6400000][key] / by_size[1600000][key], REQUIRED_GROWTH)
        last = sizes[-1][1]
        add(f"peak memory at {last['triangles']:.0f} triangles", last["peak_bytes"] / 1e9,
            REQUIRED_BYTES / 1e9, " GB")
        # What the program itself takes weighs on small meshes.
        if last["triangles"] >= 100000:
            add("the same by the triangle", last["peak_bytes"] / last["triangles"],
                REQUIRED_BYTES_PER_TRIANGLE, " bytes")
        for case in self.cases:
            strength = self.runs.get("strength", *case[:1])
            if strength and not case[1]:
                for move, key in ("first", "first_move_seconds"), ("sixth", "seconds"):
                    add(f"{move} move of the strength over the first aligned field, "
                        f"{self.name(case)}, {strength['triangles']:.0f} triangles",
                        strength[key] / strength["first_seconds"], REQUIRED_CHANGE)
        for case in self.cases:
            both = self.runs.get("constraints", *case[:1])
            if both and not case[1]:
                add(f"other constraints over the smoothest field, {self.name(case)}, "
                    f"{both['triangles']:.0f} triangles",
                    both["seconds"] / both["smoothest_seconds"], REQUIRED_CONSTRAINED)
        automatic = self.runs.get("field", SMALL)
        direct = self.runs.get("field", SMALL, DIRECT)
        if automatic and direct:
            add(f"automatic over direct solver, {automatic['triangles']:.0f} triangles",
                automatic["seconds"] / direct["seconds"], 1.0)
        return table(["figure", "measured", "required", "holds"], rows)

    def stages(self):
        rows = []
        for case in self.cases:
            stages = self.runs.get("stages", case[0])
            if case[1]:
                continue
            whole = self.field(case)["seconds"]
            rest = whole - stages["setup_seconds"] - stages["smoothest_seconds"]
            rows.append([self.name(case), f"{stages['triangles']:.0f}", number(1e3 * whole)] + [
                number(1e3 * stages[name + "_seconds"])
                for name in ("setup", "flip", "assembly")] + [
                    number(1e3 * (stages["smoothest_seconds"] - stages["assembly_seconds"])),
                    number(1e3 * max(0.0, rest))] + [
                        number(1e3 * self.field(case)[name + "_processor_seconds"])
                        for name in ("program", "system")])
        return table(["mesh", "triangles", "whole ms", "setup", "(flips)", "assembly",
                      "eigenvalue problem and results", "conversion and arrays",
                      "processors' time: program", "system"], rows)

    def meshes(self):
        """The counterpart of the thesis' table 4.1."""
        rows = []
        for case in self.cases:
            field = self.field(case)
            stages = self.runs.get("stages", case[0])
            rows.append([
                self.name(case), f"{field['triangles']:.0f}", f"{field['vertices']:.0f}",
                f"{field['euler']:.0f}", number(stages["setup_seconds"]),
                number(field["seconds"] - stages["setup_seconds"]), number(field["seconds"]),
                f"{field['singularities']:.0f}", f"{field['index_sum']:.0f}",
                f"{field['lambda']:.6g}", f"{field['residual']:.1e}", f"{field['iterations']:.0f}"])
        return table(["mesh", "triangles", "vertices", "χ", "setup s", "solve s", "whole s",
                      "singularities", "index sum", "λ₁", "residual", "iterations"], rows)

    def text(self):
        one = self.runs.get("bandwidth", "-")["bytes_per_second_one_thread"]
        return "\n".join([
            "# Time and memory of the smoothest cross field\n",
            "The whole filter, conversion and output arrays included, beside the thesis' algorithm "
            "(Eigen's LDLᵀ, 30 inverse iterations, same matrices). A pass over A is its product "
            "with a vector in single precision at the memory's bandwidth, "
            f"{self.bandwidth / 1e9:.1f} GB/s ({one / 1e9:.1f} with one thread).\n",
            self.comparison(), self.figures(), "## Where the time goes\n", self.stages(),
            "## Meshes\n", self.meshes()])

    def draw(self, path):
        import logLogChart

        ours = [f for _, f in self.generated()]
        base = [b for size, _ in self.generated() if (b := self.runs.get("baseline", size))]
        curves = []
        for label, color, figures in (("this filter", (0, 107, 117), ours),
                                      ("thesis' algorithm", (214, 120, 20), base)):
            if figures:
                curves.append((label, color, [f["triangles"] for f in figures],
                               [f["seconds"] for f in figures]))
        missing = logLogChart.draw(path, curves, ("triangles", "seconds"))
        if missing:
            sys.exit(f"The curve of {missing[0]} is not in the picture.")


def check(runs, cases):
    """What must hold on any machine, whatever the times."""
    for mesh, properties, _ in cases:
        ours = runs.get("field", mesh, *properties)
        stages = runs.get("stages", mesh)
        assert ours["residual"] <= TOLERANCE, ours
        assert ours["index_sum"] == DEGREE * ours["euler"] or not str(mesh).isdigit(), ours
        assert 0 < ours["seconds"] <= ours["first_seconds"], ours
        assert 0 < ours["peak_bytes_before"] <= ours["peak_bytes"], ours
        assert all(stages[name] > 0 for name in stages if name.endswith("seconds")), stages
        base = runs.get("baseline", mesh)
        if base:
            # An eigenvalue from above, not quite converged.
            assert base["triangles"] == ours["triangles"], (base, ours)
            if not properties:
                assert -1e-6 < base["lambda"] / ours["lambda"] - 1 < 0.2, (base, ours)
            assert 0 < base["setup_seconds"] < base["seconds"], base


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("program")
    parser.add_argument("directory")
    parser.add_argument("--sizes", default=",".join(map(str, SIZES)),
                        help="triangles of the generated meshes, with commas between")
    parser.add_argument("--mesh", action="append", default=[], help="a .ply, .obj or .stl file")
    parser.add_argument("--levels", type=int, default=0,
                        help="how often each file is subdivided at the midpoints of its edges")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--no-picture", action="store_true",
                        help="no chart: needs neither VTK nor a display")
    arguments = parser.parse_args()

    runs = Runs(arguments.program)
    cases = [(int(size), (), 1.0) for size in arguments.sizes.split(",") if size]
    for mesh in arguments.mesh:
        for level in range(arguments.levels + 1):
            path = f"{mesh}@{level}" if level else mesh
            cases.append((path, (), SLIVER_PART))
            cases.append((path, ("IntrinsicDelaunay=1",), 1.0))
    os.makedirs(arguments.directory, exist_ok=True)
    for turn in range(arguments.rounds):
        runs.run("bandwidth", "-")
        for mesh, properties, _ in cases:
            triangles = runs.run("field", mesh, *properties)["triangles"]
            # What the properties change is the field only.
            if not properties:
                limit = LARGEST_BASELINE if turn == 0 else REPEATED_BASELINE
                if triangles <= limit:
                    runs.run("baseline", mesh)
                runs.run("stages", mesh)
                runs.run("strength", mesh)
                if 100000 < triangles < 1000000 or len(cases) == 1:
                    runs.run("constraints", mesh)
        runs.run("field", SMALL)
        runs.run("field", SMALL, DIRECT)
    check(runs, cases)
    with open(os.path.join(arguments.directory, "results.json"), "w", encoding="utf-8") as file:
        json.dump(runs.results, file, indent=1)
    report = Report(runs, cases)
    text = report.text()
    with open(os.path.join(arguments.directory, "report.md"), "w", encoding="utf-8") as file:
        file.write(text)
    print(text)
    if not arguments.no_picture:
        report.draw(os.path.join(arguments.directory, "times.png"))


if __name__ == "__main__":
    main()
