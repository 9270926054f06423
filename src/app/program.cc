// SPDX-License-Identifier: BSD-3-Clause
#include "app/program.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <exception>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/commands.h"
#include "app/failure.h"
#include "base/console.h"
#include "base/interrupt.h"
#include "base/nearest_name.h"
#include "base/standard_streams.h"
#include "base/write_failure.h"

namespace armature {
namespace {

constexpr int kFailed = 1, kBadInput = 2;

int Report(std::string message, int status) {
  PrintError(std::move(message));
  return status;
}

// A signal reaches child processes, too: what they then fail at is no failure of ours.
int ReportFailure(const Failure& failure) {
  if (InterruptSignal() == 0 || failure.status == kBadInput) return Report(failure.line, failure.status);
  return Report(fmt::format("interrupted: {}", failure.line), SignalExitStatus(InterruptSignal()));
}

// "armature rnu ...": the command that was probably meant.
std::optional<std::string> UnknownCommand(const CLI::App& app, const std::vector<std::string>& arguments) {
  const auto named = std::find_if(arguments.begin(), arguments.end(),
                                  [](const std::string& argument) { return !argument.starts_with("-"); });
  if (named == arguments.end()) return std::nullopt;
  std::vector<std::string> known;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    known.push_back(command->get_name());
  }
  if (std::find(known.begin(), known.end(), *named) != known.end()) return std::nullopt;
  return UnknownNameMessage("command", *named, known);
}

// Help and version are exceptions too, with status 0.
int ReportUsage(const CLI::App& app, const CLI::ParseError& error,
                const std::vector<std::string>& arguments) {
  if (error.get_exit_code() == 0) return app.exit(error);
  if (const auto message = UnknownCommand(app, arguments)) return Report(*message, kBadInput);
  std::string command = "armature";
  for (const CLI::App* parsed : app.get_subcommands()) command += " " + parsed->get_name();
  return Report(fmt::format("{}; see {} --help", error.what(), command), kBadInput);
}

int RunCommand(int argc, char** argv) {
  cv::setNumThreads(1);  // times are of one thread
  CatchInterrupts();
  CLI::App app("Armature finds furniture in monocular video from line segments and puts it in the map.",
               "armature");
  int exit_status = 0;
  AddCommands(app, exit_status);
  try {
    app.parse(argc, argv);
    return exit_status;
  } catch (const CLI::ParseError& error) {
    return ReportUsage(app, error, {argv + 1, argv + argc});
  } catch (const Interrupted& error) {
    return Report(error.what(), SignalExitStatus(InterruptSignal()));
  } catch (...) {
    return ReportFailure(DescribeFailure(std::current_exception()));
  }
}

// What was printed last may still be on its way. That its reader has seen enough (`| head`) is no error of
// ours.
int EndOutput(int status) {
  const int error = FlushStandardOutput();
  if (error == 0) return status;
  if (error == EPIPE) return SignalExitStatus(SIGPIPE);
  return Report(WriteFailure("standard output", error), kFailed);
}

}  // namespace

int RunArmature(int argc, char** argv) {
  OpenStandardStreams();
  return EndOutput(RunCommand(argc, argv));
}

}  // namespace armature
