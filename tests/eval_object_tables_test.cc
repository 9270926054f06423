// SPDX-License-Identifier: BSD-3-Clause
// Tables of objects: what they say of known maps, of none, and beside the paper.
#include <gtest/gtest.h>

#include "eval/objects/normal_term_table.h"
#include "eval/objects/paper_object_errors.h"
#include "io/csv.h"
#include "support/expect_input_error.h"
#include "support/table_cells.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

using testing::CellText;
using testing::ExpectInputError;
using testing::NotesText;

EvaluatedObject Found(const std::string& id, const std::string& category, double centre_m) {
  ObjectError error;
  error.centre_m = centre_m;
  error.orientation = {-10, 3, -4, 5, 0};
  error.size_m = {0.1, -0.05, 0};
  error.iou = 0.5;
  return {ObjectStatus::kFound, category, id, "map_" + id, 7, error};
}

// Two maps of one run: odometry's misses the table.
NamedObjects TwoMaps(const std::string& run) {
  NamedObjects named{run, {}};
  named.objects.configuration = {"axis", true};
  EvaluatedMap odometry{Approach::kOdometryOnly, {}, {}, {}};
  odometry.by_distance = {Found("chair0", "chair", 0.4),
                          {ObjectStatus::kMissed, "table", "table0", "", 0, std::nullopt},
                          {ObjectStatus::kSpurious, "table", "", "o9", 2, std::nullopt}};
  EvaluatedMap objects{Approach::kObjectsLoopClosure, {}, {}, {}};
  objects.by_distance = {Found("chair0", "chair", 0.1), Found("table0", "table", 0.3)};
  named.objects.maps = {odometry, objects};
  return named;
}

SequenceObjects Sequence(const std::vector<NamedObjects>& runs) { return {"office", "", {}, runs}; }

std::vector<PaperObjectErrors> ShippedPaper() {
  return ReadPaperObjectErrors(std::filesystem::path(ARMATURE_SOURCE_DIR) /
                               "results/paper_object_errors.csv");
}

TEST(ObjectTables, Summary) {
  const Table table = ObjectSummaryTable(Sequence({TwoMaps("mine")}));
  ASSERT_EQ(table.rows.size(), 6u);  // two maps; chair, table, all
  EXPECT_EQ(CellText(table, 5, "approach"), "objects, loop closure");
  EXPECT_EQ(CellText(table, 5, "category"), "all");
  EXPECT_EQ(CellText(table, 5, "found"), "2");
  EXPECT_EQ(CellText(table, 5, "best [m]"), "0.1000");
  EXPECT_EQ(CellText(table, 5, "worst [m]"), "0.3000");
  EXPECT_EQ(CellText(table, 5, "average [m]"), "0.2000");
  EXPECT_EQ(CellText(table, 5, "azimuth [deg]"), "10.00");
  EXPECT_EQ(CellText(table, 5, "size [m]"), "0.0500");
  EXPECT_EQ(CellText(table, 5, "IoU"), "0.500");
  EXPECT_EQ(CellText(table, 1, "category"), "table");
  EXPECT_EQ(CellText(table, 1, "missed"), "1");
  EXPECT_EQ(CellText(table, 1, "spurious"), "1");
  EXPECT_EQ(CellText(table, 1, "true"), "1");
  EXPECT_EQ(CellText(table, 1, "best [m]"), "");
  EXPECT_EQ(CellText(table, 2, "observed"), "2");
}

TEST(ObjectTables, RecordsAreOfEachWayOfMatching) {
  NamedObjects run = TwoMaps("mine");
  run.objects.maps[1].by_detections = {Found("chair0", "chair", 2.5)};
  const auto records = MakeObjectRecords(Sequence({run}));
  ASSERT_EQ(records.size(), 9u);  // three of each; odometry names no objects
  EXPECT_EQ(records[2].approach, Approach::kOdometryOnly);
  EXPECT_FALSE(records[2].category) << "all";
  EXPECT_EQ(records[2].missed, 1);
  EXPECT_EQ(records[2].spurious, 1);
  EXPECT_EQ(records[1].category, "table");
  EXPECT_FALSE(records[1].object_error_mean_m) << "none was found";
  EXPECT_EQ(records[5].matched_by, MatchedBy::kDistance);
  EXPECT_DOUBLE_EQ(records[5].object_error_mean_m.value(), 0.2);
  EXPECT_EQ(records[8].matched_by, MatchedBy::kDetections);
  EXPECT_EQ(records[8].object_error_mean_m, 2.5);
}

