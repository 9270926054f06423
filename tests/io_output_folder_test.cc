// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <optional>

#include "io/atomic_write.h"
#include "io/output_folder.h"
#include "io/run_results.h"
#include "support/expect_input_error.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

using testing::ReadFile;

const Replaceable kAnything{"a result", [](const fs::path&) { return true; }};

TEST(OutputFolder, WhatAKilledProgramLeftIsRemoved) {
  const testing::TempFolder folder;
  folder.Write("out.partial-0/summary.json", "an older result, exchanged and not yet removed");
  folder.Write("out.partial-7/half", "");
  folder.Write("out.partial-x/own", "of somebody else");
  {
    OutputFolder output(folder / "out", kAnything);
    EXPECT_EQ(output.partial(), folder / "out.partial-0");
    EXPECT_TRUE(fs::is_empty(output.partial()));
    WriteFile(output.partial() / "file", "new");
    output.Publish();
  }
  EXPECT_EQ(ReadFile(folder / "out/file"), "new");
  EXPECT_FALSE(fs::exists(folder / "out.partial-0"));
  EXPECT_FALSE(fs::exists(folder / "out.partial-7"));
  EXPECT_TRUE(fs::exists(folder / "out.partial-x/own"));
}

TEST(OutputFolder, AnotherProgramsWorkIsLeftAlone) {
  const testing::TempFolder folder;
  OutputFolder first(folder / "out", kAnything);
  WriteFile(first.partial() / "file", "first");
  OutputFolder second(folder / "out", kAnything);
  EXPECT_NE(first.partial(), second.partial());
  WriteFile(second.partial() / "file", "second");
  first.Publish();
  EXPECT_EQ(ReadFile(folder / "out/file"), "first");
  second.Publish();
  EXPECT_EQ(ReadFile(folder / "out/file"), "second");
}

TEST(OutputFolder, TakesOverAFolderWithoutChangingItBeforeItIsPublished) {
  const testing::TempFolder folder;
  folder.Write("out/kept/inside", "as it was");
  folder.Write("out/changed", "before");
  {
    OutputFolder output(folder / "out", kAnything);
    output.TakeOver();
    AtomicWrite(output.partial() / "changed", "given up");
  }
  EXPECT_EQ(ReadFile(folder / "out/changed"), "before");
  OutputFolder output(folder / "out", kAnything);
  output.TakeOver();
  AtomicWrite(output.partial() / "changed", "after");
  AtomicWrite(output.partial() / "added", "new");
  EXPECT_EQ(ReadFile(folder / "out/changed"), "before");
  output.Publish();
  EXPECT_EQ(ReadFile(folder / "out/changed"), "after");
  EXPECT_EQ(ReadFile(folder / "out/added"), "new");
  EXPECT_EQ(ReadFile(folder / "out/kept/inside"), "as it was");
}

TEST(OutputFolder, ALinkToAFolderStaysOne) {
  const testing::TempFolder folder;
  fs::create_directories(folder / "elsewhere/out");
  fs::create_directory_symlink(folder / "elsewhere/out", folder / "link");
  OutputFolder output(folder / "link", kAnything);
  WriteFile(output.partial() / "file", "x");
  output.Publish();
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(ReadFile(folder / "elsewhere/out/file"), "x");
}

TEST(OutputFolder, SaysWhyItCannotBeMade) {
  const testing::TempFolder folder;
  folder.Write("file", "");
  testing::ExpectInputError([&] { OutputFolder(folder / "file/out", kAnything); },
                            {"file/out", "Not a directory"});
  testing::ExpectInputError([&] { OutputFolder(folder / std::string(300, 'x'), kAnything); },
                            {"File name too long", "shorter name"});
}

TEST(OutputFolder, WhatIsWrittenAsideIsNoRun) {
  const testing::TempFolder folder;
  const std::string complete = R"({"complete": true, "sequence": "one"})";
  folder.Write("one/summary.json", complete);
  for (const char* aside : {"one.partial-0", "two.partial-12", "three.partial", "one.partial-0-old"}) {
    EXPECT_TRUE(IsPartial(folder / aside));
    folder.Write(std::string(aside) + "/summary.json", complete);
  }
  EXPECT_FALSE(IsPartial(folder / "my.partial-run"));
  EXPECT_EQ(RunsIn(folder.path()), std::vector<fs::path>{folder / "one"});
}

}  // namespace
}  // namespace armature
