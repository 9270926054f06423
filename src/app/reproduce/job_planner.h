// SPDX-License-Identifier: BSD-3-Clause
// One job of a matrix: its calls, what they read and what they leave.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/reproduce/job.h"
#include "app/reproduce/matrix.h"

namespace armature {

inline constexpr const char* kLibraryFile = "library.armlib";

struct PlanFolders {
  std::filesystem::path results;  // where the calls are made; absolute
  std::filesystem::path configs;  // CONFIGS; absolute
  bool name_configs = false;      // the calls have to be told where it is
};

class JobPlanner {
 public:
  JobPlanner(const Matrix& matrix, const PlanFolders& folders)
      : matrix_(matrix), folders_(folders), sequences_(ListSequences(matrix)) {}

  Job Data(int draw) const;
  // How the edges of our CAD models lie is the category's padding: datasets/README.md.
  Job Category(const LearntCategory& category) const;
  Job Library() const;
  // Draws and renders one; what is there is not made again.
  Job Room(const MatrixSequence& room) const;
  // `jitter`: the seed of a repeat; 0: the run itself.
  Job Run(const Variant& variant, const MatrixSequence& sequence, int jitter = 0) const;
  Job Bench(const Timing& timing) const;
  // `runs`: folders of run folders.
  Job Evaluation(const std::string& folder, const std::vector<std::string>& runs,
                 const std::vector<std::string>& more) const;
  // True edges of one's own sequences.
  std::vector<std::string> CadArguments() const;
  // Truth and images.
  void AddSequences(Job& job) const;
  // With what all calls are told.
  std::vector<std::string> Call(std::vector<std::string> call) const;
  std::string CategoriesInput() const;

 private:
  // As it is written in the folder of results.
  std::string Here(const std::filesystem::path& path) const;
  bool IsRetrieved(const std::string& variant) const;
  void NeedCategories(Job& job) const;
  void AddRetrieval(const std::string& folder, Job& job) const;

  const Matrix& matrix_;
  const PlanFolders& folders_;
  std::vector<MatrixSequence> sequences_;
};

}  // namespace armature
