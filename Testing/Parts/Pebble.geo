// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
// A block of which all edges are round: no edge is sharp, only the faces of the part tell them.
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 2, 1.4, 1};
Fillet{1}{ 1:12 }{ 0.3 }
