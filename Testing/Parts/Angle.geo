// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
// Two legs of an angle, joined by a fillet, with a round hole in each.
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 1.6, 1.2, 0.2};
Box(2) = {0, 0, 0, 0.2, 1.2, 1.2};
BooleanUnion(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
inner() = Curve In BoundingBox{0.19, -0.01, 0.19, 0.21, 1.21, 0.21};
filled() = Fillet{3}{ inner(0) }{ 0.2 };
Cylinder(4) = {1.1, 0.6, -0.1, 0, 0, 0.4, 0.18};
Cylinder(5) = {-0.1, 0.6, 0.85, 0.4, 0, 0, 0.14};
BooleanDifference(6) = { Volume{filled()}; Delete; }{ Volume{4, 5}; Delete; };
