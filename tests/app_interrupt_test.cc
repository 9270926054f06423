// SPDX-License-Identifier: BSD-3-Clause
// The program is stopped by a signal: the shell's exit status, one line, nothing half-written.
#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <spawn.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "support/program.h"
#include "support/tiny_sequence.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

// The program as a child that is waited for or told to stop; it writes to files.
class RunningProgram {
 public:
  RunningProgram(std::vector<std::string> arguments, const fs::path& out, const fs::path& err) : err_(err) {
    arguments.insert(arguments.begin(), ARMATURE_PROGRAM);
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 1, out.c_str(), O_WRONLY | O_CREAT, 0600);
    posix_spawn_file_actions_addopen(&actions, 2, err.c_str(), O_WRONLY | O_CREAT, 0600);
    EXPECT_EQ(posix_spawn(&child_, ARMATURE_PROGRAM, &actions, nullptr, pointers.data(), environ), 0);
    posix_spawn_file_actions_destroy(&actions);
  }

  // Waits until the program has begun to write there, then stops it. Returns its exit status.
  int StopOnce(const fs::path& is_there, int signal) const {
    while (!fs::exists(is_there) && waitpid(child_, nullptr, WNOHANG) == 0)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    kill(child_, signal);
    int status = 0;
    EXPECT_EQ(waitpid(child_, &status, 0), child_) << "had ended before: " << Err();
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  std::string Err() const { return testing::ReadFile(err_); }

 private:
  pid_t child_ = 0;
  fs::path err_;
};

// The tiny sequence shown again and again, for minutes.
void WriteLongSequence(const testing::TempFolder& folder) {
  WriteTinySequence(folder);
  std::string images;
  for (int i = 0; i < 100'000; ++i) images += fmt::format("{:.1f} rgb/0.png\n", 0.2 * i);
  folder.Write("rgb.txt", images);
  folder.Write("sequence.yaml", testing::TinySequenceYaml("long"));
}

TEST(AppInterrupt, ARunEndsWithTheShellsStatusAndLeavesNothing) {
  const testing::TempFolder sequence, out;
  WriteLongSequence(sequence);
  for (const auto& [signal, status] : {std::pair(SIGINT, 130), std::pair(SIGTERM, 143)}) {
    const fs::path err = out / fmt::format("err{}", signal);
    const RunningProgram program({"run", sequence.path(), "--out", out / "runs/one"}, out / "out", err);
    EXPECT_EQ(program.StopOnce(out / "runs/one.partial-0", signal), status);
    EXPECT_TRUE(program.Err().ends_with("armature: interrupted; nothing was written\n")) << program.Err();
    EXPECT_TRUE(fs::is_empty(out / "runs"));
  }
  EXPECT_EQ(testing::ReadFile(out / "out"), "");
}

TEST(AppInterrupt, WhatWasFinishedBeforeIsNamed) {
  const testing::TempFolder first, second, out;
  WriteTinySequence(first);
  WriteLongSequence(second);
  const RunningProgram program({"run", first.path(), second.path(), "--out", out / "runs"}, out / "out",
                               out / "err");
  EXPECT_EQ(program.StopOnce(out / "runs/long.partial-0", SIGINT), 130);
  EXPECT_NE(program.Err().find("interrupted; finished before: " + (out / "runs/tiny").string() + "\n"),
            std::string::npos)
      << program.Err();
  EXPECT_TRUE(fs::exists(out / "runs/tiny/summary.json"));
  EXPECT_FALSE(fs::exists(out / "runs/long.partial-0"));
}

TEST(AppInterrupt, GeneratingLeavesNothingHalfWritten) {
  const testing::TempFolder out;
  const RunningProgram program({"generate", "--out", out / "data", "--only", "sample", "--without-cad"},
                               out / "out", out / "err");
  EXPECT_EQ(program.StopOnce(out / "data/sample.partial-0", SIGTERM), 143);
  EXPECT_TRUE(fs::is_empty(out / "data"));
}

}  // namespace
}  // namespace armature