TEST(ObjectTables, NothingFoundIsADash) {
  NamedObjects run{"mine", {}};
  run.objects.maps = {{Approach::kObjects, {}, {}, {}}};
  const std::vector<Table> tables = {ObjectSummaryTable(Sequence({run})), EachObjectTable(Sequence({run})),
                                     PaperTable({Sequence({run})}, {}),
                                     NormalTermTable(Sequence({run}), {{"mine", {}}})};
  for (const Table& table : tables) {
    EXPECT_EQ(FormatTable(table, TableFormat::kText).find("nan"), std::string::npos);
  }
  EXPECT_EQ(CellText(tables[0], 0, "found"), "0");
  EXPECT_EQ(CellText(tables[0], 0, "average [m]"), "");
  EXPECT_EQ(CellText(tables[2], 0, "# Objects"), "0");
  EXPECT_EQ(CellText(tables[2], 0, "Best"), "");
  EXPECT_EQ(CellText(tables[3], 0, "objects: pitch mean"), "");
}

TEST(ObjectTables, EachObject) {
  const Table table = EachObjectTable(Sequence({TwoMaps("mine")}));
  ASSERT_EQ(table.rows.size(), 5u);
  EXPECT_EQ(CellText(table, 0, "id"), "chair0");
  EXPECT_EQ(CellText(table, 0, "map object"), "map_chair0");
  EXPECT_EQ(CellText(table, 0, "centre [m]"), "0.4000");
  EXPECT_EQ(CellText(table, 0, "azimuth [deg]"), "10.00");
  EXPECT_EQ(CellText(table, 0, "tilt [deg]"), "5.00");
  EXPECT_EQ(CellText(table, 0, "observations"), "7");
  EXPECT_EQ(CellText(table, 1, "status"), "missed");
  EXPECT_EQ(CellText(table, 1, "observations"), "");
  EXPECT_EQ(CellText(table, 2, "id"), "");
  EXPECT_EQ(CellText(table, 2, "status"), "spurious");
  EXPECT_EQ(CellText(table, 2, "observations"), "2");
}

TEST(ObjectTables, NotesSayHowAndAgainstWhat) {
  SequenceObjects sequence = Sequence({TwoMaps("mine"), {"older", {}}});
  sequence.truth_source = "measured by hand, about 2 cm";
  sequence.options.alignment = AlignmentKind::kSim3;
  sequence.runs[0].objects.maps[1].T_truth_run.scale = 1.25;
  for (const Table& table :
       {ObjectSummaryTable(sequence), EachObjectTable(sequence), PaperTable({sequence}, {}),
        NormalTermTable(sequence, {{"mine", {}}, {"older", {}}})}) {
    const std::string notes = NotesText(table);
    EXPECT_NE(notes.find("measured by hand, about 2 cm"), std::string::npos) << notes;
    EXPECT_NE(notes.find("alignment sim3"), std::string::npos) << notes;
    EXPECT_NE(notes.find("mine, objects, loop closure: scale 1.25"), std::string::npos) << notes;
    EXPECT_EQ(notes.find("odometry only: scale"), std::string::npos) << notes;
    EXPECT_NE(notes.find("older: left out, the run folder has no objects.csv"), std::string::npos) << notes;
  }
}

