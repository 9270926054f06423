// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "category/normalise.h"
#include "support/category_examples.h"
#include "support/expect_input_error.h"

namespace armature {
namespace {

using testing::ExpectInputError;
using testing::FrameSpec;
using testing::FrameWireframe;

Wireframe Scaled(Wireframe wireframe, double scale, const Eigen::Vector3d& offset) {
  wireframe.midpoints = (scale * wireframe.midpoints).colwise() + offset;
  wireframe.directions *= scale;
  return wireframe;
}

TEST(Normalise, UndoesScaleAndOffset) {
  const Wireframe moved = Scaled(FrameWireframe(), 17, {3, -2, 5});
  const Wireframe back = Normalised(FrameSpec().category.reference, moved);
  EXPECT_LT((ShapeVector(back) - ShapeVector(FrameWireframe())).norm(), 1e-12);
}

TEST(Normalise, HeightIsMeasuredFromTheLowestEnd) {
  Wireframe wireframe = FrameWireframe();
  wireframe.directions.col(0) = Eigen::Vector3d(0, -3, 0);  // hangs 1.5 below the bar
  const MetricReference reference{MetricReference::Measure::kHeightAboveGround, {2}, 0.45};
  EXPECT_DOUBLE_EQ(Measure(reference, wireframe), 1.5);
  EXPECT_DOUBLE_EQ(Measure(reference, Normalised(reference, wireframe)), 0.45);
}

TEST(Normalise, CentresTheBoundingBox) {
  const Wireframe centred = Centred(Scaled(FrameWireframe(), 1, {1, 2, 3}));
  EXPECT_LT(BoundingBoxCenter(centred).norm(), 1e-15);
}

TEST(Normalise, RefusesAReferenceWithoutHeight) {
  const MetricReference reference{MetricReference::Measure::kHeightAboveGround, {2}, 0.45};
  ExpectInputError([&] { Normalised(reference, FrameWireframe()); }, {"measures 0", "y is up"});
}

TEST(Mirror, SwapsLeftAndRightAndKeepsSenses) {
  Wireframe wireframe = FrameWireframe();
  wireframe.midpoints.col(0) = Eigen::Vector3d(-0.8, 0.1, 0);  // left post further out
  wireframe.directions.col(2) = Eigen::Vector3d(1, 0.2, 0);    // bar rises to the right
  const Wireframe mirrored = Mirrored(FrameSpec().category, wireframe);
  EXPECT_EQ(mirrored.midpoints.col(1), Eigen::Vector3d(0.8, 0.1, 0));
  EXPECT_EQ(mirrored.midpoints.col(0), Eigen::Vector3d(-0.5, 0, 0));
  EXPECT_EQ(mirrored.directions.col(1), Eigen::Vector3d(0, 0, 1));
  EXPECT_EQ(mirrored.directions.col(2), Eigen::Vector3d(1, -0.2, 0));  // still left to right, now falling
  const Wireframe twice = Mirrored(FrameSpec().category, mirrored);
  EXPECT_EQ(ShapeVector(twice), ShapeVector(wireframe));
}

TEST(Mirror, NeedsThePartner) {
  CategorySpec spec = FrameSpec().category;
  spec.edge_names[1] = "other";
  ExpectInputError([&] { Mirrored(spec, FrameWireframe()); }, {"'left'", "'right'", "training.mirrored"});
}

}  // namespace
}  // namespace armature
