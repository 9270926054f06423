// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <memory>

#include "bench/micro/micro_families.h"
#include "geometry/rotation.h"

namespace armature {
namespace {

constexpr size_t kMatchingSegments = 80;  // the most that association takes
constexpr int kMatchingCalls = 500;
constexpr int kHypothesesCalls = 20;

std::shared_ptr<const MicroView> SharedView(const CategoryModel& model, size_t segments) {
  return std::make_shared<const MicroView>(model, segments);
}

std::vector<Hypothesis> MakeMicroHypotheses(const MicroView& micro, const AssociationOptions& options) {
  return MakeHypotheses(micro.view, micro.dictionary, options.box, options.hypotheses);
}

Contender HypothesisContender(const std::string& name, const CategoryModel& model, const MicroSetup& setup) {
  const auto micro = SharedView(model, kMicroSegments);
  const std::vector<Hypothesis> hypotheses = MakeMicroHypotheses(*micro, setup.association);
  return MicroContender(name, static_cast<double>(hypotheses.size()),
                        [micro, hypotheses, options = setup.association] {
                          ProjectedWireframe scratch;
                          for (const Hypothesis& h : hypotheses) HypothesisCost(*micro, h, options, scratch);
                        });
}

Contender HypothesesContender(const std::string& name, const CategoryModel& model, const MicroSetup& setup) {
  const auto micro = SharedView(model, kMicroSegments);
  const size_t made = MakeMicroHypotheses(*micro, setup.association).size();
  return MicroContender(name, static_cast<double>(made * kHypothesesCalls),
                        [micro, options = setup.association] {
                          for (int i = 0; i < kHypothesesCalls; ++i) MakeMicroHypotheses(*micro, options);
                        });
}

Contender MatchingContender(const std::string& name, const CategoryModel& model, const MicroSetup& setup) {
  const auto micro = SharedView(model, kMatchingSegments);
  const MatchGate gate = SearchGate(micro->view, setup.association);
  return MicroContender(name, kMatchingCalls, [micro, gate, projected = micro->Project(micro->truth)] {
    for (int i = 0; i < kMatchingCalls; ++i) MatchSegments(projected, micro->view.segments, gate);
  });
}

}  // namespace

MatchGate SearchGate(const ObjectView& view, const AssociationOptions& options) {
  const double diagonal = std::hypot(view.detection.box.width, view.detection.box.height);
  return {std::max(options.final_gate_pixels, options.search_gate * diagonal), kSearchAngleDeg * kDegree};
}

MatchGate FinalGate(const AssociationOptions& options) {
  return {options.final_gate_pixels, kFinalAngleDeg * kDegree};
}

double HypothesisCost(const MicroView& micro, const Hypothesis& hypothesis, const AssociationOptions& options,
                      ProjectedWireframe& scratch) {
  const ObjectView& view = micro.view;
  const CategorySpec& spec = micro.model.spec;
  const Wireframe& wireframe = micro.dictionary[static_cast<size_t>(hypothesis.dictionary_index)];
  const Eigen::Isometry3d& T = hypothesis.start.T_camera_object;
  ProjectSeenEdges(micro.camera, spec, wireframe, T,
                   ClipBox(view.detection.box, hypothesis.sides, micro.camera), scratch);
  const double prior =
      PriorCost(view, hypothesis.start, wireframe, hypothesis.sides, scratch, options.box, options.coverage);
  DetermineVisibility(micro.camera, spec, wireframe, T, view.occluders, scratch);
  const double covered = CoveredLength(scratch, view.segments, SearchGate(view, options));
  return prior + LineCost(scratch, covered);
}

std::vector<MicroBenchmark> AssociationBenchmarks(const MicroSetup& setup) {
  std::vector<MicroBenchmark> benchmarks;
  AddForEveryModel(
      setup, "hypothesis",
      "the cost of one hypothesis with 60 segments, nothing pruned: projection, cost without lines, "
      "visibility, explained length",
      HypothesisContender, benchmarks);
  AddForEveryModel(setup, "hypotheses", "making all hypotheses of a view, divided by their number",
                   HypothesesContender, benchmarks);
  AddForEveryModel(setup, "matching", "giving each of 80 segments to the edge that it explains best",
                   MatchingContender, benchmarks);
  return benchmarks;
}

}  // namespace armature
