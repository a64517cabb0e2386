// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
// The skin of three pipes that meet, one of which is inclined, open at their ends.
SetFactory("OpenCASCADE");
Cylinder(1) = {-1.5, 0, 0, 3, 0, 0, 0.5};
Cylinder(2) = {0.3, 0, 0, 0, 0, 1.4, 0.4};
Cylinder(3) = {-0.5, 0, 0, -0.8, 1, 0, 0.3};
BooleanUnion(4) = { Volume{1}; Delete; }{ Volume{2, 3}; Delete; };
