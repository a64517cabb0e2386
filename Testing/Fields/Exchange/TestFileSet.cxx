// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Exchange/CompanionFiles.h"
#include "Exchange/FieldExport.h"
#include "Exchange/FileError.h"
#include "Exchange/FileSet.h"
#include "Exchange/TextFile.h"
#include "Meshes/Fields.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <sys/stat.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <sys/resource.h>
#include <vector>

using namespace DirectionFields;
namespace fs = std::filesystem;

namespace
{
/// A new folder for one test, which goes with it.
struct Folder
{
  Folder()
  {
    std::string name = (fs::temp_directory_path() / "FileSetXXXXXX").string();
    this->Path = mkdtemp(name.data());
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { fs::remove_all(this->Path); }

  std::string operator()(const std::string& name) const { return (this->Path / name).string(); }
  void Write(const std::string& name, const std::string& text) const
  {
    std::ofstream((*this)(name), std::ios::binary) << text;
  }
  std::string Read(const std::string& name) const
  {
    std::ifstream stream((*this)(name), std::ios::binary);
    return std::string((std::istreambuf_iterator<char>(stream)), {});
  }
  std::size_t Files() const
  {
    return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(this->Path), fs::directory_iterator()));
  }

  fs::path Path;
};

/// Files may not become longer, as on a disk that is full.
struct FullDisk
{
  explicit FullDisk(rlim_t bytes)
  {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &this->Before);
    rlimit limit = this->Before;
    limit.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;
  ~FullDisk() { setrlimit(RLIMIT_FSIZE, &this->Before); }

  rlimit Before{};
};

std::vector<ExportedFile> FilesOf(FieldFormat format, int levels = 1)
{
  const Surface surface = Meshes::Potato(levels);
  const Result result = Fields::Compute(surface, 4);
  ExportOptions options;
  options.Format = format;
  return ExportField(GivenField(surface, Fields::Of(result)), nullptr, options);
}

std::string ErrorOf(const std::string& name, const std::vector<ExportedFile>& files)
{
  try
  {
    WriteFiles(name, files);
  }
  catch (const FileError& error)
  {
    return error.what();
  }
  return {};
}
}

TEST(FileSet, AFullDiskLeavesTheFilesThatWereThere)
{
  const Folder folder;
  WriteTogether({ { folder("a"), "one" }, { folder("b"), "two" } });
  const std::string longText(100000, 'x');
  {
    const FullDisk disk(50000);
    EXPECT_THROW(WriteTogether({ { folder("a"), "three" }, { folder("b"), longText } }), FileError);
    EXPECT_THROW(WriteTogether({ { folder("a"), longText }, { folder("c"), "three" } }), FileError);
  }
  EXPECT_EQ(folder.Read("a"), "one");
  EXPECT_EQ(folder.Read("b"), "two");
  EXPECT_EQ(folder.Files(), 2U);
  WriteTogether({ { folder("a"), longText }, { folder("c"), "three" } });
  EXPECT_EQ(folder.Read("a"), longText);
  EXPECT_EQ(folder.Files(), 3U);
}

TEST(FileSet, OneThatCannotBeWrittenKeepsTheOthersFromIt)
{
  const Folder folder;
  folder.Write("a", "one");
  for (const std::string& bad : { folder(""), folder("not/there"), std::string("/dev/full") })
  {
    EXPECT_THROW(WriteTogether({ { folder("a"), "two" }, { bad, "two" } }), FileError) << bad;
    EXPECT_EQ(folder.Read("a"), "one");
    EXPECT_EQ(folder.Files(), 1U);
  }
}

