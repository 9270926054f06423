// SPDX-License-Identifier: BSD-3-Clause
#include "app/commands.h"

#include <fmt/format.h>

#include "app/completion_command.h"
#include "app/learn/learn_command.h"
#include "app/posegraph_command.h"
#include "app/reproduce/reproduce_command.h"
#include "app/retrieve/retrieve_command.h"
#include "app/run/photo_command.h"
#include "app/run/run_command.h"
#include "base/console.h"
#include "bench/bench_command.h"
#include "bench/compare_benches.h"
#include "cli/help.h"
#include "datasets/cad/families.h"
#include "datasets/generate_command.h"
#include "eval/budget/substitute_command.h"
#include "eval/compare_command.h"
#include "eval/eval_command.h"
#include "eval/report/report_command.h"
#include "io/build_info.h"

namespace armature {
namespace {

std::string VersionText() {
  const BuildInfo build = GetBuildInfo();
  return fmt::format("armature {} ({}{})", build.version, build.git_commit,
                     build.git_dirty ? ", modified" : "");
}

// Before or after the command. They take effect while the command line is parsed, before a command runs.
void AddGlobalOptions(CLI::App& program) {
  program.set_help_flag("-h,--help", "show this help");
  program.set_version_flag("--version", VersionText, "show version and commit");
  CLI::Option* quiet = program.add_flag_callback(
      "--quiet", [] { SetVerbosity(Verbosity::kQuiet); }, "only results and errors: no progress, no notes");
  program
      .add_flag_callback(
          "--verbose", [] { SetVerbosity(Verbosity::kVerbose); },
          "also say what is read, where settings come from and how long steps take")
      ->excludes(quiet);
  program.fallthrough();
}

}  // namespace

void AddCommands(CLI::App& program, int& exit_status) {
  AddGlobalOptions(program);
  program.require_subcommand(1);
  AddReproduceCommand(program, exit_status);
  AddGenerateCommand(program, exit_status);
  AddLearnCommand(program, SampleFamily, exit_status);
  AddRunCommand(program, exit_status);
  AddPhotoCommand(program, exit_status);
  AddRetrieveCommand(program, exit_status);
  AddEvalCommand(program, exit_status);
  AddCompareCommand(program, CompareBenches, exit_status);
  AddSubstituteCommand(program, exit_status);
  AddBenchCommand(program, exit_status);
  AddReportCommand(program, exit_status);
  AddPoseGraphCommand(program, exit_status);
  AddCompletionCommand(program, exit_status);
  DescribeProgram(program);
}

}  // namespace armature
