// SPDX-License-Identifier: BSD-3-Clause
#include "eval/trajectories/eval_trajectories.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "base/console.h"
#include "base/errors.h"
#include "base/text.h"
#include "cli/help.h"
#include "eval/trajectories/trajectory_tables.h"
#include "eval/trajectories/unmatched_stamps.h"
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
  check(std::isfinite(arguments.time_offset),
        fmt::format("--time-offset {:g}: give a number of seconds", arguments.time_offset));
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
  std::string why_unmatched;
  for (const TrajectoryOptions& o : options) {
    rows.push_back({run, trajectory, EvaluateTrajectory(estimate, truth, o), {}});
    if (!rows.back().IsUnmatched()) continue;
    if (why_unmatched.empty()) why_unmatched = ExplainUnmatched(estimate, truth, o.tolerance);
    rows.back().why_unmatched = why_unmatched;
  }
}

void TellRepeatedStamps(const fs::path& file, const TrajectoryFile& read) {
  if (read.repeated > 0) Note(DescribeRepeatedStamps(file, read));
}

// A run without odometry has a trajectory without poses.
std::vector<TimedPose> ReadRunTrajectory(const fs::path& file) {
  if (ReadTextLines(file).empty()) return {};
  TrajectoryFile read = ReadTrajectoryFile(file, {.format = TrajectoryFormat::kTum});
  TellRepeatedStamps(file, read);
  return std::move(read.poses);
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

TrajectoryFile ReadTruth(const std::vector<fs::path>& truth, const TrajectoryArguments& arguments) {
  if (truth.size() != 1) {
    throw InputError(
        fmt::format("--groundtruth: {} given; give one true trajectory to compare files with", truth.size()));
  }
  if (fs::is_directory(truth.front())) return {.poses = LoadTrueTrajectory(truth.front())};
  return ReadTrajectoryFile(truth.front(), MakeReading(arguments, RepeatedStamps::kKept));
}

// Where both files have numbers of lines for stamps, a line more or less moves all pairs after it.
void CheckEqualLength(const fs::path& file, const TrajectoryFile& estimate, const fs::path& truth,
                      const TrajectoryFile& true_poses) {
  const bool are_numbered = estimate.is_numbered && true_poses.is_numbered;
  if (!are_numbered || estimate.poses.size() == true_poses.poses.size()) return;
  throw InputError(fmt::format(
      "{}: has {} poses where {} has {}, and KITTI lines without stamps are paired by their number; give one "
      "line for each true one, or convert both to the TUM format with their stamps",
      file.string(), estimate.poses.size(), truth.string(), true_poses.poses.size()));
}

void Shift(std::vector<TimedPose>& poses, double seconds) {
  if (seconds == 0) return;
  for (TimedPose& pose : poses) pose.timestamp += seconds;
}

// Of files each that has no pair fails, of runs the whole where none has any: a matrix of many sequences is
// not to fail for one.
std::vector<std::string> FindFailures(
    const std::map<std::string, std::vector<NamedTrajectory>>& by_sequence) {
  std::vector<std::string> failures;
  bool is_any_matched = false, are_files = true;
  for (const auto& [sequence, rows] : by_sequence) {
    for (const NamedTrajectory& row : rows) {
      is_any_matched |= !row.evaluation.poses.empty();
      are_files &= row.trajectory == TrajectoryKind::kFile;
      const std::string failure = fmt::format("{}: {}", TrajectoryLabel(row), row.why_unmatched);
      const bool is_new = std::find(failures.begin(), failures.end(), failure) == failures.end();
      if (row.IsUnmatched() && is_new) failures.push_back(failure);
    }
  }
  if (are_files || !is_any_matched) return failures;
  for (const std::string& failure : failures) Note("warning: " + failure);
  return {};
}

std::string FormatName(const fs::path& truth) {
  const fs::path path = fs::absolute(truth).lexically_normal();
  return (path.has_filename() ? path : path.parent_path()).stem().string();
}

Evaluation Finished(const std::map<std::string, std::vector<NamedTrajectory>>& by_sequence,
                    const TrajectoryArguments& arguments, TableFormat format) {
  WriteRaw(arguments.raw, by_sequence);
  Evaluation made{.failures = FindFailures(by_sequence)};
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
  command.add_option("--time-offset", a.time_offset, "seconds added to the stamps of trajectory files")
      ->type_name("S")
      ->capture_default_str();
  command.add_option("--raw-trajectory", a.raw, "also write a row a matched pose to this file (CSV)")
      ->type_name("FILE");
}

Evaluation MakeRunTrajectoryTables(const std::vector<RunToEvaluate>& runs,
                                   const TrajectoryArguments& arguments, TableFormat format) {
  if (arguments.time_offset != 0) {
    throw InputError(
        "--time-offset: is for trajectory files, as a run has the stamps of its sequence; give its "
        "trajectory.txt and groundtruth.txt");
  }
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
  const TrajectoryFile true_poses = ReadTruth(truth, arguments);
  std::vector<NamedTrajectory> rows;
  for (const fs::path& file : files) {
    TrajectoryFile read = ReadTrajectoryFile(file, MakeReading(arguments, RepeatedStamps::kFirstKept));
    TellRepeatedStamps(file, read);
    CheckEqualLength(file, read, truth.front(), true_poses);
    Shift(read.poses, arguments.time_offset);
    AddRows(file.filename().string(), TrajectoryKind::kFile, read.poses, true_poses.poses, options, rows);
  }
  return Finished({{FormatName(truth.front()), rows}}, arguments, format);
}

}  // namespace armature
