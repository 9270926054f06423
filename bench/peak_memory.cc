// SPDX-License-Identifier: BSD-3-Clause
#include "bench/peak_memory.h"

#include <fcntl.h>
#include <malloc.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>

#include "base/child_process.h"
#include "base/errors.h"
#include "base/interrupt.h"

namespace armature {
namespace {

enum ExitStatus { kDone = 0, kBadInput = 2, kFailed = 3 };

double ResidentMegabytes() {
  long pages = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> pages >> resident;
  return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
}

void Silence() {
  const int nowhere = open("/dev/null", O_WRONLY);
  if (nowhere < 0) return;
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
}

void Send(int pipe, const void* bytes, size_t size) {
  if (write(pipe, bytes, size) < 0) _exit(kFailed);
}

// Sends what is resident, then the message of what was thrown.
int WorkAndTell(const std::function<void()>& work, int pipe) {
  Silence();
  const double before = ResidentMegabytes();
  Send(pipe, &before, sizeof before);
  try {
    work();
  } catch (const InputError& error) {
    Send(pipe, error.what(), std::strlen(error.what()));
    return kBadInput;
  } catch (const std::exception& error) {
    Send(pipe, error.what(), std::strlen(error.what()));
    return kFailed;
  }
  return kDone;
}

ssize_t ReadSome(int pipe, std::array<char, 4096>& part, ChildProcess& child) {
  constexpr int kBetweenLooks = 100;  // milliseconds
  pollfd waiting{pipe, POLLIN, 0};
  while (poll(&waiting, 1, kBetweenLooks) <= 0) {
    if (InterruptSignal() != 0) child.Signal(SIGKILL);
  }
  return read(pipe, part.data(), part.size());
}

// Until the child ends, at once if the user stops the program.
std::string ReadAll(int pipe, ChildProcess& child) {
  std::string all;
  std::array<char, 4096> part;
  for (ssize_t size = 0; (size = ReadSome(pipe, part, child)) != 0;) {
    if (size > 0) all.append(part.data(), static_cast<size_t>(size));
    if (size < 0 && errno != EINTR) break;
  }
  return all;
}

void CheckEnd(int status, const std::string& message) {
  if (status < 0) {
    throw std::runtime_error(std::string("measuring memory: the child process was ended by signal ") +
                             strsignal(-status));
  }
  if (status == kBadInput) throw InputError(message);
  if (status != kDone) throw std::runtime_error("measuring memory: " + message);
}

}  // namespace

PeakMemory MeasurePeakMemory(const std::function<void()>& work) {
  std::fflush(nullptr);  // or the child could write it a second time
  malloc_trim(0);
  auto [from_child, to_parent] = OpenPipe();
  ChildProcess child([&work, &pipe = to_parent] { return WorkAndTell(work, pipe.number()); });
  { const FileDescriptor closed = std::move(to_parent); }  // the child's alone, so that it ends with it
  const std::string sent = ReadAll(from_child.number(), child);
  const int status = child.Wait();
  ThrowIfInterrupted();
  PeakMemory memory;
  const size_t head = std::min(sent.size(), sizeof memory.before_mb);
  std::memcpy(&memory.before_mb, sent.data(), head);
  CheckEnd(status, sent.substr(head));
  memory.peak_mb = child.peak_mb();
  return memory;
}

}  // namespace armature
