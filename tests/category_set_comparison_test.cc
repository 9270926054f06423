// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "category/learn.h"
#include "category/set_comparison.h"
#include "datasets/cad/families.h"
#include "io/category_yaml.h"
#include "io/training_models.h"
#include "support/category_examples.h"
#include "support/expect_input_error.h"
#include "support/shared_data.h"

namespace armature {
namespace {

TrainingSpec FindSpec(const std::string& category) {
  return LoadTrainingSpec(testing::CategoryFolder() / "specs" / (category + ".yaml"));
}

TEST(SetComparison, ASetComparedWithItselfHasMeanZeroAndDeviationOne) {
  for (const std::string category : {"chair", "table", "laptop"}) {
    const TrainingSpec spec = FindSpec(category);
    const TrainingModels family =
        FamilyTrainingModels(spec, {category, 200, 1}, SampleFamily({category, 200, 1}));
    const CategoryModel model = LearnCategory(spec, family.wireframes, "");
    const CoefficientStatistics own = ComputeStatistics(model, spec, family.wireframes).coefficients;
    EXPECT_LT(own.mean.cwiseAbs().maxCoeff(), 1e-6) << category;
    EXPECT_LT((own.deviation.array() - 1).abs().maxCoeff(), 1e-6) << category;
  }
}

// Frames whose bar is `length` + `spread` * (-1, 0, 1) long: one mode.
std::vector<Wireframe> Frames(double length, double spread) {
  std::vector<Wireframe> frames;
  for (const int step : {-1, 0, 1}) {
    Wireframe frame = testing::FrameWireframe();
    frame.directions(0, 2) = length + spread * step;
    frames.push_back(frame);
  }
  return frames;
}

TEST(SetComparison, AShiftedAndWiderSetIsSeenInTheModelsDeviations) {
  const TrainingSpec spec = testing::FrameSpec();
  const CategoryModel model = LearnCategory(spec, Frames(1, 0.1), "");
  const SetStatistics other = ComputeStatistics(model, spec, Frames(1.2, 0.3));
  ASSERT_EQ(model.modes(), 1);
  EXPECT_NEAR(other.coefficients.mean[0], 2, 1e-9);
  EXPECT_NEAR(other.coefficients.deviation[0], 3, 1e-9);
  EXPECT_NEAR(other.error.midpoint, 0, 1e-12);
  EXPECT_EQ(other.error.models, 3);
}

TEST(SetComparison, WhatTheModelCannotShowIsAnError) {
  const TrainingSpec spec = testing::FrameSpec();
  const CategoryModel model = LearnCategory(spec, Frames(1, 0.1), "");
  std::vector<Wireframe> others = Frames(1, 0.1);
  for (Wireframe& other : others) other.midpoints(1, 0) += 0.06;  // one edge of three
  EXPECT_NEAR(ComputeStatistics(model, spec, others).error.midpoint, 0.02, 1e-9);
}

TEST(SetComparison, OneModelIsNoSet) {
  const TrainingSpec spec = testing::FrameSpec();
  const CategoryModel model = LearnCategory(spec, Frames(1, 0.1), "");
  testing::ExpectInputError([&] { ComputeStatistics(model, spec, {testing::FrameWireframe()}); },
                            {"frame", "at least 2"});
}

// Our families are as published CAD models are, in the modes of those: datasets/README.md has the tables.
struct Agreement {
  std::string category, file, format;
  int modes;              // the first ones, which hold most of the variance
  double mean, narrower;  // at most this far off; at least this share of the published deviation
  double midpoint;        // metres
};

class FamilyAgreement : public ::testing::TestWithParam<Agreement> {};

TEST_P(FamilyAgreement, WithPublishedModels) {
  const Agreement& expected = GetParam();
  ARMATURE_SHARED_DATA_OR_SKIP(file, "cad/" + expected.file);
  const TrainingSpec spec = FindSpec(expected.category);
  const TrainingModels published = AnnotatedTrainingModels(spec, {file, expected.format});
  const CategoryModel model = LearnCategory(spec, published.wireframes, "");
  const TrainingModels family = FamilyTrainingModels(spec, {expected.category, 2000, 1, false},
                                                     SampleFamily({expected.category, 2000, 1, false}));
  const SetStatistics ours = ComputeStatistics(model, spec, family.wireframes);
  for (int i = 0; i < expected.modes; ++i) {
    EXPECT_LT(std::abs(ours.coefficients.mean[i]), expected.mean) << "mode " << i + 1;
    EXPECT_GT(ours.coefficients.deviation[i], expected.narrower) << "mode " << i + 1;
    EXPECT_LT(ours.coefficients.deviation[i], 1.5) << "mode " << i + 1;
  }
  EXPECT_LT(ours.error.midpoint, expected.midpoint);
}

INSTANTIATE_TEST_SUITE_P(Categories, FamilyAgreement,
                         ::testing::Values(Agreement{"chair", "keypointnet_chair_kp10.csv",
                                                     "keypointnet_chair", 7, 0.25, 0.8, 0.016},
                                           Agreement{"table", "shapeassembly_table_kp12.csv",
                                                     "shapeassembly_table", 6, 0.3, 0.65, 0.002},
                                           Agreement{"laptop", "modelnet40_laptop_autokp6.csv",
                                                     "modelnet_laptop", 3, 0.6, 0.65, 0.002}),
                         [](const auto& tested) { return tested.param.category; });

}  // namespace
}  // namespace armature
