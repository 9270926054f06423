// SPDX-License-Identifier: BSD-3-Clause
#include "eval/eval_inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/errors.h"
#include "eval/budget/substitution.h"
#include "io/output_folder.h"
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
      if (!IsPartial(entry.path()) && HasGroundTruth(entry.path())) sequences.push_back(entry.path());
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

// The runs on a sequence are compared with one truth, or with what was made of it.
void CheckSameTruth(const std::vector<const RunToEvaluate*>& runs, RunsOfASequence common) {
  const auto place = [&](const RunToEvaluate& run) {
    return common == RunsOfASequence::kOfOneOrigin ? OriginOfSequence(run.truth)
                                                   : fs::weakly_canonical(run.truth);
  };
  const RunToEvaluate& first = *runs.front();
  for (const RunToEvaluate* run : runs) {
    if (place(*run) == place(first)) continue;
    throw InputError(fmt::format(
        "{}: is a run of another sequence '{}' ({}) than {} ({}); give the names in their sequence.yaml, or "
        "the one true folder with --groundtruth",
        run->run.folder.string(), first.run.sequence, run->truth.string(), first.run.folder.string(),
        first.truth.string()));
  }
}

void NameRuns(std::vector<RunToEvaluate>& runs, RunsOfASequence common) {
  std::map<std::string, std::vector<RunToEvaluate*>> of_sequence;
  for (RunToEvaluate& run : runs) of_sequence[run.run.sequence].push_back(&run);
  for (const auto& [sequence, its_runs] : of_sequence) {
    CheckSameTruth({its_runs.begin(), its_runs.end()}, common);
    std::vector<fs::path> folders;
    for (const RunToEvaluate* run : its_runs) folders.push_back(run->run.folder);
    const std::vector<std::string> names = RunNames(folders, sequence);
    for (size_t i = 0; i < names.size(); ++i) its_runs[i]->name = names[i];
  }
}

}  // namespace

bool RunToEvaluate::HasTruth(const std::string& file) const { return fs::exists(truth / file); }

bool RunToEvaluate::HasResult(const std::string& file) const { return fs::exists(run.folder / file); }

std::vector<RunToEvaluate> FindRuns(const std::vector<fs::path>& folders, const std::vector<fs::path>& truths,
                                    RunsOfASequence common) {
  const std::map<std::string, fs::path> given = FoldersByName(truths);
  std::vector<RunToEvaluate> runs;
  for (const fs::path& folder : folders) {
    for (const fs::path& run : RunsIn(folder)) {
      runs.push_back({.run = IdentifyRun(run), .truth = {}});
      runs.back().truth = FindTruth(runs.back().run, given);
      if (run != folder) runs.back().within = folder;
    }
  }
  NameRuns(runs, common);
  return runs;
}

std::vector<std::string> RunNames(const std::vector<fs::path>& folders, const std::string& sequence) {
  std::vector<std::string> names;
  for (const fs::path& folder : folders) {
    fs::path path = folder.lexically_normal();
    if (!path.has_filename()) path = path.parent_path();
    if (path.filename() == sequence && path.parent_path().has_filename()) path = path.parent_path();
    names.push_back(path.filename().string());
  }
  if (std::set<std::string>(names.begin(), names.end()).size() == names.size()) return names;
  names.clear();
  for (const fs::path& folder : folders) names.push_back(folder.string());
  return names;
}

std::vector<EvaluatedRunRecord> MakeRunRecords(const std::vector<RunToEvaluate>& runs) {
  std::vector<EvaluatedRunRecord> records;
  for (const RunToEvaluate& run : runs)
    records.push_back({run.run.folder.lexically_normal().string(), run.run.sequence, run.name});
  return records;
}

}  // namespace armature
