// SPDX-License-Identifier: BSD-3-Clause
// What is varied to see how times grow, and how much of it a frame has.
#include <gtest/gtest.h>

#include "bench/sections/load_variants.h"
#include "support/bench_fakes.h"
#include "support/synthetic_view.h"

namespace armature {
namespace {

// A frame with one object, as the pipeline hands it out.
FrameResult FrameOf(const ObjectView& view) {
  FrameResult frame;
  frame.segments = view.segments;
  frame.up_camera = *view.up_camera;
  frame.observations.resize(1);
  frame.observations[0].detection = view.detection;
  return frame;
}

TEST(ViewCounts, GrowWithTheSearchAndStopAtTheMostSegments) {
  const testing::SyntheticView synthetic("chair", 0.6, {0.2, 0.2, 2.2}, Eigen::Vector2d::Zero());
  const FrameResult frame = FrameOf(synthetic.view);
  Options options;
  const ViewCounts usual = CountViews(frame, synthetic.camera, {synthetic.model}, options);
  EXPECT_EQ(usual.segments, static_cast<double>(synthetic.view.segments.size()));
  options.association.max_segments = 3;
  options.association.hypotheses.azimuth_step_deg /= 4;
  const ViewCounts more = CountViews(frame, synthetic.camera, {synthetic.model}, options);
  EXPECT_EQ(more.segments, 3);
  EXPECT_GT(more.hypotheses, 2 * usual.hypotheses);
}

TEST(LoadVariants, ChangeOneThingEach) {
  BenchSequence sequence = testing::BoxSequence({1});
  sequence.frames[0].gray = cv::Mat(48, 64, CV_8UC1, cv::Scalar(7));
  const testing::SyntheticView synthetic("chair", 0.6, {0.2, 0.2, 2.2}, Eigen::Vector2d::Zero());
  const EngineParts parts{{}, {}, {synthetic.model}};
  std::deque<BenchSequence> resized;
  const auto searches = MakeVariants(Load::kHypotheses, sequence, parts, resized);
  EXPECT_EQ(searches[0].models[0].dictionary.size(), 1u);
  EXPECT_EQ(searches[3].models[0].dictionary.size(), synthetic.model.dictionary.size());
  EXPECT_EQ(searches[0].options.association.hypotheses.azimuth_spread_deg, 0);
  const auto segments = MakeVariants(Load::kSegments, sequence, parts, resized);
  EXPECT_EQ(segments[2].options.association.max_segments, 20);
  EXPECT_EQ(segments[2].name(), "segments: at most 20");
  EXPECT_EQ(segments[2].sequence, &sequence);
  EXPECT_TRUE(resized.empty());
  const auto sizes = MakeVariants(Load::kImageSize, sequence, parts, resized);
  ASSERT_EQ(sizes.size(), 4u);
  EXPECT_EQ(sizes[3].setting, "1920x1080");
  EXPECT_EQ(sizes[3].sequence->frames[0].gray.cols, 1920);
}

}  // namespace
}  // namespace armature
