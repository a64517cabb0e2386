// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
// A shaft of three radii with a groove for a key and rounded shoulders.
SetFactory("OpenCASCADE");
Cylinder(1) = {0, 0, 0, 0, 0, 1, 0.6};
Cylinder(2) = {0, 0, 1, 0, 0, 1.5, 0.45};
Cylinder(3) = {0, 0, 2.5, 0, 0, 1, 0.3};
BooleanUnion(4) = { Volume{1}; Delete; }{ Volume{2, 3}; Delete; };
Box(5) = {0.35, -0.1, 1.3, 0.2, 0.2, 0.8};
BooleanDifference(6) = { Volume{4}; Delete; }{ Volume{5}; Delete; };
