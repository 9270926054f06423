// SPDX-License-Identifier: BSD-3-Clause
#include "io/run_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/errors.h"
#include "base/microseconds.h"
#include "io/csv.h"
#include "io/json_fields.h"
#include "io/json_file.h"
#include "io/output_folder.h"
#include "io/run_folder.h"
#include "io/trajectory.h"

namespace armature {
namespace {

constexpr const char* kRunAgain = "run `armature run` again";

constexpr int kMostDetections = 100'000;  // of the detections of an image

using Key = std::pair<long long, int>;

const std::vector<std::string> kPose = {"tx", "ty", "tz", "qx", "qy", "qz", "qw"};

Key MakeKey(double timestamp, int index) { return {Microseconds(timestamp), index}; }

void ReadSummary(const std::filesystem::path& file, RunIdentity& run) {
  const auto json = ReadJsonObject(file, kRunAgain);
  if (!json.contains("sequence"))
    throw InputError(fmt::format("{}: names no sequence; {}", file.string(), kRunAgain));
  try {
    run.sequence = JsonField<std::string>(json, "sequence");
    run.sequence_folder = JsonFieldOr<std::string>(json, "sequence_folder", "");
    run.jitter = JsonFieldOr(json, "jitter", 0);
    run.detections = JsonFieldOr<std::string>(json, "detections", "");
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}; {}", file.string(), error.what(), kRunAgain));
  }
}

std::optional<Eigen::Isometry3d> ReadPoseIfAny(const CsvRow& row) {
  const auto empty =
      std::count_if(kPose.begin(), kPose.end(), [&](const std::string& c) { return row.IsEmpty(c); });
  if (empty == static_cast<std::ptrdiff_t>(kPose.size())) return std::nullopt;
  if (empty != 0) throw InputError(row.At("the pose is incomplete; give all of tx..qw, or none"));
  return ReadPose(row);
}

void ReadObservations(const std::filesystem::path& file, RunResults& run) {
  std::vector<std::string> columns = {"timestamp", "index", "status"};
  columns.insert(columns.end(), kPose.begin(), kPose.end());
  const CsvTable table(file, columns);
  for (const CsvRow& row : table.rows()) {
    RunObservation observation{
        row.Number("timestamp"), row.Integer("index"), row.Text("status"), ReadPoseIfAny(row), {}, ""};
    if (table.HasColumn("object")) observation.object = row.Text("object");
    if (table.HasColumn("shape"))
      observation.shape = ParseNumbers(row.Text("shape"), row.At("column 'shape'"));
    observation.probability = ReadProbabilityIfAny(table, row);
    if (observation.index < 0 || observation.index > kMostDetections)
      throw InputError(
          row.At(fmt::format("index {} of an image's detections; {}", observation.index, kRunAgain)));
    const Key key = MakeKey(observation.timestamp, observation.index);
    if (!run.observations.emplace(key, std::move(observation)).second) {
      throw InputError(row.At("this timestamp and index occur twice; keep one row"));
    }
  }
}

void ReadAssociations(const std::filesystem::path& file, RunResults& run) {
  const CsvTable table(
      file, {"timestamp", "index", "edge", "segment_x1", "segment_y1", "segment_x2", "segment_y2"});
  for (const CsvRow& row : table.rows()) {
    const auto found = run.observations.find(MakeKey(row.Number("timestamp"), row.Integer("index")));
    if (found == run.observations.end()) {
      throw InputError(
          row.At("observations.csv has no row of this timestamp and index; the files are of two runs"));
    }
    const Segment segment{{row.Number("segment_x1"), row.Number("segment_y1")},
                          {row.Number("segment_x2"), row.Number("segment_y2")}};
    found->second.matches.push_back({row.Text("edge"), segment});
  }
}

}  // namespace

const RunObservation* RunResults::Find(double timestamp, int index) const {
  const long long at = Microseconds(timestamp);
  const long long tolerance = Microseconds(kStampTolerance);
  for (auto it = observations.lower_bound({at - tolerance, 0});
       it != observations.end() && it->first.first <= at + tolerance; ++it) {
    if (it->first.second == index) return &it->second;
  }
  return nullptr;
}

RunIdentity IdentifyRun(const std::filesystem::path& folder) {
  if (!IsCompleteRun(folder)) {
    throw InputError(
        fmt::format("{}: is not a finished run: it has no summary.json that says \"complete\": true; run "
                    "`armature run` again",
                    folder.string()));
  }
  RunIdentity run;
  run.folder = folder;
  ReadSummary(folder / "summary.json", run);
  return run;
}

RunResults LoadRun(const std::filesystem::path& folder) {
  const RunIdentity identity = IdentifyRun(folder);
  RunResults run;
  run.folder = identity.folder;
  run.sequence = identity.sequence;
  run.sequence_folder = identity.sequence_folder;
  run.detections = identity.detections;
  ReadObservations(folder / "observations.csv", run);
  ReadAssociations(folder / "associations.csv", run);
  return run;
}

std::vector<std::filesystem::path> RunsIn(const std::filesystem::path& folder) {
  if (IsCompleteRun(folder)) return {folder};
  std::vector<std::filesystem::path> runs;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    if (!IsPartial(entry.path()) && IsCompleteRun(entry.path())) runs.push_back(entry.path());
  }
  if (runs.empty()) {
    throw InputError(
        fmt::format("{}: is not a finished run and has none in it; give a folder that `armature run` wrote",
                    folder.string()));
  }
  std::sort(runs.begin(), runs.end());
  return runs;
}

}  // namespace armature
