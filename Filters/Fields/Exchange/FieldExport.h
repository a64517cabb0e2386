// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FieldExport_h
#define DirectionFields_FieldExport_h

#include "Exchange/FaceField.h"
#include "Exchange/FieldFile.h"
#include "Exchange/FieldImport.h"
#include "Interpolation/GivenField.h"
#include "Options.h"

#include <string>
#include <vector>

namespace DirectionFields
{
struct ExportOptions
{
  /// Any but ObjComments.
  FieldFormat Format = FieldFormat::Rosy;
  /// Rows for the triangles (Cells, as which Automatic counts) or the points.
  FieldOn On = FieldOn::Cells;
  /// As Options::FeatureAngle and Options::MinimumFeatureLength, for the .sharp file.
  double FeatureAngle = DefaultFeatureAngle;
  double MinimumFeatureLength = DefaultMinimumFeatureLength;
};

/// A file by the end of its name and its text.
struct ExportedFile
{
  std::string Ending;
  std::string Text;
};

/// The files that other programs need of a field. The first one has the directions, or
/// singularities for .sing; then come
/// - .obj: the mesh with the same points and triangles in the same order. Where points across seams
///   became one, each is there once;
/// - .sharp beside .rosy: the features, which QuadWild does not look for in a mesh that comes with
///   a field;
/// - .sing beside .rawfield.
///
/// Directions of a row go counter-clockwise as seen from where its triangle's corners do.
/// Singularities are vertices where rows are for triangles (FaceSingularityIndices), and triangles
/// where rows are for points.
///
/// Throws FileError where the format does not have such a field.
/// @param given the directions of the triangles, if these are to be written and not those of the
///              points; else null
std::vector<ExportedFile> ExportField(
  const GivenField& field, const FaceField* given = nullptr, const ExportOptions& options = {});

/// Writes the first of the files under its name, and the others beside it, with their own endings:
/// all of them or, where that fails, none. Until then files of these names are as they were. The
/// mesh gets comments that say which files were written with it, and their checksums.
///
/// Throws FileError where a file cannot be written, and where one of the others is there already
/// and was not written here, or was changed since, as these comments say.
/// @param fileName with the ending of the first file
/// @param files    of ExportField; at least one
void WriteFiles(const std::string& fileName, const std::vector<ExportedFile>& files);
}

#endif
