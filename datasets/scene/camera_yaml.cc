// SPDX-License-Identifier: BSD-3-Clause
// Camera and effects of a scene file.
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

}  // namespace armature
