// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
// A wheel of ten straight teeth with a bore and a groove in it.
SetFactory("OpenCASCADE");
Cylinder(1) = {0, 0, 0, 0, 0, 0.5, 1};
For k In {0:9}
  Box(10 + k) = {0.8, -0.15, 0, 0.5, 0.3, 0.5};
  Rotate {{0, 0, 1}, {0, 0, 0}, k * Pi / 5} { Volume{10 + k}; }
EndFor
BooleanUnion(30) = { Volume{1}; Delete; }{ Volume{10:19}; Delete; };
Cylinder(31) = {0, 0, -0.1, 0, 0, 0.7, 0.35};
Box(32) = {0.2, -0.1, -0.1, 0.3, 0.2, 0.7};
BooleanDifference(33) = { Volume{30}; Delete; }{ Volume{31, 32}; Delete; };
