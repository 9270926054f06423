// SPDX-License-Identifier: BSD-3-Clause
// What the simulated odometry of a scene file does wrong.
#include "base/errors.h"
#include "datasets/scene/scene_fields.h"
#include "datasets/scene/scene_sections.h"

namespace armature {
namespace {

void ReadLost(const YamlMap& map, OdometryNoise* noise) {
  if (map.Has("at") && map.Has("share")) {
    throw InputError(
        map.At("share", "and `at` are two ways to say when; keep the share of all time, or the one time"));
  }
  double at = 0;
  ReadFields(map, {Option("at", &at, "", 1e-3, 1e6), Option("share", &noise->lost_share, "", 0, 0.9),
                   Option("seconds", &noise->lost_seconds, "", 1e-3, 1e6)});
  if (map.Has("at")) noise->lost_at = at;
}

}  // namespace

OdometryNoise ReadOdometryNoise(const YamlMap& file) {
  OdometryNoise noise;
  const YamlMap map = file.MapOrEmpty("odometry");
  ReadFields(map,
             {Option("kind", &noise.kind, ""), Option("scale", &noise.scale, "", 1e-3, 1e3),
              Option("scale_drift", &noise.scale_drift, "", -0.9, 10),
              Option("heading_drift_deg", &noise.heading_drift_deg, "", -360, 360),
              Option("translation_noise", &noise.translation_noise, "", 0, 1),
              Option("rotation_noise_deg", &noise.rotation_noise_deg, "", 0, 45),
              Option("scale_jump", &noise.scale_jump, "", 0, 100),
              Option("turn_scale_drift", &noise.turn_scale_drift, "", 0, 5),
              Option("tells_up", &noise.tells_up, "")},
             {"lost"});
  if (map.Has("lost")) ReadLost(map.Map("lost"), &noise);
  return noise;
}

}  // namespace armature
