// SPDX-License-Identifier: BSD-3-Clause
#include "eval/trajectories/eval_trajectories.h"

#include <fmt/format.h>

#include <array>
#include <map>

#include "base/errors.h"
#include "base/text.h"
#include "cli/help.h"
#include "eval/trajectories/trajectory_tables.h"
#include "io/atomic_write.h"
#include "io/trajectory.h"
#include "truth/ground_truth.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

// Of a run folder, in the order of the rows.
constexpr std::array kTrajectories{TrajectoryKind::kTrajectory, TrajectoryKind::kOdometryScaled};

std::vector<TrajectoryOptions> MakeOptions(const TrajectoryArguments& arguments) {
  const auto check = [](bool holds, const std::string& message) {
    if (!holds) throw InputError(message);
  };
  check(arguments.first_n >= 1, fmt::format("--first-n {}: align by at least 1 pair", arguments.first_n));
  check(arguments.tolerance >= 0,
        fmt::format("--tolerance {:g}: give seconds, at least 0", arguments.tolerance));
  check(arguments.fps > 0, fmt::format("--fps {:g}: give poses a second, more than 0", arguments.fps));
  std::vector<TrajectoryOptions> options;
  for (const std::string& name : arguments.alignments) {
    options.push_back({.alignment = AlignmentFromName(name),
                       .first_n = arguments.first_n,
                       .tolerance = arguments.tolerance,
                       .delta = RelativeDeltaFromText(arguments.delta)});
  }
  return options;
}

// More where they cost nothing: a reader of these formats is a program.
int CountDigits(TableFormat format) {
  return format == TableFormat::kCsv || format == TableFormat::kJson ? 12 : 4;
}

void WriteRaw(const fs::path& file, const std::map<std::string, std::vector<NamedTrajectory>>& by_sequence) {
  if (file.empty()) return;
  std::string text = RawTrajectoryHeader();
  for (const auto& [sequence, trajectories] : by_sequence) {
    for (const NamedTrajectory& trajectory : trajectories) text += RawTrajectoryRows(sequence, trajectory);
  }
  AtomicWrite(file, text);
}

void AddRows(const std::string& run, TrajectoryKind trajectory, const std::vector<TimedPose>& estimate,
             const std::vector<TimedPose>& truth, const std::vector<TrajectoryOptions>& options,
             std::vector<NamedTrajectory>& rows) {
  for (const TrajectoryOptions& o : options) {
    rows.push_back({run, trajectory, EvaluateTrajectory(estimate, truth, o)});
  }
}

// A run without odometry has a trajectory without poses.
std::vector<TimedPose> ReadRunTrajectory(const fs::path& file) {
  return ReadTextLines(file).empty() ? std::vector<TimedPose>{} : ReadTumTrajectory(file);
}

std::vector<NamedTrajectory> EvaluateRuns(const std::vector<RunToEvaluate>& runs,
                                          const std::vector<TrajectoryOptions>& options) {
  const std::vector<TimedPose> truth = LoadTrueTrajectory(runs.front().truth);
  std::vector<NamedTrajectory> rows;
  for (const RunToEvaluate& run : runs) {
    for (const TrajectoryKind trajectory : kTrajectories) {
      const fs::path file = run.run.folder / (TrajectoryKindName(trajectory) + ".txt");
      if (trajectory != kTrajectories.front() && !fs::exists(file))
        continue;  // not written by `armature run`
      const auto estimate = ReadRunTrajectory(file);
      AddRows(run.name, trajectory, estimate, truth, options, rows);
    }
  }
  return rows;
}

TrajectoryReading MakeReading(const TrajectoryArguments& arguments, RepeatedStamps repeated) {
  TrajectoryReading reading{.format = TrajectoryFormatFromName(arguments.format), .repeated = repeated};
  if (!arguments.stamps.empty()) reading.stamps = ReadStamps(arguments.stamps);
  reading.rate = arguments.fps;
  return reading;
}

