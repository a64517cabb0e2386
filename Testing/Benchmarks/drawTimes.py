# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the table that TimeOverPolygons prints, both axes logarithmic, and prints its slopes.

    pvpython drawTimes.py TABLE.csv PICTURE.png [--check]

With --check it fails unless each curve can be seen in the picture.
"""

import csv
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import logLogChart  # noqa: E402, it stands beside this file

SERIES = {
    "smooth": ("smoothest", (0, 107, 117)),
    "aligned": ("aligned to curvature", (214, 120, 20)),
    "constrained": ("aligned and constrained", (150, 40, 130)),
}


def main(table_path, picture_path, *options):
    with open(table_path, newline="", encoding="ascii") as file:
        rows = list(csv.DictReader(file))
    columns = {name: [float(row[name]) for row in rows] for name in rows[0]}
    curves = []
    for name, (label, color) in SERIES.items():
        curves.append((label, color, columns["polygons"], columns[name]))
        slope = logLogChart.slope(columns["polygons"], columns[name])
        print(f"{name}: time grows with the polygons to the power of {slope:.2f}")
    missing = logLogChart.draw(picture_path, curves, ("polygons", "seconds"))
    if "--check" in options and missing:
        sys.exit(f"The curve of {missing[0]} is not in the picture.")


if __name__ == "__main__":
    main(*sys.argv[1:])
