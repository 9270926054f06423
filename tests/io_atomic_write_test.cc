// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace armature
