// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_AbaqusFile_h
#define DirectionFields_AbaqusFile_h

#include "SolverFiles/ShellMesh.h"

#include <string>

namespace DirectionFields
{
/// What an input file of Abaqus and CalculiX has of a mesh.
struct AbaqusOptions
{
  /// Elements S8R and S6 with a node in the middle of each edge, bent as the faces and lines there,
  /// in place of S4 and S3. Where faces meet at more than 40 degrees there is no bend across. S6 is
  /// a name of CalculiX: for Abaqus it has to be STRI65, as a comment before these elements says.
  bool SecondOrder = false;
  /// Of the shells, in the unit of the mesh, for which sections are written; 0 for none.
  /// At least 0.
  double Thickness = 0.0;
};

/// The text of an input file (.inp) with the nodes, elements and sets of a mesh, and no materials,
/// supports or loads: a file that has those takes it in by *INCLUDE.
///
/// Node and element i + 1 are point and face i; points of no face are left out, and nodes in the
/// middle of edges have the numbers after those of the points. Sets are
/// - NALL and EALL, all nodes and elements;
/// - NBOUNDARY, the nodes of edges of one face, if there are any;
/// - the sets of faces as *ELSET and those of points as *NSET. A node in the middle of an edge is
///   in a set of points if both ends are. Names are made of capital letters, digits and `_`, have
///   64 characters at most, and get a number behind them if they are taken; where that changes a
///   name, a comment gives the old one.
///
/// With a thickness there is a *SHELL SECTION for each set of faces, of a material of its name, and
/// one for the rest, SECTION_REST, or for EALL without sets, of the material MATERIAL. With
/// directions and a thickness each element has a section and an *ORIENTATION of its own, since
/// CalculiX knows no others that differ within a shell. Without a thickness directions become the
/// *DISTRIBUTION of the *ORIENTATION named DIRECTIONS, which Abaqus takes for shells and CalculiX
/// for solids only. Where a face has no direction in its plane that is the one along its first
/// edge, and a comment gives the number of these faces.
///
/// Numbers have up to 17 digits and 20 characters, which is all that CalculiX reads.
///
/// Throws std::invalid_argument, its text a sentence for the user, for a mesh without faces, a face
/// with one corner twice or numbers that are out of range, coordinates that are no finite numbers,
/// a thickness that is no number from 0 on, and a face in two sets with a thickness.
std::string AbaqusText(const ShellMesh& mesh, const AbaqusOptions& options = {});

/// Writes that text to a file, which is the whole one or as it was before. Throws FileError where
/// it cannot be written.
void WriteAbaqus(
  const std::string& fileName, const ShellMesh& mesh, const AbaqusOptions& options = {});
}

#endif
