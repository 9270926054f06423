// SPDX-License-Identifier: BSD-3-Clause
// A micro-benchmark: one function of one stage on fixed inputs that are made in memory.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/harness.h"
#include "category/category_model.h"
#include "pipeline/object_estimator.h"

namespace armature {

// What the inputs are made from. Outlives the benchmarks, which point to the models.
struct MicroSetup {
  std::vector<CategoryModel> models;
  AssociationOptions association;
  ResectionOptions resection;
  std::vector<size_t> pose_graphs = {100, 500, 2500};    // poses, each
  std::vector<size_t> point_sets = {10'000, 1'000'000};  // points, each
};

struct MicroBenchmark {
  std::string family;               // "hypothesis"
  std::string variant;              // "chair": what it is run on
  std::string span;                 // what one call is; the same for the whole family
  std::function<Contender()> make;  // makes the inputs, unless they are big: those wait for Contender::start

  std::string name() const { return family + ":" + variant; }
};

// A contender of that name that calls the function; `run` makes `calls` calls.
inline Contender MicroContender(const std::string& name, double calls, std::function<void()> run) {
  return {.name = name,
          .every = 1,
          .start = {},
          .run =
              [run = std::move(run)](size_t) {
                run();
                return FrameOutcome{};
              },
          .calls = calls};
}

// The family for every model of the setup.
template <typename MakeContender>  // Contender(name, const CategoryModel&, const MicroSetup&)
void AddForEveryModel(const MicroSetup& setup, const std::string& family, const std::string& span,
                      MakeContender make_contender, std::vector<MicroBenchmark>& benchmarks) {
  for (const CategoryModel& model : setup.models) {
    const std::string name = family + ":" + model.spec.name;
    benchmarks.push_back(
        {family, model.spec.name, span, [=, &model, &setup] { return make_contender(name, model, setup); }});
  }
}

}  // namespace armature
