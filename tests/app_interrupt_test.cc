// SPDX-License-Identifier: BSD-3-Clause
// The program is stopped by a signal: the shell's exit status, one line, nothing half-written.
#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "base/child_process.h"
#include "support/program.h"
#include "support/tiny_sequence.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

// The program as a child that is waited for or told to stop; it writes to files.
class RunningProgram {
 public:
  RunningProgram(const std::vector<std::string>& arguments, const fs::path& out, const fs::path& err)
      : err_(err), child_(Call(arguments, FileDescriptor(out, kWrite), FileDescriptor(err, kWrite))) {}

  // Waits until the program has begun to write there, then stops it. Returns its exit status.
  int StopOnce(const fs::path& is_there, int signal) {
    while (!fs::exists(is_there) && !child_.Ended())
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    EXPECT_FALSE(child_.Ended()) << "had ended before: " << Err();
    child_.Signal(signal);
    return child_.Wait();
  }

  std::string Err() const { return testing::ReadFile(err_); }

 private:
  static constexpr int kWrite = O_WRONLY | O_CREAT;

  static ProgramCall Call(const std::vector<std::string>& arguments, const FileDescriptor& out,
                          const FileDescriptor& err) {
    return {.program = ARMATURE_PROGRAM,
            .arguments = arguments,
            .output = out.number(),
            .error_output = err.number()};
  }

  fs::path err_;
  ChildProcess child_;
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
  for (const auto& [signal, status] :
       {std::pair(SIGINT, 130), std::pair(SIGTERM, 143), std::pair(SIGHUP, 129)}) {
    const fs::path err = out / fmt::format("err{}", signal);
    RunningProgram program({"run", sequence.path(), "--out", out / "runs/one"}, out / "out", err);
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
  RunningProgram program({"run", first.path(), second.path(), "--out", out / "runs"}, out / "out",
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
  RunningProgram program({"generate", "--out", out / "data", "--only", "sample", "--without-cad"},
                         out / "out", out / "err");
  EXPECT_EQ(program.StopOnce(out / "data/sample.partial-0", SIGTERM), 143);
  EXPECT_TRUE(fs::is_empty(out / "data"));
}

}  // namespace
}  // namespace armature
