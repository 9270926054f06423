// SPDX-License-Identifier: BSD-3-Clause
// Work in a process of its own: another program, or a fork of this one.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace armature {

// An open file of the system, closed with the object. Not handed to programs that are started, unless named
// in their call.
class FileDescriptor {
 public:
  // `flags` as of open(), such as O_WRONLY | O_CREAT; others may read what it creates. Throws
  // std::runtime_error naming the file when it cannot be opened.
  FileDescriptor(const std::filesystem::path& file, int flags);
  explicit FileDescriptor(int open) : number_(open) {}
  ~FileDescriptor();
  FileDescriptor(FileDescriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }

  int number() const { return number_; }

 private:
  int number_ = -1;
};

// The two ends of a pipe: to read from and to write to. Throws std::runtime_error when there is none.
std::pair<FileDescriptor, FileDescriptor> OpenPipe();

struct ProgramCall {
  std::filesystem::path program;       // without a slash: looked for where the shell would
  std::vector<std::string> arguments;  // without the program's name
  std::filesystem::path folder{};      // where it starts; empty: where this process is
  int input = -1;                      // an open file; -1: nothing to be read
  int output = -1, error_output = -1;  // open files; -1: those of this process
};

class ChildProcess {
 public:
  // Starts the program. It does not get the terminal's Ctrl-C, and ends with this process. Throws
  // std::system_error with the reason when it cannot be started.
  explicit ChildProcess(const ProgramCall& call);
  // Does the work in a fork of this process, which ends with the status that the work returns; what is
  // registered to run at exit is left to the parent. The work must not throw. The fork has only the calling
  // thread: locks that other threads hold stay locked in it. Throws std::system_error when there can be no
  // further process.
  explicit ChildProcess(const std::function<int()>& work);
  // Asks it to stop and waits until it has.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  // How it ended; none: it still runs. Below 0: by that signal.
  std::optional<int> Ended();
  // Waits until it has ended, and tells how.
  int Wait();
  // Nothing where it has ended. SIGINT asks it to stop, as Ctrl-C does.
  void Signal(int signal);

  // Most memory that was resident at once, in megabytes (2^20); 0 while it runs.
  double peak_mb() const { return peak_mb_; }

 private:
  // Whether it has ended; `options` as of wait4().
  bool Reap(int options);

  pid_t id_ = -1;
  std::optional<int> status_;
  double peak_mb_ = 0;
};

}  // namespace armature
