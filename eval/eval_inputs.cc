// SPDX-License-Identifier: BSD-3-Clause
#include "eval/eval_inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/errors.h"
#include "io/sequence.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

bool HasGroundTruth(const fs::path& folder) {
  return fs::exists(folder / "sequence.yaml") &&
         (fs::exists(folder / "objects_gt.csv") || fs::exists(folder / "groundtruth.txt"));
}

// The folder itself, or the sequences directly inside it.
std::vector<fs::path> SequencesAt(const fs::path& folder) {
  std::vector<fs::path> sequences;
  std::error_code absent;
  if (!HasGroundTruth(folder)) {
    for (const auto& entry : fs::directory_iterator(folder, absent)) {
      if (HasGroundTruth(entry.path())) sequences.push_back(entry.path());
    }
  }
  if (sequences.empty()) sequences.push_back(folder);
  std::sort(sequences.begin(), sequences.end());
  return sequences;
}

std::map<std::string, fs::path> FoldersByName(const std::vector<fs::path>& truths) {
  std::map<std::string, fs::path> folders;
  for (const fs::path& truth : truths) {
    for (const fs::path& sequence : SequencesAt(truth)) {
      const std::string name = ReadSequenceSettings(sequence / "sequence.yaml").name;
      if (!folders.emplace(name, sequence).second) {
        throw InputError(fmt::format("{}: a second sequence named '{}'; give one", sequence.string(), name));
      }
    }
  }
  return folders;
}

fs::path FindTruth(const RunIdentity& run, const std::map<std::string, fs::path>& given) {
  if (const auto found = given.find(run.sequence); found != given.end()) return found->second;
  if (given.empty() && !run.sequence_folder.empty()) return run.sequence_folder;
  throw InputError(
      fmt::format("{}: is a run of sequence '{}', whose ground truth is not known; give its folder with "
                  "--groundtruth",
                  run.folder.string(), run.sequence));
}

}  // namespace

bool RunToEvaluate::HasTruth(const std::string& file) const { return fs::exists(truth / file); }

bool RunToEvaluate::HasResult(const std::string& file) const { return fs::exists(run.folder / file); }

std::vector<RunToEvaluate> FindRuns(const std::vector<fs::path>& folders,
                                    const std::vector<fs::path>& truths) {
  const std::map<std::string, fs::path> given = FoldersByName(truths);
  std::vector<RunToEvaluate> runs;
  for (const fs::path& folder : folders) {
    for (const fs::path& run : RunsIn(folder)) {
      runs.push_back({IdentifyRun(run), {}});
      runs.back().truth = FindTruth(runs.back().run, given);
    }
  }
  return runs;
}

}  // namespace armature
