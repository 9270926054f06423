// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/simulation/detector_settings.h"

namespace armature {
namespace {

// What all have in common: errors of boxes that stay, no alarm that is there for one frame, scores a little
// above the threshold, no viewpoints.
DetectionNoise OfNetwork() {
  DetectionNoise noise;
  noise.false_alarms = 0;
  noise.min_visible = 0.2;
  noise.box_lasting = 0.8;
  noise.box_seconds = 1;
  noise.missed_seconds = 0.7;
  noise.missed_spread = 0.8;
  noise.turned = 0;
  noise.no_viewpoint = 1;
  noise.score = 0.3;
  noise.score_visible = 0.25;
  return noise;
}

DetectionNoise NetworkChair() {
  DetectionNoise chair = OfNetwork();
  chair.box = 0.1;
  chair.box_lasting = 0.85;
  chair.box_seconds = 1.2;
  chair.missed = 0.05;
  chair.missed_hidden = 5;
  chair.part = 0.3;
  chair.duplicates = 0.25;
  chair.duplicates_seconds = 0.4;
  chair.mistaken = 0.18;
  chair.mistaken_seconds = 0.8;
  chair.distractors = 0.5;
  chair.distractors_seconds = 1.5;
  chair.lasting_alarms = 0.3;
  chair.lasting_alarms_seconds = 0.6;
  chair.no_viewpoint = 0.05;
  chair.no_viewpoint_seconds = 0.4;
  chair.azimuth_deg = 13;
  chair.elevation_deg = 7;
  chair.tilt_deg = 6;
  chair.viewpoint_lasting = 0.6;
  chair.viewpoint_seconds = 1;
  chair.astray = 0.1;
  chair.astray_seconds = 2;
  chair.elevation_bias_deg = 6;
  return chair;
}

DetectionNoise NetworkTable() {
  DetectionNoise table = OfNetwork();
  table.box = 0.05;
  table.missed = 0.02;
  table.missed_spread = 0.3;
  table.part = 0.2;
  table.spanning = 0.15;
  table.duplicates = 0.07;
  table.duplicates_seconds = 0.4;
  table.mistaken = 0.12;
  table.mistaken_seconds = 0.8;
  table.distractors = 0.7;
  table.distractors_seconds = 2;
  table.lasting_alarms = 1.1;
  table.lasting_alarms_seconds = 0.8;
  return table;
}

// It found none.
DetectionNoise NetworkLaptop() {
  DetectionNoise laptop = OfNetwork();
  laptop.missed = 1;
  return laptop;
}

}  // namespace

DetectorNoise MakeDetectorNoise(DetectorSetting setting) {
  if (setting == DetectorSetting::kSimulated) return {};
  return {OfNetwork(), {{"chair", NetworkChair()}, {"table", NetworkTable()}, {"laptop", NetworkLaptop()}}};
}

}  // namespace armature
