// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
// A block with a round pocket, a slot that crosses its edge, and rounded upright edges.
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 2, 1.4, 0.6};
upright() = Curve In BoundingBox{-0.01, -0.01, -0.01, 0.01, 1.41, 0.61};
Cylinder(2) = {1.3, 0.7, 0.25, 0, 0, 0.5, 0.4};
Box(3) = {-0.1, 0.55, 0.3, 0.9, 0.3, 0.5};
BooleanDifference(4) = { Volume{1}; Delete; }{ Volume{2, 3}; Delete; };
