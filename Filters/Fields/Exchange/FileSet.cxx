// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Exchange/FileSet.h"

#include "Exchange/FileError.h"
#include "Exchange/TextFile.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <random>
#include <system_error>

#if __has_include(<unistd.h>)
#include <fcntl.h>
#include <unistd.h>
#endif

namespace DirectionFields::Internal
{
namespace
{
namespace fs = std::filesystem;

/// Waits until the contents of a file or folder are on the disk. Whether they are; folders of some
/// file systems cannot be waited for, which is no error.
bool Flush([[maybe_unused]] const fs::path& path)
{
#if __has_include(<unistd.h>)
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0)
  {
    return false;
  }
  const bool isFlushed = fsync(file) == 0;
  return close(file) == 0 && isFlushed;
#else
  return true;
#endif
}

/// A name that no file of the folder has. Two programs that write the same file at the same time
/// get different ones.
fs::path NameBeside(const fs::path& path, const char* purpose)
{
  std::random_device random;
  fs::path name;
  do
  {
    name = path;
    name += std::string(".") + purpose + std::to_string(random());
  } while (fs::exists(fs::symlink_status(name)));
  return name;
}

/// A file on its way to its place.
class Replacement
{
public:
  explicit Replacement(const FileText& file)
    : Name(file.Path)
    , Path(Target(file.Path))
  {
    RequireShort(file.Path, file.Text.size());
    std::error_code error;
    this->WasThere = fs::exists(this->Path, error);
    if (this->WasThere && !std::ofstream(this->Path, std::ios::app))
    {
      throw FileError("The file " + this->Name + " is write-protected.");
    }
    this->Temporary = NameBeside(this->Path, "part");
    this->Write(file.Text);
  }
  Replacement(const Replacement&) = delete;
  Replacement& operator=(const Replacement&) = delete;

  /// Whatever was not kept is taken back.
  ~Replacement()
  {
    std::error_code ignored;
    if (this->IsInPlace)
    {
      if (this->WasThere)
      {
        fs::rename(this->Backup, this->Path, ignored);
      }
      else
      {
        fs::remove(this->Path, ignored);
      }
    }
    fs::remove(this->Temporary, ignored);
  }

  void PutInPlace()
  {
    std::error_code error;
    if (this->WasThere)
    {
      this->Backup = NameBeside(this->Path, "old");
      fs::create_hard_link(this->Path, this->Backup, error);
      if (error)
      {
        // Some file systems have no hard links. For a moment there is no file of the name then.
        fs::rename(this->Path, this->Backup, error);
      }
    }
    if (!error)
    {
      this->IsInPlace = true;
      fs::rename(this->Temporary, this->Path, error);
    }
    if (error)
    {
      throw FileError("The file " + this->Name + " cannot be replaced: " + error.message() + ".");
    }
  }

  void Keep()
  {
    std::error_code ignored;
    this->IsInPlace = false;
    if (this->WasThere)
    {
      fs::remove(this->Backup, ignored);
    }
    Flush(this->Path.has_parent_path() ? this->Path.parent_path() : fs::path("."));
  }

private:
  /// The file that a name stands for.
  static fs::path Target(const fs::path& name)
  {
    std::error_code error;
    const fs::file_status status = fs::status(name, error);
    if (!fs::exists(status))
    {
      if (fs::is_symlink(fs::symlink_status(name, error)))
      {
        throw FileError(name.string() + " is a link to a file that is not there.");
      }
      return name;
    }
    if (!fs::is_regular_file(status))
    {
      throw FileError(name.string() + " is no regular file and cannot be written.");
    }
    fs::path target = fs::canonical(name, error);
    return error ? name : target;
  }

  void Write(const std::string& text)
  {
    std::ofstream stream(this->Temporary, std::ios::binary | std::ios::trunc);
    if (!stream)
    {
      throw FileError("The file " + this->Name +
        " cannot be written: its folder is not there or takes no new files.");
    }
    stream.write(text.data(), static_cast<std::streamsize>(text.size()));
    stream.close();
    if (!stream || !Flush(this->Temporary))
    {
      std::error_code ignored;
      fs::remove(this->Temporary, ignored);
      throw FileError("The file " + this->Name +
        " could not be written to its end; the disk may be full. Files that were there are as "
        "they were.");
    }
    if (this->WasThere)
    {
      std::error_code ignored;
      fs::permissions(this->Temporary, fs::status(this->Path, ignored).permissions(), ignored);
    }
  }

  std::string Name;
  fs::path Path;
  fs::path Temporary;
  fs::path Backup;
  bool WasThere = false;
  bool IsInPlace = false;
};
}

void WriteTogether(const std::vector<FileText>& files)
{
  std::vector<std::unique_ptr<Replacement>> replacements;
  for (const FileText& file : files)
  {
    replacements.push_back(std::make_unique<Replacement>(file));
  }
  for (const auto& replacement : replacements)
  {
    replacement->PutInPlace();
  }
  for (const auto& replacement : replacements)
  {
    replacement->Keep();
  }
}
}