std::vector<TimedPose> ReadTruth(const std::vector<fs::path>& truth, const TrajectoryArguments& arguments) {
  if (truth.size() != 1) {
    throw InputError(
        fmt::format("--groundtruth: {} given; give one true trajectory to compare files with", truth.size()));
  }
  if (fs::is_directory(truth.front())) return LoadTrueTrajectory(truth.front());
  return ReadTrajectory(truth.front(), MakeReading(arguments, RepeatedStamps::kKept));
}

std::string FormatName(const fs::path& truth) {
  const fs::path path = fs::absolute(truth).lexically_normal();
  return (path.has_filename() ? path : path.parent_path()).stem().string();
}

Evaluation Finished(const std::map<std::string, std::vector<NamedTrajectory>>& by_sequence,
                    const TrajectoryArguments& arguments, TableFormat format) {
  WriteRaw(arguments.raw, by_sequence);
  Evaluation made;
  for (const auto& [sequence, rows] : by_sequence) {
    made.tables.push_back(TrajectoryTable(sequence, rows, CountDigits(format)));
    for (const NamedTrajectory& row : rows)
      made.records.trajectories.push_back(MakeTrajectoryRecord(sequence, row));
  }
  return made;
}

}  // namespace

void AddTrajectoryArguments(CLI::App& command, TrajectoryArguments& a) {
  BeginSection(command, "Trajectories");
  KnownValues(
      *command
           .add_option("--alignment", a.alignments, "how trajectories are brought to the truth, a row each")
           ->type_name("NAME")
           ->delimiter(','),
      AlignmentNames())
      .capture_default_str();
  command.add_option("--first-n", a.first_n, "pairs that the alignment first_n looks at")
      ->capture_default_str();
  command.add_option("--tolerance", a.tolerance, "seconds between the stamps of a pair of poses, at most")
      ->capture_default_str();
  command
      .add_option("--rpe-delta", a.delta,
                  "distance of the poses of the relative error: 10f (poses), 1s, 0.5m")
      ->capture_default_str();
  KnownValues(*command.add_option("--trajectory-format", a.format, "of trajectory files")->type_name("NAME"),
              {"auto", "tum", "kitti", "euroc"})
      .capture_default_str();
  command.add_option("--stamps", a.stamps, "stamps of trajectory files in the KITTI format, one a line")
      ->type_name("FILE");
  command.add_option("--fps", a.fps, "poses a second of KITTI files without stamps")->capture_default_str();
  command.add_option("--raw-trajectory", a.raw, "also write a row a matched pose to this file (CSV)")
      ->type_name("FILE");
}

Evaluation MakeRunTrajectoryTables(const std::vector<RunToEvaluate>& runs,
                                   const TrajectoryArguments& arguments, TableFormat format) {
  const std::vector<TrajectoryOptions> options = MakeOptions(arguments);
  std::map<std::string, std::vector<RunToEvaluate>> runs_of;
  for (const RunToEvaluate& run : runs) runs_of[run.run.sequence].push_back(run);
  std::map<std::string, std::vector<NamedTrajectory>> by_sequence;
  for (const auto& [sequence, its_runs] : runs_of) {
    by_sequence[sequence] = EvaluateRuns(its_runs, options);
  }
  return Finished(by_sequence, arguments, format);
}

Evaluation MakeFileTrajectoryTables(const std::vector<fs::path>& files, const std::vector<fs::path>& truth,
                                    const TrajectoryArguments& arguments, TableFormat format) {
  const std::vector<TrajectoryOptions> options = MakeOptions(arguments);
  const std::vector<TimedPose> true_poses = ReadTruth(truth, arguments);
  std::vector<NamedTrajectory> rows;
  for (const fs::path& file : files) {
    const auto estimate = ReadTrajectory(file, MakeReading(arguments, RepeatedStamps::kRejected));
    AddRows(file.filename().string(), TrajectoryKind::kFile, estimate, true_poses, options, rows);
  }
  return Finished({{FormatName(truth.front()), rows}}, arguments, format);
}

}  // namespace armature
