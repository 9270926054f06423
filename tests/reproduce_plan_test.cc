// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "app/reproduce/plan_jobs.h"
#include "base/shell_text.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

using testing::TempFolder;

Matrix PlannedMatrix() {
  Matrix matrix;
  matrix.data = "/data";
  matrix.scenes = {"seq1", "seq2"};
  matrix.categories = {{.name = "chair", .padding = {0.5, 0, 0.25}, .slab_drop = 0.125}};
  matrix.variants = {{.name = "objects"},
                     {.name = "plain", .preset = "fast", .config = "/c/plain.yaml"},
                     {.name = "odometry", .odometry_of = "objects"}};
  matrix.retrieval = {"objects"};
  matrix.timings = {
      {.name = "stages", .sequences = {"seq2"}, .tables = {"comparison"}, .engines = {"lines"}}};
  return matrix;
}

const PlanFolders kFolders{.results = "/r/name.partial", .configs = "/c"};

const Job& Named(const std::string& name, const std::vector<Job>& jobs) {
  for (const Job& job : jobs) {
    if (job.name == name) return job;
  }
  throw std::out_of_range("no job " + name);
}

std::string CallOf(const Job& job, size_t call = 0) { return ShellText(job.commands.at(call)); }

JobRecord Done(const std::string& name) { return {.name = name, .status = JobStatus::kDone}; }

TEST(ReproducePlan, CallsAreMadeInTheFolderOfResults) {
  const std::vector<Job> jobs = PlanRuns(PlannedMatrix(), kFolders);
  EXPECT_EQ(CallOf(Named("data", jobs)), "armature generate --only seq1,seq2 --out ../../data");
  EXPECT_EQ(CallOf(Named("categories/chair", jobs)),
            "armature learn --spec ../../c/categories/specs/chair.yaml --annotations "
            "../../data/cad/chair_edges.csv "
            "--format edges --metric --padding 0.5,0,0.25 --out categories/chair.yaml --slab-drop 0.125");
  EXPECT_EQ(CallOf(Named("runs/plain/seq2", jobs)),
            "armature run ../../data/seq2 --out runs/plain/seq2 --preset fast --config ../../c/plain.yaml "
            "--categories categories");
  EXPECT_EQ(CallOf(Named("timings/stages", jobs)),
            "armature bench ../../data/seq2 --tables comparison --baseline-frames 12 --out timings/stages "
            "--engines "
            "lines --categories categories");
}

TEST(ReproducePlan, CategoriesThatAreThereAreNotLearnt) {
  Matrix matrix = PlannedMatrix();
  matrix.categories.clear();
  matrix.category_folder = "/models";
  const std::vector<Job> jobs = PlanRuns(matrix, kFolders);
  const Job& run = Named("runs/plain/seq2", jobs);
  EXPECT_NE(CallOf(run).find("--categories ../../models"), std::string::npos) << CallOf(run);
  EXPECT_NE(std::find(run.inputs.begin(), run.inputs.end(), "../../models"), run.inputs.end());
  EXPECT_EQ(run.after, std::vector<std::string>{"data"});
}

TEST(ReproducePlan, OnlyVariantsWithRunsOfTheirOwnAreRun) {
  std::vector<std::string> names;
  for (const Job& job : PlanRuns(PlannedMatrix(), kFolders)) names.push_back(job.name);
  EXPECT_EQ(names, (std::vector<std::string>{"data", "categories/chair", "library", "runs/objects/seq1",
                                             "runs/objects/seq2", "runs/plain/seq1", "runs/plain/seq2",
                                             "timings/stages"}));
}

TEST(ReproducePlan, RetrievalIsOfItsVariantsAndNeedsTheLibrary) {
  const std::vector<Job> jobs = PlanRuns(PlannedMatrix(), kFolders);
  const Job& retrieved = Named("runs/objects/seq1", jobs);
  ASSERT_EQ(retrieved.commands.size(), 2u);
  EXPECT_EQ(CallOf(retrieved, 1),
            "armature retrieve runs/objects/seq1 --library library.armlib --place --categories categories");
  EXPECT_EQ(retrieved.after, (std::vector<std::string>{"categories/chair", "data", "library"}));
  EXPECT_EQ(Named("runs/plain/seq1", jobs).commands.size(), 1u);
}

TEST(ReproducePlan, TimingsAndRenderingAreAlone) {
  for (const Job& job : PlanRuns(PlannedMatrix(), kFolders))
    EXPECT_EQ(job.alone, job.name == "data" || job.name == "timings/stages") << job.name;
}

TEST(ReproducePlan, FramesAndDrawsReachEveryCall) {
  Matrix matrix = PlannedMatrix();
  matrix.frames = 7;
  matrix.seeds = 2;
  const std::vector<Job> jobs = PlanRuns(matrix, kFolders);
  EXPECT_EQ(CallOf(Named("data-draw2", jobs)),
            "armature generate --only seq1,seq2 --out ../../data/draw2 --draw 2 --without-cad --frames 7");
  EXPECT_NE(CallOf(Named("runs/objects/seq1-draw2", jobs)).find("../../data/draw2/seq1-draw2"),
            std::string::npos);
  EXPECT_NE(CallOf(Named("runs/objects/seq1", jobs)).find("--frames 7"), std::string::npos);
  EXPECT_NE(CallOf(Named("timings/stages", jobs)).find("--frames 7"), std::string::npos);
}

