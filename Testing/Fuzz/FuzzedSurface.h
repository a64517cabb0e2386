// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef FuzzedSurface_h
#define FuzzedSurface_h

#include "Bytes.h"
#include "Surface.h"

/// A surface out of bytes: one of the tests' own, of any scale, that is edited as long as there are bytes.
DirectionFields::Surface ReadSurface(Bytes& bytes);

/// Whether a surface has a point of such an id.
bool Exists(DirectionFields::Index point, const DirectionFields::Surface& surface);

#endif
