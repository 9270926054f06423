// SPDX-License-Identifier: BSD-3-Clause
// The program as its users run it.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "support/temp_folder.h"

namespace armature::testing {

struct ProgramResult {
  int status = -1;       // exit status, -1 when a signal ended the program
  std::string out, err;  // what it printed
};

inline std::string ShellQuoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'') quoted += "'\\'";
    quoted += c;
  }
  quoted += '\'';
  return quoted;
}

// Starts the program itself and returns what waitpid tells of it.
inline int StartProgram(const std::vector<std::string>& arguments, const std::string& out,
                        const std::string& err) {
  std::string command = ShellQuoted(ARMATURE_PROGRAM);
  for (const std::string& argument : arguments) command.append(" ").append(ShellQuoted(argument));
  command.append(" </dev/null >").append(out).append(" 2>").append(err);
  return std::system(command.c_str());
}

// The same in a fork of the test program, where it has support/program_server.cc.
inline std::function<int(const std::vector<std::string>& arguments, const std::string& out,
                         const std::string& err)>
    program_server;

// While it lives, every run is a start: for what depends on the program's own file or on the environment as
// libraries read it when they are loaded.
class StartedAnew {
 public:
  StartedAnew() { program_server.swap(server_); }
  ~StartedAnew() { program_server.swap(server_); }
  StartedAnew(const StartedAnew&) = delete;
  StartedAnew& operator=(const StartedAnew&) = delete;

 private:
  decltype(program_server) server_;
};

inline ProgramResult RunProgram(const std::vector<std::string>& arguments) {
  const TempFolder folder;
  const auto run = program_server ? program_server : StartProgram;
  const int status = run(arguments, folder / "out", folder / "err");
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, ReadFile(folder / "out"), ReadFile(folder / "err")};
}

// Runs the program, which has to succeed.
inline ProgramResult RunOk(const std::vector<std::string>& arguments) {
  ProgramResult result = RunProgram(arguments);
  EXPECT_EQ(result.status, 0) << result.err;
  return result;
}

// Runs the program, which has to end with status 2, nothing on standard output and one line on standard error
// in which each of the texts occurs.
inline void ExpectBadInput(const std::vector<std::string>& arguments, const std::vector<std::string>& texts) {
  const ProgramResult result = RunProgram(arguments);
  EXPECT_EQ(result.status, 2) << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_TRUE(result.err.starts_with("armature: ")) << result.err;
  EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << "not one line: " << result.err;
  for (const std::string& text : texts) {
    EXPECT_NE(result.err.find(text), std::string::npos) << "no '" << text << "' in: " << result.err;
  }
}

// Everything in the folder, relative to it.
inline std::set<std::string> AllFiles(const std::filesystem::path& folder) {
  std::set<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    files.insert(std::filesystem::relative(entry.path(), folder).string());
  }
  return files;
}

}  // namespace armature::testing
