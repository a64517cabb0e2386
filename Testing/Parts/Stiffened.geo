// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
// A curved panel with two ribs across it and one along it.
SetFactory("OpenCASCADE");
Point(1) = {-1, 0, 0}; Point(2) = {0, 0, 0.5}; Point(3) = {1, 0, 0};
Spline(1) = {1, 2, 3};
panel() = Extrude {0, 2.4, 0} { Curve{1}; };
For k In {1:2}
  Rectangle(100 + k) = {-1, -0.2, 0, 2, 1.2};
  Rotate {{1, 0, 0}, {0, 0, 0}, Pi / 2} { Surface{100 + k}; }
  Translate {0, 0.8 * k, 0} { Surface{100 + k}; }
EndFor
Rectangle(103) = {-0.2, 0, 0, 1.2, 2.4};
Rotate {{0, 1, 0}, {0, 0, 0}, -Pi / 2} { Surface{103}; }
BooleanFragments{ Surface{panel(1)}; Delete; }{ Surface{101:103}; Delete; }
