// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "pipeline/object_views.h"
#include "support/category_examples.h"

namespace armature {
namespace {

const Camera kPlainCamera{640, 480, 500, 500, 320, 240, {}};
const Eigen::Vector3d kUpInCamera(0, -1, 0);

Detection InBox(const Box& box) {
  Detection detection;
  detection.category = "frame";
  detection.box = box;
  return detection;
}

Segment Level(double x1, double x2, double y) { return {{x1, y}, {x2, y}}; }

TEST(MakeView, HasTheSegmentsInAndCloseToTheBox) {
  const CategoryModel model = testing::FrameModel();
  Options options;
  options.lines.box_margin = 0.1;
  options.lines.min_length = 15;
  const std::vector<Segment> segments = {Level(220, 280, 150), Level(220, 230, 160), Level(195, 280, 199 + 9),
                                         Level(220, 280, 199 + 12)};
  const ObjectView view =
      MakeView(InBox({200, 100, 100, 100}), segments, kUpInCamera, kPlainCamera, model, options);
  ASSERT_EQ(view.segments.size(), 2) << "one is short, and one too far below";
  EXPECT_EQ(view.segments[0].p1.y(), 208) << "the longest first";
  EXPECT_EQ(view.segments[1].p1.y(), 150);
  EXPECT_EQ(view.camera, &kPlainCamera);
  EXPECT_EQ(view.model, &model);
  EXPECT_EQ(view.up_camera, kUpInCamera);
  EXPECT_TRUE(view.occluders.empty());
}

TEST(MakeView, NoMoreSegmentsThanAskedFor) {
  const CategoryModel model = testing::FrameModel();
  Options options;
  options.association.max_segments = 3;
  const std::vector<Segment> segments(10, Level(220, 280, 150));
  EXPECT_EQ(MakeView(InBox({200, 100, 100, 100}), segments, kUpInCamera, kPlainCamera, model, options)
                .segments.size(),
            3);
}

TEST(MakeView, SidesAtTheImagesBorderAreOpen) {
  const CategoryModel model = testing::FrameModel();
  const ObjectView view = MakeView(InBox({0, 100, 100, 379}), {}, kUpInCamera, kPlainCamera, model, {});
  EXPECT_EQ(view.sides, (BoxSides{BoxSide::kOpen, BoxSide::kSeen, BoxSide::kSeen, BoxSide::kOpen}));
}

// A lens that draws corners inwards: undistorted, the box is farther out and larger.
TEST(MakeView, TheBoxIsUndistorted) {
  const CategoryModel model = testing::FrameModel();
  Camera barrel = kPlainCamera;
  barrel.distortion[0] = -0.2;
  const Box box{450, 320, 120, 100};
  const ObjectView view = MakeView(InBox(box), {}, kUpInCamera, barrel, model, {});
  EXPECT_GT(view.detection.box.right(), box.right() + 5);
  EXPECT_GT(view.detection.box.width, box.width + 1);
  EXPECT_EQ(MakeView(InBox(box), {}, kUpInCamera, kPlainCamera, model, {}).detection.box.width, box.width);
}

}  // namespace
}  // namespace armature
