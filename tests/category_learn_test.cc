// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "category/held_out.h"
#include "category/learn.h"
#include "category/normalise.h"
#include "support/category_examples.h"
#include "support/expect_input_error.h"

namespace armature {
namespace {

using testing::ExpectInputError;
using testing::FrameSpec;
using testing::FrameWireframe;

// Two orthonormal ways for the frame to vary: the posts' length, the bar's height.
Eigen::MatrixXd PlantedBasis() {
  Eigen::MatrixXd basis = Eigen::MatrixXd::Zero(18, 2);
  basis(5, 0) = basis(11, 0) = std::sqrt(0.5);
  basis(13, 1) = 1;
  return basis;
}

// Shapes on a circle in the planted plane, so that both coordinates are uncorrelated: radii a and b give the
// variances n a^2 / (2 (n - 1)) and n b^2 / (2 (n - 1)).
std::vector<Wireframe> PlantedWireframes(int n, double a, double b) {
  std::vector<Wireframe> wireframes;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * M_PI * i / n;
    const Eigen::Vector2d coordinates(a * std::cos(angle), b * std::sin(angle));
    wireframes.push_back(WireframeFromVector(ShapeVector(FrameWireframe()) + PlantedBasis() * coordinates));
  }
  return wireframes;
}

TEST(Learn, RecoversAPlantedSubspaceAndItsStandardDeviations) {
  const CategoryModel model = LearnCategory(FrameSpec(), PlantedWireframes(20, 0.2, 0.1), "planted");
  EXPECT_LT((model.mean - ShapeVector(FrameWireframe())).norm(), 1e-12);
  EXPECT_LT((model.basis - PlantedBasis()).norm(), 1e-9);
  const double spread = std::sqrt(20 / (2 * 19.0));
  EXPECT_NEAR(model.standard_deviations[0], 0.2 * spread, 1e-12);
  EXPECT_NEAR(model.standard_deviations[1], 0.1 * spread, 1e-12);
  EXPECT_LT((ExplainedVariance(model) - Eigen::Vector2d(0.8, 0.2)).norm(), 1e-12);
  EXPECT_EQ(model.training_models, 20);
  EXPECT_EQ(model.source, "planted");
}

TEST(Learn, KeepsNoMoreModesThanTheModelsSpan) {
  TrainingSpec spec = FrameSpec();
  spec.modes = 7;
  EXPECT_EQ(LearnCategory(spec, PlantedWireframes(20, 0.2, 0.1), "").modes(), 2);
}

TEST(Learn, DictionaryEntriesAreTrainingModels) {
  const std::vector<Wireframe> wireframes = PlantedWireframes(20, 0.2, 0.1);
  const CategoryModel model = LearnCategory(FrameSpec(), wireframes, "");
  ASSERT_EQ(model.dictionary.size(), 4u);
  for (const Eigen::VectorXd& entry : model.dictionary) {
    const Eigen::VectorXd shape = ShapeVector(WireframeFromCoefficients(model, entry));
    const auto is_same = [&](const Wireframe& w) { return (ShapeVector(w) - shape).norm() < 1e-9; };
    EXPECT_TRUE(std::any_of(wireframes.begin(), wireframes.end(), is_same));
  }
}

TEST(Learn, MirroredTrainingGivesASymmetricMean) {
  TrainingSpec spec = FrameSpec();
  std::vector<Wireframe> wireframes = PlantedWireframes(6, 0.2, 0.1);
  for (Wireframe& wireframe : wireframes) wireframe.directions(1, 0) += 0.3;  // left posts rise
  spec.mirrored = true;
  const CategoryModel model = LearnCategory(spec, wireframes, "");
  const Wireframe mean = WireframeFromVector(model.mean);
  EXPECT_LT((ShapeVector(Mirrored(spec.category, mean)) - model.mean).norm(), 1e-12);
  EXPECT_EQ(model.training_models, 6);
}

TEST(Learn, RefusesTooFewEqualOrForeignModels) {
  const TrainingSpec spec = FrameSpec();
  ExpectInputError([&] { LearnCategory(spec, {FrameWireframe()}, ""); }, {"frame", "at least 2"});
  ExpectInputError([&] { LearnCategory(spec, {FrameWireframe(), FrameWireframe()}, ""); }, {"same shape"});
  const Wireframe two_edges{Eigen::Matrix3Xd::Zero(3, 2), Eigen::Matrix3Xd::Ones(3, 2)};
  ExpectInputError([&] { LearnCategory(spec, {FrameWireframe(), two_edges}, ""); }, {"2 edges", "has 3"});
}

TEST(HeldOut, ModelsOfTheSubspaceAreReconstructedExactlyWithAllModes) {
  const std::vector<HeldOutRow> rows =
      HeldOutErrors(FrameSpec(), PlantedWireframes(40, 0.2, 0.1), 4, {1, 2, 3});
  ASSERT_EQ(rows.size(), 2u);  // there is no third mode
  EXPECT_EQ(rows[0].training_models, 30);
  EXPECT_EQ(rows[0].error.models, 10);
  EXPECT_GT(rows[0].error.midpoint, 0.001);
  EXPECT_LT(rows[1].error.midpoint, 1e-9);
  EXPECT_LT(rows[1].error.direction, 1e-7);
}

TEST(HeldOut, ErrorIsTheMeanOverEdges) {
  CategoryModel model = LearnCategory(FrameSpec(), PlantedWireframes(20, 0.2, 0.1), "");
  Wireframe moved = FrameWireframe();
  moved.midpoints(0, 1) += 0.3;  // outside of the subspace: stays as error, of one edge in three
  moved.directions.col(2) = Eigen::Vector3d(0, 1, 0);  // a quarter of a turn
  const ReconstructionError error = Reconstruct(model, {moved}, 2);
  EXPECT_NEAR(error.midpoint, 0.1, 1e-9);
  EXPECT_NEAR(error.direction, M_PI / 2 / 3, 1e-9);
}

TEST(HeldOut, NeedsSomethingToLearnFrom) {
  ExpectInputError([] { HeldOutErrors(FrameSpec(), PlantedWireframes(8, 1, 1), 1, {2}); },
                   {"--held-out 1", "2"});
}

}  // namespace
}  // namespace armature
