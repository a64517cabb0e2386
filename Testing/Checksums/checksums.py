#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shows that a change leaves the results of all filters as they were, to the byte.

    checksums.py --package BUILD/lib/python3/dist-packages [--meshes DIR]... [--processes 2] OUTPUT.txt
    checksums.py --compare OLD.txt NEW.txt

The first form runs every filter of the package directionfields_vtk with many options on surfaces of all kinds
(meshes.py, cases.py): closed, open, one-sided, noisy, of polygons and strips, not manifold, large enough for
multigrid; on those in Data/Meshes, and on the files of the directories that --meshes names. It is run before the
change and after it, on builds of the same compiler and flags. The second form lists the cases that differ, with the
arrays in which they do, and then exits with 1.

OUTPUT.txt has a line for each case, with fields that tabs separate: mesh, filter, options, and for each array of all
outputs `PORT.KIND.NAME=DIGEST`, the first 16 digits of a SHA-256 over its type, components and bytes. Texts
(summaries, warnings, messages) stand there themselves, files by the digest of their bytes, new filters by their
properties. No output has times or figures of memory in it; messages have the places in the sources and the addresses
taken out. The first line, which begins with #, says which versions of VTK, Python and NumPy it was made with:
results of others need not be the same.

--processes 2 adds surfaces in pieces, under mpiexec and pvbatch (pieces.py). VTK's own Python package has to be
found; where it is not Debian's, PYTHONPATH names it. On one processor it takes two to three minutes.
"""

import argparse
import collections
import importlib
import pathlib
import platform
import re
import sys
import time

MESHES = pathlib.Path(__file__).resolve().parents[2] / "Data" / "Meshes"
# A case is named by the first fields of its line.
NAMING_FIELDS = 3


def head():
    import numpy
    from vtkmodules.vtkCommonCore import vtkVersion
    return f"# VTK {vtkVersion.GetVTKVersion()}, Python {platform.python_version()}, NumPy {numpy.__version__}"


def make(package, directories, only, processes, output):
    """Writes the checksums of a package's filters."""
    package = str(pathlib.Path(package).resolve())
    sys.path.insert(0, package)
    filters = importlib.import_module("directionfields_vtk")
    import cases
    import digests
    import meshes
    import pieces
    seen = set()
    begin = time.monotonic()
    # Line by line, so that the last case is there if a filter crashes in the next one.
    with open(output, "w", buffering=1, encoding="utf-8") as file:
        def write(*case):
            if case[:NAMING_FIELDS] in seen:
                raise RuntimeError(f"Two cases have the name {case[:NAMING_FIELDS]}.")
            seen.add(case[:NAMING_FIELDS])
            file.write(digests.line_of(*case))

        print(head(), file=file)
        for name in sorted(filters.__all__):
            write("-", name, "new", digests.describe_settings(getattr(filters, name)()))
        for mesh, extent, surface in meshes.surfaces([MESHES, *directories]):
            if re.search(only, mesh):
                write(mesh, "-", "input", digests.describe_data(surface, "0"))
                cases.Cases(filters, lambda *case, mesh=mesh: write(mesh, *case), surface, extent)
                print(f"{time.monotonic() - begin:6.1f} s {len(seen):5} cases, {mesh}", file=sys.stderr)
        if processes:
            file.writelines(pieces.start(processes, package))
    print(f"{output}: {time.monotonic() - begin:.1f} s", file=sys.stderr)


def read(path):
    """The head of a file of checksums, and the items of each case by its name."""
    lines = pathlib.Path(path).read_text(encoding="utf-8").splitlines()
    cases = {}
    for line in lines:
        if not line.startswith("#"):
            fields = line.split("\t")
            cases[tuple(fields[:NAMING_FIELDS])] = dict(item.split("=", 1) for item in fields[NAMING_FIELDS:])
    return [line for line in lines if line.startswith("#")], cases


def differences(old, new):
    """What differs between the items of a case, one text each."""
    for item in sorted(old.keys() | new.keys()):
        if old.get(item) != new.get(item):
            yield f"{item}: {old.get(item, 'nothing')} -> {new.get(item, 'nothing')}"


def compare(old_path, new_path):
    """Prints the cases that differ, and how many of each filter; returns their number."""
    (old_head, old), (new_head, new) = read(old_path), read(new_path)
    if old_head != new_head:
        print("\n".join(["The versions differ:", *old_head, *new_head]))
    changed = collections.Counter()
    for case in [*old, *(case for case in new if case not in old)]:
        if case not in new or case not in old:
            texts = ["is in the old file only" if case in old else "is in the new file only"]
        else:
            texts = list(differences(old[case], new[case]))
        if texts:
            changed[case[1]] += 1
            print("\n    ".join([" | ".join(case), *texts]))
    for name, number in sorted(changed.items()):
        print(f"{number:5} {name}")
    number, cases = sum(changed.values()), len(old.keys() | new.keys())
    print(f"{number} of {cases} cases differ." if number else f"All {cases} cases are the same.")
    return number


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--package", metavar="DIR", help="directory with the package directionfields_vtk")
    parser.add_argument(
        "--meshes", metavar="DIR", action="append", default=[], help="more .ply, .obj and .stl files")
    parser.add_argument("--only", metavar="REGEX", default="", help="only meshes whose names match")
    parser.add_argument("--processes", metavar="N", type=int, help="surfaces in pieces on several processes, too")
    parser.add_argument("--compare", action="store_true", help="compare the files OLD and NEW")
    parser.add_argument("files", nargs="+", metavar="FILE")
    arguments = parser.parse_args()
    if len(arguments.files) != (2 if arguments.compare else 1) or arguments.compare == bool(arguments.package):
        parser.error("give --package and one file to write, or --compare and two files")
    if arguments.compare:
        sys.exit(1 if compare(*arguments.files) else 0)
    make(arguments.package, arguments.meshes, arguments.only, arguments.processes, arguments.files[0])


if __name__ == "__main__":
    main()
