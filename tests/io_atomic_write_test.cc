// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <csignal>
#include <fstream>
#include <thread>

#include "base/child_process.h"
#include "base/errors.h"
#include "io/atomic_write.h"
#include "support/expect_input_error.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

using testing::ExpectInputError;
using testing::ReadFile;

int EntriesOf(const fs::path& folder) {
  return static_cast<int>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(WholeFile, ReplacesWhatWasThere) {
  const testing::TempFolder folder;
  const std::string bytes("a\0b\r\n\xff", 6);
  AtomicWrite(folder / "file", "something longer than that");
  AtomicWrite(folder / "file", bytes);
  EXPECT_EQ(ReadFile(folder / "file"), bytes);
  AtomicWrite(folder / "empty", "");
  EXPECT_EQ(ReadFile(folder / "empty"), "");
  EXPECT_EQ(EntriesOf(folder.path()), 2) << "nothing is left aside";
}

TEST(WholeFile, MakesTheFoldersAroundIt) {
  const testing::TempFolder folder;
  AtomicWrite(folder / "a/b/c", "x");
  EXPECT_EQ(ReadFile(folder / "a/b/c"), "x");
}

TEST(WholeFile, WhatCannotBeWrittenLeavesNothingBehind) {
  const testing::TempFolder folder;
  folder.Write("file", "as before");
  fs::create_directories(folder / "taken/inside");
  ExpectInputError([&] { AtomicWrite(folder / "file/below", "x"); },
                   {"file/below", "cannot be written", "folder"});
  ExpectInputError([&] { AtomicWrite(folder / "taken", "x"); }, {"taken", "cannot be written"});
  EXPECT_EQ(ReadFile(folder / "file"), "as before");
  EXPECT_EQ(EntriesOf(folder.path()), 2);
}

TEST(WholeFile, ALinkStaysAndWhatItLeadsToIsWritten) {
  const testing::TempFolder folder;
  folder.Write("there/file", "before");
  fs::create_symlink("there/file", folder / "link");
  fs::create_symlink("there/absent", folder / "dangling");
  AtomicWrite(folder / "link", "after");
  AtomicWrite(folder / "dangling", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(ReadFile(folder / "there/file"), "after");
  EXPECT_EQ(ReadFile(folder / "there/absent"), "new");
  fs::create_symlink("circle", folder / "circle");
  ExpectInputError([&] { AtomicWrite(folder / "circle", "x"); }, {"circle", "remove the link"});
}

TEST(WholeFile, APipeIsWrittenToOnceSomebodyReadsIt) {
  const testing::TempFolder folder;
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  const std::string bytes(100'000, 'x');  // more than a pipe holds
  std::string read;
  std::thread reader([&] { read = ReadFile(folder / "pipe"); });
  AtomicWrite(folder / "pipe", bytes);
  reader.join();
  EXPECT_EQ(read, bytes);
  EXPECT_TRUE(fs::is_fifo(folder / "pipe"));
}

TEST(WholeFile, SaysWhatToDoAboutEachReason) {
  const testing::TempFolder folder;
  ExpectInputError([&] { AtomicWrite(folder / std::string(300, 'x'), "x"); },
                   {"File name too long", "choose a shorter name"});
  ExpectInputError([&] { AtomicWrite(folder.path(), "x"); },
                   {"cannot be written: is a folder", "name a file"});
  const fs::path full = folder / "full";  // as /dev/full is
  if (mknod(full.c_str(), S_IFCHR | 0600, makedev(1, 7)) != 0) GTEST_SKIP() << "only root makes devices";
  if (!std::ofstream(full)) GTEST_SKIP() << "devices are not opened here";
  ExpectInputError([&] { AtomicWrite(full, "x"); }, {"No space left", "free some space"});
}

TEST(WholeFile, AFileThatGrowsBeyondTheLimitIsNotHalfThere) {
  const testing::TempFolder folder;
  folder.Write("file", "before");
  ChildProcess limited([&] {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{1000, 1000};
    setrlimit(RLIMIT_FSIZE, &small);
    try {
      AtomicWrite(folder / "file", std::string(5000, 'x'));
    } catch (const InputError& error) {
      return std::string(error.what()).find("ulimit -f") != std::string::npos ? 0 : 1;
    }
    return 2;
  });
  EXPECT_EQ(limited.Wait(), 0);
  EXPECT_EQ(ReadFile(folder / "file"), "before");
  EXPECT_EQ(EntriesOf(folder.path()), 1);
}

}  // namespace
}  // namespace armature