TEST(ReproducePlan, WhatFailedIsNotEvaluatedNorReported) {
  const TempFolder folder;
  folder.Write("data/seq1/groundtruth.txt", "");
  Matrix matrix = PlannedMatrix();
  matrix.data = folder / "data";
  const std::vector<JobRecord> done{Done("runs/objects/seq1"),
                                    {.name = "runs/plain/seq1", .status = JobStatus::kFailed},
                                    {.name = "library", .status = JobStatus::kReused}};
  const std::vector<Job> jobs = PlanEvaluation(matrix, kFolders, done);
  ASSERT_EQ(jobs.size(), 3u);
  EXPECT_EQ(CallOf(jobs[0]), "armature eval runs/objects --out evaluation/accuracy --categories categories");
  EXPECT_EQ(jobs[2].name, "evaluation/library");
  const Job report = PlanReport(matrix, kFolders, {Done("runs/objects/seq1"), Done("evaluation/accuracy")},
                                {.tables = {"m.json"}});
  EXPECT_EQ(
      CallOf(report),
      "armature report runs/objects --eval evaluation/accuracy --table m.json --title 'Armature: reproduce' "
      "--out report.html --categories categories");
}

TEST(ReproducePlan, WithoutAnyTruthThereIsNothingToEvaluate) {
  EXPECT_TRUE(PlanEvaluation(PlannedMatrix(), kFolders, {Done("runs/objects/seq1")}).empty());
}

Matrix RoomMatrix() {
  Matrix matrix;
  matrix.data = "/data";
  matrix.rooms =
      RoomSet{.recipe = "/c/rooms/mixed.yaml", .name = "mixed", .count = 2, .collections = {"/cad"}};
  matrix.variants = {{.name = "default"}, {.name = "fast", .preset = "fast", .detections = "/network"}};
  matrix.jitter = 1;
  return matrix;
}

TEST(ReproducePlan, RoomsAreMadeOneByOneAndThenRun) {
  const std::vector<Job> jobs = PlanRuns(RoomMatrix(), kFolders);
  ASSERT_EQ(jobs.size(), 2u + 2 * 2 * 2);
  const Job& room = Named("rooms/mixed-development-001", jobs);
  EXPECT_EQ(
      CallOf(room),
      "armature generate --rooms ../../c/rooms/mixed.yaml --count 1 --first 1 --split development --out "
      "../../data/rooms-cad --collection ../../cad");
  EXPECT_TRUE(room.always) << "generate looks for itself what is there";
  const Job& run = Named("runs/fast/mixed-development-001", jobs);
  EXPECT_EQ(CallOf(run),
            "armature run ../../data/rooms-cad/mixed-development-001 --out runs/fast/mixed-development-001 "
            "--preset fast "
            "--detections ../../network/mixed-development-001.csv");
  EXPECT_EQ(run.after, std::vector<std::string>{"rooms/mixed-development-001"});
}

TEST(ReproducePlan, RoomsOfASeedAreCalledByIt) {
  Matrix matrix = RoomMatrix();
  matrix.rooms->split = "17";
  matrix.rooms->lines_only = true;
  const std::string call = CallOf(Named("rooms/mixed-17-000", PlanRuns(matrix, kFolders)));
  EXPECT_NE(call.find("--first 0 --seed 17"), std::string::npos) << call;
  EXPECT_NE(call.find("data/rooms-cad-lines --collection ../../cad --lines-only"), std::string::npos) << call;
}

TEST(ReproducePlan, RepeatsAreRunsOfTheirOwn) {
  const Job repeat = Named("jitter/default-1/mixed-development-000", PlanRuns(RoomMatrix(), kFolders));
  EXPECT_EQ(
      CallOf(repeat),
      "armature run ../../data/rooms-cad/mixed-development-000 --out jitter/default-1/mixed-development-000 "
      "--preset default --jitter 1");
}

TEST(ReproducePlan, RoomsAreEvaluatedOverAllOfThem) {
  const testing::TempFolder folder;
  Matrix matrix = RoomMatrix();
  matrix.data = folder.path();
  folder.Write("rooms-cad/mixed-development-000/groundtruth.txt", "");
  const std::vector<Job> jobs = PlanEvaluation(
      matrix, kFolders,
      {Done("runs/default/mixed-development-000"), Done("jitter/default-1/mixed-development-000")});
  ASSERT_EQ(jobs.size(), 1u) << "not a table a room";
  EXPECT_EQ(jobs[0].name, kRoomsJob);
  EXPECT_NE(CallOf(jobs[0]).find("eval runs/default jitter/default-1 --tables rooms,"), std::string::npos)
      << CallOf(jobs[0]);
  const Job report =
      PlanReport(matrix, kFolders, {Done("runs/default/mixed-development-000"), Done(kRoomsJob)},
                 {.runs = {"runs/default/mixed-development-000"}});
  EXPECT_NE(CallOf(report).find("report runs/default/mixed-development-000 --eval evaluation/rooms"),
            std::string::npos)
      << CallOf(report);
}

}  // namespace
}  // namespace armature
