# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files and functions that fit on a page: CheckSizes.py FOLDER

Fails where a C++ file below the folder has more than 500 lines, a function more than 80, signature included, or a line
more than 100 columns, and where two headers have one include guard: a source that includes both would see one of
them. Functions are found by the layout that clang-format gives them: a brace alone on its line, which a brace at the
same indentation closes."""
import pathlib
import re
import sys

MOST_LINES = 500
LONGEST_FUNCTION = 80
MOST_COLUMNS = 100
# The documentation of all properties of the main filter.
LONG_FILES = ("VTK/Filters/vtkDirectionField.h",)
# Headers of blocks that are no functions.
OTHER = re.compile(
    r"\s*(namespace|class|struct|enum|union|extern|if|else|for|while|do|switch|try|catch|case|default)\b")


def signature(lines, brace):
    """The first line of the declaration that ends above a line with a brace."""
    first = brace
    while first > 0:
        text = lines[first - 1].strip()
        if not text or text.startswith(("//", "#", "public:", "private:", "protected:")) or text[-1] in ";{}":
            break
        first -= 1
    return first


def functions(lines):
    """Yields the first line and the number of lines of each function."""
    for brace, line in enumerate(lines):
        if line.strip() != "{":
            continue
        first = signature(lines, brace)
        if first == brace or OTHER.match(lines[first]):
            continue
        close = re.compile(re.escape(line[:-1].rstrip("{")) + r"\}")
        end = next((i for i in range(brace + 1, len(lines)) if close.match(lines[i])), None)
        if end is not None:
            yield first, end - first + 1


def faults(path, name):
    lines = path.read_text(encoding="utf-8").split("\n")
    if len(lines) - 1 > MOST_LINES and name not in LONG_FILES:
        yield "%s has %d lines, more than %d" % (name, len(lines) - 1, MOST_LINES)
    for i, line in enumerate(lines):
        # The formatter leaves texts in one piece.
        if len(line) > MOST_COLUMNS and '"' not in line:
            yield "%s:%d has %d columns, more than %d" % (name, i + 1, len(line), MOST_COLUMNS)
    for first, length in functions(lines):
        if length > LONGEST_FUNCTION:
            yield "%s:%d is a function of %d lines, more than %d: %s" % (
                name, first + 1, length, LONGEST_FUNCTION, lines[first].strip())


def same_guards(paths):
    """Yields the headers whose include guard another header has, too."""
    headers = {}
    for path in paths:
        guard = re.search(r"^#ifndef (\w+)\n#define \1$", path.read_text(encoding="utf-8"), re.MULTILINE)
        if guard:
            headers.setdefault(guard[1], []).append(path.relative_to(folder).as_posix())
    for guard, names in headers.items():
        if len(names) > 1:
            yield "%s is the include guard of %s" % (guard, " and ".join(names))


folder = pathlib.Path(sys.argv[1])
paths = sorted(p for p in folder.rglob("*") if p.suffix in (".h", ".cxx"))
assert len(paths) > 500, len(paths)
counted = sum(len(list(functions(p.read_text(encoding="utf-8").split("\n")))) for p in paths)
assert counted > 2000, counted
found = [fault for path in paths for fault in faults(path, path.relative_to(folder).as_posix())]
found += same_guards(paths)
print("\n".join(found))
sys.exit(1 if found else 0)