// The summary's average and the paper's row, from the raw rows alone.
TEST(ObjectTables, RawRowsAreEnough) {
  NamedObjects run = TwoMaps("mine");
  run.objects.maps[1].by_detections = {Found("chair0", "chair", 2.5)};
  const std::string csv = RawObjectsCsv({Sequence({run})});
  const testing::TempFolder folder;
  const CsvTable raw(folder.Write("raw.csv", csv), {"map", "matching", "status", "centre_m", "pitch_deg"});
  double sum = 0, by_detections = 0;
  int found = 0;
  for (const CsvRow& row : raw.rows()) {
    EXPECT_EQ(row.Text("normal_term"), "axis");
    EXPECT_EQ(row.Text("loop_closure"), "true");
    if (row.Text("map") != "objects" || row.Text("status") != "found") continue;
    if (row.Text("matching") == "detections") by_detections = row.Number("centre_m");
    if (row.Text("matching") != "distance") continue;
    sum += row.Number("centre_m");
    ++found;
  }
  EXPECT_EQ(raw.rows().size(), 6u);
  EXPECT_EQ(found, 2);
  EXPECT_NEAR(sum / found, 0.2, 1e-9);
  EXPECT_EQ(by_detections, 2.5);
  EXPECT_EQ(raw.rows()[1].Text("status"), "missed");
  EXPECT_TRUE(raw.rows()[1].IsEmpty("centre_m"));
}

TEST(PaperTable, OursThenThePapers) {
  const Table table = PaperTable({Sequence({TwoMaps("mine")})}, ShippedPaper());
  EXPECT_EQ(table.columns,
            (std::vector<std::string>{"Sequence", "Approach", "# Objects", "Best", "Worst", "Average"}));
  ASSERT_EQ(table.rows.size(), 8u);
  EXPECT_EQ(CellText(table, 0, "Sequence"), "office");
  EXPECT_EQ(CellText(table, 0, "Approach"), "odometry only");
  EXPECT_EQ(CellText(table, 0, "# Objects"), "1");
  EXPECT_EQ(CellText(table, 1, "Worst"), "0.3000");
  EXPECT_EQ(CellText(table, 2, "Sequence"), "paper 1");
  EXPECT_EQ(CellText(table, 2, "Approach"), "ORB");
  EXPECT_EQ(CellText(table, 3, "Average"), "0.5030") << "digits as printed";
  EXPECT_EQ(CellText(table, 2, "Average"), "0.457");
  EXPECT_NE(NotesText(table).find("office, odometry only: 1 of 2 observed objects, 1 spurious"),
            std::string::npos);
  EXPECT_EQ(PaperTable({Sequence({TwoMaps("mine")})}, {}).rows.size(), 2u);
}

TEST(PaperTable, FarObjectsCountWhereDetectionsNameThem) {
  NamedObjects run = TwoMaps("mine");
  run.objects.maps[0].by_detections = {Found("chair0", "chair", 0.4), Found("table0", "table", 3.2)};
  const Table table = PaperTable({Sequence({run})}, {});
  EXPECT_EQ(CellText(table, 0, "# Objects"), "2");
  EXPECT_EQ(CellText(table, 0, "Worst"), "3.2000");
}

TEST(PaperTable, SeveralRunsByOneApproachAreNamed) {
  const Table table = PaperTable({Sequence({TwoMaps("mine"), TwoMaps("yours")})}, {});
  EXPECT_EQ(CellText(table, 1, "Approach"), "objects, loop closure (mine)");
  EXPECT_EQ(CellText(table, 3, "Approach"), "objects, loop closure (yours)");
}

