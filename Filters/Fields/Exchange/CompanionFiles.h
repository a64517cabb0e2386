// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_CompanionFiles_h
#define DirectionFields_CompanionFiles_h

#include "Surface.h"
#include "Types.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace DirectionFields::Internal
{
/// An edge where the surface is sharp, seen from a triangle.
struct SharpEdge
{
  bool IsConvex;
  Index Triangle;
  /// 0 ... 2: from this corner of the triangle to the next one.
  int Corner;
};

/// A face or a vertex where a field is singular.
struct SingularElement
{
  Index Element;
  /// In units of 1/n.
  int SingularityIndex;
};

/// The first line of the mesh files that WriteObj makes, which tells them from others.
extern const std::string_view ObjMark;

/// The checksum of each file that was written with a mesh, by the end of its name.
using FileRecord = std::map<std::string, std::string>;

/// 16 hexadecimal digits (FNV-1a).
std::string Checksum(std::string_view text);

/// An .obj file of WriteObj, whose comments then tell which files were written with it, and that
/// none has been changed since.
std::string WithRecord(std::string_view obj, const FileRecord& record);
/// The record of such a text; none for a mesh that another program wrote or changed.
std::optional<FileRecord> RecordOf(std::string_view obj);

/// The text of an .obj file with all points and triangles in their order, on which the rows of a
/// file with a field count.
std::string WriteObj(const Surface& surface);
/// The text of a .sharp file (QuadWild): the number of rows, and rows of 1 for convex or 0 for
/// concave, triangle and corner, separated by commas.
std::string WriteSharp(const std::vector<SharpEdge>& edges);
/// The text of a .sing file (Directional): degree and number of rows, and rows of element and
/// index.
std::string WriteSingularities(int degree, const std::vector<SingularElement>& elements);
}

#endif
