// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FieldImport_h
#define DirectionFields_FieldImport_h

#include "Exchange/FieldFile.h"
#include "Progress.h"
#include "Result.h"
#include "Surface.h"

#include <string>
#include <vector>

namespace DirectionFields
{
/// The elements that the rows of a file with directions belong to.
enum class FieldOn
{
  /// The triangles, if there are as many, else the points.
  Automatic = 0,
  Cells = 1,
  Points = 2
};

/// A field that was read, as if it had been computed: with true indices, everything over the points
/// that Direction Field would have.
struct ImportedField
{
  DirectionFields::Result Field;
  /// Sentences for the user on contents of the file that a field of one degree cannot have, and the
  /// other way around.
  std::vector<std::string> Warnings;
};

/// Lays the directions of a file on the surface that they belong to. Directions of faces are
/// carried to the vertices (ToVertices). RepresentationMagnitude is how much the directions around
/// a vertex agree, 1 for directions of vertices. A vertex that has no direction gets one from its
/// neighbours. Points at the same place across seams become one, as Direction Field does it. Rows
/// of an .obj file belong to the points at their places, where there are not as many points as
/// rows.
///
/// A file of another mesh with as many elements is noticed: directions that stand out of the
/// triangles' planes, or of the tangent planes at points, by more than 20 degrees in the mean are
/// an error, less is a warning; so are directions that agree with those of their neighbours as
/// little as directions at random.
///
/// Throws FileError where the numbers do not match, where a part of the surface has no direction at
/// all, MeshError, and Stopped. Takes linear time.
/// @param facesAreTriangles whether each face of the input is one triangle of the surface: only
///                          then rows can be for faces
ImportedField ImportField(const FieldFile& file, const Surface& surface, FieldOn on,
  bool facesAreTriangles, const Progress& progress = {});
}

#endif
