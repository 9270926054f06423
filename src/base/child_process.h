// SPDX-License-Identifier: BSD-3-Clause
// A program in a process of its own.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace armature {

class ChildProcess {
 public:
  // Starts the program in `folder`; what it prints goes to the end of `log`. It has no standard input, does
  // not get the terminal's Ctrl-C, and ends with this process. Throws std::runtime_error when it cannot be
  // started.
  ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
               const std::filesystem::path& folder, const std::filesystem::path& log);
  // Asks it to stop and waits until it has.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  // How it ended; none: it still runs. Below 0: by that signal.
  std::optional<int> Ended();
  // Asks it to stop, as Ctrl-C does.
  void Interrupt();

 private:
  pid_t id_ = -1;
  std::optional<int> status_;
};

}  // namespace armature
