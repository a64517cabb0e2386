// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_FileError_h
#define DirectionFields_FileError_h

#include <stdexcept>

namespace DirectionFields
{
/// A file that cannot be read or written, or has other contents than its name says. what() is a
/// sentence for the user, which names the line where there is one, the error, and the expected
/// contents.
class FileError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};
}

#endif
