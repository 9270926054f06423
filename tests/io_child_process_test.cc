// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <system_error>

#include "base/child_process.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

int RunShell(const std::string& script) {
  return ChildProcess({.program = "sh", .arguments = {"-c", script}}).Wait();
}

TEST(ChildProcess, TellsHowAProgramEnded) {
  EXPECT_EQ(RunShell("true"), 0);
  EXPECT_EQ(RunShell("exit 3"), 3);
  EXPECT_EQ(RunShell("kill -TERM $$"), -SIGTERM);
  EXPECT_EQ(RunShell("read line"), 1) << "there is nothing to be read";
}

TEST(ChildProcess, ReadsAndWritesTheFilesOfItsCallInItsFolder) {
  const testing::TempFolder folder;
  folder.Write("in", "a line\n");
  const FileDescriptor in(folder / "in", O_RDONLY), out(folder / "out", O_WRONLY | O_CREAT),
      err(folder / "err", O_WRONLY | O_CREAT);
  ChildProcess shell({.program = "sh",
                      .arguments = {"-c", "cat; pwd >&2"},
                      .folder = folder.path(),
                      .input = in.number(),
                      .output = out.number(),
                      .error_output = err.number()});
  EXPECT_EQ(shell.Wait(), 0);
  EXPECT_EQ(testing::ReadFile(folder / "out"), "a line\n");
  EXPECT_EQ(testing::ReadFile(folder / "err"), std::filesystem::canonical(folder.path()).string() + "\n");
}

TEST(ChildProcess, SaysWhyAProgramCannotBeStarted) {
  const testing::TempFolder folder;
  for (const ProgramCall& call :
       {ProgramCall{.program = folder / "none", .arguments = {}},
        ProgramCall{.program = "no-such-program", .arguments = {}},
        ProgramCall{.program = "sh", .arguments = {"-c", "true"}, .folder = folder / "none"}}) {
    try {
      ChildProcess child(call);
      ADD_FAILURE() << call.program << " was started";
    } catch (const std::system_error& error) {
      EXPECT_EQ(error.code(), std::errc::no_such_file_or_directory) << error.what();
    }
  }
  EXPECT_THROW(FileDescriptor(folder / "none/file", O_WRONLY | O_CREAT), std::runtime_error);
}

TEST(ChildProcess, RunsUntilItIsStopped) {
  ChildProcess sleep({.program = "sleep", .arguments = {"100"}});
  EXPECT_FALSE(sleep.Ended());
  EXPECT_EQ(sleep.peak_mb(), 0);
  sleep.Signal(SIGINT);
  EXPECT_EQ(sleep.Wait(), -SIGINT);
  EXPECT_EQ(sleep.Ended(), -SIGINT);
}

TEST(ChildProcess, AForkSharesNothingButWhatItSends) {
  const auto [from_child, to_parent] = OpenPipe();
  int value = 1;
  ChildProcess child([&value, pipe = to_parent.number()] {
    value = 2;
    return write(pipe, &value, sizeof value) == sizeof value ? 7 : 8;
  });
  int sent = 0;
  EXPECT_EQ(read(from_child.number(), &sent, sizeof sent), static_cast<ssize_t>(sizeof sent));
  EXPECT_EQ(child.Wait(), 7);
  EXPECT_EQ(value, 1);
  EXPECT_EQ(sent, 2);
  EXPECT_GT(child.peak_mb(), 1);
}

}  // namespace
}  // namespace armature
