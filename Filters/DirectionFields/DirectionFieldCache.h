// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFieldCache_h
#define DirectionFieldCache_h

#include "DirectionField.h"
#include "PolyDataToSurface.h"

#include <memory>
#include <optional>
#include <vector>

class vtkPolyData;

namespace DirectionFields
{
/// The surface of the last input and the stages of its computation.
class DirectionFieldCache
{
public:
  /// The stages are kept where the points and the triangles are the same as before, whatever
  /// became of the input's data. They are compared by value: modification times do not tell, for
  /// they change with each array, and do not change where points are moved in place.
  ///
  /// Where only the points have changed and the time, the field of the time before is the reference
  /// of the new one's phase, so that it does not jump.
  ///
  /// False where the progress function stopped it; then everything is as before.
  bool SetInput(
    vtkPolyData* input, const std::optional<double>& time, const ProgressFunction& progress);

  /// The field that was computed of the input.
  void SetField(const Result& field);

  const TriangulatedPolyData& GetSurface() const { return *this->Surface; }
  DirectionField& GetSolver() { return *this->Solver; }

private:
  /// The stages share the mesh in it.
  std::shared_ptr<TriangulatedPolyData> Surface;
  std::optional<DirectionField> Solver;
  /// Of the last input, if it is one of a series, and the first directions of its field.
  std::optional<double> Time;
  std::vector<Vector3> Directions;
  int Degree = 0;
};
}

#endif
