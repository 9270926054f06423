// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "app/reproduce/matrix_tables.h"
#include "support/expect_input_error.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

ObjectRecord ErrorsOf(const std::string& sequence, Approach approach, double mean_m) {
  return {.sequence = sequence,
          .run = "objects",
          .approach = approach,
          .observed = 4,
          .found = 3,
          .spurious = 1,
          .object_error_best_m = 0.01,
          .object_error_mean_m = mean_m};
}

// Two draws of one scene; the second one's folder is not called as its sequence.
MatrixEvaluation SmallEvaluation() {
  constexpr Approach kLoops = Approach::kObjectsLoopClosure;
  MatrixEvaluation evaluation{"records.json", {}};
  EvaluationRecords& records = evaluation.records;
  records.runs = {{"runs/objects/seq1", "seq1", "objects"}, {"runs/objects/seq1-draw2", "other", "objects"}};
  ObjectRecord chair = ErrorsOf("seq1", kLoops, 9), by_detections = ErrorsOf("seq1", kLoops, 8);
  chair.category = "chair";
  by_detections.matched_by = MatchedBy::kDetections;
  records.objects = {by_detections, chair, ErrorsOf("seq1", Approach::kOdometryOnly, 0.5),
                     ErrorsOf("seq1", kLoops, 0.1), ErrorsOf("other", kLoops, 0.3)};
  const auto camera = [&](AlignmentKind alignment, double rmse_m) {
    records.trajectories.push_back({.sequence = "seq1",
                                    .run = "objects",
                                    .trajectory = TrajectoryKind::kOdometryScaled,
                                    .alignment = alignment,
                                    .ate_rmse_m = rmse_m});
  };
  camera(AlignmentKind::kSe3, 0.125);
  camera(AlignmentKind::kFirstPose, 0.25);
  records.views = {
      {.sequence = "seq1", .run = "objects", .only_ok = true, .detections = 4},
      {.sequence = "seq1", .run = "objects", .detections = 4, .views_within_15_deg_share = 0.75}};
  return evaluation;
}

const std::vector<JobRecord> kSmallJobs{
    {.name = "runs/objects/seq1", .status = JobStatus::kReused},
    {.name = "runs/objects/seq1-draw2", .status = JobStatus::kDone},
    {.name = "runs/paper/seq1", .status = JobStatus::kFailed, .reason = "it broke"}};

Matrix SmallMatrix() {
  Matrix matrix;
  matrix.data = "/d";
  matrix.scenes = {"seq1"};
  matrix.variants = {{.name = "objects", .about = "with objects"},
                     {.name = "odometry", .about = "odometry", .odometry_of = "objects"},
                     {.name = "paper", .about = "as printed"}};
  return matrix;
}

TEST(ReproduceTables, EachVariantHasItsNumbersAndOutcome) {
  const MatrixEvaluation evaluation = SmallEvaluation();
  const Table table = MatrixTable(SmallMatrix(), kSmallJobs, &evaluation);
  ASSERT_EQ(table.rows.size(), 3u);
  const auto text = [&](size_t row, size_t column) { return table.rows[row][column].text; };
  EXPECT_EQ(text(0, 6), "0.1000") << "of all categories";
  EXPECT_EQ(text(0, 7), "") << "an error that is not known";
  EXPECT_EQ(text(0, 10), "75.0");
  EXPECT_EQ(text(0, 11), "done");
  EXPECT_EQ(text(1, 6), "0.5000") << "of the run's odometry";
  EXPECT_EQ(text(1, 9), "0.2500");
  EXPECT_EQ(text(2, 6), "");
  EXPECT_EQ(text(2, 11), "failed: it broke");
}

TEST(ReproduceTables, WithoutAnyEvaluationThereAreStillTheOutcomes) {
  const Table table = MatrixTable(SmallMatrix(), {}, nullptr);
  ASSERT_EQ(table.rows.size(), 3u);
  EXPECT_EQ(table.rows[0].back().text, "not run");
}

TEST(ReproduceTables, AnEvaluationWithoutARunThatSucceededIsAnError) {
  MatrixEvaluation evaluation = SmallEvaluation();
  evaluation.records.runs.front().folder = "runs/objects/seq7";
  testing::ExpectInputError([&] { MatrixTable(SmallMatrix(), kSmallJobs, &evaluation); },
                            {"records.json", "runs/objects/seq1"});
}

TEST(ReproduceTables, AnEvaluationWithoutRecordsOfWhatHasTruthIsAnError) {
  const testing::TempFolder data;
  data.Write("seq1/groundtruth.txt", "");
  data.Write("seq1/objects_gt.csv", "");
  Matrix matrix = SmallMatrix();
  matrix.data = data.path();
  MatrixEvaluation evaluation = SmallEvaluation();
  MatrixTable(matrix, kSmallJobs, &evaluation);
  for (ObjectRecord& objects : evaluation.records.objects) objects.sequence = "seq7";
  testing::ExpectInputError([&] { MatrixTable(matrix, kSmallJobs, &evaluation); },
                            {"records.json", "no objects of run 'objects' of sequence 'seq1'"});
  evaluation.records.trajectories.clear();
  testing::ExpectInputError([&] { MatrixTable(matrix, kSmallJobs, &evaluation); }, {"no cameras"});
}

TEST(ReproduceTables, DrawsHaveMeanAndSpread) {
  Matrix matrix = SmallMatrix();
  const MatrixEvaluation evaluation = SmallEvaluation();
  EXPECT_FALSE(DrawsTable(matrix, kSmallJobs, &evaluation)) << "one draw has no spread";
  matrix.seeds = 2;
  const Table table = *DrawsTable(matrix, kSmallJobs, &evaluation);
  const auto& row = table.rows.at(0);
  EXPECT_EQ(row[2].text, "2");
  EXPECT_EQ(row[3].text, "0.2000");
  EXPECT_EQ(row[4].text, "0.1414") << "sqrt(((0.1 - 0.2)^2 + (0.3 - 0.2)^2) / 1)";
  EXPECT_EQ(row[5].text, "0.1000");
  EXPECT_EQ(row[6].text, "0.3000");
  EXPECT_EQ(row[7].text, "6");
  EXPECT_EQ(table.rows.at(1)[4].text, "") << "one draw of odometry";
  EXPECT_EQ(table.rows.at(2)[2].text, "0");
}

}  // namespace
}  // namespace armature
