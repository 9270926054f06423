// SPDX-License-Identifier: BSD-3-Clause
#include "base/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>  // NOLINT: kill is POSIX
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <system_error>

namespace armature {
namespace {

constexpr int kCannotStart = 127;  // as shells have it

bool Redirect(int file, int standard) { return file < 0 || dup2(file, standard) >= 0; }

// After fork: nothing but system calls. Sends the error number when the program cannot be started.
[[noreturn]] void Become(const ProgramCall& call, char* const* arguments, pid_t parent, int failure) {
  setpgid(0, 0);
  for (const int ignored : {SIGPIPE, SIGXFSZ}) signal(ignored, SIG_DFL);  // by us, not by the program
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(kCannotStart);  // it ended in between
  const int input = call.input >= 0 ? call.input : open("/dev/null", O_RDONLY | O_CLOEXEC);
  const bool is_ready = (call.folder.empty() || chdir(call.folder.c_str()) == 0) &&
                        Redirect(input, STDIN_FILENO) && Redirect(call.output, STDOUT_FILENO) &&
                        Redirect(call.error_output, STDERR_FILENO);
  if (is_ready) execvp(call.program.c_str(), arguments);
  const int reason = errno;
  [[maybe_unused]] const ssize_t sent = write(failure, &reason, sizeof reason);
  _exit(kCannotStart);
}

pid_t CheckedFork() {
  const pid_t id = fork();
  if (id < 0) throw std::system_error(errno, std::generic_category(), "no process can be started");
  return id;
}

// The error number that the child sent; 0: it has become the program, which closed the pipe.
int ReadFailure(int pipe) {
  int reason = 0;
  ssize_t size = 0;
  while ((size = read(pipe, &reason, sizeof reason)) < 0 && errno == EINTR) continue;
  return size == sizeof reason ? reason : 0;
}

}  // namespace

FileDescriptor::FileDescriptor(const std::filesystem::path& file, int flags)
    : number_(open(file.c_str(), flags | O_CLOEXEC, 0644)) {
  if (number_ >= 0) return;
  throw std::runtime_error(fmt::format("{}: cannot be opened ({})", file.string(), strerror(errno)));
}

FileDescriptor::~FileDescriptor() {
  if (number_ >= 0) close(number_);
}

std::pair<FileDescriptor, FileDescriptor> OpenPipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0)
    throw std::runtime_error(fmt::format("no pipe can be opened ({})", strerror(errno)));
  return {FileDescriptor(ends[0]), FileDescriptor(ends[1])};
}

ChildProcess::ChildProcess(const ProgramCall& call) {
  std::string name = call.program.filename().string();
  std::vector<std::string> texts = call.arguments;
  std::vector<char*> pointers{name.data()};
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  std::optional ends = OpenPipe();
  const pid_t parent = getpid();
  id_ = CheckedFork();
  if (id_ == 0) Become(call, pointers.data(), parent, ends->second.number());
  const FileDescriptor failure = std::move(ends->first);
  ends.reset();  // or reading would wait for this process itself
  if (const int reason = ReadFailure(failure.number()); reason != 0) {
    Wait();
    throw std::system_error(reason, std::generic_category(), call.program.string());
  }
}

ChildProcess::ChildProcess(const std::function<int()>& work) : id_(CheckedFork()) {
  if (id_ == 0) _exit(work());
}

ChildProcess::~ChildProcess() {
  if (Ended()) return;
  Signal(SIGINT);
  Wait();
}

bool ChildProcess::Reap(int options) {
  if (status_) return true;
  int status = 0;
  rusage usage{};
  pid_t ended = 0;
  while ((ended = wait4(id_, &status, options, &usage)) < 0 && errno == EINTR) continue;
  if (ended != id_) return false;
  status_ = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  peak_mb_ = static_cast<double>(usage.ru_maxrss) / 1024;  // Linux counts kilobytes
  return true;
}

std::optional<int> ChildProcess::Ended() {
  Reap(WNOHANG);
  return status_;
}

int ChildProcess::Wait() {
  if (!Reap(0)) throw std::logic_error("waiting for a process that is no child");
  return *status_;
}

void ChildProcess::Signal(int signal) {
  if (!status_) kill(id_, signal);
}

}  // namespace armature
