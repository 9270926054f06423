// SPDX-License-Identifier: BSD-3-Clause
// What the simulated detector gets wrong over a whole sequence, a kind of error at a time.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "datasets/simulation/detections.h"
#include "datasets/simulation/detector_settings.h"
#include "geometry/rotation.h"
#include "geometry/viewpoint.h"

namespace armature {
namespace {

constexpr double kStep = 0.1;  // seconds
const Camera kView{640, 480, 500, 500, 319.5, 239.5};
const Box kChairBox{270, 190, 100, 100}, kTableBox{100, 200, 200, 120}, kSofaBox{400, 200, 120, 90};

DetectionNoise Faultless() {
  return {.box = 0,
          .missed = 0,
          .false_alarms = 0,
          .azimuth_deg = 0,
          .elevation_deg = 0,
          .tilt_deg = 0,
          .turned = 0};
}

// A chair and a table, and what stands beside them.
DetectableScene ChairTableAndSofa() {
  DetectableScene scene{
      .camera = kView, .objects = {{"c", "chair"}, {"t", "table"}}, .distractors = {{"sofa"}}};
  scene.objects[0].T_world_object.translation() = Eigen::Vector3d(0, 0, 3);
  scene.objects[0].T_world_object.linear() = RotationFromViewpoint({0.4, 0.2, 0.05}, {0, 0, 3});
  scene.objects[1].T_world_object.translation() = Eigen::Vector3d(-0.6, 0, 3);
  scene.objects[1].size = Eigen::Vector3d(1.2, 0.75, 0.8);
  return scene;
}

std::vector<SeenFrame> Still(const std::vector<VisibleObject>& visible, int frames) {
  std::vector<SeenFrame> seen;
  for (int i = 0; i < frames; ++i) seen.push_back({kStep * i, Eigen::Isometry3d::Identity(), visible});
  return seen;
}

using Frames = std::vector<std::vector<SimulatedDetection>>;

Frames Detect(const std::vector<VisibleObject>& visible, const DetectorNoise& noise, int frames = 4000,
              std::uint64_t seed = 1) {
  return SimulateDetections(Still(visible, frames), ChairTableAndSofa(), noise, seed);
}

VisibleObject Chair(double share = 1) { return {1, kChairBox, share}; }
VisibleObject Table() { return {2, kTableBox, 1}; }
VisibleObject Sofa() { return {3, kSofaBox, 1}; }

// Of all frames in which `is` holds, the share and the mean number in a row.
template <typename Is>
std::pair<double, double> ShareAndRun(const Frames& frames, const Is& is) {
  double on = 0, runs = 0;
  bool was = false;
  for (const auto& frame : frames) {
    const bool now = is(frame);
    on += now;
    runs += now && !was;
    was = now;
  }
  return {on / static_cast<double>(frames.size()), on / runs};
}

TEST(SimulatedDetector, BoxErrorsStayAsLongAndAsMuchAsAsked) {
  DetectionNoise noise = Faultless();
  noise.box = 0.05;
  noise.box_lasting = 0.8;
  noise.box_seconds = 1;
  const Frames frames = Detect({Chair()}, {noise, {}}, 20000);
  double variance = 0, next = 0, after_one_second = 0;
  std::vector<double> errors;
  for (const auto& frame : frames) errors.push_back((frame.at(0).detection.box.left() - 270) / 100);
  for (size_t i = 0; i + 10 < errors.size(); ++i) {
    variance += errors[i] * errors[i];
    next += errors[i] * errors[i + 1];
    after_one_second += errors[i] * errors[i + 10];
  }
  EXPECT_NEAR(std::sqrt(variance / 20000), 0.05, 0.003);
  EXPECT_NEAR(next / variance, 0.8 * std::exp(-0.1), 0.03);
  EXPECT_NEAR(after_one_second / variance, 0.8 * std::exp(-1), 0.05);
}

TEST(SimulatedDetector, MissesComeInBursts) {
  DetectionNoise noise = Faultless();
  noise.missed = 0.25;
  noise.missed_seconds = 1.5;
  const auto [share, run] =
      ShareAndRun(Detect({Chair()}, {noise, {}}, 60000), [](const auto& frame) { return frame.empty(); });
  EXPECT_NEAR(share, 0.25, 0.03);
  EXPECT_NEAR(run, 16, 1.5);  // 15 and the half frames at its ends
}

TEST(SimulatedDetector, MissesMoreOfWhatIsHiddenAndOfHardObjects) {
  DetectionNoise noise = Faultless();
  noise.missed = 0.2;
  noise.missed_hidden = 2;
  const auto is_missed = [](const auto& frame) { return frame.empty(); };
  EXPECT_NEAR(ShareAndRun(Detect({Chair(1)}, {noise, {}}), is_missed).first, 0.2, 0.03);
  // Log odds of 0.2 are -1.386; with half of it hidden they are -0.386.
  EXPECT_NEAR(ShareAndRun(Detect({Chair(0.5)}, {noise, {}}), is_missed).first, 0.405, 0.03);
  noise.missed_spread = 3;
  std::vector<double> shares;
  for (std::uint64_t seed = 0; seed < 20; ++seed)
    shares.push_back(ShareAndRun(Detect({Chair(1)}, {noise, {}}, 300, seed), is_missed).first);
  EXPECT_LT(*std::min_element(shares.begin(), shares.end()), 0.05);
  EXPECT_GT(*std::max_element(shares.begin(), shares.end()), 0.8);
}

TEST(SimulatedDetector, BoxesPartsOfWhatIsPartlyHidden) {
  DetectionNoise noise = Faultless();
  noise.part = 0.8;
  noise.part_seconds = 1;
  const auto is_part = [](const auto& frame) {
    const Box& box = frame.at(0).detection.box;
    EXPECT_GE(box.left(), kChairBox.left() - 1e-9);
    EXPECT_LE(box.bottom(), kChairBox.bottom() + 1e-9);
    return box.area() < 0.9 * kChairBox.area();
  };
  EXPECT_EQ(ShareAndRun(Detect({Chair(1)}, {noise, {}}), is_part).first, 0);
  const auto [share, run] = ShareAndRun(Detect({Chair(0.5)}, {noise, {}}, 20000), is_part);
  EXPECT_NEAR(share, 0.4, 0.06);
  EXPECT_GT(run, 8);
}

TEST(SimulatedDetector, ATableSpansTheChairsAtIt) {
  DetectionNoise noise = Faultless();
  noise.spanning = 0.5;
  noise.spanning_seconds = 2;
  const auto spans = [](const auto& frame) {
    const auto table = std::find_if(frame.begin(), frame.end(), [](const auto& d) { return d.id == "t"; });
    return std::abs(table->detection.box.right() - kChairBox.right()) < 1e-9 &&
           std::abs(table->detection.box.top() - kChairBox.top()) < 1e-9;
  };
  const auto [share, run] = ShareAndRun(Detect({Chair(), Table()}, {noise, {}}, 20000), spans);
  EXPECT_NEAR(share, 0.5, 0.06);
  EXPECT_GT(run, 15);
  DetectableScene apart = ChairTableAndSofa();
  apart.objects[0].T_world_object.translation() = Eigen::Vector3d(2, 0, 3);
  const Frames frames = SimulateDetections(Still({Chair(), Table()}, 500), apart, {noise, {}}, 1);
  EXPECT_EQ(ShareAndRun(frames, spans).first, 0);
}

TEST(SimulatedDetector, DuplicatesAreOfTheSameObject) {
  DetectionNoise noise = Faultless();
  noise.box = 0.02;
  noise.duplicates = 0.3;
  noise.duplicates_seconds = 0;
  const auto is_double = [](const auto& frame) {
    for (const SimulatedDetection& d : frame) {
      EXPECT_EQ(d.id, "c");
      EXPECT_EQ(d.detection.category, "chair");
    }
    if (frame.size() == 2) {
      EXPECT_NE(frame[0].detection.box.x, frame[1].detection.box.x);
    }
    return frame.size() == 2;
  };
  EXPECT_NEAR(ShareAndRun(Detect({Chair()}, {noise, {}}), is_double).first, 0.3, 0.03);
}

TEST(SimulatedDetector, TakesAChairsSeatForATable) {
  DetectionNoise noise = Faultless();
  noise.missed = 1;
  noise.mistaken = 0.4;
  noise.mistaken_seconds = 1;
  const auto is_mistaken = [](const auto& frame) {
    for (const SimulatedDetection& d : frame) {
      EXPECT_EQ(d.id, "");
      EXPECT_EQ(d.detection.category, "table");
      EXPECT_NEAR(d.detection.box.bottom(), kChairBox.bottom(), 1e-9);
      EXPECT_GT(d.detection.box.top(), kChairBox.top() + 20);
    }
    return !frame.empty();
  };
  EXPECT_NEAR(ShareAndRun(Detect({Chair()}, {noise, {}}, 20000), is_mistaken).first, 0.4, 0.05);
}

TEST(SimulatedDetector, TakesASofaForAChairForStretchesOfTime) {
  DetectionNoise noise = Faultless();
  noise.distractors = 0.6;
  noise.distractors_seconds = 3;
  const auto is_taken = [](const auto& frame) {
    for (const SimulatedDetection& d : frame) {
      EXPECT_EQ(d.id, "");
      EXPECT_EQ(d.detection.category, "chair");
      EXPECT_NEAR(d.detection.box.x, kSofaBox.x, 1e-9);
    }
    return !frame.empty();
  };
  const auto [share, run] = ShareAndRun(Detect({Sofa()}, {noise, {}}, 40000), is_taken);
  EXPECT_NEAR(share, 0.6, 0.06);
  EXPECT_NEAR(run, 31, 6);
}

TEST(SimulatedDetector, FalseAlarmsOfTheBackgroundStayAtTheirPlaces) {
  DetectorNoise noise{Faultless(), {}};
  noise.of["table"] = Faultless();
  noise.of["table"].lasting_alarms = 1;
  noise.of["table"].lasting_alarms_seconds = 2;
  const Frames frames = Detect({}, noise, 20000);
  double count = 0, stay = 0;
  for (size_t i = 0; i < frames.size(); ++i) {
    for (const SimulatedDetection& d : frames[i]) {
      EXPECT_EQ(d.detection.category, "table");
      ++count;
      const auto& last = frames[i > 0 ? i - 1 : 0];
      stay += std::any_of(last.begin(), last.end(), [&](const auto& l) {
        return std::abs(l.detection.box.x - d.detection.box.x) < 1e-9;
      });
    }
  }
  EXPECT_NEAR(count / 20000, 0.95, 0.2);  // some are half outside
  EXPECT_NEAR(stay / count, std::exp(-0.05), 0.01);
}

TEST(SimulatedDetector, AViewpointIsMissingOrAstrayForStretches) {
  DetectionNoise noise = Faultless();
  noise.no_viewpoint = 0.3;
  noise.no_viewpoint_seconds = 2;
  noise.astray = 0.25;
  noise.astray_seconds = 2;
  noise.elevation_bias_deg = 8;
  const Frames frames = Detect({Chair()}, {noise, {}}, 40000);
  const auto [missing, missing_run] =
      ShareAndRun(frames, [](const auto& frame) { return !frame.at(0).detection.azimuth; });
  EXPECT_NEAR(missing, 0.3, 0.04);
  EXPECT_NEAR(missing_run, 21, 4);
  const Viewpoint truth = ViewpointFromRotation(ChairTableAndSofa().objects[0].T_world_object.linear(),
                                                kView.Ray(kChairBox.center()));
  double given = 0, astray = 0;
  for (const auto& frame : frames) {
    const Detection& d = frame.at(0).detection;
    if (!d.azimuth) continue;
    ++given;
    EXPECT_NEAR(*d.elevation, truth.elevation + 8 * kDegree, 1e-9);
    const double off = std::abs(WrapAngle(*d.azimuth - truth.azimuth)) / kDegree;
    if (off < 1e-6) continue;
    ++astray;
    EXPECT_GE(off, 60 - 1e-6);
    EXPECT_LE(off, 120 + 1e-6);  // front and back are not taken for each other
  }
  EXPECT_NEAR(astray / given, 0.25, 0.05);
}

TEST(SimulatedDetector, TurnsViewpointsForWholeTracks) {
  DetectionNoise noise = Faultless();
  noise.turned = 0.5;
  noise.turned_seconds = 1e6;
  int turned_tracks = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Frames frames = Detect({Chair()}, {noise, {}}, 5, seed);
    for (const auto& frame : frames)
      EXPECT_EQ(*frame.at(0).detection.azimuth, *frames[0].at(0).detection.azimuth);
    turned_tracks += std::abs(WrapAngle(*frames[0].at(0).detection.azimuth - 0.4)) > 1 ? 1 : 0;
  }
  EXPECT_NEAR(turned_tracks, 100, 30);
}

TEST(SimulatedDetector, HasErrorsOfItsOwnForEachCategory) {
  DetectorNoise noise{Faultless(), {}};
  noise.of["table"] = Faultless();
  noise.of["table"].missed = 1;
  for (const auto& frame : Detect({Chair(), Table()}, noise, 10)) {
    ASSERT_EQ(frame.size(), 1U);
    EXPECT_EQ(frame[0].id, "c");
  }
}

bool AreEqual(const std::vector<SimulatedDetection>& a, const std::vector<SimulatedDetection>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    return x.id == y.id && x.detection.category == y.detection.category &&
           x.detection.box.x == y.detection.box.x && x.detection.box.height == y.detection.box.height &&
           x.detection.azimuth == y.detection.azimuth && x.detection.score == y.detection.score;
  });
}

TEST(SimulatedDetector, WhatIsFoundDoesNotDependOnLaterFrames) {
  const DetectorNoise network = MakeDetectorNoise(DetectorSetting::kNetwork);
  const Frames all = Detect({Chair(0.8), Table(), Sofa()}, network, 60);
  const Frames first = Detect({Chair(0.8), Table(), Sofa()}, network, 20);
  for (size_t i = 0; i < first.size(); ++i) EXPECT_TRUE(AreEqual(first[i], all[i])) << i;
  const Frames other = Detect({Chair(0.8), Table(), Sofa()}, network, 20, 2);
  EXPECT_FALSE(std::equal(first.begin(), first.end(), other.begin(), AreEqual));
}

}  // namespace
}  // namespace armature
