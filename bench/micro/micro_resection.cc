// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <memory>

#include "bench/micro/micro_families.h"

namespace armature {
namespace {

constexpr size_t kMatchedLines = 14;  // that a solve has
constexpr int kSolves = 20;
constexpr int kAlternations = 5;

Contender ResectContender(const std::string& name, const CategoryModel& model, const MicroSetup& setup,
                          const ResectionOptions& resection) {
  const auto micro = std::make_shared<const MicroView>(model, kMicroSegments);
  const PoseAndShape start = micro->NearTruth();
  const std::vector<EdgeMatch> matches = MicroMatches(*micro, kMatchedLines, setup.association);
  return MicroContender(
      name, kSolves,
      [micro, start, matches, resection, projected = micro->Project(start), box = setup.association.box] {
        for (int i = 0; i < kSolves; ++i)
          Resect({micro->view, micro->view.sides, matches, projected, start, box, resection});
      });
}

Contender JointContender(const std::string& name, const CategoryModel& model, const MicroSetup& setup) {
  ResectionOptions joint = setup.resection;
  joint.mode = ResectionMode::kJoint;
  return ResectContender(name, model, setup, joint);
}

Contender AlternatingContender(const std::string& name, const CategoryModel& model, const MicroSetup& setup) {
  ResectionOptions alternating = setup.resection;
  alternating.mode = ResectionMode::kAlternating;
  alternating.alternations = kAlternations;
  return ResectContender(name, model, setup, alternating);
}

Contender ObjectContender(const std::string& name, const CategoryModel& model, const MicroSetup& setup) {
  const auto micro = std::make_shared<const MicroView>(model, kMicroSegments);
  return MicroContender(name, 1, [micro, association = setup.association, resection = setup.resection] {
    EstimateObject(micro->view, association, resection);
  });
}

}  // namespace

std::vector<EdgeMatch> MicroMatches(const MicroView& micro, size_t lines, const AssociationOptions& options) {
  std::vector<EdgeMatch> matches =
      MatchSegments(micro.Project(micro.truth), micro.view.segments, FinalGate(options)).matches;
  matches.resize(std::min(matches.size(), lines));
  return matches;
}

std::vector<MicroBenchmark> ResectionBenchmarks(const MicroSetup& setup) {
  std::vector<MicroBenchmark> benchmarks;
  AddForEveryModel(setup, "resection",
                   "one solve for pose and shape together from (at most) 14 matched lines and the box",
                   JointContender, benchmarks);
  AddForEveryModel(setup, "alternating", "the same by the paper's five turns of pose and shape",
                   AlternatingContender, benchmarks);
  AddForEveryModel(
      setup, "object",
      "one object whole: search, refinement, ambiguity, covariance; 60 segments, never seen before",
      ObjectContender, benchmarks);
  return benchmarks;
}

}  // namespace armature
