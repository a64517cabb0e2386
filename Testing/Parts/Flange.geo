// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
// A disk with a hub, a bore, and six holes for bolts.
SetFactory("OpenCASCADE");
Cylinder(1) = {0, 0, 0, 0, 0, 0.3, 2};
Cylinder(2) = {0, 0, 0.2, 0, 0, 1, 0.8};
BooleanUnion(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
Cylinder(4) = {0, 0, -0.1, 0, 0, 1.5, 0.5};
For k In {1:6}
  Cylinder(4 + k) = {1.4 * Cos(k * Pi / 3), 1.4 * Sin(k * Pi / 3), -0.1, 0, 0, 0.6, 0.2};
EndFor
BooleanDifference(20) = { Volume{3}; Delete; }{ Volume{4:10}; Delete; };
