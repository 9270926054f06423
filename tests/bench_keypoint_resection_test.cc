// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "bench/keypoints/keypoint_resection.h"
#include "geometry/rotation.h"
#include "support/category_examples.h"
#include "support/synthetic_view.h"

namespace armature {
namespace {

using testing::SyntheticView;

// A left and a right post and a bar that begins `gap` metres beside the left one's end; one mode, in which
// the bar's beginning moves along x.
CategoryModel FrameWithGap(double gap) {
  CategoryModel model;
  model.spec = testing::FrameSpec().category;
  Wireframe wireframe = testing::FrameWireframe();
  wireframe.midpoints.col(2).x() += gap / 2;
  wireframe.directions.col(2).x() -= gap;
  model.mean = ShapeVector(wireframe);
  model.basis = Eigen::MatrixXd::Zero(18, 1);
  model.basis(12, 0) = 0.5;
  model.basis(15, 0) = -1;
  model.standard_deviations = Eigen::VectorXd::Constant(1, 0.1);
  return model;
}

TEST(KeypointResection, EndsThatMeetAreOneKeypoint) {
  EXPECT_EQ(MakeKeypoints(FrameWithGap(0)).size(), 4u);
  EXPECT_EQ(MakeKeypoints(FrameWithGap(0.019)).size(), 4u);
  EXPECT_EQ(MakeKeypoints(FrameWithGap(0.021)).size(), 5u);
}

TEST(KeypointResection, AKeypointIsTheMeanOfItsEnds) {
  const ShapePoint corner = MakeKeypoints(FrameWithGap(0.01)).front();
  EXPECT_LT((corner.X0 - Eigen::Vector3d(-0.495, 0, -0.5)).norm(), 1e-12);
  EXPECT_NEAR(corner.G(0, 0), 0.05, 1e-12);  // half of its ends move by 0.1
}

std::vector<SeenKeypoint> SeeAll(const SyntheticView& synthetic, const std::vector<ShapePoint>& keypoints) {
  std::vector<SeenKeypoint> seen;
  seen.reserve(keypoints.size());
  const Eigen::Matrix3Xd points = KeypointsAt(keypoints, synthetic.truth);
  for (int i = 0; i < points.cols(); ++i) seen.push_back({i, synthetic.camera.Project(points.col(i))});
  return seen;
}

double ReprojectionError(const SyntheticView& synthetic, const std::vector<ShapePoint>& keypoints,
                         const PoseAndShape& estimate) {
  double largest = 0;
  const Eigen::Matrix3Xd points = KeypointsAt(keypoints, estimate);
  for (const SeenKeypoint& keypoint : SeeAll(synthetic, keypoints)) {
    largest =
        std::max(largest, (synthetic.camera.Project(points.col(keypoint.keypoint)) - keypoint.pixel).norm());
  }
  return largest;
}

void ExpectNear(const PoseAndShape& estimate, const PoseAndShape& truth, double degrees, double metres) {
  const Eigen::Matrix3d R = estimate.T_camera_object.linear() * truth.T_camera_object.linear().transpose();
  EXPECT_LT(LogSO3(R).norm() / kDegree, degrees);
  EXPECT_LT((estimate.T_camera_object.translation() - truth.T_camera_object.translation()).norm(), metres);
}

ResectionOptions NothingButWhatIsSeen() {
  ResectionOptions options;
  options.shape_weight = 1e-3;
  options.max_iterations = 50;
  return options;
}

TEST(KeypointResection, ExactKeypointsGivePoseAndShape) {
  const SyntheticView synthetic("chair", 0.5, {0.2, 0.3, 2.5}, Eigen::Vector3d(0.8, -0.6, 0.4));
  const std::vector<ShapePoint> keypoints = MakeKeypoints(synthetic.model);
  const ResectionResult result = ResectKeypoints(synthetic.view, keypoints, SeeAll(synthetic, keypoints),
                                                 PoseFromBox(synthetic.view), NothingButWhatIsSeen());
  EXPECT_TRUE(result.finite());
  ExpectNear(result.estimate, synthetic.truth, 0.1, 0.005);
  EXPECT_LT((result.estimate.coefficients - synthetic.truth.coefficients).norm(), 0.1);
  EXPECT_LT(ReprojectionError(synthetic, keypoints, result.estimate), 0.05);
}

class KeypointResectionOf : public ::testing::TestWithParam<std::string> {};

// Of the mean shape, which the regulariser prefers: one picture does not tell a larger table from a nearer
// one.
TEST_P(KeypointResectionOf, ExactKeypointsOfTheMeanShapeGiveThePose) {
  SyntheticView synthetic(GetParam(), 0.5, {0.2, 0.3, 2.5}, Eigen::Vector3d::Zero());
  synthetic.view.detection.azimuth = 0.5 - 20 * kDegree;
  const std::vector<ShapePoint> keypoints = MakeKeypoints(synthetic.model);
  const ResectionResult result = ResectKeypoints(synthetic.view, keypoints, SeeAll(synthetic, keypoints),
                                                 PoseFromBox(synthetic.view), ResectionOptions{});
  ExpectNear(result.estimate, synthetic.truth, 0.1, 0.01);
}

TEST_P(KeypointResectionOf, FindsTheObjectFromAWrongAzimuthWithTheDefaultOptions) {
  SyntheticView synthetic(GetParam(), 0.5, {0.2, 0.3, 2.5}, Eigen::Vector3d(0.8, -0.6, 0.4));
  synthetic.view.detection.azimuth = 0.5 + 20 * kDegree;
  const std::vector<ShapePoint> keypoints = MakeKeypoints(synthetic.model);
  const PoseAndShape start = PoseFromBox(synthetic.view);
  EXPECT_GT(ReprojectionError(synthetic, keypoints, start), 10);
  const ResectionResult result =
      ResectKeypoints(synthetic.view, keypoints, SeeAll(synthetic, keypoints), start, ResectionOptions{});
  ExpectNear(result.estimate, synthetic.truth, 2, 0.2);
  EXPECT_LT(ReprojectionError(synthetic, keypoints, result.estimate), 3);
}

INSTANTIATE_TEST_SUITE_P(Categories, KeypointResectionOf, ::testing::Values("chair", "table", "laptop"));

TEST(KeypointResection, AWildKeypointIsLeftOut) {
  const SyntheticView synthetic("chair", 0.5, {0.2, 0.3, 2.5}, Eigen::Vector3d::Zero());
  const std::vector<ShapePoint> keypoints = MakeKeypoints(synthetic.model);
  std::vector<SeenKeypoint> seen = SeeAll(synthetic, keypoints);
  seen[3].pixel += Eigen::Vector2d(60, -40);
  const ResectionResult result =
      ResectKeypoints(synthetic.view, keypoints, seen, PoseFromBox(synthetic.view), ResectionOptions{});
  ExpectNear(result.estimate, synthetic.truth, 1, 0.05);
}

TEST(KeypointResection, WithoutUpItStartsFromElevationAndTilt) {
  SyntheticView synthetic("table", 0.5, {0.1, 0.2, 3}, Eigen::Vector3d::Zero());
  const Eigen::Vector3d ray = synthetic.camera.Ray(synthetic.view.detection.box.center());
  const Viewpoint viewpoint = ViewpointFromRotation(synthetic.truth.T_camera_object.linear(), ray);
  synthetic.view.up_camera.reset();
  synthetic.view.detection.azimuth = viewpoint.azimuth;
  synthetic.view.detection.elevation = viewpoint.elevation;
  synthetic.view.detection.tilt = viewpoint.tilt;
  ExpectNear(PoseFromBox(synthetic.view), synthetic.truth, 1e-6, 0.05);
}

}  // namespace
}  // namespace armature
