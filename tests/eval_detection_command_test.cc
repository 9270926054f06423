// SPDX-License-Identifier: BSD-3-Clause
// `armature eval SEQUENCE --detections FILE` as its users start it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "eval/detections/true_boxes.h"
#include "io/evaluation_records.h"
#include "support/program.h"
#include "support/true_world.h"

namespace armature {
namespace {

using testing::ExpectBadInput;
using testing::RunOk;
using testing::TrueWorld;

// The world's two images, and its true boxes as detections.
struct DetectedWorld : TrueWorld {
  DetectedWorld() {
    folder.Write("sequence/0.png", "a picture");
    folder.Write("sequence/rgb.txt", "0.0 0.png\n0.2 0.png\n");
    const TrueWireframes wireframes(sequence.truth.objects, models);
    std::string rows = "timestamp,category,x,y,width,height,score\n";
    for (const TimedPose& camera : sequence.truth.T_world_camera) {
      for (const TrueBox& seen : wireframes.Seen(sequence.camera, camera.pose)) {
        rows += fmt::format("{:.6f},{},{},{},{},{},0.9\n", camera.timestamp,
                            sequence.truth.objects[seen.object].category, seen.visible.x, seen.visible.y,
                            seen.visible.width, seen.visible.height);
      }
    }
    detections = folder.Write("boxes.csv", rows);
    truth = folder / "sequence";
  }

  std::string detections, truth;
};

TEST(EvalDetections, ThoseOfAFileAreJudgedByTheTruthOfTheSequence) {
  const DetectedWorld world;
  const std::string out = world.folder / "judged";
  const auto result = RunOk({"eval", world.truth, "--detections", world.detections, "--json", "--out", out});
  const auto tables = nlohmann::json::parse(result.out);
  ASSERT_EQ(tables.size(), 2U);
  EXPECT_EQ(tables[0]["table"], "detections");
  EXPECT_EQ(tables[0]["sequence"], "world");
  ASSERT_EQ(tables[0]["rows"].size(), 3U);
  for (const auto& row : tables[0]["rows"]) {
    EXPECT_EQ(row["recall [%]"], 100.0);
    EXPECT_EQ(row["precision [%]"], 100.0);
    EXPECT_EQ(row["views"], 0);
    EXPECT_TRUE(row["azimuth [deg]"].is_null());
  }
  const EvaluationRecords records = ReadEvaluationRecords(out + "/records.json");
  ASSERT_EQ(records.detections.size(), 3U);
  EXPECT_EQ(records.detections[0].category, "chair");
  EXPECT_EQ(records.detections[0].recall_share, 1);
  EXPECT_FALSE(records.detections[0].azimuth_median_deg);
}

TEST(EvalDetections, ThoseOfSequencesAreATable) {
  const DetectedWorld world;
  std::filesystem::copy(world.detections, world.truth + "/detections.csv");
  world.folder.Write("sequence/detections_gt.csv", "timestamp,index,id\n");
  const auto result = RunOk({"eval", world.truth, world.truth, "--tables", "detections", "--json"});
  EXPECT_EQ(nlohmann::json::parse(result.out).size(), 4U);
}

TEST(EvalDetections, BadInput) {
  const DetectedWorld world;
  ExpectBadInput({"eval", world.truth, world.truth, "--detections", world.detections},
                 {"--detections", "name one"});
  ExpectBadInput({"eval", "--detections", world.detections}, {"no sequence"});
  ExpectBadInput({"eval", world.folder / "cad", "--detections", world.detections}, {"cad", "sequence.yaml"});
  ExpectBadInput({"eval", world.truth, "--detections", world.detections, "--tables", "objects"},
                 {"detections", "alone"});
  const std::string bad =
      world.folder.Write("bad.csv", "timestamp,category,x,y,width,height,score\n0.0,cat,1,1,9,9,1\n");
  ExpectBadInput({"eval", world.truth, "--detections", bad}, {"bad.csv:2", "cat"});
}

}  // namespace
}  // namespace armature
