// SPDX-License-Identifier: BSD-3-Clause
// Our pipeline as an engine, stage by stage.
#pragma once

#include <memory>
#include <vector>

#include "bench/engine.h"
#include "category/category_model.h"
#include "pipeline/options.h"

namespace armature {

// The pipeline for a sequence, as `armature run` sets it up.
std::unique_ptr<FramePipeline> MakePipeline(const Options& options, const std::vector<CategoryModel>& models,
                                            const BenchSequence& sequence);

class LinesEngine : public Engine {
 public:
  LinesEngine(Options options, std::vector<CategoryModel> models);

  std::string Description() const override;
  bool IsStateless() const override { return false; }
  void Start(const BenchSequence& sequence) override;
  FrameOutcome Process(const BenchFrame& frame) override;

  // The last frame's; its estimates are in the outcome. Requires one.
  const FrameResult& last() const { return last_; }
  const Options& options() const { return options_; }
  const std::vector<CategoryModel>& models() const { return models_; }

 private:
  Options options_;
  std::vector<CategoryModel> models_;
  std::unique_ptr<FramePipeline> pipeline_;  // of the sequence that was started
  FrameResult last_;
};

}  // namespace armature
