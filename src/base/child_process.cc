// SPDX-License-Identifier: BSD-3-Clause
#include "base/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>  // NOLINT: kill is POSIX
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace armature {
namespace {

constexpr int kCannotStart = 127;  // as shells have it

// After fork: nothing but system calls.
[[noreturn]] void Become(const char* program, char* const* arguments, const char* folder, int log,
                         pid_t parent) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(kCannotStart);  // it ended in between
  const int nothing = open("/dev/null", O_RDONLY);
  const bool is_ready = chdir(folder) == 0 && dup2(nothing, STDIN_FILENO) >= 0 &&
                        dup2(log, STDOUT_FILENO) >= 0 && dup2(log, STDERR_FILENO) >= 0;
  if (is_ready) execv(program, arguments);
  _exit(kCannotStart);
}

int OpenLog(const std::filesystem::path& file) {
  const int log = open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (log < 0)
    throw std::runtime_error(fmt::format("{}: cannot be written ({})", file.string(), strerror(errno)));
  return log;
}

}  // namespace

ChildProcess::ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                           const std::filesystem::path& folder, const std::filesystem::path& log) {
  std::string name = program.filename().string();
  std::vector<std::string> texts = arguments;
  std::vector<char*> pointers{name.data()};
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  const int log_file = OpenLog(log);
  const pid_t parent = getpid();
  id_ = fork();
  if (id_ == 0) Become(program.c_str(), pointers.data(), folder.c_str(), log_file, parent);
  close(log_file);
  if (id_ < 0) throw std::runtime_error(fmt::format("no process can be started ({})", strerror(errno)));
}

ChildProcess::~ChildProcess() {
  if (Ended()) return;
  Interrupt();
  int ignored = 0;
  while (waitpid(id_, &ignored, 0) < 0 && errno == EINTR) continue;
}

std::optional<int> ChildProcess::Ended() {
  int status = 0;
  if (!status_ && waitpid(id_, &status, WNOHANG) == id_)
    status_ = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  return status_;
}

void ChildProcess::Interrupt() {
  if (!status_) kill(id_, SIGINT);
}

}  // namespace armature
