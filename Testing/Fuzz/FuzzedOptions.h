// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FuzzedOptions_h
#define DirectionFields_FuzzedOptions_h

#include "Bytes.h"
#include "FilterRuns.h"

#include <cmath>
#include <cstddef>

/// The bytes of the options of one filter.
struct OptionBytes
{
  const Bytes& All;
  std::size_t First;
  /// The length of the mesh's box.
  double Size;
  /// Whether meshes of few faces do.
  bool AreFew;

  unsigned operator[](std::size_t i) const { return this->All.At(this->First + i); }
  bool Bit(std::size_t i, unsigned bit) const { return ((*this)[i] >> bit) % 2 != 0; }
  /// 0, a part of the size from 0.02 to 2, or now and then a number that breaks computations.
  double Length(std::size_t i) const
  {
    const unsigned byte = (*this)[i];
    return byte >= 240 ? Special(byte)
      : byte == 0      ? 0.0
                       : this->Size * 0.02 * std::pow(100.0, byte / 240.0);
  }
};

/// Directions and magnitudes that have nothing to do with the surface.
void AddRandomField(vtkPolyData* mesh, int degree, unsigned seed);

/// A number of the field becomes another one.
void Damage(vtkPolyData* field, unsigned where, unsigned number);

/// Some points of the mesh, or places beside it, as singularities.
FilterRuns::MeshPointer SomePoints(vtkPolyData* mesh, const OptionBytes& options);

/// @param kind   which filter
/// @param mesh   its first input
/// @param second its second one, where that is lines or points
FilterRuns::Filter AnyFilter(
  unsigned kind, vtkPolyData* mesh, vtkPolyData* second, const OptionBytes& options);

#endif
