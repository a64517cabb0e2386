// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
// A plate with a slot and a round hole, cut into strips of several materials.
SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, 3, 1.6, 0.2};
Disk(2) = {0.9, 0.8, 0, 0.3, 0.3};
Rectangle(3) = {1.6, 0.65, 0, 0.9, 0.3, 0.14};
BooleanDifference(4) = { Surface{1}; Delete; }{ Surface{2, 3}; Delete; };
Rectangle(5) = {1.3, 0, 0, 0.15, 1.6};
Rectangle(6) = {0, 0.25, 0, 3, 0.15};
BooleanFragments{ Surface{4}; Delete; }{ Surface{5, 6}; Delete; }
