// SPDX-License-Identifier: BSD-3-Clause
// What stays over frames in simulated detections: shares, lengths and correlations have their asked values.
#include <gtest/gtest.h>

#include <cmath>

#include "datasets/simulation/lasting_error.h"
#include "datasets/simulation/stretches.h"

namespace armature {
namespace {

struct Observed {
  double share = 0, mean_seconds = 0;
};

Observed ObserveStretches(double share, double seconds, double step) {
  constexpr int kFrames = 200000;
  Random random(7);
  Stretches stretches;
  int on = 0, begun = 0;
  for (int i = 0; i < kFrames; ++i) {
    on += stretches.IsOn(share, seconds, i * step, random) ? 1 : 0;
    begun += stretches.has_begun() ? 1 : 0;
  }
  return {static_cast<double>(on) / kFrames, on * step / begun};
}

TEST(Stretches, HaveTheirShareAndMeanLength) {
  const Observed seen = ObserveStretches(0.3, 2, 0.1);
  EXPECT_NEAR(seen.share, 0.3, 0.015);
  EXPECT_NEAR(seen.mean_seconds, 2.1, 0.1);  // what ends between two frames is seen in the first of them
}

TEST(Stretches, DoNotDependOnTheFrameRate) {
  EXPECT_NEAR(ObserveStretches(0.3, 2, 0.02).mean_seconds, 2, 0.15);
  EXPECT_NEAR(ObserveStretches(0.3, 2, 0.02).share, 0.3, 0.03);
}

TEST(Stretches, OfNoLengthAreIndependent) {
  const Observed seen = ObserveStretches(0.3, 0, 1);
  EXPECT_NEAR(seen.share, 0.3, 0.005);
  EXPECT_NEAR(seen.mean_seconds, 1 / 0.7, 0.01);
}

TEST(Stretches, AreAlwaysOrNeverAtTheEnds) {
  Random random(1);
  Stretches always, never;
  for (int i = 0; i < 100; ++i) {
    EXPECT_TRUE(always.IsOn(1, 3, i, random));
    EXPECT_FALSE(never.IsOn(0, 3, i, random));
  }
}

// Of values `frames` apart.
double Correlation(const std::vector<double>& values, size_t frames) {
  double sum = 0;
  for (size_t i = 0; i + frames < values.size(); ++i) sum += values[i] * values[i + frames];
  return sum / static_cast<double>(values.size() - frames);
}

TEST(LastingError, HasUnitVarianceAndFallsToOneOverEWithinItsTime) {
  Random random(3);
  LastingError error;
  std::vector<double> values;
  for (int i = 0; i < 100000; ++i) values.push_back(error.At(0.1 * i, 0.5, random));
  EXPECT_NEAR(Correlation(values, 0), 1, 0.03);
  EXPECT_NEAR(Correlation(values, 5), std::exp(-1), 0.03);
  EXPECT_NEAR(Correlation(values, 10), std::exp(-2), 0.03);
}

TEST(LastingError, OfNoLengthIsIndependent) {
  Random random(3);
  LastingError error;
  std::vector<double> values;
  for (int i = 0; i < 20000; ++i) values.push_back(error.At(0.1 * i, 0, random));
  EXPECT_NEAR(Correlation(values, 1), 0, 0.03);
}

}  // namespace
}  // namespace armature
