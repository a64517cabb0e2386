# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Looks for meshes that take much longer than their size explains, and writes a table of them.

    python3 cliffs.py MEASUREFIELD DIRECTORY [options]

MEASUREFIELD is the program built from MeasureField.cxx. Each row is a mesh of CliffMeshes.h with its
properties, by the solver Automatic and by Direct, in processes of their own; its time is compared with that
of an even mesh of as many triangles, by Automatic, and with that of Direct. Times are those of the processors
without the system's, the least of all rounds. Into the directory go cliffs.json and cliffs.md.
"""

import argparse
import json
import os
import subprocess
import sys

REQUIRED_OVER_EVEN = 5.0
REQUIRED_OVER_DIRECT = 2.0
# Seconds that Automatic may take besides.
NEGLIGIBLE = 0.1
TOLERANCE = 1e-6
DIRECT = "Solver=2"
NOISES = (0.3, 1, 3, 10)
# For the rows without a size of their own.
TRIANGLES = 97000
POLYGONS = (3500, 6000)


def rows(triangles, polygons):
    """(task, mesh, properties, triangles)"""
    found = []

    def add(mesh, *properties, task="field", size=triangles):
        found.append((task, mesh.replace("N", str(size)), properties, size))

    for name in ("noisy", "terrain", "noisytorus"):
        for noise in NOISES:
            add(f"{name}:N:{noise}")
    for task in ("strength", "constraints"):
        add("noisy:N:1", task=task)
    for degree in (4, 6, 16):
        add("gyroid:N:2", f"Degree={degree}")
    for degree in (1, 2, 4, 6, 8, 16):
        add("sphere:N", f"Degree={degree}")
    for bias in (-1, 1):
        add("flat:N", f"EnergyBias={bias}")
    for bias in (-0.9, 0.9):
        add("N", "Degree=6", f"EnergyBias={bias}")
    add("blobs:N:512")
    for corners in polygons:
        add("polygon:N", size=corners)
    return found


class Runs:
    def __init__(self, program):
        self.program = program
        self.results = {}

    def run(self, task, mesh, *properties):
        command = [self.program, task, mesh, *properties]
        print(" ".join(command[1:]), flush=True)
        done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True)
        figures = json.loads(done.stdout.splitlines()[-1])
        known = self.results.setdefault(" ".join(command[1:]), figures)
        for name in figures:
            if name.endswith("seconds"):
                known[name] = min(known[name], figures[name])
        return known

    def get(self, *key):
        return self.results[" ".join(key)]


def seconds(task, figures):
    name = {"strength": "first_seconds", "constraints": "seconds"}.get(
        task, "program_processor_seconds")
    # The system may count a very short run as none.
    return max(figures[name], 1e-6)


def report(runs, cases):
    lines = [
        "| mesh | properties | s | over an even mesh | Direct s | over Direct | cycles or solves |"
        " residual | holds |", "|---|---|---|---|---|---|---|---|---|"]
    for task, mesh, properties, size in cases:
        ours = runs.get(task, mesh, *properties)
        direct = runs.get(task, mesh, *properties, DIRECT)
        time = seconds(task, ours)
        other = seconds(task, direct)
        # Blocks and balls have other numbers of triangles than those asked for.
        count = size if mesh.startswith("polygon") else ours["triangles"]
        even = seconds(task, runs.get(task, str(size))) * count / size
        holds = [time <= REQUIRED_OVER_EVEN * even + NEGLIGIBLE,
                 time <= REQUIRED_OVER_DIRECT * other + NEGLIGIBLE]
        lines.append("| " + " | ".join([
            mesh + ("" if task == "field" else f", {task}"), ", ".join(properties), f"{time:.3g}",
            f"{time / even:.1f}", f"{other:.3g}", f"{time / other:.2f}",
            f"{ours['iterations']:.0f}", f"{ours['residual']:.0e}",
            ", ".join("yes" if h else "**no**" for h in holds)]) + " |")
    return "\n".join([
        "# Cliffs\n",
        "Seconds of the processors, but for aligned (strength) and constrained fields. Required: at "
        f"most {REQUIRED_OVER_EVEN:g} times an even mesh of as many triangles, and at most "
        f"{REQUIRED_OVER_DIRECT:g} times the solver Direct, {NEGLIGIBLE:g} s besides.\n",
        *lines, ""])


def check(runs):
    """What must hold on any machine, whatever the times."""
    for name, figures in runs.results.items():
        assert figures["residual"] <= TOLERANCE, (name, figures)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("program")
    parser.add_argument("directory")
    parser.add_argument("--triangles", type=int, default=TRIANGLES)
    parser.add_argument("--polygons", default=",".join(map(str, POLYGONS)),
                        help="corners of the single polygons, with commas between")
    parser.add_argument("--rounds", type=int, default=1)
    arguments = parser.parse_args()
    cases = rows(arguments.triangles, [int(p) for p in arguments.polygons.split(",") if p])
    runs = Runs(arguments.program)
    os.makedirs(arguments.directory, exist_ok=True)
    for _ in range(arguments.rounds):
        for task, size in sorted({(case[0], case[3]) for case in cases}):
            runs.run(task, str(size))
        for task, mesh, properties, _ in cases:
            runs.run(task, mesh, *properties)
            runs.run(task, mesh, *properties, DIRECT)
    text = report(runs, cases)
    with open(os.path.join(arguments.directory, "cliffs.json"), "w", encoding="utf-8") as file:
        json.dump(runs.results, file, indent=1)
    with open(os.path.join(arguments.directory, "cliffs.md"), "w", encoding="utf-8") as file:
        file.write(text)
    print(text)
    check(runs)


if __name__ == "__main__":
    sys.exit(main())
