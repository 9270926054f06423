// SPDX-License-Identifier: BSD-3-Clause
// What the simulated detector of a scene file does wrong.
#include <algorithm>

#include "datasets/scene/scene_fields.h"
#include "datasets/scene/scene_sections.h"
#include "datasets/simulation/detector_settings.h"

namespace armature {
namespace {

const std::vector<std::string> kDetectedCategories = {"chair", "table", "laptop"};

constexpr double kLongestStay = 1e6;  // seconds

OptionEntry ShareField(const char* key, double* field) { return Option(key, field, "", 0, 1); }
OptionEntry SecondsField(const char* key, double* field) { return Option(key, field, "", 0, kLongestStay); }

std::vector<OptionEntry> DetectionFields(DetectionNoise* n) {
  return {Option("box", &n->box, "", 0, 0.5),
          ShareField("missed", &n->missed),
          Option("false_alarms", &n->false_alarms, "", 0, 100),
          ShareField("min_visible", &n->min_visible),
          Option("min_size_px", &n->min_size_px, "", 0, 10000),
          Option("azimuth_deg", &n->azimuth_deg, "", 0, 180),
          Option("elevation_deg", &n->elevation_deg, "", 0, 90),
          Option("tilt_deg", &n->tilt_deg, "", 0, 180),
          ShareField("turned", &n->turned),
          ShareField("box_lasting", &n->box_lasting),
          SecondsField("box_seconds", &n->box_seconds),
          ShareField("viewpoint_lasting", &n->viewpoint_lasting),
          SecondsField("viewpoint_seconds", &n->viewpoint_seconds),
          SecondsField("missed_seconds", &n->missed_seconds),
          Option("missed_spread", &n->missed_spread, "", 0, 20),
          Option("missed_hidden", &n->missed_hidden, "", 0, 20),
          ShareField("part", &n->part),
          SecondsField("part_seconds", &n->part_seconds),
          ShareField("spanning", &n->spanning),
          SecondsField("spanning_seconds", &n->spanning_seconds),
          ShareField("duplicates", &n->duplicates),
          SecondsField("duplicates_seconds", &n->duplicates_seconds),
          ShareField("mistaken", &n->mistaken),
          SecondsField("mistaken_seconds", &n->mistaken_seconds),
          ShareField("distractors", &n->distractors),
          SecondsField("distractors_seconds", &n->distractors_seconds),
          Option("lasting_alarms", &n->lasting_alarms, "", 0, 100),
          SecondsField("lasting_alarms_seconds", &n->lasting_alarms_seconds),
          ShareField("no_viewpoint", &n->no_viewpoint),
          SecondsField("no_viewpoint_seconds", &n->no_viewpoint_seconds),
          SecondsField("turned_seconds", &n->turned_seconds),
          ShareField("astray", &n->astray),
          SecondsField("astray_seconds", &n->astray_seconds),
          Option("elevation_bias_deg", &n->elevation_bias_deg, "", -90, 90),
          ShareField("score", &n->score),
          ShareField("score_visible", &n->score_visible)};
}

}  // namespace

DetectorNoise ReadDetectorNoise(const YamlMap& file) {
  const YamlMap map = file.MapOrEmpty("detections");
  DetectorSetting setting = DetectorSetting::kSimulated;
  ReadField(map, Option("setting", &setting, ""));
  DetectorNoise noise = MakeDetectorNoise(setting);

  std::vector<std::string> more_keys = kDetectedCategories;
  more_keys.push_back("setting");
  ReadFields(map, DetectionFields(&noise.any), more_keys);
  for (auto& [category, of_category] : noise.of) ReadFields(map, DetectionFields(&of_category), more_keys);
  for (const std::string& category : kDetectedCategories) {
    if (!map.Has(category)) continue;
    DetectionNoise& of_category = noise.of.emplace(category, noise.any).first->second;
    // Those are of any category: a picture has so many.
    std::vector<OptionEntry> fields = DetectionFields(&of_category);
    std::erase_if(fields, [](const OptionEntry& field) { return field.key == "false_alarms"; });
    ReadFields(map.Map(category), fields);
  }
  return noise;
}

}  // namespace armature
