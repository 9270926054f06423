// SPDX-License-Identifier: BSD-3-Clause
// The program. Exit status: 0 done, 1 ran and failed, 2 bad usage or bad input, 130 and 143 interrupted.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/bench_command.h"
#include "app/compare_command.h"
#include "app/eval_command.h"
#include "app/generate_command.h"
#include "app/learn_command.h"
#include "app/photo_command.h"
#include "app/posegraph_command.h"
#include "app/reproduce/reproduce_command.h"
#include "app/report_command.h"
#include "app/retrieve_command.h"
#include "app/run_command.h"
#include "io/build_info.h"
#include "io/console.h"
#include "io/errors.h"
#include "io/interrupt.h"
#include "io/nearest_name.h"

namespace armature {
namespace {

constexpr int kFailed = 1;
constexpr int kBadInput = 2;

int Report(std::string message, int status) {
  PrintError(std::move(message));
  return status;
}

// A signal reaches child processes, too: what they then fail at is no failure of ours.
int ReportFailure(const std::exception& error) {
  if (InterruptSignal() == 0) return Report(error.what(), kFailed);
  return Report(fmt::format("interrupted: {}", error.what()), ExitStatusOf(InterruptSignal()));
}

std::string VersionText() {
  const BuildInfo build = GetBuildInfo();
  return fmt::format("armature {} ({}{})", build.version, build.git_commit,
                     build.git_dirty ? ", modified" : "");
}

// "armature rnu ...": the command that was probably meant.
std::optional<std::string> UnknownCommand(const CLI::App& app, const std::vector<std::string>& arguments) {
  if (arguments.empty() || arguments.front().starts_with("-")) return std::nullopt;
  std::vector<std::string> known;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    known.push_back(command->get_name());
  }
  if (std::find(known.begin(), known.end(), arguments.front()) != known.end()) return std::nullopt;
  return UnknownNameMessage("command", arguments.front(), known);
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

int Main(int argc, char** argv) {
  cv::setNumThreads(1);  // times are of one thread
  CatchInterrupts();
  CLI::App app("Armature finds furniture in monocular video from line segments and puts it in the map.",
               "armature");
  app.set_version_flag("--version", VersionText());
  app.require_subcommand(1);
  int exit_status = 0;
  AddRunCommand(app, exit_status);
  AddPhotoCommand(app, exit_status);
  AddEvalCommand(app, exit_status);
  AddCompareCommand(app, exit_status);
  AddBenchCommand(app, exit_status);
  AddReproduceCommand(app, exit_status);
  AddLearnCommand(app, exit_status);
  AddRetrieveCommand(app, exit_status);
  AddReportCommand(app, exit_status);
  AddGenerateCommand(app, exit_status);
  AddPoseGraphCommand(app, exit_status);
  try {
    app.parse(argc, argv);
    return exit_status;
  } catch (const CLI::ParseError& error) {
    return ReportUsage(app, error, {argv + 1, argv + argc});
  } catch (const InputError& error) {
    return Report(error.what(), kBadInput);
  } catch (const Interrupted& error) {
    return Report(error.what(), ExitStatusOf(InterruptSignal()));
  } catch (const std::exception& error) {
    return ReportFailure(error);
  }
}

}  // namespace
}  // namespace armature

int main(int argc, char** argv) { return armature::Main(argc, argv); }
