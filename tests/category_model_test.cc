// SPDX-License-Identifier: BSD-3-Clause
#include "category/category_model.h"

#include <gtest/gtest.h>

#include "io/category_yaml.h"
#include "support/category_examples.h"

namespace armature {
namespace {

using testing::CategoryFolder;
using testing::FrameWireframe;

TEST(CategoryModel, ShapeVectorIsMidpointThenDirectionOfEachEdge) {
  const Eigen::VectorXd shape = ShapeVector(FrameWireframe());
  ASSERT_EQ(shape.size(), 18);
  EXPECT_EQ(shape.segment<3>(0), Eigen::Vector3d(-0.5, 0, 0));
  EXPECT_EQ(shape.segment<3>(15), Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(ShapeVector(WireframeFromVector(shape)), shape);
}

TEST(CategoryModel, EndsAreHalfADirectionFromTheMidpoint) {
  EXPECT_EQ(FrameWireframe().End(2, 0), Eigen::Vector3d(-0.5, 0, -0.5));
  EXPECT_EQ(FrameWireframe().End(2, 1), Eigen::Vector3d(0.5, 0, -0.5));
}

TEST(CategoryModel, BoundingBoxCoversTheEnds) {
  EXPECT_EQ(BoundingBoxSize(FrameWireframe()), Eigen::Vector3d(1, 0, 1));
}

TEST(CategoryModel, CoefficientsSurviveTheWayThroughTheShape) {
  const CategoryModel model = LoadCategory(CategoryFolder() / "chair.yaml");
  Eigen::VectorXd coefficients(model.modes());
  for (int i = 0; i < model.modes(); ++i) coefficients[i] = 0.7 * i - 2;
  const Wireframe wireframe = WireframeFromCoefficients(model, coefficients);
  EXPECT_LT((CoefficientsFromWireframe(model, wireframe) - coefficients).norm(), 1e-6);
}

TEST(CategoryModel, FewerCoefficientsLeaveTheLaterModesAtZero) {
  const CategoryModel model = LoadCategory(CategoryFolder() / "chair.yaml");
  const Wireframe wireframe = WireframeFromCoefficients(model, Eigen::Vector2d(1, -1));
  const Eigen::VectorXd coefficients = CoefficientsFromWireframe(model, wireframe);
  EXPECT_LT((coefficients.head(2) - Eigen::Vector2d(1, -1)).norm(), 1e-6);
  EXPECT_LT(coefficients.tail(model.modes() - 2).norm(), 1e-6);
}

}  // namespace
}  // namespace armature
