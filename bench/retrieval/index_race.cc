// SPDX-License-Identifier: BSD-3-Clause
#include "bench/retrieval/index_race.h"

#include <fmt/format.h>
#include <unistd.h>  // NOLINT: getpid is POSIX

#include <algorithm>
#include <optional>

#include "base/interrupt.h"
#include "base/stage_clock.h"
#include "io/index_file.h"

namespace armature {
namespace {

namespace fs = std::filesystem;

constexpr double kMegabyte = 1 << 20;

}  // namespace

std::string ContenderName(const IndexMethod& method) {
  const std::string name = ToName(method.kind);
  return IsExact(method) ? name : fmt::format("{}:{}", name, method.checks);
}

SavedStructure::SavedStructure(const Eigen::MatrixXf& features, const IndexMethod& method)
    : features_(features),
      file_(fs::temp_directory_path() / fmt::format("armature-bench-{}.index", getpid())) {
  Eigen::MatrixXf given = features;
  std::optional<InstanceIndex> built;
  {
    const StageClock clock(costs_.build_ms);
    built.emplace(std::move(given), method);
  }
  {
    const StageClock clock(costs_.save_ms);
    WriteIndex(*built, file_);
  }
  costs_.memory_mb = static_cast<double>(built->memory_bytes()) / kMegabyte;
  costs_.file_mb = static_cast<double>(fs::file_size(file_)) / kMegabyte;
}

SavedStructure::~SavedStructure() {
  std::error_code ignored;
  fs::remove(file_, ignored);
}

InstanceIndex SavedStructure::Load(const IndexMethod& method) {
  Eigen::MatrixXf given = features_;
  costs_.load_ms = 0;
  const StageClock clock(costs_.load_ms);
  return ReadIndex(file_, std::move(given), method);
}

std::vector<BenchRow> RaceQueries(const InstanceIndex& index, const Eigen::MatrixXf& queries, size_t count,
                                  const std::string& contender, Answers& answers) {
  answers.assign(count, {});
  std::vector<Eigen::VectorXf> asked;
  for (size_t i = 0; i < count; ++i) asked.emplace_back(queries.col(static_cast<Eigen::Index>(i)));
  Contender single{.name = contender, .every = 1, .start = {}, .run = [&](size_t i) {
                     answers[i] = index.Nearest(asked[i], kRetrieved);
                     return FrameOutcome{};
                   }};
  return RunInterleaved({single}, count, {.warm_up = kRetrievalWarmUp, .repetitions = 1});
}

Answers CollectAnswers(const InstanceIndex& index, const Eigen::MatrixXf& queries) {
  Answers answers;
  for (const auto& query : queries.colwise()) {
    ThrowIfInterrupted();
    answers.push_back(index.Nearest(query, kRetrieved));
  }
  return answers;
}

double Recall(const Answers& found, const Answers& truth) {
  size_t hits = 0, all = 0;
  for (size_t i = 0; i < found.size(); ++i) {
    all += truth[i].size();
    for (const Neighbour& neighbour : found[i])
      hits += static_cast<size_t>(std::count(truth[i].begin(), truth[i].end(), neighbour));
  }
  return static_cast<double>(hits) / static_cast<double>(all);
}

}  // namespace armature
