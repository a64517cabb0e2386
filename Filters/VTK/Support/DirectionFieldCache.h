// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFieldCache_h
#define DirectionFieldCache_h

#include "Conversion/Input/PolyDataToSurface.h"

#include <DirectionFields/DirectionField.h>

#include <memory>
#include <optional>
#include <vector>

class vtkPolyData;

namespace DirectionFields
{
/// The surface of the last input and its solver, which keeps the stages of the computation.
class DirectionFieldCache
{
public:
  /// Reads the surface of an input. The solver is kept where the points and the triangles are the
  /// same as before, even if the input's data changed. They are compared by value: modification
  /// times do not tell, for they change with each array, and do not change where points are moved
  /// in place.
  ///
  /// Where only the points have changed and the time, the field of the time before is the reference
  /// of the new one's phase, so that it does not jump.
  /// @param time of the input if it is one of a series
  ///
  /// Throws Stopped; then everything is as before.
  void SetInput(vtkPolyData* input, const std::optional<double>& time, const Progress& progress);

  /// Remembers the field that was computed of the input, which the next time step's follows.
  void SetField(const Result& field);

  ///@{
  /// For pieces of a surface: whether the last input is the next time step of the one before; and
  /// the directions, of a field of that degree, that this one's phase follows. Where the surface is
  /// at its next step elsewhere, but this piece of it has stayed the same, that is the last field.
  bool IsNextStep() const { return this->Follows; }
  std::vector<Vector3> GetPrevious(bool isNextStep, int degree);
  ///@}

  const TriangulatedPolyData& GetSurface() const { return *this->Surface; }
  DirectionField& GetSolver() { return *this->Solver; }

private:
  /// The solver shares the mesh in it.
  std::shared_ptr<TriangulatedPolyData> Surface;
  std::optional<DirectionField> Solver;
  /// The time of the last input, if it is one of a series.
  std::optional<double> Time;
  bool Follows = false;
  /// The first directions of the last field, as long as |u|, and its degree.
  std::vector<Vector3> Directions;
  int Degree = 0;
};
}

#endif
