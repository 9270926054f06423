// SPDX-License-Identifier: BSD-3-Clause
// Test programs with this file run `armature` in forks of themselves: starting it anew loads two hundred
// libraries, more than most of its commands take, and more so under sanitizers. The forks are made by a
// process that is forked before the first test, so that no test's threads or variables are in them.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "app/program.h"
#include "support/program.h"

namespace armature::testing {
namespace {

// Everything or false: the other end is closed.
bool WriteAll(int socket, const void* data, size_t size) {
  const char* bytes = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t written = send(socket, bytes, size, MSG_NOSIGNAL);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes += written;
    size -= static_cast<size_t>(written);
  }
  return true;
}

bool ReadAll(int socket, void* data, size_t size) {
  char* bytes = static_cast<char*>(data);
  while (size > 0) {
    const ssize_t got = read(socket, bytes, size);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    bytes += got;
    size -= static_cast<size_t>(got);
  }
  return true;
}

bool WriteTexts(int socket, const std::vector<std::string>& texts) {
  const size_t count = texts.size();
  if (!WriteAll(socket, &count, sizeof count)) return false;
  for (const std::string& text : texts) {
    const size_t size = text.size();
    if (!WriteAll(socket, &size, sizeof size) || !WriteAll(socket, text.data(), size)) return false;
  }
  return true;
}

bool ReadTexts(int socket, std::vector<std::string>& texts) {
  size_t count = 0;
  if (!ReadAll(socket, &count, sizeof count)) return false;
  texts.assign(count, "");
  for (std::string& text : texts) {
    size_t size = 0;
    if (!ReadAll(socket, &size, sizeof size)) return false;
    text.resize(size);
    if (!ReadAll(socket, text.data(), size)) return false;
  }
  return true;
}

std::vector<std::string> EnvironmentVariables() {
  std::vector<std::string> variables;
  for (char** variable = environ; *variable != nullptr; ++variable) variables.emplace_back(*variable);
  return variables;
}

void Redirect(int stream, const std::string& file, int flags) {
  const int opened = open(file.c_str(), flags | O_CLOEXEC, 0666);
  if (opened < 0 || dup2(opened, stream) < 0) _exit(127);
  close(opened);
}

// What a run of the program depends on.
struct Request {
  std::vector<std::string> arguments, environment;
  std::vector<std::string> places;  // working folder, file of the output, file of the errors

  bool Write(int socket) const {
    return WriteTexts(socket, arguments) && WriteTexts(socket, environment) && WriteTexts(socket, places);
  }
  bool Read(int socket) {
    return ReadTexts(socket, arguments) && ReadTexts(socket, environment) && ReadTexts(socket, places);
  }
};

// In the fork that is the program.
[[noreturn]] void BeTheProgram(Request& request) {
  if (chdir(request.places[0].c_str()) != 0) _exit(127);
  Redirect(STDIN_FILENO, "/dev/null", O_RDONLY);
  Redirect(STDOUT_FILENO, request.places[1], O_WRONLY | O_CREAT | O_TRUNC);
  Redirect(STDERR_FILENO, request.places[2], O_WRONLY | O_CREAT | O_TRUNC);
  clearenv();
  for (std::string& variable : request.environment) putenv(variable.data());
  std::vector<char*> pointers;
  for (std::string& argument : request.arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  std::exit(RunArmature(static_cast<int>(request.arguments.size()), pointers.data()));
}

// In the process that makes the forks; ends with the test program.
[[noreturn]] void Serve(int socket) {
  Request request;
  while (request.Read(socket)) {
    const pid_t child = fork();
    if (child == 0) {
      close(socket);
      BeTheProgram(request);
    }
    int status = -1;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
    if (!WriteAll(socket, &status, sizeof status)) break;
  }
  _exit(0);
}

class ProgramServer : public ::testing::Environment {
 public:
  void SetUp() override {
    int ends[2];
    ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends), 0);
    std::fflush(nullptr);
    server_ = fork();
    ASSERT_GE(server_, 0);
    if (server_ == 0) {
      close(ends[0]);
      Serve(ends[1]);
    }
    close(ends[1]);
    socket_ = ends[0];
    program_server = [this](const auto& arguments, const auto& out, const auto& err) {
      return Run(arguments, out, err);
    };
  }

  void TearDown() override {
    program_server = nullptr;
    close(socket_);
    waitpid(server_, nullptr, 0);
  }

 private:
  int Run(std::vector<std::string> arguments, const std::string& out, const std::string& err) const {
    arguments.insert(arguments.begin(), ARMATURE_PROGRAM);
    const Request request{
        std::move(arguments), EnvironmentVariables(), {std::filesystem::current_path().string(), out, err}};
    int status = -1;
    if (!request.Write(socket_) || !ReadAll(socket_, &status, sizeof status))
      throw std::runtime_error("the process that runs the program is gone");
    return status;
  }

  int socket_ = -1;
  pid_t server_ = -1;
};

[[maybe_unused]] const auto* const kServer = ::testing::AddGlobalTestEnvironment(new ProgramServer);

}  // namespace
}  // namespace armature::testing
