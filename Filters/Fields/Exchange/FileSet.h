// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FileSet_h
#define DirectionFields_FileSet_h

#include <string>
#include <vector>

namespace DirectionFields::Internal
{
struct FileText
{
  std::string Path;
  std::string Text;
};

/// Writes files that belong together: all of them or none. Each text goes to a temporary file in
/// the folder of its file, and to the disk; only then do they take the places of the files, one
/// after the other. Where any of this fails, files that were there are as they were. A link is
/// followed to the file that it names, whose permissions the new one keeps.
///
/// Throws FileError where a file cannot be written, is write-protected, is no regular file or a
/// link to nowhere, and where a text is longer than MostTextBytes.
void WriteTogether(const std::vector<FileText>& files);
}

#endif
