// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
// Two materials that share a wavy sheet: its edges belong to three faces.
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 2, 1, 0.5};
Point(101) = {-0.1, -0.1, 0.25}; Point(102) = {0.5, -0.1, 0.35}; Point(103) = {1.2, -0.1, 0.15};
Point(104) = {2.1, -0.1, 0.3};
Spline(101) = {101, 102, 103, 104};
sheet() = Extrude {0, 1.2, 0} { Curve{101}; };
BooleanFragments{ Volume{1}; Delete; }{ Surface{sheet(1)}; Delete; }
