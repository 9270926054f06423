// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "bench/guard/regression_guard.h"
#include "support/expect_input_error.h"

namespace armature {
namespace {

// `error`: by which the median may be off, relative.
SpanStatistics GuardTimes(double median, double error = 0.02, size_t n = 100) {
  SpanStatistics s;
  s.n = n;
  s.mean = s.median = median;
  s.median_low = median * (1 - error);
  s.median_high = median * (1 + error);
  s.p10 = median * (1 - 2 * error);
  s.p90 = s.p99 = s.max = median * (1 + 2 * error);
  return s;
}

NamedSpan GuardSpan(const std::string& contender, const SpanStatistics& times) {
  return {"micro", "", contender, "call", times};
}

BenchRecord GuardRecord(double calibration, const std::vector<NamedSpan>& spans) {
  return {"a processor", GuardTimes(calibration), spans};
}

Verdict VerdictBetween(const SpanStatistics& reference, const SpanStatistics& now,
                       double calibration_now = 5) {
  return CompareWithReference(GuardRecord(5, {GuardSpan("a", reference)}),
                              GuardRecord(calibration_now, {GuardSpan("a", now)}))
      .spans.at(0)
      .verdict;
}

TEST(RegressionGuard, SeesWhatMovedBeyondTheMediansErrors) {
  EXPECT_EQ(VerdictBetween(GuardTimes(1), GuardTimes(1.2)), Verdict::kSlower);
  EXPECT_EQ(VerdictBetween(GuardTimes(1), GuardTimes(0.8)), Verdict::kFaster);
  EXPECT_EQ(VerdictBetween(GuardTimes(1), GuardTimes(1.04)), Verdict::kSame);
}

TEST(RegressionGuard, DividesByWhatTheCalibrationMoved) {
  EXPECT_EQ(VerdictBetween(GuardTimes(1), GuardTimes(1.2), 6), Verdict::kSame);
  EXPECT_EQ(VerdictBetween(GuardTimes(1), GuardTimes(1), 6), Verdict::kFaster);
  const GuardResult result = CompareWithReference(GuardRecord(5, {GuardSpan("a", GuardTimes(2))}),
                                                  GuardRecord(6, {GuardSpan("a", GuardTimes(3))}));
  EXPECT_DOUBLE_EQ(result.calibration_ratio(), 1.2);
  EXPECT_DOUBLE_EQ(result.spans.at(0).ratio, 1.25);
}

TEST(RegressionGuard, DividesByTheCalibrationOfTheSameTable) {
  const auto record = [](double all, double of_table, double span) {
    return GuardRecord(
        all, {GuardSpan("a", GuardTimes(span)), {"micro", "", "calibration", "pass", GuardTimes(of_table)}});
  };
  const GuardResult result = CompareWithReference(record(5, 5, 2), record(6, 7.5, 3));
  ASSERT_EQ(result.spans.size(), 1U);  // the calibration itself is not guarded
  EXPECT_DOUBLE_EQ(result.spans[0].ratio, 1);
  EXPECT_DOUBLE_EQ(result.calibration_ratio(), 1.2);
}

TEST(RegressionGuard, IsLessSureOfFewOrScatteredValues) {
  EXPECT_EQ(VerdictBetween(GuardTimes(1, 0.2), GuardTimes(1.2, 0.2)), Verdict::kSame);
  EXPECT_EQ(VerdictBetween(GuardTimes(1, 0, 4), GuardTimes(9)), Verdict::kTooFew);
}

TEST(RegressionGuard, AddsTheErrorsTowardsTheOtherSide) {
  BenchRecord reference = GuardRecord(5, {GuardSpan("a", GuardTimes(1, 0))});
  reference.spans[0].milliseconds.median_high = 1.03;
  reference.spans[0].milliseconds.median_low = 0.5;
  reference.calibration = GuardTimes(5, 0);
  BenchRecord now = reference;
  now.spans[0].milliseconds = GuardTimes(1.1, 0.04);
  now.spans[0].milliseconds.median_high = 9;
  EXPECT_NEAR(CompareWithReference(reference, now).spans.at(0).tolerance, 0.05 + 0.05, 1e-9);
  // The other way round: both errors are those of the far sides.
  now.spans[0].milliseconds = GuardTimes(0.9, 0);
  now.spans[0].milliseconds.median_high = 0.9 * 1.2;
  EXPECT_NEAR(CompareWithReference(reference, now).spans.at(0).tolerance, 0.05 + std::hypot(0.5, 0.2), 1e-9);
}

TEST(RegressionGuard, AddsTheCalibrationsErrors) {
  BenchRecord reference = GuardRecord(5, {GuardSpan("a", GuardTimes(1, 0))});
  reference.calibration = GuardTimes(5, 0.03);
  BenchRecord now = GuardRecord(5, {GuardSpan("a", GuardTimes(1.01, 0))});
  now.calibration = GuardTimes(5, 0.04);
  EXPECT_NEAR(CompareWithReference(reference, now).spans.at(0).tolerance, 0.05 + 0.05, 1e-9);
}

TEST(RegressionGuard, ListsWhatIsOnOneSideOnly) {
  const GuardResult result = CompareWithReference(
      GuardRecord(5, {GuardSpan("old", GuardTimes(1)), GuardSpan("kept", GuardTimes(1))}),
      GuardRecord(5, {GuardSpan("kept", GuardTimes(1)), GuardSpan("added", GuardTimes(1))}));
  ASSERT_EQ(result.spans.size(), 3U);
  EXPECT_EQ(result.spans[0].verdict, Verdict::kSame);
  EXPECT_EQ(result.spans[1].verdict, Verdict::kNew);
  EXPECT_EQ(result.spans[2].verdict, Verdict::kMissing);
  EXPECT_EQ(result.spans[2].key, "micro//old/call");
}

TEST(RegressionGuard, FailsOnlyForWhatBecameSlower) {
  const BenchRecord reference =
      GuardRecord(5, {GuardSpan("a", GuardTimes(1)), GuardSpan("b", GuardTimes(1))});
  EXPECT_FALSE(
      BecameSlower(CompareWithReference(reference, GuardRecord(5, {GuardSpan("a", GuardTimes(0.5))}))));
  EXPECT_TRUE(BecameSlower(CompareWithReference(reference, GuardRecord(5, {GuardSpan("b", GuardTimes(2))}))));
}

TEST(RegressionGuard, RefusesToCompareNothing) {
  testing::ExpectInputError(
      [] {
        CompareWithReference(GuardRecord(5, {GuardSpan("a", GuardTimes(1))}),
                             GuardRecord(5, {GuardSpan("b", GuardTimes(1))}));
      },
      {"no span", "write a new reference"});
}

TEST(RegressionGuard, TabulatesVerdictsAndNotesAnotherMachine) {
  const BenchRecord reference =
      GuardRecord(5, {GuardSpan("a", GuardTimes(1)), GuardSpan("gone", GuardTimes(1))});
  BenchRecord now = GuardRecord(5, {GuardSpan("a", GuardTimes(2))});
  const Table same_machine = GuardTable(CompareWithReference(reference, now));
  now.cpu = "another";
  const Table other_machine = GuardTable(CompareWithReference(reference, now));
  ASSERT_EQ(same_machine.rows.size(), 2U);
  EXPECT_EQ(same_machine.rows[0][3].text, "2.000");
  EXPECT_EQ(same_machine.rows[0][4].text, "4.0");
  EXPECT_EQ(same_machine.rows[0][7].text, "slower");
  EXPECT_EQ(same_machine.rows[1][2].text, "");
  EXPECT_EQ(same_machine.rows[1][7].text, "missing");
  EXPECT_NE(same_machine.title.find("1 slower, 0 faster, 0 same, 0 too few, 1 missing"), std::string::npos);
  ASSERT_EQ(other_machine.notes.size(), same_machine.notes.size() + 1);
  EXPECT_NE(other_machine.notes.back().find("'a processor'"), std::string::npos);
}

TEST(RegressionGuard, NotesABusyMachine) {
  const BenchRecord reference = GuardRecord(5, {GuardSpan("a", GuardTimes(1))});
  BenchRecord now = reference;
  now.calibration = GuardTimes(6, 0.2);
  const Table table = GuardTable(CompareWithReference(reference, now));
  EXPECT_NE(table.notes.back().find("busy machine: the calibration loop's times spread by 40 %"),
            std::string::npos);
}

}  // namespace
}  // namespace armature
