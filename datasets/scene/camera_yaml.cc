// SPDX-License-Identifier: BSD-3-Clause
// Camera, effects and noise of a scene file.
#include "datasets/scene/scene_fields.h"
#include "datasets/scene/scene_sections.h"

namespace armature {

Camera ReadCamera(const YamlMap& file) {
  Camera camera{856, 480, 580, 580, 0, 0};
  const YamlMap map = file.MapOrEmpty("camera");
  const std::vector<OptionEntry> fields{
      Option("width", &camera.width, "", 16, 8192), Option("height", &camera.height, "", 16, 8192),
      Option("fx", &camera.fx, "", 1, 1e5),         Option("fy", &camera.fy, "", 1, 1e5),
      Option("cx", &camera.cx, "", -1e5, 1e5),      Option("cy", &camera.cy, "", -1e5, 1e5)};
  ReadFields(map, fields);
  if (!map.Has("cx")) camera.cx = 0.5 * (camera.width - 1);
  if (!map.Has("cy")) camera.cy = 0.5 * (camera.height - 1);
  return camera;
}

CameraEffects ReadEffects(const YamlMap& file) {
  CameraEffects effects;
  ReadFields(file.MapOrEmpty("effects"),
             {Option("blur_px", &effects.blur_px, "", 0, 20),
              Option("motion_blur_px", &effects.motion_blur_px, "", 0, 100),
              Option("noise", &effects.noise, "", 0, 100), Option("exposure", &effects.exposure, "", 0.05, 5),
              Option("exposure_change", &effects.exposure_change, "", 0, 0.5),
              Option("vignetting", &effects.vignetting, "", 0, 1)});
  return effects;
}

OdometryNoise ReadOdometryNoise(const YamlMap& file) {
  OdometryNoise noise;
  ReadFields(
      file.MapOrEmpty("odometry"),
      {Option("scale", &noise.scale, "", 1e-3, 1e3), Option("scale_drift", &noise.scale_drift, "", -0.9, 10),
       Option("heading_drift_deg", &noise.heading_drift_deg, "", -360, 360),
       Option("translation_noise", &noise.translation_noise, "", 0, 1),
       Option("rotation_noise_deg", &noise.rotation_noise_deg, "", 0, 45),
       Option("tells_up", &noise.tells_up, "")});
  return noise;
}

DetectionNoise ReadDetectionNoise(const YamlMap& file) {
  DetectionNoise noise;
  ReadFields(file.MapOrEmpty("detections"),
             {Option("box", &noise.box, "", 0, 0.5), Option("missed", &noise.missed, "", 0, 1),
              Option("false_alarms", &noise.false_alarms, "", 0, 100),
              Option("min_visible", &noise.min_visible, "", 0, 1),
              Option("min_size_px", &noise.min_size_px, "", 0, 10000),
              Option("azimuth_deg", &noise.azimuth_deg, "", 0, 180),
              Option("elevation_deg", &noise.elevation_deg, "", 0, 90),
              Option("tilt_deg", &noise.tilt_deg, "", 0, 180), Option("turned", &noise.turned, "", 0, 1)});
  return noise;
}

}  // namespace armature
