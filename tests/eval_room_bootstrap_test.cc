// SPDX-License-Identifier: BSD-3-Clause
// Statistics over rooms with known answers.
#include <gtest/gtest.h>

#include <cmath>

#include "base/statistics.h"
#include "eval/statistics/rank_correlation.h"
#include "eval/statistics/room_bootstrap.h"
#include "eval/statistics/room_difference.h"

namespace armature {
namespace {

// Values 0, 1, ... one a room, each `copies` times.
ValuesInRooms Ladder(size_t rooms, int copies = 1) {
  std::vector<std::pair<double, size_t>> values;
  for (size_t i = 0; i < rooms; ++i) {
    for (int copy = 0; copy < copies; ++copy) values.emplace_back(static_cast<double>(i), i);
  }
  return ValuesInRooms(values);
}

Interval MeanInterval(const ValuesInRooms& values, size_t rooms, std::uint64_t seed = 1) {
  return RoomBootstrap(rooms, seed).Of([&](const RoomCounts& counts) { return values.Mean(counts); }).value();
}

TEST(RoomBootstrapTest, TheIntervalOfAMeanIsThatOfItsStandardError) {
  const Interval interval = MeanInterval(Ladder(100), 100);
  const double half = 1.96 * std::sqrt((100.0 * 100 - 1) / 12 / 100);  // 5.66
  EXPECT_NEAR(interval.low, 49.5 - half, 0.3);
  EXPECT_NEAR(interval.high, 49.5 + half, 0.3);
}

TEST(RoomBootstrapTest, ObjectsOfARoomThatAreAlikeSayNoMoreThanOne) {
  const Interval one = MeanInterval(Ladder(30), 30), ten = MeanInterval(Ladder(30, 10), 30);
  EXPECT_DOUBLE_EQ(one.low, ten.low);
  EXPECT_DOUBLE_EQ(one.high, ten.high);
}

TEST(RoomBootstrapTest, ASeedGivesTheSameDraws) {
  const ValuesInRooms values = Ladder(20);
  EXPECT_EQ(MeanInterval(values, 20, 7).low, MeanInterval(values, 20, 7).low);
  EXPECT_NE(MeanInterval(values, 20, 7).low, MeanInterval(values, 20, 8).low);
}

TEST(RoomBootstrapTest, DrawsWithoutAValueAreLeftOut) {
  const ValuesInRooms values({{5.0, 0}});  // the second room has none
  EXPECT_EQ(values.Mean({0, 2}), std::nullopt);
  const Interval interval = MeanInterval(values, 2);
  EXPECT_EQ(interval.low, 5);
  EXPECT_EQ(interval.high, 5);
  EXPECT_FALSE(RoomBootstrap(2).Of([](const RoomCounts&) { return std::optional<double>(); }));
}

TEST(ValuesInRoomsTest, AreThoseOfRoomsAsOftenAsTheyWereDrawn) {
  const ValuesInRooms values({{4, 0}, {1, 0}, {7, 1}, {2, 2}});
  const RoomCounts counts{2, 0, 3};  // 1 1 2 2 2 4 4
  const std::vector<double> listed{1, 1, 2, 2, 2, 4, 4};
  EXPECT_DOUBLE_EQ(*values.Mean(counts), 16.0 / 7);
  for (const double fraction : {0.0, 0.1, 0.25, 0.5, 0.72, 0.9, 1.0})
    EXPECT_DOUBLE_EQ(*values.Quantile(counts, fraction), *Quantile(listed, fraction)) << fraction;
}

std::vector<std::pair<double, double>> Alternating(size_t rooms, double mean, double deviation) {
  std::vector<std::pair<double, double>> pairs;
  for (size_t i = 0; i < rooms; ++i) pairs.emplace_back(1, 1 + mean + (i % 2 == 0 ? deviation : -deviation));
  return pairs;
}

TEST(RoomDifferenceTest, MarksWhatZeroIsOutsideOf) {
  EXPECT_EQ(CompareRooms(Alternating(40, 0.5, 1))->mark, DifferenceMark::kHigher);
  EXPECT_EQ(CompareRooms(Alternating(40, -0.5, 1))->mark, DifferenceMark::kLower);
  EXPECT_EQ(CompareRooms(Alternating(40, 0.1, 1))->mark, DifferenceMark::kSame);
  EXPECT_EQ(CompareRooms(Alternating(5, 9, 1))->mark, DifferenceMark::kTooFew);
  EXPECT_FALSE(CompareRooms({}));
}

TEST(RoomDifferenceTest, HasMeansAndTheSpreadOfDifferences) {
  const RoomDifference difference = CompareRooms({{1, 2}, {3, 3}, {5, 4}}).value();
  EXPECT_DOUBLE_EQ(difference.mean_a, 3);
  EXPECT_DOUBLE_EQ(difference.mean_b, 3);
  EXPECT_DOUBLE_EQ(difference.mean, 0);
  EXPECT_DOUBLE_EQ(difference.deviation, 1);
}

TEST(RoomDifferenceTest, SaysHowManyRoomsWouldShowASize) {
  const RoomDifference difference = CompareRooms({{1, 2}, {3, 3}, {5, 4}}).value();
  EXPECT_EQ(RoomsToShow(difference, 1), 8);  // (1.96 + 0.84)^2 = 7.85
  EXPECT_EQ(RoomsToShow(difference, 0.1), 785);
  EXPECT_EQ(RoomsToShow(difference, 100), 2);
  EXPECT_EQ(RoomsToShow(difference, 0), std::nullopt);
  EXPECT_EQ(RoomsToShow(CompareRooms({{1, 2}}).value(), 1), std::nullopt) << "one room has no spread";
}

double Correlate(const std::vector<std::pair<double, double>>& xy) {
  std::vector<PairInRoom> pairs;
  for (const auto& [x, y] : xy) pairs.push_back({x, y, 0});
  return RankCorrelation(pairs).Of({1}).value();
}

TEST(RankCorrelationTest, KnownAnswers) {
  EXPECT_DOUBLE_EQ(Correlate({{1, 10}, {2, 11}, {30, 400}}), 1);
  EXPECT_DOUBLE_EQ(Correlate({{1, 5}, {2, 4}, {3, -1}}), -1);
  EXPECT_NEAR(Correlate({{1, 1}, {2, 3}, {2, 2}, {3, 4}}), 4.5 / std::sqrt(4.5 * 5), 1e-12) << "equal x";
  EXPECT_NEAR(Correlate({{1, 2}, {2, 1}, {3, 4}, {4, 3}, {5, 5}}), 0.8, 1e-12);  // 1 - 6 * 4 / 120
}

TEST(RankCorrelationTest, IsNoneWhereNothingVaries) {
  EXPECT_FALSE(RankCorrelation({{1, 2, 0}, {1, 3, 0}, {1, 4, 0}}).Of({1}));
  EXPECT_FALSE(RankCorrelation({{1, 2, 0}, {2, 3, 0}}).Of({1})) << "two pairs";
}

TEST(RankCorrelationTest, ARoomDrawnTwiceCountsTwice) {
  const std::vector<PairInRoom> pairs{{1, 3, 0}, {2, 1, 0}, {3, 4, 1}, {4, 2, 2}};
  std::vector<PairInRoom> listed{pairs[0], pairs[0], pairs[1], pairs[1], pairs[3]};
  EXPECT_NEAR(RankCorrelation(pairs).Of({2, 0, 1}).value(), RankCorrelation(listed).Of({1, 1, 1}).value(),
              1e-12);
}

TEST(ThirdsTest, SplitByTheCircumstance) {
  std::vector<PairInRoom> pairs;
  for (int i = 8; i >= 0; --i) pairs.push_back({static_cast<double>(i), static_cast<double>(10 * i), 0});
  const Thirds thirds = SplitByThirds(pairs).value();
  EXPECT_EQ(thirds.medians[0], 10);
  EXPECT_EQ(thirds.medians[1], 40);
  EXPECT_EQ(thirds.medians[2], 70);
  EXPECT_EQ(thirds.means[2], 70);
}

TEST(ThirdsTest, EqualValuesStayTogether) {
  // Three of four have 1: the two kinds are two groups, whatever a third of four is.
  const Thirds thirds = SplitByThirds({{1, 1, 0}, {0, 5, 0}, {1, 2, 0}, {1, 3, 0}}).value();
  EXPECT_EQ(thirds.medians[0], 5);
  EXPECT_EQ(thirds.medians[1], 2);
  EXPECT_FALSE(thirds.medians[2]);
  // Nine of ten have 1, and still the one that has not is a group.
  std::vector<PairInRoom> pairs(9, {1, 3, 0});
  pairs.push_back({0, 7, 0});
  EXPECT_EQ(SplitByThirds(pairs)->medians[0], 7);
  EXPECT_FALSE(SplitByThirds({}));
}

}  // namespace
}  // namespace armature
