// SPDX-License-Identifier: BSD-3-Clause
// One structure of the index on one library: what it costs and what it finds.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/statistics.h"
#include "bench/harness.h"
#include "bench/retrieval/synthetic_library.h"
#include "retrieval/instance_index.h"

namespace armature {

// Neighbours of a query, and queries before those that count.
inline constexpr int kRetrieved = 5;
inline constexpr size_t kRetrievalWarmUp = 20;

// The neighbours of each query.
using Answers = std::vector<std::vector<Neighbour>>;

struct IndexCosts {
  double build_ms = 0, save_ms = 0, load_ms = 0;  // once each, load: the last one
  double memory_mb = 0, file_mb = 0;              // 2^20 bytes
};

// "linear", "kdtree_single", "kdtree:128", "kmeans:128": with the checks where they matter.
std::string ContenderName(const IndexMethod& method);

// A structure that was built and saved to a file of the system's folder for such files, which is there as
// long as this.
class SavedStructure {
 public:
  // Outlived by the features.
  SavedStructure(const Eigen::MatrixXf& features, const IndexMethod& method);
  ~SavedStructure();
  SavedStructure(const SavedStructure&) = delete;
  SavedStructure& operator=(const SavedStructure&) = delete;

  // The method may have other checks than that of building. Adds to the costs.
  InstanceIndex Load(const IndexMethod& method);

  const IndexCosts& costs() const { return costs_; }

 private:
  const Eigen::MatrixXf& features_;
  std::filesystem::path file_;
  IndexCosts costs_;
};

// The first queries, one after the other, a row each; the answers of all of them, also of the warm-up.
std::vector<BenchRow> RaceQueries(const InstanceIndex& index, const Eigen::MatrixXf& queries, size_t count,
                                  const std::string& contender, Answers& answers);

Answers CollectAnswers(const InstanceIndex& index, const Eigen::MatrixXf& queries);

// Share of the true neighbours that are among those found, of the queries that were answered.
double Recall(const Answers& found, const Answers& truth);

}  // namespace armature
