// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ErrorSizes_h
#define DirectionFields_ErrorSizes_h

#include "Surface.h"

#include <string>
#include <vector>

namespace DirectionFields::Internal
{
/// The sum of the moduli of the principal curvatures at each point of a surface: eight times the
/// height of its middle over a square of unit edges along them. On creases, which faces do not
/// cross, it is the mean of the points beside them. Throws MeshError.
std::vector<double> CurvatureSums(const Surface& surface);

/// The sum of the moduli of the two principal second derivatives of a function along a surface, by
/// quadratic functions that are fitted to its values at the neighbours of each point and at theirs,
/// and averaged with the neighbours. Throws MeshError.
/// @param values at the points, finite
std::vector<double> DerivativeSums(const Surface& surface, const std::vector<double>& values);

/// What the lengths of edges are to be.
struct ErrorWish
{
  /// Of second derivatives k, lengths sqrt(8 error / k) have this error at the middles of faces; 0
  /// for what the number of faces allows.
  double Error = 0.0;
  /// About how many squares of the lengths cover the surface; has to be above 0 without an error.
  double Squares = 0.0;
  /// The factor by which lengths beside each other differ at most, above 1.
  double Gradation = 1.3;
  /// Whether k is a curvature: then lengths are those of chords whose height over circles is the
  /// error, no longer than twice the radius.
  bool AreChords = false;
};

/// Lengths of edges at the points, and the error that they are for.
struct ErrorLengths
{
  std::vector<double> Lengths;
  double Error = 0.0;
};

/// Lengths for an error that is the same everywhere, but no more than four times as long as those
/// of as many even faces and no shorter than an eighth, and with the gradation. Where all
/// derivatives are 0 they are even. Throws std::invalid_argument, its text a sentence for the user,
/// where an error would need more than ten million faces.
ErrorLengths LengthsForError(
  const Surface& surface, const std::vector<double>& derivatives, const ErrorWish& wish);
}

#endif
