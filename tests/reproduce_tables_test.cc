// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "app/reproduce/matrix_tables.h"

namespace armature {
namespace {

using nlohmann::json;

json ObjectRow(const std::string& run, const std::string& approach, double average) {
  return {{"run", run},          {"approach", approach}, {"category", "all"}, {"observed", 4},
          {"found", 3},          {"spurious", 1},        {"best [m]", 0.01},  {"average [m]", average},
          {"worst [m]", nullptr}};
}

json TableOf(const std::string& table, const std::string& sequence, const json& rows) {
  return {{"table", table}, {"sequence", sequence}, {"rows", rows}};
}

// Two draws of one scene.
EvaluatedNumbers Numbers() {
  json chair = ObjectRow("objects", "objects, loop closure", 9);
  chair["category"] = "chair";
  return EvaluatedNumbers(json{
      {"tables",
       {TableOf("objects", "seq1",
                {chair, ObjectRow("objects", "odometry only", 0.5),
                 ObjectRow("objects", "objects, loop closure", 0.1)}),
        TableOf("objects", "seq1-draw2", json::array({ObjectRow("objects", "objects, loop closure", 0.3)})),
        TableOf("trajectory", "seq1",
                {{{"run", "objects"},
                  {"trajectory", "odometry_scaled"},
                  {"alignment", "first_pose"},
                  {"ATE rmse [m]", 0.25}}})}}});
}

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
  const std::vector<JobRecord> jobs{
      {.name = "runs/objects/seq1", .status = JobStatus::kReused},
      {.name = "runs/paper/seq1", .status = JobStatus::kFailed, .reason = "it broke"}};
  const Table table = MatrixTable(SmallMatrix(), jobs, Numbers());
  ASSERT_EQ(table.rows.size(), 3u);
  const auto text = [&](size_t row, size_t column) { return table.rows[row][column].text; };
  EXPECT_EQ(text(0, 6), "0.1000") << "of all categories";
  EXPECT_EQ(text(0, 7), "") << "no number in the table, none here";
  EXPECT_EQ(text(0, 11), "done");
  EXPECT_EQ(text(1, 6), "0.5000") << "of the run's odometry";
  EXPECT_EQ(text(1, 9), "0.2500");
  EXPECT_EQ(text(2, 6), "");
  EXPECT_EQ(text(2, 11), "failed: it broke");
}

TEST(ReproduceTables, WithoutAnyEvaluationThereAreStillTheOutcomes) {
  const Table table = MatrixTable(SmallMatrix(), {}, EvaluatedNumbers(nullptr));
  ASSERT_EQ(table.rows.size(), 3u);
  EXPECT_EQ(table.rows[0].back().text, "not run");
}

TEST(ReproduceTables, DrawsHaveMeanAndSpread) {
  Matrix matrix = SmallMatrix();
  EXPECT_FALSE(DrawsTable(matrix, Numbers())) << "one draw has no spread";
  matrix.seeds = 2;
  const Table table = *DrawsTable(matrix, Numbers());
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