TEST(PaperTable, ShippedNumbers) {
  const std::vector<PaperObjectErrors> paper = ShippedPaper();
  ASSERT_EQ(paper.size(), 6u);
  for (const PaperObjectErrors& row : paper) {
    EXPECT_LE(std::stod(row.best), std::stod(row.average)) << row.sequence << row.approach;
    EXPECT_LE(std::stod(row.average), std::stod(row.worst)) << row.sequence << row.approach;
  }
  const std::vector<std::string> notes = OddEntries(paper);
  ASSERT_EQ(notes.size(), 4u);
  EXPECT_EQ(notes[0], "paper 1: Ours is worse than ORB in best (0.1592 > 0.1558), average (0.5030 > 0.457).");
  EXPECT_EQ(notes[1], "paper 2: Ours is worse than ORB in best (1.55 > 1.52).");
  EXPECT_EQ(notes[2], "paper 3: Ours is worse than ORB in best (3.75 > 3.05).");
  // (8 * 3.75 + 4.61) / 9 = 3.846: eight of nine objects at 3.75 exactly, or a misprint.
  EXPECT_TRUE(notes[3].starts_with("paper 3, Ours: 9 objects between 3.75 and 4.61 average 3.85 only if"))
      << notes[3];
}

TEST(PaperTable, OddAverages) {
  const auto notes = [](int objects, const std::string& average) {
    return OddEntries({{"1", "ORB", objects, "1.00", "2.00", average}});
  };
  EXPECT_TRUE(notes(4, "1.50").empty());
  EXPECT_TRUE(notes(2, "1.50").empty());
  ASSERT_EQ(notes(4, "1.10").size(), 1u);
  EXPECT_NE(notes(4, "1.10")[0].find("cannot be"), std::string::npos);
  EXPECT_NE(notes(4, "2.30")[0].find("cannot be"), std::string::npos);
  EXPECT_NE(notes(4, "1.25")[0].find("all but one are the best"), std::string::npos);
  EXPECT_NE(notes(4, "1.75")[0].find("all but one are the worst"), std::string::npos);
}

TEST(PaperTable, BadInput) {
  const testing::TempFolder folder;
  const auto refused = [&](const std::string& row, const std::vector<std::string>& texts) {
    const auto file = folder.Write("p.csv", "sequence,approach,objects,best,worst,average\n" + row);
    ExpectInputError([&] { ReadPaperObjectErrors(file); }, texts);
  };
  refused("1,ORB,7,0.1,x,0.4\n", {"p.csv:2", "worst", "'x'"});
  refused("1,ORB,0,0.1,0.2,0.15\n", {"p.csv:2", "objects"});
}

TEST(NormalTermTable, PitchAndRollOfObjectsAndObservations) {
  NamedObjects without = TwoMaps("without");
  without.objects.configuration.normal_term = "none";
  without.objects.maps[1].by_distance[1].error->orientation.pitch_deg = -9;
  RunEvaluation evaluation;
  evaluation.detections.resize(4);
  const auto observe = [&](size_t i, const std::string& status, double pitch, double roll) {
    evaluation.detections[i].status = status;
    evaluation.detections[i].error = ObservationError{};
    evaluation.detections[i].error->pitch_deg = pitch;
    evaluation.detections[i].error->roll_deg = roll;
  };
  observe(0, "ok", 1, -2);
  observe(1, "ok", -6, 0);
  observe(2, "diverged", 80, 80);  // not relied on; the last one has no pose
  evaluation.detections[3].status = "ok";
  const Table table =
      NormalTermTable(Sequence({TwoMaps("with"), without}), {{"with", {}}, {"without", evaluation}});
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(CellText(table, 0, "normal term"), "axis");
  EXPECT_EQ(CellText(table, 1, "normal term"), "none");
  EXPECT_EQ(CellText(table, 1, "objects"), "2") << "of the map with objects, not of odometry's";
  EXPECT_EQ(CellText(table, 1, "objects: pitch mean"), "6.00");
  EXPECT_EQ(CellText(table, 1, "objects: roll median"), "4.00");
  EXPECT_EQ(CellText(table, 0, "observations: pitch mean"), "");
  EXPECT_EQ(CellText(table, 1, "observations"), "2");
  EXPECT_EQ(CellText(table, 1, "observations: pitch mean"), "3.50");
  EXPECT_EQ(CellText(table, 1, "observations: roll mean"), "1.00");
  EXPECT_THROW(NormalTermTable(Sequence({without}), {}), std::invalid_argument);
}

}  // namespace
}  // namespace armature