TEST(FileSet, LinksAreFollowedAndPermissionsKept)
{
  const Folder folder;
  folder.Write("a", "one");
  fs::permissions(folder("a"), fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("a", folder("link"));
  WriteTogether({ { folder("link"), "two" } });
  EXPECT_TRUE(fs::is_symlink(folder("link")));
  EXPECT_EQ(folder.Read("a"), "two");
  EXPECT_EQ(fs::status(folder("a")).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("nowhere", folder("dangling"));
  EXPECT_TRUE(IsThere(folder("dangling")));
  EXPECT_THROW(WriteTogether({ { folder("dangling"), "two" } }), FileError);
  EXPECT_FALSE(fs::exists(folder("nowhere")));
}

TEST(FileSet, PipesDevicesAndLongFilesAreNotRead)
{
  const Folder folder;
  ASSERT_EQ(mkfifo(folder("pipe").c_str(), 0600), 0);
  EXPECT_THROW(ReadText(folder("pipe")), FileError);
  EXPECT_THROW(ReadText("/dev/zero"), FileError);
  EXPECT_THROW(ReadText(folder("")), FileError);
  folder.Write("long", "4");
  // Takes no room on the disk.
  std::error_code error;
  fs::resize_file(folder("long"), MostTextBytes + 1, error);
  if (!error)
  {
    EXPECT_THROW(ReadText(folder("long")), FileError);
  }
}

TEST(FileSet, MeshesTellWhatIsTheirsAndUnchanged)
{
  const std::string obj = WriteObj(Meshes::Potato(1));
  const std::string text = WithRecord(obj, { { ".rosy", Checksum("a") }, { ".sharp", "b" } });
  const auto record = RecordOf(text);
  ASSERT_TRUE(record.has_value());
  EXPECT_EQ(*record, (FileRecord{ { ".rosy", "af63dc4c8601ec8c" }, { ".sharp", "b" } }));
  EXPECT_FALSE(RecordOf(obj).has_value());
  EXPECT_FALSE(RecordOf("").has_value());
  for (std::size_t at = 0; at < text.size(); at += 97)
  {
    std::string changed = text;
    changed[at] ^= 1;
    EXPECT_FALSE(RecordOf(changed).has_value()) << at;
  }
}

TEST(FileSet, CompanionsOfOtherProgramsAreNeverReplaced)
{
  const Folder folder;
  const std::string rosy = folder("p.rosy");
  const std::vector<ExportedFile> files = FilesOf(FieldFormat::Rosy);
  EXPECT_EQ(ErrorOf(rosy, files), "");
  EXPECT_EQ(ErrorOf(rosy, FilesOf(FieldFormat::Rosy, 2)), "");
  // Another format beside keeps the record of the first.
  EXPECT_EQ(ErrorOf(folder("p.rawfield"), FilesOf(FieldFormat::RawField)), "");
  EXPECT_EQ(ErrorOf(rosy, files), "");
  EXPECT_EQ(folder.Files(), 5U);
  // Files that another program wrote beside a mesh of ours.
  folder.Write("p.sharp", "mine\n");
  EXPECT_NE(ErrorOf(rosy, files).find("p.sharp"), std::string::npos);
  EXPECT_EQ(folder.Read("p.sharp"), "mine\n");
  folder.Write("p.sing", "mine\n");
  const std::string before = folder.Read("p.rawfield");
  EXPECT_NE(ErrorOf(folder("p.rawfield"), FilesOf(FieldFormat::RawField, 2)).find("p.sing"),
    std::string::npos);
  EXPECT_EQ(folder.Read("p.sing"), "mine\n");
  EXPECT_EQ(folder.Read("p.rawfield"), before);
  // A mesh of ours that another program moved, its comments kept.
  EXPECT_EQ(ErrorOf(folder("q.rosy"), files), "");
  folder.Write("q.obj", folder.Read("q.obj") + "v 1 2 3\n");
  EXPECT_NE(ErrorOf(folder("q.rosy"), files).find("q.obj"), std::string::npos);
  // A link to nowhere is somebody's.
  fs::create_symlink("nowhere", folder("r.obj"));
  EXPECT_NE(ErrorOf(folder("r.rosy"), files), "");
  EXPECT_FALSE(fs::exists(folder("nowhere")));
  EXPECT_FALSE(fs::exists(folder("r.rosy")));
}
