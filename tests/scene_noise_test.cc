// SPDX-License-Identifier: BSD-3-Clause
// What a scene file says of detector and odometry.
#include <gtest/gtest.h>

#include "datasets/scene/scene_yaml.h"
#include "datasets/simulation/detector_settings.h"
#include "support/expect_input_error.h"
#include "support/temp_folder.h"

namespace armature {
namespace {

using testing::ExpectInputError;
using testing::TempFolder;

Scene ReadNoise(const std::string& text) {
  const TempFolder folder;
  return ReadScene(folder.Write("noise.yaml", "name: noise\n" + text), {}, 1);
}

TEST(SceneNoise, TheDefaultSettingIsTheDetectorThatForgets) {
  const DetectorNoise noise = ReadNoise("").detections;
  EXPECT_TRUE(noise.of.empty());
  EXPECT_EQ(noise.any.box, DetectionNoise().box);
  EXPECT_EQ(noise.any.box_lasting, 0);
  EXPECT_EQ(ReadNoise("detections: {setting: simulated, box: 0.03}\n").detections.any.box, 0.03);
}

TEST(SceneNoise, ASettingCanBeOverriddenForAllCategoriesAndForOne) {
  const DetectorNoise network = MakeDetectorNoise(DetectorSetting::kNetwork);
  const DetectorNoise noise =
      ReadNoise("detections:\n  setting: network\n  box: 0.123\n  table: {box: 0.2, missed: 0.5}\n")
          .detections;
  EXPECT_EQ(noise.Of("chair").box, 0.123);
  EXPECT_EQ(noise.Of("laptop").box, 0.123);
  EXPECT_EQ(noise.Of("table").box, 0.2);
  EXPECT_EQ(noise.Of("table").missed, 0.5);
  EXPECT_EQ(noise.Of("chair").missed, network.Of("chair").missed);
  EXPECT_EQ(noise.Of("table").elevation_bias_deg, network.Of("table").elevation_bias_deg);
}

TEST(SceneNoise, ACategoryOfItsOwnKeepsWhatIsSaidForAll) {
  const DetectorNoise noise = ReadNoise("detections: {missed: 0.3, chair: {box: 0.1}}\n").detections;
  EXPECT_EQ(noise.Of("chair").missed, 0.3);
  EXPECT_EQ(noise.Of("chair").box, 0.1);
  EXPECT_EQ(noise.Of("table").box, DetectionNoise().box);
}

TEST(SceneNoise, ReadsWhatStays) {
  const DetectionNoise noise =
      ReadNoise(
          "detections: {box_lasting: 0.5, box_seconds: 2, missed_seconds: 3, part: 0.4, spanning: 0.1, "
          "duplicates: 0.2, mistaken: 0.3, distractors: 0.6, lasting_alarms: 2, no_viewpoint: 0.7, "
          "astray: 0.8, elevation_bias_deg: -9, score: 0.1}\n")
          .detections.any;
  EXPECT_EQ(noise.box_seconds, 2);
  EXPECT_EQ(noise.missed_seconds, 3);
  EXPECT_EQ(noise.distractors, 0.6);
  EXPECT_EQ(noise.lasting_alarms, 2);
  EXPECT_EQ(noise.elevation_bias_deg, -9);
}

TEST(SceneNoise, NamesTheLineOfWhatIsNoSettingNoFieldOrNoShare) {
  ExpectInputError([] { ReadNoise("detections:\n  setting: netwrok\n"); }, {"noise.yaml:3", "network"});
  ExpectInputError([] { ReadNoise("detections:\n  box_lastin: 1\n"); }, {"noise.yaml:3", "box_lasting"});
  ExpectInputError([] { ReadNoise("detections:\n  table:\n    part: 1.5\n"); }, {"noise.yaml:4", "1.5"});
  // False alarms are so many a picture, of whatever category.
  ExpectInputError([] { ReadNoise("detections:\n  table: {false_alarms: 1}\n"); },
                   {"noise.yaml:3", "false_alarms"});
}

TEST(SceneNoise, ReadsWhereTheOdometryIsLost) {
  const OdometryNoise at =
      ReadNoise("odometry: {lost: {at: 4, seconds: 1.5}, scale_jump: 0.3, turn_scale_drift: 0.1}\n").odometry;
  EXPECT_EQ(at.lost_at, 4);
  EXPECT_EQ(at.lost_seconds, 1.5);
  EXPECT_EQ(at.scale_jump, 0.3);
  EXPECT_EQ(at.turn_scale_drift, 0.1);
  const OdometryNoise share = ReadNoise("odometry: {lost: {share: 0.1}}\n").odometry;
  EXPECT_FALSE(share.lost_at);
  EXPECT_EQ(share.lost_share, 0.1);
  EXPECT_EQ(ReadNoise("odometry: {kind: none}\n").odometry.kind, OdometryKind::kNone);
}

TEST(SceneNoise, ReportsTwoTimesAtWhichTheOdometryIsLost) {
  ExpectInputError([] { ReadNoise("odometry:\n  lost: {at: 4, share: 0.1}\n"); }, {"noise.yaml:3", "share"});
  ExpectInputError([] { ReadNoise("odometry: {lost: {at: 0}}\n"); }, {"noise.yaml:2", "at"});
  ExpectInputError([] { ReadNoise("odometry: {kind: stereo}\n"); }, {"noise.yaml:2", "monocular"});
}

}  // namespace
}  // namespace armature
